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

from ._rendering import vertex_normals

if TYPE_CHECKING:
    from ._arrays import Floats
    from ._curve import Curve
    from ._mesh import Mesh

# A notebook waits for its pictures: of meshes with more faces there is none.
FACES_OF_PICTURES = 60_000
LINE_WIDTH = 5  # pixels
# Wide lines of segments that are shorter than a pixel have gaps: shorter ones than this share of the diagonal are joined,
# where they are straight to the other one.
SHORT, STRAIGHT = 0.006, 1e-4


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


def plot(curve: Curve, plotter: Any, **options: Any) -> Any:
    """A pyvista plotter or, where there is no pyvista, axes of matplotlib: new ones, or those that are given."""
    if hasattr(plotter, "plot_trisurf") or (plotter is None and find_spec("pyvista") is None):
        if find_spec("matplotlib") is None:
            raise ImportError("plot() needs pyvista or matplotlib: run pip install pyvista")
        return plot_by_matplotlib(curve, plotter, **options)
    if plotter is not None and not hasattr(plotter, "add_actor"):
        raise TypeError(f"plotter is {type(plotter).__name__}, but must be a Plotter of pyvista, or 3d axes of matplotlib")
    return plot_by_pyvista(curve, plotter, **options)


def in_front(shape: Any, **look: Any) -> Any:
    """An actor of pyvista that is seen before the surface that it lies on."""
    import pyvista

    mapper = pyvista.DataSetMapper(dataset=shape)
    mapper.SetScalarVisibility(False)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -400)
    mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-800)
    return pyvista.Actor(mapper=mapper, prop=pyvista.Property(lighting=False, **look))


def surface_of_pyvista(mesh: Mesh) -> Any:
    """The mesh as a PolyData."""
    import pyvista

    return pyvista.PolyData(np.array(mesh.vertices), np.c_[np.full(len(mesh.faces), 3), mesh.faces].ravel())


def thinned(points: Floats, diagonal: float) -> Floats:
    """A line as it is drawn: without segments so short that they would leave gaps."""
    along = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    step = np.floor(along / (SHORT * diagonal))
    kept = np.r_[True, step[1:] > step[:-1]]
    kept[-1] = True
    ends = np.flatnonzero(kept)
    before = np.searchsorted(ends, np.arange(len(points)), side="right") - 1
    start, end = points[ends[before]], points[ends[np.minimum(before + 1, len(ends) - 1)]]
    chord = end - start
    off = np.linalg.norm(np.cross(points - start, chord), axis=1)
    kept |= off > STRAIGHT * diagonal * np.linalg.norm(chord, axis=1)
    return points[kept]


def add_mesh(plotter: Any, mesh: Mesh) -> None:
    """Puts the mesh into a plotter, where it is not yet; behind lines on it, also where it slopes across their width."""
    name = f"bspline_curve mesh {mesh.checksum}"
    if name in plotter.actors:
        return
    surface = surface_of_pyvista(mesh)
    surface.point_data["Normals"] = vertex_normals(mesh.vertices, mesh.faces)
    surface.point_data.active_normals_name = "Normals"
    actor = plotter.add_mesh(surface, color="lightgray", name=name)
    actor.prop.interpolation = "phong"
    actor.mapper.SetResolveCoincidentTopologyToPolygonOffset()
    actor.mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(LINE_WIDTH, 0)


def plot_by_pyvista(curve: Curve, plotter: Any, **options: Any) -> Any:
    import pyvista

    given = pyvista.Plotter(**options) if plotter is None else plotter
    add_mesh(given, curve.mesh)
    line = curve.points if not curve.closed else np.concatenate([curve.points, curve.points[:1]])
    line = thinned(line, curve.mesh.diagonal)
    shape = pyvista.PolyData(line, lines=np.r_[len(line), np.arange(len(line))])
    given.add_actor(in_front(shape, color="firebrick", line_width=LINE_WIDTH), reset_camera=False, render=False)
    if len(curve.picks):
        picks = in_front(pyvista.PolyData(np.array(curve.picks)), color="navy", point_size=12, style="points")
        picks.prop.render_points_as_spheres = True
        given.add_actor(picks, reset_camera=False, render=False)
    return given


def plot_by_matplotlib(curve: Curve, axes: Any, **options: Any) -> Any:
    import matplotlib.pyplot as pyplot

    mesh = curve.mesh
    if axes is None:
        axes = pyplot.figure(**options).add_subplot(projection="3d")
        axes.plot_trisurf(*mesh.vertices.T, triangles=mesh.faces, color="lightgray", alpha=0.6, linewidth=0)
    line = curve.points if not curve.closed else np.concatenate([curve.points, curve.points[:1]])
    axes.plot(*line.T, color="firebrick", linewidth=2)
    axes.scatter(*curve.picks.T, color="navy")
    axes.set_aspect("equal")
    return axes
