# SPDX-License-Identifier: GPL-3.0-or-later
"""Points and derivatives of a B-spline."""

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
    return Spline(degree - 1, knots[1:-1], degree * np.diff(points, axis=0) / lengths[:, None])


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
    spans = np.clip(np.searchsorted(knots, at, side="right") - 1, degree, len(points) - 1)
    # Of each t the control points that count, blended pairwise until one is left.
    blended = points[spans[..., None] + np.arange(-degree, 1)]
    for level in range(1, degree + 1):
        first = spans[..., None] + np.arange(level - degree, 1)
        low, high = knots[first], knots[first + degree + 1 - level]
        share = ((at[..., None] - low) / (high - low))[..., None]
        blended = (1.0 - share) * blended[..., :-1, :] + share * blended[..., 1:, :]
    return np.asarray(blended[..., 0, :])
