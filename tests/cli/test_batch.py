# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb batch: many curves at once, results, going on after a stop, and what it refuses."""

import csv
import json
import os
import pty
import re
import signal
import subprocess
import time
from pathlib import Path

import made_meshes as meshes
import numpy as np
import psutil
import pytest

ROOT = Path(__file__).resolve().parents[2]
COLUMNS = "job,mesh,picks,output,status,seconds,usable,length,max_distance,vertices,peak_memory_bytes,message,command"
LONG = 100000  # repeats of a curve: minutes


@pytest.fixture
def hill(tmp_path):
    """A folder with hill.ply, picks.json and bad.ply, which is no mesh."""
    V, F = meshes.plate(height=0.1)
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    (tmp_path / "picks.json").write_text(json.dumps({"picks": V[[30, 90, 140]].tolist()}))
    (tmp_path / "bad.ply").write_text("no mesh")
    return tmp_path


def write_jobs(folder, *rows, columns="mesh,picks,output", name="jobs.csv"):
    (folder / name).write_text("\n".join([columns, *rows]) + "\n")


def plain(*outputs, mesh="hill.ply"):
    return [f"{mesh},picks.json,{output}" for output in outputs]


def results(folder, name="jobs.results.csv"):
    """The lines of a results file, by the number of the job."""
    with open(folder / name, newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert (folder / name).read_text().splitlines()[0] == COLUMNS
    assert len({row["job"] for row in rows}) == len(rows), "a line for each job"
    return {int(row["job"]): row for row in rows}


def status(folder, **names):
    return {job: row["status"] for job, row in sorted(results(folder, **names).items())}


# ---------------------------------------------------------------- what it does


@pytest.mark.parametrize("at_once", [1, 3])
def test_every_job_is_drawn_as_by_itself(run, hill, at_once):
    rows = ["hill.ply,picks.json,a.ply,,,", "hill.ply,picks.json,b.ply,4,yes,0.5", 'hill.ply,picks.json,"c, 1.json",2,no,']
    write_jobs(hill, *rows, columns="mesh,picks,output,Degree,closed,--tension")
    process = run("batch", "jobs.csv", "--jobs", at_once)
    assert (process.returncode, process.stdout, process.stderr) == (0, "jobs.results.csv: 3 jobs done\n", "")
    assert status(hill) == {1: "done", 2: "done", 3: "done"}
    words = {"a.ply": (), "b.ply": ("--degree", 4, "--closed", "--tension", 0.5), "c, 1.json": ("--degree", 2)}
    for (name, options), row in zip(words.items(), results(hill).values() if at_once == 1 else [None] * 3):
        alone = hill / ("alone" + Path(name).suffix)
        reported = run("hill.ply", "--picks", "picks.json", "--output", alone, "--report", "r.json", *options)
        assert reported.returncode == 0
        assert alone.read_bytes() == (hill / name).read_bytes()
        if row:
            report = json.loads((hill / "r.json").read_text())
            assert row["usable"] == "true" and row["output"] == name and row["message"] == ""
            assert float(row["length"]) == report["curve"]["length"]
            assert float(row["max_distance"]) == report["max_distance"]
            assert int(row["vertices"]) == report["curve"]["vertices"]
            assert float(row["seconds"]) > 0 and int(row["peak_memory_bytes"]) > 1e6


def test_a_job_that_fails_does_not_stop_the_others(run, hill):
    V = meshes.plate()[0]
    (hill / "far.json").write_text(json.dumps({"picks": (V[[0, 5]] + [0, 0, 9]).tolist()}))
    rows = ["bad.ply,picks.json,a.ply", "none.ply,picks.json,b.ply", "hill.ply,far.json,c.ply", "hill.ply,picks.json,d.ply"]
    write_jobs(hill, *rows)
    process = run("batch", "jobs.csv", "--jobs", 2)
    assert process.returncode == 1 and process.stdout == ""
    assert process.stderr.count("\n") == 1 and "3 of 4 jobs failed; jobs.results.csv says why" in process.stderr
    assert status(hill) == {1: "failed", 2: "failed", 3: "failed", 4: "done"}
    rows = results(hill)
    assert "bad.ply" in rows[1]["message"] and "no such file" in rows[2]["message"] and "pick" in rows[3]["message"]
    assert rows[1]["usable"] == rows[1]["length"] == "" and rows[4]["usable"] == "true"
    assert not any((hill / f"{name}.ply").exists() for name in "abc")


def test_a_curve_that_is_not_usable_has_figures(run, hill):
    columns = "mesh,picks,output,max_rounds,max_iterations,distance_tolerance,require_usable"
    write_jobs(hill, "hill.ply,picks.json,a.ply,1,1,1e-9,", "hill.ply,picks.json,b.ply,1,1,1e-9,true", columns=columns)
    assert run("batch", "jobs.csv").returncode == 1
    for row, status in zip((results(hill)[1], results(hill)[2]), ("done", "failed")):
        assert (row["status"], row["usable"]) == (status, "false") and float(row["max_distance"]) > 1e-9
        assert "not usable" in row["message"]


def test_paths_are_relative_to_the_jobs_file(run, hill):
    folder = hill / "ein Ordner – 曲線"
    (folder / "out").mkdir(parents=True)
    for name in ("hill.ply", "picks.json"):
        (hill / name).rename(folder / name)
    rows = ["hill.ply,picks.json,out/Kurve 1.ply,out/r.json", f"hill.ply,picks.json,{hill}/absolute.ply,"]
    write_jobs(folder, *rows, columns="mesh,picks,output,report")
    run.ok("batch", folder / "jobs.csv")
    assert (folder / "out" / "Kurve 1.ply").is_file() and (hill / "absolute.ply").is_file()
    assert json.loads((folder / "out" / "r.json").read_text())["usable"]
    assert status(folder) == {1: "done", 2: "done"}
    assert float(results(folder)[1]["length"]) > 1


def test_the_command_of_a_line_draws_the_same_curve(program, run, hill):
    write_jobs(hill, """hill.ply,picks.json,"it's a, b.ply",3""", columns="mesh,picks,output,degree")
    run.ok("batch", "jobs.csv")
    curve = hill / "it's a, b.ply"
    first = curve.read_bytes()
    curve.unlink()
    environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}
    subprocess.run(results(hill)[1]["command"], shell=True, cwd=hill, env=environment, check=True)
    assert curve.read_bytes() == first


def test_a_report_of_an_earlier_run_is_not_taken(run, hill):
    write_jobs(hill, "hill.ply,picks.json,a.ply,r.json", columns="mesh,picks,output,report")
    run.ok("batch", "jobs.csv")
    (hill / "hill.ply").write_text("broken meanwhile")
    assert run("batch", "jobs.csv", "--results", "later.csv").returncode == 1
    row = results(hill, "later.csv")[1]
    assert row["status"] == "failed" and row["usable"] == row["length"] == ""


def test_separators_comments_and_quotes(run, hill):
    (hill / "jobs.csv").write_text('\ufeff# made by hand\nmesh;picks;output;closed\n\nhill.ply; picks.json ;"a;1.ply";\n')
    run.ok("batch", "jobs.csv")
    assert (hill / "a;1.ply").is_file()


def test_jobs_on_one_mesh_share_one_preparation(run, hill, cache):
    (hill / "flat.ply").write_bytes((hill / "hill.ply").read_bytes())
    rows = [f"{mesh}.ply,picks.json,{mesh}{n}.ply,{mesh}{n}.json,simplified" for n in "abc" for mesh in ("hill", "flat")]
    rows.append("hill.ply,picks.json,fibres.ply,fibres.json,local")
    write_jobs(hill, *rows, columns="mesh,picks,output,report,shell")
    run.ok("batch", "jobs.csv", "--jobs", 2)
    reports = {path.stem: json.loads(path.read_text()) for path in hill.glob("*.json") if path.stem != "picks"}

    def preparations(names):
        """Times that no two preparations share."""
        return {tuple(reports[name]["seconds"][key] for key in ("read", "validate", "shell")) for name in names}

    assert len(preparations(f"hill{n}" for n in "abc")) == len(preparations(f"flat{n}" for n in "abc")) == 1
    assert len(preparations(reports)) == 3, "another mesh, or another shell, is another preparation"
    assert list(results(hill)) == list(range(1, 8)), "the lines are in the order of the jobs"


def test_a_job_that_needs_too_much_memory_fails_alone(run, hill):
    meshes.write_ply(hill / "large.ply", *meshes.plate(cells=300))
    (hill / "flat.json").write_text(json.dumps({"picks": meshes.PICKS}))
    write_jobs(hill, "large.ply,flat.json,a.ply", "hill.ply,picks.json,b.ply")
    process = run("batch", "jobs.csv", "--job-memory", 0.06)
    assert process.returncode == 1
    assert status(hill) == {1: "failed", 2: "done"}
    assert "out of memory" in results(hill)[1]["message"]


def test_a_dry_run_prints_the_commands_and_runs_nothing(run, hill):
    write_jobs(hill, "hill.ply,picks.json,a b.ply,yes,0.5", columns="mesh,picks,output,closed,lambda")
    before = sorted(hill.iterdir())
    process = run("batch", "jobs.csv", "--dry-run")
    assert process.returncode == 0 and process.stderr == ""
    assert process.stdout == "bspline_curve curve hill.ply --picks=picks.json '--output=a b.ply' --closed --lambda=0.5  # job 1\n"
    assert sorted(hill.iterdir()) == before


def test_only_some_jobs(run, hill):
    write_jobs(hill, *plain("a.ply", "b.ply", "c.ply", "d.ply"))
    run.ok("batch", "jobs.csv", "--only", "2,4")
    assert status(hill) == {2: "done", 4: "done"}
    run.ok("batch", "jobs.csv", "--only", "1-2", "--resume")
    assert status(hill) == {1: "done", 2: "done", 4: "done"}, "lines of other jobs stay"


# ---------------------------------------------------------------- going on


def test_resume_runs_what_is_not_done(run, hill):
    rows = plain("a.ply", "b.ply", "c.ply", "d.ply")
    rows[1] = "bad.ply,picks.json,b.ply"
    write_jobs(hill, *rows)
    assert run("batch", "jobs.csv").returncode == 1
    first = results(hill)
    (hill / "c.ply").unlink()
    (hill / "bad.ply").write_bytes((hill / "hill.ply").read_bytes())
    before = {name: (hill / name).stat().st_mtime_ns for name in ("a.ply", "d.ply")}
    run.ok("batch", "jobs.csv", "--resume")
    assert status(hill) == dict.fromkeys((1, 2, 3, 4), "done")
    assert {name: (hill / name).stat().st_mtime_ns for name in before} == before
    assert results(hill)[1] == first[1] and results(hill)[4] == first[4]
    assert (hill / "b.ply").is_file() and (hill / "c.ply").is_file()


def test_resume_runs_jobs_whose_line_changed_and_follows_new_numbers(run, hill):
    write_jobs(hill, "hill.ply,picks.json,a.ply,3", "hill.ply,picks.json,b.ply,3", columns="mesh,picks,output,degree")
    run.ok("batch", "jobs.csv")
    old = (hill / "b.ply").read_bytes()
    time_of_a = (hill / "a.ply").stat().st_mtime_ns
    rows = ["hill.ply,picks.json,n.ply,", "hill.ply,picks.json,b.ply,2", "hill.ply,picks.json,a.ply,3"]
    write_jobs(hill, *rows, columns="mesh,picks,output,degree")
    run.ok("batch", "jobs.csv", "--resume")
    assert {job: row["output"] for job, row in results(hill).items()} == {1: "n.ply", 2: "b.ply", 3: "a.ply"}
    assert (hill / "b.ply").read_bytes() != old and (hill / "a.ply").stat().st_mtime_ns == time_of_a


@pytest.mark.parametrize("cut", [1, 10, 150])
def test_resume_after_the_results_were_cut_off(run, hill, cut):
    write_jobs(hill, *plain("a.ply", "b.ply"))
    run.ok("batch", "jobs.csv", "--jobs", 1)
    whole = (hill / "jobs.results.csv").read_bytes()
    (hill / "jobs.results.csv").write_bytes(whole[:-cut])
    run.ok("batch", "jobs.csv", "--resume")
    assert status(hill) == {1: "done", 2: "done"}


def test_resume_without_results_begins(run, hill):
    write_jobs(hill, *plain("a.ply"))
    run.ok("batch", "jobs.csv", "--resume")
    assert status(hill) == {1: "done"}


# ---------------------------------------------------------------- what it refuses, before anything runs


@pytest.mark.parametrize(
    "text, parts",
    [
        ("mesh,picks\nhill.ply,picks.json\n", ["line 1", 'no column "output"']),
        ("mesh,picks,output,colour\n", ["line 1", '"colour"']),
        ("mesh,picks,output,help\n", ["line 1", '"help"']),
        ("mesh,picks,output,max_rounds,max-rounds\n", ["line 1", "two columns"]),
        ("mesh,picks,output\n", ["no jobs"]),
        ("# nothing\n", ["no header"]),
        ("", ["empty"]),
        ("mesh,picks,output\nhill.ply,picks.json\n", ["line 2", "2 fields"]),
        ("mesh,picks,output\nhill.ply,picks.json,a.ply,b\n", ["line 2", "4 fields"]),
        ("mesh,picks,output\nhill.ply,,a.ply\n", ["line 2", "picks"]),
        ("mesh,picks,output\n,picks.json,a.ply\n", ["line 2", "mesh"]),
        ('mesh,picks,output\nhill.ply,"picks.json,a.ply\n', ["line 2", "quote"]),
        ("mesh,picks,output\nhill.ply,picks.json,a.xyz\n", ["line 2", ".xyz"]),
        ("mesh,picks,output\nhill.ply,picks.json,none/a.ply\n", ["line 2", "does not exist"]),
        ("mesh,picks,output\nhill.ply,picks.json,a.ply\nhill.ply,picks.json,./a.ply\n", ["line 3", "a.ply", "line 2"]),
        ("mesh,picks,output,report\nhill.ply,picks.json,a.json,\nhill.ply,picks.json,b.ply,a.json\n", ["line 3", "line 2"]),
        ("mesh,picks,output\nhill.ply,picks.json,a.ply\nhill.ply,picks.json,picks.json\n", ["line 2", "picks.json", "line 3"]),
        ("mesh,picks,output\nhill.ply,picks.json,jobs.csv\n", ["line 2", "the jobs file"]),
        ("mesh,picks,output\nhill.ply,picks.json,jobs.results.csv\n", ["line 2", "the results file"]),
        ("mesh,picks,output,degree\nhill.ply,picks.json,a.ply,\nhill.ply,picks.json,b.ply,5\n", ["line 3", "--degree", "[2, 4]"]),
        ("mesh,picks,output,closed\nhill.ply,picks.json,a.ply,perhaps\n", ["line 2", "closed", "perhaps"]),
        ("mesh,picks,output,tension,lambda\nhill.ply,picks.json,a.ply,0,1\n", ["line 2", "tension"]),
        ("mesh,picks,output,avoid\nhill.ply,picks.json,a.ply,under-threshold\n", ["line 2", "--avoid-threshold"]),
        ("mesh,picks,output,report\nhill.ply,picks.json,a.ply,r.txt\n", ["line 2", "r.txt"]),
    ],
)
def test_jobs_files_that_are_not_in_order(refused, hill, text, parts):
    (hill / "jobs.csv").write_text(text)
    assert refused(1, "batch", "jobs.csv", says=parts).startswith("bspline_curve: jobs.csv")


def test_other_refusals(refused, hill):
    write_jobs(hill, *plain("a.ply"))
    for words, code, part in [
        (("none.csv",), 1, "no such file"),
        (("jobs.csv", "--jobs", 0), 2, "--jobs"),
        (("jobs.csv", "--only", "2-1"), 2, "backwards"),
        (("jobs.csv", "--only", "x"), 2, "--only"),
        (("jobs.csv", "--only", "2"), 1, "no job 2"),
        (("jobs.csv", "--job-memory", "0"), 2, "--job-memory"),
        (("jobs.csv", "--results", "none/r.csv"), 1, "does not exist"),
        ((), 2, "JOBS"),
    ]:
        refused(code, "batch", *words, says=[part])
    (hill / "jobs.results.csv").write_text("precious")
    for words in ((), ("--resume",)):
        refused(1, "batch", "jobs.csv", *words, says=["jobs.results.csv"])


def test_the_table_of_options_is_the_help(run):
    section = re.search(r"\n## Batches\n(.*)", (ROOT / "docs" / "FILES.md").read_text(), re.S)[1]
    options = re.findall(r"^  (?:-h,)?(--[\w-]+)", run("batch", "--help").stdout, re.M)
    assert sorted(re.findall(r"^\| `(--[\w-]+)` \|", section, re.M)) == sorted(set(options) - {"--help"})


# ---------------------------------------------------------------- jobs that crash, and stops


@pytest.fixture
def long_batch(program, hill):
    """Starts a batch whose job 1 is quick and whose others last; gives the process and its running jobs."""
    started = []

    def start(*words, stderr=subprocess.PIPE, running=2):
        rows = ["hill.ply,picks.json,a.ply,"] + [f"hill.ply,picks.json,{name}.ply,{LONG}" for name in "bcd"]
        write_jobs(hill, *rows, columns="mesh,picks,output,repeat")
        command = [str(program), "batch", "jobs.csv", "--jobs", "2", *words]
        process = subprocess.Popen(command, cwd=hill, stderr=stderr, stdout=subprocess.PIPE, text=True)
        started.append(process)
        end = time.monotonic() + 60
        while time.monotonic() < end:
            jobs = jobs_of(process)
            written = hill / "jobs.results.csv"
            if written.exists() and "done" in written.read_text() and len(jobs) == running:
                return process, jobs
            time.sleep(0.02)
        raise AssertionError("the jobs do not run")

    yield start
    for process in started:
        process.kill()
        process.wait()


def jobs_of(batch):
    """The processes that draw curves: children of those that prepare meshes."""
    found = []
    for mesh in psutil.Process(batch.pid).children():
        try:
            found += [job for job in mesh.children() if job.status() != psutil.STATUS_ZOMBIE]
        except psutil.NoSuchProcess:
            pass
    return found


def test_so_many_jobs_run_at_once(long_batch):
    process, _ = long_batch()
    for _ in range(10):
        assert len(psutil.Process(process.pid).children()) == 1 and len(jobs_of(process)) == 2
        time.sleep(0.02)


def crash(processes):
    for process in processes:
        process.send_signal(signal.SIGSEGV)
        process.wait(60)
    return len(processes)


def test_a_job_that_crashes_ends_alone(long_batch, hill):
    process, _ = long_batch()
    crashed = 0
    while crashed < 3:
        crashed += crash(jobs_of(process))
        time.sleep(0.02)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 1 and "3 of 4 jobs failed" in err
    assert status(hill) == {1: "done", 2: "crashed", 3: "crashed", 4: "crashed"}
    assert "Segmentation fault" in results(hill)[2]["message"]
    assert not (hill / "b.ply").exists()


def test_a_mesh_that_crashes_takes_only_its_running_jobs_along(long_batch, hill):
    process, jobs = long_batch()
    crash(psutil.Process(process.pid).children())
    assert psutil.wait_procs(jobs, timeout=60)[1] == []
    end = time.monotonic() + 60
    while len(jobs_of(process)) != 1 and time.monotonic() < end:
        time.sleep(0.02)
    assert crash(jobs_of(process)) == 1, "the last job has got a process for its mesh anew"
    process.communicate(timeout=60)
    assert status(hill) == {1: "done", 2: "crashed", 3: "crashed", 4: "crashed"}


def test_ctrl_c_leaves_results_to_go_on_with(long_batch, hill, run):
    process, jobs = long_batch()
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130 and out == ""
    assert err == "bspline_curve: interrupted; 1 of 4 jobs done, --resume goes on\n"
    assert psutil.wait_procs(jobs, timeout=10)[1] == [], "the jobs have ended"
    assert status(hill) == {1: "done"}
    assert sorted(p.name for p in hill.glob(".*")) == [], "no temporary files"
    lines = (hill / "jobs.csv").read_text().replace(f",{LONG}", ",")
    (hill / "jobs.csv").write_text(lines)
    run.ok("batch", "jobs.csv", "--resume")
    assert status(hill) == dict.fromkeys((1, 2, 3, 4), "done")


def test_jobs_end_with_a_batch_that_is_killed(long_batch, hill):
    process, jobs = long_batch()
    process.kill()
    process.wait()
    assert psutil.wait_procs(jobs, timeout=60)[1] == []
    assert status(hill) == {1: "done"}


def test_a_second_batch_on_the_same_results_is_refused(long_batch, hill, run):
    process, _ = long_batch()
    second = run("batch", "jobs.csv", "--resume")
    assert second.returncode == 1 and "another batch" in second.stderr
    assert process.poll() is None and status(hill) == {1: "done"}


def test_a_terminal_shows_how_many_jobs_are_done(long_batch):
    terminal, stderr = pty.openpty()
    process, _ = long_batch(stderr=stderr)
    os.close(stderr)
    text, end = b"", time.monotonic() + 60
    while b"1 of 4 jobs" not in text and time.monotonic() < end:
        text += os.read(terminal, 4096)
    assert b"[#" in text and b"25 % 1 of 4 jobs" in text
    process.send_signal(signal.SIGINT)
    try:
        while block := os.read(terminal, 4096):
            text += block
    except OSError:  # the terminal closes with the process
        pass
    assert process.wait(timeout=60) == 130 and b"interrupted" in text


def test_nothing_is_left_in_the_temporary_folder(run, hill, monkeypatch):
    temporary = hill / "temporary"
    temporary.mkdir()
    monkeypatch.setenv("TMPDIR", str(temporary))
    write_jobs(hill, *plain("a.ply"), *plain("b.ply", mesh="bad.ply"))
    assert run("batch", "jobs.csv").returncode == 1
    assert list(temporary.iterdir()) == []
    monkeypatch.setenv("TMPDIR", str(hill / "none"))
    process = run("batch", "jobs.csv", "--resume")
    assert process.returncode == 1 and "TMPDIR" in process.stderr


def test_hundreds_of_jobs(run, hill):
    names = [f"c{i:03}.csv" for i in range(300)]
    write_jobs(hill, *plain(*names))
    run.ok("batch", "jobs.csv", "--jobs", 8)
    assert status(hill) == dict.fromkeys(range(1, 301), "done")
    assert len({(hill / name).read_bytes() for name in names}) == 1
    lengths = np.array([float(row["length"]) for row in results(hill).values()])
    assert np.ptp(lengths) == 0
