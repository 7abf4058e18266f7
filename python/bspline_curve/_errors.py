# SPDX-License-Identifier: GPL-3.0-or-later
"""What is raised where an argument is wrong."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Sequence


class InputError(ValueError):
    """An argument is wrong; the message says which, where, and what to do.

    Attributes
    ----------
    code : str
        The kind of defect: "pick-too-far", "non-manifold-edge", "bad-option" …
    vertices, faces, picks : tuple of int
        Ids of what is wrong, from 0 on, ascending: every one, not only those in the message, which counts picks from 1.
    """

    def __init__(self, message: str, code: str = "bad-argument", kind: str = "", elements: Sequence[int] = ()) -> None:
        super().__init__(message)
        self.code = code
        ids = tuple(elements)
        self.vertices: tuple[int, ...] = ids if kind == "vertices" else ()
        self.faces: tuple[int, ...] = ids if kind == "faces" else ()
        self.picks: tuple[int, ...] = ids if kind == "picks" else ()

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), self.args, self.__dict__


class MeshError(InputError):
    """The mesh cannot be drawn on: `vertices` or `faces` say where."""


class MeshWarning(UserWarning):
    """A mesh was mended so that it can be drawn on, or is not parted or raised as it seems; the message says how."""


class PickError(InputError):
    """No curve can pass these picks: `picks` says which, as indices from 0; the message counts them from 1."""


class FieldError(InputError):
    """A field is wrong or cannot be computed: `vertices` or `faces` say where."""


class OptionError(InputError):
    """The value of an option is not allowed."""


class FileError(InputError):
    """A file cannot be read or written."""


class Cancelled(Exception):
    """The progress function returned False."""


# Of each code of the core: the class, and what its elements are.
_CODES: dict[str, tuple[type[InputError], str]] = {
    "empty-mesh": (MeshError, ""),
    "non-finite-coordinate": (MeshError, "vertices"),
    "index-out-of-range": (MeshError, "faces"),
    "degenerate-face": (MeshError, "faces"),
    "non-manifold-edge": (MeshError, "faces"),
    "non-manifold-vertex": (MeshError, "vertices"),
    "inconsistent-orientation": (MeshError, "faces"),
    "self-intersection": (MeshError, "faces"),
    "too-few-picks": (PickError, "picks"),
    "pick-too-far": (PickError, "picks"),
    "coincident-picks": (PickError, "picks"),
    "picks-on-different-components": (PickError, "picks"),
    "pick-avoided": (PickError, "picks"),
    "no-path": (PickError, "picks"),
    "bad-field": (FieldError, "vertices"),
    "bad-option": (OptionError, ""),
    "unreadable-file": (FileError, ""),
    "unwritable-file": (FileError, ""),
    "no-shell": (MeshError, "faces"),
}


def input_error(code: str, message: str, elements: Sequence[int]) -> InputError:
    """The exception for an error of the core."""
    kind, noun = _CODES[code]
    return kind(message, code, noun, elements)


def warn(notes: Iterable[str], level: int) -> None:
    """What people must know, as warnings at a line of the caller: 1 is that of the function that calls this."""
    for note in notes:
        warnings.warn(note, MeshWarning, level + 1)
