#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws curves on folders of meshes that people have, and tells what came of them.

    benchmarks/zoo.py FOLDER...                  all curves of the meshes there
    benchmarks/zoo.py FOLDER... --judge FILE     has each curve judged by a program of somebody else
    benchmarks/zoo.py FOLDER... --page           writes the tables into docs/ROBUSTNESS.md as well

A folder holds meshes, and their picks beside them or in its folder picks/: NAME.A.picks.json are those of an open curve, B of a
closed one, C of an open one under the field `valley`, NAME.picks.json of a curve as the file says. Each curve is a process of its
own. Times are CPU seconds of the process; the usual time for a size is the median of the curves of the same kind on meshes of at
least half and at most twice the faces. The judge is called as FILE MESH CURVE.json --picks PICKS --quiet and exits with 0 where it
is content. Where it complains, the faces that the curve names are looked at: on sheets that lie upon each other a judge cannot
know which of them a point belongs to.
"""
import argparse
import json
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import numpy as np
from cases import PROGRAM, ROOT, machine, replace_table, write_json

MESHES = (".ply", ".obj", ".off", ".stl")
KINDS = {"A": "open, 4 picks", "B": "closed, 6 picks", "C": "open, field `valley`", "": "other picks"}
OPTIONS = {"C": ["--field", "valley"]}
MENDED = {"left_out_faces": "faces that are not finite left out", "merged_vertices": "vertices merged", "removed_degenerate_faces": "faces without area removed",
          "split_faces": "faces split", "removed_duplicate_faces": "duplicate faces removed", "reversed_faces": "faces reversed",
          "cut_edges": "edges cut", "duplicated_vertices": "vertices duplicated"}
SIMILAR = 2.0  # sizes within this factor are alike
TARGETS = {"answers, %": ("at least", 99.5), "usable, %": ("at least", 97),
           "judged right, or strict by the faces that they name, %": ("at least", 100),
           "longest time / usual time for the size": ("at most", 50)}


# ---------------------------------------------------------------- cases
def picks_files(mesh):
    """(kind, file) of each curve of a mesh."""
    for folder in (mesh.parent, mesh.parent / "picks"):
        for kind in KINDS:
            file = folder / (f"{mesh.stem}.{kind}.picks.json" if kind else f"{mesh.stem}.picks.json")
            if file.is_file():
                yield kind, file


def cases_in(folders):
    meshes = [mesh for folder in folders for mesh in sorted(folder.iterdir()) if mesh.suffix.lower() in MESHES]
    return [(mesh, kind, picks) for mesh in meshes for kind, picks in picks_files(mesh)]


# ---------------------------------------------------------------- runs
def timed(words, timeout):
    """Return code (none: too slow), what was said, CPU seconds, wall seconds."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    try:
        done = subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=timeout)
        code, said = done.returncode, done.stderr.strip()
    except subprocess.TimeoutExpired:
        code, said = None, f"not done after {timeout:g} s"
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return code, said.removeprefix("bspline_curve: ").replace("\n", " "), cpu, time.monotonic() - start


def judged(judge, mesh, curve, picks):
    """Empty where the judge is content."""
    done = subprocess.run([sys.executable, judge, mesh, curve, "--picks", picks, "--quiet"], capture_output=True, text=True)
    if done.returncode != 0 and not done.stdout.strip():
        sys.exit(f"zoo.py: {judge} does not run: {done.stderr.strip()}")
    return "" if done.returncode == 0 else done.stdout.strip().splitlines()[-1]


def read_every_face(mesh):
    """Also those without area, which MeshLab leaves out: the program numbers faces as the file does."""
    import trimesh

    loaded = trimesh.load(mesh, force="mesh", process=False, maintain_order=True)
    return np.asarray(loaded.vertices), np.asarray(loaded.faces)


def loose_segments(mesh, curve):
    """How many segments have ends that share none of the faces that the curve names for them; points that are not where their
    barycentric coordinates say share none."""
    vertices, faces = read_every_face(mesh)
    corners = vertices[faces]
    faces = np.unique(vertices, axis=0, return_inverse=True)[1].reshape(-1)[faces]  # the same place is the same vertex
    line = json.loads(Path(curve).read_text())
    points, named, weights = (np.array(line["polyline"][key]) for key in ("points", "faces", "barycentrics"))
    near = np.linalg.norm((corners[named] * weights[:, :, None]).sum(1) - points, axis=1) < 1e-6 * np.ptp(vertices)
    around = {}
    for index, face in enumerate(faces.tolist()):
        for corner in face:
            around.setdefault(corner, set()).add(index)
    holders = [set.intersection(*(around[v] for v in faces[face][weight > 1e-9])) if is_near else set()
               for face, weight, is_near in zip(named, weights, near)]
    pairs = zip(holders, holders[1:] + (holders[:1] if line["closed"] else []))
    return sum(not first & second for first, second in pairs)


def row_of(given, mesh, kind, picks):
    """What became of one curve."""
    with tempfile.TemporaryDirectory() as folder:
        curve, report = Path(folder) / "curve.json", Path(folder) / "report.json"
        words = [given.program, mesh, "--picks", picks, "--output", curve, "--report", report, "--no-cache",
                 *OPTIONS.get(kind, []), *given.option]
        code, said, cpu, wall = timed(words, given.timeout)
        row = {"mesh": mesh.name, "kind": kind, "code": code, "said": said, "cpu": cpu, "wall": wall, "answer": curve.is_file()}
        if code != 0 or not report.is_file():
            return row
        told = json.loads(report.read_text())
        row |= {key: told[key] for key in ("status", "usable", "shell", "seconds", "max_distance", "allowed_distance")}
        row |= {"faces": told["mesh"]["faces"], "peak_bytes": told["peak_memory_bytes"]["cold"],
                "mended": {key: len(told["repair"][key]) for key in MENDED} if told["repair"] else None}
        if given.judge and curve.is_file():
            row["judged"] = judged(given.judge, mesh, curve, picks)
            row["loose"] = loose_segments(mesh, curve) if row["judged"] else 0
        return row


# ---------------------------------------------------------------- figures
def add_ratios(rows):
    """To each curve its time relative to the usual one for its kind and size."""
    sized = [row for row in rows if "faces" in row]
    for row in sized:
        alike = [other["cpu"] for other in sized if other["kind"] == row["kind"]
                 and abs(math.log(other["faces"] / row["faces"])) <= math.log(SIMILAR)]
        row["ratio"] = row["cpu"] / statistics.median(alike)


def share(rows, holds):
    return 100 * sum(map(bool, map(holds, rows))) / len(rows)


def figures_of(rows):
    """The measured values of TARGETS."""
    drawn = [row for row in rows if "judged" in row]
    return {"answers, %": share(rows, lambda row: row["answer"]),
            "usable, %": share(rows, lambda row: row.get("usable")),
            "judged right, or strict by the faces that they name, %":
                share(drawn, lambda row: not row["judged"] or not row["loose"]) if drawn else None,
            "longest time / usual time for the size": max((row["ratio"] for row in rows if "ratio" in row), default=None)}


def is_met(name, value):
    word, bound = TARGETS[name]
    return value >= bound if word == "at least" else value <= bound


# ---------------------------------------------------------------- tables
def table(head, rows):
    """The first column is text, the others are numbers."""
    rules = ["---"] + ["--:"] * (len(head) - 1)
    return "\n".join("| " + " | ".join(map(str, row)) + " |" for row in (head, rules, *rows))


def targets_table(rows):
    lines = []
    for name, value in figures_of(rows).items():
        if value is not None:
            met = "yes" if is_met(name, value) else "**no**"
            lines.append([name, "{} {:g}".format(*TARGETS[name]), f"{value:.1f}", met])
    return table(["", "asked", "measured", "met"], lines)


def kinds_table(rows):
    statuses = [status for status, _ in Counter(row["status"] for row in rows if "status" in row).most_common()]
    lines = []
    for kind, text in KINDS.items():
        of_kind = [row for row in rows if row["kind"] == kind]
        if of_kind:
            counts = Counter(row.get("status") for row in of_kind)
            lines.append([text, len(of_kind), sum(row["answer"] for row in of_kind), sum(row.get("usable", False) for row in of_kind),
                          *(counts[status] for status in statuses)])
    return table(["curves", "number", "answers", "usable", *statuses], lines)


def mended_table(rows):
    """Meshes by what had to be mended; a mesh may stand in several lines."""
    by_mesh = {row["mesh"]: row["mended"] for row in rows if "mended" in row}
    mended = [counts for counts in by_mesh.values() if counts]
    lines = [["taken as they are", len(by_mesh) - len(mended), ""], ["mended", len(mended), ""]]
    for key, text in MENDED.items():
        places = [counts[key] for counts in mended if counts[key]]
        if places:
            lines.append([text, len(places), f"{statistics.median(places):g}, {max(places):,}"])
    return table(["meshes", "number", "places in each: median, most"], lines)


def times_table(rows):
    """By size of the mesh."""
    lines = []
    sized = [row for row in rows if "ratio" in row]
    for power in range(2, 8):
        alike = [row for row in sized if 10**power <= row["faces"] < 10 ** (power + 1)]
        if alike:
            worst = max(alike, key=lambda row: row["ratio"])
            lines.append([f"{10**power:,} to {10 ** (power + 1):,}", len(alike),
                          f"{1e3 * statistics.median(row['cpu'] for row in alike):,.0f}", f"{1e3 * worst['cpu']:,.0f}",
                          f"{worst['ratio']:.1f}", f"{Path(worst['mesh']).stem} {worst['kind']}"])
    return table(["faces", "curves", "median, ms", "worst, ms", "worst / usual", "which"], lines)


def failures(rows):
    for row in rows:
        name = f"{row['mesh']} {row['kind']}"
        if not row["answer"]:
            yield f"no answer: {name}: {row['said']}"
        elif not row["usable"]:
            yield f"not usable: {name}: {row['said']}"
        if row.get("judged"):
            yield f"judged wrong: {name}: {row['judged']}; {row['loose']} segments are in none of the faces that it names"
        if "ratio" in row and not is_met("longest time / usual time for the size", row["ratio"]):
            yield f"slow: {name}: {row['cpu']:.2f} s, {row['ratio']:.0f} times the usual"


def write_page(page, rows):
    info = machine()
    meshes = len({row["mesh"] for row in rows})
    replace_table(page, "machine", f"{meshes} meshes, {len(rows)} curves; {info['processor']}, {info['cores']} cores, load average {info['load']}.")
    for name, made in (("targets", targets_table), ("kinds", kinds_table), ("mended", mended_table), ("times", times_table)):
        replace_table(page, name, made(rows))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--judge", type=Path, help="a program that judges a curve")
    parser.add_argument("--timeout", type=float, default=120, help="seconds that a curve may take")
    parser.add_argument("--only", default="", help="meshes whose names hold this")
    parser.add_argument("--option", action="append", default=[], help="a further option of the program, as --option=--strict")
    parser.add_argument("--json", type=Path, help="what became of each curve")
    parser.add_argument("--page", nargs="?", type=Path, const=ROOT / "docs" / "ROBUSTNESS.md", help="page that gets the tables")
    given = parser.parse_args()
    cases = [case for case in cases_in(given.folders) if given.only in case[0].name]
    if not cases:
        sys.exit("zoo.py: no mesh with picks in " + ", ".join(map(str, given.folders)))
    rows = []
    for number, case in enumerate(cases, 1):
        if sys.stderr.isatty():
            print(f"\r{number} of {len(cases)} ", end="", file=sys.stderr, flush=True)
        rows.append(row_of(given, *case))
    add_ratios(rows)
    for made in (targets_table, kinds_table, mended_table, times_table):
        print(made(rows) + "\n")
    print("\n".join(failures(rows)))
    write_json(given.json, {"machine": machine(), "rows": rows})
    if given.page:
        write_page(given.page, rows)
    return 0 if all(value is None or is_met(name, value) for name, value in figures_of(rows).items()) else 1


if __name__ == "__main__":
    os.environ["BSPLINE_CURVE_CACHE"] = ""
    sys.exit(main())
