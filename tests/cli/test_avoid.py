# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces to avoid, as a user names them."""

import json

import made_meshes as meshes
import numpy as np
import pytest

CELLS = 24


@pytest.fixture
def wall(tmp_path):
    """A plate with quality x in plate.ply, picks left and right; ids of the faces of a wall between them in wall.txt."""
    V, F = meshes.plate(cells=CELLS)
    meshes.write_ply(tmp_path / "plate.ply", V, F, quality=V[:, 0])
    (tmp_path / "picks.json").write_text(json.dumps({"picks": [[0.1, 0.4, 0], [0.9, 0.45, 0]]}))
    middle = V[F].mean(1)
    ids = np.flatnonzero((abs(middle[:, 0] - 0.5) < 0.1) & (middle[:, 1] < 0.7))
    (tmp_path / "wall.txt").write_text("# the wall\n" + "\n".join(map(str, ids)) + "\n")
    np.save(tmp_path / "wall.npy", ids)
    return V, F, ids


DRAW = ("plate.ply", "--picks", "picks.json", "--output", "curve.json", "--report", "report.json")


def draw(run, *words, mesh=DRAW[0]):
    return run(mesh, *DRAW[1:], *words)


def result(folder):
    return [json.loads((folder / name).read_text()) for name in ("curve.json", "report.json")]


def faces_of(curve):
    return np.array(curve["polyline"]["faces"])


@pytest.mark.parametrize("file", ["wall.txt", "wall.npy"])
@pytest.mark.parametrize("shell", ["full", "simplified"])
def test_the_curve_goes_round_the_faces_of_a_file(run, tmp_path, wall, file, shell):
    process = draw(run, "--avoid", file, "--shell", shell, "--no-cache")
    assert process.returncode == 0, process.stderr
    curve, report = result(tmp_path)
    assert not np.isin(faces_of(curve), wall[2]).any()
    assert max(p[1] for p in curve["polyline"]["points"]) > 0.7
    assert report["avoid"]["faces"] == len(wall[2]) and 0 < report["avoid"]["clearance"] < 0.1


def test_nothing_is_avoided_unless_it_is_asked_for(run, tmp_path, wall):
    assert draw(run).returncode == 0
    curve, report = result(tmp_path)
    assert report["avoid"] is None
    assert np.isin(faces_of(curve), wall[2]).any()


def test_faces_are_avoided_by_the_quality_or_the_field(run, tmp_path, wall):
    V, F, _ = wall
    (tmp_path / "picks.json").write_text(json.dumps({"picks": [[0.75, 0.1, 0], [0.75, 0.4, 0], [0.9, 0.9, 0]]}))
    process = draw(run, "--avoid", "under-threshold", "--avoid-threshold", "0.7")
    assert process.returncode == 0, process.stderr
    x = V[F].mean(1)[:, 0]
    curve, report = result(tmp_path)
    assert report["avoid"]["faces"] == (x < 0.7).sum()
    assert (x[faces_of(curve)] > 0.7).all()
    np.savetxt(tmp_path / "field.txt", -V[:, 0])
    words = ["--field", "field.txt", "--field-weight", "0"]
    process = draw(run, *words, "--avoid", "over-threshold", "--avoid-threshold", "-0.7")
    assert process.returncode == 0, process.stderr
    assert result(tmp_path)[0]["polyline"]["points"] == curve["polyline"]["points"]


def test_ids_are_those_of_the_mesh_before_it_was_mended(run, tmp_path, wall):
    V, F, ids = wall
    # A face without area goes first and is removed, so that all ids change.
    F = np.vstack([[0, 1, 1], F])
    meshes.write_obj(tmp_path / "bad.obj", V, F)
    np.save(tmp_path / "wall.npy", ids + 1)
    process = draw(run, "--avoid", "wall.npy", mesh="bad.obj")
    assert process.returncode == 0, process.stderr
    curve, report = result(tmp_path)
    assert report["avoid"]["faces"] == len(ids)
    assert not np.isin(faces_of(curve), ids + 1).any()


def test_what_has_no_way_is_refused_by_name(refused, tmp_path, wall):
    V, F, _ = wall
    middle = V[F].mean(1)
    np.save(tmp_path / "whole.npy", np.flatnonzero(abs(middle[:, 0] - 0.5) < 0.1))
    refused(1, *DRAW, "--avoid", "whole.npy", says=["from pick 1 to pick 2", "avoid"])
    np.save(tmp_path / "left.npy", np.flatnonzero(middle[:, 0] < 0.3))
    refused(1, *DRAW, "--avoid", "left.npy", says=["pick 1 lies in face", "avoid"])


FACES = 2 * CELLS * CELLS


@pytest.mark.parametrize("status, words, says", [
    (1, ("ids.txt",), [f"-1, {FACES}", f"0 to {FACES - 1}"]),
    (1, ("words.txt",), ["words.txt, line 1", "whole number"]),
    (1, ("none.txt",), ["none.txt", "no such file"]),
    (1, ("wall.txt", "--quadrature", "samples"), ["quadrature", "cells"]),
    (1, ("wall.txt", "--preset", "paper"), ["use \"cells\""]),
    (2, ("under-threshold",), ["--avoid-threshold"]),
    (2, ("wall.txt", "--avoid-threshold", "1"), ["--avoid-threshold"]),
    (2, ("wall.txt", "--avoid-margin", "0"), ["(0, 1]"]),
])
def test_wrong_ids_files_and_settings_are_refused(refused, tmp_path, wall, status, words, says):
    (tmp_path / "ids.txt").write_text(f"3 {FACES} -1")
    (tmp_path / "words.txt").write_text("3 x")
    refused(status, *DRAW, "--avoid", *words, says=says)


def test_a_threshold_needs_quality(refused, tmp_path, wall):
    meshes.write_obj(tmp_path / "plain.obj", *wall[:2])
    refused(1, "plain.obj", *DRAW[1:], "--avoid", "over-threshold", "--avoid-threshold", "0.5", says=["plain.obj", "quality"])
