# SPDX-License-Identifier: GPL-3.0-or-later
"""The recipes of docs/PYTHON.md run as they stand there."""
import re
from pathlib import Path

import bspline_curve
import numpy as np
import pytest

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "PYTHON.md").read_text()
RECIPES = dict(re.findall(r"\n### ([^\n]+)\n.*?```python\n(.*?)```", PAGE.partition("\n## Recipes\n")[2].partition("\n## ")[0], re.S))


@pytest.fixture
def files(tmp_path, monkeypatch, wavy):
    """What the recipes read."""
    import meshio

    vertices, faces = wavy(41)

    def write(name, points):
        meshio.Mesh(points, [("triangle", faces)]).write(tmp_path / name)

    write("part.ply", vertices)
    radius = np.hypot(vertices[:, 0], vertices[:, 1])
    bowl = np.c_[vertices[:, :2], 0.3 * np.abs(np.tanh(8 * (radius - 0.6)))]  # a groove along a circle
    write("tooth.ply", bowl)
    angles = np.linspace(0, 2 * np.pi, 6, endpoint=False)
    np.savetxt(tmp_path / "margin.xyz", np.c_[0.62 * np.cos(angles), 0.62 * np.sin(angles), 0 * angles + 0.02])
    np.savetxt(tmp_path / "holes.csv", [[-0.2, -0.2, 0.2], [0.5, 0.4, 0.15]], delimiter=",")
    (tmp_path / "scans").mkdir()
    for i in range(3):
        write(f"scans/{i}.ply", vertices * (i + 1))
        np.savetxt(tmp_path / "scans" / f"{i}.xyz", vertices[[300, 700, 1300]] * (i + 1) + [0, 0, 5 * (i == 1)])
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run(name):
    variables = {}
    exec(compile(RECIPES[name], name, "exec"), variables)
    return variables


def test_each_recipe_has_a_test():
    assert set(RECIPES) == {name.partition("_recipe_")[2].replace("_", " ") for name in globals() if name.startswith("test_recipe_")}


def test_recipe_A_margin_line(files, capsys):
    margin = run("A margin line")["margin"]
    assert capsys.readouterr().out.endswith("long, usable\n")
    assert np.abs(np.hypot(*margin.points[:, :2].T) - 0.6).mean() < 0.02  # in the groove, which the picks were not
    assert {"margin.vtu", "margin.json"} <= {path.name for path in files.iterdir()}


def test_recipe_A_part_cut_out_of_a_scan(files, capsys):
    given = run("A part cut out of a scan")
    crown, margin = given["crown"], given["margin"]
    assert crown.euler_number == 1 and crown.area == pytest.approx(given["inside"].area)
    assert given["inside"].perimeter == pytest.approx(margin.length)
    assert capsys.readouterr().out.startswith(f"{crown.area:.3f} inside")
    assert (files / "crown.ply").exists()


def test_recipe_A_scan_divided_into_regions(files, capsys):
    import trimesh

    given = run("A scan divided into regions")
    rest, crown, band = given["regions"].parts
    assert (rest.euler, crown.euler, band.euler) == (0, 1, 0)
    outside = sum(piece.length for piece in given["band"])
    assert band.area == pytest.approx(0.15 * (given["margin"].length + outside) / 2, rel=0.07)  # corners
    assert len(capsys.readouterr().out.splitlines()) == 3
    colours = trimesh.load(files / "regions.ply", process=False).visual.face_colors
    assert len(np.unique(colours, axis=0)) == 3


def test_recipe_A_route_around_obstacles(files, capsys):
    cable = run("A route around obstacles")["cable"]
    away = np.hypot(cable.points[:, 0] + 0.2, cable.points[:, 1] + 0.2)
    assert away.min() > 0.17 and float(capsys.readouterr().out.split()[1]) > 0


def test_recipe_A_curve_that_follows_a_drag(files):
    given = run("A curve that follows a drag")
    moved = given["mesh"].vertices[900] - given["final"].picks[2]
    assert np.linalg.norm(moved) > 0.1 and given["final"].usable


def test_recipe_A_heart_with_corners(files, capsys):
    given = run("A heart with corners")
    heart, seam = given["heart"], given["seam"]
    assert all(np.count_nonzero(heart.knots == heart.pick_parameters[corner]) == 3 for corner in (0, 6))
    assert heart.usable and seam.usable
    ends = np.abs([seam.points[0, 0], seam.points[-1, 0]])
    np.testing.assert_allclose(ends, 1.0)  # on the boundary
    assert [met["pick"] for met in seam.report["tangents"]] == [0, 2]
    assert max(met["angle_of_spline"] for met in seam.report["tangents"]) < 1e-6
    assert capsys.readouterr().out.splitlines()[0].endswith("(0, 6)")


def test_recipe_A_folder_of_scans(files, capsys):
    run("A folder of scans")
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == ["0.ply", "1.ply", "2.ply"]
    assert "picks [0, 1, 2]: pick-too-far" in lines[1]
    assert float(lines[2].split()[1]) == pytest.approx(3 * float(lines[0].split()[1]), rel=1e-3)
    assert len(list((files / "scans").glob("*.curve.json"))) == 2


def test_recipe_A_notebook(files):
    assert isinstance(run("A notebook")["curve"], bspline_curve.Curve)
