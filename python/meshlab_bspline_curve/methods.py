# SPDX-License-Identifier: GPL-3.0-or-later
# Made from filters/filters.json by scripts/python_filters.py; do not edit.
"""The filters as methods of pymeshlab.MeshSet."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, TypeAlias

import pymeshlab

from .run import apply

Field: TypeAlias = Literal[
    "none", "normal-variation", "maximal-curvature", "ridge", "valley", "crease-distance", "boundary-distance",
    "quality", "obstacle", "auto",
]
FieldCost: TypeAlias = Literal["natural", "identity", "square", "exp-minus"]
Avoid: TypeAlias = Literal["none", "selected-faces", "selected-vertices", "under-threshold", "over-threshold"]
Shell: TypeAlias = Literal["local", "full", "simplified", "preset"]
FieldRegion: TypeAlias = Literal["selected-faces", "selected-vertices"]
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
Region: TypeAlias = Literal["selected-faces", "selected-vertices"]
Keep: TypeAlias = Literal["all", "largest", "smallest", "inside", "outside", "seed"]
Fill: TypeAlias = Literal["none", "flat", "smooth"]
Profile: TypeAlias = Literal["step", "ramp", "round"]
Side: TypeAlias = Literal["both", "left", "right"]
Place: TypeAlias = Literal["point", "curve"]
Boundaries: TypeAlias = Literal["selected-faces", "face-quality", "face-colour", "vertex-quality"]
Edit: TypeAlias = Literal["join", "split", "trim", "extend", "reverse"]
Ends: TypeAlias = Literal["end", "start", "both"]
Shape: TypeAlias = Literal["smooth", "flat"]


def generate_bspline_curve_on_surface(
    self: pymeshlab.MeshSet,
    *,
    surface_layer: int | None = None,
    closed: bool = False,
    degree: int = 3,
    tension: float = 0.0,
    field: Field = "none",
    field_weight: float = 2000.0,
    tube_radius: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    pick_tolerance: float | str | Sequence[float | str] = "0",
    pick_distance: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    corners: str = "",
    tangents: str = "",
    picks_layer: int | None = None,
    picks_file: str = "",
    picks: str = "",
    field_cost: FieldCost = "natural",
    avoid: Avoid = "none",
    avoid_threshold: float = 0.0,
    samples: int = 256,
    max_segment_length: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    save: str = "",
    shell: Shell = "preset",
    control_polygon: bool = False,
    shell_layers: bool = False,
    avoid_margin: float = 0.02,
    field_curvature_scale: float = 0.015,
    field_crease_angle: float = 40.0,
    field_reach: float = 0.1,
    field_region: FieldRegion = "selected-faces",
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
) -> dict[str, Any]:
    """Draws a smooth curve through picked points on a triangle mesh.

    Draws a smooth curve through picked points on a triangle mesh: a variational B-spline close to the surface, and its
    exact projection onto it, a polyline every segment of which lies inside one face. The curve becomes a new layer; the
    mesh is not changed. Picks come from Edit > PickPoints, a layer of points, a file or text; their order is the order
    of the curve. A scalar per vertex (a field) may draw the curve to where its cost is low. Each vertex of the curve
    knows its face (`face_index`), its barycentric coordinates there (`barycentric`) and its parameter (`t`).

    Parameters
    ----------
    surface_layer : int, optional
        The layer with the triangle mesh that the curve is drawn on. Default: the current layer. If that has no faces,
        or is the tube of a curve: the layer that it was drawn on, else the only other layer with faces.
    closed : bool, default False
        On: a closed curve through at least 3 picks. Off: an open curve from the first to the last of at least 2 picks,
        unless the file of picks says that it is closed.
    degree : int in [2, 4], default 3
        Polynomial degree of the spline.
    tension : float in [0, 1], default 0.0
        From 0 (as smooth as possible) to 1 (as straight as possible: geodesics between the picks). No unit.
    field : {'none', 'normal-variation', 'maximal-curvature', 'ridge', 'valley', 'crease-distance', 'boundary-distance',
        'quality', 'obstacle', 'auto'}, default 'none'
        A scalar that draws the curve to where its cost is low. none: no field; normal-variation: least product of the
        normals of a vertex and its faces; maximal-curvature: largest principal curvature, at a scale; ridge: how convex
        the surface is across, at a scale; valley: how concave the surface is across, at a scale; crease-distance: along
        the surface, to its sharp edges; boundary-distance: along the surface, to its own edges; quality: the per-vertex
        quality of the mesh; obstacle: a hill on a region of faces; auto: the per-vertex quality, mapped to [0, 1],
        where the mesh has one that is finite and not constant and that no threshold of avoid is for; else none.
    field_weight : float ≥ 0, default 2000.0
        Weight of the field against smoothness, in units of 1 / cost, for costs between 0 and 1. 0: the field has no
        effect.
    tube_radius : float ≥ 0, default 0.0
        A closed tube mesh around the curve becomes a layer too, with this radius in the unit of the mesh, at most its
        diagonal. 0: no tube.
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
    picks_layer : int, optional
        A layer of points without faces; the curve passes through its vertices in their order. The surface itself
        (default): no layer of picks.
    picks_file : str, optional
        A file of picks in world coordinates: .pp as PickPoints saves it, .json {"picks": [[x, y, z], ...]}, .mrk.json
        or .fcsv of 3D Slicer, .csv, .xyz, .txt or .asc with one point a line. Empty: no file.
    picks : str, optional
        Picks as text "x y z; x y z; ..." in world coordinates. Empty: no text. Without text, file and layer the points
        of Edit > PickPoints on the surface are used. Picks farther from the surface than 1 % of its diagonal are
        refused.
    field_cost : {'natural', 'identity', 'square', 'exp-minus'}, default 'natural'
        What a value x of the field costs. natural: the cost of the field's kind: exp-minus for curvature, ridge and
        valley, square for normal variation and distances, else identity; identity: x; square: x^2; exp-minus: exp(-x),
        which draws the curve to large values.
    avoid : {'none', 'selected-faces', 'selected-vertices', 'under-threshold', 'over-threshold'}, default 'none'
        Faces of the surface that the curve does not enter. none: it may enter all faces; selected-faces: the selected
        faces; selected-vertices: the faces all of whose vertices are selected; under-threshold: the faces over which
        the mean of the field, or without a field of the per-vertex quality, is under the threshold; over-threshold: the
        same, over the threshold.
    avoid_threshold : float, default 0.0
        The threshold of under-threshold and over-threshold, in the unit of the field. Only with avoid under-threshold
        or over-threshold.
    samples : int ≥ 0, default 256
        At least this many vertices at even steps of the spline's parameter, besides those where the curve crosses mesh
        edges and the picks. 0: none.
    max_segment_length : float ≥ 0, default 0.0
        No segment of the polyline is longer than this, in the unit of the mesh. 0: not limited.
    save : str or path, optional
        A file that the curve is written to, in world coordinates: the polyline, or the spline itself where the name
        ends with .bspline.obj, .bspline.dxf, .step or .iges, which name millimetres (.json: both). MeshLab's own
        exporters lose the edges, the quality or the spline. Empty: no file.
    shell : {'local', 'full', 'simplified', 'preset'}, default 'preset'
        Where the curve is sought. local: no prisms: the fibres of a full shell are followed beneath the curve; a shell
        is built only for a curve that needs one; full: a shell of one thin prism per face, built at the start;
        simplified: a shell of few thick prisms, which takes seconds to build on large meshes and is kept for the next
        curve; preset: as the preset says, by default local.
    control_polygon : bool, default False
        The control points of the spline and the segments between them become a layer too.
    shell_layers : bool, default False
        Top and bottom of the shell become layers too; a local shell is built for that.
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
    field_region : {'selected-faces', 'selected-vertices'}, default 'selected-faces'
        Field of obstacles: where they are. selected-faces: the selected faces; selected-vertices: the faces all of
        whose vertices are selected. Only with field obstacle.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "generate_bspline_curve_on_surface",
        {
            "surface_layer": surface_layer,
            "closed": closed,
            "degree": degree,
            "tension": tension,
            "field": field,
            "field_weight": field_weight,
            "tube_radius": tube_radius,
            "pick_tolerance": pick_tolerance,
            "pick_distance": pick_distance,
            "corners": corners,
            "tangents": tangents,
            "picks_layer": picks_layer,
            "picks_file": picks_file,
            "picks": picks,
            "field_cost": field_cost,
            "avoid": avoid,
            "avoid_threshold": avoid_threshold,
            "samples": samples,
            "max_segment_length": max_segment_length,
            "save": save,
            "shell": shell,
            "control_polygon": control_polygon,
            "shell_layers": shell_layers,
            "avoid_margin": avoid_margin,
            "field_curvature_scale": field_curvature_scale,
            "field_crease_angle": field_crease_angle,
            "field_reach": field_reach,
            "field_region": field_region,
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


def compute_scalar_field_for_curves_per_vertex(
    self: pymeshlab.MeshSet,
    *,
    kind: Kind = "maximal-curvature",
    curvature_scale: float = 0.015,
    crease_angle: float = 40.0,
    reach: float = 0.1,
    region: Region = "selected-faces",
    obstacle_value: float = 1.0,
    obstacle_slope: float = 1.0,
    smoothing: float = 0.0,
    normalised: bool = False,
    inverted: bool = False,
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> dict[str, Any]:
    """Computes a scalar per vertex that curves can follow or avoid.

    Computes a scalar per vertex that curves can follow or avoid, and makes it the quality of the current layer:
    variation of normals, curvature, ridges and valleys at a scale, distances to creases and to the boundary, obstacles
    from a selection. It is the same in every unit and, but for the variation of normals, hardly depends on how fine the
    mesh is. The filter B-spline Curve on Surface takes the same fields by itself.

    Parameters
    ----------
    kind : {'normal-variation', 'maximal-curvature', 'ridge', 'valley', 'crease-distance', 'boundary-distance',
        'quality', 'obstacle'}, default 'maximal-curvature'
        What the values are made from. normal-variation: least product of the normals of a vertex and its faces;
        maximal-curvature: largest principal curvature, at a scale; ridge: how convex the surface is across, at a scale;
        valley: how concave the surface is across, at a scale; crease-distance: along the surface, to its sharp edges;
        boundary-distance: along the surface, to its own edges; quality: the per-vertex quality of the mesh; obstacle: a
        hill on a region of faces.
    curvature_scale : float in [0, 1], default 0.015
        Fields of curvature, ridges and valleys: radius that curvatures are averaged over, relative to the diagonal of
        the mesh's box. More: less noise. Only with kind maximal-curvature or ridge or valley.
    crease_angle : float in [0, 180], default 40.0
        Field of crease distance: creases are edges whose faces turn by more than this, in degrees. Only with kind
        crease-distance.
    reach : float in (0, 1], default 0.1
        Fields of crease and boundary distance: the distance that becomes 1, relative to the diagonal. Only with kind
        crease-distance or boundary-distance.
    region : {'selected-faces', 'selected-vertices'}, default 'selected-faces'
        Field of obstacles: where they are. selected-faces: the selected faces; selected-vertices: the faces all of
        whose vertices are selected. Only with kind obstacle.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "compute_scalar_field_for_curves_per_vertex",
        {
            "kind": kind,
            "curvature_scale": curvature_scale,
            "crease_angle": crease_angle,
            "reach": reach,
            "region": region,
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


def imprint_curves(
    self: pymeshlab.MeshSet,
    *,
    surface_layer: int | None = None,
    curve_layer: int | None = None,
    max_distance: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    direction: str = "",
    project_curves: bool = False,
    snap: float = 1e-09,
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> dict[str, Any]:
    """Makes curves edges of a copy of the mesh.

    Makes curves edges of a copy of the mesh, a new layer. Vertices of the mesh come first, as they are; only faces that
    a curve passes are divided, and no new face is flat or turned over. Curves may cross themselves and each other, and
    run along edges and through vertices; crossings become vertices. Colours, qualities, texture coordinates, selections
    and custom attributes of numbers and points come along, interpolated linearly in each face. Vertices know whether
    they are on a curve (`on_curve`), faces of which face they are part (`parent`).

    Parameters
    ----------
    surface_layer : int, optional
        The layer with the triangle mesh. Default: the current layer. If that has no faces, or is the tube of a curve:
        the layer that it was drawn on, else the only other layer with faces.
    curve_layer : int, optional
        A layer of polylines: edges without faces. The surface itself (default) stands for its visible curves, and for
        visible polylines near it that belong to no other layer. Results of filters (offsets, patterns) are taken where
        they are chosen here, or where no such curve is visible; else, curves of other surfaces that are near. In
        MeshLab's window the current layer is chosen if it is a curve.
    max_distance : float ≥ 0, default 0.0
        Polylines are projected onto the mesh; one that is farther away anywhere is refused. Curves that this plugin
        drew on the surface know their faces and are taken exactly. 0: 1 % of the diagonal, along a direction any
        distance.
    direction : str, optional
        "x y z": polylines are draped: each of their points is moved along this direction to the first face that is met
        there, coming from outside, however far away. A warning tells where a line jumps, and where it is parted since
        it is beside the mesh. Empty: to the nearest point.
    project_curves : bool, default False
        Projects also curves that know their faces, as for a mesh that changed since they were drawn, which is refused
        otherwise.
    snap : float in [0, 0.01], default 1e-09
        Points that are nearer to each other, to an edge, a vertex or another curve are taken as one, relative to the
        altitudes of a face. 0: only where they are one.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "imprint_curves",
        {
            "surface_layer": surface_layer,
            "curve_layer": curve_layer,
            "max_distance": max_distance,
            "direction": direction,
            "project_curves": project_curves,
            "snap": snap,
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )


def cut_along_curves(
    self: pymeshlab.MeshSet,
    *,
    surface_layer: int | None = None,
    curve_layer: int | None = None,
    keep: Keep = "all",
    seed: str = "",
    fill: Fill = "none",
    split: bool = False,
    relief: float = 0.0,
    max_distance: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    drop_untouched: bool = False,
    stroke: float = 0.0,
    profile: Profile = "step",
    profile_width: float = 0.0,
    thickness: float = 0.0,
    base: float = 0.0,
    base_direction: str = "",
    base_height: float = 0.0,
    direction: str = "",
    project_curves: bool = False,
    snap: float = 1e-09,
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> dict[str, Any]:
    """Opens a copy of the mesh along curves, whole or in parts.

    Opens a copy of the mesh along curves: vertices on them are doubled, so that each side has its own, and an open
    curve becomes a slit. A warning counts the curves that part nothing. The result is one layer, a layer for each part,
    or the part that is kept, whose holes can be filled. Colours, qualities, texture coordinates, selections and custom
    attributes of numbers and points come along, interpolated linearly in each face.

    Parameters
    ----------
    surface_layer : int, optional
        The layer with the triangle mesh. Default: the current layer. If that has no faces, or is the tube of a curve:
        the layer that it was drawn on, else the only other layer with faces.
    curve_layer : int, optional
        A layer of polylines: edges without faces. The surface itself (default) stands for its visible curves, and for
        visible polylines near it that belong to no other layer. Results of filters (offsets, patterns) are taken where
        they are chosen here, or where no such curve is visible; else, curves of other surfaces that are near. In
        MeshLab's window the current layer is chosen if it is a curve.
    keep : {'all', 'largest', 'smallest', 'inside', 'outside', 'seed'}, default 'all'
        Which parts the result has. Components that no curve parts stay with any of them. all: all parts; largest: the
        part at curves with the largest area; smallest: the one with the smallest area; inside: the parts that an odd
        number of curves parts from the largest, so that the holes of letters are not among them; outside: the parts
        that an even number does; seed: the parts at points.
    seed : str, optional
        Points of the parts to keep, "x y z; x y z" in world coordinates. Empty: the points of Edit > PickPoints on the
        surface. Only with keep seed.
    fill : {'none', 'flat', 'smooth'}, default 'none'
        What becomes of the holes that the other parts leave. Of parts that become a mesh each, flat patches are the
        same triangles on both sides of a cut, unless curves cross there, or patches can be sound on one side alone.
        none: they stay open; flat: a triangulation that bends least; with new vertices only where it would cross the
        mesh; smooth: as dense as around, with its tangent planes.
    split : bool, default False
        Makes a layer of each part at curves, the largest first, and one of all that no curve parts. On in MeshLab's
        window. Only with keep all.
    relief : float, default 0.0
        Keeps the whole surface, with the parts to keep moved by this along their normals, in the unit of the mesh, and
        walls around them. Negative: engraved. 0: the parts are cut. Only with keep largest or smallest or inside or
        outside or seed.
    max_distance : float ≥ 0, default 0.0
        Polylines are projected onto the mesh; one that is farther away anywhere is refused. Curves that this plugin
        drew on the surface know their faces and are taken exactly. 0: 1 % of the diagonal, along a direction any
        distance.
    drop_untouched : bool, default False
        Drops components that no curve parts as well; a seed keeps one. Only with keep largest or smallest or inside or
        outside or seed.
    stroke : float ≥ 0, default 0.0
        Cuts along both sides of the curves, round their ends, at half of this width from them, in the unit of the mesh:
        the parts inside are strokes, as for slots and ridges by a relief. 0: along the curves.
    profile : {'step', 'ramp', 'round'}, default 'step'
        How a relief rises from its rim inwards. step: up at once, by a wall; ramp: straight up over a width; round: as
        a quarter of an ellipse.
    profile_width : float ≥ 0, default 0.0
        Over which a relief rises, along the surface, in the unit of the mesh. 0: its height; of strokes half their
        width. Only with profile ramp or round.
    thickness : float, default 0.0
        Makes each part that is cut out a closed wall of this thickness, in the unit of the mesh: outwards, or inwards
        where it is negative. Where that would cross itself the wall is thinner, and a warning says so. 0: none.
        Excludes filled holes and reliefs.
    base : float ≥ 0, default 0.0
        Makes each part that is cut out a closed solid on a base: its rims go straight to a plane, this far beyond the
        farthest point of the part, in the unit of the mesh. 0: none, but to the height of the base where a direction is
        given.
    base_direction : str, optional
        "x y z": from the part to the plane of its base, at right angles to that. Empty: against the mean normal of the
        part.
    base_height : float, default 0.0
        Where the plane of the base is, along its direction from the origin, if the length of the base is 0 and a
        direction is given.
    direction : str, optional
        "x y z": polylines are draped: each of their points is moved along this direction to the first face that is met
        there, coming from outside, however far away. A warning tells where a line jumps, and where it is parted since
        it is beside the mesh. Empty: to the nearest point.
    project_curves : bool, default False
        Projects also curves that know their faces, as for a mesh that changed since they were drawn, which is refused
        otherwise.
    snap : float in [0, 0.01], default 1e-09
        Points that are nearer to each other, to an edge, a vertex or another curve are taken as one, relative to the
        altitudes of a face. 0: only where they are one.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "cut_along_curves",
        {
            "surface_layer": surface_layer,
            "curve_layer": curve_layer,
            "keep": keep,
            "seed": seed,
            "fill": fill,
            "split": split,
            "relief": relief,
            "max_distance": max_distance,
            "drop_untouched": drop_untouched,
            "stroke": stroke,
            "profile": profile,
            "profile_width": profile_width,
            "thickness": thickness,
            "base": base,
            "base_direction": base_direction,
            "base_height": base_height,
            "direction": direction,
            "project_curves": project_curves,
            "snap": snap,
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )


def segment_by_curves(
    self: pymeshlab.MeshSet,
    *,
    surface_layer: int | None = None,
    curve_layer: int | None = None,
    split: bool = False,
    max_distance: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    direction: str = "",
    project_curves: bool = False,
    snap: float = 1e-09,
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> dict[str, Any]:
    """Labels, colours and measures the parts that curves leave.

    Labels, colours and measures the parts that curves leave, in a copy of the mesh, a new layer: the quality of a face
    is the number of its part, from 0 for the largest area on. The log has faces, area, perimeter, centroid and Euler
    characteristic of each. Colours, qualities, texture coordinates, selections and custom attributes of numbers and
    points come along, interpolated linearly in each face.

    Parameters
    ----------
    surface_layer : int, optional
        The layer with the triangle mesh. Default: the current layer. If that has no faces, or is the tube of a curve:
        the layer that it was drawn on, else the only other layer with faces.
    curve_layer : int, optional
        A layer of polylines: edges without faces. The surface itself (default) stands for its visible curves, and for
        visible polylines near it that belong to no other layer. Results of filters (offsets, patterns) are taken where
        they are chosen here, or where no such curve is visible; else, curves of other surfaces that are near. In
        MeshLab's window the current layer is chosen if it is a curve.
    split : bool, default False
        Makes a layer of each part at curves, the largest first, and one of all that no curve parts.
    max_distance : float ≥ 0, default 0.0
        Polylines are projected onto the mesh; one that is farther away anywhere is refused. Curves that this plugin
        drew on the surface know their faces and are taken exactly. 0: 1 % of the diagonal, along a direction any
        distance.
    direction : str, optional
        "x y z": polylines are draped: each of their points is moved along this direction to the first face that is met
        there, coming from outside, however far away. A warning tells where a line jumps, and where it is parted since
        it is beside the mesh. Empty: to the nearest point.
    project_curves : bool, default False
        Projects also curves that know their faces, as for a mesh that changed since they were drawn, which is refused
        otherwise.
    snap : float in [0, 0.01], default 1e-09
        Points that are nearer to each other, to an edge, a vertex or another curve are taken as one, relative to the
        altitudes of a face. 0: only where they are one.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "segment_by_curves",
        {
            "surface_layer": surface_layer,
            "curve_layer": curve_layer,
            "split": split,
            "max_distance": max_distance,
            "direction": direction,
            "project_curves": project_curves,
            "snap": snap,
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )


def offset_curve_on_surface(
    self: pymeshlab.MeshSet,
    *,
    surface_layer: int | None = None,
    curve_layer: int | None = None,
    offset: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    side: Side = "both",
    select_band: bool = False,
    max_distance: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    direction: str = "",
    project_curves: bool = False,
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> dict[str, Any]:
    """Draws the lines at a distance from curves, measured along the surface.

    Draws the lines at a distance from curves, measured along the surface, as new layers that are curves of this plugin.
    Where a line runs into itself it ends there, so that no piece crosses itself or another.

    Parameters
    ----------
    surface_layer : int, optional
        The layer with the triangle mesh. Default: the current layer. If that has no faces, or is the tube of a curve:
        the layer that it was drawn on, else the only other layer with faces.
    curve_layer : int, optional
        A layer of polylines: edges without faces. The surface itself (default) stands for its visible curves, and for
        visible polylines near it that belong to no other layer. Results of filters (offsets, patterns) are taken where
        they are chosen here, or where no such curve is visible; else, curves of other surfaces that are near. In
        MeshLab's window the current layer is chosen if it is a curve.
    offset : float ≥ 0, default 0.0
        Distance from the curve along the surface. 0: 2 % of the diagonal.
    side : {'both', 'left', 'right'}, default 'both'
        On which side of the curve. both: also round the ends of an open curve; left: seen along the curve, the
        surface's normal upwards; right: likewise.
    select_band : bool, default False
        Selects the faces of the surface whose middle is within the distance, on the side asked for.
    max_distance : float ≥ 0, default 0.0
        Polylines are projected onto the mesh; one that is farther away anywhere is refused. Curves that this plugin
        drew on the surface know their faces and are taken exactly. 0: 1 % of the diagonal, along a direction any
        distance.
    direction : str, optional
        "x y z": polylines are draped: each of their points is moved along this direction to the first face that is met
        there, coming from outside, however far away. A warning tells where a line jumps, and where it is parted since
        it is beside the mesh. Empty: to the nearest point.
    project_curves : bool, default False
        Projects also curves that know their faces, as for a mesh that changed since they were drawn, which is refused
        otherwise.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "offset_curve_on_surface",
        {
            "surface_layer": surface_layer,
            "curve_layer": curve_layer,
            "offset": offset,
            "side": side,
            "select_band": select_band,
            "max_distance": max_distance,
            "direction": direction,
            "project_curves": project_curves,
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )


def pattern_on_surface(
    self: pymeshlab.MeshSet,
    *,
    surface_layer: int | None = None,
    drawing: str = "",
    text: str = "",
    font: str = "",
    place: Place = "point",
    centre: str = "",
    curve_layer: int | None = None,
    size: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    layers: str = "",
    scale: float = 0.0,
    up: str = "",
    repeat: int = 0,
    spacing: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    start: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    shift: float = 0.0,
    smoothing: int = 0,
    tolerance: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    corner_angle: float = 20.0,
    max_distance: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    direction: str = "",
    project_curves: bool = False,
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> dict[str, Any]:
    """Carries a planar drawing or a text to the surface, as curves.

    Carries a planar drawing or a text to the surface: round a point, along straightest geodesics from it (exponential
    map), or along a curve, repeated as often as asked. Each path becomes curves through picks of its own, parted at its
    corners, where they meet exactly. All of them are one new layer of polylines, which the filters that use curves
    take. The log tells how much lengths are distorted.

    Parameters
    ----------
    surface_layer : int, optional
        The layer with the triangle mesh. Default: the current layer. If that has no faces, or is the tube of a curve:
        the layer that it was drawn on, else the only other layer with faces.
    drawing : str, optional
        A file with a planar drawing: the paths of .svg, or the curves of .dxf. Empty: a text.
    text : str, optional
        A text to carry in place of a drawing, as outlines of the letters of the font. Empty: a drawing.
    font : str, optional
        The font file of the text. Empty: a plain sans serif of this system, such as DejaVu Sans or Arial; the log names
        its file. MeshLab's window begins with the font that was given last.
    place : {'point', 'curve'}, default 'point'
        Where the drawing goes. point: the middle of the drawing comes to lie on the centre; curve: the drawing's x axis
        along the curve, its y axis to the left, seen with the surface's normal upwards.
    centre : str, optional
        The point "x y z" in world coordinates. Empty: the one point of Edit > PickPoints on the surface. Only with
        place point.
    curve_layer : int, optional
        A layer of polylines: edges without faces. The surface itself (default) stands for its visible curves, and for
        visible polylines near it that belong to no other layer. Results of filters (offsets, patterns) are taken where
        they are chosen here, or where no such curve is visible; else, curves of other surfaces that are near. In
        MeshLab's window the current layer is chosen if it is a curve.
    size : float ≥ 0, default 0.0
        The longer side of the drawing, or of the whole text, in the unit of the mesh. 0: as Scale says; if that is 0 as
        well, 10 % of the diagonal, or along a curve so that copies touch.
    layers : str, optional
        The layers of a DXF to read, with commas between them, also where they are off. Empty: all that are not off or
        frozen.
    scale : float ≥ 0, default 0.0
        Units of the mesh for one of the drawing (of a text: for the height of the font, its em). 0: as Size says.
    up : str, optional
        The direction "x y z" in space that the drawing's up follows at the centre. Empty: the y axis, or z where the
        surface faces along y. Only with place point.
    repeat : int in [0, 100000], default 0
        Copies along each curve, evenly spaced. 0: as many as Spacing says, or one. Only with place curve.
    spacing : float ≥ 0, default 0.0
        Length of the curve from one copy to the next; on a closed curve the nearest that divides its length. 0: as
        Copies says. Only with place curve.
    start : float ≥ 0, default 0.0
        Length of the curve before the first copy. Only with place curve.
    shift : float, default 0.0
        Moves the drawing to the left of the curve, in the unit of the mesh; negative: to the right. Only with place
        curve.
    smoothing : int in [0, 1000], default 0
        Smooths a copy of the mesh along its normals this often, and finds the ways of the drawing on it: evens patterns
        on rough scans. The curves lie on the mesh itself.
    tolerance : float ≥ 0, default 0.0
        Largest distance of the curves to the carried drawing, in the unit of the mesh. 0: 0.1 % of the mean size of its
        paths.
    corner_angle : float in (0, 179], default 20.0
        Paths are parted into curves where they turn by more than this, in degrees.
    max_distance : float ≥ 0, default 0.0
        Polylines are projected onto the mesh; one that is farther away anywhere is refused. Curves that this plugin
        drew on the surface know their faces and are taken exactly. 0: 1 % of the diagonal, along a direction any
        distance.
    direction : str, optional
        "x y z": polylines are draped: each of their points is moved along this direction to the first face that is met
        there, coming from outside, however far away. A warning tells where a line jumps, and where it is parted since
        it is beside the mesh. Empty: to the nearest point.
    project_curves : bool, default False
        Projects also curves that know their faces, as for a mesh that changed since they were drawn, which is refused
        otherwise.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "pattern_on_surface",
        {
            "surface_layer": surface_layer,
            "drawing": drawing,
            "text": text,
            "font": font,
            "place": place,
            "centre": centre,
            "curve_layer": curve_layer,
            "size": size,
            "layers": layers,
            "scale": scale,
            "up": up,
            "repeat": repeat,
            "spacing": spacing,
            "start": start,
            "shift": shift,
            "smoothing": smoothing,
            "tolerance": tolerance,
            "corner_angle": corner_angle,
            "max_distance": max_distance,
            "direction": direction,
            "project_curves": project_curves,
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )


def fit_curve_to_selection_boundary(
    self: pymeshlab.MeshSet,
    *,
    surface_layer: int | None = None,
    boundaries: Boundaries = "selected-faces",
    deviation: float | str = "0",
    corner_angle: float = 60.0,
    degree: int = 3,
    tension: float = 0.0,
    samples: int = 256,
    max_segment_length: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    distance_tolerance: float = 0.1,
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> dict[str, Any]:
    """Makes smooth curves along the boundaries of selected faces, or of labels.

    Makes smooth curves along the jagged boundaries of the selected faces, or of all labels of a segmentation, as new
    layers that are curves of this plugin: the drawing tool takes them up. Nowhere is a curve farther from its boundary
    than the deviation; it turns where the boundary really turns. A boundary between two labels is drawn once, from
    junction to junction, and junctions stay single points.

    Parameters
    ----------
    surface_layer : int, optional
        The layer with the triangle mesh that the curve is drawn on. Default: the current layer. If that has no faces,
        or is the tube of a curve: the layer that it was drawn on, else the only other layer with faces.
    boundaries : {'selected-faces', 'face-quality', 'face-colour', 'vertex-quality'}, default 'selected-faces'
        Which boundaries become curves. selected-faces: round all that is selected; face-quality: whole numbers; others
        are rounded; face-colour: each colour is a label; vertex-quality: likewise; a face has the label of most of its
        vertices, else the least one.
    deviation : float or str, default '0'
        How far from its boundary a curve may be, anywhere: a length in the unit of the mesh, or in mean edges of it, as
        1.5 edges. 0: one mean edge, and no more than the jags of the boundary ask for.
    corner_angle : float in [1, 180], default 60.0
        Where a boundary turns by this and more, in degrees, its curve has a corner; jags alone make none. 180: no
        corners.
    degree : int in [2, 4], default 3
        Polynomial degree of the spline.
    tension : float in [0, 1], default 0.0
        From 0 (as smooth as possible) to 1 (as straight as possible: geodesics between the picks). No unit.
    samples : int ≥ 0, default 256
        At least this many vertices at even steps of the spline's parameter, besides those where the curve crosses mesh
        edges and the picks. 0: none.
    max_segment_length : float ≥ 0, default 0.0
        No segment of the polyline is longer than this, in the unit of the mesh. 0: not limited.
    distance_tolerance : float > 0, default 0.1
        Largest distance of the spline to the surface, in mean edge lengths; edges shorter than a hundredth of the
        square root of the surface's area count as that long. The polyline lies on the surface in any case.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "fit_curve_to_selection_boundary",
        {
            "surface_layer": surface_layer,
            "boundaries": boundaries,
            "deviation": deviation,
            "corner_angle": corner_angle,
            "degree": degree,
            "tension": tension,
            "samples": samples,
            "max_segment_length": max_segment_length,
            "distance_tolerance": distance_tolerance,
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )


def edit_curve_on_surface(
    self: pymeshlab.MeshSet,
    *,
    surface_layer: int | None = None,
    curve_layer: int | None = None,
    edit: Edit = "join",
    at: str = "0.25, 0.75",
    extension: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    ends: Ends = "end",
    smooth: bool = False,
    max_distance: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    gap: float | str = "1 edges",
    blend: float | str = "3 edges",
    direction: str = "",
    project_curves: bool = False,
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> dict[str, Any]:
    """Joins curves, cuts them, turns them round, or makes them longer.

    Joins curves, cuts them, turns them round, or makes them longer, along the surface. Each result is a new layer with
    a curve like others, whose spline is the same one where nothing was added; the layers that it is made of are hidden.
    It is no longer one that is drawn through its picks: to draw it again, change the curves that it is made of.

    Parameters
    ----------
    surface_layer : int, optional
        The layer with the triangle mesh. Default: the current layer. If that has no faces, or is the tube of a curve:
        the layer that it was drawn on, else the only other layer with faces.
    curve_layer : int, optional
        A layer of polylines: edges without faces. The surface itself (default) stands for its visible curves, and for
        visible polylines near it that belong to no other layer. Results of filters (offsets, patterns) are taken where
        they are chosen here, or where no such curve is visible; else, curves of other surfaces that are near. In
        MeshLab's window the current layer is chosen if it is a curve.
    edit : {'join', 'split', 'trim', 'extend', 'reverse'}, default 'join'
        What is done with the curves. join: all curves become one, each joined to those before by the ends that are
        nearest; it goes the way of the first; split: the parts between parameters, each a curve of its own; trim: the
        part between two parameters; extend: goes on along the surface, as straight as that lets it, or to the boundary;
        reverse: from the end to the start.
    at : str, default '0.25, 0.75'
        Parameters t in [0, 1], with commas between them; two for trim. Of a closed curve that is trimmed the first may
        be larger: the part leads over the curve's start then. Only with edit split or trim.
    extension : float ≥ 0, default 0.0
        By how much a curve becomes longer, at each end that is meant. 0: 2 % of the diagonal. Only with edit extend.
    ends : {'end', 'start', 'both'}, default 'end'
        Where a curve becomes longer. end: behind its last point; start: before its first point; both: at either end.
        Only with edit extend.
    smooth : bool, default False
        Curves meet with one direction; else at corners. Only with edit join.
    max_distance : float ≥ 0, default 0.0
        Polylines are projected onto the mesh; one that is farther away anywhere is refused. Curves that this plugin
        drew on the surface know their faces and are taken exactly. 0: 1 % of the diagonal, along a direction any
        distance.
    gap : float or str, default '1 edges'
        How far apart the ends that are joined may be: a length in the unit of the mesh, or in mean edges of it, as 1.5
        edges. A curve through both bridges the gap. Only with edit join.
    blend : float or str, default '3 edges'
        Of a smooth joint: how much of either curve, but at most a third of it, gives way to it, likewise. Not used
        where the curves meet with one direction already. Only with edit join.
    direction : str, optional
        "x y z": polylines are draped: each of their points is moved along this direction to the first face that is met
        there, coming from outside, however far away. A warning tells where a line jumps, and where it is parted since
        it is beside the mesh. Empty: to the nearest point.
    project_curves : bool, default False
        Projects also curves that know their faces, as for a mesh that changed since they were drawn, which is refused
        otherwise.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "edit_curve_on_surface",
        {
            "surface_layer": surface_layer,
            "curve_layer": curve_layer,
            "edit": edit,
            "at": at,
            "extension": extension,
            "ends": ends,
            "smooth": smooth,
            "max_distance": max_distance,
            "gap": gap,
            "blend": blend,
            "direction": direction,
            "project_curves": project_curves,
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )


def points_on_curve(
    self: pymeshlab.MeshSet,
    *,
    surface_layer: int | None = None,
    curve_layer: int | None = None,
    count: int = 20,
    distances: str = "",
    at_picks: bool = False,
    max_distance: float | pymeshlab.PercentageValue | pymeshlab.PureValue = 0.0,
    direction: str = "",
    project_curves: bool = False,
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> dict[str, Any]:
    """Places points along curves, at equal distances, at chosen ones or at the picks.

    Places points along curves, on the surface: semilandmarks of morphometrics, drill holes, poses of a tool. They are
    one new layer, in the order of the curves, which is a layer of picks as well. A point has its distance along the
    curve as quality and the surface's normal, at right angles to the curve, as its own. Attributes of vertices hold the
    rest: curve (from 0), distance, tangent, left (to the left of the curve, seen with the normal upwards), curvature (1
    / radius), normal_curvature, geodesic_curvature, face_index and barycentric. Curvatures are those of the spline
    where this plugin drew the curve, else of a parabola through three points, 1 % of the length apart.

    Parameters
    ----------
    surface_layer : int, optional
        The layer with the triangle mesh. Default: the current layer. If that has no faces, or is the tube of a curve:
        the layer that it was drawn on, else the only other layer with faces.
    curve_layer : int, optional
        A layer of polylines: edges without faces. The surface itself (default) stands for its visible curves, and for
        visible polylines near it that belong to no other layer. Results of filters (offsets, patterns) are taken where
        they are chosen here, or where no such curve is visible; else, curves of other surfaces that are near. In
        MeshLab's window the current layer is chosen if it is a curve.
    count : int in [1, 1e+07], default 20
        Of each curve, at equal distances along it: those of an open one with both ends, those of a closed one from its
        start on.
    distances : str, optional
        In place of a number: distances of the points along each curve from its start, in the unit of the mesh, with
        commas between them. A closed curve begins anew after its length.
    at_picks : bool, default False
        In place of a number: the points where the picks of the curves are. The layers must be curves of this plugin.
    max_distance : float ≥ 0, default 0.0
        Polylines are projected onto the mesh; one that is farther away anywhere is refused. Curves that this plugin
        drew on the surface know their faces and are taken exactly. 0: 1 % of the diagonal, along a direction any
        distance.
    direction : str, optional
        "x y z": polylines are draped: each of their points is moved along this direction to the first face that is met
        there, coming from outside, however far away. A warning tells where a line jumps, and where it is parted since
        it is beside the mesh. Empty: to the nearest point.
    project_curves : bool, default False
        Projects also curves that know their faces, as for a mesh that changed since they were drawn, which is refused
        otherwise.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "points_on_curve",
        {
            "surface_layer": surface_layer,
            "curve_layer": curve_layer,
            "count": count,
            "distances": distances,
            "at_picks": at_picks,
            "max_distance": max_distance,
            "direction": direction,
            "project_curves": project_curves,
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )


def fill_holes(
    self: pymeshlab.MeshSet,
    *,
    surface_layer: int | None = None,
    shape: Shape = "smooth",
    max_length: float = 0.0,
    max_edges: int = 0,
    seed: str = "",
    strict: bool = False,
    weld: float = 0.0,
    slits: bool = False,
) -> dict[str, Any]:
    """Closes the holes that a mesh has, smooth or flat, on a copy of it.

    Closes the holes that a mesh has, all or some, on a copy of it, a new layer. No new face crosses another one or the
    mesh; where a rim allows no such patch, a warning names the faces. Vertices and faces of the mesh come first, as
    they are. Colours, qualities and texture coordinates of the patches go on smoothly from their rims. The outer
    boundary of an open mesh is a hole as well.

    Parameters
    ----------
    surface_layer : int, optional
        The layer with the triangle mesh. Default: the current layer. If that has no faces, or is the tube of a curve:
        the layer that it was drawn on, else the only other layer with faces.
    shape : {'smooth', 'flat'}, default 'smooth'
        How holes are closed. smooth: as dense as around, with its tangent planes; flat: a triangulation that bends
        least; with new vertices only where it would cross the mesh.
    max_length : float ≥ 0, default 0.0
        Leaves holes open whose rim is longer than this, in the unit of the mesh. 0: none.
    max_edges : int ≥ 0, default 0
        Leaves holes open whose rim has more edges than this. 0: none.
    seed : str, optional
        "x y z" in world coordinates: closes the hole alone whose rim comes nearest to this point. Empty: all holes.
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
    dict
        Figures, by name.

    Raises
    ------
    pymeshlab.PyMeshLabException
        The filter refuses something, or fails; the message says why.
    """
    return apply(
        self,
        "fill_holes",
        {
            "surface_layer": surface_layer,
            "shape": shape,
            "max_length": max_length,
            "max_edges": max_edges,
            "seed": seed,
            "strict": strict,
            "weld": weld,
            "slits": slits,
        },
    )


def bind() -> None:
    """Makes them methods of pymeshlab.MeshSet."""
    pymeshlab.MeshSet.generate_bspline_curve_on_surface = generate_bspline_curve_on_surface
    pymeshlab.MeshSet.compute_scalar_field_for_curves_per_vertex = compute_scalar_field_for_curves_per_vertex
    pymeshlab.MeshSet.imprint_curves = imprint_curves
    pymeshlab.MeshSet.cut_along_curves = cut_along_curves
    pymeshlab.MeshSet.segment_by_curves = segment_by_curves
    pymeshlab.MeshSet.offset_curve_on_surface = offset_curve_on_surface
    pymeshlab.MeshSet.pattern_on_surface = pattern_on_surface
    pymeshlab.MeshSet.fit_curve_to_selection_boundary = fit_curve_to_selection_boundary
    pymeshlab.MeshSet.edit_curve_on_surface = edit_curve_on_surface
    pymeshlab.MeshSet.points_on_curve = points_on_curve
    pymeshlab.MeshSet.fill_holes = fill_holes
