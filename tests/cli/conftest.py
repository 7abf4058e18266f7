# SPDX-License-Identifier: GPL-3.0-or-later
"""The program under test: $BSPLINE_CURVE_PROGRAM, or what `cmake --build --preset release` leaves."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))  # the modules beside this one
import made_meshes as meshes  # noqa: E402


@pytest.fixture(scope="session")
def program():
    built = Path(__file__).resolve().parents[2] / "build" / "release" / "bin" / "bspline_curve"
    path = Path(os.environ.get("BSPLINE_CURVE_PROGRAM", built))
    assert path.is_file(), f"no program at {path}; build it, or set BSPLINE_CURVE_PROGRAM"
    return path


@pytest.fixture
def run(program, tmp_path):
    """Runs the program in a directory of its own; returns the completed process."""

    def call(*arguments, timeout=120):
        words = [str(program), *map(str, arguments)]
        return subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=timeout)

    return call


@pytest.fixture
def refused(run, tmp_path):
    """Runs a command that must fail; checks status, line, what it says and that no file came or changed; returns the line."""

    def call(status, *arguments, says=()):
        before = {p.name: p.is_file() and p.read_bytes() for p in tmp_path.iterdir()}
        process = run(*arguments)
        assert process.returncode == status, process.stderr
        assert process.stdout == ""
        assert process.stderr.count("\n") == 1 and process.stderr.endswith("\n"), process.stderr
        assert process.stderr.startswith("bspline_curve: ")
        assert [part for part in says if part not in process.stderr] == [], process.stderr
        assert {p.name: p.is_file() and p.read_bytes() for p in tmp_path.iterdir()} == before
        return process.stderr

    return call


@pytest.fixture
def plate(tmp_path):
    """A plate in plate.ply and three picks in picks.json."""
    meshes.write_ply(tmp_path / "plate.ply", *meshes.plate())
    (tmp_path / "picks.json").write_text('{"picks": %s}' % meshes.PICKS)
    return tmp_path
