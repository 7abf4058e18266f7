# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/obstacle_layouts.py draws among random discs: with the default field of obstacles curves keep out of them."""

import subprocess
import sys
from pathlib import Path

import made_meshes as meshes
import pytest

pytestmark = pytest.mark.slow
SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"


def counted(program, tmp_path, *options):
    """Exit code, and how many of 12 curves on a plate keep out."""
    meshes.write_ply(tmp_path / "plate.ply", *meshes.plate(cells=32))
    script = [sys.executable, SCRIPTS / "obstacle_layouts.py", tmp_path / "plate.ply", "--program", program]
    process = subprocess.run(list(map(str, [*script, "--layouts", 12, *options])), capture_output=True, text=True)
    assert process.stderr == ""
    return process.returncode, int(process.stdout.splitlines()[-1].split(": ")[1].split()[0])


def test_curves_keep_out_of_obstacles_by_default(program, tmp_path):
    code, kept = counted(program, tmp_path)
    assert kept >= 11
    assert code == (0 if kept == 12 else 1)  # 95 of 100


def test_curves_that_enter_are_seen(program, tmp_path):
    code, kept = counted(program, tmp_path, "--", "--field-weight", "0")
    assert code == 1 and kept < 12
