# SPDX-License-Identifier: GPL-3.0-or-later
"""A curve that was drawn, and curves made from it."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from . import _core, _spline
from ._arrays import Floats, Int32s, face_ids, numbers, of_core, one_pick
from ._errors import InputError, PickError
from ._options import Option, Progress, Value, changed, checked_number, checked_value, part_of

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import CurveOptions
    from ._mesh import Mesh


Side: TypeAlias = Literal["left", "right", "both"]
Unit: TypeAlias = Literal["mm", "cm", "m", "um", "in", "ft"]

DISTANCE = Option("double", None, 0.0, None, True, ())
UNIT = Option("enum", "mm", None, None, False, ("mm", "cm", "m", "um", "in", "ft"))
SIDE = Option("enum", "both", None, None, False, ("left", "right", "both"))

_Array = TypeVar("_Array", bound=npt.NDArray[Any])


class Drawing(NamedTuple):
    """What a curve is drawn by."""

    mesh: Mesh
    picks: Floats
    options: dict[str, Value]  # those that are not their defaults
    field: str | _core.Field | None
    avoid: Int32s | None

    def made_field(self, progress: Progress | None = None) -> _core.Field | None:
        if isinstance(self.field, str):
            return self.mesh._kept_field(self.field, progress)
        return self.field

    def resolved(self, progress: Progress | None = None) -> tuple[dict[str, Value], _core.Field | None, Int32s | None]:
        """Options, field, and faces to avoid, as the core takes them."""
        made = self.made_field(progress)  # which checks the kind
        options = self.options
        if isinstance(self.field, str) and "field_cost" not in options:
            options = {**options, "field_cost": _core.natural_cost({"kind": self.field})}
        return options, made, self.avoid

    def renumbered(self, moved: Callable[[int], int | None]) -> Drawing:
        """Corners and tangents of other picks: of `moved` of each, of none where that is None."""
        options = dict(self.options)
        corners: Any = options.get("corners")
        if isinstance(corners, tuple):
            options["corners"] = tuple(each for each in map(moved, corners) if each is not None)
        tangents: Any = options.get("tangents") or ()
        if tangents:
            pairs = ((moved(pick), direction) for pick, direction in tangents)
            options["tangents"] = tuple((pick, direction) for pick, direction in pairs if pick is not None)
        return self._replace(options={name: value for name, value in options.items() if value != ()})

    def draw(self, start: _core.Curve | None, progress: Progress | None) -> Curve:
        share = 0.5 if isinstance(self.field, str) and self.field not in self.mesh._fields else 0.0  # of the field
        resolved = self.resolved(part_of(progress, 0.0, share))
        drawn = self.mesh._core.draw(self.picks, *resolved, start, part_of(progress, share, 1.0))
        return Curve(drawn, self)


class Samples(NamedTuple):
    """Points along a curve, one for each row."""

    points: Floats  # (n, 3)
    faces: Int32s  # (n,)
    barycentrics: Floats  # (n, 3)
    distances: Floats  # (n,), along the polyline from its start
    tangents: Floats  # (n, 3), of unit length, as the next two
    normals: Floats  # (n, 3), of the surface, perpendicular to the tangents
    left: Floats  # (n, 3), to the left of the curve, seen with the normal upwards
    curvature: Floats  # (n,), 1 / radius
    normal_curvature: Floats  # (n,), its part along the normal
    geodesic_curvature: Floats  # (n,), its part to the left


class Curve:
    """A polyline on a mesh, and the B-spline that was projected onto it; it does not change.

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
    picks : (p, 3) array of float
        As they were given.
    mesh : Mesh
    usable : bool
        Whether the spline came as near to the surface as asked; the polyline lies on it in any case.
    length : float
        Of the polyline, in the unit of the mesh.
    report : dict
        How the curve came about: status, notes (what people must know, in words), max_distance (spline to surface, in mean
        edge lengths), seconds, rounds …

    All arrays are read-only, and those but `faces`, `barycentrics` and `values` share the memory of the curve.
    """

    __slots__ = ("_core", "_drawing", "_places", "_report", "_values")

    points: Floats = of_core("points")
    t: Floats = of_core("t")
    control_points: Floats = of_core("control_points")
    knots: Floats = of_core("knots")
    degree: int = of_core("degree")
    closed: bool = of_core("closed")
    pick_parameters: Floats = of_core("pick_parameters")
    pick_vertices: Int32s = of_core("pick_vertices")
    usable: bool = of_core("usable")
    length: float = of_core("length")

    def __init__(self, core: _core.Curve, drawing: Drawing, report: dict[str, Any] | None = None) -> None:
        self._core = core
        self._drawing = drawing
        self._report = report
        self._places: tuple[Int32s, Floats] | None = None
        self._values: Floats | None = None

    @property
    def mesh(self) -> Mesh:
        return self._drawing.mesh

    @property
    def picks(self) -> Floats:
        view = self._drawing.picks.view()
        view.flags.writeable = False
        return view

    @property
    def options(self) -> dict[str, Value]:
        """Those that are not their defaults."""
        return dict(self._drawing.options)

    @property
    def faces(self) -> Int32s:
        return self._placed()[0]

    @property
    def barycentrics(self) -> Floats:
        return self._placed()[1]

    @property
    def values(self) -> Floats:
        if self._values is None:
            field = self._drawing.made_field()
            corners = self.mesh.faces[self.faces]
            along: Floats = self.t if field is None else (field.values[corners] * self.barycentrics).sum(1)
            self._values = _read_only(along)
        return self._values

    @property
    def report(self) -> dict[str, Any]:
        if self._report is None:
            self._report = self._core.report()
        return self._report

    def spline(self, t: npt.ArrayLike, derivative: int = 0) -> Floats:
        """Points of the spline, or its derivatives by t.

        Parameters
        ----------
        t : array of float
            Parameters in [0, 1]; a closed curve takes any, with period 1.
        derivative : int ≥ 0, default 0
            Order of the derivative. Where that jumps, the value is that from the right.

        Returns
        -------
        (..., 3) array of float
            One row for each t. Points are off the surface by up to `distance_tolerance`.

        Raises
        ------
        InputError
            A parameter is outside of [0, 1] on an open curve, or is not finite.
        """
        at = numbers(t, "t").reshape(np.shape(t))
        if not np.isfinite(at).all():
            raise InputError("t must be finite")
        if self.closed:
            at = at % 1.0
        elif at.size and (at.min() < 0.0 or at.max() > 1.0):
            raise InputError(f"t is in [{at.min()}, {at.max()}], but an open curve has [0, 1]")
        return _spline.evaluate(_spline.Spline(self.degree, self.knots, self.control_points), at, derivative)

    def segments(self) -> npt.NDArray[np.int64]:
        """Pairs of indices into `points`: (n - 1, 2), or (n, 2) where the curve is closed."""
        n = len(self.points)
        first = np.arange(n if self.closed else n - 1)
        return np.stack([first, (first + 1) % n], axis=1)

    def move(self, pick: int, point: npt.ArrayLike | tuple[int, Any], progress: Progress | None = None) -> Curve:
        """Draw the curve with one pick at another place: (3,), or a pair (face, barycentrics).

        The solver starts from this curve, which takes about half the time. Raises as Mesh.curve() does.
        """
        index = self._index(pick, len(self._drawing.picks))
        picks = self._drawing.picks.copy()
        picks[index] = one_pick(point, self.mesh, index)
        return self._drawing._replace(picks=picks).draw(self._core, progress)

    def insert(self, pick: int, point: npt.ArrayLike | tuple[int, Any], progress: Progress | None = None) -> Curve:
        """Draw the curve with one more pick, before `pick`; len(picks) puts it last."""
        index = self._index(pick, len(self.picks) + 1)
        added = one_pick(point, self.mesh, index)
        drawing = self._drawing.renumbered(lambda corner: corner + (corner >= index))
        return drawing._replace(picks=np.insert(drawing.picks, index, added, axis=0)).draw(None, progress)

    def remove(self, pick: int, progress: Progress | None = None) -> Curve:
        """Draw the curve without one of its picks."""
        index = self._index(pick, len(self.picks))
        drawing = self._drawing.renumbered(lambda corner: None if corner == index else corner - (corner > index))
        return drawing._replace(picks=np.delete(drawing.picks, index, axis=0)).draw(None, progress)

    def with_options(self, progress: Progress | None = None, **options: Unpack[CurveOptions]) -> Curve:
        """Draw the curve through the same picks with some options changed; those of Mesh.curve()."""
        from ._keywords import CURVE

        given: dict[str, Any] = dict(options)
        drawing = self._drawing
        if "field" in given:
            drawing = drawing._replace(field=self.mesh._field_of(given.pop("field")))
        if "avoid" in given:
            avoid = given.pop("avoid")
            drawing = drawing._replace(avoid=None if avoid is None else face_ids(avoid, "avoid", len(self.mesh.faces)))
        unknown = sorted(given.keys() - CURVE.keys())
        if unknown:
            raise TypeError(f"with_options() has no option {unknown[0]!r}; it has {', '.join([*CURVE, 'field', 'avoid'])}")
        return drawing._replace(options=changed(CURVE, {**drawing.options, **given})).draw(None, progress)

    def offset(self, distance: float, side: Side = "both", progress: Progress | None = None) -> list[Curve]:
        """Draw the lines at a distance from this curve, measured along the surface.

        Where two parts of a line run into each other they end, so that no piece crosses itself or another. Vertices and
        middles of segments are at the distance to 5e-4 of it.

        Parameters
        ----------
        distance : float > 0
            In the unit of the mesh.
        side : {"left", "right", "both"}, default "both"
            Seen along the curve, the surface's normal upwards; "both" runs round the ends of an open curve.
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.

        Returns
        -------
        list of Curve
            The longest piece first; none where no point has that distance. They have no picks. They are cubic splines;
            of degree 1, through all vertices, where no cubic one comes near enough. `report["deviation"]` is the largest
            difference of vertices and middles of segments from the distance, relative to it.

        Raises
        ------
        InputError
            The curve passes from sheet to sheet at an edge where mending parts them.
        OptionError
            `distance` or `side` is not allowed.
        Cancelled
            `progress` returned False.
        """
        near = self._near(distance, side)
        drawing = Drawing(self.mesh, np.empty((0, 3)), {}, None, None)
        pieces = _core.offset(*near, progress)
        return [Curve(piece, drawing, {**piece.report(), "deviation": deviation}) for piece, deviation in pieces]

    def faces_within(
        self, distance: float, side: Side = "both", progress: Progress | None = None
    ) -> npt.NDArray[np.bool_]:
        """Find the faces near this curve: (m,), whether the middle of each is within a distance. As offset()."""
        return _core.faces_within(*self._near(distance, side), progress).astype(np.bool_)

    def _near(self, distance: float, side: str) -> tuple[_core.Mesh, _core.Curve, float, str]:
        length = checked_number("distance", DISTANCE, distance)
        return self.mesh._core, self._core, length, str(checked_value("side", SIDE, side))

    def sample(self, count: int | None = None, *, distances: npt.ArrayLike | None = None) -> Samples:
        """Points at equal distances along the curve (semilandmarks), or at given ones, with frames and curvatures.

        Parameters
        ----------
        count : int
            Of points. Those of an open curve (at least 2) have both ends; those of a closed one part it evenly from its start.
        distances : (n,) array of float
            In place of `count`: from the start, in the unit of the mesh. A closed curve begins anew after its length.

        Returns
        -------
        Samples
            On the mesh; tangent and curvature are those of the spline.

        Raises
        ------
        InputError
            A distance is not on the curve, or neither or both of the arguments are given.
        """
        if (count is None) == (distances is None):
            raise InputError("give either count or distances")
        if distances is None:
            assert count is not None
            least = 1 if self.closed else 2
            if count < least:
                raise InputError(f"count is {count}, but must be at least {least}")
            at = self.length * np.arange(count) / (count if self.closed else count - 1)
        else:
            at = numbers(distances, "distances").ravel()
        columns = _core.points_along(self.mesh._core, self._core, at.tolist())
        faces, barycentrics = columns.pop("places")
        return Samples(faces=faces, barycentrics=barycentrics, **columns)

    def save(self, file: str | os.PathLike[str], unit: Unit = "mm") -> None:
        """Write the curve to a file, which appears wholly, or not at all.

        Parameters
        ----------
        file : str or path
            .json, from which load() makes the curve again; .step, .stp, .iges or .igs: the spline for CAD; .polyline.step …: the
            polyline.
        unit : {"mm", "cm", "m", "um", "in", "ft"}, default "mm"
            Of the mesh; files for CAD name it.

        Raises
        ------
        FileError
            The file cannot be written, or its name has another end.
        """
        from ._files import save

        save(self, file, str(checked_value("unit", UNIT, unit)))

    def to_pyvista(self) -> Any:
        """A PolyData of one line, with t, values, face and barycentric as point data. Needs pyvista."""
        from ._convert import to_pyvista

        return to_pyvista(self)

    def to_trimesh(self) -> Any:
        """A Path3D. Needs trimesh and what it needs for paths: networkx, scipy."""
        from ._convert import to_trimesh

        return to_trimesh(self)

    def to_meshio(self) -> Any:
        """A Mesh of lines, which meshio writes in many formats. Needs meshio."""
        from ._convert import to_meshio

        return to_meshio(self)

    def plot(self, **options: Any) -> Any:
        """Put mesh, curve and picks into a pyvista Plotter, which show() shows, or without pyvista into axes of matplotlib.

        `options` go to Plotter or figure().
        """
        from ._picture import plot

        return plot(self, **options)

    def _repr_html_(self) -> str:
        from ._picture import html

        return html(self)

    def _placed(self) -> tuple[Int32s, Floats]:
        if self._places is None:
            faces, barycentrics = self._core.places
            self._places = _read_only(faces), _read_only(barycentrics)
        return self._places

    def _index(self, pick: int, end: int) -> int:
        if isinstance(pick, bool) or not isinstance(pick, (int, np.integer)):
            raise TypeError(f"pick is {pick!r}, but must be an integer")
        if not len(self._drawing.picks):
            raise PickError("this curve has no picks: it is an offset or of a pattern; draw one with Mesh.curve()", "too-few-picks")
        if not -end <= pick < end:
            raise PickError(f"pick is {pick}, but must be in [{-end}, {end - 1}]", "index-out-of-range")
        return int(pick) % end

    def __repr__(self) -> str:
        kind = "closed" if self.closed else "open"
        note = "" if self.usable else ", not usable"
        return (
            f"<bspline_curve.Curve: {kind}, {len(self.picks)} picks, {len(self.points)} points, "
            f"length {self.length:.6g}{note}>"
        )

    def __len__(self) -> int:
        return len(self.points)

    def __reduce__(self) -> tuple[object, ...]:
        return restored, (self._drawing, self._state(), self.report)

    def _state(self) -> dict[str, Any]:
        """What restored() makes the same curve of."""
        rounds = self.report["rounds"]
        return {
            "points": np.array(self.points),
            "faces": self.faces,
            "barycentrics": self.barycentrics,
            "t": np.array(self.t),
            "control_points": np.array(self.control_points),
            "knots": self.knots.tolist(),
            "pick_parameters": self.pick_parameters.tolist(),
            "pick_vertices": self.pick_vertices.tolist(),
            "degree": self.degree,
            "closed": self.closed,
            "usable": self.usable,
            "is_sampled": self.report["is_sampled"],
            "alpha": rounds[-1]["alpha"] if rounds else 0.0,
        }


def restored(drawing: Drawing, state: dict[str, Any], report: dict[str, Any]) -> Curve:
    """The curve that `state` was taken of."""
    return Curve(_core.Curve.restored(state), drawing, report)


def _read_only(array: _Array) -> _Array:
    array.flags.writeable = False
    return array
