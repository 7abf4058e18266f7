# SPDX-License-Identifier: GPL-3.0-or-later
"""meshlabserver 2020.09 draws what pymeshlab draws, from the same scripts, and says what is wrong."""
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import polylines
import pymeshlab
import pytest
from meshlabserver import run_server

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("BSPLINE_CURVE_BUILD", ROOT / "build" / "release"))
EXAMPLES = ROOT / "examples"
SCRIPTS = sorted(path.name for path in (EXAMPLES / "mlx").glob("*.mlx"))
CURVE = "generate_bspline_curve_on_surface"
FIELD = "compute_scalar_field_for_curves_per_vertex"
FIT = "fit_curve_to_selection_boundary"
CUT, SEGMENT = "cut_along_curves", "segment_by_curves"
ALL_OPTIONS = CURVE + "_all_options"
SPHERE_PICKS = "1 0 0; 0 1 0; 0 0 1; -1 0 0"

# MeshLab writes OBJ with six decimals; the bunny's diagonal is 1 and the sphere's 3.5.
ROUNDING = 1e-6


@pytest.fixture
def serve(display, prefix):
    return lambda *words, cwd=None: run_server(display, prefix, *words, cwd=cwd)


def diagonal(vertices):
    return np.linalg.norm(np.ptp(vertices, axis=0))


def drawn_by_pymeshlab(mesh, script):
    """Vertices and edges of the curve, and those of the mesh."""
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(mesh))
    surface = document.current_mesh().vertex_matrix(), document.current_mesh().face_matrix()
    document.load_filter_script(str(script))
    document.apply_filter_script()
    curve = document.current_mesh()
    return (curve.vertex_matrix(), curve.edge_matrix()), surface


def picks_of(text):
    return np.array([[float(x) for x in pick.split()] for pick in text.split(";")])


def test_the_example_scripts_list_every_parameter():
    script = ROOT / "scripts" / "example_scripts.py"
    done = subprocess.run([sys.executable, script, "--check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", SCRIPTS)
def test_an_example_draws_the_same_curve_in_both_hosts(
    name, serve, bunny, tmp_path, loaded_plugin, monkeypatch, example_scripts
):
    monkeypatch.chdir(EXAMPLES)  # where the paths in the scripts begin
    run = serve("-i", bunny, "-s", EXAMPLES / "mlx" / name, "-o", tmp_path / "curve.obj", cwd=EXAMPLES)
    assert run.status == 0, run.output
    figures = run.figures[-1]
    assert figures["usable"] == "true" and figures["converged"] == "true"
    is_closed = "closed" in name
    assert figures["closed"] == str(is_closed).lower()

    vertices, edges = polylines.read_obj(tmp_path / "curve.obj")
    assert edges.tolist() == polylines.in_order(vertices, is_closed)
    assert len(vertices) == int(figures["vertices"])
    # Each end of each segment is rounded.
    assert polylines.length(vertices, edges) == pytest.approx(float(figures["length"]), abs=len(edges) * ROUNDING)

    (expected, expected_edges), (surface, faces) = drawn_by_pymeshlab(bunny, f"mlx/{name}")
    assert polylines.distance((vertices, edges), (expected, expected_edges)) <= 1e-5 * diagonal(surface)
    assert polylines.distance_to_mesh(vertices, surface, faces) <= 2 * ROUNDING
    picks = picks_of(example_scripts.BUNNY_PICKS)
    assert polylines.distance_to(picks, vertices, edges) <= 2 * ROUNDING


def test_the_commands_of_readme_draw_a_curve_from_nothing(prefix, readme_commands, display, checkout):
    # The window is opened in test_window.py.
    commands = [command for command in readme_commands if "/bin/meshlab " not in command]
    assert len(commands) == len(readme_commands) - 1
    done = display.run(["bash", "-e", "-c", "\n".join(commands)], cwd=checkout)
    assert done.returncode == 0, done.stdout + done.stderr
    assert (checkout / "build" / "meshlab-2020.09" / "bin" / "meshlab").is_file()
    vertices, edges = polylines.read_obj(checkout / "examples" / "curve.obj")
    assert len(edges) == len(vertices) - 1 > 100


def test_the_commands_of_the_page_work(prefix, display, checkout):
    page = (ROOT / "docs" / "MESHLAB.md").read_text()
    commands = re.search(r"## meshlabserver\n\n((?:    .*\n)+)", page).group(1)
    (checkout / "build" / "meshlab-2020.09").symlink_to(prefix)
    done = display.run(["bash", "-e", "-c", commands], cwd=checkout)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "\npreparing the surface\nbuilding the shell\n" in done.stdout and "\ndone\nshell=" in done.stdout, "lines"
    vertices, edges = polylines.read_obj(checkout / "examples" / "curve.obj")
    assert len(edges) == len(vertices) - 1 > 100


def test_an_example_asks_for_what_it_says(example_scripts):
    assert set(SCRIPTS) == set(example_scripts.EXAMPLES)


def test_quality_of_the_curve_is_the_field_or_t(serve, sphere, write_script, tmp_path):
    script = write_script((CURVE, {"picks": SPHERE_PICKS}))
    run = serve("-i", sphere, "-s", script, "-o", tmp_path / "curve.ply", "-m", "vq")
    assert run.status == 0, run.output
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(tmp_path / "curve.ply"))
    t = document.current_mesh().vertex_scalar_array()
    assert (np.diff(t) > 0).all()


def test_the_field_becomes_the_quality(serve, sphere, write_script, tmp_path, loaded_plugin):
    script = write_script((FIELD, {"kind": "maximal-curvature"}))
    run = serve("-i", sphere, "-s", script, "-o", tmp_path / "field.ply", "-m", "vq")
    assert run.status == 0, run.output
    minimum, mean, maximum = (float(run.figures[-1][key]) for key in ("minimum", "mean", "maximum"))
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(tmp_path / "field.ply"))
    written = document.current_mesh().vertex_scalar_array()
    assert (written.min(), written.mean(), written.max()) == pytest.approx((minimum, mean, maximum), rel=1e-5)
    document.load_new_mesh(str(sphere))
    document.apply_filter(FIELD, kind="maximal-curvature")
    expected = document.current_mesh().vertex_scalar_array()
    np.testing.assert_allclose(written, expected, rtol=1e-6)  # float against double


def test_picks_of_a_layer_and_matrices_of_a_project(serve, sphere, write_script, tmp_path):
    picks = picks_of(SPHERE_PICKS)
    (tmp_path / "picks.xyz").write_text("".join(" ".join(map(str, pick)) + "\n" for pick in picks))
    matrix = "0 -1 0 5 \n1 0 0 0 \n0 0 1 0 \n0 0 0 1 \n"
    identity = "1 0 0 0 \n0 1 0 0 \n0 0 1 0 \n0 0 0 1 \n"
    layers = [(sphere, matrix), (tmp_path / "picks.xyz", matrix)]
    lines = [f'<MLMesh label="{p.name}" filename="{p}"><MLMatrix44>\n{m}</MLMatrix44></MLMesh>' for p, m in layers]
    text = "<!DOCTYPE MeshLabDocument><MeshLabProject><MeshGroup>%s</MeshGroup></MeshLabProject>"
    (tmp_path / "moved.mlp").write_text(text % "".join(lines))
    (tmp_path / "still.mlp").write_text(text % "".join(lines).replace(matrix, identity))
    script = write_script((CURVE, {"surface_layer": 0, "picks_layer": 1}))
    curves = []
    for project in ("moved", "still"):
        out = tmp_path / f"{project}.obj"
        run = serve("-p", tmp_path / f"{project}.mlp", "-s", script, "-o", out)
        assert run.status == 0, run.output
        curves.append(polylines.read_obj(out))
    # The layer has the surface's coordinates and matrix, so both are the same in it.
    assert polylines.distance(*curves) <= 2e-5
    assert polylines.distance_to(picks, *curves[0]) <= 2e-5


def test_a_boundary_becomes_the_same_curve_as_in_pymeshlab(serve, sphere, write_script, tmp_path, loaded_plugin):
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(sphere))
    faces = document.current_mesh().face_matrix()
    middles = document.current_mesh().vertex_matrix()[faces].mean(1)
    labels = (middles[:, 2] > 0.3).astype(float)
    labelled = pymeshlab.MeshSet()
    labelled.add_mesh(pymeshlab.Mesh(document.current_mesh().vertex_matrix(), faces, f_scalar_array=labels))
    labelled.save_current_mesh(str(tmp_path / "labelled.ply"), save_face_quality=True)
    script = write_script((FIT, {"boundaries": "face-quality"}))
    run = serve("-i", tmp_path / "labelled.ply", "-s", script, "-o", tmp_path / "fitted.obj")
    assert run.status == 0, run.output
    assert run.figures[-1]["curves"] == "1"
    expected = labelled.apply_filter(FIT, boundaries="face-quality")
    assert float(run.figures[-1]["length"]) == pytest.approx(expected["length"], rel=1e-5)


def test_a_second_curve_needs_no_second_shell(serve, sphere, write_script, tmp_path):
    other = "1 0 0; 0 -1 0; 0 0 -1"
    script = write_script((CURVE, {"picks": SPHERE_PICKS}), (CURVE, {"picks": other}))
    run = serve("-i", sphere, "-s", script, "-o", tmp_path / "second.obj")
    assert run.status == 0, run.output
    first, second = run.figures[0], run.figures[-1]  # it prints what it logged before once more
    assert (first["surface_kept"], second["surface_kept"]) == ("false", "true")
    assert polylines.distance_to(picks_of(other), *polylines.read_obj(tmp_path / "second.obj")) <= 2 * ROUNDING


def test_the_filter_saves_the_curve_and_adds_a_tube(serve, sphere, write_script, tmp_path):
    saved = tmp_path / "saved.json"
    script = write_script((CURVE, {"picks": SPHERE_PICKS, "tube_radius": 0.02, "save": str(saved)}))
    run = serve("-i", sphere, "-s", script, "-o", tmp_path / "curve.obj", "-o", tmp_path / "tube.ply", "-l", "x")
    assert run.status == 0, run.output
    points = np.array(json.loads(saved.read_text())["polyline"]["points"])
    vertices, edges = polylines.read_obj(tmp_path / "curve.obj")
    np.testing.assert_allclose(vertices, points, atol=ROUNDING)
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(tmp_path / "tube.ply"))
    assert document.get_topological_measures()["boundary_edges"] == 0
    tube = document.current_mesh()
    distance = polylines.distance_to_mesh(vertices, tube.vertex_matrix(), tube.face_matrix())
    assert 0.015 < distance < 0.021  # a tube with corners is a little thinner between them


RING = {"picks": "0.8 0 0.6; 0 0.8 0.6; -0.8 0 0.6; 0 -0.8 0.6", "closed": True}
SPHERE_AREA = 4 * np.pi


def test_a_hole_is_cut_along_a_curve_and_filled(serve, sphere, write_script, tmp_path):
    script = write_script((CURVE, RING), (CUT, {"keep": "largest", "fill": "smooth"}))
    run = serve("-i", sphere, "-s", script, "-o", tmp_path / "filled.ply")
    assert run.status == 0, run.output
    figures = run.figures[-1]
    assert (figures["curves"], figures["projected_curves"], figures["parts"], figures["filled_holes"]) == ("1", "0", "2", "1")
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(tmp_path / "filled.ply"))
    assert document.get_topological_measures()["boundary_edges"] == 0
    assert document.get_geometric_measures()["surface_area"] == pytest.approx(SPHERE_AREA, rel=0.01)


def test_segments_are_in_the_log_and_in_the_quality_of_faces(serve, sphere, write_script, tmp_path):
    run = serve("-i", sphere, "-s", write_script((CURVE, RING), (SEGMENT, {})), "-o", tmp_path / "parts.ply", "-m", "fq")
    assert run.status == 0, run.output
    table = [f for f in run.figures if "part" in f][-2:]
    assert [f["part"] for f in table] == ["0", "1"]
    assert sum(float(f["area"]) for f in table) == pytest.approx(SPHERE_AREA, rel=0.01)
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(tmp_path / "parts.ply"))
    counts = np.bincount(document.current_mesh().face_scalar_array().astype(int))
    assert counts.tolist() == [int(f["faces"]) for f in table]


def test_paths_that_the_window_took_as_text_are_read(serve, sphere, write_script, tmp_path):
    (tmp_path / "picks.xyz").write_text(SPHERE_PICKS.replace("; ", "\n"))
    script = write_script((CURVE, {"picks_file": str(tmp_path / "picks.xyz"), "save": str(tmp_path / "saved.csv")}))
    script.write_text(script.read_text().replace("RichOpenFile", "RichString").replace("RichSaveFile", "RichString"))
    run = serve("-i", sphere, "-s", script, "-o", tmp_path / "curve.obj")
    assert run.status == 0, run.output
    assert (tmp_path / "saved.csv").is_file()


def test_the_twin_has_the_advanced_options(serve, sphere, write_script, tmp_path):
    script = write_script((ALL_OPTIONS, {"picks": SPHERE_PICKS, "distance_tolerance": 0.01, "preset": "default"}))
    run = serve("-i", sphere, "-s", script, "-o", tmp_path / "curve.obj")
    assert run.status == 0, run.output
    assert float(run.figures[-1]["max_distance"]) <= 0.01


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"picks": "1 0 0; 0 1 0; 3 3 3"}, "pick 3"),
        ({"picks_file": "not there.pp"}, "not there.pp"),
        ({"picks": SPHERE_PICKS, "picks_file": "x.pp"}, "more than one option: picks and picks_file"),
        ({}, "give one of the options picks, picks_file and picks_layer"),
        ({"picks": SPHERE_PICKS, "degree": 5}, "degree"),
        ({"picks": SPHERE_PICKS, "field": "quality"}, "no per-vertex quality"),
    ],
)
def test_errors_are_lines_of_the_log_and_nothing_is_written(changes, expected, serve, sphere, write_script, tmp_path):
    output = tmp_path / "curve.obj"
    run = serve("-i", sphere, "-s", write_script((CURVE, changes)), "-o", output)
    assert run.status != 0
    assert any(expected in line for line in run.output.splitlines()), run.output
    assert not output.exists()


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"keep": "seed", "seed": "9 9 9"}, "the seed (9, 9, 9) is"),
        ({"fill": "flat"}, "the option fill needs the option keep"),
    ],
)
def test_a_cut_that_cannot_be_is_refused(changes, expected, serve, sphere, write_script, tmp_path):
    run = serve("-i", sphere, "-s", write_script((CURVE, RING), (CUT, changes)), "-o", tmp_path / "cut.ply")
    assert run.status != 0 and any(expected in line for line in run.output.splitlines()), run.output
    assert not (tmp_path / "cut.ply").exists()


def test_a_mesh_without_faces_is_refused(serve, write_script, tmp_path):
    (tmp_path / "points.xyz").write_text("0 0 0\n1 0 0\n0 1 0\n")
    run = serve("-i", tmp_path / "points.xyz", "-s", write_script((CURVE, {"picks": SPHERE_PICKS})))
    assert run.status != 0 and 'layer "points.xyz" has no faces' in run.output
