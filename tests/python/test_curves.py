# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves, and curves made from them."""
import copy
import json
import pickle
import subprocess

import bspline_curve
import numpy as np
import pytest
from made_meshes import write_obj
from scipy.interpolate import BSpline


def test_the_polyline_lies_on_the_faces_that_it_names(mesh, picks):
    curve = mesh.curve(picks)
    on_faces = (mesh.vertices[mesh.faces[curve.faces]] * curve.barycentrics[..., None]).sum(1)
    np.testing.assert_allclose(on_faces, curve.points, rtol=0, atol=1e-14)
    np.testing.assert_allclose(curve.points[curve.pick_vertices], picks, atol=1e-12)
    ends = curve.points[curve.segments()]
    assert np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum() == pytest.approx(curve.length)
    assert curve.usable and curve.report["status"] == "converged" and (np.diff(curve.t) > 0).all()
    np.testing.assert_array_equal(curve.picks, picks)
    assert curve.report["notes"] == []
    (note,) = mesh.curve(picks[[0, 0, *range(1, len(picks))]]).report["notes"]
    assert note.startswith("pick 2 is at the same point")


@pytest.mark.parametrize(("options", "words"), [
    ({}, []),
    ({"closed": True, "degree": 4, "tension": 0.2}, ["--closed", "--degree", "4", "--tension", "0.2"]),
    ({"preset": "paper", "samples": 60, "field": "valley"}, ["--preset", "paper", "--samples", "60", "--field", "valley"]),
    ({"field": "valley", "field_weight": 500}, ["--field", "valley", "--field-weight", "500"]),
    ({"avoid": [1600, 1601, 1602]}, ["--avoid", "avoid.npy"]),
])
def test_a_curve_is_the_programs(options, words, mesh, picks, build_folder, tmp_path):
    write_obj(tmp_path / "mesh.obj", mesh.vertices, mesh.faces)
    np.savetxt(tmp_path / "picks.xyz", picks, fmt="%.17g")
    np.save(tmp_path / "avoid.npy", options.get("avoid", []))
    command = [build_folder / "bin" / "bspline_curve", "mesh.obj", "--picks", "picks.xyz", "--output", "curve.json", *words]
    subprocess.run(command, cwd=tmp_path, check=True)
    line = json.loads((tmp_path / "curve.json").read_text())["polyline"]
    if "preset" in options:  # the program chooses the shell of the preset, too
        mesh = bspline_curve.Mesh(mesh.vertices, mesh.faces, shell="simplified")
    curve = mesh.curve(picks, **options)
    np.testing.assert_array_equal(curve.points, line["points"])
    np.testing.assert_array_equal(curve.faces, line["faces"])
    loaded = bspline_curve.load(tmp_path / "curve.json", mesh)
    np.testing.assert_array_equal(loaded.points, curve.points)


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("degree", [2, 3, 4])
def test_points_and_derivatives_are_of_the_spline(degree, closed, mesh, picks):
    curve = mesh.curve(picks, degree=degree, closed=closed)
    spline = BSpline(curve.knots, curve.control_points, degree)
    at = np.random.default_rng(5).uniform(0, 1, 200).reshape(20, 10)
    for order in range(degree + 2):
        expected = spline(at, nu=order)
        np.testing.assert_allclose(curve.spline(at, order), expected, rtol=0, atol=1e-9 * max(1, np.abs(expected).max()))
    assert curve.spline(0.5).shape == (3,)
    np.testing.assert_allclose(curve.spline(curve.pick_parameters), picks, atol=1e-9)
    if closed:
        np.testing.assert_array_equal(curve.spline(1.25), curve.spline(0.25))
    else:
        with pytest.raises(bspline_curve.InputError, match=r"an open curve has \[0, 1\]"):
            curve.spline([0.5, 1.5])


def test_a_curve_is_moved_and_changed(mesh, picks):
    curve = mesh.curve(picks, tension=0.1)
    there = mesh.vertices[702]
    moved = curve.move(1, there)
    np.testing.assert_array_equal(moved.picks, [picks[0], there, picks[2], picks[3]])
    np.testing.assert_allclose(moved.points[moved.pick_vertices[1]], there, atol=1e-12)
    np.testing.assert_array_equal(curve.picks, picks)
    scratch = mesh.curve(moved.picks, tension=0.1)
    assert moved.length == pytest.approx(scratch.length, rel=1e-3)
    assert len(curve.remove(-1).picks) == 3
    np.testing.assert_array_equal(curve.remove(1).points, mesh.curve(picks[[0, 2, 3]], tension=0.1).points)
    np.testing.assert_array_equal(curve.insert(1, there).picks, [picks[0], there, *picks[1:]])
    np.testing.assert_array_equal(curve.insert(4, there).picks, [*picks, there])
    straight = curve.with_options(tension=0.5, closed=True)
    assert straight.closed and straight.options == {"tension": 0.5, "closed": True}
    np.testing.assert_array_equal(straight.points, mesh.curve(picks, tension=0.5, closed=True).points)
    assert curve.with_options(tension=0.0).options == {}
    for bad in (4, -5):
        with pytest.raises(bspline_curve.PickError, match="pick is"):
            curve.move(bad, there)


def test_picks_may_be_faces_with_barycentrics(mesh):
    given = [(100, (0.2, 0.3, 0.5)), (1500, [1, 0, 0]), (2500, np.array([0.5, 0.5, 0]))]
    curve = mesh.curve(given)
    points = [np.asarray(weights) @ mesh.vertices[mesh.faces[face]] for face, weights in given]
    np.testing.assert_array_equal(curve.points, mesh.curve(points).points)
    there = (1700, (1 / 3, 1 / 3, 1 / 3))
    np.testing.assert_allclose(curve.move(1, there).picks[1], mesh.vertices[mesh.faces[1700]].mean(0), atol=1e-15)


def test_a_field_draws_the_curve(mesh, picks):
    values = mesh.field("valley")
    named, given = mesh.curve(picks, field="valley"), mesh.curve(picks, field=values, field_cost="exp-minus")
    np.testing.assert_array_equal(named.points, given.points)
    assert named.length != mesh.curve(picks).length
    corners = values[mesh.faces[named.faces]]
    np.testing.assert_array_equal(named.values, (corners * named.barycentrics).sum(1))
    plain = mesh.curve(picks)
    np.testing.assert_array_equal(plain.values, plain.t)
    hill = mesh.field("obstacle", region=[1600, 1601], obstacle_value=0.5)
    assert hill.max() >= 0.5 and hill.min() == 0
    np.testing.assert_allclose(mesh.field("quality", quality=values, inverted=True), values.max() + values.min() - values, atol=1e-12)


def test_faces_are_avoided(mesh, picks):
    straight = mesh.curve(picks[:2])
    centres = mesh.vertices[mesh.faces].mean(1)
    middle = straight.points[len(straight.points) // 2]
    disc = np.linalg.norm(centres - middle, axis=1) < 0.2
    curve = mesh.curve(picks[:2], avoid=disc)
    assert disc[straight.faces].any() and not disc[curve.faces].any()
    np.testing.assert_array_equal(mesh.curve(picks[:2], avoid=np.flatnonzero(disc)).points, curve.points)
    assert curve.report["clearance"] > 0


@pytest.mark.parametrize("again", [lambda c: pickle.loads(pickle.dumps(c)), copy.deepcopy])
def test_curves_and_meshes_are_pickled(again, mesh, picks):
    curve = mesh.curve(picks, closed=True, tension=0.1, field=mesh.field("ridge"), avoid=[3000, 2998])
    other = again(curve)
    for name in ("points", "faces", "barycentrics", "t", "values", "knots", "control_points", "pick_vertices", "picks"):
        np.testing.assert_array_equal(getattr(other, name), getattr(curve, name))
    assert (other.report, other.options, other.closed, repr(other)) == (curve.report, curve.options, True, repr(curve))
    assert other.mesh is mesh  # the equal one that is there
    np.testing.assert_array_equal(other.move(1, mesh.vertices[702]).points, curve.move(1, mesh.vertices[702]).points)


def test_a_saved_curve_is_the_same_again(mesh, picks, tmp_path):
    curve = mesh.curve(picks, tension=0.1, field=mesh.field("ridge"))
    curve.save(tmp_path / "c.json")
    loaded = bspline_curve.load(tmp_path / "c.json", mesh)
    np.testing.assert_array_equal(loaded.points, curve.points)
    assert (loaded.options, loaded.report["seconds"]) == (curve.options, curve.report["seconds"])
    np.testing.assert_array_equal(loaded.move(1, mesh.vertices[702]).points, curve.move(1, mesh.vertices[702]).points)
    assert [path.name for path in tmp_path.iterdir()] == ["c.json"]


def test_files_that_are_no_curves_are_refused(mesh, picks, tmp_path):
    curve = mesh.curve(picks)
    curve.save(tmp_path / "c.json")
    text = (tmp_path / "c.json").read_text()
    refused = {
        "is no curve": ("{}", mesh),
        "cut": (text[: len(text) // 2], mesh),
        "of another mesh": (text, bspline_curve.Mesh(mesh.vertices * 2, mesh.faces)),
        "of a mesh without a name": (text.replace('"mesh"', '"no"'), bspline_curve.Mesh(mesh.vertices * 2, mesh.faces)),
        "of a mesh that changed": (text, bspline_curve.Mesh(np.vstack([mesh.vertices, [[0.0, 0.0, 0.0]]]), mesh.faces)),
        "faces": (text.replace('"faces": [', '"faces": [99999, '), mesh),
    }
    for name, (content, on) in refused.items():
        (tmp_path / f"{name}.json").write_text(content)
        with pytest.raises(bspline_curve.FileError, match="holds no curve|another mesh"):
            bspline_curve.load(tmp_path / f"{name}.json", on)
    for file in (tmp_path / "gone.json", tmp_path):
        with pytest.raises(bspline_curve.FileError, match="cannot be read"):
            bspline_curve.load(file, mesh)
    for file in (tmp_path / "c.png", tmp_path / "nowhere" / "c.json"):
        with pytest.raises(bspline_curve.FileError, match="is saved as .json|cannot be written"):
            curve.save(file)


def test_repr_is_short(mesh, picks):
    assert repr(mesh) == "<bspline_curve.Mesh: 1681 vertices, 3200 faces>"
    assert len(repr(mesh.curve(picks))) < 100
    assert bspline_curve.__version__.count(".") == 2


def test_a_curve_is_saved_for_cad(mesh, picks, tmp_path):
    curve = mesh.curve(picks, closed=True)
    for name in ("c.step", "c.igs", "c.polyline.stp", "c.polyline.iges"):
        curve.save(tmp_path / name, unit="in")
    step, polyline = ((tmp_path / name).read_text() for name in ("c.step", "c.polyline.stp"))
    assert step.startswith("ISO-10303-21;") and "CONVERSION_BASED_UNIT('INCH'" in step
    assert step.count("CARTESIAN_POINT") == len(curve.control_points)
    assert polyline.count("CARTESIAN_POINT") == len(curve.points) + 1
    assert (tmp_path / "c.igs").read_text().count("\n     126") == 2
    assert (tmp_path / "c.polyline.iges").read_text().count("\n     106") == 2
    with pytest.raises(bspline_curve.OptionError, match="unit"):
        curve.save(tmp_path / "c.step", unit="mile")


@pytest.mark.parametrize("field", [None, "ridge"])
def test_a_curve_is_saved_as_the_program_saves_it(mesh, picks, build_folder, tmp_path, field):
    write_obj(tmp_path / "mesh.obj", mesh.vertices, mesh.faces)
    np.savetxt(tmp_path / "picks.xyz", picks, fmt="%.17g")
    curve = mesh.curve(picks, closed=True, field=field)
    ends = ["ply", "obj", "bspline.obj", "dxf", "bspline.dxf", "vtu", "csv", "step", "polyline.igs"]
    words = ["--picks", "picks.xyz", "--closed", *(["--field", field] if field else [])]
    for end in ends:
        command = [build_folder / "bin" / "bspline_curve", "mesh.obj", *words, "--output", f"program.{end}"]
        subprocess.run(command, cwd=tmp_path, check=True)
        curve.save(tmp_path / f"python.{end}")
        ours, theirs = ((tmp_path / f"{host}.{end}").read_bytes() for host in ("python", "program"))
        assert ours == theirs, end


@pytest.mark.parametrize("end", ["ply", "obj", "off", "stl"])
def test_a_mesh_is_read_from_a_file(mesh, end, tmp_path):
    import trimesh

    file = tmp_path / f"mesh.{end}"
    trimesh.Trimesh(mesh.vertices, mesh.faces, process=False).export(file)
    read = bspline_curve.Mesh.load(file, shell_thickness=0.5)
    assert len(read.faces) == len(mesh.faces) and read.quality is None
    np.testing.assert_allclose(read.vertices[read.faces], mesh.vertices[mesh.faces], atol=1e-6)
    for name, said in (("none.ply", "none.ply"), ("mesh.gif", "extension .* is none of .ply")):
        with pytest.raises(bspline_curve.FileError, match=said):
            bspline_curve.Mesh.load(tmp_path / name)


def test_a_mesh_is_read_with_its_quality(mesh, picks, tmp_path):
    height = mesh.vertices[:, 2]
    rows = "".join(f"{x!r} {y!r} {z!r} {q!r}\n" for (x, y, z), q in zip(mesh.vertices.tolist(), height.tolist()))
    rows += "".join(f"3 {a} {b} {c}\n" for a, b, c in mesh.faces.tolist())
    head = "".join(f"property double {name}\n" for name in ("x", "y", "z", "quality"))
    (tmp_path / "mesh.ply").write_text(
        f"ply\nformat ascii 1.0\nelement vertex {len(height)}\n{head}element face {len(mesh.faces)}\n"
        f"property list uchar int vertex_indices\nend_header\n{rows}"
    )
    read = bspline_curve.Mesh.load(tmp_path / "mesh.ply")
    np.testing.assert_array_equal(read.quality, height)
    np.testing.assert_array_equal(read.curve(picks, field="quality").points, mesh.curve(picks, field=np.array(height)).points)


def test_files_of_several_curves_and_of_made_ones_are_read(mesh, picks, tmp_path):
    curve = mesh.curve(picks)
    made = [curve.trim(0.2, 0.6), curve.reversed(), *curve.offset(0.05), bspline_curve.Curve.from_points(curve.points, mesh)]
    for i, each in enumerate(made):
        each.save(tmp_path / f"{i}.json")
        loaded = bspline_curve.load(tmp_path / f"{i}.json", mesh)
        np.testing.assert_array_equal(loaded.points, each.points)
        assert loaded._drawing.fixed == each._drawing.fixed
    documents = [json.loads((tmp_path / f"{i}.json").read_text()) for i in range(len(made))]
    (tmp_path / "all.json").write_text(json.dumps({"curves": documents, "mesh": documents[0]["mesh"]}))
    for loaded, each in zip(bspline_curve.load_all(tmp_path / "all.json", mesh), made, strict=True):
        np.testing.assert_array_equal(loaded.points, each.points)
    with pytest.raises(bspline_curve.FileError, match=rf"holds {len(made)} curves: load_all\(\) reads them"):
        bspline_curve.load(tmp_path / "all.json", mesh)
    (tmp_path / "none.json").write_text(json.dumps({"curves": [{"closed": False}]}))
    with pytest.raises(bspline_curve.FileError, match="an entry 'polyline' is missing"):
        bspline_curve.load(tmp_path / "none.json", mesh)


@pytest.mark.parametrize("closed", [False, True])
def test_samples_are_at_equal_steps_on_the_mesh_with_frames(mesh, picks, closed):
    curve = mesh.curve(picks, closed=closed)
    samples = curve.sample(30)
    on_faces = (mesh.vertices[mesh.faces[samples.faces]] * samples.barycentrics[..., None]).sum(1)
    np.testing.assert_allclose(on_faces, samples.points, rtol=0, atol=1e-12)
    np.testing.assert_allclose(np.diff(samples.distances), curve.length / (30 if closed else 29), rtol=1e-12)
    np.testing.assert_allclose(samples.points[0], curve.points[0], atol=1e-12)
    if not closed:
        np.testing.assert_allclose(samples.points[-1], curve.points[-1], atol=1e-12)
    frames = np.stack([samples.tangents, samples.left, samples.normals], axis=1)
    np.testing.assert_allclose(frames @ frames.transpose(0, 2, 1), np.broadcast_to(np.eye(3), frames.shape), atol=1e-12)
    np.testing.assert_allclose(np.linalg.det(frames), 1, atol=1e-12)
    chords = np.diff(samples.points, axis=0)
    assert ((chords * samples.tangents[:-1]).sum(1) > 0.8 * np.linalg.norm(chords, axis=1)).all()
    parts = samples.normal_curvature**2 + samples.geodesic_curvature**2
    np.testing.assert_allclose(samples.curvature**2, parts, rtol=1e-9, atol=1e-9)
    again = curve.sample(distances=samples.distances[[3, 7]])
    np.testing.assert_array_equal(again.points, samples.points[[3, 7]])


def test_samples_that_are_not_on_the_curve_are_refused(mesh, picks):
    curve = mesh.curve(picks)
    for arguments in ({}, {"count": 3, "distances": [0.0]}, {"count": 1}, {"distances": [2 * curve.length]},
                      {"distances": [np.nan]}):
        with pytest.raises(bspline_curve.InputError):
            curve.sample(**arguments)


def test_a_curve_may_pass_beside_its_picks(mesh, picks):
    reach = 0.1 * np.linalg.norm(picks[1] - picks[0])
    through = mesh.curve(picks)
    near = mesh.curve(picks, pick_tolerance=reach)
    distances = np.array(near.report["pick_distances"])
    assert distances.shape == (4,) and 0.1 * reach < distances.max() <= reach
    assert through.report["pick_distances"] == []
    edges = mesh.curve(picks, pick_tolerance="0.5 edges")
    assert edges.usable and len(edges.report["pick_distances"]) == 4
    # A pick that is moved goes on from the picks as they were given.
    assert np.array_equal(near.move(0, picks[0]).points, near.points)
    with pytest.raises(TypeError, match="pick_tolerance"):
        mesh.curve(picks, pick_tolerance=True)
    with pytest.raises(ValueError, match="must be a length"):
        mesh.curve(picks, pick_tolerance="far")


def test_each_pick_may_have_a_tolerance_of_its_own(mesh, picks):
    reach = 0.1 * np.linalg.norm(picks[1] - picks[0])
    near = mesh.curve(picks, pick_tolerance=[0, reach, reach, "weight 1e9"])
    distances = np.array(near.report["pick_distances"])
    assert distances[0] < 1e-9 and 0.1 * reach < distances[1:3].max() and distances.max() <= reach
    assert near.options["pick_tolerance"] == ("0.0", repr(float(reach)), repr(float(reach)), "weight 1e9")
    assert np.array_equal(mesh.curve(picks, pick_tolerance=[reach] * 4).points, mesh.curve(picks, pick_tolerance=reach).points)
    assert np.array_equal(mesh.curve(picks, pick_tolerance=np.full(4, reach)).points, mesh.curve(picks, pick_tolerance=reach).points)
    # They go with their picks; a new pick has that of the one before it.
    assert [float(each) > 0 for each in near.remove(3).options["pick_tolerance"]] == [False, True, True]
    added = near.insert(1, mesh.project(0.5 * (picks[:1] + picks[1:2])).points[0]).options["pick_tolerance"]
    assert added == ("0.0", *near.options["pick_tolerance"])
    assert near.reversed().options["pick_tolerance"] == near.options["pick_tolerance"][::-1]
    assert near.with_options(pick_tolerance=0.0).report["pick_distances"] == []
    again = pickle.loads(pickle.dumps(near))
    assert again.options == near.options


@pytest.mark.parametrize(
    ("tolerances", "error", "said"),
    [([0.1, 0.1], ValueError, "2 pick tolerances for 4 picks"), ([], ValueError, "for each pick"), ([0.1, None, 0, 0], TypeError, r"\[1\]"),
     ([0, 0, -1, 0], ValueError, "not negative"), ("weight 0", ValueError, "above 0"), ({0: 1.0}, TypeError, "pick_tolerance")],
)
def test_tolerances_that_are_none_are_refused(tolerances, error, said, mesh, picks):
    with pytest.raises(error, match=said):
        mesh.curve(picks, pick_tolerance=tolerances)


def test_picks_may_be_farther_from_the_mesh_where_that_is_asked_for(mesh, picks):
    far = picks + [0, 0, 0.3]
    with pytest.raises(bspline_curve.PickError, match="1 % of the diagonal"):
        mesh.curve(far)
    with pytest.raises(bspline_curve.PickError, match="more than is allowed"):
        mesh.curve(far, pick_distance=0.01)
    curve = mesh.curve(far, pick_distance=0.4)
    assert curve.usable
    ends = mesh.project(far[[0, -1]]).points
    np.testing.assert_allclose(curve.points[[0, -1]], ends, rtol=0, atol=1e-12)
    assert curve.move(1, far[1]).usable


def full_knots(curve):
    """Parameters of knots between 0 and 1 that are not simple, and of a closed curve that at 0."""
    values, counts = np.unique(curve.knots, return_counts=True)
    inside = (values < 1) & ((values >= 0) if curve.closed else (values > 0))
    assert set(counts[inside]) <= {1, curve.degree}
    return values[inside & (counts > 1)]


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("degree", [2, 3, 4])
def test_a_curve_turns_at_its_corners(degree, closed, mesh, picks):
    curve = mesh.curve(picks, degree=degree, closed=closed, corners=[2, 1])
    np.testing.assert_array_equal(full_knots(curve), curve.pick_parameters[[1, 2]])
    np.testing.assert_allclose(curve.spline(curve.pick_parameters), picks, atol=1e-9)
    assert curve.options["corners"] == (1, 2)
    everywhere = mesh.curve(picks, degree=degree, closed=closed, corners="all")
    assert len(full_knots(everywhere)) == (len(picks) if closed else len(picks) - 2)
    between = mesh.curve(picks[1:3], degree=degree)
    np.testing.assert_array_equal(between.points, curve.points[curve.pick_vertices[1] : curve.pick_vertices[2] + 1])


def test_corners_stay_with_their_picks(mesh, picks, tmp_path):
    curve = mesh.curve(picks, corners=[1])
    before, middle = mesh.project([picks[:2].mean(0), picks[1:3].mean(0)]).points
    assert curve.move(2, picks[2]).options["corners"] == (1,)
    assert curve.insert(1, before).options["corners"] == (2,)
    assert curve.insert(2, middle).options["corners"] == (1,)
    assert curve.remove(0).options["corners"] == (0,)
    assert "corners" not in curve.remove(1).options
    assert curve.remove(2).options["corners"] == (1,)
    curve.save(tmp_path / "curve.json")
    again = bspline_curve.load(tmp_path / "curve.json", mesh)
    assert again.options["corners"] == (1,)
    np.testing.assert_array_equal(full_knots(again), curve.pick_parameters[[1]])
    smooth = again.with_options(corners=())
    assert not len(full_knots(smooth))
    document = json.loads((tmp_path / "curve.json").read_text())
    del document["drawn_by"]  # as the program writes it
    (tmp_path / "program.json").write_text(json.dumps(document))
    assert bspline_curve.load(tmp_path / "program.json", mesh).options["corners"] == (1,)
    assert "tangents" not in document
    # Samples take tangents from the spline, at a corner those behind it.
    at = curve.length * np.linspace(0, 1, 50)
    samples = curve.sample(distances=at)
    np.testing.assert_allclose(np.linalg.norm(samples.tangents, axis=1), 1.0)


@pytest.mark.parametrize(
    ("corners", "error"),
    [([4], ValueError), ([-1], ValueError), ("1,2", ValueError), ([0.5], TypeError), (1, TypeError), ([[1]], TypeError)],
)
def test_corners_that_are_none_are_refused(corners, error, mesh, picks):
    with pytest.raises(error, match="corner"):
        mesh.curve(picks, corners=corners)


@pytest.mark.parametrize("degree", [2, 3, 4])
def test_a_curve_passes_picks_in_given_directions(degree, mesh, picks, tmp_path):
    directions = {0: (0.0, 1.0, 0.3), 2: picks[3] - picks[1]}
    curve = mesh.curve(picks, degree=degree, tangents=directions)
    assert [each["pick"] for each in curve.report["tangents"]] == [0, 2]
    for each in curve.report["tangents"]:
        assert each["angle_of_spline"] < 1e-6 and each["angle_of_polyline"] < 0.3
        slope = curve.spline(curve.pick_parameters[each["pick"]], derivative=1)
        along = directions[each["pick"]] / np.linalg.norm(directions[each["pick"]])
        # The direction's part along the surface: they differ by a part along the normal alone.
        assert slope @ along > 0.5 * np.linalg.norm(slope)
    curve.save(tmp_path / "curve.json")
    again = bspline_curve.load(tmp_path / "curve.json", mesh)
    assert again.options["tangents"] == curve.options["tangents"]
    np.testing.assert_array_equal(again.with_options().points, curve.points)
    assert [pick for pick, _ in curve.insert(1, mesh.project(picks[:1] * 0.9).points[0]).options["tangents"]] == [0, 3]
    assert [pick for pick, _ in curve.remove(0).options["tangents"]] == [1]
    assert "tangents" not in curve.with_options(tangents=None).options


@pytest.mark.parametrize("sides", [((0.0, 1.0, 0.3), (1.0, 0.2, 0.1)), (None, (1.0, 0.2, 0.1)), ((0.0, 1.0, 0.3), None)])
def test_a_corner_has_a_direction_on_either_side(sides, mesh, picks, tmp_path):
    curve = mesh.curve(picks, corners=[1], tangents={1: sides})
    (met,) = curve.report["tangents"]
    assert met["pick"] == 1 and met["angle_of_spline"] < 1e-6
    step = 1e-7
    at = curve.pick_parameters[1]
    for side, asked in zip((-step, step), sides):
        if asked is not None:
            way = (curve.spline(at + side) - curve.spline(at)) / side
            assert way @ np.array(asked) > 0.5 * np.linalg.norm(way)
    curve.save(tmp_path / "curve.json")
    again = bspline_curve.load(tmp_path / "curve.json", mesh)
    assert again.options["tangents"] == curve.options["tangents"] == ((1, sides),)
    np.testing.assert_array_equal(again.with_options().points, curve.points)
    turned = curve.reversed()
    before, after = sides
    ((pick, directions),) = turned.options["tangents"]
    assert pick == 2
    for found, wanted in zip(directions, (after, before)):
        assert (found is None) == (wanted is None)
        assert found is None or found == tuple(-x for x in wanted)
    with pytest.raises(bspline_curve.InputError, match="only a corner can have"):
        mesh.curve(picks, tangents={1: ((0, 1, 0), (1, 0, 0))})


@pytest.mark.parametrize(
    ("tangents", "error"),
    [({4: (1, 0, 0)}, ValueError), ({1: (None, None)}, ValueError), ({1: ((1, 0, 0), (1, 0))}, TypeError), ({-1: (1, 0, 0)}, ValueError), ({0: (0, 0, 0)}, ValueError), ({0: (1, 0)}, TypeError),
     ({"a": (1, 0, 0)}, TypeError), ("1:1,0,0", TypeError), (1, TypeError)],
)
def test_tangents_that_are_none_are_refused(tangents, error, mesh, picks):
    with pytest.raises(error, match="tangent"):
        mesh.curve(picks, tangents=tangents)
