#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times the same curve as a spline and as a polyline that is optimised itself, at more and more samples (as in the paper's Fig. 12).

    benchmarks/polyline_method.py [--json FILE] [--quick]

The mesh, picks and tension are those of the row "Fig. 12a" of table1.py, the numbers of samples those of Fig. 12a - d and some between.
The program polyline_comparison, built beside --program, draws both over the same fibres (see polyline_relaxation.h); each time is from
the picks to the polyline, and the least of several runs. Needs requirements.txt.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from cases import PROGRAM, farthest_picks, machine, write_json, write_ply
from table1 import SEED, bunny_of

SAMPLES = (165, 358, 600, 1200, 2500, 5132)
VERTICES, PICKS, TENSION = 24000, 7, 0.5


def compare(program, vertices, picks, samples, repeat):
    """What polyline_comparison says."""
    mesh_vertices, faces = bunny_of(vertices)
    points = farthest_picks(mesh_vertices, faces, picks, SEED)
    with tempfile.TemporaryDirectory() as folder:
        mesh, picked = Path(folder) / "mesh.ply", Path(folder) / "picks.json"
        write_ply(mesh, mesh_vertices, faces)
        picked.write_text(json.dumps({"picks": points.tolist(), "closed": False}))
        words = [program.parent / "polyline_comparison", mesh, picked, "--tension", TENSION, "--repeat", repeat,
                 "--samples", *samples]
        done = subprocess.run(list(map(str, words)), capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"polyline_method.py: {done.stderr.strip()}")
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--repeat", type=int, default=15, help="runs of each, of which the quickest counts")
    parser.add_argument("--quick", action="store_true", help="a small mesh, two numbers of samples, one run")
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    results = (compare(given.program, 3000, 4, SAMPLES[:2], 1) if given.quick
               else compare(given.program, VERTICES, PICKS, SAMPLES, given.repeat))
    print(f"{'samples':>8} {'spline, ms':>11} {'polyline, ms':>13} {'energy, spline / polyline':>26}")
    for row in results["rows"]:
        spline, polyline = row["spline"], row["polyline"]
        print(f"{row['samples']:8,} {1e3 * spline['seconds']:11.2f} {1e3 * polyline['seconds']:13.2f} "
              f"{spline['internal'] / polyline['internal']:26.2f}")
    write_json(given.json, {"machine": machine()} | results)
    return 0


if __name__ == "__main__":
    sys.exit(main())
