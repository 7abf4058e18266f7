#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the same curves in both kinds of shell and writes how they compare into docs/SHELLS.md.

    scripts/shell_kinds_table.py MESH:PICKS...

Times are the program's own: seconds.shell once per curve, and the median of further curves on the same shell (warm).
Bending is the integral of the squared geodesic curvature over the curve, resampled at 100 points.
"""
import argparse
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from render_curve import read_mesh, vertex_normals
from shell_table import replace_table

ROOT = Path(__file__).resolve().parents[1]
HEAD = ("| curve | shell full, s | simplified, s | warm full, ms | simplified, ms | ratio | bending, ratio |\n"
        "|---|--:|--:|--:|--:|--:|--:|\n")
POINTS = 100


def draw(program, mesh, picks, kind, repeats):
    """The curve and the report of one run, or why there is none."""
    with tempfile.TemporaryDirectory() as folder:
        output, report = Path(folder) / "curve.json", Path(folder) / "report.json"
        words = [program, mesh, "--picks", picks, "--shell", kind, "--repeat", repeats, "--no-cache",
                 "--output", output, "--report", report]
        done = subprocess.run(list(map(str, words)), capture_output=True, text=True)
        if done.returncode != 0:
            return None, done.stderr.strip()
        return json.loads(output.read_text()), json.loads(report.read_text())


def bending(mesh, curve):
    """The integral of the squared geodesic curvature."""
    vertices, faces = mesh
    line = curve["polyline"]
    points = np.array(line["points"])
    corners = faces[np.array(line["faces"])]
    normals = (np.array(line["barycentrics"])[:, :, None] * vertex_normals(vertices, faces)[corners]).sum(1)
    if curve["closed"]:
        points, normals = np.vstack([points, points[:1]]), np.vstack([normals, normals[:1]])
    lengths = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    at = np.linspace(0, lengths[-1], POINTS + 1)
    p = np.stack([np.interp(at, lengths, points[:, k]) for k in range(3)], 1)
    n = np.stack([np.interp(at, lengths, normals[:, k]) for k in range(3)], 1)
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    if curve["closed"]:
        p, n = p[:-1], n[:-1]
        ahead, behind = np.roll(p, -1, 0) - p, p - np.roll(p, 1, 0)
    else:
        ahead, behind, n = p[2:] - p[1:-1], p[1:-1] - p[:-2], n[1:-1]
    tangent = ahead + behind
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    step = lengths[-1] / POINTS
    curvature = ((ahead - behind) * np.cross(n, tangent)).sum(1) / step**2
    return float((curvature**2).sum() * step)


def compare(program, mesh_file, picks, repeats):
    """The row of one curve, and its two ratios (None where a kind of shell has no curve)."""
    mesh = read_mesh(mesh_file)[:2]
    results = {kind: draw(program, mesh_file, picks, kind, repeats) for kind in ("full", "simplified")}
    failures = [f"{kind}: {result[1]}" for kind, result in results.items() if result[0] is None]
    if failures:
        return f"| {picks.stem} | | | | | | {'; '.join(failures).replace('|', '/')} |", None
    (full, full_report), (simplified, simplified_report) = results["full"], results["simplified"]
    before, after = full_report["seconds"], simplified_report["seconds"]
    ratios = after["warm"] / before["warm"], bending(mesh, simplified) / bending(mesh, full)
    return (f"| {picks.stem} | {before['shell']:.2f} | {after['shell']:.2f} | {before['warm'] * 1e3:.1f} "
            f"| {after['warm'] * 1e3:.1f} | {ratios[0]:.2f} | {ratios[1]:.2f} |"), ratios


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("curves", nargs="+", metavar="MESH:PICKS")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/bspline_curve")
    parser.add_argument("--repeats", type=int, default=15)
    parser.add_argument("--page", type=Path, default=ROOT / "docs/SHELLS.md")
    given = parser.parse_args()
    rows, ratios = [], []
    for curve in given.curves:
        mesh, picks = map(Path, curve.split(":"))
        row, pair = compare(given.program, mesh, picks, given.repeats)
        rows.append(row)
        ratios += [pair] if pair else []
        print(row, flush=True)
    if ratios:
        warm, bent = (geometric_mean(column) for column in zip(*ratios))
        rows.append(f"| geometric mean of {len(ratios)} | | | | | {warm:.2f} | {bent:.3f} |")
        print(rows[-1])
    replace_table(given.page, "kinds", HEAD + "\n".join(rows))
    return 0 if len(ratios) == len(given.curves) else 1


if __name__ == "__main__":
    sys.exit(main())
