#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tells which rules of the paper keep its preset from what Figures 9 and 10 show.

    benchmarks/paper_rules.py                    curves on meshes of pymeshlab's wheel and on tori
    benchmarks/paper_rules.py --cases FOLDER     those of files NAME.json: {"mesh": file, "picks": [...], "closed": bool}
    benchmarks/paper_rules.py --page             writes the table into docs/PAPER.md as well

The rules of `preset=paper` are replaced by those of the default one after another, each row with those of the rows above. For
each curve it is told whether its length ever rises by more than 0.5 % as λ goes 0, 0.25, 0.5, 0.75, 1, whether it is longer with
λ = 1 than with 0, and whether its knots rise from degree 2 to 3 or 4 with λ = 0.5. Takes some minutes.
"""
import argparse
import os
import statistics
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from cases import (PROGRAM, ROOT, SEED, Case, cases_of, farthest_picks, packaged_mesh, replace_table, report_of, torus_of, write_case,
                   write_json)

RULES = [  # what takes the place, in words and as options
    ("as in the paper", []),
    ("(9) penalty at picks → constraints", ["--interpolation", "constraint"]),
    ("(12) narrow barrier → full width", ["--barrier-width", "full"]),
    ("(14)–(16) samples → exact integrals", ["--quadrature", "cells"]),
    ("(18) weights → schedule", ["--distance-weight", "schedule"]),
    ("(19)–(23) feature function → predicted gains", ["--knot-rule", "energy-and-distance"]),
    ("simplified shell → shell of all faces", ["--shell", "full"]),
]
DEFAULT = ("the default", None)
TENSIONS = (0, 0.25, 0.5, 0.75, 1)
DEGREES = (2, 3, 4)
MIDDLE = 0.5      # λ for degrees
ALLOWED = 1.005   # lengths may rise by this factor
LAYOUTS = ((4, False), (6, True), (7, False))
PACKAGED = ("bone", "bunny10k_textured", "airplane")
TORI = (1000, 3000)  # vertices


def own_cases(quick):
    meshes = [(name, packaged_mesh(name)) for name in (("bone",) if quick else PACKAGED)]
    meshes += [(f"torus of {count:,}", torus_of(count)) for count in (() if quick else TORI)]
    for name, (vertices, faces) in meshes:
        for count, closed in LAYOUTS[:1] if quick else LAYOUTS:
            picks = farthest_picks(vertices, faces, count, SEED)
            yield Case(f"{name}, {count} {'closed' if closed else 'open'}", vertices, faces, picks, closed)


class CaseRuns:
    """Runs of the program on a case, whose files are written once; shells are kept in its folder."""

    def __init__(self, program, folder, case):
        folder.mkdir()
        self.program, self.folder, self.files = program, folder, write_case(folder, case)

    def draw(self, tension, degree, options):
        chosen = ["--tension", tension, "--degree", degree, *options]
        return report_of(self.program, self.folder, *self.files, *chosen, XDG_CACHE_HOME=str(self.folder))

    def figures(self, options):
        """Length by λ and knots by degree."""
        by_tension = [self.draw(tension, 3, options) for tension in TENSIONS]
        lengths = [report["curve"]["length"] for report in by_tension]
        middle = by_tension[TENSIONS.index(MIDDLE)]
        knots = [(middle if degree == 3 else self.draw(MIDDLE, degree, options))["knots_last"] for degree in DEGREES]
        return {"lengths": lengths, "knots": knots}


def rises(values, allowed=1.0):
    return any(after > allowed * before for before, after in zip(values, values[1:]))


def row_of(rule, cases):
    return {
        "rule": rule,
        "curves": len(cases),
        "rising": sum(rises(case["lengths"], ALLOWED) for case in cases),
        "longer": sum(case["lengths"][-1] > ALLOWED * case["lengths"][0] for case in cases),
        "ratio": statistics.mean(case["lengths"][-1] / case["lengths"][0] for case in cases),
        "more_knots": sum(rises(case["knots"]) for case in cases),
        "knots": [statistics.median(case["knots"][i] for case in cases) for i in range(len(DEGREES))],
    }


def table_of(rows):
    lines = [f"| rule replaced | length rises, of {rows[0]['curves']} curves | longer with λ = 1 than with 0 | mean length, λ = 1 / 0 "
             "| knots rise with the degree | median knots, degree 2, 3, 4 |",
             "|---|--:|--:|--:|--:|--:|"]
    for row in rows:
        knots = ", ".join(f"{count:.0f}" for count in row["knots"])
        lines.append(f"| {row['rule']} | {row['rising']} | {row['longer']} | {row['ratio']:.3f} | {row['more_knots']} | {knots} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cases", type=Path, help="folder of cases, in place of those made by a rule")
    parser.add_argument("--quick", action="store_true", help="one curve")
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--page", action="store_true", help="write the table into docs/PAPER.md as well")
    given = parser.parse_args()
    cases = list(cases_of(given.cases) if given.cases else own_cases(given.quick))
    rows, options = [], ["--preset", "paper"]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        runs = [CaseRuns(given.program, Path(folder) / str(index), case) for index, case in enumerate(cases)]
        for rule, more in [*RULES, DEFAULT]:
            options = [] if more is None else options + more
            rows.append(row_of(rule, list(pool.map(lambda run: run.figures(options), runs))))
            print(rows[-1], flush=True)
    write_json(given.json, rows)
    print(table_of(rows))
    if given.page:
        replace_table(ROOT / "docs" / "PAPER.md", "rules", table_of(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
