# SPDX-License-Identifier: GPL-3.0-or-later
"""The path that a curve starts from follows the field, unless it is told not to."""

import json

import made_meshes as meshes
import numpy as np
import pytest
from curve_files import read_ply


@pytest.fixture
def road(tmp_path):
    """A plate where a road along y = 0.7 costs nothing, and all else as much everywhere; two picks beside the road."""
    V, F = meshes.plate(cells=40)
    meshes.write_ply(tmp_path / "plate.ply", V, F, quality=np.clip(np.abs(V[:, 1] - 0.7) / 0.1, 0, 1))
    (tmp_path / "picks.json").write_text(json.dumps({"picks": [[0.05, 0.5, 0], [0.95, 0.5, 0]]}))
    return tmp_path


def drawn(run, folder, *words):
    """Largest distance of the curve from the straight line between the picks, and its mean cost."""
    process = run("plate.ply", "--picks", "picks.json", "--field", "quality", "--output", "curve.ply",
                  "--report", "r.json", *words)
    assert process.returncode == 0, process.stderr
    report = json.loads((folder / "r.json").read_text())
    return np.abs(read_ply(folder / "curve.ply")["vertex"]["y"] - 0.5).max(), report["field"]["mean_cost"]


def test_the_first_path_takes_the_road(run, road):
    away, cost = drawn(run, road)
    assert away > 0.15 and cost < 0.5
    assert drawn(run, road, "--field-guides-path", "on") == (away, cost)
    # Between the picks the field is flat, so nothing pulls a curve that starts there.
    away, cost = drawn(run, road, "--field-guides-path", "off")
    assert away < 1e-6 and abs(cost - 1) < 1e-6


def test_quality_is_followed_only_where_it_is_asked_for(run, road):
    draw = ["plate.ply", "--picks", "picks.json", "--output"]
    automatic = run(*draw, "auto.ply", "--field", "auto", "--report", "r.json")
    assert automatic.stderr == "bspline_curve: note: the curve follows the quality of plate.ply\n"
    assert json.loads((road / "r.json").read_text())["field"]["kind"] == "quality"
    assert "note" not in run(*draw, "asked.ply", "--field", "quality").stderr
    y = [read_ply(road / name)["vertex"]["y"] for name in ("auto.ply", "asked.ply")]
    assert np.allclose(*y, rtol=0, atol=1e-9)
    assert "note" not in run(*draw, "none.ply").stderr
    assert np.abs(read_ply(road / "none.ply")["vertex"]["y"] - 0.5).max() < 1e-9


def test_the_option_is_on_or_off(run, road):
    process = run("plate.ply", "--picks", "picks.json", "--output", "curve.ply", "--field-guides-path", "yes")
    assert process.returncode == 2 and "yes is none of preset|off|on" in process.stderr
