# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth B-spline curves through picked points on triangle meshes.

    mesh = bspline_curve.Mesh(vertices, faces)
    curve = mesh.curve(picks, closed=True)
    curve.points, curve.faces, curve.barycentrics, curve.t
    moved = curve.move(2, point)
"""

from ._core import __version__
from ._curve import Curve, Samples
from ._errors import Cancelled, FieldError, FileError, InputError, MeshError, MeshWarning, OptionError, PickError
from ._files import load, load_all
from ._imprint import Cut, Imprint, Part
from ._mesh import Mesh, Repair, repair
from ._pattern import Distortion, Pattern
from ._picker import Picker, pick

__all__ = [
    "Cancelled",
    "Curve",
    "Cut",
    "Distortion",
    "FieldError",
    "FileError",
    "Imprint",
    "InputError",
    "Mesh",
    "MeshError",
    "MeshWarning",
    "OptionError",
    "Part",
    "Pattern",
    "PickError",
    "Picker",
    "Repair",
    "Samples",
    "__version__",
    "load",
    "load_all",
    "pick",
    "repair",
]
