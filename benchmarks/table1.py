#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of the paper's Table 1 rebuilt as nearly as meshes allow, and its curve of 5,132 samples (Fig. 12a).

    benchmarks/table1.py [--json FILE] [--quick]

The paper's meshes are not public: each row has the bunny of pymeshlab's wheel instead, refined by Loop's rule and decimated to as
many vertices, with as many picks far apart (seeded), as an open curve. The paper's seconds are of its machine, its shell
not counted; our cold counts everything from the arrays in memory on, the field included. Times are the least of several rounds.
Needs requirements.txt.
"""
import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

from cases import PROGRAM, Case, NoCurve, best_of, draw, farthest_picks, is_in_whole_shell, machine, packaged_meshes, write_json

SEED = 3


@dataclass
class Row:
    name: str
    vertices: int
    picks: int
    seconds: float  # the paper's
    knots: tuple | None = None  # the paper's, of the first and of the last curve
    options: tuple = ()


ROWS = (
    Row("Ghost (Fig. 17)", 1000, 7, 0.073, (10, 32)),
    Row("Bunny (Fig. 11a)", 3000, 4, 0.098, (8, 34)),
    Row("Squirrel (Fig. 10b)", 8000, 10, 0.863, (23, 91)),
    Row("Elephant (Fig. 17)", 24000, 4, 0.497, (9, 51)),
    Row("Armadillo (Fig. 14c)", 50000, 6, 1.023, (11, 23)),
    Row("Cup (Fig. 15c)", 300000, 7, 3.228, (11, 39)),
    Row("Cup (Fig. 15d), with a field", 300000, 7, 50.981, (11, 71), ("--field", "maximal-curvature")),
    Row("Fig. 12a: 5,132 samples, tension 0.5", 24000, 7, 0.320, None, ("--samples", "5132", "--tension", "0.5")),
)


def bunny_of(vertices):
    """The bunny with about so many vertices: two faces for each."""
    import pymeshlab

    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.load_new_mesh(str(next(path for path in packaged_meshes() if path.stem == "bunny")))
    while meshes.current_mesh().vertex_number() < vertices:
        meshes.meshing_surface_subdivision_loop(iterations=1, threshold=pymeshlab.PercentageValue(0))
    meshes.meshing_decimation_quadric_edge_collapse(targetfacenum=2 * vertices)
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


def measure(program, row, mesh, rounds, repeat):
    vertices, faces = mesh
    case = Case(row.name, vertices, faces, farthest_picks(vertices, faces, row.picks, SEED), False)
    report = best_of([draw(program, case, *row.options, repeat=repeat) for _ in range(rounds)])
    seconds = report["seconds"]
    return {"vertices": len(vertices), "points": report["curve"]["vertices"], "field_seconds": seconds["field"],
            "cold": seconds["cold"], "warm": seconds["warm"], "knots": [report["knots_first"], report["knots_last"]],
            "whole_shell": is_in_whole_shell(report)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--repeat", type=int, default=7, help="warm curves in each round")
    parser.add_argument("--quick", action="store_true", help="the two smallest rows, one round")
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    wanted = ROWS[:2] if given.quick else ROWS
    if given.quick:
        given.rounds, given.repeat = 1, 1
    meshes = {count: bunny_of(count) for count in sorted({row.vertices for row in wanted})}
    print(f"{'row':38} {'vertices':>9} {'picks':>5} {'paper, s':>9} {'cold, s':>9} {'warm, s':>9}")
    rows, failed = [], 0
    for row in wanted:
        result = {"name": row.name, "picks": row.picks, "paper_seconds": row.seconds, "paper_knots": row.knots}
        try:
            result |= measure(given.program, row, meshes[row.vertices], given.rounds, given.repeat)
            print(f"{row.name:38} {result['vertices']:9,} {row.picks:5} {row.seconds:9.3f} {result['cold']:9.3f} "
                  f"{result['warm']:9.4f}", flush=True)
        except NoCurve as failure:
            result |= {"vertices": row.vertices, "reason": str(failure)}
            failed = 1
            print(f"{row.name:38} no curve: {failure}", flush=True)
        rows.append(result)
    write_json(given.json, {"machine": machine(), "rows": rows})
    return failed


if __name__ == "__main__":
    sys.exit(main())
