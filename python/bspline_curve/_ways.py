# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances along the surface, and shortest paths."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Int32s, SurfacePoints, finite_points, is_surface_point, numbers, one_pick
from ._curve import Curve
from ._drawing import Drawing
from ._errors import InputError
from ._lines import REACH, curve_on
from ._options import Option, Progress, checked_number

if TYPE_CHECKING:
    from ._mesh import Mesh

Places: TypeAlias = "npt.ArrayLike | SurfacePoints"

DISTANCE = Option("double", None, 0.0, None, True, ())


def distances_to(mesh: Mesh, to: Any, reach: float | None, progress: Progress | None) -> Floats:
    limit = np.inf if reach is None else float(checked_number("reach", DISTANCE, reach))
    curves: list[_core.Curve] = []
    places: tuple[Int32s, Floats] = np.empty(0, np.int32), np.empty((0, 3))
    if isinstance(to, Curve):
        curves = [curve_on(mesh, to, "to")._core]
    elif isinstance(to, Sequence) and len(to) and isinstance(to[0], Curve):
        curves = [curve_on(mesh, each, f"to[{i}]")._core for i, each in enumerate(to)]
    elif np.size(to) == 0 if not isinstance(to, (tuple, list)) else not len(to):
        raise InputError("to is empty: give points or curves", "bad-array")
    else:
        places = _places(mesh, to, "to")
    return _core.distances(mesh._core, curves, *places, limit, progress)


def way_between(mesh: Mesh, start: Any, end: Any) -> Curve:
    (first, weights), (last, others) = (_place(mesh, at, name) for name, at in (("start", start), ("end", end)))
    found = _core.shortest_way(mesh._core, np.r_[first, last].astype(np.int32), np.concatenate([weights, others]))
    if found is None:
        raise InputError("start and end are one point, or no way along the surface leads from one to the other", "no-path")
    return Curve(found, Drawing(mesh, np.empty((0, 3)), {}, fixed="a shortest path"))


def _place(mesh: Mesh, given: Any, name: str) -> tuple[Int32s, Floats]:
    if is_surface_point(given):
        return _places(mesh, [given], name)
    point = numbers(given, name)
    if point.shape != (3,):
        raise InputError(f"{name} has shape {point.shape}, but must be a point, (3,), or a pair (face, barycentrics)", "bad-array")
    return _places(mesh, point[None], name)


def _places(mesh: Mesh, given: Any, name: str) -> tuple[Int32s, Floats]:
    """Faces and barycentrics of points, or of such pairs."""
    if isinstance(given, (tuple, list)) and len(given) and is_surface_point(given[0]):
        for i, each in enumerate(given):
            one_pick(each, mesh, i)  # which checks it
        return np.array([face for face, _ in given], dtype=np.int32), np.array([weights for _, weights in given], dtype=np.float64)
    points = finite_points(given, name, InputError, "")
    faces, barycentrics = (closest := mesh.project(points)).faces, closest.barycentrics
    if len(points) and closest.distances.max() > REACH * mesh.diagonal:
        far = int(closest.distances.argmax())
        which = f"{name}[{far}]" if len(points) > 1 else name
        raise InputError(f"{which} is {closest.distances[far]:.4g} away from the mesh, more than 1 % of its diagonal", "pick-too-far")
    return faces, barycentrics
