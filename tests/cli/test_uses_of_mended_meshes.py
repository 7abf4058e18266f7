# SPDX-License-Identifier: GPL-3.0-or-later
"""Verbs that use curves, on meshes that are mended: ids are those of the mesh as it was given."""

import json

import made_meshes as meshes
import numpy as np
import pytest
import trimesh
from broken_meshes import scan_with_bad_spots, spots


def succeed(process):
    assert process.returncode == 0, process.stderr
    assert process.stderr.startswith("bspline_curve: note: the mesh was mended: ")
    assert process.stderr.count("the mesh was mended") == 1 and process.stdout.count("\n") == 1


GONE = ("left_out_faces", "removed_degenerate_faces", "removed_duplicate_faces")


def normals(corners):
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def check_origins(V, F, mesh, map_, removed):
    """Faces lie in their parents and fill them, vertices at their places; both of the given mesh."""
    corners = V[F]
    assert np.array_equal(mesh.vertices[: len(V)], V, equal_nan=True)
    places = map_["new_vertices"]
    assert len(mesh.vertices) == len(V) + len(places)
    inside = corners[[place["face"] for place in places]]
    weights = np.array([place["barycentric"] for place in places])
    assert np.abs((inside * weights[:, :, None]).sum(1) - mesh.vertices[len(V) :]).max() < 1e-9
    parents = np.array(map_["parents"])
    areas = np.linalg.norm(normals(corners), axis=1) / 2
    kept = np.setdiff1d(np.arange(len(F)), list(removed))
    assert np.array_equal(np.unique(parents), kept)
    filled = np.bincount(parents, weights=mesh.area_faces, minlength=len(F))
    assert np.allclose(filled[kept], areas[kept], rtol=1e-9)
    across = normals(corners)[parents] / (2 * areas[parents, None])
    off = np.einsum("fki,fi->fk", mesh.triangles - corners[parents][:, :1], across)
    assert np.abs(off).max() < 1e-9


def draw(run, folder, V, F, picks):
    meshes.write_ply(folder / "bad.ply", V, F, quality=np.nan_to_num(V) @ [1.0, 2.0, 3.0])
    (folder / "picks.json").write_text(json.dumps({"picks": picks.tolist(), "closed": True}))
    succeed(run("bad.ply", "--picks", "picks.json", "--field", "none", "--output", "curve.json", "--report", "curve-report.json"))
    return json.loads((folder / "curve-report.json").read_text())["repair"]


@pytest.mark.parametrize("name", spots())
def test_imprints_come_from_the_given_mesh(run, refused, tmp_path, name):
    V, F, _, word = spots()[name]
    repair = draw(run, tmp_path, V, F, V[[15, 36, 40]])
    words = ("imprint", "bad.ply", "--curve", "curve.json", "--output", "out.ply", "--map", "map.json", "--report", "r.json")
    refused(1, *words, "--strict", says=[word])
    succeed(run(*words))
    mesh = trimesh.load(tmp_path / "out.ply", process=False)
    map_ = json.loads((tmp_path / "map.json").read_text())
    check_origins(V, F, mesh, map_, {f for name in GONE for f in repair[name]})
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["repair"] == repair and len(report["parts"]) >= 2
    quality = map_["quality"]
    assert all(np.allclose(quality[name], np.nan_to_num(at) @ [1.0, 2.0, 3.0]) for name, at in (("input", V), ("output", mesh.vertices)))
    by_curve = (tmp_path / "out.ply").read_bytes()
    succeed(run("imprint", "bad.ply", "--picks", "picks.json", "--field", "none", "--output", "out.ply"))
    assert (tmp_path / "out.ply").read_bytes() == by_curve


def test_all_verbs_take_a_scan_with_many_bad_spots(run, tmp_path):
    V, F = scan_with_bad_spots()
    along = V[:, V.std(0).argmax()]
    is_inner = np.bincount(F.ravel(), minlength=len(V)) > 3  # on no flap
    ring = np.flatnonzero(is_inner & (np.abs(along - np.median(along)) < 0.02 * np.ptp(along)))
    across = V[ring] - V[ring].mean(0)
    first, second = np.linalg.svd(across, full_matrices=False)[2][:2]
    turns = np.arctan2(across @ first, across @ second)
    picks = V[ring[[np.abs(turns - turn).argmin() for turn in (-2.5, -1, 0.5, 2)]]]
    repair = draw(run, tmp_path, V, F, picks)
    curve = ("bad.ply", "--curve", "curve.json")
    succeed(run("imprint", *curve, "--output", "out.ply", "--map", "map.json"))
    mesh = trimesh.load(tmp_path / "out.ply", process=False)
    map_ = json.loads((tmp_path / "map.json").read_text())
    check_origins(V, F, mesh, map_, {f for name in GONE for f in repair[name]})
    succeed(run("cut", *curve, "--output", "half.ply", "--keep", "largest", "--fill", "smooth"))
    assert trimesh.load(tmp_path / "half.ply", process=False).area < 0.99 * mesh.area
    succeed(run("cut", *curve, "--output", "relief.ply", "--keep", "smallest", "--relief", 0.01 * np.ptp(along)))
    succeed(run("segment", *curve, "--output", "parts.ply"))
    distance = 0.02 * np.ptp(along)
    succeed(run("offset", *curve, "--distance", distance, "--output", "beside.json", "--band", "band.ply"))
    line = json.loads((tmp_path / "beside.json").read_text())["polyline"]
    given = (V[F[line["faces"]]] * np.array(line["barycentrics"])[:, :, None]).sum(1)
    assert np.abs(given - line["points"]).max() < 1e-9
    succeed(run("imprint", "bad.ply", "--curve", "beside.json", "--output", "out.ply"))
    pattern = ("--drawing", "square.svg", "--size", distance)
    (tmp_path / "square.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H1V1H0Z"/></svg>')
    succeed(run("pattern", *curve[:1], "--along", "curve.json", *pattern, "--output", "squares.json"))
    succeed(run("imprint", "bad.ply", "--curve", "squares.json", "--output", "out.ply"))


def test_a_curve_from_sheet_to_sheet_is_imprinted_but_has_no_offset(run, tmp_path):
    """Three plates that meet in an edge; mending leaves the two that bend least joined."""
    V, F = meshes.plate(cells=6)
    half = V[:, 0] >= 0.5 - 1e-9
    wall = F[half[F].all(1)]
    ids = np.where(np.isclose(V[:, 0], 0.5), np.arange(len(V)), -1)
    up = np.flatnonzero(half & (ids < 0))
    ids[up] = len(V) + np.arange(len(up))
    raised = np.stack([0.5 + 0 * V[up, 0], V[up, 1], V[up, 0] - 0.5], 1)
    V, F = np.vstack([V, raised]), np.vstack([F, ids[wall]])
    meshes.write_ply(tmp_path / "bad.ply", V, F)
    (tmp_path / "picks.json").write_text(json.dumps({"picks": [[0.2, 0.5, 0], [0.5, 0.4, 0.3]]}))
    succeed(run("bad.ply", "--picks", "picks.json", "--output", "curve.json"))
    for words in (("--curve", "curve.json"), ("--picks", "picks.json")):
        succeed(run("imprint", "bad.ply", *words, "--output", "out.ply", "--map", "map.json"))
        mesh = trimesh.load(tmp_path / "out.ply", process=False)
        map_ = json.loads((tmp_path / "map.json").read_text())
        check_origins(V, F, mesh, map_, set())
        edges = set(map(tuple, np.sort(mesh.edges, axis=1).tolist()))
        along = map_["curves"][0]["vertices"]
        assert all(tuple(sorted(pair)) in edges for pair in zip(along, along[1:]))
        points = json.loads((tmp_path / "curve.json").read_text())["polyline"]["points"]
        gaps = np.linalg.norm(mesh.vertices[along][None] - np.array(points)[:, None], axis=2)
        assert gaps.min(1).max() < 1e-12
        (tmp_path / "out.ply").unlink()
    process = run("offset", "bad.ply", "--curve", "curve.json", "--distance", 0.05, "--output", "beside.json")
    assert process.returncode == 1 and not (tmp_path / "beside.json").exists()
    line = process.stderr.splitlines()[-1]
    assert "from sheet to sheet" in line and "move its picks" in line


def test_welded_parts_are_imprinted_as_one(run, tmp_path):
    V, F = meshes.plate(cells=8)
    V, F = np.vstack([V, V + [1 + 1e-8, 0, 0]]), np.vstack([F, F + len(V)])
    meshes.write_ply(tmp_path / "halves.ply", V, F)
    (tmp_path / "picks.json").write_text(json.dumps({"picks": V[[20, 100, 140]].tolist()}))
    weld = ("--weld", "1e-6")
    succeed(run("halves.ply", "--picks", "picks.json", "--output", "curve.json", *weld))
    succeed(run("imprint", "halves.ply", "--curve", "curve.json", "--output", "out.ply", "--map", "map.json", *weld))
    mesh = trimesh.load(tmp_path / "out.ply", process=False)
    map_ = json.loads((tmp_path / "map.json").read_text())
    assert len(mesh.split(only_watertight=False)) == 1 and {0, 1} == {int(f >= len(F) / 2) for f in map_["parents"]}


def vertex_values(mesh):
    return mesh.metadata["_ply_raw"]["vertex"]["data"]["quality"].ravel()


def test_seams_are_left_as_they_are(run, tmp_path):
    """A closed curve over the seam of two halves: ids stay, and the values of either half."""
    V, F, values = meshes.halved_plate()
    meshes.write_ply(tmp_path / "halves.ply", V, F, quality=values)
    picks = [[0.3, 0.3, 0], [0.7, 0.35, 0], [0.7, 0.7, 0], [0.3, 0.65, 0]]
    (tmp_path / "picks.json").write_text(json.dumps({"picks": picks, "closed": True}))
    curve = ("halves.ply", "--curve", "curve.json")
    succeed(run("halves.ply", "--picks", "picks.json", "--field", "none", "--output", "curve.json"))
    succeed(run("imprint", *curve, "--output", "out.ply", "--map", "map.json", "--report", "report.json"))
    mesh = trimesh.load(tmp_path / "out.ply", process=False)
    map_, report = (json.loads((tmp_path / name).read_text()) for name in ("map.json", "report.json"))
    check_origins(V, F, mesh, map_, set())
    assert len(report["parts"]) == 2 and report["vertices"] == len(mesh.vertices)
    assert report["new_vertices"] == len(mesh.vertices) - len(V)
    # Faces that no curve passes are those of the input.
    children = np.bincount(map_["parents"])
    whole = children[map_["parents"]] == 1
    assert np.array_equal(mesh.faces[whole], F[np.array(map_["parents"])[whole]])
    # Each face has the values of its half, in new vertices too.
    is_right = V[F].mean(1)[:, 0] > 0.5
    expected = mesh.vertices[mesh.faces] @ [1.0, 2.0, 0.0] + 10.0 * is_right[map_["parents"]][:, None]
    assert np.allclose(vertex_values(mesh)[mesh.faces], expected, atol=1e-9)
    doubled = mesh.vertices[len(V) :][mesh.vertices[len(V) :, 0] == 0.5]
    assert len(doubled) == 4 and len(np.unique(doubled, axis=0)) == 2
    # Neighbours on a curve are at the ends of an edge on one side or the other.
    place = {tuple(p): i for i, p in enumerate(mesh.vertices)}
    ids = np.array([place[tuple(p)] for p in mesh.vertices])
    edges = {tuple(sorted(pair)) for pair in ids[mesh.edges].tolist()}
    (chain,) = map_["curves"]
    along = ids[chain["vertices"]].tolist()
    assert all(tuple(sorted(pair)) in edges for pair in zip(along, along[1:] + along[:1]))
    for words in (["--keep", "smallest"], ["--keep", "largest", "--fill", "smooth"], ["--keep", "inside", "--relief", 0.05]):
        succeed(run("cut", *curve, "--output", "cut.ply", *words))
        cut = trimesh.load(tmp_path / "cut.ply", process=False)
        labels = cut.metadata["_ply_raw"]["face"]["data"]["label"].ravel()
        kept = cut.vertices[cut.faces[labels >= 0]]
        expected = kept @ [1.0, 2.0, 0.0] + 10.0 * (kept.mean(1)[:, :1] > 0.5)
        assert np.allclose(vertex_values(cut)[cut.faces[labels >= 0]], expected, atol=1e-9)
    succeed(run("segment", *curve, "--output", "parts.ply"))
    parts = trimesh.load(tmp_path / "parts.ply", process=False)
    assert np.array_equal(parts.vertices, mesh.vertices) and np.array_equal(parts.faces, mesh.faces)
