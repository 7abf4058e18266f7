# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of curves on meshes, without a graphics card or a window: numpy only.

A small ray-free renderer: triangles are scanned into a depth buffer at several times the size of the picture, shaded per
pixel (three lights, a shadow, darker creases) and averaged down.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

Floats: TypeAlias = npt.NDArray[np.float64]
Ints: TypeAlias = npt.NDArray[np.signedinteger[Any]]
Size: TypeAlias = tuple[int, int]  # width and height, pixels
Shape: TypeAlias = tuple[Floats, Ints, Floats, Floats]  # vertices, faces, normals, colour or one per vertex

MESH_COLOUR = np.array([0.80, 0.81, 0.83])
CURVE_COLOUR = np.array([0.86, 0.17, 0.08])
PICK_COLOUR = np.array([0.07, 0.16, 0.38])
BACKGROUND = np.array([[0.97, 0.98, 1.00], [0.84, 0.87, 0.91]])  # top, bottom


# ---------------------------------------------------------------- shapes
def vertex_normals(vertices: Floats, faces: Ints) -> Floats:
    corners = vertices[faces]
    weighted = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(normals, faces[:, k], weighted)
    return normalised(normals)


def normalised(vectors: Floats) -> Floats:
    lengths: Floats = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(vectors / np.maximum(lengths, 1e-300))


def tube(points: Floats, radius: float, sides: int = 12) -> tuple[Floats, Ints]:
    """Triangles of a tube around a polyline, with a frame carried along it."""
    keep = np.r_[True, np.linalg.norm(np.diff(points, axis=0), axis=1) > 1e-9]
    points = points[keep]
    tangents = normalised(np.gradient(points, axis=0))
    side = normalised(np.cross(tangents[0], [0.3, 0.5, 0.8]))
    rings = []
    for point, tangent in zip(points, tangents):
        side = normalised(side - tangent * (side @ tangent))
        up = np.cross(tangent, side)
        angle = np.linspace(0, 2 * np.pi, sides, endpoint=False)[:, None]
        rings.append(point + radius * (np.cos(angle) * side + np.sin(angle) * up))
    ring = np.arange(sides)
    start = (np.arange(len(points) - 1) * sides)[:, None]
    a, b = start + ring, start + (ring + 1) % sides
    faces = np.concatenate([np.stack([a, b, a + sides], -1), np.stack([b, b + sides, a + sides], -1)])
    return np.concatenate(rings), faces.reshape(-1, 3)


def ball(centre: Floats, radius: float, rows: int = 16) -> tuple[Floats, Ints]:
    """Triangles of a sphere, from a grid of longitudes and latitudes."""
    latitude, longitude = np.meshgrid(np.linspace(0, np.pi, rows), np.linspace(0, 2 * np.pi, 2 * rows), indexing="ij")
    points = np.stack(
        [np.sin(latitude) * np.cos(longitude), np.sin(latitude) * np.sin(longitude), np.cos(latitude)], -1
    ).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(2 * rows - 1), indexing="ij")
    a = (i * 2 * rows + j).ravel()
    faces = np.concatenate([np.stack([a, a + 2 * rows, a + 1], -1), np.stack([a + 1, a + 2 * rows, a + 2 * rows + 1], -1)])
    return centre + radius * points, faces


# ---------------------------------------------------------------- scanning
def scan(screen: Floats, faces: Ints, size: Size) -> tuple[Ints, Floats, Floats]:
    """Per pixel the nearest triangle (-1 where there is none), its barycentric coordinates and the depth.

    screen: x, y in pixels and depth (larger is nearer) per vertex.
    """
    width, height = size
    depth = np.full(width * height, -np.inf)
    face_at = np.full(width * height, -1)
    bary_at = np.zeros((width * height, 3))
    corners = screen[faces]
    low = np.floor(corners[:, :, :2].min(1)).astype(int)
    span = np.ceil(corners[:, :, :2].max(1)).astype(int) - low + 1
    extent = np.maximum(span.max(1), 1)
    # Triangles of similar extent are scanned together, as a block of pixels each.
    for extent_limit in 2 ** np.arange(1, 14):
        chosen = np.where((extent <= extent_limit) & (extent > extent_limit // 2 if extent_limit > 2 else True))[0]
        if len(chosen) == 0:
            continue
        offsets = np.stack(np.meshgrid(np.arange(extent_limit), np.arange(extent_limit)), -1).reshape(-1, 2)
        batch = max(1, 500_000 // len(offsets))  # stays in the cache
        for first in range(0, len(chosen), batch):
            scan_batch(chosen[first:first + batch], corners, low, offsets, size, depth, face_at, bary_at)
    return face_at.reshape(height, width), bary_at.reshape(height, width, 3), depth.reshape(height, width)


def cross(u: Floats, v: Floats) -> Floats:
    return np.asarray(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])


def scan_batch(
    ids: Ints, corners: Floats, low: Ints, offsets: Ints, size: Size, depth: Floats, face_at: Ints, bary_at: Floats
) -> None:
    width, height = size
    a, b, c = (corners[ids, k, :2] for k in range(3))
    area = cross(b - a, c - a)
    has_area = np.abs(area) >= 1e-12
    area = np.where(has_area, area, np.inf)
    middle = low[ids] + 0.5
    inside = np.repeat(has_area[:, None], len(offsets), 1)
    shares = []
    for u, v in ((b, c), (c, a), (a, b)):  # barycentric coordinates are affine in the place of a pixel
        share = np.multiply.outer((u - v)[:, 1] / area, offsets[:, 0])
        share += np.multiply.outer((v - u)[:, 0] / area, offsets[:, 1])
        share += (cross(u - middle, v - middle) / area)[:, None]
        inside &= share >= -1e-9
        shares.append(share)
    row, column = np.nonzero(inside)
    at = low[ids[row]] + offsets[column]
    kept = (at >= 0).all(1) & (at[:, 0] < width) & (at[:, 1] < height)
    row, column, at = row[kept], column[kept], at[kept]
    if len(row) == 0:
        return
    index = at[:, 1] * width + at[:, 0]
    bary = np.stack([share[row, column] for share in shares], -1)
    near = (bary * corners[ids[row], :, 2]).sum(-1)
    order = np.lexsort((near, index))
    last = np.r_[index[order][1:] != index[order][:-1], True]
    order = order[last]
    order = order[near[order] > depth[index[order]]]
    depth[index[order]], face_at[index[order]], bary_at[index[order]] = near[order], ids[row[order]], bary[order]


# ---------------------------------------------------------------- picture
def camera(direction: npt.ArrayLike, up: npt.ArrayLike) -> Floats:
    """Rows: right, up, towards the viewer."""
    backward = normalised(np.asarray(direction, np.float64))
    right: Floats = normalised(np.asarray(np.cross(np.asarray(up, np.float64), backward), np.float64))
    above: Floats = np.asarray(np.cross(backward, right), np.float64)
    return np.stack([right, above, backward])


def box_blur(image: Floats, radius: int) -> Floats:
    """Mean over a square, along each axis by running sums."""
    for axis in (0, 1):
        padded = np.pad(image, [(radius + 1, radius) if k == axis else (0, 0) for k in range(2)], mode="edge")
        total = np.cumsum(padded, axis)
        first = np.arange(image.shape[axis])
        image = (np.take(total, first + 2 * radius + 1, axis) - np.take(total, first, axis)) / (2 * radius + 1)
    return image


def creases(depth: Floats, scale: float, radius: int) -> Floats:
    """From 1 (open) down to about 0.5 where the surroundings stand nearer to the viewer."""
    filled = np.where(np.isfinite(depth), depth, depth[np.isfinite(depth)].min())
    shade = np.zeros_like(filled)
    for r in (radius, radius // 3):
        shade += np.clip((box_blur(box_blur(filled, r), r) - filled) / (scale * 0.05), 0, 1)
    return 1 - 0.28 * shade


def shadow(points: Floats, triangles: Ints, vertices: Floats, light: Floats, diagonal: float) -> Floats:
    """How much of the light reaches each point: a depth buffer seen from the light."""
    frame = camera(light, [0.1, 1.0, 0.2])
    seen = vertices @ frame.T
    low, high = seen.min(0), seen.max(0)
    size = 1400
    scale = (size - 20) / (high - low)[:2].max()

    def to_map(at: Floats) -> Floats:
        return np.column_stack([(at[:, :2] - low[:2]) * scale + 10, at[:, 2]])

    _, _, depth = scan(to_map(seen), triangles, (size, size))
    q = to_map(points @ frame.T)
    lit = np.zeros(len(q))
    steps = np.linspace(-4, 4, 5)
    for dx in steps:
        for dy in steps:
            column, row = np.clip(np.round(q[:, :2] + [dx, dy]).astype(int), 0, size - 1).T
            lit += depth[row, column] < q[:, 2] + 0.012 * diagonal
    return lit / len(steps) ** 2


def shade(normals: Floats, lit: Floats, colours: Floats, even: float) -> Floats:
    """Three lights, a highlight of the first one, and a rim; even: share of the colours that needs no light."""
    key, fill, back = (normalised(np.array(v, float)) for v in ((-0.45, 0.75, 0.65), (0.9, 0.1, 0.45), (0.1, 0.6, -0.9)))

    def diffuse(light: Floats) -> Floats:
        return np.asarray(np.clip(normals @ light, 0, 1))

    half = normalised(key + [0, 0, 1])
    gloss = np.clip(normals @ half, 0, 1) ** 40 * 0.16 * lit
    brightness = 0.25 + 0.10 * normals[:, 1] + 0.78 * diffuse(key) * (0.35 + 0.65 * lit) + 0.22 * diffuse(fill) + 0.12 * diffuse(back)
    return colours * (even + (1 - even) * brightness)[:, None] + (1 - even) * gloss[:, None]


def turned_away(screen: Floats, faces: Ints) -> npt.NDArray[np.bool_]:
    """Which triangles are seen from behind."""
    a, b, c = (screen[faces[:, k], :2] for k in range(3))
    area = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    return area > 0  # y points down on the screen


def render(
    shapes: Sequence[Shape],
    frame: Floats,
    size: Size,
    supersampling: int,
    window: tuple[Floats, Floats] | None = None,
    even: float = 0.0,
) -> Floats:
    """shapes: (vertices, faces, normals, colour) each, one colour or one per vertex; frame: rows right, up, towards the
    viewer; window: lowest and highest corner of what is seen, in that frame (without it everything is, under a shadow);
    even: see shade()."""
    vertices = np.concatenate([s[0] for s in shapes])
    normals = np.concatenate([s[2] for s in shapes])
    colours = np.concatenate([np.broadcast_to(s[3], s[0].shape) for s in shapes])
    start = np.cumsum([0] + [len(s[0]) for s in shapes])
    faces = np.concatenate([s[1] + offset for s, offset in zip(shapes, start)])

    width, height = (n * supersampling for n in size)
    seen = vertices @ frame.T
    low, high = window or (seen.min(0), seen.max(0))
    box = seen[faces][:, :, :2]
    faces = faces[((box.max(1) >= low[:2]) & (box.min(1) <= high[:2])).all(1)]
    scale = (1 if window else 0.9) * min(width / (high - low)[0], height / (high - low)[1])
    centre = (low + high)[:2] / 2
    screen = np.c_[(seen[:, 0] - centre[0]) * scale + width / 2, (centre[1] - seen[:, 1]) * scale + height / 2, seen[:, 2]]
    away = turned_away(screen, faces)
    # At an outline a triangle turned away is as near as its neighbour; it must not win by a rounding error.
    apart = screen[faces].reshape(-1, 3)
    apart[np.repeat(away, 3), 2] -= 0.003 * (high - low).max()
    face_at, bary, depth = scan(apart, np.arange(len(apart)).reshape(-1, 3), (width, height))

    ramp = np.linspace(0, 1, height)[:, None, None]
    image = np.broadcast_to(BACKGROUND[0] * (1 - ramp) + BACKGROUND[1] * ramp, (height, width, 3)).copy()
    hit = face_at >= 0
    corner, weight = faces[face_at[hit]], bary[hit][..., None]

    def mix(values: Floats) -> Floats:
        return np.asarray((values[corner] * weight).sum(1))

    view_normals = normalised(mix(normals)) @ frame.T
    view_normals[away[face_at[hit]]] *= -1  # both sides of an open surface are shown
    diagonal = float(np.linalg.norm(high - low))
    light = np.array([-0.45, 0.75, 0.65]) @ frame
    lit = np.ones(hit.sum()) if window else shadow(mix(vertices), faces, vertices, light, diagonal)
    image[hit] = shade(view_normals, lit, mix(colours), even) * creases(depth, diagonal, width // 60)[hit][:, None]
    image = np.clip(image, 0, 1)
    return np.asarray(image.reshape(size[1], supersampling, size[0], supersampling, 3).mean((1, 3)))


def curve_picture(
    mesh: tuple[Floats, Ints],
    line: Floats,
    picks: Floats,
    view: npt.ArrayLike = (0, 0, 1),
    up: npt.ArrayLike = (0, 1, 0),
    size: Size = (1000, 1000),
    width: float = 0.0045,
    supersampling: int = 3,
) -> npt.NDArray[np.uint8]:
    """A curve as a tube on its mesh, as rows of pixels.

    line: points in order, the first repeated at the end where it is closed; picks: drawn as balls; view: from the mesh
    towards the viewer; width: radius of the curve, relative to the mesh's diagonal.
    """
    vertices, faces = mesh
    radius = width * float(np.linalg.norm(np.ptp(vertices, axis=0)))
    shapes = [(vertices, faces, vertex_normals(vertices, faces), MESH_COLOUR)]
    curve, curve_faces = tube(line, radius)
    shapes.append((curve, curve_faces, vertex_normals(curve, curve_faces), CURVE_COLOUR))
    for pick in picks:
        points, ball_faces = ball(pick, 2.1 * radius)
        shapes.append((points, ball_faces, normalised(points - pick), PICK_COLOUR))
    image = render(shapes, camera(view, up), size, supersampling)
    return (image * 255 + 0.5).astype(np.uint8)
