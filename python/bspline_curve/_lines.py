# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that come from elsewhere, as curves on a mesh: wherever a curve is taken, so is a polyline, and a spline of scipy."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _core, _spline
from ._arrays import Floats, finite_points, numbers
from ._curve import Curve, restored
from ._drawing import Drawing
from ._errors import InputError, PickError, warn
from ._identity import difference, require_mesh
from ._options import Option, checked_number

if TYPE_CHECKING:
    from ._mesh import Mesh


class ScipySpline(Protocol):
    """What is used of a BSpline of scipy."""

    @property
    def t(self) -> Any: ...
    @property
    def c(self) -> Any: ...
    @property
    def k(self) -> Any: ...


Line: TypeAlias = "Curve | npt.ArrayLike | ScipySpline"

REACH = 0.01  # of the diagonal, for points of a mesh
MAX_DISTANCE = Option("double", 0.0, 0.0, None, False, ())
SAMPLES_OF_A_SPAN = 32  # at least: the projection follows the spline between them


class Placing(NamedTuple):
    """How what comes from elsewhere comes onto a mesh."""

    max_distance: float = 0.0
    direction: npt.ArrayLike | None = None


class Placed(NamedTuple):
    """Curves on a mesh, and what people must know of them."""

    curves: list[Curve]
    notes: list[str]


def curve_on(mesh: Mesh, given: Any, name: str) -> Curve:
    """A curve of this mesh, of what people give for one."""
    return only_one(curves_of(mesh, given, name, Placing()))


def only_one(placed: Placed) -> Curve:
    if len(placed.curves) != 1:
        raise InputError(f"{' '.join(placed.notes)}: {len(placed.curves)} curves, and one is needed here")
    warn(placed.notes, 3)
    return placed.curves[0]


def curves_of(mesh: Mesh, given: Any, name: str, placing: Placing) -> Placed:
    """Of one that is given, which a direction may part."""
    if isinstance(given, Curve):
        if given._drawing.home is mesh:
            return Placed([given], [])
        other = difference(given._drawing.home, mesh)
        if other:
            raise InputError(f"{name} is of another mesh: {other}")
        return Placed([given.on(mesh)], [])
    if is_spline(given):
        if placing.direction is None:
            return Placed([of_spline(given, mesh, placing.max_distance, name)], [])
        spline, closed = our_spline(given, name)
        points = _spline.evaluate(spline, parameters_along(spline, mesh), 0)
        return of_points(points, mesh, closed, placing, name)
    return of_points(given, mesh, None, placing, name)


def curves_on(mesh: Mesh, given: Any, placing: Placing) -> Placed:
    """Of one, or of several."""
    if isinstance(given, Curve) or is_spline(given) or (isinstance(given, np.ndarray) and given.ndim == 2):
        return curves_of(mesh, given, "curves", placing)
    if not isinstance(given, Iterable) or isinstance(given, (str, bytes)):
        raise TypeError(f"curves is {type(given).__name__}, but must be curves: Curve, (n, 3) arrays, or BSpline of scipy")
    each = [curves_of(mesh, one, f"curves[{i}]", placing) for i, one in enumerate(given)]
    return Placed([curve for placed in each for curve in placed.curves], [note for placed in each for note in placed.notes])


def is_spline(given: Any) -> bool:
    """A BSpline of scipy, which is not imported: known by its attributes."""
    return all(hasattr(given, name) for name in ("t", "c", "k", "extrapolate"))


def of_points(given: npt.ArrayLike, mesh: Mesh, closed: bool | None, placing: Placing, name: str) -> Placed:
    require_mesh(mesh)
    points = finite_points(given, name, InputError, "")
    if len(points) < 2:
        raise InputError(f"{name} has {len(points)} points, but a line has at least 2", "bad-array")
    ends_where_it_starts = bool((points[0] == points[-1]).all()) and len(points) > 2
    if ends_where_it_starts:
        points = np.ascontiguousarray(points[:-1])
    is_closed = ends_where_it_starts if closed is None else closed
    drawing = Drawing(mesh, np.empty((0, 3)), {}, fixed="a polyline that was given")
    lines, notes = projected(mesh, points, is_closed, placing, name)
    return Placed([Curve(line, drawing) for line in lines], notes)


def projected(mesh: Mesh, points: Floats, closed: bool, placing: Placing, name: str) -> tuple[list[_core.Curve], list[str]]:
    reach = checked_number("max_distance", MAX_DISTANCE, placing.max_distance)
    direction = None if placing.direction is None else direction_of(placing.direction)
    try:
        lines, note = _core.projected(mesh._core, points, closed, reach, direction)
    except PickError as error:
        # Ids are those of points, which the message names.
        text = f"{name} is not near the mesh: {error}; give the mesh that it belongs to, or a larger max_distance"
        raise InputError(text, error.code) from None
    if not lines:
        raise InputError(f"{name} does not meet the mesh along the direction; move it, or give another direction", "pick-too-far")
    return lines, [f"{name}: {note}"] if note else []


def direction_of(given: npt.ArrayLike) -> tuple[float, ...]:
    direction = numbers(given, "direction")
    if direction.shape != (3,) or not np.isfinite(direction).all() or not direction.any():
        raise InputError(f"direction is {given!r}, but must be three finite numbers that are not all 0", "bad-array")
    return tuple(direction.tolist())


def of_spline(given: Any, mesh: Mesh, max_distance: float, name: str) -> Curve:
    require_mesh(mesh)
    spline, closed = our_spline(given, name)
    at = parameters_along(spline, mesh)
    points = _spline.evaluate(spline, at, 0)
    on_mesh, notes = projected(mesh, np.ascontiguousarray(points[:-1] if closed else points), closed, Placing(max_distance), name)
    warn(notes, 3)
    line = on_mesh[0]
    faces, barycentrics = line.places
    state = {
        "points": np.array(line.points), "faces": faces, "barycentrics": barycentrics,
        "t": parameters_of(line, spline, at, points), "pick_parameters": [], "pick_vertices": [],
        "degree": spline.degree, "closed": closed, "usable": True, "is_sampled": False, "alpha": 0.0,
    } | spline_state(spline)  # fmt: skip
    return restored(Drawing(mesh, np.empty((0, 3)), {}, fixed="a spline that was given"), state, None)


def spline_state(spline: _spline.Spline) -> dict[str, Any]:
    return {"control_points": np.ascontiguousarray(spline.control_points), "knots": spline.knots.tolist()}


def our_spline(given: Any, name: str) -> tuple[_spline.Spline, bool]:
    """Over [0, 1], clamped where it is open, periodic where it is closed; and whether it is."""
    degree, knots, points = int(given.k), numbers(given.t, f"{name}.t"), numbers(given.c, f"{name}.c")
    if points.ndim != 2 or points.shape[1] != 3 or degree < 1:
        raise InputError(
            f"{name} has coefficients of shape {points.shape} and degree {degree}, but must be a curve in space: (m, 3), "
            "degree at least 1", "bad-array",
        )  # fmt: skip
    if not np.isfinite(points).all():
        raise InputError(f"{name} has coefficients that are not finite", "bad-array")
    count = len(knots) - degree - 1
    low, high = knots[degree], knots[count]
    spline = _spline.Spline(degree, (knots - low) / (high - low), points[:count])
    if _spline.is_periodic(spline):
        return spline, True
    spline = _spline.part(spline, 0.0, 1.0)
    first, last = spline.control_points[0], spline.control_points[-1]
    size = float(np.abs(spline.control_points).max())
    if np.linalg.norm(first - last) <= 1e-9 * size and len(spline.control_points) > 2 + degree:
        return _spline.joined(spline), True
    return spline, False


def parameters_along(spline: _spline.Spline, mesh: Mesh) -> Floats:
    """As dense as the spline bends, and as the mean edge of the mesh."""
    knots = np.unique(spline.knots)
    knots = knots[(knots >= 0.0) & (knots <= 1.0)]
    even = np.asarray(np.linspace(0.0, 1.0, SAMPLES_OF_A_SPAN * len(knots) + 1), np.float64)
    rough = _spline.evaluate(spline, even, 0)
    length = np.linalg.norm(np.diff(rough, axis=0), axis=1).sum()
    edge = mesh.diagonal / np.sqrt(max(len(mesh.faces), 1))
    share = np.clip(np.diff(knots) * length / edge, SAMPLES_OF_A_SPAN, 4096)
    spans = [np.linspace(a, b, int(n), endpoint=False) for a, b, n in zip(knots, knots[1:], share)]
    return np.concatenate([*spans, np.ones(1)])


def parameters_of(line: _core.Curve, spline: _spline.Spline, at: Floats, points: Floats) -> Floats:
    """Parameters of the spline at the points of its projection: the nearest ones, by Newton's method from those of the same
    share of the length."""
    lengths = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    first: Floats = np.interp(line.t, lengths / lengths[-1], at)
    t, step = first, 2.0 * float(np.diff(at).max())
    for _ in range(3):
        way, speed = (_spline.evaluate(spline, t, order) for order in (0, 1))
        newton = t - ((way - line.points) * speed).sum(1) / np.maximum((speed * speed).sum(1), 1e-300)
        t = np.asarray(np.clip(newton, np.maximum(first - step, 0.0), np.minimum(first + step, 1.0)), np.float64)
    t[0] = 0.0
    if not line.closed:
        t[-1] = 1.0
    ascends = (np.diff(t) > 0).all() and (not line.closed or t[-1] < 1.0)
    return np.asarray(t if ascends else first)
