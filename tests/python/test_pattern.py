# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings carried to a mesh."""
import numpy as np
import pytest
from bspline_curve import FileError, InputError, Mesh, OptionError

STAR = "M0 -4 L1 -1 L4 0 L1 1 L0 4 L-1 1 L-4 0 L-1 -1Z"


@pytest.fixture(scope="module")
def plate():
    x, y = np.meshgrid(np.linspace(0, 1, 13), np.linspace(0, 1, 13), indexing="ij")
    vertices = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    corner = (np.arange(12)[:, None] * 13 + np.arange(12)).reshape(-1, 1)
    return Mesh(vertices, np.concatenate([corner + [0, 13, 14], corner + [0, 14, 1]]))


def test_path_data_and_polylines_and_files_are_the_same_drawing(plate, tmp_path):
    (tmp_path / "star.svg").write_text(f"<svg xmlns='http://www.w3.org/2000/svg'><g><path d='{STAR}'/></g></svg>")
    corners = np.array([[0, 4], [1, 1], [4, 0], [1, -1], [0, -4], [-1, -1], [-4, 0], [-1, 1], [0, 4]], float)
    patterns = [
        plate.pattern(drawing, centre=[0.5, 0.4, 0], size=0.4) for drawing in (STAR, [corners], tmp_path / "star.svg")
    ]
    for pattern in patterns:
        assert len(pattern.curves) == 8
        assert pattern.paths.tolist() == pattern.copies.tolist() == [0] * 8
        for a, b, curve in zip(corners, corners[1:], pattern.curves):
            ends = [0.5, 0.4] + 0.05 * np.array([a, b])
            np.testing.assert_allclose(curve.points[[0, -1], :2], ends, atol=1e-9)
    assert patterns[0].shortest.ratio == pytest.approx(1, abs=1e-6)
    assert patterns[0].longest.position.shape == (3,)


def test_along_a_curve(plate):
    line = plate.curve([[0.1, 0.5, 0], [0.9, 0.5, 0]])
    pattern = plate.pattern([[[0, 0], [1, 0], [0.5, 1], [0, 0]]], along=line, repeat=4, size=0.1, shift=0.2)
    assert pattern.copies.tolist() == [0] * 3 + [1] * 3 + [2] * 3 + [3] * 3
    starts = np.array([curve.points[0] for curve in pattern.curves[::3]])
    np.testing.assert_allclose(starts[:, 0], np.linspace(0.1, 0.8, 4), atol=1e-6)
    np.testing.assert_allclose(starts[:, 1], 0.65, atol=1e-6)  # its middle is 0.2 to the left


def test_its_curves_are_curves_of_the_mesh(plate):
    pattern = plate.pattern(STAR, centre=[0.5, 0.5, 0], size=0.4)
    assert len(plate.segment(pattern.curves).parts) == 2
    assert all(curve.usable for curve in pattern.curves)


def test_refusals(plate, tmp_path):
    other = Mesh(plate.vertices, plate.faces)
    line = other.curve([[0.1, 0.5, 0], [0.9, 0.5, 0]])
    (tmp_path / "bad.svg").write_text("<svg><path d='M0 0L1'/></svg>")
    (tmp_path / "worse.svg").write_text("<svg>")
    centre = [0.5, 0.5, 0]
    for error, said, arguments in [
        (InputError, "centre and along", {}),
        (InputError, "centre and along", {"centre": centre, "along": line}),
        (InputError, "another mesh", {"along": line}),
        (InputError, "centre must be", {"centre": [0, 0]}),
        (InputError, "away from the mesh", {"centre": [0, 0, 5]}),
        (InputError, "path 0", {"centre": centre, "size": 3}),
        (OptionError, "size", {"centre": centre, "size": -1}),
        (OptionError, "exclude", {"centre": centre, "size": 1, "scale": 1}),
        (OptionError, "corner_angle", {"centre": centre, "corner_angle": 0}),
        (OptionError, "path data", {"drawing": "M0 0X", "centre": centre}),
        (InputError, r"drawing\[0\]", {"drawing": [[1, 2]], "centre": centre}),
        (FileError, "read from .svg", {"drawing": "x.png", "centre": centre}),
        (FileError, "no.svg", {"drawing": tmp_path / "no.svg", "centre": centre}),
        (FileError, "line 1: <path>", {"drawing": tmp_path / "bad.svg", "centre": centre}),
        (FileError, "not XML", {"drawing": tmp_path / "worse.svg", "centre": centre}),
    ]:
        with pytest.raises(error, match=said):
            plate.pattern(**{"drawing": STAR, **arguments})
