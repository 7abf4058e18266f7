# SPDX-License-Identifier: GPL-3.0-or-later
"""The package bspline_curve as the build leaves it, and meshes made here."""
import os
import sys
from pathlib import Path

import numpy as np
import pytest

BUILD = Path(os.environ.get("BSPLINE_CURVE_BUILD", Path(__file__).resolve().parents[2] / "build" / "release"))
sys.path.insert(0, str(BUILD / "python"))


def wavy_square(n, height=0.2, low=-1):
    """An open, wavy square from low to 1."""
    x, y = np.meshgrid(np.linspace(low, 1, n), np.linspace(low, 1, n), indexing="ij")
    vertices = np.stack([x, y, height * np.sin(3 * x) * np.cos(2 * y)], axis=-1).reshape(-1, 3)
    corner = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).reshape(-1, 1)
    return vertices, np.concatenate([corner + [0, n, n + 1], corner + [0, n + 1, 1]]).astype(np.int32)


@pytest.fixture(scope="session")
def wavy():
    return wavy_square


@pytest.fixture(scope="session")
def arrays():
    return wavy_square(41)


@pytest.fixture(scope="session")
def mesh(arrays):
    import bspline_curve

    return bspline_curve.Mesh(*arrays)


@pytest.fixture(scope="session")
def picks(arrays):
    return arrays[0][[45, 700, 850, 1500]]
