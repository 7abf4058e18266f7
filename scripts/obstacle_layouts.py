#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws curves among random discs that the field of obstacles marks, and counts those that keep out.

    scripts/obstacle_layouts.py MESH [--layouts 50] [--first 0] [-- OPTION...]

A layout is two to five discs of faces, and two to four picks outside of all discs and of each other's reach, on one component
of what the discs leave. Each segment of a curve is checked. Options after -- go to the program.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from avoid_layouts import ROOT, Mesh, enters
from scipy.sparse.csgraph import dijkstra


def random_discs(mesh, seed):
    """The faces of the discs, and the picks as points; discs leave a way from pick to pick."""
    rng = np.random.default_rng(seed)
    while True:
        inside = np.zeros(len(mesh.faces), bool)
        for _ in range(rng.integers(2, 6)):
            radius = mesh.diagonal * rng.uniform(0.03, 0.1)
            centre = rng.integers(len(mesh.vertices))
            inside |= dijkstra(mesh.graph, directed=False, indices=centre, limit=2 * radius)[mesh.faces].mean(1) < radius
        touched = np.zeros(len(mesh.vertices), bool)
        touched[mesh.faces[inside].ravel()] = True
        free = np.flatnonzero(~touched[mesh.faces].any(1))
        faces = rng.choice(free, rng.integers(2, 5), replace=False)
        if len(set(mesh.components(~inside)[faces])) == 1:
            return inside, mesh.centres[faces]


def outcome(mesh, seed, program, options):
    """'out', 'in', or how the program failed."""
    inside, points = random_discs(mesh, seed)
    with tempfile.TemporaryDirectory() as folder:
        picks, region, output = (Path(folder) / name for name in ("p.json", "r.npy", "c.json"))
        picks.write_text(json.dumps({"closed": False, "picks": points.tolist()}))
        np.save(region, np.flatnonzero(inside))
        done = subprocess.run(
            [program, mesh.path, "--picks", picks, "--field", "obstacle", "--field-region", region, "--output", output,
             "--no-cache", *options],
            capture_output=True, text=True)
        if done.returncode != 0:
            return f"failed: {done.stderr.strip()}"
        return "in" if enters(mesh, json.loads(output.read_text()), inside) else "out"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", type=Path)
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/bspline_curve")
    parser.add_argument("--layouts", type=int, default=50)
    parser.add_argument("--first", type=int, default=0, help="seed of the first layout")
    parser.add_argument("--least", type=float, default=0.95, help="share of curves that must keep out")
    words = sys.argv[1:]
    end = words.index("--") if "--" in words else len(words)
    given, options = parser.parse_args(words[:end]), words[end + 1:]
    mesh = Mesh(given.mesh)
    outcomes = {seed: outcome(mesh, seed, given.program, options) for seed in range(given.first, given.first + given.layouts)}
    for seed, what in outcomes.items():
        if what != "out":
            print(f"layout {seed}: {what}")
    kept = list(outcomes.values()).count("out")
    print(f"{given.mesh.stem}: {kept} of {given.layouts} curves keep out of the discs")
    return 0 if kept >= given.least * given.layouts else 1


if __name__ == "__main__":
    sys.exit(main())
