# SPDX-License-Identifier: GPL-3.0-or-later
"""Files as other programs and other verbs write them: what one verb writes every other reads, and nothing is lost in silence."""

import json
import os

import ezdxf
import ezdxf.math
import made_meshes as meshes
import numpy as np
import pytest

FORMATS = ["json", "ply", "csv", "vtu"]
PROJECTED = ["obj", "dxf", "bspline.obj", "bspline.dxf"]
RING = [[0.3, 0.3, 0.0], [0.7, 0.3, 0.0], [0.7, 0.7, 0.0], [0.3, 0.7, 0.0]]


def report_of(path):
    return json.loads(path.read_text())


@pytest.fixture
def hill(tmp_path):
    """A hill, and picks of a closed and of an open curve on it."""
    meshes.write_ply(tmp_path / "hill.ply", *meshes.plate(height=0.2))
    for name, picks in [("ring", RING), ("line", meshes.PICKS)]:
        lifted = [[x, y, 0.2 * np.sin(np.pi * x) * np.sin(np.pi * y)] for x, y, _ in picks]
        (tmp_path / f"{name}.json").write_text(json.dumps({"picks": lifted, "closed": name == "ring"}))
    return tmp_path


@pytest.mark.parametrize("name", ["ring", "line"])
def test_every_format_of_curves_is_read_by_every_verb(run, hill, name):
    faces = {}
    for end in FORMATS + PROJECTED:
        run.ok("hill.ply", "--picks", f"{name}.json", "--output", f"curve.{end}")
        run.ok("imprint", "hill.ply", "--curve", f"curve.{end}", "--output", "out.ply", "--map", "map.json")
        made = report_of(hill / "map.json")
        assert [curve["closed"] for curve in made["curves"]] == [name == "ring"], end
        faces[end] = (hill / "out.ply").read_bytes()
    for end in FORMATS[1:]:
        assert faces[end] == faces["json"], end
    run.ok("offset", "hill.ply", "--curve", "curve.vtu", "--distance", 0.05, "--output", "offset.csv")
    (hill / "a.svg").write_text("<svg><circle r='1'/></svg>")
    run.ok("pattern", "hill.ply", "--drawing", "a.svg", "--along", "curve.bspline.dxf", "--size", 0.1, "--output", "row.json")
    if name == "ring":
        run.ok("cut", "hill.ply", "--curve", "curve.bspline.obj", "--keep", "inside", "--output", "inside.ply")
        run.ok("segment", "hill.ply", "--curve", "curve.csv", "--output", "parts.ply")


def test_curves_of_another_mesh_are_projected(run, hill):
    run.ok("hill.ply", "--picks", "line.json", "--output", "curve.ply")
    V, F = meshes.plate(cells=9, height=0.2)
    meshes.write_ply(hill / "other.ply", V, F)
    run.ok("imprint", "other.ply", "--curve", "curve.ply", "--output", "out.ply", "--report", "r.json")
    assert report_of(hill / "r.json")["new_vertices"] > 10


def test_layers_of_a_dxf_are_chosen(run, refused, plate):
    lines = ["0 SECTION", "2 ENTITIES"]
    for layer, radius in [("inner", 0.1), ("outer", 0.3)]:
        lines += ["0 CIRCLE", f"8 {layer}", "10 0.5", "20 0.5", f"40 {radius}"]
    lines += ["0 CIRCLE", "8 inner", "40 0", "0 ENDSEC", "0 EOF"]
    (plate / "a.dxf").write_text("\n".join(line.replace(" ", "\n") for line in lines) + "\n")
    result = run.ok("imprint", "plate.ply", "--curve", "a.dxf", "--output", "out.ply", "--report", "r.json")
    assert "1 entity left out; line 25: a radius that is not > 0" in result.stderr
    assert report_of(plate / "r.json")["curves"] == 2
    run.ok("imprint", "plate.ply", "--curve", "a.dxf", "--layers", "outer", "--output", "out.ply", "--report", "r.json")
    assert report_of(plate / "r.json")["curves"] == 1
    refused(1, "imprint", "plate.ply", "--curve", "a.dxf", "--layers", "walls", "--output", "new.ply",
            says=['no layer "walls" but inner, outer'])


def test_picks_are_read_from_farther_away_where_that_is_asked_for(run, refused, plate):
    (plate / "far.txt").write_text("A,0.1,0.1,0.1\nB,0.9,0.8,0.1\n")
    refused(1, "plate.ply", "--picks", "far.txt", "--output", "a.json", says=["1 % of the diagonal"])
    refused(1, "plate.ply", "--picks", "far.txt", "--pick-distance", 0.05, "--output", "a.json", says=["from the surface, more than is allowed (0.05)"])
    run.ok("plate.ply", "--picks", "far.txt", "--pick-distance", 0.2, "--output", "a.json")
    ends = np.array(report_of(plate / "a.json")["polyline"]["points"])[[0, -1]]
    assert np.allclose(ends, [[0.1, 0.1, 0], [0.9, 0.8, 0]], rtol=0, atol=1e-12)


def test_segments_without_end_are_refused(refused, plate):
    refused(1, "plate.ply", "--picks", "picks.json", "--max-segment-length", 1e-9, "--output", "a.json",
            says=["more than 10000000 segments"])


def write_coloured_ply(path):
    """A plate with colours, normals, texture coordinates, a number of its own and one of faces, all linear; in ASCII."""
    V, F = meshes.plate()
    names = ["float nx", "float ny", "float nz", "uchar red", "uchar green", "uchar blue", "float s", "float t", "int zone",
             "float weight"]
    lines = ["ply", "format ascii 1.0", "comment TextureFile wood.png", f"element vertex {len(V)}"]
    lines += [f"property float {axis}" for axis in "xyz"] + [f"property {name}" for name in names]
    lines += [f"element face {len(F)}", "property list uchar int vertex_indices", "property list uchar float texcoord",
              "property short patch", "end_header"]
    for x, y, z in V:
        lines.append(f"{x:.9g} {y:.9g} 0 0 0 1 {round(200 * x)} {round(200 * y)} 9 {x:.9g} {y:.9g} {int(x > 0.5)} {x + 2 * y:.9g}")
    for i, face in enumerate(F):
        places = " ".join(f"{2 * x:.9g} {3 * y:.9g}" for x, y, _ in V[face])
        lines.append("3 %d %d %d 6 %s %d" % (*face, places, i % 7))
    path.write_text("\n".join(lines) + "\n")
    return V, F


@pytest.mark.parametrize("verb", ["imprint", "cut", "segment"])
def test_attributes_of_ply_go_through(run, plate, verb):
    import trimesh

    V, F = write_coloured_ply(plate / "mesh.ply")
    (plate / "ring.json").write_text(json.dumps({"picks": RING, "closed": True}))
    keep = ["--keep", "inside"] if verb == "cut" else []
    run.ok(verb, "mesh.ply", "--picks", "ring.json", *keep, "--output", "out.ply")
    assert b"comment TextureFile wood.png" in (plate / "out.ply").read_bytes()
    raw = trimesh.load(plate / "out.ply", process=False, skip_materials=True).metadata["_ply_raw"]
    v, f = raw["vertex"]["data"], raw["face"]["data"]
    assert len(v) > len(V) or verb == "cut"
    for name, expected, tolerance in [("red", 200 * v["x"], 1), ("green", 200 * v["y"], 1), ("s", v["x"], 1e-6),
                                      ("weight", v["x"] + 2 * v["y"], 1e-5), ("nz", 1, 1e-6), ("blue", 9, 0)]:
        assert np.abs(v[name] - expected).max() <= tolerance, name
    assert set(np.unique(v["zone"])) == {0, 1}
    corners = f["vertex_indices"]["f1"]
    places = f["texcoord"]["f1"].reshape(-1, 3, 2)
    assert np.abs(places[..., 0] - 2 * v["x"][corners]).max() < 1e-5
    assert np.abs(places[..., 1] - 3 * v["y"][corners]).max() < 1e-5
    assert set(np.unique(f["patch"])) == set(range(7))


def test_groups_materials_and_corners_of_obj_go_through(run, plate):
    V, F = meshes.plate()
    lines = ["mtllib wood.mtl", "o plate"] + ["v %.17g %.17g %.17g" % tuple(p) for p in V]
    lines += ["vt %.17g %.17g" % (2 * x, 3 * y) for x, y, _ in V] + ["vn 0 0 1"]
    for i, face in enumerate(F + 1):
        lines += [f"usemtl m{i // 100}"] if i % 100 == 0 else []
        lines.append("f " + " ".join(f"{k}/{k}/1" for k in face))
    (plate / "mesh.obj").write_text("\n".join(lines) + "\n")
    (plate / "ring.json").write_text(json.dumps({"picks": RING, "closed": True}))
    assert run.ok("imprint", "mesh.obj", "--picks", "ring.json", "--output", "out.obj").stderr == ""
    words = [line.split() for line in (plate / "out.obj").read_text().splitlines()]
    assert [w[1] for w in words if w[0] in ("mtllib", "o")][:2] == ["wood.mtl", "plate"]
    assert {w[1] for w in words if w[0] == "usemtl"} == {"m0", "m1", "m2"}
    v, vt = (np.array([w[1:] for w in words if w[0] == key], dtype=float) for key in ("v", "vt"))
    corners = np.array([[part.split("/") for part in w[1:]] for w in words if w[0] == "f"], dtype=int) - 1
    assert len(corners) > len(F)
    assert np.abs(vt[corners[..., 1]] - v[corners[..., 0]][..., :2] * [2, 3]).max() < 1e-12
    result = run.ok("imprint", "mesh.obj", "--picks", "ring.json", "--output", "out.stl")
    assert "out.stl does not hold normals, texture coordinates, groups and materials of the input" in result.stderr
    assert "groups and materials" in run.ok("imprint", "mesh.obj", "--picks", "ring.json", "--output", "out.ply").stderr


def test_outputs_replace_those_of_an_earlier_run(run, hill):
    """Several offsets first, then one: nothing stale is left, and nothing else is touched."""
    old = hill / "offset-9.ply"
    old.write_text("mine")
    run.ok("hill.ply", "--picks", "ring.json", "--output", "ring.ply")
    run.ok("offset", "hill.ply", "--curve", "ring.ply", "--distance", 0.05, "--output", "offset.ply")
    assert sorted(p.name for p in hill.glob("offset*")) == ["offset-2.ply", "offset-9.ply", "offset.ply"]
    result = run.ok("offset", "hill.ply", "--curve", "ring.ply", "--distance", 0.05, "--side", "left", "--output", "offset.ply")
    assert "1 further file of an earlier run removed, the first offset-2.ply" in result.stderr
    assert sorted(p.name for p in hill.glob("offset*")) == ["offset-9.ply", "offset.ply"]
    # A file that was not written with the first one is somebody's own.
    mine = hill / "offset-2.ply"
    mine.write_text("mine")
    os.utime(mine, (1e9, 1e9))
    run.ok("offset", "hill.ply", "--curve", "ring.ply", "--distance", 0.06, "--side", "left", "--output", "offset.ply")
    assert mine.read_text() == "mine"


def test_headers_of_ply_may_have_blanks_and_a_mark(run, refused, plate):
    V, F = meshes.plate(cells=2)
    body = "".join("%g %g %g\n" % tuple(p) for p in V) + "".join("3 %d %d %d\n" % tuple(f) for f in F)
    head = (f"format ascii 1.0\nelement vertex {len(V)}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {len(F)}\nproperty list uchar int vertex_indices\nend_header\n")
    for start in ["ply \n", "\ufeffply\n", "ply\t\r\n"]:
        (plate / "a.ply").write_text(start + head + body, encoding="utf-8", newline="")
        run.ok("field", "a.ply", "--kind", "ridge", "--output", "a.npy")
    (plate / "b.ply").write_text("ply\n" + head + body.replace("0.5", "0,5"))
    refused(1, "field", "b.ply", "--kind", "ridge", "--output", "b.npy",
            says=['line 11: vertex 1: "0,5" is not a number', "write decimal points"])


def test_a_format_that_moves_vertices_says_so(run, plate):
    V, F = meshes.plate()
    meshes.write_ply(plate / "far.ply", V + [4e5, 5e6, 0], F)
    (plate / "far.json").write_text(json.dumps({"picks": (np.array(RING) + [4e5, 5e6, 0]).tolist(), "closed": True}))
    result = run.ok("imprint", "far.ply", "--picks", "far.json", "--output", "out.stl")
    assert "out.stl holds floats, which move vertices by up to 0.2" in result.stderr
    assert "floats" not in run.ok("imprint", "far.ply", "--picks", "far.json", "--output", "out.obj").stderr


def random_entities(random, layout, doc, depth=0):
    """Adds curves of every kind; those of blocks as well."""
    at = lambda: tuple(random.uniform(-3, 3, 2))  # noqa: E731
    for kind in random.choice(["line", "circle", "arc", "ellipse", "light", "old", "spline", "insert"], 6):
        layer = {"layer": str(random.choice(["0", "seen", "off", "frozen"], p=[0.4, 0.4, 0.1, 0.1]))}
        if kind == "line":
            layout.add_line(at(), at(), layer)
        elif kind == "circle":
            layout.add_circle(at(), random.uniform(0.1, 2), {**layer, "extrusion": (0, 0, random.choice([-1, 1]))})
        elif kind == "arc":
            layout.add_arc(at(), random.uniform(0.1, 2), *random.uniform(0, 360, 2), dxfattribs=layer)
        elif kind == "ellipse":
            layout.add_ellipse(at(), (*random.uniform(0.5, 2, 2), 0), random.uniform(0.1, 1), *random.uniform(0, 6.2, 2),
                               dxfattribs=layer)
        elif kind == "light":
            points = [(*at(), 0, 0, random.choice([0, random.uniform(-1.5, 1.5)])) for _ in range(4)]
            layout.add_lwpolyline(points, close=bool(random.integers(2)), dxfattribs=layer)
        elif kind == "old":
            layout.add_polyline2d([(*at(), random.uniform(-1, 1)) for _ in range(4)], format="xyb", dxfattribs=layer)
        elif kind == "spline":
            layout.add_open_spline([(*at(), 0) for _ in range(6)], degree=int(random.integers(2, 5)), dxfattribs=layer)
        elif kind == "insert" and depth < 3:
            block = doc.blocks.new(name=f"B{len(doc.blocks)}", base_point=at())
            random_entities(random, block, doc, depth + 1)
            layout.add_blockref(block.name, at(), {
                "xscale": random.choice([1, -0.7]), "yscale": random.uniform(0.5, 1), "rotation": random.uniform(0, 360),
                "layer": str(random.choice(["0", "seen"]))})


def seen(entities, matrix, layer="0"):
    """Curves of ezdxf that are shown, as points."""
    from ezdxf import path

    for entity in entities:
        own = layer if entity.dxf.layer == "0" else entity.dxf.layer
        if entity.dxftype() == "INSERT":
            yield from seen(entity.block(), entity.matrix44() * matrix, own)
        elif own not in ("off", "frozen"):
            points = list(matrix.transform_vertices(path.make_path(entity).flattening(1e-5, 64)))
            if len(points) > 1:
                yield np.array([(p.x, p.y, p.z) for p in points])


@pytest.mark.parametrize("seed", range(6))
def test_random_dxf_drawings_are_those_of_ezdxf(run, tmp_path, seed):
    """Blocks in blocks, mirrored, on hidden layers: as many curves, of the same lengths."""
    random = np.random.default_rng(seed)
    doc = ezdxf.new("R2010")
    for name in ("seen", "off", "frozen"):
        doc.layers.add(name)
    doc.layers.get("off").off()
    doc.layers.get("frozen").freeze()
    random_entities(random, doc.modelspace(), doc)
    doc.layout("Layout1").add_line((0, 0), (297, 210))
    doc.saveas(tmp_path / "a.dxf")
    expected = list(seen(doc.modelspace(), ezdxf.math.Matrix44()))
    V, F = meshes.plate(cells=4, size=80)
    meshes.write_ply(tmp_path / "plate.ply", V - [40, 40, 0], F)
    run.ok("points", "plate.ply", "--curve", "a.dxf", "--count", 4000, "--output", "points.json")
    curves = []
    for curve in report_of(tmp_path / "points.json")["curves"]:
        points = np.array([point["position"] for point in curve["points"]])
        curves.append(np.vstack([points, points[:1]]) if curve["closed"] else points)
    length = lambda points: np.linalg.norm(np.diff(points, axis=0), axis=1).sum()  # noqa: E731
    assert sum(map(length, curves)) == pytest.approx(sum(map(length, expected)), rel=1.5e-3)
    for low_or_high in (np.min, np.max):
        box = [low_or_high(np.vstack(all_of), axis=0) for all_of in (curves, expected)]
        assert np.allclose(*box, rtol=0, atol=0.02)
