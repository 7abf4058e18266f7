# SPDX-License-Identifier: GPL-3.0-or-later
# Made from filters/filters.json by scripts/python_filters.py; do not edit.
"""Curves and fields on arrays."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Literal, TypeAlias

import numpy.typing as npt

from . import run
from .arrays import Floats
from .curve import Curve

Field: TypeAlias = Literal[
    "none", "normal-variation", "maximal-curvature", "ridge", "valley", "crease-distance", "boundary-distance",
    "quality", "obstacle", "auto",
]
FieldCost: TypeAlias = Literal["natural", "identity", "square", "exp-minus"]
Avoid: TypeAlias = Literal["none", "under-threshold", "over-threshold"]
Shell: TypeAlias = Literal["local", "full", "simplified", "preset"]
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
Kind: TypeAlias = Literal[
    "normal-variation", "maximal-curvature", "ridge", "valley", "crease-distance", "boundary-distance", "quality",
    "obstacle",
]


def draw_curve(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    picks: npt.ArrayLike,
    *,
    closed: bool = False,
    degree: int = 3,
    tension: float = 0.0,
    field: Field | npt.ArrayLike = "none",
    quality: npt.ArrayLike | None = None,
    field_weight: float = 2000.0,
    tube_radius: float = 0.0,
    pick_tolerance: float | str | Sequence[float | str] = "0",
    pick_distance: float = 0.0,
    corners: str = "",
    tangents: str = "",
    field_cost: FieldCost = "natural",
    avoid: Avoid | npt.ArrayLike = "none",
    avoid_threshold: float = 0.0,
    samples: int = 256,
    max_segment_length: float = 0.0,
    save: str | os.PathLike[str] | None = None,
    shell: Shell = "preset",
    avoid_margin: float = 0.02,
    field_curvature_scale: float = 0.015,
    field_crease_angle: float = 40.0,
    field_reach: float = 0.1,
    field_region: npt.ArrayLike | None = None,
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
    target_thickness: float = 0.135,
    target_edge_length: float = 1.0,
    shell_thickness: float = 0.75,
    shell_smoothing_passes: int = 3,
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
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> Curve:
    """Draw a smooth curve through points on a triangle mesh.

    A variational B-spline close to the surface, and its exact projection onto it, a polyline every segment of which
    lies inside one face. A further curve on the same arrays finds the surface prepared.

    Parameters
    ----------
    vertices : (n, 3) array of float
        Of the mesh.
    faces : (m, 3) array of int
        Of the mesh: ids of vertices, from 0 on, all oriented alike.
    picks : (p, 3) array of float
        Points that the curve passes, in order. Those farther from the mesh than 1 % of its diagonal are refused.
    closed : bool, default False
        True: a closed curve through at least 3 picks. False: an open one from the first to the last of at least 2.
    degree : int in [2, 4], default 3
        Polynomial degree of the spline.
    tension : float in [0, 1], default 0.0
        From 0 (as smooth as possible) to 1 (as straight as possible: geodesics between the picks). No unit.
    field : {'none', 'normal-variation', 'maximal-curvature', 'ridge', 'valley', 'crease-distance', 'boundary-distance',
        'quality', 'obstacle', 'auto'} or (n,) array of float, its values, default 'none'
        A scalar that draws the curve to where its cost is low. none: no field; normal-variation: least product of the
        normals of a vertex and its faces; maximal-curvature: largest principal curvature, at a scale; ridge: how convex
        the surface is across, at a scale; valley: how concave the surface is across, at a scale; crease-distance: along
        the surface, to its sharp edges; boundary-distance: along the surface, to its own edges; quality: the per-vertex
        quality of the mesh; obstacle: a hill on a region of faces; auto: the per-vertex quality, mapped to [0, 1],
        where the mesh has one that is finite and not constant and that no threshold of avoid is for; else none.
    quality : (n,) array of float, optional
        A value for each vertex, for field 'quality' or 'auto', and for faces to avoid where there is no field.
    field_weight : float ≥ 0, default 2000.0
        Weight of the field against smoothness, in units of 1 / cost, for costs between 0 and 1. 0: the field has no
        effect.
    tube_radius : float ≥ 0, default 0.0
        A closed tube mesh around the curve is made too, with this radius in the unit of the mesh, at most its diagonal.
        0: none.
    pick_tolerance : float or str, or a sequence of these, default '0'
        How far from each pick the curve may pass: it is as fair as possible within that distance. A length in the unit
        of the mesh, or in mean edges of it, as 1.5 edges, for all picks; or one for each, as 0.4, 0, 1.5 edges. 0: it
        passes the picks. In place of a length, weight 100: no bound, but a pull that grows with the distance.
    pick_distance : float ≥ 0, default 0.0
        Picks that are farther from the mesh are refused; the others are moved to its nearest point. 0: 1 % of the
        diagonal.
    corners : str, optional
        Picks at which the curve turns, by their numbers from 1, as 1,4; all: every pick. It passes them, and is as fair
        as possible on either side.
    tangents : str, optional
        Directions in which the curve passes picks, by their numbers from 1, as 1: 1, 0, 0; 4: 0, 1, 0. Their part along
        the surface counts, not their length. Such picks are passed whatever their tolerance. A corner has two, one
        before and one after it, as 2: 1, 0, 0 / 0, 1, 0; any in place of one that is free.
    field_cost : {'natural', 'identity', 'square', 'exp-minus'}, default 'natural'
        What a value x of the field costs. natural: the cost of the field's kind: exp-minus for curvature, ridge and
        valley, square for normal variation and distances, else identity; identity: x; square: x^2; exp-minus: exp(-x),
        which draws the curve to large values.
    avoid : {'none', 'under-threshold', 'over-threshold'} or (k,) array of int, ids of the faces, or (m,) array of bool,
        default 'none'
        Faces of the surface that the curve does not enter. none: it may enter all faces; under-threshold: the faces
        over which the mean of the field, or without a field of the per-vertex quality, is under the threshold;
        over-threshold: the same, over the threshold.
    avoid_threshold : float, default 0.0
        The threshold of under-threshold and over-threshold, in the unit of the field. Only with avoid under-threshold
        or over-threshold.
    samples : int ≥ 0, default 256
        At least this many vertices at even steps of the spline's parameter, besides those where the curve crosses mesh
        edges and the picks. 0: none.
    max_segment_length : float ≥ 0, default 0.0
        No segment of the polyline is longer than this, in the unit of the mesh. 0: not limited.
    save : str or path, optional
        A file that the curve is written to: the polyline (.ply, .obj, .dxf, .vtu, .csv), the spline itself
        (.bspline.obj, .bspline.dxf) or both (.json).
    shell : {'local', 'full', 'simplified', 'preset'}, default 'preset'
        Where the curve is sought. local: no prisms: the fibres of a full shell are followed beneath the curve; a shell
        is built only for a curve that needs one; full: a shell of one thin prism per face, built at the start;
        simplified: a shell of few thick prisms, which takes seconds to build on large meshes and is kept for the next
        curve; preset: as the preset says, by default local.
    avoid_margin : float in (0, 1], default 0.02
        Distance within which faces to avoid push the curve away, relative to the diagonal of the mesh's box.
    field_curvature_scale : float in [0, 1], default 0.015
        Fields of curvature, ridges and valleys: radius that curvatures are averaged over, relative to the diagonal of
        the mesh's box. More: less noise. Only with field maximal-curvature or ridge or valley.
    field_crease_angle : float in [0, 180], default 40.0
        Field of crease distance: creases are edges whose faces turn by more than this, in degrees. Only with field
        crease-distance.
    field_reach : float in (0, 1], default 0.1
        Fields of crease and boundary distance: the distance that becomes 1, relative to the diagonal. Only with field
        crease-distance or boundary-distance.
    field_region : (k,) array of int, ids of the faces, or (m,) array of bool, optional
        Field of obstacles: the faces where they are.
    field_obstacle_value : float ≥ 0, default 1.0
        Field of obstacles: its value on the boundary of the region. Only with field obstacle.
    field_obstacle_slope : float > 0, default 1.0
        Field of obstacles: how steeply it grows from the boundary of the region inwards, per diagonal. Only with field
        obstacle.
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
    target_thickness : float in (0, 1], default 0.135
        Simplified shell: longest pillar, bottom to top, relative to the longest side of the mesh's box. Only with shell
        simplified or preset.
    target_edge_length : float in (0, 1], default 1.0
        Simplified shell: shorter edges are collapsed where its invariants allow it, relative to the longest side of the
        mesh's box. Only with shell simplified or preset.
    shell_thickness : float in (0, 1000], default 0.75
        Full shell, also where local builds one: largest distance of its top and bottom from the surface, in mean edge
        lengths. Only with shell local or full or preset.
    shell_smoothing_passes : int ≥ 0, default 3
        Rounds of averaging of the pillar directions (the directions of the fibres).
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
    strict : bool, default False
        Refuses a mesh with duplicate faces, faces without area, edges or vertices that are not manifold, or faces
        turned opposite ways, and names them. Off: a mended copy is taken; the mesh is not changed.
    weld : float in [0, 0.01], default 0.0
        Joins vertices of a copy that are within this distance of each other, relative to the diagonal of the mesh; 0:
        none. For parts that only look joined.
    slits : bool, default False
        Leaves the mesh open where boundary edges lie on each other, as along seams of texture coordinates. Off: both
        sides are joined on a copy; the mesh is not changed.

    Returns
    -------
    Curve
        Where it is not `usable`, it follows a shortest path, or shows how far it came.

    Raises
    ------
    ValueError, TypeError
        An argument has a wrong shape or type, or is out of its range.
    CurveError
        The filter refuses the mesh or the picks, or fails; the message says which and what to do.
    """
    return run.draw(
        (vertices, faces),
        picks,
        {"field": field, "quality": quality, "avoid": avoid, "field_region": field_region},
        save,
        {
            "closed": closed,
            "degree": degree,
            "tension": tension,
            "field_weight": field_weight,
            "tube_radius": tube_radius,
            "pick_tolerance": pick_tolerance,
            "pick_distance": pick_distance,
            "corners": corners,
            "tangents": tangents,
            "field_cost": field_cost,
            "avoid_threshold": avoid_threshold,
            "samples": samples,
            "max_segment_length": max_segment_length,
            "shell": shell,
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
            "target_thickness": target_thickness,
            "target_edge_length": target_edge_length,
            "shell_thickness": shell_thickness,
            "shell_smoothing_passes": shell_smoothing_passes,
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
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )


def compute_field(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    kind: Kind = "maximal-curvature",
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
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> Floats:
    """Compute a scalar per vertex that curves can follow or avoid.

    It is the same in every unit and, but for the variation of normals, hardly depends on how fine the mesh is.

    Parameters
    ----------
    vertices : (n, 3) array of float
        Of the mesh.
    faces : (m, 3) array of int
        Of the mesh: ids of vertices, from 0 on, all oriented alike.
    kind : {'normal-variation', 'maximal-curvature', 'ridge', 'valley', 'crease-distance', 'boundary-distance',
        'quality', 'obstacle'}, default 'maximal-curvature'
        What the values are made from. normal-variation: least product of the normals of a vertex and its faces;
        maximal-curvature: largest principal curvature, at a scale; ridge: how convex the surface is across, at a scale;
        valley: how concave the surface is across, at a scale; crease-distance: along the surface, to its sharp edges;
        boundary-distance: along the surface, to its own edges; quality: the per-vertex quality of the mesh; obstacle: a
        hill on a region of faces.
    quality : (n,) array of float, optional
        A value for each vertex, for kind 'quality'.
    region : (k,) array of int, ids of the faces, or (m,) array of bool, optional
        The faces of obstacles, for kind 'obstacle'.
    curvature_scale : float in [0, 1], default 0.015
        Fields of curvature, ridges and valleys: radius that curvatures are averaged over, relative to the diagonal of
        the mesh's box. More: less noise. Only with kind maximal-curvature or ridge or valley.
    crease_angle : float in [0, 180], default 40.0
        Field of crease distance: creases are edges whose faces turn by more than this, in degrees. Only with kind
        crease-distance.
    reach : float in (0, 1], default 0.1
        Fields of crease and boundary distance: the distance that becomes 1, relative to the diagonal. Only with kind
        crease-distance or boundary-distance.
    obstacle_value : float ≥ 0, default 1.0
        Field of obstacles: its value on the boundary of the region. Only with kind obstacle.
    obstacle_slope : float > 0, default 1.0
        Field of obstacles: how steeply it grows from the boundary of the region inwards, per diagonal. Only with kind
        obstacle.
    smoothing : float in [0, 1], default 0.0
        Radius over which the values are averaged, relative to the diagonal. 0: not averaged.
    normalised : bool, default False
        Maps the values between their quantiles of 1 % and 99 % to [0, 1].
    inverted : bool, default False
        Turns x into minimum + maximum - x.
    strict : bool, default False
        Refuses a mesh with duplicate faces, faces without area, edges or vertices that are not manifold, or faces
        turned opposite ways, and names them. Off: a mended copy is taken; the mesh is not changed.
    weld : float in [0, 0.01], default 0.0
        Joins vertices of a copy that are within this distance of each other, relative to the diagonal of the mesh; 0:
        none. For parts that only look joined.
    slits : bool, default False
        Leaves the mesh open where boundary edges lie on each other, as along seams of texture coordinates. Off: both
        sides are joined on a copy; the mesh is not changed.

    Returns
    -------
    (n,) array of float
        A value for each vertex.

    Raises
    ------
    ValueError, TypeError
        An argument has a wrong shape or type, or is out of its range.
    CurveError
        The filter refuses the mesh or the picks, or fails; the message says which and what to do.
    """
    return run.compute(
        (vertices, faces),
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
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )
