#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the instructions of each hot path under callgrind, and compares them with those kept in instructions.json.

    benchmarks/count_instructions.py            counts, and keeps the counts
    benchmarks/count_instructions.py --check    compares: exit status 1 where a path takes more or less than TOLERANCE
    benchmarks/count_instructions.py --names trace newton_step …

Unlike times they do not depend on what else a machine does. They do depend on compiler, flags and processor family, so
counts of another build are not compared; the script says so and fails nothing. Needs valgrind and the program hot_paths
(-DBSPLINE_CURVE_BENCHMARKS=ON).
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
KEPT = Path(__file__).with_name("instructions.json")
TOLERANCE = 0.05  # of a count; runs of one build differ by less than 0.005
LEFT_OUT = ("design_cold",)  # takes two threads, of which one would be counted; its stages are paths of their own
FUNCTIONS = 12  # that are kept of a path, those with most instructions of their own
LEAST_SHARE = 0.01  # of a path's instructions, likewise


def lines_of(program, option):
    done = subprocess.run([program, option], capture_output=True, text=True, check=True)
    return [line.split("\t") for line in done.stdout.splitlines()]


def build_of(program):
    """What counts depend on."""
    return {key: value for key, value in lines_of(program, "--about")}


def short_name(function):
    """A C++ function without arguments, template arguments and the project's namespaces."""
    name = function.replace("(anonymous namespace)::", "").replace("operator()", "call")
    name = re.sub(r"bspline_curve::(benchmarks::)?|\[clone [^]]*\]|'\d+", "", name)
    name = re.sub(r"operator (new|delete)", r"operator_\1", name)
    while re.search(r"<[^<>]*>|\([^()]*\)|\{[^{}]*\}", name):
        name = re.sub(r"<[^<>]*>|\([^()]*\)|\{[^{}]*\}", "", name)
    words = re.sub(r" const\b|&", "", name).split()  # the last one is the name, those before what it returns
    return re.sub("(::)+", "::", words[-1]).replace("operator_", "operator ").strip(":") if words else function


def own_instructions(dump):
    """Instructions by function, those of functions that it calls left out, of a file of callgrind's."""
    names, counts = {}, {}
    function, called = None, False
    for line in dump.read_text().splitlines():
        if match := re.match(r"(c?)fn=\((\d+)\)(?: (.*))?", line):
            if match[3]:
                names[match[2]] = match[3]
            if not match[1]:
                function = match[2]
        elif line.startswith("calls="):
            called = True  # the next line holds what the call took
        elif re.match(r"[+\-*\d]", line):
            if not called:
                counts[function] = counts.get(function, 0) + int(line.split()[1])
            called = False
    merged = {}
    for function, count in counts.items():
        name = short_name(names[function])
        merged[name] = merged.get(name, 0) + count
    return merged


def count(program, name):
    """The instructions of one run of a path, and its functions with most of them."""
    with tempfile.TemporaryDirectory() as folder:
        dump = Path(folder) / "callgrind"
        words = ["valgrind", "--tool=callgrind", "--toggle-collect=runMeasured", f"--callgrind-out-file={dump}", program, name]
        done = subprocess.run(list(map(str, words)), capture_output=True, text=True,
                              env={**os.environ, "LD_BIND_NOW": "1"})  # looking up functions is not counted
        if done.returncode != 0:
            raise RuntimeError(f"{name}: {done.stderr.strip()[-500:]}")
        functions = own_instructions(dump)
    total = sum(functions.values())
    most = sorted(functions.items(), key=lambda entry: -entry[1])[:FUNCTIONS]
    return total, {function: round(own / total, 3) for function, own in most if own > LEAST_SHARE * total}


def count_all(program, names, jobs):
    """A row per path, and all that the counts depend on."""
    rows = {}
    listed = {name: (int(items), item) for name, items, item in lines_of(program, "--list") if name not in LEFT_OUT}
    unknown = sorted(set(names) - set(listed))
    if unknown:
        raise RuntimeError(f"hot_paths knows no {', '.join(unknown)}")
    with ThreadPoolExecutor(jobs) as pool:
        wanted = names or list(listed)
        for name, (total, functions) in zip(wanted, pool.map(lambda name: count(program, name), wanted)):
            items, item = listed[name]
            rows[name] = {"instructions": total, "items": items, "item": item, "own": functions}
            print(f"{name:20} {total:14,}   {total / items:12,.0f} per {item}", flush=True)
    return {"build": build_of(program), "paths": rows}


def compare(kept, now):
    """A line for each path that is not as it was; nothing where the counts cannot be compared."""
    lines = []
    for name, row in now["paths"].items():
        if name not in kept["paths"]:
            lines.append(f"{name}: not in {KEPT.name}")
            continue
        before = kept["paths"][name]["instructions"]
        change = row["instructions"] / before - 1
        if abs(change) > TOLERANCE:
            lines.append(f"{name}: {before:,} instructions before, {row['instructions']:,} now ({change:+.1%})")
    return lines


def check(program, kept, names, jobs):
    build = build_of(program)
    if build != kept["build"]:
        differs = ", ".join(f"{key} {value} (kept: {kept['build'].get(key)})"
                            for key, value in build.items() if value != kept["build"].get(key))
        print(f"not compared, since the build is another one: {differs}")
        return 0
    lines = compare(kept, count_all(program, names, jobs))
    if lines:
        print(f"Instructions changed by more than {TOLERANCE:.0%}:", *lines, sep="\n  ")
        print("Where that is meant, run benchmarks/count_instructions.py and commit benchmarks/instructions.json.")
    return 1 if lines else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bin/hot_paths")
    parser.add_argument("--kept", type=Path, default=KEPT, help="the file of counts")
    parser.add_argument("--names", nargs="+", default=[], help="these paths alone")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--check", action="store_true", help="compare, and keep nothing")
    given = parser.parse_args()
    if given.check:
        return check(given.program, json.loads(given.kept.read_text()), given.names, given.jobs)
    results = count_all(given.program, given.names, given.jobs)
    if given.names and given.kept.is_file():
        before = json.loads(given.kept.read_text())
        if before["build"] == results["build"]:
            results["paths"] = before["paths"] | results["paths"]
    given.kept.write_text(json.dumps(results, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
