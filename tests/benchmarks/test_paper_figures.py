# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of docs/PAPER.md can be remade, and the stand-ins for other methods do what they are named after."""
import os
import re
import sys
from pathlib import Path

import cases  # on the path since conftest.py
import numpy as np
import pytest
from PIL import Image

BUILD = Path(os.environ.get("BSPLINE_CURVE_BUILD", Path(__file__).resolve().parents[2] / "build" / "release"))
sys.path.insert(0, str(BUILD / "python"))
bspline_curve = pytest.importorskip("bspline_curve", reason="needs the Python package of the build")
surface_baselines = pytest.importorskip("surface_baselines", reason="needs scipy")


@pytest.fixture(scope="module")
def plate():
    n = 21
    x, y = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n), indexing="ij")
    i, j = np.meshgrid(np.arange(n - 1), np.arange(n - 1), indexing="ij")
    a = (i * n + j).ravel()
    faces = np.concatenate([np.stack([a, a + n, a + n + 1], 1), np.stack([a, a + n + 1, a + 1], 1)])
    return bspline_curve.Mesh(np.stack([x, y, 0 * x], -1).reshape(-1, 3), faces)


def test_figures_are_drawn_and_told(script, tmp_path):
    done = script("paper_figures.py", "--only", 5, 13, 15, "--size", 60, "--images", tmp_path)
    assert done.returncode == 0, done.stderr
    assert "0 of which raise the energy within a round" in done.stdout
    assert "`paper` 1 crossing; `default` 1 crossing" in done.stdout
    costs = re.findall(r"`(?:paper|default)` ([\d.]+) without, ([\d.]+) with", done.stdout)
    assert len(costs) == 2 and all(float(after) < float(before) for before, after in costs), "curves keep off sharp features"
    for name in ("paper_05.png", "paper_13.png", "paper_15.png"):
        assert len(set(Image.open(tmp_path / name).convert("RGB").getdata())) > 20


def test_the_page_is_written_with_all_figures_alone(script):
    done = script("paper_figures.py", "--only", 5, "--size", 60, "--images", "/nonexistent", "--page")
    assert done.returncode != 0 and "--page needs all figures" in done.stderr


def test_phong_projection_of_a_flat_face_is_the_foot():
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    up = np.tile([0.0, 0, 1], (3, 1))
    np.testing.assert_allclose(surface_baselines.phong_point(corners, up, np.array([0.3, 0.2, 0.5])), [0.3, 0.2, 0], atol=1e-12)
    assert surface_baselines.phong_point(corners, up, np.array([0.8, 0.7, 0.5])) is None


def test_projected_splines_fall_apart_where_the_nearest_side_changes():
    vertices, faces = cases.bumpy_torus(90, 40)
    across = np.array([[1.36, 0, 0], [0.95, 0.95, 0.1], [-1.36, 0, 0]])  # a spline through the hole of the torus
    line = surface_baselines.projected_spline(bspline_curve.Mesh(vertices, faces), across[[0, 2, 1]])
    assert line.failed == 0 and len(line.parts()) > 1


def test_bezier_curves_on_a_plate_are_those_of_the_plane(plate):
    controls = np.array([[0.1, 0.1, 0], [0.3, 0.8, 0], [0.6, 0.9, 0], [0.9, 0.2, 0]])
    line = surface_baselines.bezier_by_geodesics(plate, controls, samples=5)
    t = np.linspace(0, 1, 5)[:, None]
    exact = ((1 - t) ** 3 * controls[0] + 3 * t * (1 - t) ** 2 * controls[1] + 3 * t ** 2 * (1 - t) * controls[2]
             + t ** 3 * controls[3])
    np.testing.assert_allclose(line, exact, atol=1e-9)


def test_the_level_set_goes_round_its_picks(plate):
    angle = np.linspace(0, 2 * np.pi, 6, endpoint=False)
    picks = np.stack([0.5 + 0.3 * np.cos(angle), 0.5 + 0.3 * np.sin(angle), 0 * angle], 1)
    lines = surface_baselines.heat_level_set(plate, picks, band=0.07)
    radius = np.linalg.norm(lines[0][:, :2] - 0.5, axis=1)
    assert 0.2 < radius.min() and radius.max() < 0.36
    winding = np.unwrap(np.arctan2(lines[0][:, 1] - 0.5, lines[0][:, 0] - 0.5))
    assert abs(abs(winding[-1] - winding[0]) - 2 * np.pi) < 1e-6
