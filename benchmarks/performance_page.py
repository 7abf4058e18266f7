#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the benchmarks and writes their tables and plots into docs/PERFORMANCE.md.

    benchmarks/performance_page.py            runs all, a few minutes on an idle machine
    benchmarks/performance_page.py --keep     takes the results that are in --results, and runs what is missing
    benchmarks/performance_page.py --quick    small meshes, one round: to see that it works

Needs requirements.txt, and the program built as the preset release does. Instructions are those that count_instructions.py keeps.
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

import matplotlib
from cases import PROGRAM, ROOT, geometric_mean, replace_table

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator  # noqa: E402

HERE = Path(__file__).resolve().parent
SCRIPTS = ("peers", "scaling", "table1", "polyline_method")
FIELD_NAMES = {"none": "no field", "waves": "waves", "maximal-curvature": "maximal curvature"}
OURS, MESHLIB, GEODESIC = "#c33b22", "#3d6ea8", "#7a9a4f"
MILLION = 1_000_000
RATIO_TICKS = (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20)


# ---------------------------------------------------------------- results
def results_of(name, given):
    """What a script measured; it runs where there is nothing to keep."""
    file = given.results / f"{name}.json"
    if not (given.keep and file.is_file()):
        given.results.mkdir(parents=True, exist_ok=True)
        print(f"-- {name}", flush=True)
        words = [sys.executable, HERE / f"{name}.py", "--program", given.program, "--json", file]
        done = subprocess.run(list(map(str, words + (["--quick"] if given.quick else []))))
        if not file.is_file():
            sys.exit(f"performance_page.py: {name}.py left no results (exit status {done.returncode})")
    return json.loads(file.read_text())


# ---------------------------------------------------------------- tables
def table(head, rows):
    """The first column is text, the others are numbers."""
    rules = ["---"] + ["--:"] * (len(head) - 1)
    return "\n".join("| " + " | ".join(map(str, row)) + " |" for row in (head, rules, *rows))


def milliseconds(seconds):
    return f"{1e3 * seconds:.1f}" if seconds < 0.1 else f"{1e3 * seconds:,.0f}"


def machine_text(results):
    machines = [result["machine"] for result in results.values()]
    names = " / ".join(sorted({machine["processor"] for machine in machines}))
    load = max(machine["load"] for machine in machines)
    cores = machines[0]["cores"]
    state = "idle otherwise" if load <= 1.5 else "busy with other work as well: times are rough"
    return f"Times below: {names}, {cores} cores, load average {load:.1f} at the end of a script ({state})."


def peers_table(peers):
    rows = []
    for row in peers["rows"]:
        if "reason" in row:
            rows.append([row["case"], f"{row['vertices']:,}", row["reason"].replace("|", "/"), *[""] * 5])
            continue
        times = [milliseconds(row[who][state]) for state in ("warm", "cold") for who in ("ours", "meshlib", "geodesic")]
        rows.append([row["case"], f"{row['vertices']:,}", *times])
    head = ["mesh, picks", "vertices", "warm, ms: ours", "MeshLib", "geodesic", "cold, ms: ours", "MeshLib", "geodesic"]
    return table(head, rows)


def named_growth(grown, state):
    factors = [by_state[state]["worst"] for kind, by_state in grown.items() if kind != "maximal-curvature" and by_state[state]]
    return max(factors)


def targets_table(peers, scaling, counts):
    """What was asked of the project and what was measured."""
    ratios = peers["ratios"]
    largest = [row for row in scaling["rows"] if row["faces"] == max(row["faces"] for row in scaling["rows"])]
    plain = next(row for row in largest if row["field"] == "none")
    moved, fresh = (counts["paths"][name]["instructions"] for name in ("design_moved", "design_warm"))
    entries = [
        ("warm / MeshLib, geometric mean", geometric_mean(ratios["warm, ours / meshlib"]), 1.0),
        ("warm / MeshLib, worst", max(ratios["warm, ours / meshlib"]), 2.5),
        ("a pick moved by two edges / from the beginning, instructions", moved / fresh, 0.5),
        ("cold / geodesic, geometric mean", geometric_mean(ratios["cold, ours / geodesic"]), 0.5),
        ("cold / geodesic, worst", max(ratios["cold, ours / geodesic"]), 1.0),
        ("cold / MeshLib, worst", max(ratios["cold, ours / meshlib"]), 3.0),
        ("warm, growth per four times the faces, largest", named_growth(scaling["growth"], "warm"), 1.3),
        ("cold, growth per four times the faces, largest", named_growth(scaling["growth"], "cold"), 4.2),
        (f"cold at {plain['faces']:,} faces, s", plain["cold"], 5.0),
        ("peak memory there, GB", plain["peak_bytes"] / 1e9, 1.5),
        ("bytes per face above the arrays there", plain["bytes_per_face"], 300.0),
    ]
    return table(["", "at most", "measured", "met"], [[label, f"{most:g}", f"{value:.0f}" if value >= 100 else f"{value:.2f}",
                                                       "yes" if value <= most else "**no**"] for label, value, most in entries])


def instructions_table(counts):
    rows = [[name.replace("_", " "), f"{row['instructions'] / MILLION:.2f}", f"{row['items']:,} × {row['item']}",
             f"{row['instructions'] / row['items']:,.0f}"] for name, row in counts["paths"].items()]
    return table(["path", "millions", "in one run", "each"], rows)


def shares_table(counts):
    columns = [counts["paths"][name] for name in ("design_warm_by_cells", "design_warm")]
    lists = [[f"`{function}` {100 * share:.0f} %" for function, share in column["own"].items()] for column in columns]
    head = [f"{label}: {column['instructions'] / MILLION:.0f} million"
            for label, column in zip(("before, cell by cell", "now, by foot points"), columns)]
    parts = [f"{label} {100 * counts['paths'][name]['instructions'] / columns[1]['instructions']:.0f} %"
             for label, name in (("the first path", "first_path"),
                                 ("a trace of the whole curve", "trace"), ("a Newton step", "newton_step"))]
    lines = [f"Of a curve by foot points now: {', '.join(parts[:-1])}, {parts[-1]} (several of the last\n"
             "two in each curve).", "",
             "| " + " | ".join(head) + " |", "|---|---|"]
    lines += [f"| {before} | {now} |" for before, now in zip(*lists)]
    return "\n".join(lines)


def stages_table(scaling):
    rows = []
    for row in scaling["rows"]:
        if row["field"] == "waves":
            continue
        stages = row["stages"]
        rows.append([f"{row['faces']:,}, {FIELD_NAMES[row['field']]}", *(milliseconds(stages[key]) for key in stages),
                     milliseconds(row["cold"])])
    return table(["faces", "validate, ms", "tree and patches", "wait for the extended surface", "field", "first curve", "cold"], rows)


def scaling_table(scaling):
    rows = [[f"{row['faces']:,}, {FIELD_NAMES[row['field']]}", milliseconds(row["warm"]), milliseconds(row["cold"]),
             f"{row['peak_bytes'] / 1e6:,.0f}", f"{row['bytes_per_face']:,.0f}"] for row in scaling["rows"]]
    for kind, by_state in scaling["growth"].items():
        factors = [by_state[state] for state in ("warm", "cold")]
        if all(factors):
            rows.append([f"growth per four times, {FIELD_NAMES[kind]}",
                         *(f"{factor['mean']:.2f} (worst {factor['worst']:.2f})" for factor in factors), "", ""])
    return table(["faces", "warm, ms", "cold, ms", "peak memory, MB", "bytes per face"], rows)


def table1_table(table1):
    rows = []
    for row in table1["rows"]:
        paper = f"{row['paper_seconds']:.3f}"
        if "reason" in row:
            rows.append([row["name"], f"{row['vertices']:,}", row["picks"], paper, row["reason"].replace("|", "/"), "", "", ""])
            continue
        knots = "" if row["paper_knots"] is None else " → ".join(map(str, row["paper_knots"]))
        rows.append([row["name"], f"{row['vertices']:,}", row["picks"], paper, f"{row['cold']:.3f}", f"{row['warm']:.4f}",
                     knots, " → ".join(map(str, row["knots"]))])
    return table(["row", "vertices", "picks", "paper, s", "cold, s", "warm, s", "knots, paper", "ours"], rows)


def polylines_table(polylines):
    rows = [[f"{row['samples']:,}", f"{1e3 * row['spline']['seconds']:.1f}", f"{1e3 * row['polyline']['seconds']:.1f}",
             row["spline"]["steps"], row["polyline"]["steps"], f"{row['spline']['internal'] / row['polyline']['internal']:.2f}"]
            for row in polylines["rows"]]
    return table(["samples", "spline, ms", "polyline, ms", "Newton steps: spline", "polyline", "energy, spline / polyline"], rows)


# ---------------------------------------------------------------- plots
def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=80, metadata={"Software": None})
    pyplot.close(figure)


def plot_peers(peers, path):
    rows = [row for row in peers["rows"] if "reason" not in row]
    figure, axes = pyplot.subplots(1, 2, figsize=(10, 0.9 + 0.32 * len(rows)), sharey=True)
    for axis, state in zip(axes, ("warm", "cold")):
        for offset, who, colour in ((-0.2, "meshlib", MESHLIB), (0.2, "geodesic", GEODESIC)):
            ratios = [row["ours"][state] / row[who][state] for row in rows]
            label = {"meshlib": "MeshLib's projected spline", "geodesic": "flip geodesics"}[who]
            bars = [index + offset for index in range(len(rows))]
            axis.barh(bars, [ratio - 1 for ratio in ratios], 0.38, left=1, color=colour, label=label)
            axis.axvline(geometric_mean(ratios), color=colour, linestyle=":", linewidth=1.5)
        axis.axvline(1, color="black", linewidth=0.8)
        axis.set_xscale("log")
        axis.xaxis.set_major_locator(FixedLocator(RATIO_TICKS))
        axis.xaxis.set_minor_locator(NullLocator())
        axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.grid(alpha=0.3, axis="x")
        axis.set_title(f"{state}: our time / theirs (left of 1: ours is quicker)", fontsize=10)
    axes[0].set_yticks(range(len(rows)), [row["case"] for row in rows], fontsize=8)
    axes[0].invert_yaxis()
    axes[1].legend(fontsize=8, loc="lower right")
    save(figure, path)


def plot_scaling(scaling, path):
    figure, axes = pyplot.subplots(1, 2, figsize=(10, 4))
    for kind, marker in (("none", "o"), ("waves", "s"), ("maximal-curvature", "^")):
        rows = [row for row in scaling["rows"] if row["field"] == kind]
        faces = [row["faces"] for row in rows]
        axes[0].loglog(faces, [row["cold"] for row in rows], marker=marker, color=MESHLIB, label=f"cold, {FIELD_NAMES[kind]}")
        axes[0].loglog(faces, [row["warm"] for row in rows], marker=marker, color=OURS, label=f"warm, {FIELD_NAMES[kind]}")
        axes[1].semilogx(faces, [row["bytes_per_face"] for row in rows], marker=marker, label=FIELD_NAMES[kind])
    axes[0].set(xlabel="faces", title="seconds")
    axes[1].axhline(300, color="black", linewidth=0.8, linestyle=":")
    axes[1].set(xlabel="faces", title="bytes per face above the arrays, at most", ylim=(0, None))
    for axis in axes:
        axis.title.set_fontsize(10)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    save(figure, path)


def plot_polylines(polylines, path):
    rows = polylines["rows"]
    samples = [row["samples"] for row in rows]
    figure, axis = pyplot.subplots(figsize=(6, 3.2))
    for kind, marker, colour, label in (("spline", "o", OURS, "B-spline, then sampled"),
                                        ("polyline", "s", MESHLIB, "polyline, optimised itself")):
        axis.plot(samples, [1e3 * row[kind]["seconds"] for row in rows], marker=marker, color=colour, label=label)
    axis.set(xlabel="points on the curve", ylabel="warm, ms", ylim=(0, None))
    axis.grid(alpha=0.3)
    axis.legend(fontsize=8)
    save(figure, path)


def plot_instructions(counts, path):
    """What a warm curve takes, by the paths that it is made of."""
    paths = counts["paths"]
    bars = [("before, cell by cell", paths["design_warm_by_cells"]["instructions"]),
            ("now, by foot points", paths["design_warm"]["instructions"]),
            ("likewise, after a pick moved by two edges", paths["design_moved"]["instructions"]),
            ("first path", paths["first_path"]["instructions"]),
            ("one trace of the curve", paths["trace"]["instructions"]), ("one Newton step", paths["newton_step"]["instructions"])]
    figure, axis = pyplot.subplots(figsize=(8, 2.7))
    axis.barh([label for label, _ in bars], [value / MILLION for _, value in bars], color=[MESHLIB, OURS, OURS] + 3 * ["#e09a8a"])
    axis.bar_label(axis.containers[0], fmt=" %.1f", fontsize=8)
    axis.invert_yaxis()
    axis.set_xlabel("million instructions")
    axis.margins(x=0.08)
    save(figure, path)


# ---------------------------------------------------------------- the page
def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--results", type=Path, default=ROOT / "build" / "benchmarks", help="folder of the scripts' results")
    parser.add_argument("--keep", action="store_true", help="run only what has no results there")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--page", type=Path, default=ROOT / "docs" / "PERFORMANCE.md")
    given = parser.parse_args()
    results = {name: results_of(name, given) for name in SCRIPTS}
    peers, scaling, table1, polylines = (results[name] for name in SCRIPTS)
    counts = json.loads((HERE / "instructions.json").read_text())
    images = given.page.parent / "images"
    images.mkdir(exist_ok=True)
    plot_peers(peers, images / "performance_peers.png")
    plot_scaling(scaling, images / "performance_scaling.png")
    plot_polylines(polylines, images / "performance_polylines.png")
    plot_instructions(counts, images / "performance_instructions.png")
    build = counts["build"]
    replace_table(given.page, "machine", machine_text(results) + f"\nInstructions: {build['compiler']}, `{build['flags']}`.")
    replace_table(given.page, "targets", targets_table(peers, scaling, counts))
    replace_table(given.page, "peers", peers_table(peers))
    replace_table(given.page, "shares", shares_table(counts))
    replace_table(given.page, "instructions", instructions_table(counts))
    replace_table(given.page, "stages", stages_table(scaling))
    replace_table(given.page, "scaling", scaling_table(scaling))
    replace_table(given.page, "table1", table1_table(table1))
    replace_table(given.page, "polylines", polylines_table(polylines))
    return 0


if __name__ == "__main__":
    sys.exit(main())
