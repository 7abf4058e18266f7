# SPDX-License-Identifier: GPL-3.0-or-later
"""Full disks, folders that cannot be written, and kill -9 at random moments: no half file, and one line that says why."""

import csv
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

import made_meshes as meshes
import pytest

SEED = 20261125
NOBODY = 65534


@pytest.fixture
def hill(tmp_path):
    V, F = meshes.plate(cells=24, height=0.1)
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    (tmp_path / "picks.json").write_text(json.dumps({"picks": V[[30, 290, 440]].tolist()}))
    return tmp_path


def visible(folder):
    """Files but those hidden ones that a killed process left beside its output."""
    return sorted(path.name for path in folder.iterdir() if not path.name.startswith("."))


# ---------------------------------------------------------------- no room, no permission


VERBS = {
    "curve": ("hill.ply", "--picks", "picks.json", "--output", "out/c.ply"),
    "report": ("hill.ply", "--picks", "picks.json", "--output", "c.csv", "--report", "out/r.json"),
    "field": ("field", "hill.ply", "--kind", "valley", "--output", "out/f.txt"),
    "shell": ("shell", "hill.ply", "--output", "out/s.vtu"),
}


@pytest.mark.parametrize("verb", VERBS)
def test_a_file_that_finds_no_room_is_refused_in_one_line_and_leaves_nothing(program, hill, verb):
    (hill / "out").mkdir()
    before = visible(hill)

    def little_room():
        resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

    done = subprocess.run([program, *VERBS[verb]], cwd=hill, capture_output=True, text=True, preexec_fn=little_room)
    assert done.returncode == 1 and done.stderr.count("\n") == 1, done.stderr
    assert "out/" in done.stderr and "cannot be written: File too large" in done.stderr
    assert list((hill / "out").iterdir()) == [] and visible(hill) == before


def test_a_full_device_is_told(program, hill):
    (hill / "full.ply").symlink_to("/dev/full")
    words = [program, "hill.ply", "--picks", "picks.json", "--output", "full.ply"]
    done = subprocess.run(words, cwd=hill, capture_output=True, text=True)
    assert done.returncode == 1 and "No space left on device" in done.stderr and done.stderr.count("\n") == 1


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can mount a file system")
def test_a_full_disk_keeps_the_file_that_was_there(program, hill):
    (hill / "out").mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", hill / "out"], capture_output=True).returncode:
        pytest.skip("mounting is not allowed")
    try:
        (hill / "out" / "c.ply").write_text("old")
        (hill / "out" / "fill").write_bytes(bytes(8192))
        done = subprocess.run([program, *VERBS["curve"]], cwd=hill, capture_output=True, text=True)
        assert done.returncode == 1 and "out/c.ply: cannot be written: No space left on device" in done.stderr
        assert sorted(os.listdir(hill / "out")) == ["c.ply", "fill"] and (hill / "out" / "c.ply").read_text() == "old"
    finally:
        subprocess.run(["umount", hill / "out"], check=True)


@pytest.mark.parametrize("verb", VERBS)
def test_a_folder_that_cannot_be_written_is_refused_before_the_work(program, hill, verb):
    with tempfile.TemporaryDirectory() as folder:  # others may enter it, unlike that of the test
        place = Path(folder)
        place.chmod(0o777)
        for name in ("hill.ply", "picks.json"):
            shutil.copy(hill / name, place)
        (place / "out").mkdir()
        (place / "out").chmod(0o555)
        user = {"user": NOBODY} if os.geteuid() == 0 else {}
        done = subprocess.run([program, *VERBS[verb]], cwd=place, capture_output=True, text=True, **user)
        assert done.returncode == 1 and done.stderr.count("\n") == 1, done.stderr
        assert "out/" in done.stderr and "Permission denied" in done.stderr
        assert visible(place) == ["hill.ply", "out", "picks.json"] and list((place / "out").iterdir()) == []


# ---------------------------------------------------------------- kill -9


def killed_at(moment, words, folder):
    """Starts a process and kills it after so many seconds; whether it was still running."""
    process = subprocess.Popen(list(map(str, words)), cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(moment)
    process.kill()
    return process.wait() == -signal.SIGKILL


def seconds_of(words, folder):
    start = time.monotonic()
    subprocess.run(list(map(str, words)), cwd=folder, check=True, capture_output=True)
    return time.monotonic() - start


@pytest.mark.slow
def test_kills_while_curves_are_saved_leave_the_old_file_or_the_new_one(program, hill):
    words = [program, "hill.ply", "--picks", "picks.json", "--output", "c.ply", "--report", "r.json", "--samples", "20000"]
    seconds = seconds_of(words, hill)
    new, names = (hill / "c.ply").read_bytes(), visible(hill)
    moments = random.Random(SEED)
    killed = 0
    for _ in range(100):
        (hill / "c.ply").write_bytes(b"old")
        killed += killed_at(moments.uniform(0, 1.2 * seconds), words, hill)
        assert (hill / "c.ply").read_bytes() in (b"old", new) and visible(hill) == names
        json.loads((hill / "r.json").read_text())
    assert killed > 30


@pytest.mark.slow
def test_kills_while_shells_are_cached_never_leave_one_that_is_wrong(program, hill, cache):
    words = [program, "hill.ply", "--picks", "picks.json", "--output", "c.csv", "--shell", "simplified"]
    seconds = seconds_of(words, hill)
    new = (hill / "c.csv").read_bytes()
    moments = random.Random(SEED)
    killed = 0
    for _ in range(50):
        shutil.rmtree(cache)
        killed += killed_at(moments.uniform(0, 1.2 * seconds), words, hill)
        cache.mkdir(parents=True, exist_ok=True)
        done = subprocess.run(words, cwd=hill, capture_output=True, text=True)
        assert (done.returncode, done.stderr) == (0, "") and (hill / "c.csv").read_bytes() == new
    assert killed > 15


@pytest.mark.slow
def test_kills_of_batches_and_resuming_end_with_the_same_results(program, hill):
    names = [f"{n}.ply" for n in range(12)]
    rows = [f"hill.ply,picks.json,{name},{0.03 * n}" for n, name in enumerate(names)]
    (hill / "jobs.csv").write_text("\n".join(["mesh,picks,output,tension", *rows]) + "\n")
    words = [program, "batch", "jobs.csv", "--jobs", "2"]
    seconds = seconds_of(words, hill)
    whole = {name: (hill / name).read_bytes() for name in names}
    moments = random.Random(SEED)
    killed = 0
    for _ in range(12):
        for name in [*names, "jobs.results.csv"]:
            (hill / name).unlink(missing_ok=True)
        for _ in range(4):
            killed += killed_at(moments.uniform(0, 0.6 * seconds), [*words, "--resume"], hill)
            assert {name: (hill / name).read_bytes() for name in names if (hill / name).exists()}.items() <= whole.items()
        done = subprocess.run([*words, "--resume"], cwd=hill, capture_output=True, text=True)
        assert (done.returncode, done.stderr) == (0, "")
        assert {name: (hill / name).read_bytes() for name in names} == whole
        with open(hill / "jobs.results.csv", newline="") as stream:
            assert [(row["job"], row["status"]) for row in csv.DictReader(stream)] == [(str(n), "done") for n in range(1, 13)]
    assert killed > 15
