# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves on equal meshes, lines that come from elsewhere, and ways and distances along the surface."""
import gc
import os
import pickle
import subprocess
import sys
from pathlib import Path

import bspline_curve
import numpy as np
import pytest
from bspline_curve import Curve, InputError, Mesh
from scipy.interpolate import BSpline, make_interp_spline

ARRAYS = ("points", "faces", "barycentrics", "t", "control_points", "knots", "pick_parameters", "pick_vertices", "picks")


DRAWN_ELSEWHERE = """
import pickle, sys
import bspline_curve
arrays, picks = pickle.load(sys.stdin.buffer)
curve = bspline_curve.Mesh(*arrays).curve(picks, field="ridge")
sys.stdout.buffer.write(pickle.dumps(curve))
"""


def test_a_curve_of_another_process_is_one_of_this_mesh(mesh, arrays, picks):
    folder = Path(bspline_curve.__file__).parents[1]
    done = subprocess.run([sys.executable, "-c", DRAWN_ELSEWHERE], input=pickle.dumps((arrays, picks)), capture_output=True,
                          env={**os.environ, "PYTHONPATH": str(folder)}, check=True)
    curve = pickle.loads(done.stdout)
    here = mesh.curve(picks, field="ridge")
    np.testing.assert_array_equal(mesh.imprint([curve]).vertices, mesh.imprint([here]).vertices)
    assert curve.mesh._core.checksum == mesh._core.checksum
    np.testing.assert_array_equal(curve.move(1, mesh.vertices[702]).points, here.move(1, mesh.vertices[702]).points)


def test_a_pickled_curve_leaves_its_mesh_out(mesh, picks):
    for options in ({}, {"closed": True, "tension": 0.2}, {"samples": 0}):
        curve = mesh.curve(picks, **options)
        assert len(pickle.dumps(curve)) <= 3 * sum(getattr(curve, name).nbytes for name in ARRAYS)


def test_an_unpickled_curve_finds_an_equal_mesh_or_says_that_there_is_none(wavy):
    vertices, faces = wavy(17)
    mesh = Mesh(vertices, faces)
    data = pickle.dumps(mesh.curve(vertices[[20, 150, 260]]))
    assert pickle.loads(data).mesh is mesh
    del mesh
    gc.collect()
    curve = pickle.loads(data)
    with pytest.raises(InputError, match=r"came without its mesh \(512 faces\).*curve.on\(mesh\)"):
        curve.mesh
    assert len(curve.points) and curve.spline(0.5).shape == (3,)  # these need no mesh
    again = Mesh(vertices, faces, shell_thickness=0.5)  # prepared otherwise: taken where it is given
    with pytest.raises(InputError, match="came without its mesh"):
        curve.mesh
    assert curve.on(again).mesh is again and len(again.imprint([curve]).curves[0]) >= len(curve)


def test_a_curve_of_truly_another_mesh_is_refused(mesh, arrays, picks):
    curve = Mesh(*arrays).curve(picks)
    assert mesh.imprint([curve]).curves and curve.on(mesh).mesh is mesh
    vertices, faces = arrays
    for other, said in [
        (Mesh(vertices * 1.01, faces), "its coordinates, its faces or their order are others"),
        (Mesh(vertices, faces[::-1]), "or their order"),
        (Mesh(vertices, faces[1:]), "that one has 3200 faces, this one has 3199"),
    ]:
        with pytest.raises(InputError, match=rf"curves\[0\] is of another mesh: .*{said}"):
            other.imprint([curve])
        with pytest.raises(InputError, match="the curve is of another mesh"):
            curve.on(other)


def test_a_mesh_of_pyvista_whose_data_are_touched_stays_the_same(arrays, picks):
    pyvista = pytest.importorskip("pyvista")
    import bspline_curve._accessor  # noqa: F401, which an installed package has by its entry point

    surface = pyvista.PolyData.from_regular_faces(arrays[0].copy(), arrays[1])
    curve = surface.bspline_curve.curve(picks)
    surface.point_data["heat"] = np.arange(len(arrays[0]), dtype=float)
    surface.Modified()
    assert surface.bspline_curve.mesh is curve.mesh
    assert len(surface.bspline_curve.mesh.imprint([curve]).parts) == 1
    surface.points *= 2
    surface.Modified()
    assert surface.bspline_curve.mesh is not curve.mesh
    with pytest.raises(InputError, match="another mesh"):
        surface.bspline_curve.mesh.imprint([curve])


@pytest.mark.parametrize("closed", [False, True])
def test_polylines_and_splines_enter_where_curves_do(mesh, picks, closed):
    curve = mesh.curve(picks, closed=closed)
    points = np.concatenate([curve.points, curve.points[:1]]) if closed else np.array(curve.points)
    lifted = points + [0, 0, 0.003]
    parts = len(mesh.imprint([curve]).parts)
    for line in (points, lifted, curve.to_scipy()):
        assert len(mesh.imprint([line]).parts) == len(mesh.imprint(line).parts) == parts
        assert len(mesh.imprint([curve, line, points]).curves) == 3
    if closed:
        assert len(mesh.cut(points, keep="inside").faces) == len(mesh.cut(curve, keep="inside").faces)
        assert len(mesh.segment([curve.to_scipy()]).parts) == len(mesh.segment(curve).parts)
    with pytest.raises(InputError, match=r"curves\[1\] is not near the mesh: vertex 0, .* larger max_distance"):
        mesh.imprint([curve, points + [0, 0, 0.2]])
    assert mesh.imprint([points + [0, 0, 0.2]], max_distance=0.3).curves
    line = Curve.from_points(lifted, mesh)
    assert line.closed == closed and line.degree == 1 and line.usable
    assert line.length == pytest.approx(curve.length, rel=1e-2)
    np.testing.assert_allclose(line.spline(line.t), line.points, atol=1e-12)
    assert line.offset(0.05)[0].length == pytest.approx(curve.offset(0.05)[0].length, rel=0.05)


@pytest.mark.parametrize("kind", ["open", "periodic", "clamped but closed", "not clamped"])
def test_a_spline_of_scipy_keeps_its_shape(flat, kind):
    angles = np.linspace(0, 2 * np.pi, 13)
    circle = np.stack([0.5 + 0.3 * np.cos(angles), 0.5 + 0.3 * np.sin(angles), 0 * angles], -1)
    if kind == "not clamped":
        given = BSpline(np.arange(12.0), circle[:8], 3)
    else:
        bounds = "periodic" if kind == "periodic" else None
        given = make_interp_spline(5 + 2 * angles, circle[:-3] if kind == "open" else circle, k=3, bc_type=bounds) \
            if kind != "open" else make_interp_spline(5 + 2 * angles[:-3], circle[:-3], k=3)
    low, high = given.t[given.k], given.t[len(given.t) - given.k - 1]
    curve = Curve.from_scipy(given, flat)
    assert curve.closed == (kind in ("periodic", "clamped but closed"))
    at = np.linspace(0, 1, 101)[:-1]
    np.testing.assert_allclose(curve.spline(at), given(low + at * (high - low)), atol=1e-12)
    np.testing.assert_allclose(curve.points, curve.spline(curve.t), atol=2e-4)  # chords between samples
    assert (np.diff(curve.t) > 0).all()
    back = curve.to_scipy()
    np.testing.assert_allclose(back(at), curve.spline(at), atol=1e-12)
    assert back.extrapolate == ("periodic" if curve.closed else False)


@pytest.fixture(scope="module")
def flat(wavy):
    vertices, faces = wavy(21, height=0.0, low=0)
    return Mesh(vertices, faces)


def test_what_is_no_line_is_refused(mesh, flat, picks):
    for given, error, said in [
        (5, TypeError, "curves is int, but must be curves"),
        ("M0 0", TypeError, "curves is str"),
        ([[0.0, 0, 0]], InputError, r"curves\[0\] has shape \(3,\), but must have \(n, 3\)"),
        ([picks[:1]], InputError, "has 1 points, but a line has at least 2"),
        ([picks * np.nan], InputError, "must be finite"),
        ([picks[[0, 0]]], InputError, "one point on the mesh"),
        ([BSpline(np.arange(8.0), np.zeros((4, 2)), 3)], InputError, "must be a curve in space"),
    ]:
        with pytest.raises(error, match=said):
            mesh.imprint(given)
    with pytest.raises(TypeError, match="must be a BSpline of scipy"):
        Curve.from_scipy(picks, mesh)
    for curve in (Curve.from_points(picks[:2], mesh, max_distance=1), mesh.path(picks[0], picks[1])):
        with pytest.raises(bspline_curve.PickError, match="it has no picks to be drawn through"):
            curve.move(0, picks[0])
        with pytest.raises(bspline_curve.PickError, match="it has no picks to be drawn through"):
            curve.with_options(tension=0.1)


@pytest.mark.parametrize("degree", [2, 3, 4])
@pytest.mark.parametrize("closed", [False, True])
def test_a_curve_is_turned_round(mesh, picks, closed, degree):
    curve = mesh.curve(picks, closed=closed, degree=degree)
    turned = curve.reversed()
    at = np.linspace(0, 1, 60)
    np.testing.assert_allclose(turned.spline(1 - at), curve.spline(at), atol=1e-12)
    np.testing.assert_allclose(turned.points[turned.pick_vertices], turned.picks, atol=1e-12)
    np.testing.assert_allclose(turned.spline(turned.pick_parameters), turned.picks, atol=1e-9)
    assert (np.diff(turned.pick_parameters) > 0).all() and (np.diff(turned.t) > 0).all()
    assert turned.length == pytest.approx(curve.length)
    np.testing.assert_allclose(turned.reversed().points, curve.points)
    moved = turned.move(1, mesh.vertices[702])
    np.testing.assert_allclose(moved.points[moved.pick_vertices[1]], mesh.vertices[702], atol=1e-12)
    left, right = (c.faces_within(0.05, side) for c, side in ((curve, "left"), (turned, "right")))
    assert (left != right).sum() <= (0 if closed else 6)  # beside the ends


def test_corners_tangents_and_tolerances_go_the_other_way_with_their_picks(mesh, picks):
    curve = mesh.curve(picks, closed=True, corners=[0, 1], tangents={2: (1, 0, 0)}, pick_tolerance=[0, 0, 0, 0.05])
    turned = curve.reversed()
    at = np.linspace(0.01, 0.99, 60)
    np.testing.assert_allclose(turned.spline(1 - at), curve.spline(at), atol=1e-12)
    assert turned.options["corners"] == (0, 3) and turned.options["tangents"] == ((2, (-1, 0, 0)),)
    assert turned.options["pick_tolerance"] == ("0.0", "0.05", "0.0", "0.0")
    np.testing.assert_array_equal(turned.picks, picks[[0, 3, 2, 1]])
    # A closed curve that is cut open at a corner, and over its first point.
    for start, end in ((0.0, 1.0), (curve.pick_parameters[2], curve.pick_parameters[1])):
        part = curve.trim(start, end)
        assert part.picks.shape == part.points[part.pick_vertices].shape and len(part.picks) >= 4
        near = [each for each in range(len(part.picks)) if np.abs(part.picks[each] - picks[3]).max() > 0]  # but the pick with a tolerance
        np.testing.assert_allclose(part.points[part.pick_vertices][near], part.picks[near], atol=1e-12)


@pytest.mark.parametrize("degree", [2, 3, 4])
@pytest.mark.parametrize("closed", [False, True])
def test_parts_of_a_curve_are_those_of_spline_and_polyline(mesh, picks, closed, degree):
    curve = mesh.curve(picks, closed=closed, degree=degree)
    at = np.linspace(0, 1, 40)
    bounds = [(0.2, 0.7), (0.0, 0.5), (curve.pick_parameters[1], curve.pick_parameters[2]), (0.0, 1.0)]
    for start, end in bounds + ([(0.8, 0.3)] if closed else []):
        part = curve.trim(start, end)
        span = end - start if end > start else end + 1 - start
        assert not part.closed and (part.t[0], part.t[-1]) == (0, 1) and (np.diff(part.t) > 0).all()
        expected = curve.spline(start + span * at) if closed else curve.spline(np.minimum(start + span * at, 1))
        np.testing.assert_allclose(part.spline(at), expected, atol=1e-12)
        on_faces = (mesh.vertices[mesh.faces[part.faces]] * part.barycentrics[..., None]).sum(1)
        np.testing.assert_allclose(on_faces, part.points, atol=1e-12)
        np.testing.assert_allclose(part.spline(part.t), part.points, atol=1e-2)
        np.testing.assert_allclose(part.points[part.pick_vertices], part.picks, atol=1e-12)
        np.testing.assert_allclose(part.spline(part.pick_parameters), part.picks, atol=1e-9)
        assert mesh.imprint([part]).largest_move < 1e-9
    part = curve.trim(curve.pick_parameters[1], curve.pick_parameters[2])
    np.testing.assert_array_equal(part.picks, picks[1:3])
    with pytest.raises(bspline_curve.PickError, match="a part of another"):
        part.move(0, picks[0])
    parts = curve.split([0.5, 0.25])
    assert len(parts) == (2 if closed else 3)
    assert sum(part.length for part in parts) == pytest.approx(curve.length, abs=1e-12)
    for one, next_one in zip(parts, parts[1:]):
        np.testing.assert_array_equal(one.points[-1], next_one.points[0])
    assert [len(curve.split(0.5)), len(curve.split([]))] == ([1, 1] if closed else [2, 1])


def test_parts_that_are_not_there_are_refused(mesh, picks):
    curve = mesh.curve(picks)
    for bounds, error, said in [
        ((0.5, 0.2), InputError, "has no length"),
        ((-0.1, 0.2), InputError, r"start is -0.1, but a parameter of an open curve is in \[0, 1\]"),
        ((0.1, np.nan), InputError, "end is nan"),
        ((0.1, "1"), TypeError, "end is '1', but must be a number"),
    ]:
        with pytest.raises(error, match=said):
            curve.trim(*bounds)
    with pytest.raises(InputError, match="at is 2.0"):
        curve.split(2)


@pytest.mark.parametrize("smooth", [False, True])
def test_curves_are_joined_at_corners_or_smoothly(mesh, picks, smooth):
    first, second = mesh.curve(picks[:3]), mesh.curve([picks[2], picks[0]])
    joined = first.join(second, smooth=smooth)
    np.testing.assert_array_equal(joined.points[[0, -1]], [first.points[0], second.points[-1]])
    assert (np.diff(joined.t) > 0).all() and mesh.imprint([joined]).largest_move < 1e-9
    np.testing.assert_allclose(joined.spline(joined.pick_parameters), joined.picks, atol=1e-2)
    # Where the curve has full knots its directions before and behind them are one, or not.
    inner = [t for t in np.unique(joined.knots) if (joined.knots == t).sum() == 3 and 0 < t < 1]
    assert len(inner) == (2 if smooth else 1)
    for t in inner:
        before, behind = (joined.spline(t + step, 1) for step in (-1e-9, 1e-9))
        angle = np.arccos(np.clip(before @ behind / np.linalg.norm(before) / np.linalg.norm(behind), -1, 1))
        assert (angle < 1e-5) == smooth
    with pytest.raises(bspline_curve.PickError, match="joined of others"):
        joined.move(0, picks[0])
    if not smooth:
        assert joined.length == pytest.approx(first.length + second.length)


def test_curves_apart_are_joined_over_the_gap_that_is_allowed(mesh, picks):
    whole = mesh.curve(picks)
    first, _, second = whole.split([0.4, 0.45])
    gap = np.linalg.norm(first.points[-1] - second.points[0])
    for smooth in (False, True):
        assert second.join(first, smooth=smooth, gap=1.01 * gap).length == pytest.approx(whole.length, rel=0.02)
    with pytest.raises(InputError, match="apart, more than the gap that is allowed"):
        first.join(second, gap=0.99 * gap)
    with pytest.raises(InputError, match="a closed curve has no ends"):
        first.join(mesh.curve(picks, closed=True))
    with pytest.raises(TypeError, match="other is ndarray"):
        first.join(picks)


def test_curves_go_on_from_their_ends(mesh, picks):
    curve = mesh.curve(picks).trim(0.2, 0.8)
    longer = curve.extend(0.05, start=0.1)
    assert longer.length == pytest.approx(curve.length + 0.15, abs=2e-3)
    assert mesh.imprint([longer]).largest_move < 1e-9
    np.testing.assert_array_equal(curve.extend().points, curve.points)
    with pytest.raises(InputError, match="end is -1"):
        curve.extend(-1)
    with pytest.raises(InputError, match="a closed curve has no ends"):
        mesh.curve(picks, closed=True).extend(0.1)


def test_frames_at_the_points_are_those_of_samples(mesh, picks):
    curve = mesh.curve(picks, closed=True)
    n = len(curve)
    assert (curve.normals.shape, curve.frames.shape, curve.curvature.shape) == ((n, 3), (n, 3, 3), (n,))
    np.testing.assert_allclose(curve.frames @ curve.frames.transpose(0, 2, 1), np.broadcast_to(np.eye(3), (n, 3, 3)), atol=1e-12)
    np.testing.assert_array_equal(curve.frames[:, 2], curve.normals)
    speed, bend = curve.spline(curve.t, 1), curve.spline(curve.t, 2)
    expected = np.linalg.norm(np.cross(speed, bend), axis=1) / np.linalg.norm(speed, axis=1) ** 3
    np.testing.assert_allclose(curve.curvature, expected, rtol=0.02, atol=0.02 * expected.max())
    with pytest.raises(ValueError, match="read-only"):
        curve.normals[0] = 0


def test_distances_are_exact(flat, mesh, picks):
    vertices = flat.vertices
    there = np.array([0.43, 0.31, 0.0])
    np.testing.assert_allclose(flat.distance([there]), np.linalg.norm(vertices - there, axis=1), atol=1e-12)
    two = [(0, (1, 0, 0)), (7, (0.2, 0.3, 0.5))]
    places = [np.asarray(weights) @ vertices[flat.faces[face]] for face, weights in two]
    nearest = np.min([np.linalg.norm(vertices - place, axis=1) for place in places], axis=0)
    np.testing.assert_allclose(flat.distance(two), nearest, atol=1e-12)
    line = Curve.from_points([[0.2, 0.51, 0], [0.8, 0.51, 0]], flat)
    beyond = np.maximum(np.abs(vertices[:, 0] - 0.5) - 0.3, 0)
    expected = np.hypot(beyond, vertices[:, 1] - 0.51)
    np.testing.assert_allclose(flat.distance(line), expected, atol=1e-12)
    np.testing.assert_allclose(flat.distance([line, flat.path([0, 0, 0], [1, 0, 0])]), np.minimum(expected, vertices[:, 1]), atol=1e-12)
    near = flat.distance(line, reach=0.2)
    np.testing.assert_array_equal(np.isfinite(near), expected <= 0.2)
    with pytest.raises(InputError, match=r"to\[1\] is 1 away from the mesh"):
        flat.distance([there, there + [0, 0, 1]])
    with pytest.raises(InputError, match="to is empty"):
        flat.distance([])
    with pytest.raises(bspline_curve.Cancelled):
        mesh.distance(picks, progress=lambda *_: False)
        raise bspline_curve.Cancelled  # where it ended before it was asked


def test_distances_end_where_the_surface_does(flat):
    vertices, faces = flat.vertices, flat.faces
    two = Mesh(np.r_[vertices, vertices + [3, 0, 0]], np.r_[faces, faces + len(vertices)])
    distances = two.distance([vertices[0]])
    assert np.isfinite(distances[: len(vertices)]).all() and np.isinf(distances[len(vertices):]).all()
    with pytest.raises(InputError, match="no way along the surface"):
        two.path(vertices[0], vertices[0] + [3, 0, 0])


def test_paths_are_as_long_as_distances(mesh, arrays):
    vertices = arrays[0]
    rng = np.random.default_rng(3)
    for start, end in rng.choice(len(vertices), (12, 2), replace=False):
        path = mesh.path(vertices[start], vertices[end])
        assert path.length == pytest.approx(mesh.distance([vertices[start]])[end], rel=1e-9)
        np.testing.assert_allclose(path.points[[0, -1]], vertices[[start, end]], atol=1e-12)
        assert mesh.imprint([path]).largest_move < 1e-9
    with pytest.raises(InputError, match="are one point"):
        mesh.path(vertices[0], vertices[0])
    with pytest.raises(InputError, match="end is 4.947 away"):
        mesh.path(vertices[0], vertices[0] + [0, 0, 5])
    with pytest.raises(InputError, match=r"start has shape \(2,\)"):
        mesh.path([0, 0], vertices[0])


def test_fields_and_faces_to_avoid_have_the_words_of_other_hosts(mesh, picks):
    height = np.array(mesh.vertices[:, 2])
    plain, along = mesh.curve(picks), mesh.curve(picks, field=height)
    same = lambda curve, other: np.array_equal(curve.points, other.points)  # noqa: E731
    assert same(mesh.curve(picks, field="none", avoid="none"), plain)
    assert same(mesh.curve(picks, field="auto"), plain)  # there is no quality
    assert same(mesh.curve(picks, field="quality", quality=height), along)
    own = Mesh(mesh.vertices, mesh.faces, quality=height)
    np.testing.assert_array_equal(own.quality, height)
    assert same(own.curve(picks, field="quality"), along)
    assert same(own.curve(picks, field="auto"), mesh.curve(picks, field=mesh.field("quality", quality=height, normalised=True)))
    assert same(own.curve(picks), plain)
    again = pickle.loads(pickle.dumps(own))
    assert same(again.curve(picks, field="quality").move(1, mesh.vertices[702]), along.move(1, mesh.vertices[702]))
    hill = mesh.field("obstacle", region=[1600, 1601], obstacle_value=0.5)
    assert same(mesh.curve(picks, field="obstacle", field_region=[1600, 1601], field_obstacle_value=0.5), mesh.curve(picks, field=hill))
    valley = mesh.field("valley", curvature_scale=0.05, inverted=True)
    named = mesh.curve(picks, field="valley", field_curvature_scale=0.05, field_inverted=True)
    assert same(named, mesh.curve(picks, field=valley, field_cost="exp-minus"))
    assert same(named.with_options(field_inverted=False, field_curvature_scale=0.015), mesh.curve(picks, field="valley"))
    ends = picks[[0, 3]]
    high = height[mesh.faces].mean(1) > 0.15
    round_it = mesh.curve(ends, avoid="over-threshold", avoid_threshold=0.15, quality=height)
    assert same(round_it, mesh.curve(ends, avoid=high)) and not high[round_it.faces].any()
    assert same(round_it.with_options(avoid="none"), mesh.curve(ends))
    for options, error, said in [
        ({"field": "quality"}, bspline_curve.FieldError, "quality is not given, and the mesh has none"),
        ({"field": "obstacle"}, bspline_curve.FieldError, "field_region is not given"),
        ({"avoid": "over-threshold"}, bspline_curve.OptionError, "needs a field or quality"),
        ({"avoid": "selected-faces"}, bspline_curve.OptionError, "avoid is 'selected-faces', but must be one of 'none'"),
    ]:
        with pytest.raises(error, match=said):
            mesh.curve(picks, **options)


def test_a_saved_curve_keeps_quality_and_thresholds(mesh, picks, tmp_path):
    height = np.array(mesh.vertices[:, 2])
    curve = mesh.curve(picks[[0, 3]], field="quality", quality=height, avoid="over-threshold", avoid_threshold=0.15)
    curve.save(tmp_path / "c.json")
    loaded = bspline_curve.load(tmp_path / "c.json", mesh)
    np.testing.assert_array_equal(loaded.with_options(tension=0.2).points, curve.with_options(tension=0.2).points)


def test_polylines_are_draped_along_a_direction(mesh):
    plan = np.array([[-0.5, -0.4, 9], [0.6, -0.3, 2], [0.1, 0.7, 9], [-0.5, -0.4, 9]])
    ring = bspline_curve.Curve.from_points(plan, mesh, direction=[0, 0, -1])
    assert ring.closed
    starts = ring.points[np.abs(ring.points[:, None, :2] - plan[None, :3, :2]).sum(2).argmin(0)]
    np.testing.assert_allclose(starts[:, :2], plan[:3, :2], rtol=0, atol=1e-14)
    assert len(mesh.segment(plan, direction=[0, 0, -1]).parts) == 2
    assert len(mesh.cut(plan, keep="inside", direction=(0, 0, -2)).faces) > 0
    with pytest.raises(InputError, match="is not near the mesh"):
        mesh.imprint(plan)
    with pytest.raises(InputError, match="away from the mesh along the direction"):
        mesh.imprint(plan, max_distance=3, direction=[0, 0, -1])
    for wrong in ([0, 0, 0], [0, 1], [0, 0, np.nan]):
        with pytest.raises(InputError, match="direction is"):
            mesh.imprint(plan, direction=wrong)


def test_a_draped_line_that_leaves_the_mesh_is_parted_with_a_warning(mesh):
    plan = np.array([[0.5, 0, 3], [2.0, 0, 3], [2.0, 0.5, 3], [0.5, 0.5, 3]])
    with pytest.warns(bspline_curve.MeshWarning, match=r"curves: along the direction it is beside the mesh 1 time \(first behind vertex 0\)"):
        assert len(mesh.imprint(plan, direction=[0, 0, -1]).curves) == 2
    with pytest.raises(InputError, match="2 curves, and one is needed here"):
        bspline_curve.Curve.from_points(plan, mesh, direction=[0, 0, -1])
    with pytest.raises(InputError, match="does not meet the mesh along the direction"):
        mesh.imprint(plan + [9, 0, 0], direction=[0, 0, -1])
