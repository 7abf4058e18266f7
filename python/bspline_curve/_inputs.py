# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other packages as arrays. None of them is imported: a mesh is known by its attributes."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from ._arrays import Floats, points, shape_text, triangles
from ._errors import MeshError

Faces: TypeAlias = npt.NDArray[np.int32] | npt.NDArray[np.int64]


def mesh_arrays(given: Any, faces: npt.ArrayLike | None) -> tuple[Floats, Faces]:
    """Vertices (n, 3) and faces (m, 3), of two arrays or of a mesh."""
    if faces is not None:
        return points(given, "vertices", MeshError), triangles(faces)
    if isinstance(given, (tuple, list)) and len(given) == 2:
        return points(given[0], "vertices", MeshError), triangles(given[1])
    for is_such, parts in _KINDS:
        if is_such(given):
            vertices, corners = parts(given)
            return points(vertices, "vertices", MeshError), triangles(corners)
    raise TypeError(
        f"vertices is {type(given).__name__}: give vertices and faces as arrays, or a mesh of trimesh, pyvista, meshio or "
        "pymeshlab; Mesh.load() reads a file"
    )


def has(*names: str) -> Any:
    return lambda mesh: all(hasattr(mesh, name) for name in names)


def of_pymeshlab(mesh: Any) -> tuple[Any, Any]:
    return mesh.vertex_matrix(), mesh.face_matrix()


def of_document(document: Any) -> tuple[Any, Any]:
    return of_pymeshlab(document.current_mesh())


def of_meshio(mesh: Any) -> tuple[Any, Any]:
    blocks = [np.asarray(block.data) for block in mesh.cells if block.type == "triangle"]
    others = sorted({block.type for block in mesh.cells} - {"triangle", "line", "vertex"})
    if others or not blocks:
        raise MeshError(f"the mesh has cells of type {', '.join(others) or 'none'}, but must have triangles", "bad-array")
    return mesh.points, np.concatenate(blocks)


def of_pyvista(mesh: Any) -> tuple[Any, Any]:
    """Its faces are one array of counts and ids."""
    packed = np.asarray(mesh.faces)
    if packed.ndim == 2 and packed.shape[1] == 3:
        return mesh.points, packed
    if packed.ndim != 1 or len(packed) % 4 or (packed[::4] != 3).any():
        raise MeshError(
            f"the mesh has faces that are no triangles (an array of shape {shape_text(packed)}): call its triangulate()",
            "bad-array",
        )
    return mesh.points, packed.reshape(-1, 4)[:, 1:]


def of_trimesh(mesh: Any) -> tuple[Any, Any]:
    return mesh.vertices, mesh.faces


_KINDS = (
    (has("vertex_matrix", "face_matrix"), of_pymeshlab),
    (has("current_mesh"), of_document),
    (has("points", "cells_dict"), of_meshio),
    (has("vertices", "faces"), of_trimesh),
    (has("points", "faces"), of_pyvista),
)
