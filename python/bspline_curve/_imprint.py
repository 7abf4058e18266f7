# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves as edges of a mesh, and the parts that they leave."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal, NamedTuple, TypeAlias, cast

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Int32s, numbers, of_core
from ._errors import FieldError, InputError, OptionError, warn
from ._options import Option, Progress, checked_number, checked_value, part_of

Keep: TypeAlias = "Literal['largest', 'smallest', 'inside', 'outside'] | Sequence[float] | Sequence[Sequence[float]] | Floats"
Profile: TypeAlias = Literal["step", "ramp", "round"]
Fill: TypeAlias = Literal["none", "flat", "smooth"]

SNAP = Option("double", 1e-9, 0.0, 0.01, False, ())
KEEP = Option("enum", "largest", None, None, False, ("largest", "smallest", "inside", "outside"))
HEIGHT = Option("double", 0.0, None, None, False, ())
FILL = Option("enum", "none", None, None, False, ("none", "flat", "smooth"))
PROFILE = Option("enum", "step", None, None, False, ("step", "ramp", "round"))
STROKE = Option("double", 0.0, 0.0, None, False, ())
SHAPE = Option("enum", "smooth", None, None, False, ("smooth", "flat"))
LENGTH = Option("double", 0.0, 0.0, None, True, ())
EDGES = Option("int", 3, 3, None, False, ())


def parts_meant(name: str, keep: Keep | None) -> tuple[str | None, list[float]]:
    """A word and the coordinates of seeds, as the core takes them; None: all parts."""
    if keep is None or isinstance(keep, str):
        return None if keep is None else cast(str, checked_value(name, KEEP, keep)), []
    seeds = numbers(keep, name)
    if seeds.shape != (3,) and (seeds.ndim != 2 or seeds.shape[1] != 3 or len(seeds) == 0):
        raise InputError(f"{name} has shape {seeds.shape}, but must be a word or have (3,) or (k, 3)", "bad-array")
    return "seed", seeds.ravel().tolist()


def with_holes_filled(
    core: _core.Mesh,
    shape: str,
    max_length: float | None,
    max_edges: int | None,
    seed: npt.ArrayLike | None,
    progress: Progress | None,
) -> Cut:
    """See Mesh.fill_holes()."""
    meant = str(checked_value("shape", SHAPE, shape))
    length = math.inf if max_length is None else float(checked_number("max_length", LENGTH, max_length))
    edges = 2**31 - 1 if max_edges is None else int(checked_number("max_edges", EDGES, max_edges))
    point = [] if seed is None else numbers(seed, "seed").ravel().tolist()
    if len(point) not in (0, 3):
        raise InputError(f"seed has {len(point)} numbers, but must be a point", "bad-array")
    whole = _core.imprint(core, [], SNAP.default, 0.0, part_of(progress, 0.0, 0.3))
    cut, notes = whole.fill_holes(meant, length, edges, point, part_of(progress, 0.3, 1.0))
    warn(notes, 3)
    return Cut(*cut)


class Part(NamedTuple):
    """Faces that are joined across edges which are on no curve.

    Attributes
    ----------
    faces : (k,) array of int
        Ids of faces of the imprint.
    area : float
        In the unit of the mesh, squared.
    perimeter : float
        Length of its rim, which is curves and the mesh's own boundary, in the unit of the mesh.
    centroid : (3,) array of float
        Of its area.
    euler : int
        Euler's number: 1 for a disc, 0 for a ring, 2 for a closed sphere.
    """

    faces: Int32s
    area: float
    perimeter: float
    centroid: Floats
    euler: int


class Cut(NamedTuple):
    """The mesh, or parts of it, opened along its curves: vertices on them are doubled.

    Attributes
    ----------
    vertices : (n, 3) array of float
        Copies come last.
    faces : (m, 3) array of int
        In the order of the imprint; new ones come last.
    origins : (n,) array of int
        The vertex of the imprint that each vertex comes from; -1: it is new, in a filled hole.
    labels : (m,) array of int
        The part of each face, an index into Imprint.parts; -1: it is new.
    """

    vertices: Floats
    faces: Int32s
    origins: Int32s
    labels: Int32s


class Imprint:
    """A mesh with curves as edges; it does not change.

    Attributes
    ----------
    vertices : (n, 3) array of float
        Those of the mesh first, as they were; where the mesh had to be mended, those that mending doubled come next.
    faces : (m, 3) array of int
        Only faces that a curve passes were divided.
    parents : (m,) array of int
        The face of the mesh that each face is part of.
    curves : list of (k,) array of int
        Vertices of each curve in order, joined by edges; a closed one does not repeat the first. Where edges of the mesh lie
        on each other, as along seams of texture coordinates, a vertex is there once on each side, and one of them is named:
        where the curve passes to the other side, its next edge starts at the other one.
    crossings : (k,) array of int
        Vertices where more than two edges of curves meet.
    labels : (m,) array of int
        The part of each face: an index into `parts`.
    parts : list of Part
        From the largest area to the smallest.
    largest_move : float
        How far a point was moved by snapping or rounding, in the unit of the mesh.
    """

    __slots__ = ("_core", "_parts")

    vertices: Floats = of_core("vertices")
    faces: Int32s = of_core("faces")
    parents: Int32s = of_core("parents")
    curves: list[Int32s] = of_core("curves")
    crossings: Int32s = of_core("crossings")
    largest_move: float = of_core("largest_move")
    labels: Int32s = of_core("labels")

    def __init__(self, core: _core.Imprint) -> None:
        self._core = core
        self._parts: list[Part] | None = None

    @property
    def parts(self) -> list[Part]:
        if self._parts is None:
            figures, labels = self._core.figures, self.labels
            self._parts = [
                Part(np.flatnonzero(labels == i).astype(np.int32), area, perimeter, np.array(centroid), euler)
                for i, (area, perimeter, centroid, euler) in enumerate(figures)
            ]
        return self._parts

    def cut(
        self,
        keep: Keep | None = None,
        fill: Fill = "none",
        progress: Progress | None = None,
        drop_untouched: bool = False,
    ) -> Cut:
        """Open the mesh along the curves; an open curve becomes a slit with joined ends. O(m log m).

        A MeshWarning says which curves part nothing, so that nothing comes apart there, how many rims cannot be filled, and
        which new faces cross others, where a rim allows no fill that does not.

        Parameters
        ----------
        keep : "largest", "smallest", "inside", "outside" or (3,) or (k, 3) array of float, default None
            Return one part at the curves, those that an odd ("inside") or an even number of curves parts from the largest, or
            the parts at points; None: all parts.
        fill : {"none", "flat", "smooth"}, default "none"
            Fill the holes that the other parts leave: with a triangulation that bends least, which has new vertices only
            where it would cross the mesh, or as dense as around, with its tangent planes. Needs `keep`.
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.
        drop_untouched : bool, default False
            Components that no curve parts stay with `keep`, unless they are dropped here; a point keeps one then.

        Returns
        -------
        Cut

        Raises
        ------
        InputError
            The curves open nothing or, with `keep`, part nothing (a PickError), or no part or two are at the point.
        OptionError
            `keep` or `fill` is none of these, or `fill` is there without `keep`.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> opened = mesh.imprint(ring).cut()
        >>> inside = mesh.imprint(ring).cut(keep="inside")
        >>> len(inside.faces) < len(opened.faces)
        True
        """
        return self._cut(keep, fill, progress, drop_untouched)

    def _cut(self, keep: Keep | None, fill: Fill, progress: Progress | None, drop_untouched: bool) -> Cut:
        shape = cast(str, checked_value("fill", FILL, fill))
        if keep is None and shape != "none":
            raise OptionError(f"fill is {shape!r}, which needs keep", "bad-option")
        if keep is None and drop_untouched:
            raise OptionError("drop_untouched is True, which needs keep", "bad-option")
        cut, notes = self._core.cut((*parts_meant("keep", keep), drop_untouched), fill=shape, progress=progress)
        warn(notes, 3)
        return Cut(*cut)

    def split(self, fill: Fill = "none", progress: Progress | None = None) -> list[Cut]:
        """Take the mesh apart along the curves: each part at a curve by itself. O(m log m).

        A MeshWarning says which curves part nothing, how many rims cannot be filled, and which new faces cross others.

        Parameters
        ----------
        fill : {"none", "flat", "smooth"}, default "none"
            Close each part, so that it is a solid where the mesh is one. Flat patches are the same triangles on both sides of a
            cut, unless curves cross there, or patches can be sound on one side alone; smooth ones go on in the tangent planes of
            each side.
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.

        Returns
        -------
        list of Cut
            The largest part first; all that no curve parts is one of them.

        Raises
        ------
        InputError
            The curves open nothing, or no rim can be filled.
        OptionError
            `fill` is none of these.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> [len(part.faces) for part in mesh.imprint(ring).split()] == [part.faces.size for part in mesh.imprint(ring).parts]
        True
        """
        shape = str(checked_value("fill", FILL, fill))
        parts, notes = self._core.split(shape, progress)
        warn(notes, 2)
        return [Cut(*part) for part in parts]

    def relief(
        self, height: float, part: Keep = "inside", profile: Profile = "step", profile_width: float | None = None
    ) -> Cut:
        """Move parts along their normals: a relief, or an engraving. O(m log m).

        Parameters
        ----------
        height : float
            Outwards where it is positive, in the unit of the mesh. A MeshWarning says where the relief had to be lower so
            that it crosses nothing, or crosses something in spite of that.
        part : "largest", "smallest", "inside", "outside" or (3,) or (k, 3) array of float, default "inside"
            The parts to move, as `keep` of cut(). Where the imprint has strokes, "inside" are these.
        profile : {"step", "ramp", "round"}, default "step"
            How the parts rise from their rim: by a wall, straight, or as a quarter of an ellipse.
        profile_width : float, optional
            Over which they rise, along the surface, in the unit of the mesh. None: the height; of strokes half their width.

        Returns
        -------
        Cut
            The whole mesh: watertight where it was. The walls are its last faces, and new. With a profile there are none, but
            further vertices, whose origin is -1.

        Raises
        ------
        InputError
            The curves part nothing (a PickError), or no part or two are at the point.
        OptionError
            `part` or `profile` is none of these, `height` is not finite, or `profile_width` is not above 0.

        Examples
        --------
        >>> slot = mesh.imprint(curve, stroke=0.02).relief(-0.01, profile="round")
        >>> raised = mesh.imprint(ring).relief(0.02)
        >>> bool((raised.origins >= 0).any())
        True
        """
        meant = parts_meant("part", part)
        raised = checked_number("height", HEIGHT, height)
        if raised == 0:
            return Cut(self.vertices, self.faces, np.arange(len(self.vertices), dtype=np.int32), self.labels)
        shape = cast(str, checked_value("profile", PROFILE, profile))
        width = 0.0 if profile_width is None else checked_number("profile_width", LENGTH, profile_width)
        relief, notes = self._core.cut((*meant, False), relief=(raised, shape, width))
        warn(notes, 2)
        return Cut(*relief)

    def thicken(self, thickness: float, part: Keep = "inside", progress: Progress | None = None) -> Cut:
        """Make parts closed walls: solids of this thickness. O(m log m) a round of checks.

        Parameters
        ----------
        thickness : float
            Outwards where it is positive, inwards where it is negative, in the unit of the mesh. The other side is at this
            distance from the planes of the faces, so that sharp edges stay sharp.
        part : "largest", "smallest", "inside", "outside" or (3,) or (k, 3) array of float, default "inside"
            The parts, as `keep` of cut(); components that no curve parts are dropped.
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.

        Returns
        -------
        Cut
            A watertight mesh, oriented as a solid. The faces of the imprint come first; outwards, they are the moved side.
            A MeshWarning says where the wall had to be thinner so that it crosses nothing, or crosses something in spite of
            that.

        Raises
        ------
        InputError
            The curves part nothing (a PickError), or no part or two are at the point.
        OptionError
            `part` is none of these, or `thickness` is 0 or not finite.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> shell = mesh.imprint(ring).thicken(0.02)
        >>> bool((shell.origins >= 0).all())
        True
        """
        parts = parts_meant("part", part)
        meant = checked_number("thickness", HEIGHT, thickness)
        if meant == 0:
            raise OptionError("thickness is 0, which makes no wall", "bad-option")
        cut, notes = self._core.cut((*parts, True), thickness=meant, progress=progress)
        warn(notes, 2)
        return Cut(*cut)

    def add_base(
        self,
        length: float | None = None,
        part: Keep = "inside",
        direction: npt.ArrayLike | None = None,
        height: float | None = None,
    ) -> Cut:
        """Stand parts on a base, as of a die: their rims go straight to a plane, and are closed there. O(m log m).

        Parameters
        ----------
        length : float, optional
            How far the plane is beyond the farthest point of the parts, in the unit of the mesh. Needed without `height`.
        part : "largest", "smallest", "inside", "outside" or (3,) or (k, 3) array of float, default "inside"
            The parts, as `keep` of cut(); components that no curve parts are dropped.
        direction : (3,) array of float, optional
            From the parts to the plane, at right angles to that. None: against their mean normal.
        height : float, optional
            Where the plane is along `direction`, from the origin, in place of `length`.

        Returns
        -------
        Cut
            A watertight mesh, oriented as a solid. A MeshWarning names faces that cross others, as where a part hangs over
            its rim.

        Raises
        ------
        InputError
            The curves part nothing (a PickError), no part or two are at the point, a part has no rim or reaches beyond the
            plane, or the rim crosses itself as seen along the direction.
        OptionError
            `part` is none of these; `length` is not above 0; both or none of `length` and `height` are given, or `height`
            without `direction`.

        Examples
        --------
        >>> die = mesh.imprint(ring).add_base(0.1)
        >>> bool((die.origins >= 0).all())
        True
        """
        parts = parts_meant("part", part)
        if (length is None) == (height is None):
            raise OptionError("one of length and height is needed: where the plane of the base is", "bad-option")
        if height is not None and direction is None:
            raise OptionError("height needs direction: along which it is", "bad-option")
        towards = [] if direction is None else numbers(direction, "direction").ravel().tolist()
        if len(towards) not in (0, 3):
            raise InputError(f"direction has {len(towards)} numbers, but must have 3", "bad-array")
        far = 0.0 if length is None else checked_number("length", LENGTH, length)
        at = None if height is None else checked_number("height", HEIGHT, height)
        cut, notes = self._core.cut((*parts, True), base=(far, towards, at))
        warn(notes, 2)
        return Cut(*cut)

    def values(self, given: npt.ArrayLike, faces: npt.ArrayLike) -> Floats:
        """Values at the vertices of the mesh, at those of the imprint: linear in each face of the mesh.

        Parameters
        ----------
        given : (k,) or (k, d) array of float
            One row for each vertex of the mesh.
        faces : (f, 3) array of int
            Those of the mesh: mesh.faces.

        Returns
        -------
        (n,) or (n, d) array of float

        Examples
        --------
        >>> imprint = mesh.imprint(ring)
        >>> heights = imprint.values(mesh.vertices[:, 2], mesh.faces)
        >>> heights.shape == (len(imprint.vertices),)
        True
        """
        rows = numbers(given, "given", FieldError)
        inside, weights = self._core.places
        count = len(self.vertices) - len(inside)
        if len(rows) != count:
            raise FieldError(f"given has {len(rows)} rows, but must have {count}, one for each vertex of the mesh", "bad-array")
        triangles = np.asarray(faces)
        if triangles.ndim != 2 or triangles.shape[1] != 3 or triangles.dtype.kind not in "iu":
            raise FieldError(f"faces has shape {triangles.shape} of {triangles.dtype}, but must be those of the mesh: mesh.faces", "bad-array")
        if len(triangles) <= int(inside.max(initial=-1)):
            raise FieldError(f"faces has {len(triangles)} rows, but must be all faces of the mesh: mesh.faces", "bad-array")
        corners = rows[triangles[inside]]
        return np.concatenate([rows, np.einsum("ij,ij...->i...", weights, corners)])

    def __repr__(self) -> str:
        count = len(self.curves)
        return (
            f"<bspline_curve.Imprint: {len(self.vertices)} vertices, {len(self.faces)} faces, "
            f"{count} curve{'s' if count != 1 else ''}>"
        )
