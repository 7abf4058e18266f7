# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb edit: curves turned round, cut, joined and extended."""

import json

import numpy as np
import pytest

pytestmark = pytest.mark.usefixtures("plate")


def told(file):
    return json.loads(file.read_text())


def points(file):
    return np.array(told(file)["polyline"]["points"])


def length(file):
    return np.linalg.norm(np.diff(points(file), axis=0), axis=1).sum()


@pytest.fixture
def curve(run, plate):
    run.ok("plate.ply", "--picks", "picks.json", "--output", "curve.json")
    return plate / "curve.json"


def edit(run, *words):
    return run.ok("edit", "plate.ply", *words)


def test_turned_round_and_back(run, plate, curve):
    edit(run, "--curve", "curve.json", "--reverse", "--output", "turned.json")
    np.testing.assert_allclose(points(plate / "turned.json"), points(curve)[::-1])
    edit(run, "--curve", "turned.json", "--reverse", "--output", "again.json")
    np.testing.assert_allclose(points(plate / "again.json"), points(curve))


def test_parts_and_the_whole_again(run, plate, curve):
    edit(run, "--curve", "curve.json", "--split", "0.7,0.3", "--output", "part.json")
    parts = [plate / "part.json", plate / "part-2.json", plate / "part-3.json"]
    assert sum(map(length, parts)) == pytest.approx(length(curve), rel=1e-9)
    words = [word for part in ("part.json", "part-2.json", "part-3.json") for word in ("--curve", part)]
    edit(run, *words, "--join", "--output", "whole.json")
    assert length(plate / "whole.json") == pytest.approx(length(curve), rel=1e-9)
    edit(run, "--curve", "curve.json", "--trim", "0.3,0.7", "--output", "trimmed.json")
    np.testing.assert_allclose(points(plate / "trimmed.json"), points(plate / "part-2.json"))


def test_longer_at_both_ends(run, plate, curve):
    edit(run, "--curve", "curve.json", "--trim", "0.2,0.8", "--output", "short.json")
    for at, times in (("end", 1), ("start", 1), ("both", 2)):
        edit(run, "--curve", "short.json", "--extend", 0.05, "--at", at, "--output", "longer.json")
        assert length(plate / "longer.json") == pytest.approx(length(plate / "short.json") + times * 0.05, abs=1e-4)


def test_curves_of_polylines_are_joined_smoothly(run, plate, curve):
    edit(run, "--curve", "curve.json", "--split", "0.45", "--output", "part.ply")
    edit(run, "--curve", "part.ply", "--curve", "part-2.ply", "--join", "--smooth", "--output", "whole.json")
    assert length(plate / "whole.json") == pytest.approx(length(curve), rel=1e-3)


@pytest.mark.parametrize("status, words, part", [
    (2, (), "one of --reverse, --trim, --split, --join and --extend is required"),
    (2, ("--reverse", "--join"), "one of --reverse"),
    (2, ("--reverse", "--smooth"), "--smooth, --gap and --blend are for --join"),
    (2, ("--trim", "0.2"), "--trim"),
    (2, ("--split", "1.2"), "[0, 1]"),
    (2, ("--extend", "0"), "--extend"),
    (2, ("--extend", "0.1", "--at", "middle"), "start|end|both"),
    (1, ("--join",), "--join needs two curves or more"),
    (1, ("--trim", "0.7,0.2"), "no length"),
    (1, ("--join", "--curve", "far.json"), "apart"),
])
def test_what_is_refused(refused, run, plate, curve, status, words, part):
    edit(run, "--curve", "curve.json", "--trim", "0.4,0.6", "--output", "far.json")
    assert part in refused(status, "edit", "plate.ply", "--curve", "curve.json", *words, "--output", "out.json")
