#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the curves of zoo.py in the Python package and in pymeshlab, and compares them with the program's.

    .cache/venv/bin/python benchmarks/zoo_hosts.py FOLDER...
    .cache/venv/bin/python benchmarks/zoo_hosts.py FOLDER... --page     # writes the table into docs/ROBUSTNESS.md as well

Meshes are read by pymeshlab, which leaves out faces without area and joins no vertices; where it reads another mesh than the
program does, another curve is right. A curve is the same where it has as many points, all of them in the same place.
"""
import argparse
import json
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path

import numpy as np
import pymeshlab
from cases import PROGRAM, ROOT, replace_table
from zoo import OPTIONS, cases_in, share, table

SAME = 1e-9  # of the diagonal
KEYWORDS = {"C": {"field": "valley"}}  # as zoo.OPTIONS
FILTER = "generate_bspline_curve_on_surface"


def of_program(mesh, kind, picks, folder):
    curve, report = folder / "curve.json", folder / "report.json"
    words = [PROGRAM, mesh, "--picks", picks, "--output", curve, "--report", report, "--no-cache", *OPTIONS.get(kind, [])]
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True)
    if done.returncode != 0:
        return None, done.stderr
    line, told = json.loads(curve.read_text()), json.loads(report.read_text())
    for file in (curve, report):
        file.unlink()
    return np.array(line["polyline"]["points"]), told["usable"]


def of_package(package, arrays, picks, options):
    try:
        curve = package.Mesh(*arrays).curve(picks, **options)
    except package.InputError as error:
        return None, str(error)
    return curve.points, curve.usable


def of_filter(document, picks, options):
    through = "; ".join(" ".join(map(repr, point)) for point in picks)
    try:
        figures = document.apply_filter(FILTER, picks=through, **options)
    except pymeshlab.PyMeshLabException as error:
        return None, str(error)
    return document.current_mesh().vertex_matrix(), bool(figures["usable"])


def is_same(points, other):
    if points is None or other is None or len(points) != len(other):
        return points is other
    return np.abs(points - other).max() <= SAME * np.linalg.norm(np.ptp(points, axis=0))


def row_of(package, mesh, kind, file, folder):
    given = json.loads(file.read_text())
    picks, options = given["picks"], {"closed": given.get("closed", False), **KEYWORDS.get(kind, {})}
    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(mesh))
    read = document.current_mesh()
    arrays = read.vertex_matrix(), read.face_matrix()
    row = {"name": f"{mesh.name} {kind}", "program": of_program(mesh, kind, file, folder)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        row |= {"Python": of_package(package, arrays, picks, options), "pymeshlab": of_filter(document, picks, options)}
    return row, document


def hosts_table(rows):
    lines = []
    for host in ("program", "Python", "pymeshlab"):
        same = sum(bool(is_same(row[host][0], row["program"][0])) for row in rows)
        lines.append([host, len(rows), f"{share(rows, lambda row: row[host][0] is not None):.1f}",
                      f"{share(rows, lambda row: row[host][0] is not None and row[host][1]):.1f}", same if host != "program" else ""])
    return table(["host", "curves", "answers, %", "usable, %", "the program's curve"], lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "release")
    parser.add_argument("--only", default="", help="meshes whose names hold this")
    parser.add_argument("--page", nargs="?", type=Path, const=ROOT / "docs" / "ROBUSTNESS.md", help="page that gets the table")
    given = parser.parse_args()
    sys.path.insert(0, str(given.build / "python"))
    import bspline_curve

    pymeshlab.load_plugin(str(given.build / "plugins" / "libfilter_bspline_curve.so"))
    rows, kept = [], []
    with tempfile.TemporaryDirectory() as folder:
        for mesh, kind, picks in cases_in(given.folders):
            if given.only not in mesh.name:
                continue
            row, document = row_of(bspline_curve, mesh, kind, picks, Path(folder))
            rows.append(row)
            if row["pymeshlab"][0] is None:
                kept.append(document)  # pymeshlab uses the log of a document that an error came from once more
            for host in ("program", "Python", "pymeshlab"):
                points, told = row[host]
                if points is None or not told:
                    print(f"{row['name']}, {host}: {'not usable' if points is not None else told.strip()}", flush=True)
                elif not is_same(points, row["program"][0]):
                    print(f"{row['name']}, {host}: another curve than the program's", flush=True)
    print(hosts_table(rows))
    if given.page:
        replace_table(given.page, "hosts", hosts_table(rows))


if __name__ == "__main__":
    main()
