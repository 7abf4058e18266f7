# SPDX-License-Identifier: GPL-3.0-or-later
"""The cache of simplified shells, as the program's users meet it."""

import json
import os

import made_meshes as meshes
import pytest

CURVE = ("curve", "hill.ply", "--picks", "picks.json", "--output", "c.json", "--report", "r.json")
SIMPLIFIED = (*CURVE, "--shell", "simplified")


@pytest.fixture
def draw(run, tmp_path):
    """Draws a curve on a hill; returns its bytes, its report and what was said on stderr."""
    V, F = meshes.plate(cells=20, height=0.2)
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    (tmp_path / "picks.json").write_text(json.dumps({"picks": V[[25, 215, 415]].tolist()}))

    def call(*words):
        process = run.ok(*(words or SIMPLIFIED))
        assert process.stdout.startswith("c.json: an open curve, ")
        return (tmp_path / "c.json").read_bytes(), json.loads((tmp_path / "r.json").read_text()), process.stderr

    return call


def entries(cache):
    return sorted(cache.iterdir())


def test_the_second_run_is_served_from_the_cache_and_draws_the_same_curve(draw, cache):
    first, report, said = draw()
    assert not report["cached"] and said == "" and len(entries(cache)) == 1
    stored = entries(cache)[0].read_bytes()
    second, again, said = draw()
    assert again["cached"] and again["notes"] == [] and said == ""
    assert second == first
    for key in ("shell", "prisms", "curve", "iterations"):
        assert again[key] == report[key]
    assert entries(cache)[0].read_bytes() == stored


@pytest.mark.parametrize("damage", ["bit", "cut", "empty", "garbage"])
def test_a_damaged_entry_is_rebuilt_and_a_note_says_so(draw, cache, damage):
    first, _, _ = draw()
    (entry,) = entries(cache)
    stored = entry.read_bytes()
    middle = len(stored) // 2
    entry.write_bytes({
        "bit": stored[:middle] + bytes([stored[middle] ^ 4]) + stored[middle + 1:],
        "cut": stored[:middle],
        "empty": b"",
        "garbage": b"x" * len(stored),
    }[damage])
    second, report, said = draw()
    assert not report["cached"] and second == first
    assert len(report["notes"]) == 1 and entry.name in report["notes"][0]
    assert said == f"bspline_curve: note: {report['notes'][0]}\n"
    assert entry.read_bytes() == stored
    assert draw()[1]["cached"]


def test_other_meshes_and_options_have_entries_of_their_own(draw, cache, run, tmp_path):
    draw()
    for count, words in enumerate(
        [("--target-thickness", 0.1), ("--target-edge-length", 0.3), ("--shell-smoothing-passes", 2)], start=2
    ):
        assert not draw(*SIMPLIFIED, *words)[1]["cached"]
        assert len(entries(cache)) == count
        assert draw(*SIMPLIFIED, *words)[1]["cached"]
    # What a simplified shell does not depend on
    assert draw(*SIMPLIFIED, "--tension", 0.5, "--shell-thickness", 0.5)[1]["cached"]
    V, F = meshes.plate(cells=20, height=0.2)
    V[0, 2] += 1e-9
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    assert not draw()[1]["cached"]
    assert len(entries(cache)) == 5


def test_full_shells_are_not_kept(draw, cache):
    assert not draw(*CURVE, "--shell", "full")[1]["cached"]
    assert not cache.exists()


def test_no_cache_neither_reads_nor_writes(draw, cache):
    assert not draw(*SIMPLIFIED, "--no-cache")[1]["cached"]
    assert not cache.exists()
    draw()
    before = entries(cache)[0].stat().st_mtime_ns
    assert not draw(*SIMPLIFIED, "--no-cache")[1]["cached"]
    assert entries(cache)[0].stat().st_mtime_ns == before


def test_an_empty_variable_turns_the_cache_off(draw, monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    monkeypatch.setenv("BSPLINE_CURVE_CACHE", "")
    draw()
    assert not (tmp_path / "xdg").exists()
    monkeypatch.delenv("BSPLINE_CURVE_CACHE")
    draw()
    assert len(entries(tmp_path / "xdg" / "bspline_curve" / "shells")) == 1


def test_a_folder_that_cannot_be_written_is_a_note(draw, cache):
    cache.parent.write_text("a file in the way")
    _, report, said = draw()
    assert len(report["notes"]) == 1 and "not stored" in report["notes"][0]
    assert said == f"bspline_curve: note: {report['notes'][0]}\n"
    assert cache.parent.read_text() == "a file in the way"


def test_what_was_not_used_for_longest_makes_room(draw, cache):
    cache.mkdir(parents=True)
    for name, age, size in (("old.shell", 200, 400 << 20), ("new.shell", 100, 200 << 20), ("mine.txt", 300, 600 << 20)):
        with open(cache / name, "wb") as file:
            file.truncate(size)  # holes; they take no space
        seconds = (cache / name).stat().st_mtime - age
        os.utime(cache / name, (seconds, seconds))
    draw()
    names = [entry.name for entry in entries(cache)]
    assert "old.shell" not in names and {"new.shell", "mine.txt"} < set(names) and len(names) == 3


def test_the_verb_shell_keeps_shells_for_curves_and_takes_them(draw, cache, run, tmp_path):
    def shell(*words):
        process = run("shell", "hill.ply", *words)
        assert process.returncode == 0 and process.stderr == "", process.stderr

    shell("--output", "built.vtu")
    first, report, _ = draw()
    assert report["cached"]
    shell("--output", "taken.vtu")
    assert (tmp_path / "taken.vtu").read_bytes() == (tmp_path / "built.vtu").read_bytes()
    assert len(entries(cache)) == 1
    assert draw(*SIMPLIFIED, "--no-cache")[0] == first


@pytest.mark.parametrize("words", [("--report", "shell.json"), ("--check",)])
def test_figures_and_checks_are_of_a_shell_that_was_built(run, cache, draw, tmp_path, words):
    draw()
    (entry,) = entries(cache)
    stored = entry.read_bytes()
    entry.write_bytes(b"damaged")
    process = run("shell", "hill.ply", *words)
    assert process.returncode == 0 and process.stderr == "", "the entry is not even read"
    assert entry.read_bytes() == stored
    if "--report" in words:
        assert json.loads((tmp_path / "shell.json").read_text())["notes"] == []


def test_the_verb_shell_tells_what_it_met_too(run, cache, draw, tmp_path):
    draw()
    (entry,) = entries(cache)
    entry.write_bytes(b"damaged")
    process = run("shell", "hill.ply", "--output", "a.vtu")
    assert process.returncode == 0 and entry.name in process.stderr and process.stderr.count("\n") == 1
    assert process.stderr.startswith("bspline_curve: note: ")


def test_mended_meshes_have_shells_in_the_cache_too(draw, cache, tmp_path):
    V, F = meshes.plate(cells=20, height=0.2)
    F[7] = F[7][::-1]
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    first, report, said = draw(*SIMPLIFIED)
    assert "mended" in said and not report["cached"]
    second, report, _ = draw(*SIMPLIFIED)
    assert report["cached"] and second == first
