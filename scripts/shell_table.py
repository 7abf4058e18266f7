#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the shells of meshes, one thread, and writes their figures into the table of docs/SHELLS.md.

    scripts/shell_table.py                        the meshes that pymeshlab's wheel carries
    scripts/shell_table.py a.ply b.off -- OPTION  these, with further options of `bspline_curve shell`

Times are medians of several runs. A mesh that is refused gets a row with the reason.
"""
import argparse
import json
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
HEAD = ("| mesh | faces | prisms | mean thickness | 5 % thinner than | CPU, s | peak memory, MB | bytes per face | checks |\n"
        "|---|--:|--:|--:|--:|--:|--:|--:|---|\n")


def packaged_meshes():
    import pymeshlab

    folder = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"
    return sorted(path for path in folder.iterdir() if path.suffix in (".ply", ".obj", ".off"))


def build(program, mesh, options, runs):
    """The report of the run with the median CPU time, or why the mesh was refused."""
    reports = []
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        for _ in range(runs):
            words = [str(program), "shell", str(mesh), "--no-cache", "--check", "--report", str(report), *options]
            done = subprocess.run(words, capture_output=True, text=True)
            if not report.exists():
                return None, done.stderr.strip().removeprefix("bspline_curve: ")
            reports.append(json.loads(report.read_text()))
    median = statistics.median_low(r["seconds"]["cpu"] for r in reports)
    return next(r for r in reports if r["seconds"]["cpu"] == median), ""


def row(name, report, reason):
    if report is None:
        return f"| {name} | | | | | | | | refused: {reason.replace('|', '/')} |"
    broken = [key for key, entry in report["check"].items() if not entry["holds"]]
    notes = f"FAILED: {', '.join(broken)}" if broken else "all hold"
    if report["blocked_faces"]:
        notes += f", {report['blocked_faces']} faces without a prism"
    if report["repair"] and report["repair"]["changes"]:
        notes += f", {report['repair']['changes']} spots mended"
    memory = report["peak_memory_bytes"]
    thickness = report["thickness"]
    return (f"| {name} | {report['faces']:,} | {report['prisms']:,} | {thickness['mean']:.4f} | {thickness['p5']:.4f} "
            f"| {report['seconds']['cpu']:.2f} | {memory / 1e6:.1f} | {memory / report['faces']:,.0f} | {notes} |")


def replace_table(page, name, table):
    """Puts another table between the markers of that name in a page."""
    begin, end = (f"<!-- {name} table: {word} -->" for word in ("begin", "end"))
    before, rest = page.read_text().split(begin)
    _, after = rest.split(end)
    page.write_text(f"{before}{begin}\n{table}\n{end}{after}")


def main():
    arguments, options = sys.argv[1:], []
    if "--" in arguments:
        at = arguments.index("--")
        arguments, options = arguments[:at], arguments[at + 1:]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="*", type=Path)
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/bspline_curve")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--page", type=Path, default=ROOT / "docs/SHELLS.md")
    given = parser.parse_args(arguments)

    rows = []
    for mesh in given.meshes or packaged_meshes():
        rows.append(row(mesh.stem, *build(given.program, mesh, options, given.runs)))
        print(rows[-1], flush=True)
    replace_table(given.page, "shell", HEAD + "\n".join(rows))
    return 1 if any("FAILED" in text for text in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
