# SPDX-License-Identifier: GPL-3.0-or-later
"""A curve that was drawn, and curves made from it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from . import _core, _spline
from ._arrays import Floats, Int32s, numbers, of_core, one_pick
from ._drawing import Drawing
from ._errors import InputError, PickError
from ._identity import AbsentMesh, difference, name_of
from ._options import Option, Progress, Value, changed, checked_number, checked_value

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import CurveOptions
    from ._lines import ScipySpline
    from ._mesh import Mesh


Side: TypeAlias = Literal["left", "right", "both"]
Unit: TypeAlias = Literal["mm", "cm", "m", "um", "in", "ft"]

DISTANCE = Option("double", None, 0.0, None, True, ())
UNIT = Option("enum", "mm", None, None, False, ("mm", "cm", "m", "um", "in", "ft"))
SIDE = Option("enum", "both", None, None, False, ("left", "right", "both"))

_Array = TypeVar("_Array", bound=npt.NDArray[Any])


class Samples(NamedTuple):
    """Points along a curve, one row for each.

    Attributes
    ----------
    points : (n, 3) array of float
        On the mesh, in its unit.
    faces : (n,) array of int
        A face of the mesh that holds the point.
    barycentrics : (n, 3) array of float
        Where it is in that face.
    distances : (n,) array of float
        Along the polyline from its start, in the unit of the mesh.
    tangents : (n, 3) array of float
        Unit vectors along the curve.
    normals : (n, 3) array of float
        Unit normals of the surface, perpendicular to the tangents.
    left : (n, 3) array of float
        Unit vectors to the left of the curve, seen with the normal upwards.
    curvature : (n,) array of float
        1 / radius, in 1 / unit of the mesh.
    normal_curvature : (n,) array of float
        Its part along the normal.
    geodesic_curvature : (n,) array of float
        Its part to the left.
    """

    points: Floats
    faces: Int32s
    barycentrics: Floats
    distances: Floats
    tangents: Floats
    normals: Floats
    left: Floats
    curvature: Floats
    normal_curvature: Floats
    geodesic_curvature: Floats


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
        Of the spline: 2 to 4 of those that were drawn, 1 of polylines that were given.
    closed : bool
        Whether it ends where it begins.
    pick_parameters : (p,) array of float
        Parameter t of each pick.
    pick_vertices : (p,) array of int
        Which points the picks are.
    picks : (p, 3) array of float
        As they were given.
    normals : (n, 3) array of float
        Unit normals of the surface at the points, perpendicular to the curve, as of sample().
    frames : (n, 3, 3) array of float
        At each point three unit vectors, a row each: tangent, to the left, normal.
    curvature : (n,) array of float
        1 / radius of the spline at the points.
    options : dict
        Those that are not their defaults.
    mesh : Mesh
        A pickle leaves it out. A curve that was unpickled has an equal mesh that is alive in this process, prepared with the
        same options; where there is none, on() gives it one, and until then what needs the mesh raises an InputError.
    usable : bool
        Whether the spline came as near to the surface as asked; the polyline lies on it in any case.
    length : float
        Of the polyline, in the unit of the mesh.
    report : dict
        How the curve came about: status, notes (what people must know, in words), max_distance (spline to surface, in mean
        edge lengths), seconds, rounds …

    All arrays are read-only, and those but `faces`, `barycentrics` and `values` share the memory of the curve.
    """

    __slots__ = ("_at_points", "_core", "_drawing", "_places", "_report", "_values")

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
        self._at_points: Samples | None = None

    @classmethod
    def from_points(
        cls,
        points: npt.ArrayLike,
        mesh: Mesh,
        *,
        closed: bool | None = None,
        max_distance: float = 0.0,
        direction: npt.ArrayLike | None = None,
    ) -> Curve:
        """Lay a polyline on a mesh: its points, and points between them, become the closest ones of the mesh.

        Whatever takes curves also takes such arrays, and does this.

        Parameters
        ----------
        points : (n, 3) array of float
            In order, n ≥ 2.
        mesh : Mesh
        closed : bool, default None
            None: whether the last point is the first.
        max_distance : float ≥ 0, default 0
            A polyline that is farther from the mesh anywhere is refused, in the unit of the mesh; 0: 1 % of its diagonal, along a
            direction any distance.
        direction : (3,) array of float, default None
            Drape the polyline: move each of its points along this direction to the first face that is met there, coming from
            outside. It is refused where it leaves the mesh; imprint(), cut() and segment() take its parts.

        Returns
        -------
        Curve
            Of degree 1 through all its points; t is the length along it, from 0 to 1. It has no picks.

        Raises
        ------
        InputError
            The polyline is not near the mesh, or leads over a gap of it; the message names the point.

        Examples
        --------
        >>> square = [[0, 0, 0], [0.5, 0, 0], [0.5, 0.5, 0], [0, 0.5, 0], [0, 0, 0]]
        >>> line = bspline_curve.Curve.from_points(square, mesh, max_distance=0.3)
        >>> line.closed, line.degree
        (True, 1)
        """
        from ._lines import Placing, of_points, only_one

        return only_one(of_points(points, mesh, closed, Placing(max_distance, direction), "points"))

    @classmethod
    def from_scipy(cls, spline: ScipySpline, mesh: Mesh, *, max_distance: float = 0.0) -> Curve:
        """Project a spline of scipy onto a mesh; it is kept as the spline of the curve, with its knots over [0, 1].

        Whatever takes curves also takes such splines, and does this.

        Parameters
        ----------
        spline : scipy.interpolate.BSpline
            Of degree k ≥ 1 with coefficients (m, 3). One that is periodic, or ends where it begins, is closed.
        mesh : Mesh
        max_distance : float ≥ 0, default 0
            A spline that is farther from the mesh anywhere is refused, in the unit of the mesh; 0: 1 % of its diagonal.

        Returns
        -------
        Curve
            It has no picks.

        Raises
        ------
        InputError
            The spline is not near the mesh, or leads over a gap of it, or is no curve in space.

        Examples
        --------
        >>> from scipy.interpolate import make_interp_spline
        >>> spline = make_interp_spline([0, 1, 2, 3], picks, k=3)
        >>> bspline_curve.Curve.from_scipy(spline, mesh, max_distance=0.5).degree
        3
        """
        from ._lines import is_spline, of_spline

        if not is_spline(spline):
            raise TypeError(f"spline is {type(spline).__name__}, but must be a BSpline of scipy")
        return of_spline(spline, mesh, max_distance, "spline")

    @property
    def mesh(self) -> Mesh:
        return self._bound().mesh

    def on(self, mesh: Mesh) -> Curve:
        """The same curve on an equal mesh: for curves that come from another process, or from a mesh that was made anew.

        Raises
        ------
        InputError
            The mesh is another one: it has other coordinates or faces, or another order of them.

        Examples
        --------
        >>> import pickle
        >>> pickle.loads(pickle.dumps(curve)).on(mesh).mesh is mesh
        True
        """
        other = difference(self._drawing.home, mesh)
        if other:
            raise InputError(f"the curve is of another mesh: {other}")
        return Curve(self._core, self._drawing._replace(home=mesh), self._report)

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
            field = self._bound().made_field()
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

        Examples
        --------
        >>> curve.spline([0, 0.5, 1]).shape, curve.spline(0.5, derivative=1).shape
        ((3, 3), (3,))
        """
        at = numbers(t, "t").reshape(np.shape(t))
        if not np.isfinite(at).all():
            raise InputError("t must be finite")
        if self.closed:
            at = at % 1.0
        elif at.size and (at.min() < 0.0 or at.max() > 1.0):
            raise InputError(f"t is in [{at.min()}, {at.max()}], but an open curve has [0, 1]")
        return _spline.evaluate(self._spline_data(), at, derivative)

    def to_scipy(self) -> Any:
        """The spline as a BSpline of scipy over [0, 1]; that of a closed curve goes on with period 1. Needs scipy.

        Examples
        --------
        >>> spline = curve.to_scipy()
        >>> bool(np.allclose(spline(0.3), curve.spline(0.3)))
        True
        """
        from scipy.interpolate import BSpline

        extrapolate: Any = "periodic" if self.closed else False
        return BSpline(np.array(self.knots), np.array(self.control_points), self.degree, extrapolate=extrapolate)

    def segments(self) -> npt.NDArray[np.int64]:
        """Pairs of indices into `points`: (n - 1, 2), or (n, 2) where the curve is closed.

        Examples
        --------
        >>> ends = curve.points[curve.segments()]
        >>> bool(np.isclose(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum(), curve.length))
        True
        """
        n = len(self.points)
        first = np.arange(n if self.closed else n - 1)
        return np.stack([first, (first + 1) % n], axis=1)

    def move(self, pick: int, point: npt.ArrayLike | tuple[int, Any], progress: Progress | None = None) -> Curve:
        """Draw the curve with one pick at another place. The solver starts from this curve, which takes about three fifths of the time.

        Parameters
        ----------
        pick : int
            Index of the pick; from the end where it is negative.
        point : (3,) array of float, or a pair (face, barycentrics)
            Where it comes to.
        progress : callable, optional
            As of Mesh.curve().

        Returns
        -------
        Curve

        Raises
        ------
        PickError
            The curve has no such pick or none at all, or as Mesh.curve() raises it.

        Examples
        --------
        >>> moved = curve.move(1, mesh.vertices[702])
        >>> bool((moved.picks[1] == mesh.vertices[702]).all())
        True
        """
        index = self._index(pick, len(self._drawing.picks))
        picks = self._drawing.picks.copy()
        picks[index] = one_pick(point, self.mesh, index)
        return drawn(self._bound()._replace(picks=picks), self._core, progress)

    def insert(self, pick: int, point: npt.ArrayLike | tuple[int, Any], progress: Progress | None = None) -> Curve:
        """Draw the curve with one more pick.

        Parameters
        ----------
        pick : int
            Index of the pick that it comes before; len(picks) puts it last.
        point : (3,) array of float, or a pair (face, barycentrics)
        progress : callable, optional
            As of Mesh.curve().

        Returns
        -------
        Curve

        Raises
        ------
        PickError
            As move() raises it.

        Examples
        --------
        >>> len(curve.insert(1, mesh.vertices[500]).picks) - len(curve.picks)
        1
        """
        index = self._index(pick, len(self.picks) + 1)
        added = one_pick(point, self.mesh, index)
        drawing = self._bound().renumbered(len(self.picks) + 1, lambda corner: corner + (corner >= index))
        return drawn(drawing._replace(picks=np.insert(drawing.picks, index, added, axis=0)), None, progress)

    def remove(self, pick: int, progress: Progress | None = None) -> Curve:
        """Draw the curve without one of its picks.

        Parameters
        ----------
        pick : int
            Index of the pick; from the end where it is negative.
        progress : callable, optional
            As of Mesh.curve().

        Returns
        -------
        Curve

        Raises
        ------
        PickError
            As move() raises it, or too few picks are left.

        Examples
        --------
        >>> len(curve.remove(-1).picks) - len(curve.picks)
        -1
        """
        index = self._index(pick, len(self.picks))
        drawing = self._bound().renumbered(len(self.picks) - 1, lambda corner: None if corner == index else corner - (corner > index))
        return drawn(drawing._replace(picks=np.delete(drawing.picks, index, axis=0)), None, progress)

    def with_options(self, progress: Progress | None = None, **options: Unpack[CurveOptions]) -> Curve:
        """Draw the curve through the same picks with some options changed.

        Parameters
        ----------
        progress : callable, optional
            As of Mesh.curve().
        **options
            Those of Mesh.curve().

        Returns
        -------
        Curve

        Raises
        ------
        InputError
            As Mesh.curve() raises it; a PickError where the curve was not drawn through picks.

        Examples
        --------
        >>> curve.with_options(tension=0.5, closed=True).options
        {'tension': 0.5, 'closed': True}
        """
        from ._keywords import CURVE

        given: dict[str, Any] = dict(options)
        drawing = self._bound()
        guides = {name: given.pop(name) for name in ("field", "avoid", "quality", "field_region") if name in given}
        unknown = sorted(given.keys() - CURVE.keys())
        if unknown:
            known = ", ".join([*CURVE, "field", "avoid", "quality", "field_region"])
            raise TypeError(f"with_options() has no option {unknown[0]!r}; it has {known}")
        drawing = drawing._replace(**self.mesh._guides(**guides))
        return drawn(drawing._replace(options=changed(CURVE, {**drawing.options, **given})), None, progress)

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

        Examples
        --------
        >>> outer, inner = sorted(ring.offset(0.05), key=len)
        >>> outer.degree, outer.report["deviation"] < 1e-3
        (3, True)
        """
        near = self._near(distance, side)
        drawing = Drawing(self.mesh, np.empty((0, 3)), {}, fixed="an offset")
        pieces = _core.offset(*near, progress)
        return [Curve(piece, drawing, {**piece.report(), "deviation": deviation}) for piece, deviation in pieces]

    def faces_within(
        self, distance: float, side: Side = "both", progress: Progress | None = None
    ) -> npt.NDArray[np.bool_]:
        """Find the faces near this curve.

        Parameters
        ----------
        distance, side, progress
            As of offset().

        Returns
        -------
        (m,) array of bool
            Whether the middle of each face is within the distance.

        Examples
        --------
        >>> near = curve.faces_within(0.1)
        >>> near.dtype, near.shape == (len(mesh.faces),)
        (dtype('bool'), True)
        """
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

        Examples
        --------
        >>> samples = curve.sample(20)
        >>> samples.points.shape, samples.curvature.shape
        ((20, 3), (20,))
        >>> curve.sample(distances=[0.1, 0.2]).distances
        array([0.1, 0.2])
        """
        if (count is None) == (distances is None):
            raise InputError("give either count or distances")
        if distances is None:
            if isinstance(count, bool) or not isinstance(count, (int, np.integer)):
                raise TypeError(f"count is {count!r}, but must be an integer")
            least = 1 if self.closed else 2
            if count < least:
                raise InputError(f"count is {count}, but must be at least {least}")
            at = self.length * np.arange(count) / (count if self.closed else count - 1)
        else:
            at = numbers(distances, "distances").ravel()
        columns = _core.points_along(self.mesh._core, self._core, at.tolist())
        faces, barycentrics = columns.pop("places")
        return Samples(faces=faces, barycentrics=barycentrics, **columns)

    @property
    def normals(self) -> Floats:
        return self._frames().normals

    @property
    def frames(self) -> Floats:
        found = self._frames()
        return _read_only(np.stack([found.tangents, found.left, found.normals], axis=1))

    @property
    def curvature(self) -> Floats:
        return self._frames().curvature

    def reversed(self) -> Curve:
        """The same curve from its end to its start; a closed one keeps its first point. Its picks change their order.

        Examples
        --------
        >>> turned = curve.reversed()
        >>> bool(np.allclose(turned.spline(0.2), curve.spline(0.8)))
        True
        """
        from ._pieces import reversed_curve

        return reversed_curve(self)

    def trim(self, start: float, end: float) -> Curve:
        """Cut out the part between two parameters, as an open curve: spline and polyline end at the same places.

        Parameters
        ----------
        start, end : float in [0, 1]
            Parameters t, start < end. On a closed curve start may be larger: the part leads over its first point then.

        Returns
        -------
        Curve
            Its t is from 0 to 1 again. Its spline is the same one, by insertion of knots. It has the picks that lie in the part,
            and cannot be drawn again: to change it, change the whole curve, and trim that.

        Raises
        ------
        InputError
            A parameter is not in [0, 1], or the part has no length.

        Examples
        --------
        >>> middle = curve.trim(0.25, 0.75)
        >>> bool(np.allclose(middle.spline(0), curve.spline(0.25)))
        True
        """
        from ._pieces import checked_parameter, part

        return part(self, *(checked_parameter(name, at, self.closed) for name, at in (("start", start), ("end", end))))

    def split(self, at: float | Sequence[float] | Floats) -> list[Curve]:
        """Cut the curve at parameters t into open curves; together they are the whole.

        Parameters
        ----------
        at : float or (k,) array of float in [0, 1]
            In any order. The ends of an open curve do not count. One is enough for a closed curve to become an open one.

        Returns
        -------
        list of Curve
            In the order of the curve, each as of trim(); those of a closed curve begin at the first parameter.

        Raises
        ------
        InputError
            A parameter is not in [0, 1].

        Examples
        --------
        >>> parts = curve.split([0.3, 0.6])
        >>> len(parts), bool(np.isclose(sum(part.length for part in parts), curve.length))
        (3, True)
        """
        from ._pieces import checked_parameter, parts

        given = numbers(np.atleast_1d(np.asarray(at)), "at").ravel().tolist()
        return parts(self, [checked_parameter("at", each, self.closed) for each in given]) if given else [self]

    def join(
        self,
        other: Curve,
        *,
        smooth: bool = False,
        gap: float | str = "1edge",
        blend: float | str = "3edges",
        progress: Progress | None = None,
    ) -> Curve:
        """Join this open curve and another one of the mesh, by those of their ends that are nearest; it goes the way of this one.

        Parameters
        ----------
        other : Curve
            Open, with a spline of the same degree.
        smooth : bool, default False
            True: they meet with one direction (G1); else at a corner where their directions differ.
        gap : float or str, default "1edge"
            How far apart, in a straight line, the ends may be, as a length in the unit of the mesh, or as text like '1edge'. A
            curve through both bridges the gap.
        blend : float or str, default "3edges"
            How much of either curve, but at most a third of it, gives way to a smooth passage, likewise. Without effect where the
            curves meet with one direction already.
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.

        Returns
        -------
        Curve
            Outside of the passage both stay what they are. It cannot be drawn again: change the curves, and join them.

        Raises
        ------
        InputError
            A curve is closed, degrees differ, the gap is too wide, or no way leads over it.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> first, second = curve.split(0.5)
        >>> whole = first.join(second)
        >>> bool(np.allclose(whole.spline([0, 1]), curve.spline([0, 1])))
        True
        """
        from ._pieces import joined

        return joined(self, other, smooth, gap, blend, progress)

    def extend(self, end: float = 0.0, *, start: float = 0.0, progress: Progress | None = None) -> Curve:
        """Let the curve go on from its ends, along the surface, as straight as that lets it.

        Parameters
        ----------
        end, start : float ≥ 0, default 0
            Lengths in the unit of the mesh. The boundary of the mesh ends the curve before.
        progress : callable, optional
            Called with a fraction in [0, 1] and a stage; where it returns False, the work is cancelled.

        Returns
        -------
        Curve
            With the same tangents where it goes on. It cannot be drawn again: change this one, and extend that.

        Raises
        ------
        InputError
            The curve is closed, a length is negative, or the curve ends at a boundary that it would cross.
        Cancelled
            `progress` returned False.

        Examples
        --------
        >>> longer = curve.extend(0.1)
        >>> bool(abs(longer.length - curve.length - 0.1) < 0.01)
        True
        """
        from ._pieces import extended

        return extended(self, start, end, progress)

    def save(self, file: str | os.PathLike[str], unit: Unit = "mm") -> None:
        """Write the curve to a file, which appears wholly, or not at all.

        Parameters
        ----------
        file : str or path
            The end of its name tells the format, as of the program. .json: all, from which load() makes the curve again. .ply,
            .obj, .dxf, .vtu, .csv: the polyline. .bspline.obj, .bspline.dxf: the spline. .step, .stp, .iges, .igs: the spline
            for CAD; .polyline.step …: the polyline.
        unit : {"mm", "cm", "m", "um", "in", "ft"}, default "mm"
            Of the mesh; files for CAD name it.

        Raises
        ------
        FileError
            The file cannot be written, or its name has another end.

        Examples
        --------
        >>> curve.save("curve.step", unit="mm")
        >>> curve.save("curve.json")
        """
        from ._files import save

        save(self, file, str(checked_value("unit", UNIT, unit)))

    def to_pyvista(self) -> Any:
        """A PolyData of one line, with t, values, face and barycentric as point data. Needs pyvista.

        Examples
        --------
        >>> curve.to_pyvista().n_cells
        1
        """
        from ._convert import to_pyvista

        return to_pyvista(self)

    def to_trimesh(self) -> Any:
        """A Path3D. Needs trimesh and what it needs for paths: networkx, scipy.

        Examples
        --------
        >>> bool(np.isclose(curve.to_trimesh().length, curve.length))
        True
        """
        from ._convert import to_trimesh

        return to_trimesh(self)

    def to_meshio(self) -> Any:
        """A Mesh of lines, which meshio writes in many formats. Needs meshio.

        Examples
        --------
        >>> curve.to_meshio().write("curve.vtu")
        """
        from ._convert import to_meshio

        return to_meshio(self)

    def plot(self, plotter: Any = None, **options: Any) -> Any:
        """Put mesh, curve and picks into a pyvista Plotter, which show() shows, or without pyvista into axes of matplotlib.

        The line is drawn in front of the surface that it lies on.

        Parameters
        ----------
        plotter : optional
            What plot() of another curve returned, or a Plotter or axes of your own: this curve is added, and the mesh where it
            is not there yet.
        **options
            Go to Plotter or figure().

        Returns
        -------
        pyvista.Plotter or matplotlib axes
            In a notebook, show() of the plotter gives a view that can be turned.

        Examples
        --------
        >>> plotter = curve.plot(off_screen=True)
        >>> plotter = ring.plot(plotter)
        >>> plotter.close()
        """
        from ._picture import plot

        return plot(self, plotter, **options)

    def _repr_html_(self) -> str:
        from ._picture import html

        return html(self)

    def _bound(self) -> Drawing:
        """What the curve is drawn by, with the mesh found."""
        if isinstance(self._drawing.home, AbsentMesh):
            self._drawing = self._drawing._replace(home=self._drawing.home.found())
        return self._drawing

    def _spline_data(self) -> _spline.Spline:
        return _spline.Spline(self.degree, self.knots, self.control_points)

    def _frames(self) -> Samples:
        """Samples at all points."""
        if self._at_points is None:
            steps = np.linalg.norm(np.diff(self.points, axis=0), axis=1)
            distances = np.minimum(np.r_[0.0, np.cumsum(steps)], self.length)
            samples = self.sample(distances=distances)
            for array in samples:
                array.flags.writeable = False
            self._at_points = samples
        return self._at_points

    def _placed(self) -> tuple[Int32s, Floats]:
        if self._places is None:
            faces, barycentrics = self._core.places
            self._places = _read_only(faces), _read_only(barycentrics)
        return self._places

    def _index(self, pick: int, end: int) -> int:
        if isinstance(pick, bool) or not isinstance(pick, (int, np.integer)):
            raise TypeError(f"pick is {pick!r}, but must be an integer")
        if self._drawing.fixed:
            raise PickError(
                f"this curve is {self._drawing.fixed}: it has no picks to be drawn through; draw one with Mesh.curve()", "too-few-picks"
            )
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
        home = self._drawing.home
        absent = home if isinstance(home, AbsentMesh) else name_of(home)
        return restored, (self._drawing._replace(home=absent), self._state(), self.report)

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


def drawn(drawing: Drawing, start: _core.Curve | None = None, progress: Progress | None = None) -> Curve:
    """The curve of a drawing; `start`: one that the solver starts from."""
    return Curve(*drawing.draw(start, progress))


def restored(drawing: Drawing, state: dict[str, Any], report: dict[str, Any] | None) -> Curve:
    """The curve that `state` was taken of."""
    return Curve(_core.Curve.restored(state), drawing, report)


def _read_only(array: _Array) -> _Array:
    array.flags.writeable = False
    return array
