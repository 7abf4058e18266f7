# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth B-spline curves through picked points on triangle meshes.

`draw_curve` and `compute_field` take and return numpy arrays. The import also loads the plugin into pymeshlab and makes its
filters methods of `pymeshlab.MeshSet`: `generate_bspline_curve_on_surface`, `compute_scalar_field_for_curves_per_vertex`, and
those that use curves, `imprint_curves`, `cut_along_curves`, `segment_by_curves` and `offset_curve_on_surface`.
"""

from .curve import Curve, Tube
from .description import CURVE, FIELD
from .errors import CurveError, HostError
from .filters import compute_field, draw_curve
from .host import check_host, load_plugin
from .methods import bind

__all__ = ["Curve", "CurveError", "HostError", "Tube", "compute_field", "draw_curve"]

check_host()
load_plugin((CURVE, FIELD))
bind()
