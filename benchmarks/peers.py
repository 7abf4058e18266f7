#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times what a user could pick instead, on the same meshes and picks, cold and warm.

    benchmarks/peers.py [--json FILE] [--quick]

- geodesic: potpourri3d's shortest paths by edge flips (geometry-central), from pick to pick. They pass all picks, with a kink
  at each.
- meshlib: MeshLib's spline through the picks, its points projected onto the mesh. It is not optimised; on bumpy meshes it
  follows the bumps.
- ours: the program, which lowers bending until nothing is gained any more.

Cold is from arrays in memory to the curve, every structure built anew; warm is a further curve with what was built kept.
Meshes are those that pymeshlab's wheel ships and bumpy tori; picks are vertices far apart, from a random one on (seeded).
All is timed in turn on one machine, medians of several curves, the least of several rounds. Needs requirements.txt.
"""
import argparse
import sys
import time
from pathlib import Path

import numpy as np
from cases import PROGRAM, NoCurve, draw, geometric_mean, is_in_whole_shell, machine, picked_cases, write_json

LAYOUTS = ((4, False), (6, True))  # picks, closed
SAMPLES = 400  # of MeshLib's spline, as many as our polylines have at least


def median_seconds(call, repeat):
    times = []
    for _ in range(repeat):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return float(np.median(times))


def geodesic(case, repeat):
    import potpourri3d

    ids = [int(((case.vertices - pick) ** 2).sum(1).argmin()) for pick in case.picks]
    ends = ids + ids[:1] if case.closed else ids

    def paths(solver):
        return [solver.find_geodesic_path(a, b) for a, b in zip(ends[:-1], ends[1:])]

    def make():
        return potpourri3d.EdgeFlipGeodesicSolver(case.vertices, case.faces)

    cold = median_seconds(lambda: paths(make()), min(repeat, 3))
    solver = make()
    paths(solver)
    return cold, median_seconds(lambda: paths(solver), repeat)


def meshlib(case, repeat):
    from meshlib import mrmeshnumpy, mrmeshpy

    control = np.vstack([case.picks, case.picks[:1]]) if case.closed else case.picks
    step = float(np.linalg.norm(np.diff(control, axis=0), axis=1).sum() / SAMPLES)
    faces = case.faces.astype(np.int32)

    def make():
        return mrmeshnumpy.meshFromFacesVerts(faces, case.vertices)

    def spline(mesh):
        points = mrmeshpy.std_vector_Vector3_float()
        for point in control:
            points.append(mrmeshpy.Vector3f(*map(float, point)))
        settings = mrmeshpy.SplineSettings()
        settings.samplingStep, settings.controlStability, settings.iterations = step, 1000, 2
        return mrmeshpy.projectSplineAsMTP(mesh, mrmeshpy.makeSpline(points, settings))

    cold = median_seconds(lambda: spline(make()), min(repeat, 3))
    mesh = make()
    spline(mesh)
    return cold, median_seconds(lambda: spline(mesh), repeat)


def compare(program, case, rounds, repeat):
    """Cold and warm seconds of each; the least of several rounds."""
    times = {"geodesic": [], "meshlib": [], "ours": []}
    for _ in range(rounds):
        times["geodesic"].append(geodesic(case, repeat))
        times["meshlib"].append(meshlib(case, repeat))
        report = draw(program, case, repeat=repeat)
        times["ours"].append((report["seconds"]["cold"], report["seconds"]["warm"]))
    row = {"case": case.name, "vertices": len(case.vertices), "closed": case.closed, "picks": len(case.picks),
           "whole_shell": is_in_whole_shell(report)}
    for who, pairs in times.items():
        row[who] = dict(zip(("cold", "warm"), map(min, zip(*pairs))))
    return row


def ratios_of(rows):
    """Ours relative to each peer: one number per curve."""
    return {f"{state}, ours / {peer}": [row["ours"][state] / row[peer][state] for row in rows]
            for state in ("warm", "cold") for peer in ("meshlib", "geodesic")}


def text_of(row):
    if "reason" in row:
        return f"{row['case']:28} no curve: {row['reason']}"
    columns = [f"{1e3 * row[who][state]:10.2f}" for who in ("geodesic", "meshlib", "ours") for state in ("cold", "warm")]
    return f"{row['case']:28} {row['vertices']:8,} {' '.join(columns)}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--repeat", type=int, default=9, help="warm curves in each round")
    parser.add_argument("--quick", action="store_true", help="two small meshes, one round")
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    if given.quick:
        given.rounds, given.repeat = 1, 2
    print(f"{'milliseconds':28} {'vertices':>8} " + " ".join(
        f"{who + ' ' + state:>10.10}" for who in ("geod.", "meshl.", "ours") for state in ("cold", "warm")))
    rows = []
    for case in picked_cases(LAYOUTS, given.quick):
        try:
            rows.append(compare(given.program, case, given.rounds, given.repeat))
        except NoCurve as failure:
            rows.append({"case": case.name, "vertices": len(case.vertices), "reason": str(failure)})
        print(text_of(rows[-1]), flush=True)
    drawn = [row for row in rows if "reason" not in row]
    ratios = ratios_of(drawn)
    for label, values in ratios.items():
        print(f"{label:28} geometric mean {geometric_mean(values):.2f}, worst {max(values):.2f}, of {len(values)}")
    write_json(given.json, {"machine": machine(), "rows": rows, "ratios": ratios})
    return 0 if len(drawn) == len(rows) else 1


if __name__ == "__main__":
    sys.exit(main())
