# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs that the benchmarks run: those of the build in $BSPLINE_CURVE_BUILD, or of the preset release."""
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(os.environ.get("BSPLINE_CURVE_BUILD", ROOT / "build" / "release")) / "bin"
sys.path.insert(0, str(ROOT / "benchmarks"))


@pytest.fixture(scope="session")
def bench_program():
    program = PROGRAMS / "bspline_curve"
    assert program.is_file(), f"no program at {program}; build it, or set BSPLINE_CURVE_BUILD"
    return program


@pytest.fixture(scope="session")
def hot_paths():
    program = PROGRAMS / "hot_paths"
    if not program.is_file():
        pytest.skip("hot_paths is not built (-DBSPLINE_CURVE_BENCHMARKS=ON)")
    if shutil.which("valgrind") is None:
        pytest.skip("valgrind is not installed")
    return program


@pytest.fixture
def script():
    """Runs a script of benchmarks/; returns the completed process."""

    def call(name, *words, timeout=300):
        command = [sys.executable, ROOT / "benchmarks" / name, *words]
        return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=timeout)

    return call
