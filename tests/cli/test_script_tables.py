# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts that write tables into pages: a row per mesh or curve between the markers, the rest of the page as it was;
means of costs and bending as they are defined."""

import json
import subprocess
import sys
from pathlib import Path

import made_meshes as meshes
import numpy as np
import pytest

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"


@pytest.fixture
def table(program, tmp_path):
    """Runs a script on a page with a stale table; returns the process, its rows and the table's."""

    def call(script, marker, *words):
        page = tmp_path / "page.md"
        page.write_text(f"before\n<!-- {marker} table: begin -->\nstale\n<!-- {marker} table: end -->\nafter\n")
        command = [sys.executable, SCRIPTS / script, "--program", program, "--page", page, *words]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
        text = page.read_text()
        assert text.startswith("before\n") and text.endswith(f"<!-- {marker} table: end -->\nafter\n")
        return done, *([line for line in lines.splitlines() if line.startswith("| ")] for lines in (done.stdout, text)), text

    return call


def write_curves(folder, V, F, **picks):
    """A mesh and files of picks; the words for a script."""
    meshes.write_ply(folder / "mesh.ply", V, F)
    for name, points in picks.items():
        (folder / f"{name}.json").write_text(json.dumps({"picks": points}))
    return [f"{folder / 'mesh.ply'}:{folder / name}.json" for name in picks]


def names(rows):
    return [row.split(" | ")[0] for row in rows]


# ---- fields ----


def test_curvature_is_near_to_that_of_known_surfaces(table):
    done, printed, written, _ = table("field_error_table.py", "errors", "--quick")
    assert done.returncode == 0, done.stderr
    assert written == printed and [row.split(" | ")[0] for row in printed[1:]] == ["| sphere", "| torus, r = 0.3 R", "| cylinder"]
    for row in printed[1:]:
        _, exact, error, noisy = map(float, row.strip("| ").split(" | ")[1:])
        assert error < 0.05 * exact and error < noisy < 1.2 * exact


@pytest.fixture
def beside_a_ridge(tmp_path):
    """A plate with a rounded ridge along y = 0.65: a curve beside it, and one that is refused."""
    V, F = meshes.plate(40)
    V[:, 2] = 0.1 * np.exp(-(((V[:, 1] - 0.65) / 0.05) ** 2))
    at = lambda i, j: V[j * 41 + i].tolist()
    return write_curves(tmp_path, V, F, beside=[at(4, 22), at(36, 22)], far=[[9, 9, 9], at(4, 20)])


FIELDS = ("field_table.py", "fields", "--repeats", "1", "--runs", "1")


def test_every_curve_with_a_field_has_a_row_and_refusals_say_why(table, beside_a_ridge):
    done, rows, _, page = table(*FIELDS, *beside_a_ridge)
    assert done.returncode == 1, "one curve is refused"
    assert names(rows) == ["| curve", "| beside", "| far", "| geometric mean of 1"]
    assert len({row.count("|") for row in rows}) == 1, "as many cells in every row"
    assert "pick 1" in rows[2] or "pick 2" in rows[2], rows[2]
    without, following, change = map(float, rows[1].split("|")[2:5])
    assert following < without and change == pytest.approx(100 * (following / without - 1), abs=0.6)
    assert rows[3] in page and "stale" not in page


def test_weight_and_further_options_reach_the_program(table, beside_a_ridge):
    done, rows, *_ = table(*FIELDS, beside_a_ridge[0], "--field-weight", "0", "--", "--degree", "2")
    assert done.returncode == 0, done.stdout + done.stderr
    assert rows[1].split("|")[4].strip() in ("+0", "-0"), "a field without weight does nothing"
    refused, *_ = table(*FIELDS, beside_a_ridge[0], "--", "--degree", "7")
    assert refused.returncode == 1 and "degree" in refused.stdout


def test_mean_cost_is_weighted_by_length(monkeypatch):
    monkeypatch.syspath_prepend(str(SCRIPTS))
    from field_table import mean_cost

    faces, values = np.array([[0, 1, 2]]), np.array([0.0, 1.0, 3.0])
    line = {"points": [[0, 0, 0], [1, 0, 0], [1, 3, 0]], "faces": [0] * 3, "barycentrics": np.eye(3).tolist()}
    c = np.exp(-values)
    first, second, last = (c[0] + c[1]) / 2, 3 * (c[1] + c[2]) / 2, np.sqrt(10) * (c[2] + c[0]) / 2
    assert mean_cost(values, faces, {"closed": False, "polyline": line}) == pytest.approx((first + second) / 4)
    closed = mean_cost(values, faces, {"closed": True, "polyline": line})
    assert closed == pytest.approx((first + second + last) / (4 + np.sqrt(10)))


# ---- kinds of shells ----


def test_every_curve_in_both_kinds_of_shell_has_a_row_and_refusals_say_why(table, tmp_path):
    V, F = meshes.plate(cells=10, height=0.1)
    curves = write_curves(tmp_path, V, F, near=V[[12, 60, 104]].tolist(), far=[[9, 9, 9], V[0].tolist()])
    done, _, rows, page = table("shell_kinds_table.py", "kinds", "--repeats", "1", *curves)
    assert done.returncode == 1, "one curve is refused"
    assert "stale" not in page and names(rows) == ["| curve", "| near", "| far", "| geometric mean of 1"]
    assert "full: " in rows[2] and "simplified: " in rows[2]
    assert float(rows[3].split("|")[-2]) > 0


def test_bending_of_a_circle_in_a_plane_is_its_length_by_its_squared_radius(monkeypatch):
    monkeypatch.syspath_prepend(str(SCRIPTS))
    from shell_kinds_table import bending

    vertices = np.array([[-5.0, -5, 0], [5, -5, 0], [0, 9, 0]])
    angles = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
    points = np.stack([2 * np.cos(angles), 2 * np.sin(angles), 0 * angles], 1)
    line = {"points": points, "faces": [0] * 2000, "barycentrics": [[1 / 3] * 3] * 2000}
    mesh = vertices, np.array([[0, 1, 2]])
    assert bending(mesh, {"closed": True, "polyline": line}) == pytest.approx(2 * np.pi * 2 / 2**2, rel=5e-3)
    straight = {"points": points[:1000:999], "faces": [0, 0], "barycentrics": [[1 / 3] * 3] * 2}
    assert bending(mesh, {"closed": False, "polyline": straight}) == pytest.approx(0, abs=1e-12)


# ---- shells ----


def test_every_mesh_has_a_row_and_options_after_two_dashes_go_to_the_program(table, tmp_path):
    V, F = meshes.plate(cells=6, height=0.1)
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    F[3] = F[3][::-1]
    meshes.write_ply(tmp_path / "bad.ply", V, F)
    done, _, rows, page = table("shell_table.py", "shell", "--runs", "1", tmp_path / "hill.ply", tmp_path / "bad.ply", "--", "--strict")
    assert done.returncode == 0, done.stderr
    assert "stale" not in page and names(rows) == ["| mesh", "| hill", "| bad"]
    assert len({row.count("|") for row in rows}) == 1, "as many cells in every row"
    assert "| 72 |" in rows[1] and rows[1].endswith("all hold |")
    assert "refused" in rows[2] and "opposite ways" in rows[2]
    assert "all hold, 1 spots mended" in table("shell_table.py", "shell", "--runs", "1", tmp_path / "bad.ply")[3]
