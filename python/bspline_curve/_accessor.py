# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of pyvista draw curves by themselves: surface.bspline_curve.curve(picks). pyvista 0.48 and later imports this module
when it meets that name, by the entry point of the package."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pyvista

from ._curve import Curve
from ._inputs import mesh_arrays
from ._mesh import Mesh
from ._picker import pick

if TYPE_CHECKING:
    from ._arrays import Floats


@pyvista.register_dataset_accessor("bspline_curve", pyvista.PolyData)
class PolyDataAccessor:
    """Attached to each PolyData as `bspline_curve`; the surface is prepared at the first use, and again once its points or faces changed."""

    def __init__(self, surface: Any) -> None:
        self._surface = surface
        self._prepared: tuple[int, Mesh] | None = None  # and when the surface was changed last

    @property
    def mesh(self) -> Mesh:
        """The bspline_curve.Mesh of the surface."""
        changed = self._surface.GetMTime()
        if self._prepared is None:
            self._prepared = changed, Mesh(self._surface)
        elif self._prepared[0] != changed:
            mesh = self._prepared[1]
            vertices, faces = mesh_arrays(self._surface, None)
            is_same = np.array_equal(vertices, mesh.vertices) and np.array_equal(faces, mesh.faces)
            self._prepared = changed, mesh if is_same else Mesh(vertices, faces)
        return self._prepared[1]

    def curve(self, picks: Any, **options: Any) -> Curve:
        """Mesh.curve(); `field` may be the name of point data of the surface, too."""
        field = options.get("field")
        if isinstance(field, str) and field in self._surface.point_data:
            options["field"] = self._surface.point_data[field]
        return self.mesh.curve(picks, **options)

    def line(self, picks: Any, **options: Any) -> Any:
        """The curve as a PolyData of one line."""
        return self.curve(picks, **options).to_pyvista()

    def field(self, kind: str = "maximal-curvature", **options: Any) -> Floats:
        """Mesh.field()."""
        return self.mesh.field(kind, **options)  # type: ignore[arg-type]

    def pick(self, **options: Any) -> list[Curve]:
        """pick() on the surface."""
        return pick(self.mesh, **options)
