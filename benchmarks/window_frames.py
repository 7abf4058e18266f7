#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures frames per second in the window of MeshLab 2020.09 while a pick of the drawing tool is dragged.

    .cache/venv/bin/python benchmarks/window_frames.py [--mesh FILE] [--seconds 4]

Xvfb, rendering in software. The mesh is the bunny of pymeshlab's wheel if none is given. Needs the build with
-DBSPLINE_CURVE_LEGACY=ON and the packages of scripts/test. Frames are counted where the program hands them to the
display (benchmarks/swap_times.c).
"""
import argparse
import json
import math
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "hosts"))
from float_ply import bunny_ply  # noqa: E402
from meshlab_window import MeshLabWindow  # noqa: E402
from virtual_display import VirtualDisplay  # noqa: E402

TOOL = "Draw B-spline Curves"
# In pixels from the middle of the view; the pick in the middle is dragged.
CLICKS = [(-135, 60), (-60, 130), (30, 75), (105, 120), (60, -5)]
DRAGGED = 2
RADIUS = 30  # of the circle that the mouse goes round, in pixels
EVENTS_PER_SECOND = 125


def compile_counter(folder):
    library = folder / "swap_times.so"
    subprocess.run(["cc", "-O2", "-shared", "-fPIC", ROOT / "benchmarks" / "swap_times.c", "-o", library, "-ldl"], check=True)
    return library


def drag(display, start, seconds):
    """Round a circle that begins at `start`; when it began and ended."""
    words = ["mousemove", *map(str, start), "mousedown", "1"]
    for i in range(int(seconds * EVENTS_PER_SECOND)):
        angle = 2 * math.pi * i / EVENTS_PER_SECOND
        place = start[0] + RADIUS * math.sin(angle), start[1] + RADIUS * (1 - math.cos(angle))
        words += ["mousemove", *(str(round(x)) for x in place), "sleep", str(1 / EVENTS_PER_SECOND)]
    begin = time.monotonic()
    display.xdotool(*words)
    end = time.monotonic()
    display.xdotool("mouseup", "1")
    return begin, end


def measure(mesh, seconds):
    with tempfile.TemporaryDirectory() as temporary, VirtualDisplay() as display:
        folder = Path(temporary)
        times = folder / "times"
        prefix = subprocess.run(
            [ROOT / "scripts" / "meshlab_2020_prefix", folder / "meshlab"], check=True, capture_output=True, text=True
        ).stdout.strip()
        program = Path(prefix) / "bin" / "meshlab"
        preload = {"LD_PRELOAD": str(compile_counter(folder)), "SWAP_TIMES": str(times)}
        with MeshLabWindow(display, program, mesh or bunny_ply(folder), **preload) as meshlab:
            meshlab.start_action(TOOL)
            meshlab.wait_for_window("^B-spline Curves$")
            meshlab.wait_for_still_picture()
            view = meshlab.view()
            places = [(view.x + view.width // 2 + x, view.y + view.height // 2 + y) for x, y in CLICKS]
            for place in places:
                meshlab.click(*place)
                meshlab.wait_for_still_picture()
            begin, end = drag(display, places[DRAGGED], seconds)
            shown = [float(line) for line in times.read_text().split()]
    frames = [t for t in shown if begin <= t <= end]
    gaps = sorted(b - a for a, b in zip(frames, frames[1:]))
    return {
        "frames_per_second": len(frames) / (end - begin),
        "median_gap_ms": 1e3 * gaps[len(gaps) // 2],
        "p95_gap_ms": 1e3 * gaps[int(0.95 * len(gaps))],
        "worst_gap_ms": 1e3 * gaps[-1],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mesh", type=Path, help="the mesh, a file that MeshLab reads")
    parser.add_argument("--seconds", type=float, default=4.0, help="how long the pick is dragged")
    arguments = parser.parse_args()
    print(json.dumps(measure(arguments.mesh, arguments.seconds), indent=1))


if __name__ == "__main__":
    main()
