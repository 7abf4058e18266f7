# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb offset: lines at a distance from a curve, and the faces within it."""

import json

import made_meshes as meshes
import numpy as np
import pytest
import trimesh


@pytest.fixture
def curve(run, tmp_path):
    """A curve from left to right on a flat plate of 12 x 12 cells."""
    vertices, faces = meshes.plate(cells=12, height=0.0)
    meshes.write_ply(tmp_path / "plate.ply", vertices, faces)
    (low, high) = vertices.min(axis=0), vertices.max(axis=0)
    at = lambda u, v: (low + (high - low) * [u, v, 0]).tolist()  # noqa: E731
    (tmp_path / "picks.json").write_text(json.dumps({"picks": [at(0.3, 0.5), at(0.7, 0.5)]}))
    run.ok("plate.ply", "--picks", "picks.json", "--output", "curve.json")
    return np.array(json.loads((tmp_path / "curve.json").read_text())["polyline"]["points"])


def distances(points, curve):
    begin, along = curve[:-1], np.diff(curve, axis=0)
    t = np.einsum("psk,sk->ps", points[:, None] - begin, along) / np.einsum("sk,sk->s", along, along)
    feet = begin + np.clip(t, 0, 1)[..., None] * along
    return np.linalg.norm(points[:, None] - feet, axis=2).min(axis=1)


def test_points_are_at_the_distance(run, tmp_path, curve):
    distance = 0.2 * np.ptp(curve[:, 0])
    run.ok("offset", "plate.ply", "--curve", "curve.json", "--distance", distance, "--output", "offset.json",
                 "--report", "report.json")
    offset = json.loads((tmp_path / "offset.json").read_text())
    points = np.array(offset["polyline"]["points"])
    assert offset["closed"]
    assert np.abs(distances(points, curve) / distance - 1).max() < 5e-4
    report = json.loads((tmp_path / "report.json").read_text())
    (piece,) = report["pieces"]
    middles = (points + np.roll(points, -1, axis=0)) / 2
    off = np.abs(distances(np.vstack([points, middles]), curve) / distance - 1).max()
    assert piece["deviation"] == pytest.approx(off, abs=1e-7) and off < 1e-3
    assert piece["fitted"] and piece["closed"] and piece["degree"] == offset["spline"]["degree"] == 3
    assert piece["control_points"] == len(offset["spline"]["control_points"]) - 3 < len(points) / 10
    assert not (tmp_path / "offset-2.json").exists()


def test_one_side_is_open_and_its_band_is_beside_the_curve(run, tmp_path, curve):
    distance = 0.3 * np.ptp(curve[:, 0])
    run.ok("offset", "plate.ply", "--curve", "curve.json", "--distance", distance, "--side", "left",
                 "--output", "left.json", "--band", "band.ply")
    offset = json.loads((tmp_path / "left.json").read_text())
    assert not offset["closed"]
    assert np.array(offset["polyline"]["points"])[:, 1].min() > curve[:, 1].max()
    mesh = trimesh.load(tmp_path / "band.ply", process=False)
    label = mesh.metadata["_ply_raw"]["face"]["data"]["label"].ravel()
    middles = mesh.triangles_center[label == 1]
    assert 0 < len(middles) < len(mesh.faces)
    assert middles[:, 1].min() > curve[:, 1].min()
    assert distances(middles, curve).max() <= distance * (1 + 1e-9)


def test_refuses_another_mesh_and_distances_that_no_point_has(run, refused, tmp_path, curve):
    vertices, faces = meshes.plate(cells=12, height=0.3)
    meshes.write_ply(tmp_path / "hill.ply", vertices, faces)
    words = ("--curve", "curve.json", "--output", "offset.json")
    refused(1, "offset", "hill.ply", *words, "--distance", 0.1, says=["the mesh changed since the curve was drawn", "give the mesh"])
    refused(1, "offset", "plate.ply", *words, "--distance", 1e6, says=["curve.json: no point", "smaller offset"])
    refused(2, "offset", "plate.ply", *words, "--distance", -1, says=["must be > 0"])
    assert not (tmp_path / "offset.json").exists()
    (tmp_path / "rim.obj").write_text("v 0 0 0\nv 1 0 0\nl 1 2\n")
    process = run.ok("offset", "plate.ply", *words, "--curve", "rim.obj", "--side", "right", "--distance", 0.1)
    assert process.stderr.startswith("bspline_curve: note: rim.obj: no point of the surface") and process.stderr.count("\n") == 1
