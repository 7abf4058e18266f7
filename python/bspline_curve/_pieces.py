# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves turned round, cut, joined and made longer: spline and polyline at the same parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._drawing import Drawing
from ._errors import InputError
from ._options import Direction, Option, Progress, TwoDirections, checked_length, checked_number

if TYPE_CHECKING:
    from ._curve import Curve
    from ._mesh import Mesh

LENGTH = Option("double", 0.0, 0.0, None, False, ())


def reversed_curve(curve: Curve) -> Curve:
    """From the end to the start; a closed curve keeps its first point."""
    core, turned = _core.reversed(curve._core)
    drawing = curve._bound()
    if len(turned) != len(drawing.picks):  # of none, or of other picks than the curve passes
        turned = list(range(len(drawing.picks)))[::-1]
    place = {pick: i for i, pick in enumerate(turned)}
    other = _turned(drawing.renumbered(len(turned), place.get))._replace(picks=drawing.picks[turned])
    return _of(core, other, curve)


def _turned(drawing: Drawing) -> Drawing:
    """With the tangents of a curve that goes the other way."""
    tangents: Any = drawing.options.get("tangents") or ()
    if not tangents:
        return drawing

    def turned(tangent: Direction | TwoDirections) -> Direction | TwoDirections:
        if len(tangent) == 3:
            x, y, z = tangent
            return (-x, -y, -z)
        before, after = ((-side[0], -side[1], -side[2]) if side else None for side in tangent)
        return (after, before)

    other = tuple(sorted((pick, turned(direction)) for pick, direction in tangents))
    return drawing._replace(options={**drawing.options, "tangents": other})


def part(curve: Curve, start: float, end: float) -> Curve:
    """The part from parameter start to end; of a closed curve end may be less."""
    return _part(curve, *_core.part(curve.mesh._core, curve._core, start, end))


def parts(curve: Curve, at: list[float]) -> list[Curve]:
    """The parts between parameters, which together are the whole."""
    return [_part(curve, core, kept) for core, kept in _core.parts(curve.mesh._core, curve._core, at)]


def _part(curve: Curve, core: _core.Curve, kept: list[int]) -> Curve:
    drawing = curve._bound()
    picks = drawing.picks[kept] if len(drawing.picks) == len(curve.pick_parameters) else drawing.picks[:0]
    of_whole = ("closed", "corners", "tangents", "pick_tolerance")
    options = {name: value for name, value in drawing.options.items() if name not in of_whole}
    return _of(core, drawing._replace(picks=picks, options=options, fixed="a part of another"), curve)


def _of(core: _core.Curve, drawing: Drawing, whole: Curve) -> Curve:
    from ._curve import Curve as CurveClass

    return CurveClass(core, drawing, whole.report)


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
