# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of curves: as bytes of a PNG for notebooks, and as plots of pyvista or matplotlib."""

from __future__ import annotations

import base64
import struct
import zlib
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from ._arrays import Floats
    from ._curve import Curve
    from ._mesh import Mesh

# A notebook waits for its pictures: of meshes with more faces there is none.
FACES_OF_PICTURES = 60_000


def png_bytes(pixels: npt.NDArray[np.uint8]) -> bytes:
    """(height, width, 3) as a PNG."""
    height, width, _ = pixels.shape
    rows = np.zeros((height, 1 + 3 * width), np.uint8)  # each begins with its filter: none
    rows[:, 1:] = pixels.reshape(height, -1)
    parts = [
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)),
        (b"IDAT", zlib.compress(rows.tobytes(), 6)),
        (b"IEND", b""),
    ]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)) for name, data in parts
    )


def view_of(curve: Curve) -> Floats:
    """Towards most of the curve: the mean normal of the faces that it passes, weighted by its lengths there."""
    mesh = curve.mesh
    corners = mesh.vertices[mesh.faces[curve.faces]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    lengths = np.linalg.norm(np.diff(curve.points, axis=0, append=curve.points[-1:]), axis=1)
    mean = (normals * lengths[:, None]).sum(0)
    # A curve around its mesh has no side: seen from where its first normal points then.
    return np.asarray(mean if np.linalg.norm(mean) > 0.05 * lengths.sum() else normals[0])


def picture(curve: Curve, size: tuple[int, int], supersampling: int = 2) -> npt.NDArray[np.uint8]:
    """Rows of pixels (height, width, 3)."""
    from ._rendering import curve_picture

    line = np.array(curve.points)
    if curve.closed:
        line = np.concatenate([line, line[:1]])
    view = view_of(curve)
    up = (0, 1, 0) if abs(view[1]) < 0.9 * np.linalg.norm(view) else (0, 0, 1)
    mesh = curve.mesh.vertices, curve.mesh.faces
    return curve_picture(mesh, line, curve.picks, view=view, up=up, size=size, width=0.006, supersampling=supersampling)


def html(curve: Curve) -> str:
    """The picture and a table, for notebooks; of large meshes the table alone."""
    rows = {
        "kind": "closed" if curve.closed else "open",
        "degree": curve.degree,
        "picks": len(curve.picks),
        "points": len(curve.points),
        "length": f"{curve.length:.6g}",
        "status": curve.report["status"],
        "usable": "yes" if curve.usable else "no",
    }
    table = "".join(f"<tr><th style='text-align:left'>{name}</th><td>{value}</td></tr>" for name, value in rows.items())
    image = ""
    if len(curve.mesh.faces) <= FACES_OF_PICTURES:
        encoded = base64.b64encode(png_bytes(picture(curve, (320, 280), 1))).decode()
        image = f"<img alt='the curve on its mesh' src='data:image/png;base64,{encoded}'>"
    return f"<div style='display:flex;gap:1em;align-items:center'>{image}<table>{table}</table></div>"


def plot(curve: Curve, **options: Any) -> Any:
    """A pyvista plotter or, where there is no pyvista, axes of matplotlib."""
    if find_spec("pyvista") is not None:
        return plot_by_pyvista(curve, **options)
    if find_spec("matplotlib") is not None:
        return plot_by_matplotlib(curve, **options)
    raise ImportError("plot() needs pyvista or matplotlib: run pip install pyvista")


def surface_of_pyvista(mesh: Mesh) -> Any:
    """The mesh as a PolyData."""
    import pyvista

    return pyvista.PolyData(np.array(mesh.vertices), np.c_[np.full(len(mesh.faces), 3), mesh.faces].ravel())


def plot_by_pyvista(curve: Curve, **options: Any) -> Any:
    import pyvista

    plotter = pyvista.Plotter(**options)
    plotter.add_mesh(surface_of_pyvista(curve.mesh), color="lightgray", smooth_shading=True)
    plotter.add_mesh(curve.to_pyvista(), color="firebrick", line_width=5)
    plotter.add_points(np.array(curve.picks), color="navy", point_size=12, render_points_as_spheres=True)
    return plotter


def plot_by_matplotlib(curve: Curve, **options: Any) -> Any:
    import matplotlib.pyplot as pyplot

    mesh = curve.mesh
    axes = pyplot.figure(**options).add_subplot(projection="3d")
    axes.plot_trisurf(*mesh.vertices.T, triangles=mesh.faces, color="lightgray", alpha=0.6, linewidth=0)
    line = curve.points if not curve.closed else np.concatenate([curve.points, curve.points[:1]])
    axes.plot(*line.T, color="firebrick", linewidth=2)
    axes.scatter(*curve.picks.T, color="navy")
    axes.set_aspect("equal")
    return axes
