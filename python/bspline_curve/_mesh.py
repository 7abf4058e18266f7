# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh that curves are drawn on."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, get_args

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Int32s, Picks, face_ids, file_name, finite_points, of_core, per_vertex, pick_points
from ._curve import Curve, drawn
from ._drawing import THRESHOLDS, Drawing
from ._errors import FieldError, InputError, OptionError, warn
from ._fit import allowed, curve_along, curves_round
from ._identity import remember
from ._imprint import SNAP, STROKE, Cut, Fill, Imprint, Keep, with_holes_filled
from ._inputs import mesh_arrays
from ._keywords import CURVE, FIELD, SHELL, Avoid, Field, MeshKeywords
from ._lines import Line, Placing, curves_on
from ._options import Progress, Value, changed, checked_number, part_of
from ._pattern import Pattern, Planar, carried_drawing, patterned
from ._ways import Places, distances_to, way_between

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import MeshOptions


class Projection(NamedTuple):
    """Closest points of a mesh, one row for each query.

    Attributes
    ----------
    points : (n, 3) array of float
        On the mesh, in its unit.
    faces : (n,) array of int
        A face that holds the point.
    barycentrics : (n, 3) array of float
        Where it is in that face: weights of the face's vertices, in their order.
    distances : (n,) array of float
        From the query, in the unit of the mesh.
    """

    points: Floats
    faces: Int32s
    barycentrics: Floats
    distances: Floats


class Layer(NamedTuple):
    """A triangle mesh as arrays.

    Attributes
    ----------
    vertices : (n, 3) array of float
    faces : (m, 3) array of int
        Ids of vertices.
    """

    vertices: Floats
    faces: Int32s


class Shell(NamedTuple):
    """Top and bottom of a shell, both oriented as the mesh is.

    Attributes
    ----------
    top : Layer
        Outside of the mesh, where its normals point.
    bottom : Layer
        Inside.
    """

    top: Layer
    bottom: Layer


class Repair(NamedTuple):
    """A mended mesh, and what was changed.

    Attributes
    ----------
    mesh : Mesh
    changes : dict
        Ids of what was changed, by kinds: "joined_vertices", "merged_vertices" (vertex: the one that it became),
        "left_out_faces", "removed_degenerate_faces", "removed_duplicate_faces", "reversed_faces", "split_faces" (lists),
        "cut_edges" (pairs of vertices), "duplicated_vertices" (vertex: its copies).
    summary : str
        The same in words: "2 duplicate faces removed"; empty where nothing was changed.
    """

    mesh: Mesh
    changes: dict[str, Any]
    summary: str


class Mesh(MeshKeywords):
    """A validated triangle mesh, prepared for curves; it does not change. Several threads may draw on it at once.

    Attributes
    ----------
    vertices : (n, 3) array of float, read-only
    faces : (m, 3) array of int, read-only
    diagonal : float
        Of the box of the mesh.
    components : int
        Connected parts.
    mending : str
        What was mended so that the mesh can be drawn on; empty where nothing was.
    quality : (n,) array of float, read-only, or None
        A value for each vertex, as it was given or read.
    checksum : str
        The CRC-32 of coordinates, rounded to single precision, and faces, as files name it. Curves of one mesh are taken on
        every other with as many vertices and faces and the same checksum, also in another process.
    """

    __slots__ = ("_core", "_fields", "_made", "_options", "_quality")

    vertices: Floats = of_core("vertices")
    faces: Int32s = of_core("faces")
    diagonal: float = of_core("diagonal")
    components: int = of_core("components")
    mending: str = of_core("mending")

    _options: dict[str, Value]
    _quality: Floats | None
    _fields: deque[tuple[dict[str, Value], object, _core.Field]]  # the last that curves followed: options, array, field
    _made: deque[_core.Field]  # the last ones that field() returned; not kept where each vertex has one value only

    def _prepare(
        self,
        vertices: Any,
        faces: npt.ArrayLike | None,
        options: Mapping[str, object],
        quality: npt.ArrayLike | None,
        progress: Progress | None,
    ) -> None:
        self._options = changed(SHELL, options)
        self._fields, self._made = deque(maxlen=16), deque(maxlen=8)
        self._core = _core.Mesh(*mesh_arrays(vertices, faces), self._options, progress)
        self._quality = None if quality is None else per_vertex(quality, "quality", len(self.vertices)).copy()
        if self._quality is not None:
            self._quality.flags.writeable = False
        remember(self)
        warn(self._core.notes, 3)

    @classmethod
    def load(cls, file: str | os.PathLike[str], **options: Unpack[MeshOptions]) -> Mesh:
        """Read a mesh from a file, and prepare it.

        Parameters
        ----------
        file : str or path
            .ply (with the quality of its vertices), .obj, .off or .stl, whose vertices at one place become one. Polygons are cut
            into triangles.
        **options
            Those of Mesh.

        Returns
        -------
        Mesh

        Raises
        ------
        FileError
            The file cannot be read; the message names the place in it.
        InputError
            As Mesh() raises it.

        Examples
        --------
        >>> import meshio
        >>> meshio.Mesh(mesh.vertices, [("triangle", mesh.faces)]).write("part.ply")
        >>> bspline_curve.Mesh.load("part.ply")
        <bspline_curve.Mesh: 1681 vertices, 3200 faces>
        """
        given: dict[str, Any] = dict(options)
        _check_options("Mesh.load", given)
        vertices, faces, quality = _core.read_mesh(file_name(file))
        given.setdefault("quality", quality if len(quality) and np.isfinite(quality).all() else None)
        return cls(vertices, faces, **given)

    @property
    def quality(self) -> Floats | None:
        return self._quality

    @property
    def checksum(self) -> str:
        return f"{self._core.checksum:08x}"

    def project(self, points: npt.ArrayLike) -> Projection:
        """Find the closest point of the mesh for each point, (n, 3) and finite. O(log m) each.

        Examples
        --------
        >>> closest = mesh.project([[0.1, 0.2, 1.0]])
        >>> closest.points.shape, closest.faces.shape
        ((1, 3), (1,))
        """
        places, positions, distances = self._core.project(finite_points(points, "points", InputError, ""))
        return Projection(positions, *places, distances)

    def shell(self) -> Shell:
        """Build the shell that curves are sought in, where it is not there yet, and return its top and bottom.

        Examples
        --------
        >>> mesh.shell().top.vertices.shape[1]
        3
        """
        top, bottom = self._core.shell_layers()
        return Shell(Layer(*top), Layer(*bottom))

    def distance(
        self, to: Places | Curve | Sequence[Curve], reach: float | None = None, progress: Progress | None = None
    ) -> Floats:
        """Measure how far each vertex is along the surface: exact geodesic distances.

        Parameters
        ----------
        to : (p, 3) array of float, p pairs (face, barycentrics), Curve, or a list of Curve
            The distance is to the nearest of these. Points are taken to the closest ones of the mesh.
        reach : float > 0, default None
            Stop there: what is farther away is infinitely far; None: everywhere.
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.

        Returns
        -------
        (n,) array of float
            In the unit of the mesh, with relative errors of about 1e-9; infinite where no way leads. Takes about half a second
            for 30,000 faces within reach and five for 150,000.

        Raises
        ------
        InputError
            A point is farther from the mesh than 1 % of its diagonal, or a curve is of another mesh.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> mesh.distance(picks[:1]).shape
        (1681,)
        >>> far = mesh.distance(curve, reach=0.2) == np.inf
        """
        return distances_to(self, to, reach, progress)

    def path(self, start: npt.ArrayLike | tuple[int, Any], end: npt.ArrayLike | tuple[int, Any]) -> Curve:
        """Find the shortest path between two points along the surface.

        Parameters
        ----------
        start, end : (3,) array of float, or a pair (face, barycentrics)

        Returns
        -------
        Curve
            Of degree 1: its polyline is the path, and t the length along it, from 0 to 1. It is the shortest one up to rounding;
            where a search of about half a second cannot tell, a geodesic that is longer by less than 4 %.

        Raises
        ------
        InputError
            A point is farther from the mesh than 1 % of its diagonal, both are one, or no way leads from one to the other.

        Examples
        --------
        >>> path = mesh.path(picks[0], picks[1])
        >>> path.length < curve.length
        True
        """
        return way_between(self, start, end)

    def fit(
        self,
        line: npt.ArrayLike,
        *,
        closed: bool = False,
        direction: npt.ArrayLike | None = None,
        deviation: float | str | None = None,
        corner_angle: float = 60.0,
        degree: int = 3,
        tension: float = 0.0,
        samples: int = 256,
        max_segment_length: float = 0.0,
        progress: Progress | None = None,
    ) -> Curve:
        """Draw a smooth curve along a line that is there already: a stroke, an edge loop, a polyline of a file.

        Parameters
        ----------
        line : (n, 3) array of float
            Points near the mesh, in order, n ≥ 2, or 3 where it is closed.
        closed : bool, default False
            True: the line goes on from its last point to the first. An open curve keeps the ends of its line.
        direction : (3,) array of float, default None
            Drape the line first: move each of its points along this direction to the first face that is met there, coming from
            outside. One that leaves the mesh, seen so, is refused.
        deviation : float or str, default None
            How far from the line the curve may be anywhere: a length in the unit of the mesh, or text like '1edge', in mean edges.
            It is as smooth as it can be where the line is off by about a quarter of that. None: by a mean edge, and no smoother
            than the line's own noise asks for: waves of more than a dozen of its points stay.
        corner_angle : float in [1, 180], default 60.0
            Where the line turns by so many degrees and more, along the surface and by more than its noise explains, the curve has
            a corner. 180: it has none. report["corner_turns"]: by how much, for each.
        degree : int in [2, 4], default 3
        tension : float in [0, 1], default 0.0
        samples : int ≥ 0, default 256
        max_segment_length : float ≥ 0, default 0.0
            All four as of curve().
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.

        Returns
        -------
        Curve
            Its picks are points of it, so that it can be edited like one that was drawn. report["line_distance"]: how far it is
            from the line.

        Raises
        ------
        InputError
            An argument is wrong, or there is no smooth curve so near.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> shaky = curve.points + 0.002 * np.sin(50 * np.arange(len(curve.points)))[:, None]
        >>> smooth = mesh.fit(shaky, deviation=0.02)
        >>> smooth.usable
        True
        """
        options = {"degree": degree, "tension": tension, "samples": samples, "max_segment_length": max_segment_length}
        return curve_along(self, line, closed, direction, allowed(deviation, corner_angle), options, progress)

    def fit_boundary(
        self,
        faces: npt.ArrayLike | None = None,
        *,
        labels: npt.ArrayLike | None = None,
        deviation: float | str | None = None,
        corner_angle: float = 60.0,
        degree: int = 3,
        tension: float = 0.0,
        samples: int = 256,
        max_segment_length: float = 0.0,
        progress: Progress | None = None,
    ) -> list[Curve]:
        """Draw smooth curves along the jagged boundaries of faces, or of the labels of a segmentation.

        Parameters
        ----------
        faces : (k,) array of int or (m,) array of bool, default None
            Their boundaries.
        labels : (m,) array of int, default None
            In place of faces: a label for each face. Each boundary between two labels is drawn once, from junction to junction,
            where curves meet in one point.
        deviation : float or str, default None
            How far from its line a curve may be anywhere: a length in the unit of the mesh, or text like '1edge', in mean edges.
            It is as smooth as it can be where the line is off by about a quarter of that. None: by a mean edge, and no smoother
            than the line's own noise asks for: waves of more than a dozen of its points stay.
        corner_angle : float in [1, 180], default 60.0
            Where the line turns by so many degrees and more, along the surface and by more than its noise explains, the curve has
            a corner. 180: it has none. report["corner_turns"]: by how much, for each.
        degree : int in [2, 4], default 3
        tension : float in [0, 1], default 0.0
        samples : int ≥ 0, default 256
        max_segment_length : float ≥ 0, default 0.0
            All four as of curve().
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.

        Returns
        -------
        list of Curve
            Open ones first.

        Raises
        ------
        InputError
            An argument is wrong, there is no boundary, or no smooth curve so near.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> middles = mesh.vertices[mesh.faces].mean(1)
        >>> [loop.closed for loop in mesh.fit_boundary(np.hypot(*(middles - middles.mean(0))[:, :2].T) < 0.3)]
        [True]
        """
        options = {"degree": degree, "tension": tension, "samples": samples, "max_segment_length": max_segment_length}
        return curves_round(self, faces, labels, allowed(deviation, corner_angle), options, progress)

    def imprint(
        self,
        curves: Line | Iterable[Line],
        snap: float = 1e-9,
        max_distance: float = 0.0,
        stroke: float = 0.0,
        direction: npt.ArrayLike | None = None,
        progress: Progress | None = None,
    ) -> Imprint:
        """Make curves edges of a copy of the mesh, which is mended where it had to be for curves.

        Parameters
        ----------
        curves : Curve, (n, 3) array, BSpline of scipy, or several of these
            They may cross themselves and each other, and run along edges and through vertices; their order does not matter. Those
            of an equal mesh are taken, too. Arrays are polylines, closed where they end as they begin; they and splines are
            projected onto the mesh.
        snap : float in [0, 0.01], default 1e-9
            Points that are nearer are taken as one: relative to the altitudes of a face, on an edge to its length.
        max_distance : float ≥ 0, default 0
            Polylines and splines that are farther from the mesh anywhere are refused, in its unit; 0: 1 % of its diagonal, along
            a direction any distance. A MeshWarning tells where one jumps from one part of the mesh to another.
        stroke : float ≥ 0, default 0
            A width: the lines at half of it beside the curves, round the ends of open ones, become edges, and the parts
            between them are "inside". 0: the curves do.
        direction : (3,) array of float, default None
            Drape polylines and splines: move each of their points along this direction to the first face that is met there,
            coming from outside; None: to the closest point. A MeshWarning tells where one is beside the mesh, and parted there.
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.

        Returns
        -------
        Imprint

        Raises
        ------
        InputError
            A curve is of another mesh or not near to this one, or passes from sheet to sheet in more ways than can be joined at
            once.
        OptionError
            `snap`, `max_distance` or `stroke` is not in its range.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> imprint = mesh.imprint([curve, ring])
        >>> len(imprint.curves), imprint.parts[0].area > imprint.parts[1].area
        (2, True)
        """
        return self._imprinted(curves, snap, Placing(max_distance, direction), progress, stroke)

    def _imprinted(
        self,
        curves: Line | Iterable[Line],
        snap: float,
        placing: Placing,
        progress: Progress | None = None,
        stroke: float = 0.0,
    ) -> Imprint:
        placed = curves_on(self, curves, placing)
        warn(placed.notes, 3)
        given = [curve._core for curve in placed.curves]
        width = checked_number("stroke", STROKE, stroke)
        return Imprint(_core.imprint(self._core, given, checked_number("snap", SNAP, snap), width, progress))

    def cut(
        self,
        curves: Line | Iterable[Line],
        keep: Keep | None = None,
        fill: Fill = "none",
        snap: float = 1e-9,
        progress: Progress | None = None,
        drop_untouched: bool = False,
        max_distance: float = 0.0,
        direction: npt.ArrayLike | None = None,
    ) -> Cut:
        """Open a copy of the mesh along curves: imprint(curves, snap, max_distance, direction=direction).cut(keep, fill, progress,
        drop_untouched).

        Examples
        --------
        >>> cut = mesh.cut(ring, keep="inside")
        >>> cut.vertices.shape[1], cut.labels.min() == cut.labels.max()
        (3, np.True_)
        """
        imprint = self._imprinted(curves, snap, Placing(max_distance, direction), part_of(progress, 0.0, 0.3))
        return imprint._cut(keep, fill, part_of(progress, 0.3, 1.0), drop_untouched)

    def fill_holes(
        self,
        shape: Literal["smooth", "flat"] = "smooth",
        max_length: float | None = None,
        max_edges: int | None = None,
        seed: npt.ArrayLike | None = None,
        progress: Progress | None = None,
    ) -> Cut:
        """Close holes of a copy of the mesh, which is mended where it had to be for curves. No new face crosses another one.

        The outer boundary of an open mesh is a hole like the others. A MeshWarning says how many holes stay open, and which new
        faces cross others, where a rim allows no fill that does not.

        Parameters
        ----------
        shape : {"smooth", "flat"}, default "smooth"
            Patches as dense as around, with the tangent planes at their rims, or triangulations of these that bend least.
        max_length : float > 0, optional
            Holes whose rim is longer stay open; in the unit of the mesh.
        max_edges : int ≥ 3, optional
            Holes whose rim has more edges stay open.
        seed : (3,) array of float, optional
            Close the hole alone whose rim has the vertex nearest to this point.
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.

        Returns
        -------
        Cut
            The whole mesh; new faces are the last ones, with the label -1.

        Raises
        ------
        InputError
            The mesh has no such hole (a PickError), or one cannot be filled.
        OptionError
            `shape`, `max_length` or `max_edges` is none of these.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> closed = mesh.fill_holes("flat")
        >>> bool((closed.labels == -1).any())
        True
        """
        return with_holes_filled(self._core, shape, max_length, max_edges, seed, progress)

    def segment(
        self,
        curves: Line | Iterable[Line],
        snap: float = 1e-9,
        max_distance: float = 0.0,
        direction: npt.ArrayLike | None = None,
        progress: Progress | None = None,
    ) -> Imprint:
        """Label the parts that curves leave: an imprint whose `labels` and `parts` are more than those of the mesh.

        A MeshWarning says which curves part nothing while others do.

        Parameters
        ----------
        curves, snap, max_distance, direction, progress
            As of imprint().

        Returns
        -------
        Imprint
            `labels` has the part of each of its faces, `parts` their figures.

        Raises
        ------
        InputError
            The curves part nothing (a PickError), or as imprint() does.

        Examples
        --------
        >>> regions = mesh.segment(ring)
        >>> sorted(set(regions.labels.tolist()))
        [0, 1]
        """
        imprint = self._imprinted(curves, snap, Placing(max_distance, direction), progress)
        warn(imprint._core.segment_notes, 2)
        return imprint

    def pattern(
        self,
        drawing: Planar | None = None,
        centre: npt.ArrayLike | None = None,
        along: Line | None = None,
        *,
        text: str = "",
        font: str | os.PathLike[str] = "",
        up: npt.ArrayLike | None = None,
        layers: Sequence[str] = (),
        size: float = 0.0,
        scale: float = 0.0,
        repeat: int = 0,
        spacing: float = 0.0,
        start: float = 0.0,
        shift: float = 0.0,
        corner_angle: float = 20.0,
        tolerance: float = 0.0,
        smoothing: int = 0,
        progress: Progress | None = None,
    ) -> Pattern:
        """Carry a planar drawing to the mesh, each path as curves through picks of its own.

        Parameters
        ----------
        drawing : file name, str or sequence of (n, 2) arrays, default None
            A file .svg or .dxf, path data of SVG ("M0 0 L1 1"), or polylines, y upwards; one that ends where it begins is closed.
            None: `text` is carried.
        centre : (3,) array of float
            Carry the drawing round this point: its middle comes to lie there, and other points at the ends of straightest
            geodesics of their distances (exponential map).
        along : Curve, (n, 3) array or BSpline of scipy
            In place of `centre`: the drawing's x axis runs along this curve, its y axis to the left of it, seen with the
            surface's normal upwards.
        text : str, default ""
            A line of text in place of `drawing`, as outlines of the letters of `font`: one unit is the font's em, and the
            letters stand on the curve. Needs fontTools: pip install fonttools.
        font : file name, default ""
            A font .ttf or .otf; "": a plain one of this system.
        up : (3,) array of float, default None
            Direction in space that the drawing's up follows at the centre; None: the y axis, or z where the surface faces
            along y.
        layers : sequence of str, default ()
            The layers of a .dxf to read, also where they are off; (): all that are not off or frozen.
        size : float ≥ 0, default 0
            Longer side of the drawing, in the unit of the mesh; 0: as `scale` says; if that is 0 as well, 10 % of the
            diagonal, or along a curve so that copies touch.
        scale : float ≥ 0, default 0
            Units of the mesh for one of the drawing.
        repeat : int ≥ 0, default 0
            Copies along the curve, evenly spaced; 0: as many as `spacing` says, or one.
        spacing : float ≥ 0, default 0
            Length of the curve from one copy to the next; on a closed curve the nearest that divides its length.
        start : float ≥ 0, default 0
            Length of the curve before the first copy.
        shift : float, default 0
            Moves the drawing to the left of the curve.
        corner_angle : float in (0, 179], default 20
            Paths are parted into curves where they turn by more than this, in degrees.
        tolerance : float ≥ 0, default 0
            Largest distance of the curves to the carried drawing; 0: 0.1 % of the mean size of its paths.
        smoothing : int in [0, 1000], default 0
            Smooth a copy of the mesh along its normals this often, and find the ways of the drawing on it: evens patterns
            on rough scans.
        progress : callable, default None
            Called with a fraction and a stage; returning False cancels.

        Returns
        -------
        Pattern

        Raises
        ------
        InputError
            A path leads over the boundary or an end of the curve (the message names it), or an argument is wrong.
        FileError
            The file cannot be read.

        Examples
        --------
        >>> pattern = mesh.pattern("M0 0 L1 0 L1 1 Z", centre=[0, 0, 0], size=0.2)
        >>> len(pattern.curves)
        3
        """
        options = {"size": size, "scale": scale, "repeat": repeat, "spacing": spacing, "start": start, "shift": shift}
        options |= {"corner_angle": corner_angle, "tolerance": tolerance, "smoothing": smoothing}
        carried = carried_drawing(drawing, layers, text, font)
        return patterned(self, carried, centre, along, up, options, progress)

    def _make_field(
        self,
        quality: npt.ArrayLike | None,
        region: npt.ArrayLike | None,
        options: Mapping[str, object],
        progress: Progress | None,
    ) -> Floats:
        chosen = changed(FIELD, options)
        kind = chosen.get("kind", FIELD["kind"].default)
        quality = self._quality if quality is None else quality
        for name, array, needing in (("quality", quality, "quality"), ("region", region, "obstacle")):
            if kind == needing and array is None:
                raise FieldError(f"kind is {kind!r}, which needs {name}")
        values = None if quality is None else per_vertex(quality, "quality", len(self.vertices))
        faces = None if region is None else face_ids(region, "region", len(self.faces))
        made = self._core.field(chosen, values, faces, progress)
        if self.mending:
            self._made.append(made)
        return made.values.copy()

    def _chosen_field(
        self, options: dict[str, Value], quality: Floats | None, region: Int32s | None, progress: Progress | None
    ) -> _core.Field:
        """The field that a curve follows: computed once, since a drag asks for it again and again."""
        kind = options["kind"]
        array = quality if kind == "quality" else region if kind == "obstacle" else None
        known = self._known_field(options, array)
        if known is None:
            known = self._core.field(options, quality, region, progress)
            self._fields.append((options, array, known))
        return known

    def _known_field(self, options: dict[str, Value], array: object = None) -> _core.Field | None:
        return next((field for asked, of, field in tuple(self._fields) if asked == options and of is array), None)

    def _draw(
        self, picks: Picks, options: Mapping[str, object], guides: Mapping[str, Any], progress: Progress | None
    ) -> Curve:
        return drawn(self._drawing(pick_points(picks, self), options, guides), None, progress)

    def _drawing(self, picks: Floats, options: Mapping[str, object], guides: Mapping[str, Any]) -> Drawing:
        return Drawing(self, picks, changed(CURVE, options), **self._guides(**guides))

    def _guides(self, **given: Any) -> dict[str, Any]:
        """What draws a curve besides its picks, as a Drawing has it; of that what is given."""
        found: dict[str, Any] = {}
        if "quality" in given:
            quality = given["quality"]
            found["quality"] = self._quality if quality is None else per_vertex(quality, "quality", len(self.vertices))
        if "field_region" in given:
            region = given["field_region"]
            found["region"] = None if region is None else face_ids(region, "field_region", len(self.faces))
        if "field" in given:
            found["field"] = self._field_of(given["field"])
        if "avoid" in given:
            found["avoid"] = self._avoided(given["avoid"])
        return found

    def _avoided(self, given: Any) -> str | Int32s | None:
        if isinstance(given, str):
            if given not in get_args(Avoid):
                raise OptionError(
                    f"avoid is {given!r}, but must be one of {', '.join(map(repr, get_args(Avoid)))}, ids of faces, or a bool for "
                    "each face", "bad-option",
                )  # fmt: skip
            return given if given in THRESHOLDS else None
        return None if given is None else face_ids(given, "avoid", len(self.faces))

    def _field_of(self, given: str | npt.ArrayLike | None) -> str | _core.Field | None:
        """A kind as it is; values as a field: what field() returned as it was made, also where mending doubled vertices."""
        if isinstance(given, str):
            kinds = get_args(Field)
            if given not in kinds:
                raise FieldError(
                    f"field is {given!r}, but must be one of {', '.join(map(repr, kinds))}, or a value for each vertex", "bad-field"
                )
            return None if given == "none" else given
        if given is None:
            return None
        values = per_vertex(given, "field", len(self.vertices))
        return next((made for made in tuple(self._made) if np.array_equal(made.values, values)), None) or _core.Field(values)

    def __repr__(self) -> str:
        parts = f", {self.components} components" if self.components > 1 else ""
        return f"<bspline_curve.Mesh: {len(self.vertices)} vertices, {len(self.faces)} faces{parts}>"

    def __reduce__(self) -> tuple[object, ...]:
        return _restored, (self.vertices, self.faces, self._options, self._quality)


def _check_options(call: str, given: dict[str, Any]) -> None:
    known = [*SHELL, "quality", "progress"]
    for name in given:
        if name not in known:
            raise TypeError(f"{call}() has no option {name!r}; it has {', '.join(known)}")


def _restored(vertices: Floats, faces: Int32s, options: dict[str, Any], quality: Floats | None) -> Mesh:
    return Mesh(vertices, faces, quality=quality, **options)


def repair(vertices: Any, faces: npt.ArrayLike | None = None, **options: Any) -> Repair:
    """Make a mesh that can be drawn on of one that cannot, with no more than rounding of its coordinates.

    Removes faces without area and duplicates, parts faces where more than two meet, turns faces alike; joins vertices within
    `weld` diagonals of each other first, if that is given, and both sides of slits unless `slits` leaves them open.

    Parameters
    ----------
    vertices, faces
        As of Mesh.
    **options
        Those of Mesh.

    Returns
    -------
    Repair
        The mesh, and what was changed: ids of the mesh that was given.

    Raises
    ------
    MeshError
        Every face has a coordinate that is not finite, or one names a vertex that is not there.

    Examples
    --------
    >>> repaired = bspline_curve.repair(mesh.vertices, np.concatenate([mesh.faces, mesh.faces[:1]]))
    >>> repaired.summary
    '1 duplicate face removed'
    """
    _check_options("repair", options)
    mending = changed(SHELL, {"weld": options.pop("weld", 0.0), "slits": options.get("slits", False)})
    mended, corners, changes, summary = _core.repaired(*mesh_arrays(vertices, faces), mending)
    return Repair(Mesh(mended, corners, **options), changes, summary)
