# SPDX-License-Identifier: GPL-3.0-or-later
"""The verbs cut and segment: the mesh opened along curves, and the parts between them."""

import csv
import json
import re

import made_meshes as meshes
import numpy as np
import pytest
import trimesh

RING = ("--curve", "ring.json")


def load(path):
    return trimesh.load(path, process=False)


def labels(mesh):
    return mesh.metadata["_ply_raw"]["face"]["data"]["label"].ravel()


@pytest.fixture
def ring(run, tmp_path):
    """A closed curve on a hill, ring.json; an open one, slit.json; vertices and faces."""
    vertices, faces = meshes.plate(cells=12, height=0.2)
    meshes.write_ply(tmp_path / "hill.ply", vertices, faces, vertices @ [1.0, 2.0, 0.0])
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    at = lambda u, v: vertices[np.abs(vertices - (low + (high - low) * [u, v, 0]))[:, :2].sum(axis=1).argmin()].tolist()  # noqa: E731
    for name, picks, words in (
        ("ring", [at(0.3, 0.3), at(0.7, 0.35), at(0.7, 0.7), at(0.3, 0.65)], ["--closed"]),
        ("slit", [at(0.2, 0.15), at(0.8, 0.2)], []),
    ):
        (tmp_path / "picks.json").write_text(json.dumps({"picks": picks}))
        (tmp_path / f"picks-of-{name}.json").write_text(json.dumps({"picks": picks}))
        run.ok("hill.ply", "--picks", "picks.json", "--field", "none", "--output", f"{name}.json", *words)
    return vertices, faces


def test_parts_have_their_own_rims_and_fill_the_mesh(run, tmp_path, ring):
    run.ok("cut", "hill.ply", *RING, "--output", "cut.ply", "--report", "report.json")
    mesh, whole = load(tmp_path / "cut.ply"), trimesh.Trimesh(*ring, process=False)
    report = json.loads((tmp_path / "report.json").read_text())
    assert mesh.area == pytest.approx(whole.area, rel=1e-12)
    assert mesh.body_count == len(report["parts"]) == 2
    assert [part["euler"] for part in report["parts"]] == [0, 1]
    assert report["kept"] == [0, 1]
    assert len(mesh.vertices) == report["vertices"] + report["doubled_vertices"]
    # The two sides' rims are the same points.
    inner = mesh.submesh([labels(mesh) == 1], append=True, repair=False)
    shared = {tuple(v) for v in mesh.vertices[np.unique(mesh.faces[labels(mesh) == 0])]} & {tuple(v) for v in inner.vertices}
    assert len(shared) == report["doubled_vertices"]


def test_split_writes_every_part_and_keep_one(run, tmp_path, ring):
    run.ok("cut", "hill.ply", *RING, "--output", "all.ply", "--split")
    outer, inner = load(tmp_path / "all.ply"), load(tmp_path / "all-2.ply")
    assert outer.area > inner.area
    assert outer.area + inner.area == pytest.approx(trimesh.Trimesh(*ring, process=False).area, rel=1e-12)
    seed = ",".join(str(x) for x in inner.triangles_center[0])
    for keep, part in (("largest", outer), ("smallest", inner), ("inside", inner), (f"seed={seed}", inner)):
        run.ok("cut", "hill.ply", *RING, "--output", "one.ply", "--keep", keep)
        one = load(tmp_path / "one.ply")
        assert np.array_equal(one.vertices, part.vertices) and np.array_equal(one.faces, part.faces), keep
        quality = one.metadata["_ply_raw"]["vertex"]["data"]["quality"].ravel()
        assert np.allclose(quality, one.vertices @ [1.0, 2.0, 0.0], atol=1e-9)


@pytest.mark.parametrize("fill", ["flat", "smooth"])
def test_parts_of_a_solid_become_solids(run, tmp_path, fill):
    """A ball in three slices by two rings, and a box that no curve touches."""
    ball, box = trimesh.creation.icosphere(4), trimesh.creation.box(bounds=[[2, 2, 2], [3, 3, 3]])
    both = trimesh.util.concatenate([ball, box])
    meshes.write_ply(tmp_path / "ball.ply", both.vertices, both.faces)
    rings = []
    for height in (-0.31, 0.42):
        angles = np.linspace(0, 2 * np.pi, 80)
        radius = np.sqrt(1 - height**2)
        points = np.stack([radius * np.cos(angles), radius * np.sin(angles), np.full(80, height)], axis=1)
        name = f"ring{len(rings)}.obj"
        lines = "".join(f"v {x} {y} {z}\n" for x, y, z in points[:-1]) + "l " + " ".join(map(str, [*range(1, 80), 1]))
        (tmp_path / name).write_text(lines)
        rings += ["--curve", name]
    run.ok("cut", "ball.ply", *rings, "--split", "--fill", fill, "--output", "part.ply")
    parts = [load(tmp_path / f"part{number}.ply") for number in ("", "-2", "-3", "-4")]
    assert all(part.is_watertight and part.is_winding_consistent for part in parts)
    box_part = next(part for part in parts if np.allclose(part.bounds[0], 2))
    assert box_part.volume == pytest.approx(1, rel=1e-12)
    slices = sorted((part for part in parts if part is not box_part), key=lambda part: part.triangles_center[:, 2].mean())
    if fill == "smooth":
        return
    assert sum(part.volume for part in slices) == pytest.approx(ball.volume, rel=1e-9)
    for below, above in zip(slices[:-1], slices[1:]):
        caps = []
        for part, normal in ((below, 1), (above, -1)):
            new = labels(part) == -1
            own = new & (normal * part.face_normals[:, 2] > 0)
            caps.append({frozenset(map(tuple, triangle)) for triangle in part.triangles[own]})
        assert caps[0] == caps[1] and len(caps[0]) > 20


def test_several_seeds_and_what_no_curve_touches(run, tmp_path, ring):
    vertices, faces = ring
    apart = vertices + [0.0, 0.0, 5.0]
    both = np.concatenate([vertices, apart]), np.concatenate([faces, faces + len(vertices)])
    meshes.write_ply(tmp_path / "two.ply", *both)
    run.ok("cut", "hill.ply", *RING, "--output", "all.ply", "--split")
    seeds = [load(tmp_path / name).triangles_center[0] for name in ("all.ply", "all-2.ply")]
    words = "seed=" + ";".join(",".join(map(str, seed)) for seed in seeds)
    whole = trimesh.Trimesh(*ring, process=False).area
    run.ok("cut", "hill.ply", *RING, "--keep", words, "--output", "one.ply")
    assert load(tmp_path / "one.ply").area == pytest.approx(whole, rel=1e-12)
    run.ok("two.ply", "--picks", "picks-of-ring.json", "--closed", "--field", "none", "--output", "ring-of-two.json")
    cut = ("cut", "two.ply", "--curve", "ring-of-two.json", "--output", "kept.ply", "--keep")
    run.ok(*cut, "inside")
    inside = load(tmp_path / "kept.ply").area
    run.ok(*cut, "outside")
    assert inside + load(tmp_path / "kept.ply").area == pytest.approx(3 * whole, rel=1e-12)  # the other plate is in both
    result = run(*cut, "inside", "--drop-untouched")
    assert (result.returncode, result.stderr) == (0, "bspline_curve: note: dropped: 1 component that no curve parts\n")
    assert load(tmp_path / "kept.ply").area == pytest.approx(inside - whole, rel=1e-9)


@pytest.mark.parametrize("shape", ["flat", "smooth"])
def test_the_hole_that_a_part_leaves_is_filled(run, tmp_path, ring, shape):
    words = ("cut", "hill.ply", *RING, "--keep", "largest", "--output")
    run.ok(*words, "open.ply")
    run.ok(*words, "filled.ply", "--fill", shape, "--report", "report.json")
    hole, filled = load(tmp_path / "open.ply"), load(tmp_path / "filled.ply")
    assert hole.euler_number == 0 and filled.euler_number == 1
    assert set(map(tuple, hole.vertices.tolist())) <= set(map(tuple, filled.vertices.tolist()))
    assert filled.area_faces[labels(filled) >= 0].sum() == pytest.approx(hole.area, rel=1e-12)
    assert (len(filled.vertices) > len(hole.vertices)) == (shape == "smooth")
    assert (labels(filled) == -1).sum() == len(filled.faces) - len(hole.faces)
    assert json.loads((tmp_path / "report.json").read_text())["filled_holes"] == 1


@pytest.mark.parametrize("height", [0.05, -0.05])
def test_a_part_is_moved_along_its_normals(run, tmp_path, ring, height):
    result = run("cut", "hill.ply", *RING, "--keep", "inside", "--relief", height, "--output", "relief.ply")
    assert (result.returncode, result.stderr) == (0, "")
    run.ok("imprint", "hill.ply", *RING, "--output", "imprint.ply")
    relief, imprint = load(tmp_path / "relief.ply"), load(tmp_path / "imprint.ply")
    kept = len(imprint.faces)
    assert relief.euler_number == 1  # the plate, with a step
    assert np.array_equal(labels(relief)[:kept], labels(imprint)) and (labels(relief)[kept:] == -1).all()
    moved = relief.triangles[:kept] - imprint.triangles
    assert (moved[labels(imprint) == 0] == 0).all()
    of_part = labels(imprint) == 1
    # Faces come to lie at the height, in the mean of those at a vertex.
    lifted = np.einsum("fki,fi->f", moved[of_part], imprint.face_normals[of_part]) / 3
    assert np.average(lifted, weights=imprint.area_faces[of_part]) == pytest.approx(height, rel=1e-6)
    assert np.linalg.norm(moved[of_part], axis=-1) == pytest.approx(abs(height), rel=0.01)
    assert (np.sign(moved[of_part][..., 2]) == np.sign(height)).all()


def test_a_relief_without_room_is_lower_and_says_so(run, tmp_path, ring):
    result = run("cut", "hill.ply", *RING, "--keep", "inside", "--relief", -5, "--output", "relief.ply")
    assert result.returncode == 0 and re.search(r"the relief is lower than asked at \d+ vertices, at least [\d.e-]+, since", result.stderr)


def is_solid(mesh):
    return mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0


@pytest.mark.parametrize("thickness", [0.01, -0.01])
def test_a_part_becomes_a_wall(run, tmp_path, ring, thickness):
    result = run("cut", "hill.ply", *RING, "--keep", "inside", "--thickness", thickness, "--output", "wall.ply")
    assert (result.returncode, result.stderr) == (0, "")
    run.ok("cut", "hill.ply", *RING, "--keep", "inside", "--output", "part.ply")
    wall, part = load(tmp_path / "wall.ply"), load(tmp_path / "part.ply")
    assert is_solid(wall)
    assert wall.volume == pytest.approx(abs(thickness) * part.area, rel=0.05)
    assert (labels(wall)[: len(part.faces)] == 1).all() and (labels(wall)[len(part.faces) :] == -1).all()


def test_walls_of_two_parts_fit_each_other(run, tmp_path, ring):
    run.ok("cut", "hill.ply", *RING, "--split", "--thickness", 0.02, "--output", "wall.ply")
    outer, inner = load(tmp_path / "wall.ply"), load(tmp_path / "wall-2.ply")
    assert is_solid(outer) and is_solid(inner)
    moved = {tuple(v) for v in outer.vertices} & {tuple(v) for v in inner.vertices}
    points = json.loads((tmp_path / "ring.json").read_text())["polyline"]["points"]
    assert len(moved) >= 2 * len(points)


def test_a_wall_without_room_is_thinner_and_says_so(run, tmp_path, ring):
    result = run("cut", "hill.ply", *RING, "--keep", "inside", "--thickness", -5, "--output", "wall.ply")
    assert result.returncode == 0 and is_solid(load(tmp_path / "wall.ply"))
    assert re.search(r"note: the wall is thinner than asked at \d+ vertices, at least [\d.e-]+, since", result.stderr)


def test_a_part_stands_on_a_base(run, tmp_path, ring):
    cut = ("cut", "hill.ply", *RING, "--keep", "inside")
    run.ok(*cut, "--output", "part.ply")
    part = load(tmp_path / "part.ply")
    flat = (part.area_faces * part.face_normals[:, 2]).sum()
    above = (part.area_faces * part.face_normals[:, 2] * part.triangles_center[:, 2]).sum()
    for words, low in ((("--base", 0.3, "--base-direction=0,0,-2"), part.vertices[:, 2].min() - 0.3),
                       (("--base-direction", "0 0 -1", "--base-height", 0.5), -0.5)):
        result = run(*cut, *words, "--output", "die.ply")
        assert (result.returncode, result.stderr) == (0, "")
        die = load(tmp_path / "die.ply")
        assert is_solid(die) and die.vertices[:, 2].min() == pytest.approx(low, abs=1e-12)
        assert die.volume == pytest.approx(above - low * flat, rel=1e-9)
    run.ok(*cut, "--base", 0.3, "--output", "die.ply")
    assert is_solid(load(tmp_path / "die.ply"))


@pytest.mark.parametrize("profile, share", [("step", 1.0), ("ramp", 0.5), ("round", np.pi / 4)])
def test_slots_are_sunk_along_curves(run, tmp_path, ring, profile, share):
    words = ("--slot", "0.08,0.02", "--profile", profile)
    result = run("cut", "hill.ply", "--curve", "slit.json", *RING, *words, "--output", "slot.ply")
    assert (result.returncode, result.stderr) == (0, "")
    slot, whole = load(tmp_path / "slot.ply"), trimesh.Trimesh(*ring, process=False)
    assert slot.is_winding_consistent and slot.euler_number == 1  # the plate, with grooves
    under = lambda mesh: (mesh.area_faces * mesh.face_normals[:, 2] * mesh.triangles_center[:, 2]).sum()  # noqa: E731
    length = sum(
        np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
        for points in (
            np.vstack([told["points"], told["points"][:1]] if closed else told["points"])
            for name, closed in (("slit", False), ("ring", True))
            for told in [json.loads((tmp_path / f"{name}.json").read_text())["polyline"]]
        )
    )
    assert under(whole) - under(slot) == pytest.approx(share * 0.08 * 0.02 * length, rel=0.06)  # without ends and bends
    # --slot is short for the two.
    run.ok("cut", "hill.ply", "--curve", "slit.json", *RING, "--stroke", 0.08, "--relief", -0.02, "--profile", profile,
           "--output", "same.ply")
    assert (tmp_path / "same.ply").read_bytes() == (tmp_path / "slot.ply").read_bytes()


def test_an_open_curve_becomes_a_slit(run, tmp_path, ring):
    result = run("cut", "hill.ply", "--curve", "slit.json", "--split", "--output", "slit.ply")
    assert result.returncode == 0 and not (tmp_path / "slit-2.ply").exists()
    note = r"bspline_curve: note: the curve parts nothing: the mesh is cut open along it \((\d+) edges\), a slit that is closed to the eye; draw"
    edges = int(re.match(note, result.stderr).group(1))
    mesh = load(tmp_path / "slit.ply")
    assert mesh.body_count == 1
    assert mesh.euler_number == 0  # the plate's 1, less a hole
    assert len(mesh.vertices) - len(np.unique(mesh.vertices, axis=0)) == edges - 1  # all but its ends are doubled
    both = run("cut", "hill.ply", *RING, "--curve", "slit.json", "--keep", "inside", "--output", "part.ply")
    assert both.returncode == 0 and "1 of 2 curves parts nothing; draw" in both.stderr
    assert run("segment", "hill.ply", *RING, "--curve", "slit.json", "--output", "parts.ply").stderr == both.stderr


def test_what_parts_the_mesh_is_not_warned_of(run, tmp_path, ring):
    vertices, _ = ring
    low, high = vertices[[0, -1]].tolist()
    (tmp_path / "picks.json").write_text(json.dumps({"picks": [low, high]}))
    run.ok("hill.ply", "--picks", "picks.json", "--field", "none", "--output", "across.json")
    for curves in (("--curve", "across.json"), RING):
        result = run("cut", "hill.ply", *curves, "--output", "cut.ply")
        assert (result.returncode, result.stderr) == (0, "")
        assert load(tmp_path / "cut.ply").body_count == 2


def test_components_that_no_curve_parts_stay_in_one_file(run, tmp_path, ring):
    vertices, faces = ring
    copies = [vertices, *(0.1 * vertices + [shift, 0, 0] for shift in (50, 60))]
    meshes.write_ply(tmp_path / "three.ply", np.vstack(copies), np.vstack([faces + i * len(vertices) for i in range(3)]))
    points = json.loads((tmp_path / "ring.json").read_text())["polyline"]["points"]
    (tmp_path / "ring.obj").write_text(
        "".join("v %r %r %r\n" % tuple(p) for p in points) + f"l {' '.join(str(i + 1) for i in range(len(points)))} 1\n"
    )
    result = run.ok("cut", "three.ply", "--curve", "ring.obj", "--split", "--output", "part.ply")
    assert (result.stdout, result.stderr) == ("part.ply: 3 meshes, the last in part-3.ply\n", "")
    assert [load(tmp_path / f"part{end}.ply").body_count for end in ("", "-2", "-3")] == [1, 1, 2]


def test_segments_are_labelled_coloured_and_measured(run, tmp_path, ring):
    run.ok("segment", "hill.ply", *RING, "--output", "parts.ply", "--table", "parts.csv")
    mesh = load(tmp_path / "parts.ply")
    assert mesh.euler_number == 1  # still whole
    raw = mesh.metadata["_ply_raw"]["face"]["data"]
    colours = {(int(raw["label"][f]), *(int(raw[c][f]) for c in ("red", "green", "blue"))) for f in range(len(mesh.faces))}
    assert len(colours) == 2
    rows = list(csv.DictReader((tmp_path / "parts.csv").open()))
    assert [int(row["part"]) for row in rows] == [0, 1]
    for label, row in enumerate(rows):
        chosen = labels(mesh) == label
        assert int(row["faces"]) == chosen.sum()
        assert float(row["area"]) == pytest.approx(mesh.area_faces[chosen].sum(), rel=1e-12)
        centre = np.average(mesh.triangles_center[chosen], axis=0, weights=mesh.area_faces[chosen])
        assert np.allclose([float(row[f"centroid_{axis}"]) for axis in "xyz"], centre, atol=1e-12)
    run.ok("segment", "hill.ply", *RING, "--output", "parts.ply", "--table", "parts.json")
    table = json.loads((tmp_path / "parts.json").read_text())
    assert [part["area"] for part in table["parts"]] == [float(row["area"]) for row in rows]


def test_refuses_by_name_and_writes_nothing(refused, tmp_path, ring):
    cut = ("cut", "hill.ply", *RING, "--output", "out.ply")
    refused(2, *cut, "--keep", "biggest", says=["is none of all|largest|smallest|inside|outside|seed=x,y,z"])
    refused(2, *cut, "--keep", "seed=1,2", says=["--keep"])
    refused(2, *cut, "--relief", "1", says=["--relief", "--keep"])
    refused(2, *cut, "--keep", "inside", "--relief", "nan", says=["--relief"])
    refused(2, *cut, "--keep", "inside", "--fill", "flat", "--relief", "1", says=["--relief", "--fill"])
    refused(2, *cut, "--keep", "largest", "--split", says=["--split"])
    refused(2, *cut, "--fill", "flat", says=["--fill", "--keep or --split"])
    refused(2, *cut, "--thickness", "1", says=["--thickness", "--keep"])
    refused(2, *cut, "--base", "1", says=["--base", "--split"])
    refused(2, *cut, "--keep", "inside", "--base", "1", "--thickness", "1", says=["--base", "--thickness"])
    refused(2, *cut, "--slot", "1,0", says=["--slot"])
    refused(2, *cut, "--slot", "1", says=["--slot"])
    refused(2, *cut, "--keep", "inside", "--profile", "ramp", says=["profile", "relief"])
    refused(1, *cut, "--keep", "inside", "--base-direction", "0,0,-1", "--base-height=-9", says=["the base", "beyond the plane"])
    refused(1, *cut, "--stroke", "99", says=["no point of the surface"])
    refused(2, *cut, "--keep", "largest", "--fill", "round", says=["--fill", "none"])
    point = json.loads((tmp_path / "ring.json").read_text())["polyline"]["points"][3]
    refused(1, *cut, "--keep", "seed=" + ",".join(map(str, point)), says=["the seed", "lies on a curve"])
    refused(1, *cut, "--keep", "seed=0,0,9", says=["the seed", "away from the mesh"])
    slit = ("hill.ply", "--curve", "slit.json", "--output", "out.ply")
    refused(1, "cut", *slit, "--keep", "largest", says=["the curves part nothing"])
    refused(1, "segment", *slit, says=["the curves part nothing"])
    refused(1, "segment", "hill.ply", *RING, "--output", "out.obj", says=["labels of faces are written as .ply"])
    refused(1, "segment", "hill.ply", *RING, "--output", "out.ply", "--table", "t.xls", says=["tables are written as .csv or .json"])
    vertices, faces = meshes.plate(cells=12, height=0.3)
    meshes.write_ply(tmp_path / "other.ply", vertices, faces)
    refused(1, "cut", "other.ply", *RING, "--output", "out.ply", says=["ring.json: the mesh changed since the curve was drawn"])
    assert not (tmp_path / "out.ply").exists()


def test_refuses_where_there_is_nothing_to_cut(refused, tmp_path):
    vertices, faces = meshes.plate(cells=2)
    meshes.write_ply(tmp_path / "plate.ply", vertices, faces)
    face = faces[0]
    edge = {"closed": False, "polyline": {"points": vertices[face[:2]].tolist(), "faces": [0, 0], "barycentrics": [[1, 0, 0], [0, 1, 0]]}}
    (tmp_path / "edge.json").write_text(json.dumps(edge))
    refused(1, "cut", "plate.ply", "--curve", "edge.json", "--output", "out.ply", says=["nothing to cut"])
