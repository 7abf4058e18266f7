# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves as objects of other packages, which are imported only here, when they are asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from ._curve import Curve


def to_pyvista(curve: Curve) -> Any:
    """One line cell; t, values, face and barycentric as point data."""
    import pyvista

    order: npt.NDArray[np.int64] = np.arange(len(curve.points))
    if curve.closed:
        order = np.append(order, 0)
    line = pyvista.PolyData(np.array(curve.points), lines=np.r_[len(order), order])
    for name, array in (("t", curve.t), ("values", curve.values), ("face", curve.faces), ("barycentric", curve.barycentrics)):
        line.point_data[name] = np.array(array)
    return line


def to_trimesh(curve: Curve) -> Any:
    """A Path3D with one entity."""
    import trimesh

    points = np.array(curve.points)
    if curve.closed:
        points = np.concatenate([points, points[:1]])
    return trimesh.load_path(points)


def to_meshio(curve: Curve) -> Any:
    """Cells of type "line"; t, values, face and barycentric as point data."""
    import meshio

    data = {"t": curve.t, "values": curve.values, "face": curve.faces, "barycentric": curve.barycentrics}
    return meshio.Mesh(
        np.array(curve.points),
        [("line", curve.segments())],
        point_data={name: np.array(array) for name, array in data.items()},
    )
