# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb fill: holes that a mesh has, closed."""

import json

import made_meshes as meshes
import numpy as np
import pytest
import trimesh


def load(path):
    return trimesh.load(path, process=False)


@pytest.fixture
def pierced(tmp_path):
    """A sphere with a small hole at the top and a large one at the bottom; quality is the height."""
    sphere = trimesh.creation.icosphere(4)
    height = sphere.vertices[sphere.faces][:, :, 2].mean(axis=1)
    sphere.update_faces((height < 0.98) & (height > -0.85))
    sphere.remove_unreferenced_vertices()
    meshes.write_ply(tmp_path / "pierced.ply", sphere.vertices, sphere.faces, sphere.vertices[:, 2])
    return sphere


@pytest.mark.parametrize("shape", ["smooth", "flat"])
def test_all_holes_are_closed(run, tmp_path, pierced, shape):
    run.ok("fill", "pierced.ply", "--shape", shape, "--output", "closed.ply", "--report", "report.json")
    mesh = load(tmp_path / "closed.ply")
    assert mesh.is_watertight and mesh.is_winding_consistent
    assert json.loads((tmp_path / "report.json").read_text())["filled_holes"] == 2
    raw = mesh.metadata["_ply_raw"]
    labels = raw["face"]["data"]["label"].ravel()
    assert (labels[: len(pierced.faces)] == 0).all() and (labels[len(pierced.faces) :] == -1).all()
    if shape == "smooth":
        assert mesh.volume == pytest.approx(4 / 3 * np.pi, rel=0.01)
        quality = raw["vertex"]["data"]["quality"].ravel()[len(pierced.vertices) :]
        new = mesh.vertices[len(pierced.vertices) :]
        assert (np.sign(quality) == np.sign(new[:, 2])).all()


@pytest.mark.parametrize("words, top, bottom", [
    (("--max-edges", "40"), True, False),
    (("--max-length", "2"), True, False),
    (("--seed", "0,0,-1"), False, True),
])
def test_those_that_are_chosen_are_closed(run, tmp_path, pierced, words, top, bottom):
    process = run("fill", "pierced.ply", *words, "--output", "closed.ply")
    assert process.returncode == 0 and "1 hole stays open" in process.stderr
    new = load(tmp_path / "closed.ply").vertices[len(pierced.vertices) :, 2]
    assert ((new > 0.9).any(), (new < -0.8).any()) == (top, bottom)


@pytest.mark.parametrize("words, status, said", [
    (("--max-edges", "3"), 1, "none of 2 holes is as small as that"),
    (("--max-edges", "-1"), 2, "--max-edges"),
    (("--max-length", "-1"), 2, "--max-length"),
    (("--shape", "round"), 2, "round"),
])
def test_what_cannot_be_done_is_refused(run, tmp_path, pierced, words, status, said):
    process = run("fill", "pierced.ply", *words, "--output", "closed.ply")
    assert process.returncode == status and said in process.stderr
    assert not (tmp_path / "closed.ply").exists()


def test_no_limit_closes_all(run, tmp_path, pierced):
    run.ok("fill", "pierced.ply", "--max-edges", "0", "--max-length", "0", "--output", "closed.ply")
    assert load(tmp_path / "closed.ply").is_watertight


def test_a_closed_mesh_has_no_hole(run, tmp_path):
    trimesh.creation.icosphere(2).export(tmp_path / "sphere.ply")
    process = run("fill", "sphere.ply", "--output", "closed.ply")
    assert process.returncode == 1 and "the mesh has no hole" in process.stderr
