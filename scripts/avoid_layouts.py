#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws curves through random picks round random faces to avoid, and checks each of them.

    scripts/avoid_layouts.py MESH [--layouts 100] [--first 0] [-- OPTION...]

A layout is one to seven discs, rings, slabs and half-spaces of faces, and two to seven picks, a tenth of the time in any
face, else outside of what is avoided. Whether a curve exists is decided here, by the components of the faces left. Every curve
must keep out, segment by segment, and be usable, and be drawn exactly where one exists. Options after -- go to the program.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from render_curve import read_mesh
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components, dijkstra

ROOT = Path(__file__).resolve().parents[1]


class Mesh:
    """A mesh with what layouts ask of it."""

    def __init__(self, path):
        self.path = path
        self.vertices, self.faces = read_mesh(path)[:2]
        self.centres = self.vertices[self.faces].mean(1)
        self.diagonal = np.linalg.norm(np.ptp(self.vertices, axis=0))
        ends = np.sort(np.concatenate([self.faces[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
        owners = np.tile(np.arange(len(self.faces)), 3)
        order = np.lexsort(ends.T)
        same = (ends[order][1:] == ends[order][:-1]).all(1)
        self.pairs = np.stack([owners[order][:-1][same], owners[order][1:][same]], 1)  # faces that share an edge
        lengths = np.linalg.norm(self.vertices[ends[:, 0]] - self.vertices[ends[:, 1]], axis=1)
        edges, first = np.unique(ends, axis=0, return_index=True)
        self.graph = csr_matrix((lengths[first], edges.T), shape=(len(self.vertices),) * 2)
        self.around = [set() for _ in self.vertices]
        for face, corners in enumerate(self.faces):
            for vertex in corners:
                self.around[vertex].add(face)

    def holding(self, face, barycentric):
        """The faces that hold a point of a face."""
        corners = [v for v, b in zip(self.faces[face], barycentric) if b > 0]
        return set.intersection(*(self.around[v] for v in corners)) if len(corners) < 3 else {int(face)}

    def components(self, open_faces):
        kept = self.pairs[open_faces[self.pairs].all(1)]
        graph = csr_matrix((np.ones(len(kept)), kept.T), shape=(len(self.faces),) * 2)
        return connected_components(graph, directed=False)[1]


def random_obstacle(mesh, rng):
    """Which faces one obstacle holds."""
    start = rng.choice(mesh.faces[rng.integers(len(mesh.faces))])
    kind = rng.integers(10)
    if kind < 6:
        outer = mesh.diagonal * np.exp(rng.uniform(np.log(0.01), np.log(0.2)))
        inner = outer * rng.uniform(0.5, 0.95) if kind == 5 else -1.0
        distance = dijkstra(mesh.graph, directed=False, indices=start, limit=2 * outer)[mesh.faces].mean(1)
        return (distance < outer) & (distance > inner)
    normal = rng.normal(size=3)
    along = (mesh.centres - mesh.vertices[start]) @ (normal / np.linalg.norm(normal))
    if kind < 9:
        near = np.linalg.norm(mesh.centres - mesh.vertices[start], axis=1) < mesh.diagonal * rng.uniform(0.05, 0.4)
        return near & (abs(along) < mesh.diagonal * rng.uniform(0.003, 0.03))
    return along > max(0.0, np.median(along))


def random_layout(mesh, seed):
    """The faces avoided, and the picks as faces and points."""
    rng = np.random.default_rng(seed)
    avoided = np.any([random_obstacle(mesh, rng) for _ in range(rng.integers(1, 8))], axis=0)
    closed = bool(rng.integers(3) == 0)
    anywhere = rng.integers(10) == 0 or avoided.all()
    faces = rng.choice(len(mesh.faces) if anywhere else np.flatnonzero(~avoided), (3 if closed else 2) + rng.integers(4))
    weights = rng.dirichlet(np.ones(3), len(faces))
    points = (mesh.vertices[mesh.faces[faces]] * weights[..., None]).sum(1)
    return avoided, faces, points, closed


def enters(mesh, curve, avoided):
    """Whether a vertex or a segment of a curve lies in a face avoided."""
    line = curve["polyline"]
    held = [{f for f in mesh.holding(*point) if not avoided[f]} for point in zip(line["faces"], line["barycentrics"])]
    pairs = zip(held, held[1:] + (held[:1] if curve["closed"] else []))
    return bool(avoided[line["faces"]].any()) or not all(a & b for a, b in pairs)


def outcome(mesh, seed, program, options):
    """'drawn' or 'refused' where that is right, else what is wrong."""
    avoided, faces, points, closed = random_layout(mesh, seed)
    components = mesh.components(~avoided)
    possible = not avoided[faces].any() and len(set(components[faces])) == 1
    with tempfile.TemporaryDirectory() as folder:
        picks, avoid, output, report = (Path(folder) / name for name in ("p.json", "a.npy", "c.json", "r.json"))
        picks.write_text(json.dumps({"closed": closed, "picks": points.tolist()}))
        np.save(avoid, np.flatnonzero(avoided))
        done = subprocess.run(
            [program, mesh.path, "--picks", picks, "--avoid", avoid, "--output", output, "--report", report,
             "--degree", str(3 if seed % 5 > 1 else 2 + 2 * (seed % 5)), "--no-cache", *options],
            capture_output=True, text=True)
        if done.returncode == 0:
            if not possible:
                return "drawn where none exists"
            if enters(mesh, json.loads(output.read_text()), avoided):
                return "enters what it avoids"
            return "drawn" if json.loads(report.read_text())["usable"] else "not usable"
        known = "no way along the surface" in done.stderr or "to avoid" in done.stderr
        return "refused" if not possible and known else f"wrongly refused: {done.stderr.strip()}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", type=Path)
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/bspline_curve")
    parser.add_argument("--layouts", type=int, default=100)
    parser.add_argument("--first", type=int, default=0, help="seed of the first layout")
    words = sys.argv[1:]
    end = words.index("--") if "--" in words else len(words)
    given, options = parser.parse_args(words[:end]), words[end + 1:]
    mesh = Mesh(given.mesh)
    seeds = range(given.first, given.first + given.layouts)
    outcomes = {seed: outcome(mesh, seed, given.program, options) for seed in seeds}
    wrong = {seed: what for seed, what in outcomes.items() if what not in ("drawn", "refused")}
    for seed, what in wrong.items():
        print(f"layout {seed}: {what}")
    counts = [list(outcomes.values()).count(what) for what in ("drawn", "refused")]
    print(f"{given.mesh.stem}: {counts[0]} drawn, {counts[1]} refused, {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
