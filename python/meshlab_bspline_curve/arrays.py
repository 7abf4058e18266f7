# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays checked before they go to a filter: what is wrong, and where."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Floats: TypeAlias = npt.NDArray[np.float64]
Int32s: TypeAlias = npt.NDArray[np.int32]
Integers: TypeAlias = npt.NDArray[np.int64]


def shape_text(array: npt.NDArray[np.generic]) -> str:
    return "(" + ", ".join(map(str, array.shape)) + ("," if array.ndim == 1 else "") + ")"


def numbers(given: npt.ArrayLike, name: str) -> Floats:
    """As doubles; text, complex numbers and rows of different lengths are refused."""
    try:
        array = np.asarray(given)
    except ValueError as error:
        raise ValueError(f"{name} is no array: {error}") from error
    if array.dtype.kind not in "biuf":
        raise ValueError(f"{name} holds {array.dtype}, but must hold numbers")
    return array.astype(np.float64)


def points(given: npt.ArrayLike, name: str) -> Floats:
    """(n, 3) and finite."""
    array = numbers(given, name)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} has shape {shape_text(array)}, but must have (n, 3)")
    bad = np.flatnonzero(~np.isfinite(array).all(axis=1))
    if len(bad):
        raise ValueError(f"{name}[{bad[0]}] is {array[bad[0]].tolist()}, but must be finite ({len(bad)} such in all)")
    return array


def per_vertex(given: npt.ArrayLike, name: str, vertices: int) -> Floats:
    """(n,), one for each vertex."""
    array = numbers(given, name)
    if array.shape != (vertices,):
        raise ValueError(f"{name} has shape {shape_text(array)}, but must have ({vertices},), a value for each vertex")
    return array


def integers(given: npt.ArrayLike, name: str) -> Integers:
    array = np.asarray(given)
    if array.size == 0:
        return array.astype(np.int64)
    if array.dtype.kind not in "iu":
        raise ValueError(f"{name} holds {array.dtype}, but must hold integers")
    return array.astype(np.int64)


def triangles(given: npt.ArrayLike, vertices: int) -> Int32s:
    """(m, 3), ids of vertices."""
    array = integers(given, "faces")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"faces has shape {shape_text(array)}, but must have (m, 3)")
    bad = np.argwhere((array < 0) | (array >= vertices))
    if len(bad):
        row, column = bad[0]
        raise ValueError(
            f"faces[{row}, {column}] is {array[row, column]}, but there are {vertices} vertices, counted from 0"
        )
    return array.astype(np.int32)


def face_mask(given: npt.ArrayLike, name: str, faces: int) -> npt.NDArray[np.bool_]:
    """One bool for each face, from such or from ids of faces."""
    array = np.asarray(given)
    if array.dtype == np.bool_:
        if array.shape != (faces,):
            raise ValueError(f"{name} has shape {shape_text(array)}, but must have ({faces},), a bool for each face")
        return array
    ids = integers(given, name)
    if ids.ndim != 1:
        raise ValueError(f"{name} has shape {shape_text(ids)}, but must have (k,), ids of faces")
    bad = np.flatnonzero((ids < 0) | (ids >= faces))
    if len(bad):
        raise ValueError(f"{name}[{bad[0]}] is {ids[bad[0]]}, but there are {faces} faces, counted from 0")
    mask = np.zeros(faces, dtype=np.bool_)
    mask[ids] = True
    return mask
