# SPDX-License-Identifier: GPL-3.0-or-later
"""Points and derivatives of a B-spline, and parts of it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ._arrays import Floats
from ._errors import InputError


class Spline(NamedTuple):
    """Degree, full knot vector and control points; over [0, 1]."""

    degree: int
    knots: Floats
    control_points: Floats


def derivative(spline: Spline) -> Spline:
    """The spline of the first derivative."""
    degree, knots, points = spline
    lengths = knots[degree + 1 : degree + len(points)] - knots[1 : len(points)]
    rates = degree / np.where(lengths > 0.0, lengths, np.inf)  # at a corner: points that count nowhere
    return Spline(degree - 1, knots[1:-1], rates[:, None] * np.diff(points, axis=0))


def evaluate(spline: Spline, at: Floats, order: int) -> Floats:
    """(..., 3) for each t in [0, 1], by de Boor's algorithm on the spline of the derivative of this order; where that
    jumps, from the right."""
    if isinstance(order, bool) or not isinstance(order, (int, np.integer)) or order < 0:
        raise InputError(f"derivative is {order!r}, but must be an integer of at least 0")
    if order > spline.degree:
        return np.zeros((*at.shape, 3))
    for _ in range(order):
        spline = derivative(spline)
    degree, knots, points = spline
    last = int(np.searchsorted(knots, knots[len(points)], side="left")) - 1  # the span that ends at 1
    spans = np.clip(np.searchsorted(knots, at, side="right") - 1, degree, last)
    # Of each t the control points that count, blended pairwise until one is left.
    blended = points[spans[..., None] + np.arange(-degree, 1)]
    for level in range(1, degree + 1):
        first = spans[..., None] + np.arange(level - degree, 1)
        low, high = knots[first], knots[first + degree + 1 - level]
        share = ((at[..., None] - low) / (high - low))[..., None]
        blended = (1.0 - share) * blended[..., :-1, :] + share * blended[..., 1:, :]
    return np.asarray(blended[..., 0, :])


def with_knot(spline: Spline, at: float) -> Spline:
    """The same spline with one knot more, by Boehm's algorithm; `at` is in its domain, and has less than `degree` knots."""
    degree, knots, points = spline
    span = int(np.searchsorted(knots, at, side="right")) - 1
    repeated = int(np.searchsorted(knots, at, side="left"))  # the first knot there, if there is one
    blended = np.arange(span - degree + 1, min(span, repeated - 1) + 1)
    share = ((at - knots[blended]) / (knots[blended + degree] - knots[blended]))[:, None]
    between = (1.0 - share) * points[blended - 1] + share * points[blended]
    return Spline(
        degree,
        np.insert(knots, span + 1, at),
        np.concatenate([points[: span - degree + 1], between, points[int(blended[-1]) :]]),
    )


def part(spline: Spline, start: float, end: float) -> Spline:
    """The part from start to end, start < end in the domain, clamped and over [0, 1]."""
    degree = spline.degree
    for at in (start, end):
        while np.count_nonzero(spline.knots == at) < degree:
            spline = with_knot(spline, at)
    knots, points = spline.knots, spline.control_points
    first = int(np.searchsorted(knots, start, side="right")) - 1
    last = int(np.searchsorted(knots, end, side="left"))
    inner = (knots[first + 1 : last] - start) / (end - start)
    ends = np.ones(degree + 1)
    return Spline(degree, np.concatenate([0.0 * ends, inner, ends]), points[first - degree : last])


def is_periodic(spline: Spline) -> bool:
    """Whether it is closed as ours are: periodic knots, the first control points once more at the end."""
    degree, knots, points = spline
    turn = len(points) - degree
    return turn >= degree and bool(
        np.allclose(knots[turn : turn + 2 * degree + 1], knots[: 2 * degree + 1] + 1.0, rtol=0, atol=1e-12)
        and np.allclose(points[:degree], points[turn:], rtol=1e-12, atol=1e-12 * float(np.abs(points).max()))
    )


def joined(spline: Spline) -> Spline:
    """A clamped spline that ends where it starts, as a closed one; the seam is a knot of multiplicity `degree`."""
    degree, knots, points = spline
    turn = len(points) - 1
    base = knots[1 : turn + 1]  # one turn of knots, from the seam on
    index = np.arange(-1, turn + 2 * degree)
    return Spline(degree, base[index % turn] + index // turn, points[np.arange(turn + degree) % turn])
