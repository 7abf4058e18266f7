#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Imprints random sets of curves and checks what came of them.

    benchmarks/random_imprints.py                          250 sets on meshes made by a rule
    benchmarks/random_imprints.py MESH... --sets 1000      those, and on meshes of files
    benchmarks/random_imprints.py --judge check.py         each imprint judged by a module of somebody else as well

A set has 1 to 8 curves, or --curves of them: open and closed, crossing themselves and each other, through vertices and along edges,
in one face, up to the boundary. Each mesh has a quality. What is checked of each set:

- parents: the input's vertices come first, bit for bit; merging the children of each face gives the input back, bit for bit;
- curves: their edges are edges, their own points are met in order, up to rounding;
- quality: it is linear in each face of the input;
- again: imprinting the imprinted curves changes no bit;
- parts: Euler characteristics and areas add up (to 1e-12), the two sides of each cut are the same points, and joining them gives
  the imprinted mesh back.

The judge is a module with check(V, F, W, G, map, curves) that returns what is wrong, as a list of texts, first. Exit status 1
where anything is wrong; --keep FOLDER keeps the files of such sets.
"""
import argparse
import importlib.util
import json
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import numpy as np
from cases import PROGRAM, bumpy_torus, machine, write_json
from random_curves import Mesh, as_json, random_set

AREAS = 1e-12  # sums of areas agree to this
NEAR = 1e-9    # points of curves are met to this, in diagonals
LINEAR = 1e-9  # quality is linear to this, in its range


# ---------------------------------------------------------------- meshes
def grid(cells_u, cells_v, surface):
    u, v = np.meshgrid(np.linspace(0, 1, cells_u + 1), np.linspace(0, 1, cells_v + 1), indexing="ij")
    corner = (np.arange(cells_u)[:, None] * (cells_v + 1) + np.arange(cells_v)).reshape(-1, 1)
    faces = np.concatenate([corner + [0, cells_v + 1, cells_v + 2], corner + [0, cells_v + 2, 1]])
    return surface(u, v).reshape(-1, 3), faces


def plate(cells=14):
    return grid(cells, cells, lambda u, v: np.stack([u, v, 0 * u], -1))


def welded(vertices, faces):
    _, first, index = np.unique(np.round(vertices, 9), axis=0, return_index=True, return_inverse=True)
    faces = index.reshape(-1)[faces]
    alive = (faces != np.roll(faces, 1, 1)).all(1)
    return vertices[first], faces[alive]


def band(cells=36):
    """A ring with two boundaries, twice bent."""
    def surface(u, v):
        turn, wide = 2 * np.pi * u, 0.5 * v - 0.25
        return np.stack([(1 + wide) * np.cos(turn), (1 + wide) * np.sin(turn), 0.3 * np.sin(2 * turn)], -1)
    return welded(*grid(cells, 5, surface))


def box(cells=4):
    sides = []
    for axis in range(3):
        for end in (0.0, 1.0):
            def surface(u, v, axis=axis, end=end):
                return np.roll(np.stack([0 * u + end, u if end else v, v if end else u], -1), axis, -1)
            sides.append(grid(cells, cells, surface))
    starts = np.cumsum([0] + [len(v) for v, _ in sides])
    return welded(np.vstack([v for v, _ in sides]), np.vstack([f + s for (_, f), s in zip(sides, starts)]))


def torus_of_genus(genus=3, cells=4):
    """A slab of cubes with holes, its surface smoothed a little."""
    wide = 2 * genus + 1
    solid = np.ones((wide, 3, 1), bool)
    solid[1::2, 1, 0] = False
    solid = np.pad(np.kron(solid, np.ones((cells // 2,) * 3, bool)), 1)
    faces, points = [], []
    for axis in range(3):
        for end in (0, 1):
            beyond = np.roll(solid, 1 if end == 0 else -1, axis)
            for cell in np.argwhere(solid & ~beyond):
                base = cell.astype(float)
                base[axis] += end
                a, b = (axis + 1) % 3, (axis + 2) % 3
                square = [base + np.eye(3)[a] * i + np.eye(3)[b] * j for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
                square = square if end else square[::-1]
                faces += [[len(points) + k for k in t] for t in ((0, 1, 2), (0, 2, 3))]
                points += square
    vertices, faces = welded(np.array(points), np.array(faces))
    for _ in range(3):  # to the mean of the neighbours
        total, count = np.zeros_like(vertices), np.zeros(len(vertices))
        for k in range(3):
            np.add.at(total, faces[:, k], vertices[faces[:, (k + 1) % 3]])
            np.add.at(count, faces[:, k], 1)
        vertices = 0.5 * vertices + 0.5 * total / count[:, None]
    return vertices, faces


MADE = {"plate": plate, "box": box, "band": band, "genus 3": torus_of_genus, "torus": lambda: bumpy_torus(30, 14)}


def read_mesh(path):
    import trimesh

    loaded = trimesh.load(path, force="mesh", process=False, maintain_order=True)
    return np.asarray(loaded.vertices, float), np.asarray(loaded.faces, int)


# ---------------------------------------------------------------- files
FACE = np.dtype([("n", "u1"), ("v", "<i4", 3)])


def write_mesh(path, vertices, faces, quality):
    rows = np.zeros(len(faces), FACE)
    rows["n"], rows["v"] = 3, faces
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}",
              *(f"property double {name}" for name in ("x", "y", "z", "quality")), f"element face {len(faces)}",
              "property list uchar int vertex_indices", "end_header", ""]
    path.write_bytes("\n".join(header).encode() + np.column_stack([vertices, quality]).astype("<f8").tobytes() + rows.tobytes())


TYPES = {"double": "<f8", "float": "<f4", "int": "<i4", "uchar": "u1", "uint": "<u4", "short": "<i2", "char": "i1"}


def read_result(path):
    """Vertices, quality (None: it has none), faces and labels of a mesh that the program wrote."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    elements = []
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and words[1] == "list":
            elements[-1][2].extend([("n", TYPES[words[2]]), ("v", TYPES[words[3]], 3)])
        elif words[0] == "property":
            elements[-1][2].append((words[2], TYPES[words[1]]))
    tables = {}
    for name, count, fields in elements:
        kind = np.dtype(fields)
        tables[name] = np.frombuffer(data, kind, count, end)
        end += count * kind.itemsize
    v, f = tables["vertex"], tables["face"]
    quality = v["quality"] if "quality" in v.dtype.names else None
    return np.stack([v["x"], v["y"], v["z"]], 1).astype(float), quality, f["v"].astype(int), f["label"]


class Refused(Exception):
    pass


def run(program, *words):
    done = subprocess.run([str(program), *map(str, words)], capture_output=True, text=True)
    if done.returncode != 0:
        raise Refused(f"exit {done.returncode}: {done.stderr.strip()}")


# ---------------------------------------------------------------- checks
def cross_products(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


def area(vertices, faces):
    return float(np.linalg.norm(cross_products(vertices, faces), axis=1).sum() / 2)


def half_edges(faces):
    return faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)


def euler(faces):
    return len(np.unique(faces)) - len(np.unique(np.sort(half_edges(faces), 1), axis=0)) + len(faces)


def merged(count, parents, faces, faces_in):
    """The input's faces, from the children of each: what is left of their rim without new vertices, beginning with the first
    corner of the first child."""
    result = np.full((faces_in, 3), -1)
    order = np.argsort(parents, kind="stable")
    start = np.searchsorted(parents[order], np.arange(faces_in + 1))
    single = np.diff(start) == 1
    result[single] = faces[order[start[:-1][single]]]
    for parent in np.flatnonzero(~single):
        children = faces[order[start[parent]:start[parent + 1]]]
        edges = list(map(tuple, half_edges(children).tolist()))
        inner = set(edges)
        following = {a: b for a, b in edges if (b, a) not in inner}
        at = first = int(children[0][0])
        loop = []
        for _ in range(len(following)):
            if at < count:
                loop.append(at)
            at = following.get(at, -1)
        if at == first and len(loop) == 3:
            result[parent] = loop
    return result


def wrong_imprint(mesh, quality, curves, result, told):
    """What is wrong with an imprint."""
    (vertices, values, faces, labels), wrong = result, []
    count, parents = len(mesh.vertices), np.array(told["parents"])
    if not np.array_equal(vertices[:count], mesh.vertices):
        wrong.append("vertices: the input's are not first, bit for bit")
    if not np.array_equal(merged(count, parents, faces, len(mesh.faces)), mesh.faces):
        wrong.append("parents: merging children does not give the input back")
    if (np.einsum("ij,ij->i", cross_products(vertices, faces), cross_products(mesh.vertices, mesh.faces)[parents]) <= 0).any():
        wrong.append("faces: one has no area, or is turned over")
    edges = set(map(tuple, np.sort(half_edges(faces), 1).tolist()))
    size = np.linalg.norm(np.ptp(mesh.vertices, axis=0))
    for index, ((kind, points, closed), known) in enumerate(zip(curves, told["curves"])):
        ids = known["vertices"]
        ends = list(zip(ids, ids[1:] + (ids[:1] if closed else [])))
        if any((min(e), max(e)) not in edges for e in ends):
            wrong.append(f"curve {index} ({kind}): its vertices are not joined by edges")
        at = 0
        for point in points:
            place, tries = mesh.position(point), 0
            while np.linalg.norm(vertices[ids[at % len(ids)]] - place) > NEAR * size and tries <= len(ids):
                at, tries = at + 1, tries + 1
            if tries > len(ids):
                wrong.append(f"curve {index} ({kind}): it leaves out a point")
                break
    corners = mesh.vertices[mesh.faces[parents]]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    off = 0.0
    for k in range(3):
        place = vertices[faces[:, k]]
        weights = np.stack([np.einsum("ij,ij->i", np.cross(corners[:, (m + 2) % 3] - corners[:, (m + 1) % 3],
                                                           place - corners[:, (m + 1) % 3]), normal) for m in range(3)], 1)
        weights /= np.einsum("ij,ij->i", normal, normal)[:, None]
        off = max(off, np.abs((weights * quality[mesh.faces[parents]]).sum(1) - values[faces[:, k]]).max())
    if off > LINEAR * np.ptp(quality):
        wrong.append(f"quality: off by {off / np.ptp(quality):.1e}")
    if not np.array_equal(labels, told["regions"]):
        wrong.append("labels: they are not the regions of the map")
    return wrong


def wrong_again(program, folder, result, told):
    """Imprints the imprinted curves into the result."""
    vertices, values, faces, _ = result
    write_mesh(folder / "again.ply", vertices, faces, values)
    holder = {}
    for face, corners in enumerate(faces.tolist()):
        for k in range(3):
            holder.setdefault((min(corners[k], corners[k - 1]), max(corners[k], corners[k - 1])), face)
            holder.setdefault(corners[k], face)
    words = []
    for index, curve in enumerate(told["curves"]):
        if len(curve["vertices"]) < (3 if curve["closed"] else 2):
            continue
        points = [(holder[v], (faces[holder[v]] == v).astype(float)) for v in curve["vertices"]]
        file = folder / f"again-{index}.json"
        file.write_text(json.dumps(as_json(Placed(vertices, faces), points, curve["closed"])))
        words += ["--curve", file]
    if not words:
        return []
    run(program, "imprint", folder / "again.ply", *words, "--output", folder / "twice.ply")
    twice = read_result(folder / "twice.ply")
    same = np.array_equal(twice[0], vertices) and np.array_equal(twice[2], faces)
    return [] if same else ["again: imprinting the imprint changes it"]


class Placed:
    """Positions alone."""

    def __init__(self, vertices, faces):
        self.vertices, self.faces = vertices, faces

    def position(self, point):
        return point[1] @ self.vertices[self.faces[point[0]]]


def wrong_parts(program, folder, mesh, words, result, told, report):
    """Cuts along the curves, and looks at the parts."""
    (vertices, _, faces, labels), wrong = result, []
    total = sum(part["area"] for part in report["parts"])
    if abs(total - area(mesh.vertices, mesh.faces)) > AREAS * total:
        wrong.append(f"parts: areas add up to {total / area(mesh.vertices, mesh.faces) - 1:.1e} more")
    try:
        run(program, "cut", folder / "mesh.ply", *words, "--output", folder / "cut.ply")
    except Refused as refused:
        if "there is nothing to cut" in str(refused):
            return wrong
        raise
    cut_vertices, _, cut_faces, cut_labels = read_result(folder / "cut.ply")
    if not np.array_equal(cut_labels, labels):
        wrong.append("parts: the cut mesh has other labels")
    if sum(part["euler"] for part in report["parts"]) != euler(cut_faces):
        wrong.append("parts: Euler characteristics do not add up")
    # Copies come last, each at the place of the vertex that it is a copy of.
    place = {tuple(p): i for i, p in reversed(list(enumerate(vertices.tolist())))}
    origin = np.arange(len(cut_vertices))
    origin[len(vertices):] = [place.get(tuple(p), -1) for p in cut_vertices[len(vertices):].tolist()]
    if not np.array_equal(cut_vertices[:len(vertices)], vertices) or not np.array_equal(origin[cut_faces], faces):
        wrong.append("parts: joining the copies does not give the imprint back")
    inner = Counter(map(tuple, half_edges(faces).tolist()))
    sides = Counter(map(tuple, half_edges(cut_faces).tolist()))
    opened = Counter(tuple(origin[list(e)]) for e in sides if (e[1], e[0]) not in sides)
    opened = {e: n for e, n in opened.items() if (e[1], e[0]) in inner}
    if any(n != 1 or opened.get((b, a)) != 1 for (a, b), n in opened.items()):
        wrong.append("parts: the two sides of a cut are not the same points")
    return wrong


# ---------------------------------------------------------------- sets
def check_set(given, judge, mesh, quality, curves, folder):
    write_mesh(folder / "mesh.ply", mesh.vertices, mesh.faces, quality)
    words, documents = [], []
    for index, (_, points, closed) in enumerate(curves):
        documents.append(as_json(mesh, points, closed))
        (folder / f"curve-{index}.json").write_text(json.dumps(documents[-1]))
        words += ["--curve", folder / f"curve-{index}.json"]
    try:
        run(given.program, "imprint", folder / "mesh.ply", *words, "--output", folder / "out.ply",
            "--map", folder / "map.json", "--report", folder / "report.json")
        told, report = (json.loads((folder / name).read_text()) for name in ("map.json", "report.json"))
        result = read_result(folder / "out.ply")
        wrong = wrong_imprint(mesh, quality, curves, result, told)
        wrong += wrong_again(given.program, folder, result, told)
        wrong += wrong_parts(given.program, folder, mesh, words, result, told, report)
    except Refused as refused:
        return [f"refused: {refused}"]
    if judge is not None:
        said = judge.check(mesh.vertices, mesh.faces, result[0], result[2], told, documents)
        wrong += [f"judge: {text}" for text in said[0]]
    return wrong


def loaded_judge(path):
    spec = importlib.util.spec_from_file_location("judge", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", type=Path, nargs="*", help="files of meshes, besides those made by a rule")
    parser.add_argument("--sets", type=int, default=250, help="of all meshes together")
    parser.add_argument("--curves", type=int, help="in each set; else 1 to 8")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--judge", type=Path, help="a module with check(V, F, W, G, map, curves)")
    parser.add_argument("--keep", type=Path, help="folder for the files of sets that are wrong")
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    judge = loaded_judge(given.judge) if given.judge else None
    meshes = {name: make() for name, make in MADE.items()} | {path.stem: read_mesh(path) for path in given.meshes}
    rows, start = [], time.monotonic()
    for index, (name, (vertices, faces)) in enumerate(meshes.items()):
        mesh, bad = Mesh(vertices, faces), 0
        sets = given.sets // len(meshes) + (index < given.sets % len(meshes))
        for number in range(sets):
            random = np.random.default_rng([given.seed, index, number])
            curves = random_set(mesh, random, given.curves)
            quality = mesh.vertices @ random.normal(size=3) + 0.1 * random.normal(size=len(mesh.vertices))
            with tempfile.TemporaryDirectory() as temporary:
                wrong = check_set(given, judge, mesh, quality, curves, Path(temporary))
                if wrong and given.keep:
                    shutil.copytree(temporary, given.keep / f"{name}-{given.seed}-{number}", dirs_exist_ok=True)
            bad += bool(wrong)
            for text in wrong:
                print(f"{name}, set {number} of seed {given.seed}: {text}", flush=True)
        rows.append({"mesh": name, "faces": len(faces), "sets": sets, "wrong": bad})
        print(f"{name:14} {len(faces):7,} faces  {sets:5} sets  {bad:3} wrong", flush=True)
    total, bad = sum(row["sets"] for row in rows), sum(row["wrong"] for row in rows)
    print(f"{total} sets, {bad} wrong, {time.monotonic() - start:.0f} s")
    write_json(given.json, {"machine": machine(), "seed": given.seed, "rows": rows})
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
