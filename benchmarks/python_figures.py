#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what docs/PYTHON.md promises of the package bspline_curve, against its bounds, and writes the table there.

    benchmarks/python_figures.py                 # import, threads, memory
    benchmarks/python_figures.py --cases CASES   # and latencies, see python_latency.py
    benchmarks/python_figures.py --cases CASES --page   # writes the table into docs/PYTHON.md, too

On a busy machine the best of several imports counts, and medians of all else.
"""

import argparse
import math
import re
import statistics
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import python_latency

ROOT = Path(__file__).resolve().parents[1]
BEGIN, END = "<!-- table of benchmarks/python_figures.py -->\n", "<!-- end of figures -->\n"
IMPORT = "import time; start = time.perf_counter(); import bspline_curve; print(time.perf_counter() - start)"


def wavy_square(n):
    x, y = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n), indexing="ij")
    vertices = np.stack([x, y, 0.2 * np.sin(3 * x) * np.cos(2 * y)], axis=-1).reshape(-1, 3)
    corner = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).reshape(-1, 1)
    return vertices, np.concatenate([corner + [0, n, n + 1], corner + [0, n + 1, 1]]).astype(np.int32)


def import_seconds(folder, count=9):
    """The least time of an import in a process of its own, numpy included."""
    run = [sys.executable, "-c", IMPORT]
    return min(float(subprocess.run(run, check=True, capture_output=True, text=True, env={"PYTHONPATH": folder}).stdout)
               for _ in range(count))


def four_picks(package):
    """A mesh, and four picks on it."""
    arrays = wavy_square(61)
    return package.Mesh(*arrays), arrays[0][[130, 900, 2000, 3500]]


def draw_many(mesh, picks):
    for _ in range(100):
        mesh.curve(picks)


def ratio_of_two(seconds, count=41):
    """Median over pairs of runs: the seconds of two workers at once over those of one. The least of each would not do: where
    the machine does nothing else, one alone now and then runs faster than two ever do, also in processes that share nothing."""
    return statistics.median(seconds(2) / seconds(1) for _ in range(count))


def threads_ratio(package):
    """Of threads, each on a mesh of its own."""
    both = [four_picks(package) for _ in range(2)]

    def seconds(workers):
        start = time.perf_counter()
        threads = [threading.Thread(target=draw_many, args=one) for one in both[:workers]]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return time.perf_counter() - start

    return ratio_of_two(seconds)


WORKER = """
import sys, time, bspline_curve, python_figures
mesh, picks = python_figures.four_picks(bspline_curve)
for line in sys.stdin:
    start = time.perf_counter()
    python_figures.draw_many(mesh, picks)
    print(time.perf_counter() - start, flush=True)
"""


def processes_ratio(folder):
    """Of processes that share nothing: what the processors give."""
    path = {"PYTHONPATH": f"{folder}:{ROOT / 'benchmarks'}"}
    run = [sys.executable, "-c", WORKER]
    workers = [subprocess.Popen(run, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=path) for _ in range(2)]

    def seconds(count):
        for worker in workers[:count]:
            worker.stdin.write("draw\n")
            worker.stdin.flush()
        return max(float(worker.stdout.readline()) for worker in workers[:count])

    seconds(2)  # both are there
    ratio = ratio_of_two(seconds)
    for worker in workers:
        worker.communicate()
    return ratio


def resident():
    """Bytes of this process in memory."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096


def growth(package, first, last):
    """By how many bytes the process grew between the curves of these numbers."""
    arrays = wavy_square(21)
    mesh, picks = package.Mesh(*arrays), arrays[0][[25, 200, 400]]
    for i in range(last):
        if i == first:
            before = resident()
        curve = mesh.curve(picks)
        assert len(curve.points) == len(curve.barycentrics)
    return resident() - before


def figures(package, folder, cases, count, curves):
    """(what, measured, at most, unit) each."""
    yield "`import bspline_curve`, numpy included", import_seconds(folder), 0.15, "s"
    yield "two threads on two meshes, relative to one on one", threads_ratio(package), 1.2, ""
    yield "two processes, relative to one (nothing shared but the processors)", processes_ratio(folder), math.inf, ""
    yield f"memory after {curves:,} curves, relative to after 1,000", growth(package, 1000, curves) / 1e6, 5.0, "MB"
    if cases:
        program = Path(folder).parent / "bin" / "bspline_curve"
        rows = [python_latency.measure(package, program, path, None, count) for path in sorted(cases.glob("*.json"))]
        mean = statistics.geometric_mean
        yield ("`mesh.curve`, relative to the program's warm time + 0.087 ms (= 1.15 × program + 0.1 ms)",
               mean([r["curve"] / (r["program"] + 1e-4 / 1.15) for r in rows]), 1.15, "")
        yield "`curve.move`, relative to the core's stages", mean([r["move_ratio"] for r in rows]), 1.15, ""
        yield "`Mesh(…)`, relative to the core's stages", mean([r["prepare"] for r in rows]), 1.1, ""


def table(rows):
    lines = ["| figure | measured | at most |", "|---|---|---|"]
    for what, value, most, unit in rows:
        unit = f" {unit}" if unit else ""
        bound = f"{most:g}{unit}" if most < math.inf else ""
        lines.append(f"| {what} | {value:.2f}{unit} | {bound} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "release", help="a build with BSPLINE_CURVE_PYTHON=ON")
    parser.add_argument("--cases", type=Path, help="folder of cases of python_latency.py")
    parser.add_argument("--repeat", type=int, default=31, help="runs of each latency, of which the median counts")
    parser.add_argument("--curves", type=int, default=100_000, help="how many are drawn for the memory")
    parser.add_argument("--page", action="store_true", help="write the table into docs/PYTHON.md")
    arguments = parser.parse_args()
    folder = str(arguments.build.resolve() / "python")
    sys.path.insert(0, folder)
    import bspline_curve

    rows = list(figures(bspline_curve, folder, arguments.cases, arguments.repeat, arguments.curves))
    text = table(rows)
    print(text)
    if arguments.page:
        page = ROOT / "docs" / "PYTHON.md"
        page.write_text(re.sub(re.escape(BEGIN) + ".*?" + re.escape(END), lambda _: BEGIN + text + END, page.read_text(), flags=re.S))
    return sum(value > most for _, value, most, _ in rows)


if __name__ == "__main__":
    sys.exit(main())
