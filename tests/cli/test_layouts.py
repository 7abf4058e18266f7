# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/avoid_layouts.py and obstacle_layouts.py draw round random obstacles, and see curves that enter them."""

import json
import subprocess
import sys
from pathlib import Path

import made_meshes as meshes
import numpy as np
import pytest

pytestmark = pytest.mark.slow
SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"


def plate_file(folder):
    V, F = meshes.plate(cells=16)
    meshes.write_ply(folder / "plate.ply", V, F)
    return folder / "plate.ply"


def test_no_curve_enters_an_obstacle_and_all_impossible_ones_are_refused(program, tmp_path):
    layouts = ["--layouts", "12", "--first", "38"]
    command = [sys.executable, SCRIPTS / "avoid_layouts.py", plate_file(tmp_path), "--program", program, *layouts]
    process = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    assert process.returncode == 0, process.stdout + process.stderr
    drawn, refused = (int(word.split()[0]) for word in process.stdout.split(": ")[1].split(", ")[:2])
    assert drawn > 0 and refused > 0 and drawn + refused == 12


def test_a_curve_pressed_against_an_obstacle_comes_to_an_end(run, tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(SCRIPTS)
    import avoid_layouts

    # Newton's method ends in no round here: knots were added until each was as short as rounding, for a minute.
    avoided, _, points, closed = avoid_layouts.random_layout(avoid_layouts.Mesh(plate_file(tmp_path)), 40)
    (tmp_path / "picks.json").write_text(json.dumps({"closed": closed, "picks": points.tolist()}))
    np.save(tmp_path / "avoid.npy", np.flatnonzero(avoided))
    run.ok("plate.ply", "--picks", "picks.json", "--avoid", "avoid.npy", "--degree", 2, "--output", "c.json", "--report", "r.json")
    report = json.loads((tmp_path / "r.json").read_text())
    assert (report["status"], report["usable"]) == ("distance reached", True)
    assert report["knots_last"] < 500


def test_a_segment_through_a_face_avoided_is_seen(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(SCRIPTS)
    import avoid_layouts

    mesh = avoid_layouts.Mesh(plate_file(tmp_path))
    left, right = mesh.pairs[0]
    shared = np.intersect1d(mesh.faces[left], mesh.faces[right])
    on_edge = [0.5 if v in shared else 0.0 for v in mesh.faces[left]]
    centre = [1 / 3] * 3
    curve = {"closed": False, "polyline": {"faces": [left, left, right], "barycentrics": [centre, on_edge, centre]}}
    none = np.zeros(len(mesh.faces), dtype=bool)
    assert not avoid_layouts.enters(mesh, curve, none)
    for face in (left, right):
        avoided = none.copy()
        avoided[face] = True
        assert avoid_layouts.enters(mesh, curve, avoided)
    alone = {"closed": False, "polyline": {"faces": [left, right], "barycentrics": [centre, centre]}}
    assert avoid_layouts.enters(mesh, alone, none)


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
