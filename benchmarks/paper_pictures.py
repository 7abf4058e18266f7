# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels of the figures in docs/PAPER.md: meshes with lines, graphs, and rows of them."""
from dataclasses import dataclass, field

import numpy as np
from bspline_curve._rendering import MESH_COLOUR, ball, camera, normalised, render, tube, vertex_normals
from PIL import Image, ImageDraw, ImageFont

DARK = np.array((18, 40, 96)) / 255
SIZE = [320]  # pixels of a panel


@dataclass
class Panel:
    """A part of a figure: a picture and what stands under it."""
    caption: str
    image: np.ndarray


@dataclass
class Scene:
    """What a panel shows."""
    vertices: np.ndarray
    faces: np.ndarray
    lines: list = field(default_factory=list)  # points and colour
    balls: list = field(default_factory=list)
    colours: object = None  # one per vertex
    view: tuple = (0, 0, 1)
    up: tuple = (0, 1, 0)
    radius: float = 0.005  # of lines, of the diagonal


def panel(caption, scene):
    diagonal = np.linalg.norm(np.ptp(scene.vertices, axis=0))
    radius = scene.radius * diagonal
    colours = MESH_COLOUR if scene.colours is None else scene.colours
    shapes = [(scene.vertices, scene.faces, vertex_normals(scene.vertices, scene.faces), colours)]
    for points, colour in scene.lines:
        vertices, faces = tube(densified(np.asarray(points), diagonal / 120), radius)
        shapes.append((vertices, faces, vertex_normals(vertices, faces), colour))
    for centre in scene.balls:
        vertices, faces = ball(np.asarray(centre), 2.0 * radius)
        shapes.append((vertices, faces, normalised(vertices - centre), DARK))
    return Panel(caption, pixels(shapes, scene.vertices, camera(scene.view, scene.up)))


def pixels(shapes, vertices, frame):
    """A picture of shapes whose window fits some vertices; without a shadow, which would take as long again."""
    seen = vertices @ frame.T
    low, high = seen.min(0), seen.max(0)
    margin = 0.06 * (high - low)
    image = render(shapes, frame, (SIZE[0], SIZE[0]), 2, (low - margin, high + margin))
    return (image * 255 + 0.5).astype(np.uint8)


def densified(line, step):
    """With points at most a step apart: the renderer tests every pixel of a triangle's box, so none may be long."""
    parts = [np.linspace(a, b, max(2, int(np.linalg.norm(b - a) / step) + 2))[:-1] for a, b in zip(line, line[1:])]
    return np.concatenate([*parts, line[-1:]])


def ring(curve):
    """The polyline, its first point again at the end of a closed one."""
    return np.vstack([curve.points, curve.points[:1]]) if curve.closed else curve.points


def heat(values):
    """Grey to brown, one colour per vertex."""
    s = (values - values.min()) / max(np.ptp(values), 1e-300)
    stops = np.array([[0.93, 0.93, 0.93], [0.92, 0.80, 0.45], [0.66, 0.44, 0.10]])
    return np.stack([np.interp(s, [0, 0.5, 1], stops[:, k]) for k in range(3)], 1)


def graph(caption, series, labels):
    """Lines on a logarithmic axis: values by iteration; a dotted line where a round begins."""
    size, scale = SIZE[0], 3
    image = Image.new("RGB", (size * scale, size * scale), "white")
    pen = ImageDraw.Draw(image)
    left, right, top, bottom = 70, 12, 28, 34
    every = np.concatenate([np.log10(values) for values, _, _ in series])
    low, high = np.floor(every.min() * 4) / 4, np.ceil(every.max() * 4) / 4
    longest = max(len(values) for values, _, _ in series)
    place = lambda i, v: ((left + i / max(1, longest - 1) * (size - left - right)) * scale,
                          (size - bottom - (np.log10(v) - low) / (high - low) * (size - top - bottom)) * scale)
    font = ImageFont.load_default(13 * scale)
    for value in np.linspace(low, high, 5):
        y = place(0, 10 ** value)[1]
        pen.line([(left * scale, y), ((size - right) * scale, y)], fill=(225, 225, 225), width=scale)
        pen.text(((left - 6) * scale, y), f"{10 ** value:,.0f}" if value > 1 else f"{10 ** value:.2g}", fill="black", font=font, anchor="rm")
    for k, (values, starts, colour) in enumerate(series):
        rgb = tuple(int(255 * c) for c in colour)
        for start in starts:
            x = place(start, values[start])[0]
            for y in range(top, size - bottom, 8):
                pen.line([(x, y * scale), (x, (y + 3) * scale)], fill=rgb, width=scale)
        pen.line([place(i, v) for i, v in enumerate(values)], fill=rgb, width=2 * scale, joint="curve")
        pen.text(((left + 8 + 110 * k) * scale, 8 * scale), labels[k], fill=rgb, font=font)
    pen.text(((size + left) / 2 * scale, (size - 12) * scale), "iteration", fill="black", font=font, anchor="mm")
    return Panel(caption, np.asarray(image.resize((size, size), Image.LANCZOS)))


def montage(panels, path):
    """Panels in rows of four at most, captions below."""
    columns = min(4, len(panels))
    rows = -(-len(panels) // columns)
    size, foot = SIZE[0], 30
    image = Image.new("RGB", (columns * (size + 8) - 8, rows * (size + foot)), "white")
    pen, font = ImageDraw.Draw(image), ImageFont.load_default(15)
    for k, one in enumerate(panels):
        x, y = k % columns * (size + 8), k // columns * (size + foot)
        image.paste(Image.fromarray(one.image), (x, y))
        pen.text((x + size / 2, y + size + foot / 2), one.caption, fill="black", font=font, anchor="mm")
    path.parent.mkdir(parents=True, exist_ok=True)
    image.quantize(256, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(path, optimize=True)
