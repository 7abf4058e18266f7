# SPDX-License-Identifier: GPL-3.0-or-later
"""A curve on a mesh that is made here, as a picture."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ._arrays import Floats, Int32s
from ._curve import Curve
from ._errors import FileError
from ._mesh import Mesh
from ._picture import picture, png_bytes


def bumpy_torus(around: int = 120, across: int = 48) -> tuple[Floats, Int32s]:
    """Vertices and faces of a closed surface with a hole."""
    u = np.linspace(0, 2 * np.pi, around, endpoint=False)[:, None]
    v = np.linspace(0, 2 * np.pi, across, endpoint=False)
    radius = 0.4 + 0.05 * np.sin(5 * u) * np.cos(2 * v)
    vertices = np.stack([(1 + radius * np.cos(v)) * np.cos(u), (1 + radius * np.cos(v)) * np.sin(u), radius * np.sin(v)], -1)
    i, j = np.arange(around)[:, None], np.arange(across)
    right, up = (i + 1) % around, (j + 1) % across
    corners = [i * across + j, right * across + j, right * across + up, i * across + up]
    faces = np.stack([np.stack([corners[k] for k in some], -1) for some in ((0, 1, 2), (0, 2, 3))])
    return vertices.reshape(-1, 3), faces.reshape(-1, 3).astype(np.int32)


def draw_demo(output: Path, size: tuple[int, int]) -> Curve:
    """Draws the curve and writes its picture; size: width and height in pixels. Raises FileError."""
    if output.suffix.lower() != ".png":
        raise FileError(f"{output}: a picture is written as .png", "unwritable-file")
    if not output.absolute().parent.is_dir():  # said before the work is done
        raise FileError(f"{output} cannot be written: there is no folder {output.parent}", "unwritable-file")
    mesh = Mesh(*bumpy_torus())
    angles = np.linspace(0, 2 * np.pi, 9, endpoint=False)
    wave = 0.5 * np.pi + 0.9 * np.sin(2 * angles)
    ring = np.stack([(1 + 0.4 * np.cos(wave)) * np.cos(angles), (1 + 0.4 * np.cos(wave)) * np.sin(angles), 0.4 * np.sin(wave)], -1)
    curve = mesh.curve(mesh.project(ring).points, closed=True)
    try:
        output.write_bytes(png_bytes(picture(curve, size)))
    except OSError as error:
        raise FileError(f"{output} cannot be written: {error}", "unwritable-file") from error
    return curve
