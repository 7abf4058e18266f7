#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How soon the program ends after Ctrl-C, whatever it is doing.

    benchmarks/cancel_latency.py [--vertices 450000] [--times 20] [--only NAME...] [--json FILE]

Each run is interrupted at another moment, spread evenly over what the whole run takes. The latency is from the signal to the end
of the process, with all of its memory given back. A run must end with 130 and leave no file. Needs requirements.txt.
"""
import argparse
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from cases import PROGRAM, farthest_picks, machine, torus_of, write_json, write_ply

ASKED = 0.2  # seconds
RUNS = {
    "curve": [],
    "curve, whole shell": ["--shell", "full"],
    "curve, simplified shell": ["--shell", "simplified", "--no-cache"],
    "curve, preset paper": ["--preset", "paper", "--no-cache"],
    "curve, field valley": ["--field", "valley"],
    "curve, field obstacle": ["--field", "obstacle", "--field-region", "avoid.txt"],
    "curve, avoid": ["--avoid", "avoid.txt", "--avoid-margin", "0.2"],
    "field": ["field"],
    "shell": ["shell"],
    "imprint": ["imprint"],
    "cut": ["cut"],
    "cut, filled": ["cut", "fill"],
    "segment": ["segment"],
    "offset": ["offset"],
}


def words_of(name, options):
    """The command line of a run."""
    verb = options[0] if options and not options[0].startswith("-") else "curve"
    if verb == "curve":
        return ["mesh.ply", "--picks", "picks.json", "--closed", "--output", "out.json", *options]
    if verb == "field":
        return ["field", "mesh.ply", "--kind", "ridge", "--output", "out.npy"]
    if verb == "shell":
        return ["shell", "mesh.ply", "--output", "out.ply", "--no-cache"]
    words = [verb, "mesh.ply", "--curve", "curve.json", "--output", "out.ply"]
    return words + {"cut": ["--keep", "largest"] + (["--fill", "smooth"] if "fill" in options else []),
                    "offset": ["--distance", "0.05"], "segment": [], "imprint": []}[verb]


def started(program, words, folder):
    return subprocess.Popen([str(program), *words], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def whole_time(program, words, folder, kept):
    start = time.monotonic()
    process = started(program, words, folder)
    said = process.communicate()[1]
    if process.returncode != 0:
        raise RuntimeError(f"{' '.join(words)}: {said}")
    seconds = time.monotonic() - start
    for file in set(folder.iterdir()) - kept:
        file.unlink()
    return seconds


def latency(program, words, folder, kept, moment):
    """Seconds from the signal to the end; none where the run had ended before."""
    process = started(program, words, folder)
    try:
        process.wait(moment)
        return None
    except subprocess.TimeoutExpired:
        pass
    sent = time.monotonic()
    process.send_signal(signal.SIGINT)
    said = process.communicate()[1]
    seconds = time.monotonic() - sent
    left = set(folder.iterdir()) - kept
    for file in left:
        file.unlink()
    if process.returncode == 130 and left:
        raise RuntimeError(f"{' '.join(words)}: interrupted, it left {left}: {said}")
    return seconds if process.returncode == 130 else None


def loop_around(vertices, centre):
    """Six vertices around a vertex: a closed curve through them parts the surface, as not every one on a torus does."""
    size = 0.1 * np.linalg.norm(np.ptp(vertices, axis=0))
    near = vertices[np.linalg.norm(vertices - centre, axis=1) < 1.2 * size]
    normal = np.linalg.svd(near - centre, full_matrices=False)[2][2]
    x = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    x *= size / np.linalg.norm(x)
    y = np.cross(normal, x)
    angles = 2 * np.pi * np.arange(6) / 6
    wanted = centre + np.outer(np.cos(angles), x) + np.outer(np.sin(angles), y)
    return near[np.linalg.norm(near[None] - wanted[:, None], axis=2).argmin(axis=1)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--vertices", type=int, default=450_000)
    parser.add_argument("--times", type=int, default=20)
    parser.add_argument("--only", nargs="+", choices=RUNS, default=list(RUNS))
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    vertices, faces = torus_of(arguments.vertices)
    rows = []
    with tempfile.TemporaryDirectory() as text:
        folder = Path(text)
        write_ply(folder / "mesh.ply", vertices, faces)
        picks = farthest_picks(vertices, faces, 6, 1)
        write_json(folder / "picks.json", {"picks": picks.tolist()})
        (folder / "avoid.txt").write_text(" ".join(map(str, range(len(faces) // 3, len(faces) // 3 + 200))))
        write_json(folder / "loop.json", {"picks": loop_around(vertices, picks[0]).tolist()})
        subprocess.run([str(arguments.program), "mesh.ply", "--picks", "loop.json", "--closed", "--output", "curve.json"],
                       cwd=folder, check=True, stdout=subprocess.DEVNULL)
        kept = set(folder.iterdir())
        for name in arguments.only:
            words = words_of(name, RUNS[name])
            whole = whole_time(arguments.program, words, folder, kept)
            found = {}
            for k in range(arguments.times):
                moment = whole * (k + 0.5) / arguments.times
                seconds = latency(arguments.program, words, folder, kept, moment)
                if seconds is not None:
                    found[moment / whole] = seconds
            worst = max(found, key=found.get)
            rows.append({"run": name, "seconds": whole, "interrupted": len(found), "worst": found[worst], "at": worst})
            print(f"{name:25s} {whole:7.2f} s whole, {len(found):3d} times interrupted, worst latency {found[worst]:.3f} s "
                  f"at {100 * worst:.0f} %", flush=True)
    if arguments.json:
        write_json(arguments.json, {"machine": machine(), "faces": len(faces), "asked": ASKED, "rows": rows})
    return 0 if all(row["worst"] <= ASKED for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
