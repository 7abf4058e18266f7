# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong is said by a typed error, with the ids of the elements and the name of the argument."""
import bspline_curve
import numpy as np
import pytest
from bspline_curve import FieldError, InputError, Mesh, MeshError, OptionError, PickError
from scipy.interpolate import BSpline

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
TWO = np.array([[0, 1, 2], [0, 2, 3]])


def changed(array, index, value):
    copy = array.astype(type(value)) if isinstance(value, float) else array.copy()
    copy[index] = value
    return copy


@pytest.mark.parametrize(("vertices", "faces", "code", "ids", "text"), [
    (SQUARE[:, :2], TWO, "bad-array", {}, r"vertices has shape \(4, 2\), but must have \(n, 3\)"),
    (SQUARE.ravel(), TWO, "bad-array", {}, r"vertices has shape \(12,\)"),
    (SQUARE.astype(complex), TWO, "bad-array", {}, "vertices holds complex128, but must hold numbers"),
    ([[0, 0, 0], [1, 0]], TWO, "bad-array", {}, "vertices is no array"),
    ([["0", "0", "0"]], TWO, "bad-array", {}, "vertices holds <U1"),
    (SQUARE, TWO[:, :2], "bad-array", {}, r"faces has shape \(2, 2\), but must have \(m, 3\)"),
    (SQUARE, TWO * 1.0, "bad-array", {}, "faces holds float64, but must hold integers"),
    (SQUARE, TWO[:0], "empty-mesh", {}, "no faces"),
    (SQUARE[:0], TWO[:0], "empty-mesh", {}, "no faces"),
    (SQUARE, TWO - 1, "index-out-of-range", {"faces": (0, 1)}, "faces 0, 1"),
    (SQUARE, changed(TWO, (1, 2), 4), "index-out-of-range", {"faces": (1,)}, "a vertex outside of 0 to 3"),
    (SQUARE, changed(TWO, (1, 2), 2**32), "index-out-of-range", {"faces": (1,)}, "a vertex outside of 0 to 3"),
    (SQUARE, changed(TWO.astype(np.uint64), (1, 2), np.uint64(2**63)), "index-out-of-range", {"faces": (1,)}, "not there"),
    (changed(SQUARE, (2, 1), np.nan), TWO, "non-finite-coordinate", {"vertices": (2,)}, "finite"),
    (changed(SQUARE, (3, 1), np.inf), TWO, "non-finite-coordinate", {"vertices": (3,)}, "finite"),
    (SQUARE * 0, TWO, "degenerate-face", {"faces": (0, 1)}, "no area"),
    (SQUARE, TWO[[0, 1, 1]], "non-manifold-edge", {"faces": (0, 1, 2)}, "two copies of one face"),
    (SQUARE, np.array([[0, 1, 2], [0, 3, 2]]), "inconsistent-orientation", {"faces": (0, 1)}, "opposite"),
    (np.r_[SQUARE, SQUARE[1:] * -1], np.array([[0, 1, 2], [0, 4, 5]]), "non-manifold-vertex", {"vertices": (0,)}, "vertices 0"),
])
def test_a_broken_mesh_is_refused(vertices, faces, code, ids, text):
    with pytest.raises(MeshError, match=text) as caught:
        Mesh(vertices, faces, strict=True)
    assert caught.value.code == code
    for name in ("vertices", "faces", "picks"):
        assert getattr(caught.value, name) == ids.get(name, ()), name


@pytest.mark.parametrize(("given", "code", "ids", "text"), [
    ([[0, 0, 0]], "too-few-picks", (), "2"),
    (np.empty((0, 3)), "too-few-picks", (), "2"),
    (SQUARE[:, :2], "bad-array", (), r"picks has shape \(4, 2\)"),
    ([["0", "0", "0"]], "bad-array", (), "picks holds <U1"),
    ([[0, 0, 0], [0, np.nan, 0]], "non-finite-coordinate", (1,), r"picks\[1\] is \[0.0, nan, 0.0\], but must be finite"),
    ([[0, 0, 0], [0, 0, 5]], "pick-too-far", (1,), "pick 2 lies"),
    ([[0, 0, 0], [0, 0, 0]], "coincident-picks", (0, 1), "pick"),
    ([(0, (1, 0, 0)), (3200, (1, 0, 0))], "index-out-of-range", (1,), r"picks\[1\] is in face 3200, but there are 3200"),
    ([(0, (1, 0, 0)), (3, (1, 1, 0))], "bad-array", (1,), r"picks\[1\] has barycentric coordinates"),
])
def test_picks_are_refused(given, code, ids, text, mesh):
    with pytest.raises(PickError, match=text) as caught:
        mesh.curve(given)
    assert (caught.value.code, caught.value.picks) == (code, ids)


def test_picks_on_other_parts_and_in_avoided_faces_are_refused(mesh, arrays, picks):
    vertices, faces = arrays
    two = Mesh(np.r_[vertices, vertices + [5, 0, 0]], np.r_[faces, faces + len(vertices)])
    assert repr(two).endswith("2 components>")
    with pytest.raises(PickError) as caught:
        two.curve([vertices[0], vertices[50] + [5, 0, 0]])
    assert (caught.value.code, caught.value.picks) == ("picks-on-different-components", (1,))
    face = int(mesh.project(picks[:1]).faces[0])
    with pytest.raises(PickError) as caught:
        mesh.curve(picks, avoid=[face])
    assert (caught.value.code, caught.value.picks) == ("pick-avoided", (0,))
    wall = np.flatnonzero(np.abs(vertices[faces].mean(1)[:, 0]) < 0.1)
    with pytest.raises(PickError, match="no way along the surface") as caught:
        mesh.curve([vertices[0], vertices[-1]], avoid=wall)
    assert (caught.value.code, caught.value.picks) == ("no-path", (0, 1))


@pytest.mark.parametrize(("options", "kind", "text"), [
    ({"tension": 2}, OptionError, r"tension is 2.0, but must be in \[0, 1\]"),
    ({"minimum_span": 0}, OptionError, r"minimum_span is 0.0, but must be in \(0, 0.1\]"),
    ({"field_weight": np.inf}, OptionError, "field_weight is inf, but must be finite and at least 0"),
    ({"distance_tolerance": 0}, OptionError, "but must be finite and more than 0"),
    ({"degree": 5}, OptionError, r"degree is 5, but must be in \[2, 4\]"),
    ({"samples": 2**40}, OptionError, "samples is 1099511627776"),
    ({"bending": "thin"}, OptionError, "bending is 'thin', but must be one of 'preset', 'geodesic'"),
    ({"samples": 1.5}, TypeError, "samples is 1.5, but must be an integer"),
    ({"tension": "1"}, TypeError, "tension is '1', but must be a number"),
    ({"closed": 1}, TypeError, "closed is 1, but must be True or False"),
    ({"bending": 1}, TypeError, "bending is 1, but must be one of"),
    ({"radius": 1}, TypeError, "radius"),
    ({"field": "hills"}, FieldError, "field is 'hills', but must be one of 'none', 'normal-variation'"),
    ({"field": "quality"}, FieldError, "or a value for each vertex"),
    ({"field": [1, 2]}, FieldError, r"field has shape \(2,\), but must have \(1681,\), a value for each vertex"),
    ({"field": "boundary-distance", "avoid": [3200]}, InputError, r"avoid\[0\] is 3200, but there are 3200 faces"),
    ({"avoid": [True]}, InputError, r"avoid has shape \(1,\), but must have \(3200,\), a bool for each face"),
    ({"avoid": [0.5]}, InputError, "avoid holds float64"),
    ({"avoid": [[1]]}, InputError, r"avoid has shape \(1, 1\)"),
])
def test_options_are_refused(options, kind, text, mesh, picks):
    with pytest.raises(kind, match=text):
        mesh.curve(picks, **options)


def test_values_that_are_not_finite_are_named(mesh, picks):
    values = np.zeros(len(mesh.vertices))
    values[[7, 9]] = np.nan
    for call in (lambda: mesh.curve(picks, field=values), lambda: mesh.field("quality", quality=values)):
        with pytest.raises(FieldError, match=r"(field|quality)\[7\] is nan") as caught:
            call()
        assert (caught.value.code, caught.value.vertices) == ("bad-field", (7, 9))
    with pytest.raises(FieldError, match="which needs region"):
        mesh.field("obstacle")
    with pytest.raises(FieldError) as caught:
        mesh.field("crease-distance", crease_angle=180)
    assert caught.value.code == "bad-field"
    with pytest.raises(OptionError, match="kind is 'hills'"):
        mesh.field("hills")
    with pytest.raises(InputError, match=r"points\[0\]"):
        mesh.project([[0, np.inf, 0]])


def test_all_errors_are_input_errors_and_values(mesh):
    for kind in (MeshError, PickError, FieldError, OptionError, bspline_curve.FileError):
        assert issubclass(kind, InputError) and issubclass(kind, ValueError)
    with pytest.raises(TypeError, match="vertices is int: give vertices and faces"):
        Mesh(5)


SPLINE = BSpline(np.array([0.0, 0, 1, 1]), np.array([[-0.5, 0, 0], [0.5, 0, 0]]), 1)


@pytest.mark.parametrize(("call", "kind", "text"), [
    (lambda m, c: m.curve(None), PickError, "picks is None, but must be an array of numbers"),
    (lambda m, c: m.curve([("a", (1, 0, 0)), (1, (1, 0, 0))]), PickError, r"picks\[0\] is in face 'a', but a face is a number"),
    (lambda m, c: m.curve([(np.nan, (1, 0, 0)), (1, (1, 0, 0))]), PickError, r"picks\[0\] is in face nan"),
    (lambda m, c: m.curve(c.picks, progress=5), TypeError, "progress must be a function of a fraction and a stage"),
    (lambda m, c: c.sample("3"), TypeError, "count is '3', but must be an integer"),
    (lambda m, c: c.sample(2.5), TypeError, "count is 2.5, but must be an integer"),
    (lambda m, c: c.save(5), TypeError, "file is 5, but must be a str or a path"),
    (lambda m, c: bspline_curve.load(None, m), TypeError, "file is None, but must be a str or a path"),
    (lambda m, c: bspline_curve.load("x.json", (m.vertices, m.faces)), TypeError, "mesh is tuple, but must be a Mesh"),
    (lambda m, c: Mesh.load(None), TypeError, "file is None, but must be a str or a path"),
    (lambda m, c: Mesh.load("x.ply", bad=1), TypeError, r"Mesh.load\(\) has no option 'bad'; it has shell"),
    (lambda m, c: bspline_curve.repair(m.vertices, m.faces, bad=1), TypeError, r"repair\(\) has no option 'bad'"),
    (lambda m, c: Mesh("x.ply"), TypeError, r"vertices is str.*Mesh.load\(\) reads a file"),
    (lambda m, c: m.pattern(5, centre=[0, 0, 0]), TypeError, "drawing is 5, but must be a file, path data, or polylines"),
    (lambda m, c: bspline_curve.Curve.from_points(c.points, None), TypeError, "mesh is NoneType, but must be a Mesh"),
    (lambda m, c: bspline_curve.Curve.from_scipy(SPLINE, 5), TypeError, "mesh is int, but must be a Mesh"),
    (lambda m, c: c.on(None), TypeError, "mesh is NoneType, but must be a Mesh"),
    (lambda m, c: m.imprint(c).values(m.vertices, None), FieldError, "must be those of the mesh: mesh.faces"),
    (lambda m, c: m.imprint(c).values(m.vertices, m.faces[:3]), FieldError, "faces has 3 rows, but must be all faces of the mesh"),
    (lambda m, c: c.plot(5), TypeError, "plotter is int, but must be a Plotter"),
    (lambda m, c: m.distance(None), InputError, "to is None, but must be an array of numbers"),
])
def test_what_is_wrong_is_said_in_the_callers_words(call, kind, text, mesh, picks):
    with pytest.raises(kind, match=text):
        call(mesh, mesh.curve(picks))
