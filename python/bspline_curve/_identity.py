# SPDX-License-Identifier: GPL-3.0-or-later
"""By what a mesh is known again: curves belong to every mesh that is equal to theirs, also in another process."""

from __future__ import annotations

import threading
import weakref
from typing import TYPE_CHECKING, NamedTuple

from ._errors import InputError
from ._options import Value

if TYPE_CHECKING:
    from ._mesh import Mesh

# Meshes that somebody still holds, so that a curve that came without its mesh finds it.
_living: weakref.WeakSet[Mesh] = weakref.WeakSet()
_lock = threading.Lock()


def remember(mesh: Mesh) -> None:
    with _lock:
        _living.add(mesh)


class AbsentMesh(NamedTuple):
    """The mesh of a curve that was pickled: what it is known by."""

    vertices: int
    faces: int
    crc32: int
    options: dict[str, Value]

    def found(self) -> Mesh:
        """An equal mesh of this process, prepared with the same options."""
        with _lock:
            meshes = list(_living)
        for mesh in meshes:
            if mesh._options == self.options and not difference(self, mesh):
                return mesh
        raise InputError(
            f"this curve came without its mesh ({self.faces} faces), and no such mesh is there: make the mesh, and give it "
            "by curve.on(mesh)",
            "no-mesh",
        )


def name_of(mesh: Mesh) -> AbsentMesh:
    return AbsentMesh(len(mesh.vertices), len(mesh.faces), mesh._core.checksum, mesh._options)


def require_mesh(mesh: object) -> None:
    if not hasattr(mesh, "_core") or not hasattr(mesh, "checksum"):
        raise TypeError(f"mesh is {type(mesh).__name__}, but must be a Mesh")


def difference(home: Mesh | AbsentMesh, mesh: Mesh) -> str:
    """How a mesh differs from that of a curve, for messages; empty where they are equal. O(n) once for each mesh."""
    if home is mesh:
        return ""
    require_mesh(mesh)
    counts = home if isinstance(home, AbsentMesh) else None
    before = (counts.faces, counts.vertices) if counts else (len(home.faces), len(home.vertices))  # type: ignore[arg-type]
    for then, now, what in zip(before, (len(mesh.faces), len(mesh.vertices)), ("faces", "vertices")):
        if then != now:
            return f"that one has {then} {what}, this one has {now}"
    crc32 = counts.crc32 if counts else home._core.checksum  # type: ignore[union-attr]
    return "" if crc32 == mesh._core.checksum else "its coordinates, its faces or their order are others"
