# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m bspline_curve demo [--output demo.png], or the verbs of the program bspline_curve"""

from __future__ import annotations

import argparse
import subprocess
import sys
import sysconfig
from pathlib import Path

from . import InputError, __version__
from ._demo import draw_demo


def run_program(words: list[str]) -> int:
    program = Path(sysconfig.get_path("scripts")) / "bspline_curve"
    if not program.is_file():
        print("bspline-curve: this package was built without the program: only demo is there", file=sys.stderr)
        return 2
    return subprocess.run([program, *words]).returncode


def main() -> int:
    if sys.argv[1:] and sys.argv[1] not in ("demo", "-h", "--help", "--version"):
        return run_program(sys.argv[1:])
    parser = argparse.ArgumentParser(prog="bspline-curve", description="Smooth curves on triangle meshes.")
    parser.add_argument("--version", action="version", version=__version__)
    verbs = parser.add_subparsers(dest="verb", required=True)
    demo = verbs.add_parser("demo", help="draw a curve on a torus, as a picture; all other words go to the program bspline_curve")
    demo.add_argument("--output", type=Path, default=Path("demo.png"), metavar="FILE", help="the picture (demo.png)")
    demo.add_argument("--size", type=int, nargs=2, default=(800, 700), metavar=("WIDTH", "HEIGHT"), help="in pixels (800 700)")
    arguments = parser.parse_args()
    width, height = arguments.size
    if min(width, height) < 16 or max(width, height) > 4000:
        parser.error("--size: width and height must be in [16, 4000]")
    try:
        curve = draw_demo(arguments.output, (width, height))
    except InputError as error:
        print(f"bspline-curve: {error}", file=sys.stderr)
        return 1
    print(f"{arguments.output}: a curve of {len(curve.points)} points, {curve.length:.3f} long")
    return 0


if __name__ == "__main__":
    sys.exit(main())
