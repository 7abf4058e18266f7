# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth curves along lines that exist, and along boundaries of faces and labels."""

import bspline_curve as bc
import numpy as np
import pytest


@pytest.fixture(scope="module")
def flat(wavy):
    return bc.Mesh(*wavy(61, height=0.0))


def middles(mesh):
    return mesh.vertices[mesh.faces].mean(1)[:, :2]


def test_a_boundary_is_near_the_circle_that_was_meant(flat):
    edge = np.linalg.norm(flat.vertices[1] - flat.vertices[0])
    (curve,) = flat.fit_boundary(np.hypot(*middles(flat).T) < 0.6)
    assert curve.closed and curve.usable
    assert np.sqrt(((np.hypot(*curve.points[:, :2].T) - 0.6) ** 2).mean()) < 0.2 * edge
    assert 0 < curve.report["line_distance"] <= 1.2 * edge
    by_ids = flat.fit_boundary(np.flatnonzero(np.hypot(*middles(flat).T) < 0.6))[0]
    assert np.array_equal(curve.points, by_ids.points)


def test_a_stroke_becomes_smooth_and_can_be_edited(mesh):
    rng = np.random.default_rng(4)
    x = np.linspace(-0.7, 0.7, 120)
    line = np.stack([x, 0.3 * np.sin(3 * x), 0 * x], 1)
    line[:, 2] = 0.2 * np.sin(3 * line[:, 0]) * np.cos(2 * line[:, 1])
    shaky = line + rng.normal(0, 0.008, line.shape)
    curve = mesh.fit(shaky, deviation=0.05)
    off = np.abs(curve.points[:, 1] - 0.3 * np.sin(3 * curve.points[:, 0]))
    assert np.sqrt((off**2).mean()) < 0.008
    assert np.allclose(curve.picks, curve.points[curve.pick_vertices])
    moved = curve.move(1, curve.picks[1] + [0, 0.02, 0])
    assert moved.usable and len(moved.picks) == len(curve.picks)


def test_a_line_is_draped_first_along_a_direction(mesh):
    x = np.linspace(-0.7, 0.7, 80)
    plan = np.stack([x, 0.3 * np.sin(3 * x), 9 + x], 1)
    with pytest.raises(bc.InputError, match="vertex 0 lies .* drape it along"):
        mesh.fit(plan)
    curve = mesh.fit(plan, direction=[0, 0, -1], deviation=0.05)
    assert np.abs(curve.points[:, 1] - 0.3 * np.sin(3 * curve.points[:, 0])).max() < 0.02
    with pytest.raises(bc.InputError, match="does not meet the mesh along the direction"):
        mesh.fit(plan, direction=[1, 0, 0])
    with pytest.raises(bc.InputError, match="2 curves, and one is needed"):
        mesh.fit([[-0.5, 0, 9], [-0.5, 5, 9], [0.5, 5, 9], [0.5, 0, 9]], direction=[0, 0, -1])


def test_a_right_angle_is_a_corner(flat):
    x, y = np.abs(middles(flat) @ np.array([[1, 1], [1, -1]]) / np.sqrt(2)).T
    (curve,) = flat.fit_boundary((x < 0.5) & (y < 0.5))
    assert len(curve.report["corner_turns"]) == 4
    assert np.abs(np.array(curve.report["corner_turns"]) - 90).max() < 30
    (smooth,) = flat.fit_boundary((x < 0.5) & (y < 0.5), corner_angle=180)
    assert smooth.report["corner_turns"] == []
    with pytest.raises(bc.InputError, match="corner_angle"):
        flat.fit_boundary((x < 0.5) & (y < 0.5), corner_angle=0)


def test_long_lines_take_no_longer_than_their_points_ask_for(flat):
    t = np.linspace(0, 1, 30000)
    radius, angle = 0.1 + 0.6 * t, 30 * t
    shaky = np.random.default_rng(1).normal(0, 0.004, (len(t), 2))
    line = np.stack([radius * np.cos(angle) + shaky[:, 0], radius * np.sin(angle) + shaky[:, 1], 0 * t], 1)
    curve = flat.fit(line, deviation=0.03)
    assert curve.usable and curve.report["line_distance"] <= 0.03 and len(curve.control_points) < 150


def test_labels_may_be_any_integers_and_meet_in_junctions(flat):
    angle = np.arctan2(*middles(flat).T)
    labels = np.array([5, -100, 2**40])[np.floor((angle + np.pi) / (2 * np.pi + 1e-9) * 3).astype(int)]
    curves = flat.fit_boundary(labels=labels)
    assert len(curves) == 3 and not any(curve.closed for curve in curves)
    ends = [tuple(point) for curve in curves for point in (curve.points[0], curve.points[-1])]
    assert max(ends.count(end) for end in ends) == 3


def test_what_is_wrong_is_said(flat, picks):
    with pytest.raises(bc.InputError, match="either faces or labels"):
        flat.fit_boundary()
    with pytest.raises(bc.InputError, match="no boundary"):
        flat.fit_boundary([])
    with pytest.raises(bc.InputError, match="labels has shape"):
        flat.fit_boundary(labels=[1, 2])
    with pytest.raises(bc.InputError, match="must be above 0"):
        flat.fit([[0, 0, 0], [0.5, 0, 0]], deviation=0)
    with pytest.raises(bc.InputError, match="larger deviation"):
        flat.fit([[-0.5, -0.5, 0], [0.5, -0.5, 0], [0.5, 0.5, 0]], closed=True, deviation=1e-6)


def test_long_work_is_cancelled(flat):
    t = np.linspace(0, 40, 20000)
    spiral = np.stack([t / 50 * np.cos(t), t / 50 * np.sin(t), 0 * t], 1)
    with pytest.raises(bc.Cancelled):
        flat.fit(spiral, progress=lambda fraction, stage: False)
