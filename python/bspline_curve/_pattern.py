# SPDX-License-Identifier: GPL-3.0-or-later
"""Planar drawings carried to a mesh."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Floats, Int32s, numbers
from ._curve import Curve
from ._drawing import Drawing
from ._errors import FileError, InputError
from ._lines import Line, curve_on
from ._options import Option, Progress, checked_number
from ._text import text_drawing

if TYPE_CHECKING:
    from ._mesh import Mesh

Planar: TypeAlias = "str | os.PathLike[str] | Sequence[npt.ArrayLike]"

OPTIONS = {
    "size": Option("double", 0.0, 0.0, None, False, ()),
    "scale": Option("double", 0.0, 0.0, None, False, ()),
    "repeat": Option("int", 0, 0, 100000, False, ()),
    "spacing": Option("double", 0.0, 0.0, None, False, ()),
    "start": Option("double", 0.0, 0.0, None, False, ()),
    "shift": Option("double", 0.0, None, None, False, ()),
    "corner_angle": Option("double", 20.0, 0.0, 179.0, True, ()),
    "tolerance": Option("double", 0.0, 0.0, None, False, ()),
    "smoothing": Option("int", 0, 0, 1000, False, ()),
}


class Distortion(NamedTuple):
    """A part of a curve, between two picks, and how long it is relative to what was drawn.

    Attributes
    ----------
    ratio : float
        Its length on the mesh by its length in the drawing: 1 where nothing is distorted.
    path : int
        Of the drawing, from 0.
    copy : int
        Of the drawing along the curve, from 0.
    position : (3,) array of float
        Where it is on the mesh.
    """

    ratio: float
    path: int
    copy: int
    position: Floats


class Pattern(NamedTuple):
    """A drawing on a mesh.

    Attributes
    ----------
    curves : list of Curve
        In the order of the paths, and along them; parted where paths turn. They have no picks.
    paths : (n,) array of int
        The path of the drawing, from 0, that each curve is a part of.
    copies : (n,) array of int
        The copy of the drawing, from 0, that each curve is of.
    tolerance : float
        Largest distance of the curves to the carried drawing that was asked for, in the unit of the mesh.
    largest_deviation : float
        Of a carried point to its curve, in the unit of the mesh.
    shortest, longest : Distortion
        The parts that became shortest and longest.
    """

    curves: list[Curve]
    paths: Int32s
    copies: Int32s
    tolerance: float
    largest_deviation: float
    shortest: Distortion
    longest: Distortion


def patterned(
    mesh: Mesh,
    drawing: _core.Drawing,
    centre: npt.ArrayLike | None,
    along: Line | None,
    up: npt.ArrayLike | None,
    options: dict[str, Any],
    progress: Progress | None,
) -> Pattern:
    if (centre is None) == (along is None):
        raise InputError("give one of centre and along", "bad-option")
    place: dict[str, Any] = {name: checked_number(name, OPTIONS[name], value) for name, value in options.items()}
    place["centre"] = None if centre is None else _three(centre, "centre")
    place["up"] = None if up is None else _three(up, "up")
    place["along"] = None if along is None else curve_on(mesh, along, "along")._core
    try:
        curves, paths, copies, tolerance, deviation, *extremes = _core.pattern(mesh._core, drawing, place, progress)
    except InputError as error:
        # Ids are those of paths, which the message names.
        raise (InputError(str(error), error.code) if error.code == "no-path" else error) from None
    nothing = Drawing(mesh, np.empty((0, 3)), {}, fixed="of a pattern")
    return Pattern(
        [Curve(curve, nothing) for curve in curves],
        paths,
        copies,
        tolerance,
        deviation,
        *(Distortion(ratio, path, copy, np.array(position)) for ratio, path, copy, position in extremes),
    )


def carried_drawing(
    drawing: Planar | None, layers: Sequence[str], text: str, font: str | os.PathLike[str]
) -> _core.Drawing:
    """What a user gives to be carried, as the core takes it."""
    if (drawing is None) == (text == ""):
        raise InputError("give one of drawing and text", "bad-option")
    if drawing is not None:
        if os.fspath(font):
            raise InputError("font is for text, and a drawing is given", "bad-option")
        return planar_drawing(drawing, layers)
    if len(layers):
        raise InputError("layers are chosen in .dxf alone", "bad-option")
    return text_drawing(text, font)


def planar_drawing(given: Planar, layers: Sequence[str]) -> _core.Drawing:
    """A file, path data, or polylines, as the core takes it."""
    names = _names_of(layers)
    is_dxf = isinstance(given, (str, os.PathLike)) and os.fspath(given).lower().endswith(".dxf")
    if names and not is_dxf:
        raise InputError("layers are chosen in .dxf alone", "bad-option")
    if not isinstance(given, (str, os.PathLike)):
        if not isinstance(given, Iterable):
            raise TypeError(f"drawing is {given!r}, but must be a file, path data, or polylines of (n, 2) arrays")
        return _core.polyline_drawing([_polyline(line, i) for i, line in enumerate(given)])
    name = os.fspath(given)
    kind = name.lower()[-4:]
    if kind not in (".svg", ".dxf"):
        if isinstance(given, str) and name.lstrip()[:1] in ("M", "m"):
            return _core.path_drawing(name)
        raise FileError(f"{name}: drawings are read from .svg and .dxf; path data begin with M", "unreadable-file")
    data = _bytes(name)
    drawing, notes = _core.dxf_drawing(name, data, names) if is_dxf else _core.svg_drawing(name, _xml_tree(name, data))
    for note in notes:
        of_the_caller = 4
        warnings.warn(note, stacklevel=of_the_caller)
    if not drawing.path_count:
        raise FileError(f"{name}: has no path that is longer than 0", "unreadable-file")
    return drawing


def _names_of(layers: Sequence[str]) -> list[str]:
    if isinstance(layers, str) or not all(isinstance(name, str) for name in layers):
        raise TypeError(f"layers is {layers!r}, but must be a sequence of names")
    return list(layers)


def _bytes(file: str) -> bytes:
    try:
        with open(file, "rb") as stream:
            return stream.read()
    except OSError as error:
        raise FileError(f"{file}: cannot be read: {error.strerror}", "unreadable-file") from error


def _xml_tree(file: str, data: bytes) -> Any:
    """(name, attributes, children, line, text) of the root element."""
    from xml.parsers import expat

    parser = expat.ParserCreate()
    open_nodes: list[Any] = [("", [], [], 0, [])]

    def start(name: str, attributes: dict[str, str]) -> None:
        node: Any = (name.rpartition(":")[2], list(attributes.items()), [], parser.CurrentLineNumber, [])
        open_nodes[-1][2].append(node)
        open_nodes.append(node)

    def end(name: str) -> None:
        open_nodes.pop()

    def text(data: str) -> None:
        open_nodes[-1][4].append(data)

    parser.StartElementHandler = start
    parser.CharacterDataHandler = text
    parser.EndElementHandler = end
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        raise FileError(f"{file}, line {error.lineno}: is not XML ({error})", "unreadable-file") from error
    return open_nodes[0][2][0]


def _polyline(given: npt.ArrayLike, index: int) -> Floats:
    points = numbers(given, f"drawing[{index}]")
    if points.ndim != 2 or points.shape[1] != 2 or not np.isfinite(points).all():
        raise InputError(f"drawing[{index}] has shape {points.shape}, but must be finite and have (n, 2)", "bad-array")
    return np.ascontiguousarray(points)


def _three(given: npt.ArrayLike, name: str) -> tuple[float, ...]:
    values = numbers(given, name)
    if values.shape != (3,) or not np.isfinite(values).all():
        raise InputError(f"{name} must be three finite numbers", "bad-array")
    return tuple(values.tolist())
