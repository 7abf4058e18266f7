# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/field_table.py compares curves without and with a field, and takes means of costs right."""

import json
import subprocess
import sys
from pathlib import Path

import made_meshes as meshes
import numpy as np
import pytest

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"


@pytest.fixture
def table(program):
    def call(*words):
        command = [sys.executable, SCRIPTS / "field_table.py", "--program", program, "--repeats", "1", "--runs", "1", *words]
        return subprocess.run(list(map(str, command)), capture_output=True, text=True)

    return call


def ridge(cells=40, width=0.05):
    """A plate with a rounded ridge along y = 0.65."""
    V, F = meshes.plate(cells)
    V[:, 2] = 0.1 * np.exp(-(((V[:, 1] - 0.65) / width) ** 2))
    return V, F


@pytest.fixture
def curves(tmp_path):
    V, F = ridge()
    meshes.write_ply(tmp_path / "ridge.ply", V, F)
    at = lambda i, j: V[j * 41 + i].tolist()
    for name, picks in (("beside", [at(4, 22), at(36, 22)]), ("far", [[9, 9, 9], at(4, 20)])):
        (tmp_path / f"{name}.json").write_text(json.dumps({"picks": picks}))
    return [f"{tmp_path / 'ridge.ply'}:{tmp_path / name}.json" for name in ("beside", "far")]


def test_every_curve_has_a_row_and_refusals_say_why(table, curves, tmp_path):
    page = tmp_path / "page.md"
    page.write_text("before\n<!-- fields table: begin -->\nstale\n<!-- fields table: end -->\nafter\n")
    done = table(*curves, "--page", page)
    assert done.returncode == 1, "one curve is refused"
    rows = [line for line in done.stdout.splitlines() if line.startswith("| ")]
    assert [row.split(" | ")[0] for row in rows] == ["| curve", "| beside", "| far", "| geometric mean of 1"]
    assert len({row.count("|") for row in rows}) == 1, "as many cells in every row"
    assert "pick 0" in rows[2] or "pick 1" in rows[2], rows[2]
    without, following, change = map(float, rows[1].split("|")[2:5])
    assert following < without and change == pytest.approx(100 * (following / without - 1), abs=0.6)
    text = page.read_text()
    assert text.startswith("before\n") and text.endswith("after\n") and rows[3] in text and "stale" not in text


def test_weight_and_further_options_reach_the_program(table, curves):
    without_pull = table(curves[0], "--field-weight", "0", "--", "--degree", "2")
    assert without_pull.returncode == 0, without_pull.stdout + without_pull.stderr
    assert without_pull.stdout.splitlines()[2].split("|")[4].strip() in ("+0", "-0"), "a field without weight does nothing"
    refused = table(curves[0], "--", "--degree", "7")
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
