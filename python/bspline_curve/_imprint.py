# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves as edges of a mesh, and the parts that they leave."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Literal, NamedTuple, TypeAlias, cast

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Int32s, numbers
from ._errors import FieldError, InputError, MeshWarning, OptionError
from ._options import Option, Progress, checked_number, checked_value

Keep: TypeAlias = "Literal['largest', 'smallest', 'inside'] | Sequence[float] | Floats"
Fill: TypeAlias = Literal["none", "flat", "smooth"]

SNAP = Option("double", 1e-9, 0.0, 0.01, False, ())
KEEP = Option("enum", "largest", None, None, False, ("largest", "smallest", "inside"))
HEIGHT = Option("double", 0.0, None, None, False, ())
FILL = Option("enum", "none", None, None, False, ("none", "flat", "smooth"))


def parts_meant(name: str, keep: Keep) -> tuple[str, list[float]]:
    """A word and a seed, as the core takes them."""
    if isinstance(keep, str):
        return cast(str, checked_value(name, KEEP, keep)), [0.0, 0.0, 0.0]
    seed = numbers(keep, name).tolist()
    if np.shape(seed) != (3,):
        raise InputError(f"{name} has shape {np.shape(seed)}, but must be a word or have (3,)", "bad-array")
    return "seed", seed


class Part(NamedTuple):
    """Faces that are joined across edges which are on no curve."""

    faces: Int32s  # ids in the imprint
    area: float
    perimeter: float  # of its rim: curves and the mesh's own boundary
    centroid: Floats  # (3,)
    euler: int  # 1 for a disc, 0 for a ring, 2 for a closed sphere


class Cut(NamedTuple):
    """The mesh, or parts of it, opened along its curves: vertices on them are doubled."""

    vertices: Floats  # (n, 3); copies come last
    faces: Int32s  # (m, 3), in the order of the imprint
    origins: Int32s  # (n,): the vertex of the imprint of each; -1: new, in a filled hole
    labels: Int32s  # (m,): the part of each face, an index into Imprint.parts; -1: new


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
        Vertices of each curve in order, joined by edges; a closed one does not repeat the first.
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

    def __init__(self, core: _core.Imprint) -> None:
        self._core = core
        self._parts: tuple[Int32s, list[Part]] | None = None

    @property
    def vertices(self) -> Floats:
        return self._core.vertices

    @property
    def faces(self) -> Int32s:
        return self._core.faces

    @property
    def parents(self) -> Int32s:
        return self._core.parents

    @property
    def curves(self) -> list[Int32s]:
        return self._core.curves

    @property
    def crossings(self) -> Int32s:
        return self._core.crossings

    @property
    def largest_move(self) -> float:
        return self._core.largest_move

    @property
    def labels(self) -> Int32s:
        return self._measured()[0]

    @property
    def parts(self) -> list[Part]:
        return self._measured()[1]

    def cut(self, keep: Keep | None = None, fill: Fill = "none", progress: Progress | None = None) -> Cut:
        """Open the mesh along the curves; an open curve becomes a slit with joined ends. O(m log m).

        A MeshWarning says which curves part nothing, so that nothing comes apart there.

        Parameters
        ----------
        keep : "largest", "smallest", "inside" or (3,) array of float, default None
            Return one part at the curves, all of these but the largest ("inside"), or the part at a point; None: all parts.
        fill : {"none", "flat", "smooth"}, default "none"
            Fill the holes that the other parts leave: with the area that is least and no new vertices, or as dense as
            around, with its tangent planes. Needs `keep`.
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage while holes are filled; where it returns False, the work is cancelled.

        Returns
        -------
        Cut

        Raises
        ------
        InputError
            The curves open nothing; with `keep`, they part nothing (a PickError), or no part or two are at the point.
        OptionError
            `keep` or `fill` is none of these, or `fill` is there without `keep`.
        Cancelled
            `progress` returned False.
        """
        cut = self._cut(keep, fill, progress)
        self._warn_of_slits(is_cut=keep is None, stacklevel=3)
        return cut

    def _cut(self, keep: Keep | None, fill: Fill, progress: Progress | None) -> Cut:
        shape = cast(str, checked_value("fill", FILL, fill))
        if keep is None:
            if shape != "none":
                raise OptionError(f"fill is {shape!r}, which needs keep", "bad-option")
            vertices, faces, origins = self._core.cut()
            if len(vertices) == len(self.vertices):
                raise InputError(
                    "there is nothing to cut: the curves run along the boundary, or are one edge long and end inside the mesh",
                    "no-path",
                )
            return Cut(vertices, faces, origins, self.labels)
        return Cut(*self._core.take(*parts_meant("keep", keep), shape, progress)[:4])

    def relief(self, height: float, part: Keep = "inside") -> Cut:
        """Move parts along their normals, with walls between them and the rest: a relief, or an engraving. O(m log m).

        Parameters
        ----------
        height : float
            Outwards where it is positive, in the unit of the mesh. A MeshWarning says where faces are turned over.
        part : "largest", "smallest", "inside" or (3,) array of float, default "inside"
            The parts to move, as `keep` of cut().

        Returns
        -------
        Cut
            The whole mesh: watertight where it was. The walls are its last faces, and new.

        Raises
        ------
        InputError
            The curves part nothing (a PickError), or no part or two are at the point.
        OptionError
            `part` is none of these, or `height` is not finite.
        """
        meant = parts_meant("part", part)
        relief = self._core.relief(*meant, checked_number("height", HEIGHT, height))
        turned = relief[4]
        if turned:
            warnings.warn(f"the relief turns {turned} faces over; take a smaller height", MeshWarning, stacklevel=2)
        return Cut(*relief[:4])

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
        """
        rows = numbers(given, "given", FieldError)
        inside, weights = self._core.origins
        count = len(self.vertices) - len(inside)
        if len(rows) != count:
            raise FieldError(f"given has {len(rows)} rows, but must have {count}, one for each vertex of the mesh", "bad-array")
        corners = rows[np.asarray(faces)[inside]]
        return np.concatenate([rows, np.einsum("ij,ij...->i...", weights, corners)])

    def _warn_of_slits(self, is_cut: bool, stacklevel: int) -> None:
        note = self._core.slit_note(is_cut)
        if note:
            warnings.warn(note, MeshWarning, stacklevel=stacklevel)

    def _measured(self) -> tuple[Int32s, list[Part]]:
        if self._parts is None:
            labels, figures = self._core.parts()
            labels.flags.writeable = False
            parts = [
                Part(np.flatnonzero(labels == i).astype(np.int32), area, perimeter, np.array(centroid), euler)
                for i, (_, area, perimeter, centroid, euler) in enumerate(figures)
            ]
            self._parts = labels, parts
        return self._parts

    def __repr__(self) -> str:
        count = len(self.curves)
        return (
            f"<bspline_curve.Imprint: {len(self.vertices)} vertices, {len(self.faces)} faces, "
            f"{count} curve{'s' if count != 1 else ''}>"
        )
