# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh that curves are drawn on."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple, get_args

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Int32s, Picks, face_ids, finite_points, of_core, per_vertex, pick_points
from ._curve import Curve, Drawing
from ._errors import FieldError, InputError, warn
from ._imprint import SNAP, Cut, Fill, Imprint, Keep
from ._inputs import mesh_arrays
from ._keywords import CURVE, FIELD, SHELL, Kind, MeshKeywords
from ._options import Progress, Value, changed, checked_number
from ._pattern import Pattern, Planar, drawn


class Projection(NamedTuple):
    """Closest points of a mesh, one for each query."""

    points: Floats  # (n, 3)
    faces: Int32s  # (n,)
    barycentrics: Floats  # (n, 3)
    distances: Floats  # (n,)


class Layer(NamedTuple):
    """A triangle mesh as arrays."""

    vertices: Floats  # (n, 3)
    faces: Int32s  # (m, 3)


class Shell(NamedTuple):
    """Top and bottom of a shell, both oriented as the mesh is."""

    top: Layer
    bottom: Layer


class Repair(NamedTuple):
    """A mended mesh, and what was changed."""

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
    """

    __slots__ = ("_core", "_fields", "_made", "_options")

    vertices: Floats = of_core("vertices")
    faces: Int32s = of_core("faces")
    diagonal: float = of_core("diagonal")
    components: int = of_core("components")
    mending: str = of_core("mending")

    _options: dict[str, Value]
    _fields: dict[str, _core.Field]  # with default options, by their kinds
    _made: deque[_core.Field]  # the last ones; not kept where each vertex has one value only

    def _prepare(
        self, vertices: Any, faces: npt.ArrayLike | None, options: Mapping[str, object], progress: Progress | None
    ) -> None:
        self._options = changed(SHELL, options)
        self._fields, self._made = {}, deque(maxlen=8)
        self._core = _core.Mesh(*mesh_arrays(vertices, faces), self._options, progress)
        warn(self._core.notes, 3)

    def project(self, points: npt.ArrayLike) -> Projection:
        """Find the closest point of the mesh for each point, (n, 3) and finite. O(log m) each."""
        places, positions, distances = self._core.project(finite_points(points, "points", InputError, ""))
        return Projection(positions, *places, distances)

    def shell(self) -> Shell:
        """Build the shell that curves are sought in, where it is not there yet, and return its top and bottom."""
        top, bottom = self._core.shell_layers()
        return Shell(Layer(*top), Layer(*bottom))

    def imprint(self, curves: Iterable[Curve], snap: float = 1e-9) -> Imprint:
        """Make curves edges of a copy of the mesh, which is mended where it had to be for curves.

        Parameters
        ----------
        curves : curves of this mesh
            They may cross themselves and each other, and run along edges and through vertices; their order does not matter.
        snap : float in [0, 0.01], default 1e-9
            Points that are nearer are taken as one: relative to the altitudes of a face, on an edge to its length.

        Returns
        -------
        Imprint

        Raises
        ------
        InputError
            A curve is of another mesh, or passes from sheet to sheet in more ways than can be joined at once.
        OptionError
            `snap` is not in its range.
        """
        given = list(curves)
        for i, curve in enumerate(given):
            if curve.mesh is not self:
                raise InputError(f"curves[{i}] is of another mesh")
        return Imprint(_core.imprint(self._core, [curve._core for curve in given], checked_number("snap", SNAP, snap)))

    def cut(
        self,
        curves: Iterable[Curve],
        keep: Keep | None = None,
        fill: Fill = "none",
        snap: float = 1e-9,
        progress: Progress | None = None,
        drop_untouched: bool = False,
    ) -> Cut:
        """Open a copy of the mesh along curves: imprint(curves, snap).cut(keep, fill, progress, drop_untouched)."""
        return self.imprint(curves, snap)._cut(keep, fill, progress, drop_untouched)

    def segment(self, curves: Iterable[Curve], snap: float = 1e-9) -> Imprint:
        """Label the parts that curves leave: an imprint whose `labels` and `parts` are more than those of the mesh.

        A MeshWarning says which curves part nothing while others do.

        Parameters
        ----------
        curves, snap
            As of imprint().

        Returns
        -------
        Imprint
            `labels` has the part of each of its faces, `parts` their figures.

        Raises
        ------
        InputError
            The curves part nothing (a PickError), or as imprint() does.
        """
        imprint = self.imprint(curves, snap)
        warn(imprint._core.segment_notes, 2)
        return imprint

    def pattern(
        self,
        drawing: Planar,
        centre: npt.ArrayLike | None = None,
        along: Curve | None = None,
        *,
        up: npt.ArrayLike | None = None,
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
        drawing : file name, str or sequence of (n, 2) arrays
            A file .svg or .dxf, path data of SVG ("M0 0 L1 1"), or polylines, y upwards; one that ends where it begins is closed.
        centre : (3,) array of float
            Carry the drawing round this point: its middle comes to lie there, and other points at the ends of straightest
            geodesics of their distances (exponential map).
        along : Curve
            In place of `centre`: the drawing's x axis runs along this curve, its y axis to the left of it, seen with the
            surface's normal upwards.
        up : (3,) array of float, default None
            Direction in space that the drawing's up follows at the centre; None: the y axis, or z where the surface faces
            along y.
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
        """
        options = {"size": size, "scale": scale, "repeat": repeat, "spacing": spacing, "start": start, "shift": shift}
        options |= {"corner_angle": corner_angle, "tolerance": tolerance, "smoothing": smoothing}
        return drawn(self, drawing, centre, along, up, options, progress)

    def _make_field(
        self,
        quality: npt.ArrayLike | None,
        region: npt.ArrayLike | None,
        options: Mapping[str, object],
        progress: Progress | None,
    ) -> Floats:
        chosen = changed(FIELD, options)
        kind = chosen.get("kind", FIELD["kind"].default)
        for name, array, needing in (("quality", quality, "quality"), ("region", region, "obstacle")):
            if kind == needing and array is None:
                raise FieldError(f"kind is {kind!r}, which needs {name}")
        values = None if quality is None else per_vertex(quality, "quality", len(self.vertices))
        faces = None if region is None else face_ids(region, "region", len(self.faces))
        made = self._core.field(chosen, values, faces, progress)
        if self.mending:
            self._made.append(made)
        return made.values.copy()

    def _kept_field(self, kind: str, progress: Progress | None) -> _core.Field:
        """A field with default options, computed once."""
        if kind not in self._fields:
            allowed = get_args(Kind)
            if kind not in allowed:
                raise FieldError(
                    f"field is {kind!r}, but must be one of {', '.join(map(repr, allowed))}, or a value for each vertex"
                )
            self._fields[kind] = self._core.field({"kind": kind}, None, None, progress)
        return self._fields[kind]

    def _draw(
        self,
        picks: Picks,
        options: Mapping[str, object],
        field: str | npt.ArrayLike | None,
        avoid: npt.ArrayLike | None,
        progress: Progress | None,
    ) -> Curve:
        return self._drawing(pick_points(picks, self), options, field, avoid).draw(None, progress)

    def _drawing(
        self, picks: Floats, options: Mapping[str, object], field: str | npt.ArrayLike | None, avoid: npt.ArrayLike | None
    ) -> Drawing:
        return Drawing(
            mesh=self,
            picks=picks,
            options=changed(CURVE, options),
            field=self._field_of(field),
            avoid=None if avoid is None else face_ids(avoid, "avoid", len(self.faces)),
        )

    def _field_of(self, given: str | npt.ArrayLike | None) -> str | _core.Field | None:
        """A kind as it is; values as a field: what field() returned as it was made, also where mending doubled vertices."""
        if isinstance(given, str) or given is None:
            return given
        values = per_vertex(given, "field", len(self.vertices))
        return next((made for made in tuple(self._made) if np.array_equal(made.values, values)), None) or _core.Field(values)

    def __repr__(self) -> str:
        parts = f", {self.components} components" if self.components > 1 else ""
        return f"<bspline_curve.Mesh: {len(self.vertices)} vertices, {len(self.faces)} faces{parts}>"

    def __reduce__(self) -> tuple[object, ...]:
        return _restored, (self.vertices, self.faces, self._options)


def _restored(vertices: Floats, faces: Int32s, options: dict[str, Any]) -> Mesh:
    return Mesh(vertices, faces, **options)


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
    """
    mending = changed(SHELL, {"weld": options.pop("weld", 0.0), "slits": options.get("slits", False)})
    mended, corners, changes, summary = _core.repaired(*mesh_arrays(vertices, faces), mending)
    return Repair(Mesh(mended, corners, **options), changes, summary)
