# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the built plugin into the real pymeshlab, once; meshes and picks for the tests."""
import numpy as np
import pymeshlab
import pytest
from meshes import wavy_plate


@pytest.fixture(scope="session", autouse=True)
def plugins(loaded_plugin, build_folder):
    path = build_folder / "tests" / "plugin" / "libprepare_layers.so"
    assert path.is_file(), f"{path} is not there: build it, or set BSPLINE_CURVE_BUILD"
    pymeshlab.load_plugin(str(path))


@pytest.fixture
def plate():
    """A new document with the plate as its only layer."""
    vertices, faces = wavy_plate()
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(vertices, faces), "plate")
    return document


@pytest.fixture
def plate_picks():
    """Vertices of the plate, and one point inside a face."""
    vertices, faces = wavy_plate()
    ids = [4 * 41 + 5, 15 * 41 + 30, 36 * 41 + 20]
    inside = vertices[faces[1000]].mean(0)
    return np.array([vertices[ids[0]], vertices[ids[1]], inside, vertices[ids[2]]])
