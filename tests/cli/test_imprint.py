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
        run.ok("hill.ply", "--picks", "picks.json", "--field", "none", "--output", f"curve-{k}.json")
    return vertices, faces, quality


CURVES = ("--curve", "curve-0.json", "--curve", "curve-1.json")


def test_curves_are_edges_and_children_fill_their_parents(run, tmp_path, drawn):
    vertices, faces, quality = drawn
    run.ok("imprint", "hill.ply", *CURVES, "--output", "out.ply", "--map", "map.json", "--report", "report.json")
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
        run.ok("imprint", "hill.ply", *CURVES, "--output", name)
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
    run.ok("imprint", "hill.ply", "--curve", "old.json", "--output", "new.ply")
    refused(1, "imprint", "hill.ply", *CURVES, "--output", "out.xyz", says=["meshes are written as .ply, .obj, .off or .stl"])
    refused(2, "imprint", "hill.ply", *CURVES, "--output", "out.ply", "--snap", 0.5, says=["must be in [0, 0.01]"])
    refused(2, "imprint", "hill.ply", "--output", "out.ply", says=["--curve or --picks is required"])
    assert not (tmp_path / "out.ply").exists()


@pytest.mark.parametrize("extension", ["ply", "obj", "dxf"])
def test_polylines_of_other_formats_are_projected(run, refused, tmp_path, drawn, extension):
    """What was written and read again is where it was drawn, up to rounding."""
    run.ok("imprint", "hill.ply", "--curve", "curve-0.json", "--output", "exact.ply", "--map", "exact.json")
    line = json.loads((tmp_path / "curve-0.json").read_text())["polyline"]["points"]
    write_polyline(tmp_path / f"line.{extension}", line)
    words = ("--curve", f"line.{extension}", "--output", "out.ply", "--map", "map.json", "--report", "report.json")
    run.ok("imprint", "hill.ply", *words)
    exact, other = (trimesh.load(tmp_path / name, process=False) for name in ("exact.ply", "out.ply"))
    ids = json.loads((tmp_path / "map.json").read_text())["curves"][0]["vertices"]
    first = json.loads((tmp_path / "exact.json").read_text())["curves"][0]["vertices"]
    gaps = np.linalg.norm(other.vertices[ids][:, None] - exact.vertices[first][None], axis=2).min(axis=1)
    assert gaps.max() < 1e-6
    assert json.loads((tmp_path / "report.json").read_text())["seconds"]["draw"] > 0
    write_polyline(tmp_path / f"far.{extension}", np.array(line) + [0, 0, 0.05])
    far = ("imprint", "hill.ply", "--curve", f"far.{extension}", "--output", "far.ply")
    refused(1, *far, says=[f"far.{extension}: is not near the mesh: vertex 0", "larger --max-distance"])
    run.ok(*far, "--max-distance", 0.06)


def write_polyline(path, points):
    """An open polyline: elements of PLY, statements of OBJ, or lines of DXF."""
    points = np.array(points)
    ends = list(zip(range(len(points)), range(1, len(points))))
    rows = ["%.17g %.17g %.17g" % tuple(p) for p in points]
    if path.suffix == ".ply":
        head = ["ply", "format ascii 1.0", f"element vertex {len(points)}", *(f"property double {x}" for x in "xyz")]
        head += [f"element edge {len(ends)}", "property int vertex1", "property int vertex2", "end_header"]
        text = "\n".join(head + rows + [f"{a} {b}" for a, b in ends]) + "\n"
    elif path.suffix == ".obj":
        text = "\n".join(["v " + row for row in rows] + [f"l {a + 1} {b + 1}" for a, b in ends]) + "\n"
    else:
        pairs = [(0, "SECTION"), (2, "ENTITIES")]
        for a, b in ends:
            pairs += [(0, "LINE"), (8, "0")] + [(10 * (k + 1) + e, "%.17g" % points[i][k]) for e, i in ((0, a), (1, b)) for k in range(3)]
        text = "".join(f"{code}\n{value}\n" for code, value in [*pairs, (0, "ENDSEC"), (0, "EOF")])
    path.write_text(text)


def test_every_verb_draws_curves_through_picks_first(run, refused, tmp_path, drawn):
    """A curve that is drawn on the way is the one that is drawn alone."""
    vertices = drawn[0]
    centre, size = vertices.mean(axis=0), np.ptp(vertices[:, 0])
    near = lambda u, v: vertices[np.abs(vertices[:, :2] - centre[:2] - [u * size, v * size]).sum(axis=1).argmin()].tolist()  # noqa: E731
    ring = [near(-0.2, -0.2), near(0.2, -0.2), near(0.2, 0.2), near(-0.2, 0.2)]
    (tmp_path / "ring.json").write_text(json.dumps({"picks": ring, "closed": True}))
    options = ("--field", "none", "--tension", 0.3)
    run.ok("hill.ply", "--picks", "ring.json", *options, "--output", "ring-curve.json")
    for verb, *more in (["imprint"], ["cut"], ["segment"], ["offset", "--distance", 0.05]):
        outputs = []
        for name, words in (("drawn", ("--picks", "ring.json", *options)), ("read", ("--curve", "ring-curve.json"))):
            extension = "json" if verb == "offset" else "ply"
            run.ok(verb, "hill.ply", *words, *more, "--output", f"{verb}-{name}.{extension}")
            outputs.append((tmp_path / f"{verb}-{name}.{extension}").read_bytes())
        assert outputs[0] == outputs[1], verb
    both = run.ok("imprint", "hill.ply", "--picks", "ring.json", *options, *CURVES, "--output", "both.ply", "--map", "both.json")
    assert [c["closed"] for c in json.loads((tmp_path / "both.json").read_text())["curves"]] == [False, False, True]
    refused(2, "imprint", "hill.ply", *CURVES, *options, "--output", "out.ply", says=["options of curves are for --picks"])
    (tmp_path / "off.json").write_text(json.dumps({"picks": [ring[0], [9, 9, 9]]}))
    refused(1, "cut", "hill.ply", "--picks", "off.json", "--output", "out.ply", says=["pick 2"])


def test_lines_are_draped_along_a_direction_with_a_note(run, refused, tmp_path):
    """A plan far above a hill that it leaves: its shadow, in two parts."""
    meshes.write_ply(tmp_path / "hill.ply", *meshes.plate(height=0.2))
    plan = np.array([[0.2, 0.3, 5], [0.8, 0.4, 9], [1.3, 0.5, 5], [0.8, 0.6, 5], [0.2, 0.7, 5]])
    (tmp_path / "plan.obj").write_text("".join("v %g %g %g\n" % tuple(p) for p in plan) + "l 1 2 3 4 5\n")
    refused(1, "imprint", "hill.ply", "--curve", "plan.obj", "--output", "out.ply", says=["is not near the mesh"])
    note = run.ok("imprint", "hill.ply", "--curve", "plan.obj", "--direction", "0,0,-1", "--output", "out.ply", "--map", "map.json").stderr
    assert "plan.obj: along the direction it is beside the mesh 1 time (first behind vertex 1), and parted there" in note
    made = json.loads((tmp_path / "map.json").read_text())
    assert [curve["closed"] for curve in made["curves"]] == [False, False]
    run.ok("points", "hill.ply", "--curve", "plan.obj", "--direction", "0,0,-1", "--distances", "0", "--output", "points.json")
    starts = [curve["points"][0]["position"] for curve in json.loads((tmp_path / "points.json").read_text())["curves"]]
    assert np.allclose(np.array(starts)[:, :2], [[0.2, 0.3], [1, 0.56]], rtol=0, atol=1e-12)
    refused(1, "imprint", "hill.ply", "--curve", "plan.obj", "--direction", "1,0,0", "--output", "b.ply", says=["nothing of it meets"])
    refused(2, "imprint", "hill.ply", "--curve", "plan.obj", "--direction", "0,0,0", "--output", "b.ply", says=["not all 0"])
    refused(1, "cut", "hill.ply", "--curve", "plan.obj", "--direction", "0,0,-1", "--max-distance", 1, "--output", "b.ply",
            says=["away from the mesh along the direction"])
