#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the diagrams of docs/ALGORITHM.md.

    .cache/venv/bin/python scripts/algorithm_figures.py [--output docs/images]
"""

import argparse
import math
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

ROOT = Path(__file__).resolve().parents[1]
INK, GREY, PALE = (40, 40, 40), (140, 140, 140), (236, 236, 236)
RED, BLUE, GREEN, ORANGE = (196, 40, 40), (30, 90, 190), (20, 130, 70), (214, 120, 0)
SCALE = 3  # drawn so many times larger, then reduced: smooth lines


class Picture:
    """A drawing in its own coordinates, y upwards; lines and text in pixels of the result."""

    def __init__(self, width, height, left=0.0, bottom=0.0, unit=1.0):
        self.size, self.left, self.bottom, self.unit = (width, height), left, bottom, unit
        self.image = Image.new("RGB", (width * SCALE, height * SCALE), "white")
        self.draw = ImageDraw.Draw(self.image)

    def place(self, point):
        x, y = point
        return ((x - self.left) * self.unit * SCALE, (self.size[1] - (y - self.bottom) * self.unit) * SCALE)

    def line(self, points, colour=INK, width=2.0, dash=None):
        placed = [self.place(p) for p in points]
        if dash is None:
            self.draw.line(placed, fill=colour, width=round(width * SCALE), joint="curve")
            return
        for a, b in zip(placed, placed[1:]):
            count = max(1, round(math.dist(a, b) / (dash * SCALE)))
            at = [tuple(p + (q - p) * i / count for p, q in zip(a, b)) for i in range(count + 1)]
            for i in range(0, count, 2):
                self.draw.line([at[i], at[i + 1]], fill=colour, width=round(width * SCALE))

    def fill(self, points, colour):
        self.draw.polygon([self.place(p) for p in points], fill=colour)

    def dot(self, point, colour=INK, radius=4.5):
        x, y = self.place(point)
        r = radius * SCALE
        self.draw.ellipse([x - r, y - r, x + r, y + r], fill=colour)

    def arrow(self, start, end, colour=INK, width=2.0, head=10.0):
        self.line([start, end], colour, width)
        a, b = self.place(start), self.place(end)
        angle = math.atan2(b[1] - a[1], b[0] - a[0])
        wings = [(b[0] - head * SCALE * math.cos(angle + s), b[1] - head * SCALE * math.sin(angle + s)) for s in (0.4, -0.4)]
        self.draw.polygon([b, *wings], fill=colour)

    def text(self, point, words, colour=INK, size=17, anchor="mm"):
        self.draw.multiline_text(self.place(point), words, fill=colour, font=ImageFont.load_default(size * SCALE),
                                 anchor=anchor, align="center", spacing=4 * SCALE)

    def box(self, centre, width, height, words, colour=INK, size=16):
        x, y = self.place(centre)
        w, h = width * self.unit * SCALE / 2, height * self.unit * SCALE / 2
        self.draw.rounded_rectangle([x - w, y - h, x + w, y + h], radius=8 * SCALE, outline=colour, width=2 * SCALE, fill="white")
        self.text(centre, words, colour, size)

    def save(self, path):
        self.image.resize(self.size, Image.Resampling.LANCZOS).save(path, optimize=True)


def between(a, b, share):
    return tuple(p + (q - p) * share for p, q in zip(a, b))


def hermite(points, steps=40):
    """A smooth curve through points."""
    slopes = [tuple((q - p) / 2 for p, q in zip(points[max(i - 1, 0)], points[min(i + 1, len(points) - 1)]))
              for i in range(len(points))]
    curve = []
    for a, b, u, v in zip(points, points[1:], slopes, slopes[1:]):
        for i in range(steps):
            t = i / steps
            weights = (2 * t**3 - 3 * t**2 + 1, t**3 - 2 * t**2 + t, 3 * t**2 - 2 * t**3, t**3 - t**2)
            curve.append(tuple(weights[0] * a[k] + weights[1] * u[k] + weights[2] * b[k] + weights[3] * v[k] for k in (0, 1)))
    return [*curve, points[-1]]


# A cross-section: the vertices of the surface, and the pillar direction at each.
SURFACE = [(0.4, 1.2), (2.0, 2.1), (3.8, 2.5), (5.4, 1.9), (7.2, 1.7), (9.0, 2.6)]
DIRECTIONS = [(-0.45, 0.89), (-0.34, 0.94), (0.06, 1.0), (0.22, 0.97), (-0.16, 0.99), (-0.40, 0.92)]


def over(face, u, height):
    """The point over a face: foot plus height times the interpolated direction."""
    foot = between(SURFACE[face], SURFACE[face + 1], u)
    direction = between(DIRECTIONS[face], DIRECTIONS[face + 1], u)
    return tuple(p + height * d for p, d in zip(foot, direction))


def fibres():
    picture = Picture(900, 330, -0.3, 0.3, 82)
    for face in range(5):
        for i in range(5):
            picture.line([over(face, i / 5, -0.45), over(face, i / 5, 1.15)], (214, 224, 240), 1.5)
    picture.line(SURFACE, INK, 3)
    for vertex, direction in zip(SURFACE, DIRECTIONS):
        picture.dot(vertex, INK, 4)
        picture.arrow(vertex, tuple(p + 0.95 * d for p, d in zip(vertex, direction)), BLUE, 2, 8)
    ghost = (SURFACE[-1][0] + 0.8, SURFACE[-1][1] + 0.45)
    picture.line([SURFACE[-1], ghost], GREY, 3, dash=6)
    picture.text((9.95, 2.55), "ghost strip\nbeyond the\nboundary", GREY, 15)
    spline = hermite([over(0, 0.0, 0.15), over(1, 0.1, 0.42), over(2, 0.35, 0.8), over(3, 0.5, 0.55), over(4, 0.9, 0.2)])
    picture.line(spline, RED, 3)
    picture.text((0.75, 2.15), "spline P(t)", RED, 18)
    point, foot = over(2, 0.35, 0.8), over(2, 0.35, 0.0)
    picture.line([point, foot], GREEN, 3)
    picture.dot(point, RED, 6)
    picture.dot(foot, GREEN, 6)
    picture.text((point[0] + 0.12, point[1] + 0.3), "sample P", RED, 18)
    picture.text((foot[0] - 0.5, foot[1] - 0.62), "foot q,\nthe projection of P", GREEN, 18)
    picture.text((point[0] + 0.1, (point[1] + foot[1]) / 2), "height z", GREEN, 17, "lm")
    picture.text((6.3, 3.6), "pillar directions n,\ninterpolated in each face", BLUE, 17)
    picture.arrow((6.6, 3.25), (7.05, 2.72), BLUE, 1.5, 7)
    picture.text((8.6, 1.75), "surface S", INK, 18)
    return picture


def axes(picture, origin, width, height, x_label, y_label):
    x, y = origin
    picture.arrow((x, y), (x + width, y), INK, 2, 9)
    picture.arrow((x, y), (x, y + height), INK, 2, 9)
    picture.text((x + width / 2, y - 0.48), x_label, INK, 16)
    picture.text((x, y + height + 0.22), y_label, INK, 16)


def energies():
    picture = Picture(900, 360, 0, 0, 80)
    # Left: the barrier of the shell, and the quadratic term of heights.
    x0, y0, unit = 0.7, 0.9, 3.6
    axes(picture, (x0, y0), 4.3, 2.9, "relative height d: 0 on S, 1 at the top of the shell", "cost")
    clipped = [(x0 + unit * d, y0 + 0.25 * g) for i in range(400)
               if (d := i / 400) < 0.99 and (g := math.pi / 2 * d * math.tan(math.pi / 2 * d)) * 0.25 < 2.75]
    picture.line(clipped, BLUE, 3)
    picture.line([(x0 + unit, y0), (x0 + unit, y0 + 2.8)], GREY, 1.5, dash=6)
    picture.text((x0 + unit, y0 - 0.17), "1", GREY, 15)
    picture.text((x0 + 2.1, y0 + 2.1), "barrier g(d):\ncell by cell", BLUE, 17)
    picture.line([(x0 + 4.1 * i / 100, y0 + 0.05 * (4.1 * i / 100) ** 2) for i in range(101)], ORANGE, 3)
    picture.text((x0 + 4.2, y0 + 0.9), "quadratic term:\nat samples", ORANGE, 17, "lm")
    # Right: the bubble of a span, and what halving it does.
    x1, unit = 6.7, 4.0
    base = [(x1 + unit * i / 100, 1.3 + 0.35 * math.sin(math.pi * i / 100)) for i in range(101)]
    picture.line(base, RED, 3)
    bubble = [(x, y + 1.15 * 16 * (i / 100) ** 2 * (1 - i / 100) ** 2) for i, (x, y) in enumerate(base)]
    picture.line(bubble, GREEN, 2.5, dash=4)
    for at in (0, 100):
        picture.line([(base[at][0], 1.08), (base[at][0], 1.52)], INK, 2)
    picture.line([(base[50][0], 1.43), (base[50][0], 1.87)], BLUE, 2, dash=4)
    picture.arrow(base[50], bubble[50], GREEN, 2, 9)
    picture.text((x1 + 2.0, 3.15), "span plus bubble times a vector v", GREEN, 17)
    picture.text((x1 + 2.05, 1.06), "new knot, if v lowers the energy enough", BLUE, 16)
    picture.text((x1 + 0.05, 0.62), "a span of the spline", RED, 17, "lm")
    return picture


def integration():
    picture = Picture(900, 350, -0.3, 0.25, 82)
    curve = hermite([over(0, 0.15, 0.2), over(1, 0.3, -0.22), over(2, 0.5, 0.3), over(3, 0.5, -0.2), over(4, 0.75, 0.15)])
    # Prisms above and below each face, with the diagonals of their split.
    for face in range(5):
        for low, high in ((-0.6, 0.0), (0.0, 0.6)):
            corners = [over(face, 0, low), over(face, 1, low), over(face, 1, high), over(face, 0, high)]
            picture.line([*corners, corners[0]], GREY, 1.5)
            picture.line([corners[0], corners[2]] if high > 0 else [corners[1], corners[3]], (190, 190, 190), 1.2)
    picture.line(SURFACE, INK, 3)
    picture.line(curve, RED, 3)

    def side(a, b, p):
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])

    # Crossings with every wall of the drawing.
    walls = []
    for face in range(5):
        for low, high in ((-0.6, 0.0), (0.0, 0.6)):
            c = [over(face, 0, low), over(face, 1, low), over(face, 1, high), over(face, 0, high)]
            walls += [(c[0], c[3]), (c[1], c[2]), (c[0], c[1]), (c[2], c[3]), (c[0], c[2]) if high > 0 else (c[1], c[3])]
    for p, q in zip(curve, curve[1:]):
        if any(side(a, b, p) * side(a, b, q) <= 0 and side(p, q, a) * side(p, q, b) <= 0 for a, b in walls):
            picture.dot(between(p, q, 0.5), BLUE, 4.5)
    for span in range(4):
        for tau in (0.1057, 0.3943, 0.6057, 0.8943):
            picture.dot(curve[round(40 * (span + tau))], ORANGE, 5)
    picture.text((-0.1, 4.28), "orange: four samples per span, each projected along its fibre (sampled solver)", ORANGE, 17, "lm")
    picture.text((-0.1, 3.98), "blue: cuts at all cell walls; three Gauss points on each piece (cellwise solver)", BLUE, 17, "lm")
    picture.text((9.15, 2.85), "surface S", INK, 17, "lm")
    picture.text((1.15, 3.0), "top of the shell", GREY, 15)
    picture.text((3.0, 1.25), "bottom", GREY, 15)
    return picture


def flow():
    picture = Picture(900, 470, 0, 0, 1)
    picture.box((120, 420), 200, 60, "mesh, picks,\nfield, options", INK)
    picture.box((390, 420), 230, 60, "extended surface:\ndirections n, ghost strip", BLUE)
    picture.box((680, 420), 260, 60, "initial path\nfrom pick to pick on S", BLUE)
    picture.box((680, 320), 260, 56, "first spline: loose fit to it", RED)
    picture.fill([(30, 275), (870, 275), (870, 110), (30, 110)], PALE)
    picture.text((45, 258), "round", GREY, 16, "lm")
    picture.box((720, 200), 230, 76, "minimise E\nNewton, picks as\nconstraints", RED)
    picture.box((440, 200), 230, 76, "near enough?\nelse raise the weight\nof the distance", RED)
    picture.box((160, 200), 230, 76, "halve spans whose\nrefinement gain\nis largest", RED)
    picture.box((720, 50), 260, 60, "trace the whole curve\nalong fibres or cells", GREEN)
    picture.box((400, 50), 240, 60, "strict polyline on S", GREEN)
    picture.box((135, 50), 210, 60, "fails: next strategy\n(tight fits, cell by cell)", ORANGE, 15)
    for a, b in (((220, 420), (275, 420)), ((505, 420), (550, 420)), ((680, 390), (680, 348)), ((700, 292), (700, 238)),
                 ((605, 200), (555, 200)), ((325, 200), (275, 200)), ((590, 50), (520, 50))):
        picture.arrow(a, b)
    picture.line([(160, 162), (160, 130), (680, 130)])
    picture.arrow((680, 130), (680, 162))
    picture.arrow((780, 162), (780, 80))
    picture.text((775, 97), "no span gains, near enough", INK, 14, "rm")
    picture.arrow((60, 162), (60, 80), ORANGE)
    return picture


FIGURES = {"algorithm_flow": flow, "algorithm_fibres": fibres, "algorithm_energies": energies, "algorithm_integration": integration}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=Path, default=ROOT / "docs" / "images", metavar="FOLDER")
    folder = parser.parse_args().output
    for name, figure in FIGURES.items():
        figure().save(folder / f"{name}.png")


if __name__ == "__main__":
    main()
