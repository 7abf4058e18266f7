# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays as the core takes them: checked, and copied only where type or layout ask for it."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from operator import attrgetter
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import numpy.typing as npt

from ._errors import FieldError, InputError, MeshError, PickError

if TYPE_CHECKING:
    from ._mesh import Mesh

Floats: TypeAlias = npt.NDArray[np.float64]
Int32s: TypeAlias = npt.NDArray[np.int32]
SurfacePoints: TypeAlias = Sequence[tuple[int, Sequence[float]]]
Picks: TypeAlias = "npt.ArrayLike | SurfacePoints"


def file_name(file: Any) -> str:
    """Of a str or a path."""
    if not isinstance(file, (str, os.PathLike)):
        raise TypeError(f"file is {file!r}, but must be a str or a path")
    return os.fspath(file)


def of_core(name: str) -> Any:
    """An attribute that is that of `_core`, and cannot be set."""
    return property(attrgetter(f"_core.{name}"))


def shape_text(array: npt.NDArray[Any]) -> str:
    return "(" + ", ".join(map(str, array.shape)) + ("," if array.ndim == 1 else "") + ")"


def numbers(given: npt.ArrayLike, name: str, error: type[InputError] = InputError) -> Floats:
    """As doubles in C order; text, complex numbers and rows of different lengths are refused."""
    if type(given) is np.ndarray and given.dtype == np.float64 and given.flags.c_contiguous:
        return given
    try:
        array = np.asarray(given)
    except ValueError as reason:
        raise error(f"{name} is no array: {reason}", "bad-array") from reason
    if array.dtype.kind not in "biuf":
        if array.ndim == 0:
            raise error(f"{name} is {given!r}, but must be an array of numbers", "bad-array")
        raise error(f"{name} holds {array.dtype}, but must hold numbers", "bad-array")
    return np.ascontiguousarray(array, dtype=np.float64)


def rows_of_three(array: npt.NDArray[Any], name: str, letter: str, error: type[InputError]) -> None:
    if array.ndim != 2 or array.shape[1] != 3:
        raise error(f"{name} has shape {shape_text(array)}, but must have ({letter}, 3)", "bad-array")


def points(given: npt.ArrayLike, name: str, error: type[InputError] = InputError) -> Floats:
    """(n, 3)."""
    array = numbers(given, name, error)
    rows_of_three(array, name, "n", error)
    return array


def finite_points(given: npt.ArrayLike, name: str, error: type[InputError], kind: str) -> Floats:
    """(n, 3), every number finite."""
    array = points(given, name, error)
    if not np.isfinite(array).all():
        bad = np.flatnonzero(~np.isfinite(array).all(axis=1))
        text = f"{name}[{bad[0]}] is {array[bad[0]].tolist()}, but must be finite ({len(bad)} such in all)"
        raise error(text, "non-finite-coordinate", kind, bad.tolist())
    return array


def triangles(given: npt.ArrayLike) -> npt.NDArray[np.int32] | npt.NDArray[np.int64]:
    """(m, 3) in C order, as int32 or int64; the core checks the ids."""
    array = np.asarray(given)
    if array.size and array.dtype.kind not in "iu":
        raise MeshError(f"faces holds {array.dtype}, but must hold integers", "bad-array")
    rows_of_three(array, "faces", "m", MeshError)
    if array.dtype == np.int32:
        return np.ascontiguousarray(array, dtype=np.int32)
    if array.dtype == np.uint64 and array.size and array.max() > np.iinfo(np.int64).max:
        bad = np.flatnonzero((array > np.iinfo(np.int64).max).any(axis=1))
        raise MeshError("faces names vertices that are not there", "index-out-of-range", "faces", bad.tolist())
    return np.ascontiguousarray(array, dtype=np.int64)


def per_vertex(given: npt.ArrayLike, name: str, vertices: int) -> Floats:
    """(n,), a finite value for each vertex."""
    array = numbers(given, name, FieldError)
    if array.shape != (vertices,):
        text = f"{name} has shape {shape_text(array)}, but must have ({vertices},), a value for each vertex"
        raise FieldError(text, "bad-array")
    if not np.isfinite(array).all():
        bad = np.flatnonzero(~np.isfinite(array))
        text = f"{name}[{bad[0]}] is {array[bad[0]]}, but must be finite ({len(bad)} such in all)"
        raise FieldError(text, "bad-field", "vertices", bad.tolist())
    return array


def face_ids(given: npt.ArrayLike, name: str, faces: int) -> Int32s:
    """Ids of faces, from such or from a bool for each face."""
    array = np.asarray(given)
    if array.dtype == np.bool_:
        if array.shape != (faces,):
            text = f"{name} has shape {shape_text(array)}, but must have ({faces},), a bool for each face"
            raise InputError(text, "bad-array")
        return np.flatnonzero(array).astype(np.int32)
    if array.size and array.dtype.kind not in "iu":
        raise InputError(f"{name} holds {array.dtype}, but must hold ids of faces, or a bool for each", "bad-array")
    if array.ndim != 1:
        raise InputError(f"{name} has shape {shape_text(array)}, but must have (k,), ids of faces", "bad-array")
    bad = np.flatnonzero((array < 0) | (array >= faces))
    if len(bad):
        text = f"{name}[{bad[0]}] is {array[bad[0]]}, but there are {faces} faces, counted from 0"
        raise InputError(text, "index-out-of-range", "faces", sorted({int(each) for each in array[bad]}))
    return np.ascontiguousarray(array, dtype=np.int32)


def is_surface_point(given: object) -> bool:
    """(face, barycentrics)."""
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        return False
    return np.ndim(given[0]) == 0 and np.shape(given[1]) == (3,)


def one_pick(given: Any, mesh: Mesh, index: int) -> Floats:
    """A pick as a point: (3,), or (face, barycentrics)."""
    is_point = isinstance(given, np.ndarray) and given.dtype == np.float64 and given.shape == (3,)
    if is_point and all(map(math.isfinite, given.tolist())):
        point: Floats = given
        return point  # at once: a drag has no time
    vertices, faces = mesh.vertices, mesh.faces
    if not is_surface_point(given):
        point = finite_points(numbers(given, f"picks[{index}]", PickError)[None], "picks", PickError, "picks")
        return np.asarray(point[0])
    if not isinstance(given[0], (int, float, np.integer, np.floating)) or not np.isfinite(given[0]):
        raise PickError(f"picks[{index}] is in face {given[0]!r}, but a face is a number", "index-out-of-range", "picks", [index])
    face, weights = given[0], finite_points([given[1]], "picks", PickError, "picks")[0]
    if face != int(face) or not 0 <= face < len(faces):
        text = f"picks[{index}] is in face {face}, but there are {len(faces)} faces, counted from 0"
        raise PickError(text, "index-out-of-range", "picks", [index])
    if weights.min() < 0 or abs(weights.sum() - 1) > 1e-6:
        text = f"picks[{index}] has barycentric coordinates {weights.tolist()}, but they must be in [0, 1] with sum 1"
        raise PickError(text, "bad-array", "picks", [index])
    return np.asarray(weights @ vertices[faces[int(face)]])


def pick_points(given: Any, mesh: Mesh) -> Floats:
    """(p, 3) and finite, from points or from pairs (face, barycentrics)."""
    if isinstance(given, (tuple, list)) and len(given) and is_surface_point(given[0]):
        return np.stack([one_pick(each, mesh, i) for i, each in enumerate(given)])
    return finite_points(given, "picks", PickError, "picks")
