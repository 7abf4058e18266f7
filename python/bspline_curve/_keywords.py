# SPDX-License-Identifier: GPL-3.0-or-later
# Made from filters/filters.json by scripts/python_filters.py; do not edit.
"""Keywords of meshes, curves and fields."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypedDict

import numpy.typing as npt

from ._arrays import Floats, Picks
from ._options import Option, Progress

if TYPE_CHECKING:
    from ._curve import Curve

Shell: TypeAlias = Literal["local", "full", "simplified", "preset"]
Field: TypeAlias = Literal[
    "none", "normal-variation", "maximal-curvature", "ridge", "valley", "crease-distance", "boundary-distance",
    "quality", "obstacle", "auto",
]
Avoid: TypeAlias = Literal["none", "under-threshold", "over-threshold"]
FieldCost: TypeAlias = Literal["natural", "identity", "square", "exp-minus"]
Preset: TypeAlias = Literal["default", "paper"]
Fairness: TypeAlias = Literal["preset", "curvature", "parametric"]
Bending: TypeAlias = Literal["preset", "geodesic", "ambient"]
InitialCurve: TypeAlias = Literal["preset", "geodesic-fit", "control-polygon"]
FieldGuidesPath: TypeAlias = Literal["preset", "off", "on"]
Quadrature: TypeAlias = Literal["preset", "foot-points", "cells", "samples"]
BarrierWidth: TypeAlias = Literal["preset", "full", "tight"]
DistanceWeight: TypeAlias = Literal["preset", "schedule", "adaptive"]
Interpolation: TypeAlias = Literal["preset", "constraint", "penalty"]
KnotRule: TypeAlias = Literal["preset", "energy-and-distance", "feature-function"]
RelativeHeight: TypeAlias = Literal["preset", "smooth", "linear"]
FieldKind: TypeAlias = Literal[
    "normal-variation", "maximal-curvature", "ridge", "valley", "crease-distance", "boundary-distance", "quality",
    "obstacle",
]

SHELL: dict[str, Option] = {
    "shell": Option("enum", "preset", None, None, False, ("local", "full", "simplified", "preset")),
    "target_thickness": Option("double", 0.135, 0.0, 1.0, True, ()),
    "target_edge_length": Option("double", 1.0, 0.0, 1.0, True, ()),
    "shell_thickness": Option("double", 0.75, 0.0, 1000.0, True, ()),
    "shell_smoothing_passes": Option("int", 3, 0, None, False, ()),
    "strict": Option("bool", False, None, None, False, ()),
    "weld": Option("double", 0.0, 0.0, 0.01, False, ()),
    "slits": Option("bool", False, None, None, False, ()),
}
CURVE: dict[str, Option] = {
    "closed": Option("bool", False, None, None, False, ()),
    "degree": Option("int", 3, 2, 4, False, ()),
    "tension": Option("double", 0.0, 0.0, 1.0, False, ()),
    "field_weight": Option("double", 2000.0, 0.0, None, False, ()),
    "pick_tolerance": Option("tolerances", "0", None, None, False, ()),
    "pick_distance": Option("double", 0.0, 0.0, None, False, ()),
    "corners": Option("picks", (), None, None, False, ()),
    "tangents": Option("tangents", None, None, None, False, ()),
    "field_cost": Option("enum", "natural", None, None, False, ("natural", "identity", "square", "exp-minus")),
    "avoid_threshold": Option("double", 0.0, None, None, False, ()),
    "samples": Option("int", 256, 0, None, False, ()),
    "max_segment_length": Option("double", 0.0, 0.0, None, False, ()),
    "avoid_margin": Option("double", 0.02, 0.0, 1.0, True, ()),
    "field_curvature_scale": Option("double", 0.015, 0.0, 1.0, False, ()),
    "field_crease_angle": Option("double", 40.0, 0.0, 180.0, False, ()),
    "field_reach": Option("double", 0.1, 0.0, 1.0, True, ()),
    "field_obstacle_value": Option("double", 1.0, 0.0, None, False, ()),
    "field_obstacle_slope": Option("double", 1.0, 0.0, None, True, ()),
    "field_smoothing": Option("double", 0.0, 0.0, 1.0, False, ()),
    "field_normalised": Option("bool", False, None, None, False, ()),
    "field_inverted": Option("bool", False, None, None, False, ()),
    "preset": Option("enum", "default", None, None, False, ("default", "paper")),
    "fairness": Option("enum", "preset", None, None, False, ("preset", "curvature", "parametric")),
    "bending": Option("enum", "preset", None, None, False, ("preset", "geodesic", "ambient")),
    "normal_bending_weight": Option("double", 0.05, 0.0, 1.0, True, ()),
    "distance_tolerance": Option("double", 0.1, 0.0, None, True, ()),
    "initial_curve": Option("enum", "preset", None, None, False, ("preset", "geodesic-fit", "control-polygon")),
    "field_guides_path": Option("enum", "preset", None, None, False, ("preset", "off", "on")),
    "quadrature": Option("enum", "preset", None, None, False, ("preset", "foot-points", "cells", "samples")),
    "barrier_width": Option("enum", "preset", None, None, False, ("preset", "full", "tight")),
    "distance_weight": Option("enum", "preset", None, None, False, ("preset", "schedule", "adaptive")),
    "interpolation": Option("enum", "preset", None, None, False, ("preset", "constraint", "penalty")),
    "knot_rule": Option("enum", "preset", None, None, False, ("preset", "energy-and-distance", "feature-function")),
    "relative_height": Option("enum", "preset", None, None, False, ("preset", "smooth", "linear")),
    "curve_segments": Option("int", 200, 1, 10000, False, ()),
    "gauss_points": Option("int", 2, 1, 4, False, ()),
    "barrier_margin": Option("double", 0.02, 0.0, 1.0, True, ()),
    "height_scale": Option("double", 0.99, 0.0, 1.0, True, ()),
    "alpha_min": Option("double", 1.0, 0.0, None, True, ()),
    "alpha_max": Option("double", 100000000.0, 0.0, None, True, ()),
    "beta_first": Option("double", 1000000.0, 0.0, None, True, ()),
    "beta_min": Option("double", 10.0, 0.0, None, True, ()),
    "beta_max": Option("double", 10000000000.0, 0.0, None, True, ()),
    "knot_ratio": Option("double", 1.0, 0.0, None, True, ()),
    "feature_tolerance": Option("double", 1.0, 0.0, None, False, ()),
    "max_rounds": Option("int", 24, 1, None, False, ()),
    "max_iterations": Option("int", 100, 1, None, False, ()),
    "minimum_span": Option("double", 0.0001, 0.0, 0.1, True, ()),
}
FIELD: dict[str, Option] = {
    "kind": Option("enum", "maximal-curvature", None, None, False, ("normal-variation", "maximal-curvature", "ridge", "valley", "crease-distance", "boundary-distance", "quality", "obstacle")),
    "curvature_scale": Option("double", 0.015, 0.0, 1.0, False, ()),
    "crease_angle": Option("double", 40.0, 0.0, 180.0, False, ()),
    "reach": Option("double", 0.1, 0.0, 1.0, True, ()),
    "obstacle_value": Option("double", 1.0, 0.0, None, False, ()),
    "obstacle_slope": Option("double", 1.0, 0.0, None, True, ()),
    "smoothing": Option("double", 0.0, 0.0, 1.0, False, ()),
    "normalised": Option("bool", False, None, None, False, ()),
    "inverted": Option("bool", False, None, None, False, ()),
}


class MeshOptions(TypedDict, total=False):
    """Options of Mesh(), for Mesh.load() and repair()."""

    shell: Shell
    target_thickness: float
    target_edge_length: float
    shell_thickness: float
    shell_smoothing_passes: int
    strict: bool
    weld: float
    slits: bool
    quality: npt.ArrayLike | None
    progress: Progress | None


class CurveOptions(TypedDict, total=False):
    """Options of Mesh.curve(), for Curve.with_options()."""

    closed: bool
    degree: int
    tension: float
    field_weight: float
    pick_tolerance: float | str | Sequence[float | str]
    pick_distance: float
    corners: Sequence[int] | Literal["all"]
    tangents: Mapping[int, npt.ArrayLike | tuple[npt.ArrayLike | None, npt.ArrayLike | None]] | None
    field_cost: FieldCost
    avoid_threshold: float
    samples: int
    max_segment_length: float
    avoid_margin: float
    field_curvature_scale: float
    field_crease_angle: float
    field_reach: float
    field_obstacle_value: float
    field_obstacle_slope: float
    field_smoothing: float
    field_normalised: bool
    field_inverted: bool
    preset: Preset
    fairness: Fairness
    bending: Bending
    normal_bending_weight: float
    distance_tolerance: float
    initial_curve: InitialCurve
    field_guides_path: FieldGuidesPath
    quadrature: Quadrature
    barrier_width: BarrierWidth
    distance_weight: DistanceWeight
    interpolation: Interpolation
    knot_rule: KnotRule
    relative_height: RelativeHeight
    curve_segments: int
    gauss_points: int
    barrier_margin: float
    height_scale: float
    alpha_min: float
    alpha_max: float
    beta_first: float
    beta_min: float
    beta_max: float
    knot_ratio: float
    feature_tolerance: float
    max_rounds: int
    max_iterations: int
    minimum_span: float
    field: Field | npt.ArrayLike | None
    quality: npt.ArrayLike | None
    avoid: Avoid | npt.ArrayLike | None
    field_region: npt.ArrayLike | None


class MeshKeywords(ABC):
    """What a mesh does, with its options as keywords."""

    def __init__(
        self,
        vertices: Any,
        faces: npt.ArrayLike | None = None,
        *,
        shell: Shell = "preset",
        target_thickness: float = 0.135,
        target_edge_length: float = 1.0,
        shell_thickness: float = 0.75,
        shell_smoothing_passes: int = 3,
        strict: bool = False,
        weld: float = 0.0,
        slits: bool = False,
        quality: npt.ArrayLike | None = None,
        progress: Progress | None = None,
    ) -> None:
        """Prepare a triangle mesh for curves.

        Validates it once: finite, oriented, two-manifold, every face with area; boundaries and several components are
        allowed. Of another one a mended copy is drawn on where that helps, with a MeshWarning; ids stay those of the mesh
        that was given. bspline_curve.repair() returns such a copy.

        Parameters
        ----------
        vertices : (n, 3) array of float, or a mesh
            A mesh of trimesh, pyvista, meshio or pymeshlab, or a pair of arrays, serves in place of both.
        faces : (m, 3) array of int, optional
            Ids of vertices, from 0 on, all oriented alike.
        shell : {'local', 'full', 'simplified', 'preset'}, default 'preset'
            Where curves are sought. local: no prisms: the fibres of a full shell are followed beneath the curve; a shell is
            built only for a curve that needs one; full: a shell of one thin prism per face, built at the start; simplified:
            a shell of few thick prisms, which takes seconds to build on large meshes and is kept for the next curve;
            preset: as the preset says, by default local.
        target_thickness : float in (0, 1], default 0.135
            Simplified shell: longest pillar, bottom to top, relative to the longest side of the mesh's box.
        target_edge_length : float in (0, 1], default 1.0
            Simplified shell: shorter edges are collapsed where its invariants allow it, relative to the longest side of the
            mesh's box.
        shell_thickness : float in (0, 1000], default 0.75
            Full shell, also where local builds one: largest distance of its top and bottom from the surface, in mean edge
            lengths.
        shell_smoothing_passes : int ≥ 0, default 3
            Rounds of averaging of the pillar directions (the directions of the fibres).
        strict : bool, default False
            Refuses a mesh with duplicate faces, faces without area, edges or vertices that are not manifold, or faces
            turned opposite ways, and names them. Off: a mended copy is taken; the mesh is not changed.
        weld : float in [0, 0.01], default 0.0
            Joins vertices of a copy that are within this distance of each other, relative to the diagonal of the mesh; 0:
            none. For parts that only look joined.
        slits : bool, default False
            Leaves the mesh open where boundary edges lie on each other, as along seams of texture coordinates. Off: both
            sides are joined on a copy; the mesh is not changed.
        quality : (n,) array of float, optional
            A value for each vertex, which curves follow with field 'quality' or 'auto'.
        progress : callable, optional
            Called now and then with a fraction in [0, 1] and the name of a stage; cancels by returning False.

        Raises
        ------
        InputError
            An argument is wrong; which, and what to do. Its subclasses tell which kind of argument.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> bspline_curve.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        <bspline_curve.Mesh: 3 vertices, 1 faces>
        """
        self._prepare(
            vertices,
            faces,
            {
                "shell": shell,
                "target_thickness": target_thickness,
                "target_edge_length": target_edge_length,
                "shell_thickness": shell_thickness,
                "shell_smoothing_passes": shell_smoothing_passes,
                "strict": strict,
                "weld": weld,
                "slits": slits,
            },
            quality,
            progress,
        )

    def curve(
        self,
        picks: Picks,
        *,
        closed: bool = False,
        degree: int = 3,
        tension: float = 0.0,
        field_weight: float = 2000.0,
        pick_tolerance: float | str | Sequence[float | str] = "0",
        pick_distance: float = 0.0,
        corners: Sequence[int] | Literal["all"] = (),
        tangents: Mapping[int, npt.ArrayLike | tuple[npt.ArrayLike | None, npt.ArrayLike | None]] | None = None,
        field_cost: FieldCost = "natural",
        avoid_threshold: float = 0.0,
        samples: int = 256,
        max_segment_length: float = 0.0,
        avoid_margin: float = 0.02,
        field_curvature_scale: float = 0.015,
        field_crease_angle: float = 40.0,
        field_reach: float = 0.1,
        field_obstacle_value: float = 1.0,
        field_obstacle_slope: float = 1.0,
        field_smoothing: float = 0.0,
        field_normalised: bool = False,
        field_inverted: bool = False,
        preset: Preset = "default",
        fairness: Fairness = "preset",
        bending: Bending = "preset",
        normal_bending_weight: float = 0.05,
        distance_tolerance: float = 0.1,
        initial_curve: InitialCurve = "preset",
        field_guides_path: FieldGuidesPath = "preset",
        quadrature: Quadrature = "preset",
        barrier_width: BarrierWidth = "preset",
        distance_weight: DistanceWeight = "preset",
        interpolation: Interpolation = "preset",
        knot_rule: KnotRule = "preset",
        relative_height: RelativeHeight = "preset",
        curve_segments: int = 200,
        gauss_points: int = 2,
        barrier_margin: float = 0.02,
        height_scale: float = 0.99,
        alpha_min: float = 1.0,
        alpha_max: float = 100000000.0,
        beta_first: float = 1000000.0,
        beta_min: float = 10.0,
        beta_max: float = 10000000000.0,
        knot_ratio: float = 1.0,
        feature_tolerance: float = 1.0,
        max_rounds: int = 24,
        max_iterations: int = 100,
        minimum_span: float = 0.0001,
        field: Field | npt.ArrayLike | None = None,
        quality: npt.ArrayLike | None = None,
        avoid: Avoid | npt.ArrayLike | None = None,
        field_region: npt.ArrayLike | None = None,
        progress: Progress | None = None,
    ) -> Curve:
        """Draw a smooth curve through points.

        A variational B-spline close to the surface, and its exact projection onto it, a polyline every segment of which
        lies inside one face.

        Parameters
        ----------
        picks : (p, 3) array of float, or p pairs (face, barycentrics)
            Points that the curve passes, in order. Those farther from the mesh than `pick_distance` are refused.
        closed : bool, default False
            True: a closed curve through at least 3 picks. False: an open one from the first to the last of at least 2.
        degree : int in [2, 4], default 3
            Polynomial degree of the spline.
        tension : float in [0, 1], default 0.0
            From 0 (as smooth as possible) to 1 (as straight as possible: geodesics between the picks). No unit.
        field_weight : float ≥ 0, default 2000.0
            Weight of the field against smoothness, in units of 1 / cost, for costs between 0 and 1. 0: the field has no
            effect.
        pick_tolerance : float or str, or a sequence of these, default '0'
            How far from each pick the curve may pass: it is as fair as possible within that distance. A length in the unit
            of the mesh, or text like '1.5 edges', in mean edges; one for all picks, or one for each. 0: it passes the
            picks. In place of a length, 'weight 100': no bound, but a pull that grows with the distance.
        pick_distance : float ≥ 0, default 0.0
            Picks that are farther from the mesh are refused; the others are moved to its nearest point. 0: 1 % of the
            diagonal.
        corners : sequence of int, or 'all', default ()
            Picks at which the curve turns, by their indices, or 'all'. It passes them, and is as fair as possible on either
            side.
        tangents : mapping of int to (3,) arrays, or pairs of these, optional
            Directions in which the curve passes picks, by their indices, as {0: (1, 0, 0)}. Their part along the surface
            counts, not their length. Such picks are passed whatever their tolerance. A corner has two, before and after it:
            {2: ((1, 0, 0), (0, 1, 0))}; None in place of one that is free.
        field_cost : {'natural', 'identity', 'square', 'exp-minus'}, default 'natural'
            What a value x of the field costs. natural: the cost of the field's kind: exp-minus for curvature, ridge and
            valley, square for normal variation and distances, else identity; identity: x; square: x^2; exp-minus: exp(-x),
            which draws the curve to large values.
        avoid_threshold : float, default 0.0
            The threshold of under-threshold and over-threshold, in the unit of the field.
        samples : int ≥ 0, default 256
            At least this many vertices at even steps of the spline's parameter, besides those where the curve crosses mesh
            edges and the picks. 0: none.
        max_segment_length : float ≥ 0, default 0.0
            No segment of the polyline is longer, in the unit of the mesh. 0: no limit.
        avoid_margin : float in (0, 1], default 0.02
            Distance within which faces to avoid push the curve away, relative to the diagonal of the mesh's box.
        field_curvature_scale : float in [0, 1], default 0.015
            Fields of curvature, ridges and valleys: radius that curvatures are averaged over, relative to the diagonal of
            the mesh's box. More: less noise.
        field_crease_angle : float in [0, 180], default 40.0
            Field of crease distance: creases are edges whose faces turn by more than this, in degrees.
        field_reach : float in (0, 1], default 0.1
            Fields of crease and boundary distance: the distance that becomes 1, relative to the diagonal.
        field_obstacle_value : float ≥ 0, default 1.0
            Field of obstacles: its value on the boundary of the region.
        field_obstacle_slope : float > 0, default 1.0
            Field of obstacles: how steeply it grows from the boundary of the region inwards, per diagonal.
        field_smoothing : float in [0, 1], default 0.0
            Radius over which the values are averaged, relative to the diagonal. 0: not averaged.
        field_normalised : bool, default False
            Maps the values between their quantiles of 1 % and 99 % to [0, 1].
        field_inverted : bool, default False
            Turns x into minimum + maximum - x.
        preset : {'default', 'paper'}, default 'default'
            The values of the settings that are left at preset, and of the numbers that are left at their default. default:
            the settings that gave the best curves; paper: those of the paper (2023), for comparison.
        fairness : {'preset', 'curvature', 'parametric'}, default 'preset'
            What makes a curve fair. preset: as the preset says, by default curvature; curvature: least curvature along the
            surface, wherever the picks lie; under a field and beside what is avoided as parametric; parametric: least
            second derivatives by a fixed parameter, as in the paper.
        bending : {'preset', 'geodesic', 'ambient'}, default 'preset'
            What smoothness means. preset: as the preset says, by default geodesic; geodesic: only bending within the
            surface is penalised; ambient: all bending, as in the paper.
        normal_bending_weight : float in (0, 1], default 0.05
            Share of the bending along the normal that counts with geodesic bending.
        distance_tolerance : float > 0, default 0.1
            Largest distance of the spline to the surface, in mean edge lengths; edges shorter than a hundredth of the
            square root of the surface's area count as that long. The polyline lies on the surface in any case.
        initial_curve : {'preset', 'geodesic-fit', 'control-polygon'}, default 'preset'
            How the first spline is made. preset: as the preset says, by default geodesic-fit; geodesic-fit: a fit to the
            path through the picks; control-polygon: Alg. 2 of the paper.
        field_guides_path : {'preset', 'off', 'on'}, default 'preset'
            Whether the initial path from pick to pick follows the field. preset: as the preset says, by default on; off:
            no, it is a geodesic, as in the paper; on: yes, it goes where the field costs little.
        quadrature : {'preset', 'foot-points', 'cells', 'samples'}, default 'preset'
            How integrals are computed. preset: as the preset says, by default foot-points; foot-points: at samples that are
            projected onto the surface, fast on any resolution; by cells for curves that this cannot handle; cells: exactly,
            cell by cell of a shell; samples: at even steps in a shell, as in the paper.
        barrier_width : {'preset', 'full', 'tight'}, default 'preset'
            How wide the barrier of the distance is. preset: as the preset says, by default full; full: the whole shell;
            tight: narrowed around the current curve, (12) of the paper.
        distance_weight : {'preset', 'schedule', 'adaptive'}, default 'preset'
            How the weight of the distance to the surface changes. preset: as the preset says, by default schedule;
            schedule: it grows from round to round; adaptive: (18) of the paper.
        interpolation : {'preset', 'constraint', 'penalty'}, default 'preset'
            How the spline is held at the picks. preset: as the preset says, by default constraint; constraint: exactly;
            penalty: by (9) of the paper.
        knot_rule : {'preset', 'energy-and-distance', 'feature-function'}, default 'preset'
            Where knots are inserted. preset: as the preset says, by default energy-and-distance; energy-and-distance: where
            they lower the energy most, and where the spline is too far from the surface; feature-function: (19)-(23) of the
            paper.
        relative_height : {'preset', 'smooth', 'linear'}, default 'preset'
            The height d relative to the surface, in a simplified shell. preset: as the preset says, by default smooth;
            smooth: a smooth map with the same values at bottom, surface and top; linear: (10) of the paper, with a kink at
            the surface.
        curve_segments : int in [1, 10000], default 200
            M of (14) to (16): quadrature samples divides the curve into so many even segments.
        gauss_points : int in [1, 4], default 2
            M' of (14) to (16). The paper gives no number.
        barrier_margin : float in (0, 1], default 0.02
            ε_b of (12), for barrier width tight.
        height_scale : float in (0, 1], default 0.99
            η of Sect. 4.2: the relative height of samples outside the shell, and the scale of all heights while there are
            any.
        alpha_min : float > 0, default 1.0
            α_min of (18), for weight of distance adaptive.
        alpha_max : float > 0, default 100000000.0
            α_max of (18).
        beta_first : float > 0, default 1000000.0
            β of (9) in the first round, for interpolation penalty.
        beta_min : float > 0, default 10.0
            β_min of (18) for β.
        beta_max : float > 0, default 10000000000.0
            β_max of (18) for β.
        knot_ratio : float > 0, default 1.0
            r of (22), for knot rule feature-function: more of it inserts more knots in a round.
        feature_tolerance : float ≥ 0, default 1.0
            ε_d: a curve within the tolerance gets no more knots where every span has less of the feature function, or the
            whole of it changes by less, relative to the energy. The paper gives no number.
        max_rounds : int ≥ 1, default 24
            Largest number of rounds of minimisation and knot insertion.
        max_iterations : int ≥ 1, default 100
            Largest number of Newton iterations per round.
        minimum_span : float in (0, 0.1], default 0.0001
            Shortest knot span, as a share of the whole parameter range.
        field : str or (n,) array of float, optional
            Draws the curve to where it costs little: a kind of field(), or a value for each vertex. 'auto': the quality,
            mapped to [0, 1], where there is one that is finite and not constant and that no threshold of avoid is for; else
            none.
        quality : (n,) array of float, optional
            A value for each vertex, for field 'quality' and 'auto' and for thresholds of avoid; None: the mesh's own.
        avoid : str, (k,) array of int or (m,) array of bool, optional
            Faces that the curve does not enter: their ids, or a bool for each face. 'under-threshold', 'over-threshold':
            those over which the mean of the field, or without a field of the quality, is under or over avoid_threshold.
        field_region : (k,) array of int or (m,) array of bool, optional
            The faces of obstacles, for field 'obstacle'.
        progress : callable, optional
            Called now and then with a fraction in [0, 1] and the name of a stage; cancels by returning False.

        Returns
        -------
        Curve
            Where it is not `usable`, it follows a shortest path, or shows how far it came.

        Raises
        ------
        InputError
            An argument is wrong; which, and what to do. Its subclasses tell which kind of argument.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> curve = mesh.curve(picks, closed=True, field='ridge')
        >>> curve.closed, curve.usable, len(curve.picks)
        (True, True, 4)
        """
        return self._draw(
            picks,
            {
                "closed": closed,
                "degree": degree,
                "tension": tension,
                "field_weight": field_weight,
                "pick_tolerance": pick_tolerance,
                "pick_distance": pick_distance,
                "corners": corners,
                "tangents": tangents,
                "field_cost": field_cost,
                "avoid_threshold": avoid_threshold,
                "samples": samples,
                "max_segment_length": max_segment_length,
                "avoid_margin": avoid_margin,
                "field_curvature_scale": field_curvature_scale,
                "field_crease_angle": field_crease_angle,
                "field_reach": field_reach,
                "field_obstacle_value": field_obstacle_value,
                "field_obstacle_slope": field_obstacle_slope,
                "field_smoothing": field_smoothing,
                "field_normalised": field_normalised,
                "field_inverted": field_inverted,
                "preset": preset,
                "fairness": fairness,
                "bending": bending,
                "normal_bending_weight": normal_bending_weight,
                "distance_tolerance": distance_tolerance,
                "initial_curve": initial_curve,
                "field_guides_path": field_guides_path,
                "quadrature": quadrature,
                "barrier_width": barrier_width,
                "distance_weight": distance_weight,
                "interpolation": interpolation,
                "knot_rule": knot_rule,
                "relative_height": relative_height,
                "curve_segments": curve_segments,
                "gauss_points": gauss_points,
                "barrier_margin": barrier_margin,
                "height_scale": height_scale,
                "alpha_min": alpha_min,
                "alpha_max": alpha_max,
                "beta_first": beta_first,
                "beta_min": beta_min,
                "beta_max": beta_max,
                "knot_ratio": knot_ratio,
                "feature_tolerance": feature_tolerance,
                "max_rounds": max_rounds,
                "max_iterations": max_iterations,
                "minimum_span": minimum_span,
            },
            {
                "field": field,
                "quality": quality,
                "avoid": avoid,
                "field_region": field_region,
            },
            progress,
        )

    def field(
        self,
        kind: FieldKind = "maximal-curvature",
        *,
        quality: npt.ArrayLike | None = None,
        region: npt.ArrayLike | None = None,
        curvature_scale: float = 0.015,
        crease_angle: float = 40.0,
        reach: float = 0.1,
        obstacle_value: float = 1.0,
        obstacle_slope: float = 1.0,
        smoothing: float = 0.0,
        normalised: bool = False,
        inverted: bool = False,
        progress: Progress | None = None,
    ) -> Floats:
        """Compute a scalar per vertex that curves can follow or avoid.

        It is the same in every unit and, but for the variation of normals, hardly depends on how fine the mesh is.

        Parameters
        ----------
        kind : {'normal-variation', 'maximal-curvature', 'ridge', 'valley', 'crease-distance', 'boundary-distance',
            'quality', 'obstacle'}, default 'maximal-curvature'
            What the values are made from. normal-variation: least product of the normals of a vertex and its faces;
            maximal-curvature: largest principal curvature, at a scale; ridge: how convex the surface is across, at a scale;
            valley: how concave the surface is across, at a scale; crease-distance: along the surface, to its sharp edges;
            boundary-distance: along the surface, to its own edges; quality: the per-vertex quality of the mesh; obstacle: a
            hill on a region of faces.
        quality : (n,) array of float, optional
            A value for each vertex, for kind 'quality'; None: the mesh's own.
        region : (k,) array of int or (m,) array of bool, optional
            The faces of obstacles, for kind 'obstacle'.
        curvature_scale : float in [0, 1], default 0.015
            Fields of curvature, ridges and valleys: radius that curvatures are averaged over, relative to the diagonal of
            the mesh's box. More: less noise.
        crease_angle : float in [0, 180], default 40.0
            Field of crease distance: creases are edges whose faces turn by more than this, in degrees.
        reach : float in (0, 1], default 0.1
            Fields of crease and boundary distance: the distance that becomes 1, relative to the diagonal.
        obstacle_value : float ≥ 0, default 1.0
            Field of obstacles: its value on the boundary of the region.
        obstacle_slope : float > 0, default 1.0
            Field of obstacles: how steeply it grows from the boundary of the region inwards, per diagonal.
        smoothing : float in [0, 1], default 0.0
            Radius over which the values are averaged, relative to the diagonal. 0: not averaged.
        normalised : bool, default False
            Maps the values between their quantiles of 1 % and 99 % to [0, 1].
        inverted : bool, default False
            Turns x into minimum + maximum - x.
        progress : callable, optional
            Called now and then with a fraction in [0, 1] and the name of a stage; cancels by returning False.

        Returns
        -------
        (n,) array of float
            A value for each vertex.

        Raises
        ------
        InputError
            An argument is wrong; which, and what to do. Its subclasses tell which kind of argument.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> values = mesh.field('valley', curvature_scale=0.03)
        >>> values.shape
        (1681,)
        >>> curve = mesh.curve(picks, field=values, field_cost='exp-minus')
        """
        return self._make_field(
            quality,
            region,
            {
                "kind": kind,
                "curvature_scale": curvature_scale,
                "crease_angle": crease_angle,
                "reach": reach,
                "obstacle_value": obstacle_value,
                "obstacle_slope": obstacle_slope,
                "smoothing": smoothing,
                "normalised": normalised,
                "inverted": inverted,
            },
            progress,
        )

    @abstractmethod
    def _prepare(
        self,
        vertices: Any,
        faces: npt.ArrayLike | None,
        options: Mapping[str, object],
        quality: npt.ArrayLike | None,
        progress: Progress | None,
    ) -> None: ...

    @abstractmethod
    def _draw(
        self,
        picks: Picks,
        options: Mapping[str, object],
        guides: Mapping[str, Any],
        progress: Progress | None,
    ) -> Curve: ...

    @abstractmethod
    def _make_field(
        self,
        quality: npt.ArrayLike | None,
        region: npt.ArrayLike | None,
        options: Mapping[str, object],
        progress: Progress | None,
    ) -> Floats: ...
