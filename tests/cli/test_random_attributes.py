# SPDX-License-Identifier: GPL-3.0-or-later
"""Random meshes with random attributes go through the verbs that make meshes, in PLY and OBJ, and other readers read them.

BSPLINE_CURVE_MESHES is how many meshes of each format, 4 by default; the first seed is BSPLINE_CURVE_FIRST_MESH."""

import json
import os

import made_meshes as meshes
import numpy as np
import pytest

COUNT = int(os.environ.get("BSPLINE_CURVE_MESHES", 4))
FIRST = int(os.environ.get("BSPLINE_CURVE_FIRST_MESH", 0))
SEEDS = range(FIRST, FIRST + COUNT)
RING = np.array([[0.3, 0.3], [0.7, 0.35], [0.65, 0.7], [0.3, 0.66]])
TYPES = {"char": "i1", "uchar": "u1", "short": "<i2", "ushort": "<u2", "int": "<i4", "uint": "<u4", "float": "<f4", "double": "<f8"}


def scene(random, folder):
    """A hill with moved vertices, a ring of picks on it and, now and then, a loose vertex."""
    height = random.uniform(0, 0.3)
    V, F = meshes.plate(cells=int(random.integers(5, 14)), height=0.0)
    inner = (V[:, :2].min(1) > 0) & (V[:, :2].max(1) < 1)
    V[inner, :2] += random.uniform(-0.2, 0.2, (inner.sum(), 2)) / np.sqrt(len(V))
    V[:, 2] = height * np.sin(np.pi * V[:, 0]) * np.sin(np.pi * V[:, 1])
    if random.random() < 0.3:
        V = np.vstack([V, [[0.2, 0.2, 0.9]]])
    F = F[random.permutation(len(F))]
    picks = [[*p, height * np.sin(np.pi * p[0]) * np.sin(np.pi * p[1])] for p in RING + random.uniform(-0.05, 0.05, (4, 2))]
    (folder / "ring.json").write_text(json.dumps({"picks": picks, "closed": True}))
    return V, F


def linear(random, count=1):
    """Functions of positions that are linear, and so are what they have to be at any point of a face."""
    slopes, starts = random.uniform(-1, 1, (3, count)), random.uniform(0, 1, count)
    return lambda V: V @ slopes + starts


def write_ply(random, path, V, F):
    """With a random choice of properties; returns those of vertices and of corners as functions of positions, and those of faces."""
    byte_order = random.choice(["ascii", "binary_little_endian", "binary_big_endian"])
    coordinate = "float" if "big" in byte_order else "double"  # other programs misread big-endian doubles, so they are refused
    of_vertices, vertex_columns = {}, [(f"{coordinate} {axis}", V[:, k]) for k, axis in enumerate("xyz")]

    def add(names, kind, of, tolerance):
        for k, name in enumerate(names):
            values = of(V)[:, k]
            vertex_columns.append((f"{kind} {name}", np.round(values) if TYPES[kind][-2] in "iu" else values))
            of_vertices[name] = (lambda P, k=k: of(P)[:, k], tolerance)

    if random.random() < 0.7:
        bytes_of = linear(random, 4)
        add(["red", "green", "blue", "alpha"][: random.choice([3, 4])], "uchar", lambda P: 60 + 30 * bytes_of(P), 1.01)
    if random.random() < 0.5:
        add(["s", "t"], "float", linear(random, 2), 1e-5)
    if random.random() < 0.5:
        add(["quality"], random.choice(["float", "double"]), linear(random), 1e-5)
    for i in range(random.integers(0, 3)):
        add([f"own_{i}"], random.choice(["float", "double"]), linear(random), 1e-5)
    face_columns, corners = [], None
    for name in ("patch", "zone")[: random.integers(0, 3)]:
        face_columns.append((f"{random.choice(['uchar', 'short', 'int'])} {name}", random.integers(0, 100, len(F))))
    if random.random() < 0.4:
        corners = linear(random, 2)
    lines = ["ply", f"format {byte_order} 1.0"] + ["comment TextureFile wood.png"] * (corners is not None)
    lines += [f"element vertex {len(V)}"] + [f"property {name}" for name, _ in vertex_columns]
    lines += [f"element face {len(F)}", "property list uchar int vertex_indices"]
    lines += ["property list uchar float texcoord"] * (corners is not None) + [f"property {name}" for name, _ in face_columns]
    places = None if corners is None else corners(V)[F].reshape(len(F), 6)
    if byte_order == "ascii":
        body = "".join(" ".join(f"{values[i]:.17g}" for _, values in vertex_columns) + "\n" for i in range(len(V)))
        for i, face in enumerate(F):
            row = [3, *face] + ([] if places is None else [6, *places[i]]) + [values[i] for _, values in face_columns]
            body += " ".join(f"{value:.9g}" for value in row) + "\n"
        data = body.encode()
    else:
        order = (lambda t: t.replace("<", ">")) if "big" in byte_order else (lambda t: t)
        row = np.dtype([(name.split()[1], order(TYPES[name.split()[0]])) for name, _ in vertex_columns])
        table = np.zeros(len(V), row)
        for name, values in vertex_columns:
            table[name.split()[1]] = values
        wedge = [("m", "u1"), ("w", order("<f4"), 6)] if places is not None else []
        faces = np.zeros(len(F), np.dtype([("n", "u1"), ("v", order("<i4"), 3), *wedge] + [
            (name.split()[1], order(TYPES[name.split()[0]])) for name, _ in face_columns]))
        faces["n"], faces["v"] = 3, F
        if places is not None:
            faces["m"], faces["w"] = 6, places
        for name, values in face_columns:
            faces[name.split()[1]] = values
        data = table.tobytes() + faces.tobytes()
    path.write_bytes("\n".join([*lines, "end_header\n"]).encode() + data)
    return of_vertices, corners, {name.split()[1]: values for name, values in face_columns}


VERBS = {
    "imprint": ["imprint", "--map", "map.json"],
    "cut": ["cut", "--keep", "inside"],
    "segment": ["segment"],
}


def same_geometry(path, V, F):
    """meshio and pymeshlab read the same vertices and faces."""
    import pymeshlab

    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(path))
    layer = document.current_mesh()
    if path.suffix == ".ply":  # MeshLab joins vertices of OBJ where it must
        assert np.abs(layer.vertex_matrix() - V).max() < 1e-6
        assert (layer.face_matrix() == F).all()
    assert layer.face_number() == len(F)
    return layer


@pytest.mark.parametrize("seed", SEEDS)
def test_random_attributes_of_ply_go_through(run, tmp_path, seed):
    import trimesh

    random = np.random.default_rng(seed)
    V, F = scene(random, tmp_path)
    of_vertices, corners, of_faces = write_ply(random, tmp_path / "mesh.ply", V, F)
    for verb, (name, *more) in VERBS.items():
        run.ok(name, "mesh.ply", "--picks", "ring.json", "--pick-distance", 0.1, *more, "--output", "out.ply")
        raw = trimesh.load(tmp_path / "out.ply", process=False, skip_materials=True).metadata["_ply_raw"]
        v, f = raw["vertex"]["data"], raw["face"]["data"]
        P = np.stack([v[axis] for axis in "xyz"], 1)
        T = f["vertex_indices"]["f1"].reshape(-1, 3)
        same_geometry(tmp_path / "out.ply", P, T)
        assert verb == "cut" or len(T) > len(F)
        used = np.unique(T)
        for name_of, (function, tolerance) in of_vertices.items():
            assert np.abs(v[name_of] - function(P))[used].max() <= tolerance, (seed, verb, name_of)
        if corners is not None:
            places = f["texcoord"]["f1"].reshape(-1, 3, 2)
            assert np.abs(places - corners(P)[T]).max() < 1e-5, (seed, verb)
            assert b"comment TextureFile wood.png" in (tmp_path / "out.ply").read_bytes()
        if verb == "imprint":
            parents = json.loads((tmp_path / "map.json").read_text())["parents"]
            for name_of, values in of_faces.items():
                assert (np.asarray(f[name_of]) == values[parents]).all(), (seed, name_of)
    run.ok("offset", "mesh.ply", "--picks", "ring.json", "--pick-distance", 0.1, "--distance", 0.05, "--output", "offset.vtu", "--band", "band.ply")
    import meshio

    assert len(meshio.read(tmp_path / "offset.vtu").points) > 3
    band = trimesh.load(tmp_path / "band.ply", process=False)
    assert len(band.faces) == len(F) and 0 < np.sum(band.metadata["_ply_raw"]["face"]["data"]["label"]) < len(F)


@pytest.mark.parametrize("seed", SEEDS)
def test_random_attributes_of_obj_go_through(run, tmp_path, seed):
    import trimesh

    random = np.random.default_rng(seed)
    V, F = scene(random, tmp_path)
    has_texture, has_normals, has_colours = random.random(3) < [0.7, 0.5, 0.4]
    of_texture, of_colours = linear(random, 2), linear(random, 3)
    lines = ["mtllib wood.mtl"]
    for p, colour in zip(V, 0.3 + 0.1 * of_colours(V)):
        lines.append("v %.17g %.17g %.17g" % tuple(p) + (" %.9g %.9g %.9g" % tuple(colour) if has_colours else ""))
    lines += ["vt %.17g %.17g" % tuple(row) for row in of_texture(V)] if has_texture else []
    lines += ["vn 0 0 1"] * bool(has_normals)
    materials = random.integers(1, 4)
    groups = random.integers(0, 3)
    for i, face in enumerate(F + 1):
        lines += [f"usemtl m{random.integers(materials)}"] if i % 50 == 0 else []
        lines += [f"g part{random.integers(groups)}"] if groups and i % 70 == 0 else []
        lines.append("f " + " ".join(
            f"{k}/{k if has_texture else ''}/{1 if has_normals else ''}".rstrip("/") for k in face))
    (tmp_path / "mesh.obj").write_text("\n".join(lines) + "\n")
    for verb, (name, *more) in VERBS.items():
        if verb == "segment":  # writes .ply
            continue
        run.ok(name, "mesh.obj", "--picks", "ring.json", "--pick-distance", 0.1, *more, "--output", "out.obj")
        words = [line.split() for line in (tmp_path / "out.obj").read_text().splitlines()]
        rows = lambda key: np.array([w[1:] for w in words if w[0] == key], dtype=float)  # noqa: B023, E731
        P = rows("v")
        faces = [[part.split("/") for part in w[1:]] for w in words if w[0] == "f"]
        T = np.array([[part[0] for part in face] for face in faces], dtype=int) - 1
        layer = same_geometry(tmp_path / "out.obj", P[:, :3], T)
        assert layer.has_wedge_tex_coord() == bool(has_texture), (seed, verb)
        read = trimesh.load(tmp_path / "out.obj", process=False, force="mesh")
        assert len(read.faces) == len(T)
        if has_colours:
            assert np.abs(P[:, 3:] - 0.3 - 0.1 * of_colours(P[:, :3]))[np.unique(T)].max() < 3e-3, (seed, verb)
        if has_texture:
            at = np.array([[part[1] for part in face] for face in faces], dtype=int) - 1
            assert np.abs(rows("vt")[at][..., :2] - of_texture(P[:, :3])[T]).max() < 1e-9, (seed, verb)
        if has_normals:
            at = np.array([[part[2] for part in face] for face in faces], dtype=int) - 1
            assert np.abs(rows("vn")[at] - [0, 0, 1]).max() < 1e-9
        assert {w[1] for w in words if w[0] == "usemtl"} <= {f"m{i}" for i in range(materials)}
        area = lambda mesh: np.linalg.norm(np.cross(mesh[:, 1] - mesh[:, 0], mesh[:, 2] - mesh[:, 0]), axis=1).sum()  # noqa: E731
        if verb == "imprint":
            assert area(P[:, :3][T]) == pytest.approx(area(V[F]), rel=1e-12)
            assert {w[1] for w in words if w[0] == "usemtl"} == {line.split()[1] for line in lines if line.startswith("usemtl")}
