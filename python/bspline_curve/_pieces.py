# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves turned round, cut, joined and made longer: spline and polyline at the same parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core, _spline
from ._arrays import Floats, Int32s
from ._drawing import Drawing
from ._errors import InputError
from ._options import Option, Progress, checked_length, checked_number

if TYPE_CHECKING:
    from ._curve import Curve
    from ._mesh import Mesh

LENGTH = Option("double", 0.0, 0.0, None, False, ())
SAME = 1e-12  # parameters that differ by less are one


class Piece(NamedTuple):
    """What the core makes a curve of, and what that is drawn by."""

    state: dict[str, Any]
    drawing: Drawing


def spline_state(spline: _spline.Spline) -> dict[str, Any]:
    return {"control_points": np.ascontiguousarray(spline.control_points), "knots": spline.knots.tolist()}


def reversed_piece(curve: Curve) -> Piece:
    """From the end to the start; a closed curve keeps its first point."""
    n, drawing = len(curve.points), curve._bound()
    order = np.r_[0, np.arange(n - 1, 0, -1)] if curve.closed else np.arange(n - 1, -1, -1)
    t = 1.0 - curve.t[order]
    at = 1.0 - curve.pick_parameters
    if curve.closed:
        t, at = t % 1.0, at % 1.0
    # Picks in the order of their parameters: that at 0 of a closed curve stays the first.
    count = len(at)
    turn = np.arange(count)[::-1] if not (curve.closed and count and at[0] == 0.0) else np.r_[0, np.arange(count - 1, 0, -1)]
    index = np.empty(n, dtype=np.int32)
    index[order] = np.arange(n)
    state = curve._state() | spline_state(_spline.reversed_spline(curve._spline_data()))
    state |= {
        "points": curve.points[order], "faces": curve.faces[order], "barycentrics": curve.barycentrics[order], "t": t,
        "pick_parameters": at[turn].tolist(),
        "pick_vertices": index[curve.pick_vertices][turn if len(curve.pick_vertices) == count else slice(None, None, -1)].tolist(),
    }  # fmt: skip
    picks = drawing.picks
    turned = turn if len(picks) == count else np.arange(len(picks))[::-1]
    place = {int(pick): i for i, pick in enumerate(turned)}
    return Piece(state, _turned(drawing.renumbered(place.get))._replace(picks=picks[turned]))


def _turned(drawing: Drawing) -> Drawing:
    """With the tangents of a curve that goes the other way."""
    tangents: Any = drawing.options.get("tangents") or ()
    if not tangents:
        return drawing
    other = tuple(sorted((pick, tuple(-x for x in direction)) for pick, direction in tangents))
    return drawing._replace(options={**drawing.options, "tangents": other})


def piece(curve: Curve, start: float, end: float) -> Piece:
    """The part from parameter start to end; of a closed curve end may be more than 1."""
    n, closed = len(curve.points), curve.closed
    turns = 2 if closed else 1
    index = np.concatenate([np.arange(n)] * turns + ([[0]] if closed else []))
    t = np.concatenate([curve.t + turn for turn in range(turns)] + ([curve.t[:1] + 2] if closed else []))
    along = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(curve.points[index], axis=0), axis=1))]
    ends = [_place(curve, index, t, along, at) for at in (start, end)]
    inside = np.flatnonzero((t > start + SAME) & (t < end - SAME))
    inner = index[inside]
    state = curve._state() | spline_state(_part_of_spline(curve, start, end))
    state |= {
        "points": np.concatenate([ends[0][0], curve.points[inner], ends[1][0]]),
        "faces": np.concatenate([ends[0][1], curve.faces[inner], ends[1][1]]).astype(np.int32),
        "barycentrics": np.concatenate([ends[0][2], curve.barycentrics[inner], ends[1][2]]),
        "t": np.r_[0.0, (t[inside] - start) / (end - start), 1.0],
        "closed": False,
    }  # fmt: skip
    kept, at, vertices = _picks_in(curve, start, end, np.r_[-1, inner, -1])
    state |= {"pick_parameters": at, "pick_vertices": vertices}
    drawing = curve._bound()
    picks = drawing.picks[kept] if len(drawing.picks) == len(curve.pick_parameters) else drawing.picks[:0]
    options = {name: value for name, value in drawing.options.items() if name not in ("closed", "corners", "tangents")}
    return Piece(state, drawing._replace(picks=picks, options=options, fixed="a part of another"))


def _place(curve: Curve, index: npt.NDArray[np.int64], t: Floats, along: Floats, at: float) -> tuple[Floats, Int32s, Floats]:
    """Point, face and barycentrics of the polyline at a parameter, a row each."""
    near = int(np.abs(t - at).argmin())
    if abs(t[near] - at) <= SAME:
        i = index[near : near + 1]
        return curve.points[i], curve.faces[i], curve.barycentrics[i]
    distance = float(np.interp(at, t, along))
    found = _core.points_along(curve.mesh._core, curve._core, [distance])
    faces, barycentrics = found["places"]
    return found["points"], faces, barycentrics


def _part_of_spline(curve: Curve, start: float, end: float) -> _spline.Spline:
    spline = curve._spline_data()
    if curve.closed:
        spline = _spline.unrolled(spline)
    near = [spline.knots[int(np.abs(spline.knots - at).argmin())] for at in (start, end)]
    a, b = (float(knot) if abs(knot - at) <= SAME else at for knot, at in zip(near, (start, end)))
    return _spline.part(spline, a, b)


def _picks_in(curve: Curve, start: float, end: float, vertices: npt.NDArray[Any]) -> tuple[list[int], list[float], list[int]]:
    """Of the picks between start and end: which, where, and which vertices of the part they are."""
    found = []
    for i, at in enumerate(curve.pick_parameters.tolist()):
        for turn in (0.0, 1.0, 2.0) if curve.closed else (0.0,):
            if start - SAME <= at + turn <= end + SAME:
                found.append((min(max((at + turn - start) / (end - start), 0.0), 1.0), i))
    found.sort()
    named = curve.pick_vertices.tolist()
    of_vertex = {int(vertex): place for place, vertex in enumerate(vertices.tolist())}
    last = len(vertices) - 1
    places = [
        0 if at <= SAME else last if at >= 1 - SAME else of_vertex[named[i]] for at, i in found
    ] if len(named) == len(curve.pick_parameters) else []
    return [i for _, i in found], [at for at, _ in found], places


def joined(
    curve: Curve, other: Any, smooth: bool, gap: float | str, blend: float | str, progress: Progress | None
) -> Curve:
    from ._curve import Curve as CurveClass
    from ._lines import curve_on

    if not isinstance(other, CurveClass):
        raise TypeError(f"other is {type(other).__name__}, but must be a Curve")
    mesh = curve.mesh
    second = curve_on(mesh, other, "other")
    allowed, replaced = checked_length("gap", gap), checked_length("blend", blend)
    return _fixed(
        _core.joined(mesh._core, curve._core, second._core, bool(smooth), allowed, replaced, progress), mesh, "joined of others"
    )


def extended(curve: Curve, start: float, end: float, progress: Progress | None) -> Curve:
    first, last = float(checked_number("start", LENGTH, start)), float(checked_number("end", LENGTH, end))
    return _fixed(_core.extended(curve.mesh._core, curve._core, first, last, progress), curve.mesh, "longer than it was drawn")


def _fixed(core: _core.Curve, mesh: Mesh, what: str) -> Curve:
    """A curve with picks that it is no longer drawn through."""
    from ._curve import Curve as CurveClass

    curve = CurveClass(core, Drawing(mesh, np.empty((0, 3)), {}, fixed=what))
    curve._drawing = curve._drawing._replace(picks=curve.points[curve.pick_vertices])
    return curve


def checked_parameter(name: str, given: Any, closed: bool) -> float:
    if isinstance(given, (bool, np.bool_)) or not isinstance(given, (int, float, np.integer, np.floating)):
        raise TypeError(f"{name} is {given!r}, but must be a number: a parameter of the curve")
    at = float(given)
    if not 0.0 <= at <= 1.0:
        raise InputError(f"{name} is {at}, but a parameter of {'a closed' if closed else 'an open'} curve is in [0, 1]")
    return at
