# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes made by formula."""
import numpy as np


def wavy_plate(n=40):
    """A unit square with gentle hills, n by n squares cut in two."""
    x, y = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1), indexing="ij")
    z = 0.05 * np.sin(5 * x) * np.cos(4 * y)
    vertices = np.stack([x, y, z], -1).reshape(-1, 3)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    b, c, d = a + n + 1, a + n + 2, a + 1
    return vertices, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
