#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times and memory of the same curve on the same surface with more and more faces.

    benchmarks/scaling.py [--json FILE] [--levels 5] [--quick]

The bunny of pymeshlab's wheel, decimated to 7,000 faces, then every face split into four at the midpoints of its edges, four
times: 1.8 million. The picks stay. Without a field, with waves in space as field (the same on every level, from a file), and with
maximal curvature, which is made anew in each cold run. Memory is the program's largest until the first curve was there, less the
arrays of the mesh (24 bytes per vertex, 12 per face). Times are the least of several rounds over all levels, so that a busy
minute of the machine does not fall on one level alone. Needs requirements.txt.
"""
import argparse
import math
import sys
import tempfile
from pathlib import Path

import numpy as np
from cases import (PROGRAM, Case, best_of, draw, farthest_picks, is_in_whole_shell, machine, midpoint_subdivided,
                   packaged_meshes, write_json)

FACES = 7000
LEVELS = 5
PICKS = 6
SEED = 1
WAVES = 3.0  # of the field, along each axis of the box
FIELDS = ("none", "waves", "maximal-curvature")
CURVATURE_EVERY = 4  # rounds: it takes half a minute on the finest level


def decimated_bunny():
    import pymeshlab

    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(next(path for path in packaged_meshes() if path.stem == "bunny")))
    meshes.meshing_decimation_quadric_edge_collapse(targetfacenum=FACES)
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


def waves(vertices):
    """Costs between 0 and 1."""
    low, high = vertices.min(0), vertices.max(0)
    phases = 2 * np.pi * WAVES * (vertices - low) / (high - low).max()
    return 0.5 + np.sin(phases).prod(1) / 2


def field_options(kind, vertices, folder):
    if kind == "waves":
        np.save(folder / "waves.npy", waves(vertices))
        return ["--field", folder / "waves.npy"]
    return [] if kind == "none" else ["--field", kind]


def report_on(program, case, kind, repeat):
    with tempfile.TemporaryDirectory() as folder:
        return draw(program, case, *field_options(kind, case.vertices, Path(folder)), repeat=repeat)


def row_of(case, kind, reports):
    report = best_of(reports)
    seconds, faces = report["seconds"], len(case.faces)
    arrays = 24 * len(case.vertices) + 12 * faces
    stages = {key: seconds[key] for key in ("validate", "tree", "shell", "field", "design")}
    return {"field": kind, "faces": faces, "cold": seconds["cold"], "warm": seconds["warm"], "stages": stages,
            "peak_bytes": report["peak_memory_bytes"]["cold"],
            "whole_shell": is_in_whole_shell(report),
            "bytes_per_face": (report["peak_memory_bytes"]["cold"] - arrays) / faces}


def surfaces(levels):
    """The bunny on every level, finer and finer, with the same picks."""
    vertices, faces = decimated_bunny()
    picks = farthest_picks(vertices, faces, PICKS, SEED)
    cases = [Case("level 0", vertices, faces, picks, True)]
    while len(cases) < levels:
        vertices, faces = midpoint_subdivided(vertices, faces)
        cases.append(Case(f"level {len(cases)}", vertices, faces, picks, True))
    return cases


def growth(rows, key):
    """Per four times the faces: on average and at most."""
    values = [row[key] for row in rows]
    steps = [after / before for before, after in zip(values, values[1:])]
    return {"mean": math.prod(steps) ** (1 / len(steps)), "worst": max(steps)} if steps else None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--levels", type=int, default=LEVELS, help="meshes, each with four times the faces of the one before")
    parser.add_argument("--rounds", type=int, default=8)
    parser.add_argument("--repeat", type=int, default=7, help="warm curves in each round")
    parser.add_argument("--quick", action="store_true", help="two levels, one round")
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    if given.quick:
        given.levels, given.rounds, given.repeat = 2, 1, 1
    cases = surfaces(given.levels)
    reports = [[case, kind, []] for case in cases for kind in FIELDS]
    for number in range(given.rounds):
        for case, kind, done in reports:
            if kind != "maximal-curvature" or number % CURVATURE_EVERY == 0:
                done.append(report_on(given.program, case, kind, given.repeat))
    rows = [row_of(*all_of_one) for all_of_one in reports]
    print(f"{'field':18} {'faces':>10} {'cold, ms':>9} {'warm, ms':>9} {'bytes per face':>15}")
    for row in rows:
        print(f"{row['field']:18} {row['faces']:10,} {1e3 * row['cold']:9.1f} {1e3 * row['warm']:9.2f} {row['bytes_per_face']:15,.0f}")
    grown = {kind: {key: growth([row for row in rows if row["field"] == kind], key) for key in ("cold", "warm")}
             for kind in FIELDS}
    for kind, by_state in grown.items():
        for state, factor in by_state.items():
            if factor:
                print(f"{kind + ', ' + state:28} {factor['mean']:.2f} times per four times the faces, at most {factor['worst']:.2f}")
    write_json(given.json, {"machine": machine(), "rows": rows, "growth": grown})
    return 0


if __name__ == "__main__":
    sys.exit(main())
