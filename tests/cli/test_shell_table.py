# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/shell_table.py writes one row per mesh between the markers and leaves the rest of the page alone."""

import subprocess
import sys
from pathlib import Path

import made_meshes as meshes
import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "shell_table.py"
PAGE = "# Title\n\nbefore\n<!-- shell table: begin -->\nstale\n<!-- shell table: end -->\nafter\n"


@pytest.fixture
def table(program, tmp_path):
    def call(*words):
        (tmp_path / "page.md").write_text(PAGE)
        command = [sys.executable, SCRIPT, "--program", program, "--page", tmp_path / "page.md", "--runs", "1", *words]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
        return done, (tmp_path / "page.md").read_text()

    return call


def test_rows_replace_what_was_between_the_markers(table, tmp_path):
    V, F = meshes.plate(cells=6, height=0.1)
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    bad = F.copy()
    bad[3] = bad[3][::-1]
    meshes.write_ply(tmp_path / "bad.ply", V, bad)
    done, page = table(tmp_path / "hill.ply", tmp_path / "bad.ply")
    assert done.returncode == 0, done.stderr
    assert page.startswith("# Title\n\nbefore\n") and page.endswith("<!-- shell table: end -->\nafter\n") and "stale" not in page
    rows = [line for line in page.splitlines() if line.startswith("| ")]
    assert [row.split(" | ")[0] for row in rows] == ["| mesh", "| hill", "| bad"]
    assert len({row.count("|") for row in rows}) == 1, "as many cells in every row"
    assert "| 72 |" in rows[1] and rows[1].endswith("all hold |")
    assert "refused" in rows[2] and "opposite ways" in rows[2]


def test_options_after_two_dashes_go_to_the_program(table, tmp_path):
    V, F = meshes.plate(cells=6, height=0.1)
    F[3] = F[3][::-1]
    meshes.write_ply(tmp_path / "bad.ply", V, F)
    _, page = table(tmp_path / "bad.ply", "--", "--repair")
    assert "all hold, 1 spots repaired" in page
