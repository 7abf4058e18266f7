# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb imprint: curves as edges of the mesh."""

import json

import made_meshes as meshes
import numpy as np
import pytest
import trimesh


@pytest.fixture
def drawn(run, tmp_path):
    """Two curves that cross on a hill, drawn and kept as curve-0.json and curve-1.json; vertices, faces, quality."""
    vertices, faces = meshes.plate(cells=12, height=0.2)
    quality = vertices @ [1.0, 2.0, 0.0]
    meshes.write_ply(tmp_path / "hill.ply", vertices, faces, quality)
    lift = lambda u, v: vertices[np.abs(vertices[:, :2] - (u, v)).sum(axis=1).argmin()].tolist()  # noqa: E731
    (low, high) = vertices.min(axis=0), vertices.max(axis=0)
    at = lambda u, v: lift(*(low + (high - low) * [u, v, 0])[:2])  # noqa: E731
    for k, ends in enumerate(([at(0.2, 0.45), at(0.8, 0.55)], [at(0.45, 0.2), at(0.55, 0.8)])):
        (tmp_path / "picks.json").write_text(json.dumps({"picks": ends}))
        assert run("hill.ply", "--picks", "picks.json", "--field", "none", "--output", f"curve-{k}.json").returncode == 0
    return vertices, faces, quality


CURVES = ("--curve", "curve-0.json", "--curve", "curve-1.json")


def test_curves_are_edges_and_children_fill_their_parents(run, tmp_path, drawn):
    vertices, faces, quality = drawn
    result = run("imprint", "hill.ply", *CURVES, "--output", "out.ply", "--map", "map.json", "--report", "report.json")
    assert result.returncode == 0, result.stderr
    mesh = trimesh.load(tmp_path / "out.ply", process=False)
    map_ = json.loads((tmp_path / "map.json").read_text())
    report = json.loads((tmp_path / "report.json").read_text())
    assert np.array_equal(mesh.vertices[: len(vertices)], vertices)
    edges = {tuple(edge) for edge in np.sort(mesh.edges, axis=1).tolist()}
    for curve in map_["curves"]:
        ids = curve["vertices"]
        assert all((min(a, b), max(a, b)) in edges for a, b in zip(ids, ids[1:]))
    assert len(map_["crossings"]) == report["crossings"] == 1
    areas = np.bincount(map_["parents"], weights=mesh.area_faces)
    assert np.allclose(areas, trimesh.Trimesh(vertices, faces, process=False).area_faces, rtol=1e-9)
    assert np.allclose(map_["quality"]["output"], mesh.vertices @ [1.0, 2.0, 0.0], atol=1e-9)
    assert np.array_equal(mesh.metadata["_ply_raw"]["face"]["data"]["label"].ravel(), map_["regions"])
    assert report["parts"][0]["area"] == pytest.approx(mesh.area)
    assert report["seconds"]["imprint"] > 0


@pytest.mark.parametrize("extension", ["obj", "off", "stl"])
def test_other_formats_hold_the_same_faces(run, tmp_path, drawn, extension):
    for name in ("out.ply", f"out.{extension}"):
        assert run("imprint", "hill.ply", *CURVES, "--output", name).returncode == 0
    one, other = (trimesh.load(tmp_path / name, process=False) for name in ("out.ply", f"out.{extension}"))
    assert np.allclose(one.triangles, other.triangles, atol=1e-7 if extension == "stl" else 0)


def test_refuses_another_mesh_and_what_it_cannot_write(run, refused, tmp_path, drawn):
    vertices, faces = meshes.plate(cells=12, height=0.3)
    meshes.write_ply(tmp_path / "other.ply", vertices, faces)
    drawn_on = ["curve-0.json: the mesh changed since the curve was drawn", "give the mesh"]
    refused(1, "imprint", "other.ply", *CURVES, "--output", "out.ply", says=drawn_on)
    refused(1, "cut", "other.ply", *CURVES, "--output", "out.ply", says=drawn_on)
    refused(1, "segment", "other.ply", *CURVES, "--output", "out.ply", says=drawn_on)
    refused(1, "offset", "other.ply", *CURVES[:2], "--distance", 0.1, "--output", "out.json", says=drawn_on)
    document = json.loads((tmp_path / "curve-0.json").read_text())
    document["mesh"]["crc32"] = 5
    (tmp_path / "odd.json").write_text(json.dumps(document))
    refused(1, "imprint", "hill.ply", "--curve", "odd.json", "--output", "out.ply", says=["crc32"])
    del document["mesh"]  # as older versions wrote it
    (tmp_path / "old.json").write_text(json.dumps(document))
    refused(1, "imprint", "other.ply", "--curve", "old.json", "--output", "out.ply", says=["does not lie on this mesh"])
    assert run("imprint", "hill.ply", "--curve", "old.json", "--output", "new.ply").returncode == 0
    refused(1, "imprint", "hill.ply", *CURVES, "--output", "out.xyz", says=["meshes are written as .ply, .obj, .off or .stl"])
    refused(2, "imprint", "hill.ply", *CURVES, "--output", "out.ply", "--snap", 0.5, says=["must be in [0, 0.01]"])
    refused(2, "imprint", "hill.ply", "--output", "out.ply", says=["--curve"])
    assert not (tmp_path / "out.ply").exists()
