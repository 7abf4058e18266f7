#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws curves without a field and with `maximal-curvature`, and prints how they compare as a Markdown table.

    scripts/field_table.py MESH:PICKS...                 at the default weight
    scripts/field_table.py MESH:PICKS... -- OPTION...    these, with further options of the program for both curves

Costs are means of c = exp(-I) along the polyline, by the trapezoid rule between its vertices. Times are the program's own
for further curves on the same shell (warm): the least of the medians of several runs.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from render_curve import read_mesh
from shell_kinds_table import geometric_mean
from shell_table import replace_table

ROOT = Path(__file__).resolve().parents[1]
KIND = "maximal-curvature"
HEAD = ("| curve | mean c, no field | field | change, % | knots, no field | field | iterations, no field | field "
        "| warm, ms, no field | field | ratio |\n"
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n")


class NoCurve(Exception):
    """What the program says where it draws none."""


def run(*words):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True)
    if done.returncode != 0:
        raise NoCurve(done.stderr.strip().replace("\n", " "))


def draw(program, mesh, picks, options, given):
    """A curve, and its report with the least of the warm times of several runs."""
    with tempfile.TemporaryDirectory() as folder:
        output, report = Path(folder) / "curve.json", Path(folder) / "report.json"
        warm = []
        for _ in range(given.runs):
            run(program, mesh, "--picks", picks, "--repeat", given.repeats, "--no-cache", *options,
                "--output", output, "--report", report)
            warm.append(json.loads(report.read_text())["seconds"]["warm"])
        return json.loads(output.read_text()), json.loads(report.read_text()) | {"warm": min(warm)}


def values_of(program, mesh):
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "field.npy"
        run(program, "field", mesh, "--kind", KIND, "--output", output)
        return np.load(output)


def mean_cost(values, faces, curve):
    """The mean of exp(-I) along the polyline; values: I per vertex."""
    line = curve["polyline"]
    points = np.array(line["points"])
    field = (np.array(line["barycentrics"]) * values[faces[np.array(line["faces"])]]).sum(1)
    if curve["closed"]:
        points, field = np.vstack([points, points[:1]]), np.append(field, field[0])
    lengths, cost = np.linalg.norm(np.diff(points, axis=0), axis=1), np.exp(-field)
    return float((lengths * (cost[1:] + cost[:-1]) / 2).sum() / lengths.sum())


def compare(mesh, picks, options, given):
    """The row of one curve, and the ratios of its costs and of its times (None where one of the two is refused)."""
    try:
        values, faces = values_of(given.program, mesh), read_mesh(mesh)[1]
        weight = ["--field-weight", given.field_weight] if given.field_weight is not None else []
        curves = [draw(given.program, mesh, picks, [*options, *field], given) for field in ([], ["--field", KIND, *weight])]
    except NoCurve as failure:
        return f"| {picks.stem} | | | | | | | | | | {str(failure).replace('|', '/')} |", None
    cost = [mean_cost(values, faces, curve) for curve, _ in curves]
    before, after = (report for _, report in curves)
    ratios = cost[1] / cost[0], after["warm"] / before["warm"]
    pairs = [f"{before[key]} | {after[key]}" for key in ("knots_last", "newton_iterations")]
    return (f"| {picks.stem} | {cost[0]:.3f} | {cost[1]:.3f} | {100 * (ratios[0] - 1):+.0f} | {' | '.join(pairs)} "
            f"| {before['warm'] * 1e3:.1f} | {after['warm'] * 1e3:.1f} | {ratios[1]:.2f} |"), ratios


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("curves", nargs="+", metavar="MESH:PICKS")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/bspline_curve")
    parser.add_argument("--field-weight", type=float, help="of the field; left out: the program's default")
    parser.add_argument("--repeats", type=int, default=5, help="further curves in each run")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--page", type=Path, help="a page to write the table into as well")
    words = sys.argv[1:]
    end = words.index("--") if "--" in words else len(words)
    given, options = parser.parse_args(words[:end]), words[end + 1:]
    rows, ratios = [], []
    print(HEAD, end="")
    for curve in given.curves:
        mesh, picks = map(Path, curve.rsplit(":", 1))
        row, pair = compare(mesh, picks, options, given)
        rows.append(row)
        ratios += [pair] if pair else []
        print(row, flush=True)
    if ratios:
        cost, time = (geometric_mean(column) for column in zip(*ratios))
        rows.append(f"| geometric mean of {len(ratios)} | | | {100 * (cost - 1):+.0f} | | | | | | | {time:.2f} |")
        print(rows[-1])
    if given.page:
        replace_table(given.page, "fields", HEAD + "\n".join(rows))
    return 0 if len(ratios) == len(given.curves) else 1


if __name__ == "__main__":
    sys.exit(main())
