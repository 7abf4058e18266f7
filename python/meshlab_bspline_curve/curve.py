# SPDX-License-Identifier: GPL-3.0-or-later
"""A curve that was drawn."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .arrays import Floats, Integers, numbers


@dataclass(frozen=True, eq=False)
class Tube:
    """A closed triangle mesh around a curve.

    Attributes
    ----------
    vertices : (n, 3) array of float
    faces : (m, 3) array of int
        Ids of its vertices.
    """

    vertices: Floats
    faces: Integers


@dataclass(frozen=True, eq=False)
class Curve:
    """A polyline on a mesh, and the B-spline that was projected onto it.

    Attributes
    ----------
    points : (n, 3) array of float
        The polyline in order; every segment lies inside one face. A closed one does not repeat its first point.
    faces : (n,) array of int
        A face of the mesh that holds the point.
    barycentrics : (n, 3) array of float
        Where it is in that face: weights of the face's vertices, in their order.
    t : (n,) array of float
        Parameter of the spline at the point, in [0, 1].
    values : (n,) array of float
        The field at the point; without a field, t.
    control_points : (m, 3) array of float
        Of the spline. A closed one names its first `degree` again at the end.
    knots : (m + degree + 1,) array of float
        The full knot vector; the curve is over [0, 1]. Those of a closed curve are periodic.
    degree : int
    closed : bool
    pick_parameters : (p,) array of float
        Parameter t of each pick.
    pick_vertices : (p,) array of int
        Which points the picks are.
    tube : Tube or None
        Where `tube_radius` asked for one.
    figures : dict
        What the filter reports: usable, converged, length, max_distance (spline to surface, in mean edge lengths),
        surface_kept (the surface was prepared by an earlier call), seconds and others.
    """

    points: Floats
    faces: Integers
    barycentrics: Floats
    t: Floats
    values: Floats
    control_points: Floats
    knots: Floats
    degree: int
    closed: bool
    pick_parameters: Floats
    pick_vertices: Integers
    tube: Tube | None
    figures: dict[str, bool | int | float]

    @property
    def usable(self) -> bool:
        """Whether the spline came as near to the surface as asked; the polyline lies on it in any case."""
        return bool(self.figures["usable"])

    @property
    def length(self) -> float:
        """Of the polyline, in the unit of the mesh."""
        return float(self.figures["length"])

    def evaluate(self, t: npt.ArrayLike) -> Floats:
        """Points of the spline, by de Boor's algorithm.

        Parameters
        ----------
        t : array of float
            Parameters in [0, 1]; a closed curve takes any, with period 1.

        Returns
        -------
        (..., 3) array of float
            One point for each t. They are off the surface by up to `distance_tolerance`.

        Raises
        ------
        ValueError
            A parameter is outside of [0, 1] on an open curve, or is not finite.
        """
        at = numbers(t, "t")
        if not np.isfinite(at).all():
            raise ValueError("t must be finite")
        if self.closed:
            at = at % 1.0
        elif at.size and (at.min() < 0.0 or at.max() > 1.0):
            raise ValueError(f"t is in [{at.min()}, {at.max()}], but an open curve has [0, 1]")
        spans = np.searchsorted(self.knots, at, side="right") - 1
        spans = np.clip(spans, self.degree, len(self.control_points) - 1)
        # Of each t the control points that count, blended pairwise until one is left.
        blended = self.control_points[spans[..., None] + np.arange(-self.degree, 1)]
        for level in range(1, self.degree + 1):
            first = spans[..., None] + np.arange(level - self.degree, 1)
            low, high = self.knots[first], self.knots[first + self.degree + 1 - level]
            share = ((at[..., None] - low) / (high - low))[..., None]
            blended = (1.0 - share) * blended[..., :-1, :] + share * blended[..., 1:, :]
        return np.asarray(blended[..., 0, :])

    def segments(self) -> Integers:
        """Pairs of indices into `points`: (n - 1, 2), or (n, 2) where the curve is closed."""
        n = len(self.points)
        first = np.arange(n if self.closed else n - 1)
        return np.stack([first, (first + 1) % n], axis=1)
