# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth B-spline curves through picked points on triangle meshes.

    mesh = bspline_curve.Mesh(vertices, faces)
    curve = mesh.curve(picks, closed=True)
    curve.points, curve.faces, curve.barycentrics, curve.t
    moved = curve.move(2, point)
"""

from ._core import __version__
from ._curve import Curve
from ._errors import Cancelled, FieldError, FileError, InputError, MeshError, OptionError, PickError
from ._files import load
from ._mesh import Mesh, Repair, repair

__all__ = [
    "Cancelled",
    "Curve",
    "FieldError",
    "FileError",
    "InputError",
    "Mesh",
    "MeshError",
    "OptionError",
    "PickError",
    "Repair",
    "__version__",
    "load",
    "repair",
]
