# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/shell_kinds_table.py compares curves in both kinds of shell, and measures bending right."""

import json
import subprocess
import sys
from pathlib import Path

import made_meshes as meshes
import numpy as np
import pytest

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
PAGE = "before\n<!-- kinds table: begin -->\nstale\n<!-- kinds table: end -->\nafter\n"


@pytest.fixture
def table(program, tmp_path):
    def call(*curves):
        (tmp_path / "page.md").write_text(PAGE)
        command = [sys.executable, SCRIPTS / "shell_kinds_table.py", "--program", program, "--page", tmp_path / "page.md",
                   "--repeats", "1", *curves]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
        return done, (tmp_path / "page.md").read_text()

    return call


def test_every_curve_has_a_row_and_refusals_say_why(table, tmp_path):
    V, F = meshes.plate(cells=10, height=0.1)
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    for name, picks in (("near", V[[12, 60, 104]].tolist()), ("far", [[9, 9, 9], V[0].tolist()])):
        (tmp_path / f"{name}.json").write_text(json.dumps({"picks": picks}))
    done, page = table(*(f"{tmp_path / 'hill.ply'}:{tmp_path / name}.json" for name in ("near", "far")))
    assert done.returncode == 1, "one curve is refused"
    rows = [line for line in page.splitlines() if line.startswith("| ")]
    assert page.startswith("before\n") and page.endswith("after\n") and "stale" not in page
    assert [row.split(" | ")[0] for row in rows] == ["| curve", "| near", "| far", "| geometric mean of 1"]
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
