# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

Floats: TypeAlias = npt.NDArray[np.float64]
Int32s: TypeAlias = npt.NDArray[np.int32]
Faces: TypeAlias = npt.NDArray[np.int32] | npt.NDArray[np.int64]

__version__: str

class Curve:
    points: Floats
    places: tuple[Int32s, Floats]
    t: Floats
    pick_vertices: Int32s
    control_points: Floats
    knots: Floats
    pick_parameters: Floats
    degree: int
    closed: bool
    usable: bool
    length: float

    @staticmethod
    def restored(parts: dict[str, Any], /) -> Curve: ...
    def report(self) -> dict[str, Any]: ...

def points_along(mesh: Mesh, curve: Curve, distances: Sequence[float], /) -> dict[str, Any]: ...

class Field:
    values: Floats

    def __init__(self, values: Floats, /) -> None: ...

class Mesh:
    vertices: Floats
    faces: Int32s
    mending: str
    notes: list[str]
    seconds: float
    diagonal: float
    components: int
    checksum: int

    def __init__(self, vertices: Floats, faces: Faces, options: Mapping[str, Any], progress: Any, /) -> None: ...
    def draw(
        self,
        picks: Floats,
        options: Mapping[str, Any],
        field: Field | None,
        avoid: Int32s | None,
        start: Curve | None,
        progress: Any,
        /,
    ) -> Curve: ...
    def field(
        self, options: Mapping[str, Any], quality: Floats | None, region: Int32s | None, progress: Any, /
    ) -> Field: ...
    def project(self, points: Floats, /) -> tuple[tuple[Int32s, Floats], Floats, Floats]: ...
    def shell_layers(self) -> tuple[tuple[Floats, Int32s], tuple[Floats, Int32s]]: ...

class DrawingSession:
    curves: list[tuple[Floats, Floats, bool, str]]
    preview: Floats | None
    active: int
    selected: int
    hovered: tuple[int, int]
    is_dragging: bool
    is_settled: bool

    def __init__(
        self, mesh: Mesh, options: Mapping[str, Any], field: Field | None, avoid: Int32s | None, /
    ) -> None: ...
    def press(self, ray: Floats, pixel: float, is_orthographic: bool, snaps: bool, removes: bool, /) -> bool: ...
    def move(self, ray: Floats, pixel: float, is_orthographic: bool, snaps: bool, removes: bool, /) -> bool: ...
    def release(self, ray: Floats, pixel: float, is_orthographic: bool, snaps: bool, removes: bool, /) -> bool: ...
    def leave(self) -> None: ...
    def key(self, name: str, ray: Floats, pixel: float, is_orthographic: bool, snaps: bool, /) -> bool: ...
    def update(self) -> bool: ...
    def settle(self) -> None: ...

class Imprint:
    vertices: Floats
    faces: Int32s
    parents: Int32s
    crossings: Int32s
    labels: Int32s
    curves: list[Int32s]
    places: tuple[Int32s, Floats]
    largest_move: float
    figures: list[tuple[float, float, tuple[float, float, float], int]]
    segment_notes: list[str]

    def cut(
        self,
        parts: tuple[str | None, list[float], bool],
        fill: str = ...,
        relief: tuple[float, str, float] = ...,
        thickness: float = ...,
        base: tuple[float, list[float], float | None] | None = ...,
        progress: Any = ...,
    ) -> tuple[tuple[Floats, Int32s, Int32s, Int32s], list[str]]: ...
    def split(self, fill: str, progress: Any) -> tuple[list[tuple[Floats, Int32s, Int32s, Int32s]], list[str]]: ...
    def fill_holes(
        self, shape: str, max_length: float, max_edges: int, seed: Sequence[float], progress: Any
    ) -> tuple[tuple[Floats, Int32s, Int32s, Int32s], list[str]]: ...

def imprint(mesh: Mesh, curves: Sequence[Curve], snap: float, stroke: float, progress: Any, /) -> Imprint: ...
def fit(mesh: Mesh, line: Floats, options: Mapping[str, Any], deviation: str, corner_angle: float, progress: Any, /) -> Curve: ...
def boundaries(mesh: Mesh, labels: Int32s, /) -> list[tuple[Int32s, bool, int, int]]: ...
def offset(mesh: Mesh, curve: Curve, distance: float, side: str, progress: Any, /) -> list[tuple[Curve, float]]: ...
def faces_within(
    mesh: Mesh, curve: Curve, distance: float, side: str, progress: Any, /
) -> npt.NDArray[np.uint8]: ...
class Drawing:
    path_count: int
    paths: list[tuple[bool, list[tuple[list[tuple[float, float]], list[float]]]]]

def svg_drawing(file: str, root: tuple[str, list[tuple[str, str]], list[Any], int, list[str]], /) -> tuple[Drawing, list[str]]: ...
def dxf_drawing(file: str, data: bytes, layers: list[str], /) -> tuple[Drawing, list[str]]: ...
def path_drawing(data: str, /) -> Drawing: ...
def text_drawing(data: str, /) -> Drawing: ...
def font_or_default(file: str, /) -> str: ...
def polyline_drawing(lines: Sequence[Floats], /) -> Drawing: ...
def pattern(
    mesh: Mesh, drawing: Drawing, options: Mapping[str, Any], progress: Any, /
) -> tuple[
    list[Curve],
    Int32s,
    Int32s,
    float,
    float,
    tuple[float, int, int, tuple[float, float, float]],
    tuple[float, int, int, tuple[float, float, float]],
]: ...
def repaired(
    vertices: Floats, faces: Faces, options: Mapping[str, Any], /
) -> tuple[Floats, Int32s, dict[str, Any], str]: ...
def projected(
    mesh: Mesh, points: Floats, closed: bool, distance: float, direction: tuple[float, ...] | None, /
) -> tuple[list[Curve], str]: ...
def shortest_way(mesh: Mesh, faces: Int32s, barycentrics: Floats, /) -> Curve | None: ...
def distances(
    mesh: Mesh, curves: Sequence[Curve], faces: Int32s, barycentrics: Floats, reach: float, progress: Any, /
) -> Floats: ...
def reversed(curve: Curve, /) -> tuple[Curve, list[int]]: ...
def part(mesh: Mesh, curve: Curve, start: float, end: float, /) -> tuple[Curve, list[int]]: ...
def parts(mesh: Mesh, curve: Curve, at: list[float], /) -> list[tuple[Curve, list[int]]]: ...
def joined(mesh: Mesh, first: Curve, second: Curve, smooth: bool, gap: str, blend: str, progress: Any, /) -> Curve: ...
def extended(mesh: Mesh, curve: Curve, start: float, end: float, progress: Any, /) -> Curve: ...
def curve_extensions() -> str: ...
def curve_bytes(curve: Curve, end: str, field: Floats, unit: str, /) -> bytes: ...
def read_mesh(file: str, /) -> tuple[Floats, Int32s, Floats]: ...
def can_be_followed(quality: Floats, /) -> bool: ...
def faces_under(mesh: Mesh, values: Floats, threshold: float, /) -> Int32s: ...
def faces_over(mesh: Mesh, values: Floats, threshold: float, /) -> Int32s: ...
