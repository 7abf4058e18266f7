#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times curves drawn from Python against the program's warm time, and writes the table of docs/PYTHON.md.

    benchmarks/python_latency.py CASES                # a folder of cases: {"mesh": …, "picks": …, "closed": …} each
    benchmarks/python_latency.py CASES --page         # writes the table into docs/PYTHON.md, too
    benchmarks/python_latency.py CASES --draw-curve PYTHON   # with draw_curve of the Python that has meshlab_bspline_curve

Each case is a file of JSON; the path of its mesh is relative to the folder above CASES. Every time is a median of repeated
runs, program and package in turn, so that a busy machine hits both.
"""

import argparse
import json
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
BEGIN, END = "<!-- table of benchmarks/python_latency.py -->\n", "<!-- end of table -->\n"
STEP = 0.002  # a moved pick goes this far, relative to the diagonal

OLD = """
import json, sys, time
import numpy as np
from meshlab_bspline_curve import draw_curve
data = np.load(sys.argv[1])
times = []
for _ in range(int(sys.argv[2]) + 1):
    start = time.perf_counter()
    draw_curve(data["vertices"], data["faces"], data["picks"], closed=bool(data["closed"]), field="none")
    times.append(time.perf_counter() - start)
print(json.dumps(times[1:]))
"""


def timed(call, count):
    """Median seconds."""
    times = []
    for _ in range(count):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def timed_with_stages(draw, count):
    """Median seconds of a curve, and the median of their ratio to the seconds of its own stages in the core."""
    times, ratios = [], []
    for _ in range(count):
        start = time.perf_counter()
        curve = draw()
        times.append(time.perf_counter() - start)
        ratios.append(times[-1] / sum(curve.report["seconds"].values()))
    return statistics.median(times), statistics.median(ratios)


def program_seconds(program, mesh, case, folder, count):
    """Median seconds of a further curve, and of preparing the mesh."""
    picks, report = folder / "picks.json", folder / "report.json"
    picks.write_text(json.dumps({"picks": case["picks"], "closed": case.get("closed", False)}))
    command = [program, mesh, "--picks", picks, "--output", folder / "curve.json", "--report", report, "--repeat", str(count)]
    subprocess.run([str(word) for word in command], check=True, capture_output=True)
    return json.loads(report.read_text())["seconds"]["warm"]


def read_mesh(mesh):
    import meshio

    read = meshio.read(mesh)
    return np.asarray(read.points, float), read.cells_dict["triangle"].astype(np.int32)


def measure(package, program, path, old, count):
    case = json.loads(path.read_text())
    file = path.parents[1] / case["mesh"]
    vertices, faces = read_mesh(file)
    picks, closed = np.array(case["picks"], float), case.get("closed", False)
    start = time.perf_counter()
    mesh = package.Mesh(vertices, faces)
    prepared = time.perf_counter() - start
    own = mesh._core.seconds
    curve = mesh.curve(picks, closed=closed)
    middle = len(picks) // 2
    there = mesh.project(picks[[middle]] + STEP * mesh.diagonal).points[0]
    row = {"case": path.stem, "faces": len(faces), "prepare": prepared / own}
    with tempfile.TemporaryDirectory() as folder:
        rounds = [
            (program_seconds(program, file, case, Path(folder), count), timed(lambda: mesh.curve(picks, closed=closed), count))
            for _ in range(3)
        ]
        row["program"], row["curve"] = (statistics.median(each) for each in zip(*rounds))
        row["move"], row["move_ratio"] = timed_with_stages(lambda: curve.move(middle, there), count)
        if old:
            arrays = Path(folder) / "case.npz"
            np.savez(arrays, vertices=vertices, faces=faces, picks=picks, closed=closed)
            done = subprocess.run([old, "-c", OLD, arrays, "5"], check=True, capture_output=True, text=True)
            row["draw_curve"] = statistics.median(json.loads(done.stdout))
    return row


def mean(values):
    return statistics.geometric_mean(values)


def table(rows):
    has_old = "draw_curve" in rows[0]
    head = ["case", "faces", "program, ms", "`mesh.curve`, ms", "`curve.move`, ms"] + (["`draw_curve`, ms"] if has_old else [])
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    for row in rows:
        cells = [row["case"], f"{row['faces']:,}"] + [f"{1e3 * row[k]:.2f}" for k in ("program", "curve", "move")]
        lines.append("| " + " | ".join(cells + ([f"{1e3 * row['draw_curve']:.1f}"] if has_old else [])) + " |")
    return "\n".join(lines) + "\n"


def summary(rows):
    lines = [
        f"- `mesh.curve` takes {mean([r['curve'] / r['program'] for r in rows]):.2f} times the program's warm time "
        f"({mean([r['curve'] / (r['program'] + 1e-4) for r in rows]):.2f} times where 0.1 ms are allowed for Python).",
        f"- `curve.move` takes {mean([r['move_ratio'] for r in rows]):.2f} times the core's own stages, and "
        f"{mean([r['move'] / r['curve'] for r in rows]):.2f} times `mesh.curve`.",
        f"- `Mesh(…)` takes {mean([r['prepare'] for r in rows]):.2f} times the core's own stages.",
    ]
    if "draw_curve" in rows[0]:
        lines.append(f"- `draw_curve` takes {mean([r['draw_curve'] / r['curve'] for r in rows]):.1f} times `mesh.curve`.")
    return "Geometric means:\n\n" + "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", type=Path, help="folder of cases")
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "release", help="a build with BSPLINE_CURVE_PYTHON=ON")
    parser.add_argument("--draw-curve", metavar="PYTHON", help="interpreter that has meshlab_bspline_curve")
    parser.add_argument("--repeat", type=int, default=31, help="runs of each, of which the median counts")
    parser.add_argument("--page", action="store_true", help="write the table into docs/PYTHON.md")
    arguments = parser.parse_args()
    sys.path.insert(0, str(arguments.build / "python"))
    import bspline_curve

    paths = sorted(arguments.cases.glob("*.json"))
    if not paths:
        parser.error(f"{arguments.cases} has no cases")
    program = arguments.build / "bin" / "bspline_curve"
    rows = [measure(bspline_curve, program, path, arguments.draw_curve, arguments.repeat) for path in paths]
    text = table(rows) + "\n" + summary(rows)
    print(text)
    if arguments.page:
        page = ROOT / "docs" / "PYTHON.md"
        written = re.sub(re.escape(BEGIN) + ".*?" + re.escape(END), lambda _: BEGIN + text + END, page.read_text(), flags=re.S)
        page.write_text(written)


if __name__ == "__main__":
    main()
