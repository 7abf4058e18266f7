# SPDX-License-Identifier: GPL-3.0-or-later
"""examples/batch: its jobs on a Dask cluster of two workers, with the results of the program's own batch."""

import csv
import shutil
import subprocess
import sys
from pathlib import Path

import pymeshlab
import pytest
from dask.distributed import Client, LocalCluster, get_task_stream

pytestmark = pytest.mark.slow
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
MEASURED = ("seconds", "peak_memory_bytes")


@pytest.fixture(scope="module")
def cluster():
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        yield cluster


@pytest.fixture
def example(tmp_path):
    """A copy of the example with its mesh, and two more jobs that fail."""
    shutil.copytree(EXAMPLES / "batch", tmp_path / "batch")
    shutil.copy(EXAMPLES / "bunny.pp", tmp_path)
    bunny = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes" / "bunny.obj"
    shutil.copy(bunny, tmp_path / "batch")
    with open(tmp_path / "batch" / "jobs.csv", "a") as jobs:
        jobs.write('none.obj,../bunny.pp,"a, b.ply",,,\nbunny.obj,none.pp,c.ply,,,\n')
    return tmp_path / "batch"


@pytest.fixture
def on_dask(program, cluster, example):
    def call(*words):
        command = [sys.executable, "run_on_dask.py", "jobs.csv", "--program", str(program), *words]
        if "--workers" not in words:
            command += ["--scheduler", cluster.scheduler_address]
        return subprocess.run(command, cwd=example, capture_output=True, text=True, timeout=300)

    return call


def rows(path):
    with open(path, newline="") as stream:
        found = sorted(csv.DictReader(stream), key=lambda row: int(row["job"]))
    return [{name: text for name, text in row.items() if name not in MEASURED} for row in found]


def test_the_results_are_those_of_the_program(on_dask, program, cluster, example):
    with Client(cluster) as client, get_task_stream(client) as stream:
        process = on_dask()
    assert process.returncode == 1 and "2 of 6 jobs failed: [5, 6]" in process.stderr, process.stderr
    assert len({task["worker"] for task in stream.data}) == 2, "both workers had jobs"
    curves = {path.name: path.read_bytes() for path in example.glob("bunny-*")}
    assert sorted(curves) == ["bunny-closed.ply", "bunny-open.ply", "bunny-quartic.bspline.obj", "bunny-straight.dxf"]
    assert subprocess.run([program, "batch", "jobs.csv", "--results", "own.csv"], cwd=example, capture_output=True).returncode == 1
    assert rows(example / "jobs.results.csv") == rows(example / "own.csv")
    assert (example / "jobs.results.csv").read_text().splitlines()[0] == (example / "own.csv").read_text().splitlines()[0]
    assert {path.name: path.read_bytes() for path in example.glob("bunny-*")} == curves


def test_either_goes_on_with_the_results_of_the_other(on_dask, program, example):
    subprocess.run([program, "batch", "jobs.csv", "--only", "1,3,5"], cwd=example, capture_output=True)
    written = (example / "bunny-open.ply").stat().st_mtime_ns
    shutil.copy(example / "bunny.obj", example / "none.obj")
    assert on_dask().returncode == 1, "results are there"
    process = on_dask("--resume")
    assert "1 of 4 jobs failed: [6]" in process.stderr, process.stderr
    assert [row["status"] for row in rows(example / "jobs.results.csv")] == 5 * ["done"] + ["failed"]
    assert (example / "bunny-open.ply").stat().st_mtime_ns == written
    shutil.copy(example.parent / "bunny.pp", example / "none.pp")
    command = [program, "batch", "jobs.csv", "--resume"]
    assert subprocess.run(command, cwd=example, capture_output=True).returncode == 0
    assert [row["status"] for row in rows(example / "jobs.results.csv")] == 6 * ["done"]
    assert (example / "bunny-open.ply").stat().st_mtime_ns == written


def test_workers_of_its_own(on_dask, example):
    lines = (example / "jobs.csv").read_text().splitlines()
    (example / "jobs.csv").write_text("\n".join(lines[:4]) + "\n")
    process = on_dask("--workers", "2")
    assert process.returncode == 0, process.stderr
    assert [row["status"] for row in rows(example / "jobs.results.csv")] == ["done", "done"]


def test_a_bad_jobs_file_is_refused_before_anything_runs(on_dask, example):
    (example / "jobs.csv").write_text("mesh,picks,output,colour\nbunny.obj,../bunny.pp,a.ply,red\n")
    process = on_dask()
    assert process.returncode == 1 and '"colour"' in process.stderr and process.stderr.count("\n") == 1
    assert not (example / "jobs.results.csv").exists()
