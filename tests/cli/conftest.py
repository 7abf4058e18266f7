# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program in folders of their own."""

import subprocess

import made_meshes as meshes
import pytest


@pytest.fixture
def run(program, tmp_path):
    """Runs the program in a directory of its own; returns the completed process. run.ok: it must do its work."""

    def call(*arguments, timeout=120):
        words = [str(program), *map(str, arguments)]
        return subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=timeout)

    def ok(*arguments):
        process = call(*arguments)
        assert process.returncode == 0, process.stderr
        return process

    call.ok = ok
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
