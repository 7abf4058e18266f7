# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth curves along lines that exist."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._arrays import Floats, face_ids, finite_points, shape_text
from ._curve import Curve
from ._drawing import Drawing
from ._errors import InputError
from ._keywords import CURVE
from ._lines import Placing, of_points, only_one
from ._options import Progress, changed, checked_length, part_of

if TYPE_CHECKING:
    from ._mesh import Mesh


Allowed = tuple[str, float]  # how far from its line a curve may be, and from which angle on it has corners


def curve_along(
    mesh: Mesh, line: Any, closed: bool, direction: Any, allowed: Allowed, options: dict[str, Any], progress: Progress | None
) -> Curve:
    points = finite_points(line, "line", InputError, "")
    if direction is not None:
        points = only_one(of_points(points, mesh, closed, Placing(direction=direction), "line")).points
    return _fitted(mesh, points, closed, allowed, options, progress)


def curves_round(
    mesh: Mesh, faces: Any, labels: Any, allowed: Allowed, options: dict[str, Any], progress: Progress | None
) -> list[Curve]:
    count = len(mesh.faces)
    if (faces is None) == (labels is None):
        raise InputError("give either faces or labels", "bad-array")
    if labels is None:
        chosen = np.zeros(count, dtype=np.int32)
        chosen[face_ids(faces, "faces", count)] = 1
    else:
        given = np.asarray(labels)
        if given.shape != (count,) or given.dtype.kind not in "iub":
            raise InputError(f"labels has shape {shape_text(given)} of {given.dtype}, but must have ({count},), an integer for each face", "bad-array")
        # Labels may be any integers: the core gets their ranks.
        chosen = np.unique(given, return_inverse=True)[1].astype(np.int32)
    lines = _core.boundaries(mesh._core, np.ascontiguousarray(chosen))
    if not lines:
        raise InputError("there is no boundary: all faces are alike", "no-path")
    vertices = mesh.vertices
    return [
        _fitted(mesh, vertices[line], closed, allowed, options, part_of(progress, i / len(lines), (i + 1) / len(lines)))
        for i, (line, closed, _, _) in enumerate(lines)
    ]


def allowed(deviation: float | str | None, corner_angle: float) -> Allowed:
    """Checked, with the deviation as text; 0: as the line's own noise asks for."""
    text = "0" if deviation is None else checked_length("deviation", deviation)
    if deviation is not None and text in ("0", "0.0"):
        raise InputError("deviation is 0, but must be above 0; None: as the line's own noise asks for", "bad-option")
    return text, float(corner_angle)


def _fitted(
    mesh: Mesh, line: Floats, closed: bool, allowed: Allowed, options: dict[str, Any], progress: Progress | None
) -> Curve:
    chosen = changed(CURVE, {**options, "closed": closed})
    found = _core.fit(mesh._core, np.ascontiguousarray(line), chosen, *allowed, progress)
    curve = Curve(found, Drawing(mesh, np.empty((0, 3)), chosen))
    curve._drawing = curve._drawing._replace(picks=curve.points[curve.pick_vertices])
    return curve
