# SPDX-License-Identifier: GPL-3.0-or-later
"""A curve on the bunny that pymeshlab carries, as a picture."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pymeshlab
from bspline_curve._rendering import curve_picture

from .curve import Curve
from .filters import draw_curve

BUNNY = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes" / "bunny.obj"
PICKS = Path(__file__).parent / "bunny.pp"


def draw_demo(output: Path, size: tuple[int, int]) -> Curve:
    """Draws the curve and writes its picture; size: width and height in pixels.

    Raises
    ------
    RuntimeError
        Pillow, the directory or pymeshlab's bunny is not there, or the name ends with no format that Pillow knows.
    OSError
        The picture cannot be written.
    """
    try:
        from PIL import Image
    except ImportError as error:
        raise RuntimeError("Pillow, which writes the picture, is not installed: run pip install pillow") from error
    if output.suffix.lower() not in Image.registered_extensions():
        raise RuntimeError(f"{output}: no format of pictures has the extension {output.suffix!r}; .png will do")
    if not output.parent.is_dir():
        raise RuntimeError(f"{output}: the directory {output.parent} does not exist")
    if not BUNNY.is_file():
        raise RuntimeError(f"{BUNNY}, which the demo draws on, is not there: install pymeshlab again")
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(BUNNY))
    mesh = document.current_mesh().vertex_matrix(), document.current_mesh().face_matrix()
    points = ElementTree.parse(PICKS).getroot().findall("point")
    picks = np.array([[float(point.attrib[axis]) for axis in "xyz"] for point in points])
    curve = draw_curve(*mesh, picks)
    pixels = curve_picture(mesh, curve.points, picks, view=(-0.25, 0.28, 1), size=size)
    Image.fromarray(pixels).save(output)
    return curve
