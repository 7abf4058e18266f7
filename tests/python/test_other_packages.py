# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves as objects of other packages, as pictures, and the demo."""
import io
import re
import subprocess
import sys
import time
from base64 import b64decode
from pathlib import Path

import bspline_curve
import numpy as np
import pytest
from PIL import Image


@pytest.mark.parametrize("closed", [False, True])
def test_a_curve_becomes_one_of_meshio_and_trimesh(closed, mesh, picks, tmp_path):
    import meshio

    curve = mesh.curve(picks, closed=closed)
    lines = curve.to_meshio()
    np.testing.assert_array_equal(lines.points, curve.points)
    lines.write(tmp_path / "curve.vtu")
    read = meshio.read(tmp_path / "curve.vtu")
    np.testing.assert_array_equal(read.cells_dict["line"], curve.segments())
    for name, array in (("t", curve.t), ("values", curve.values), ("face", curve.faces), ("barycentric", curve.barycentrics)):
        np.testing.assert_array_equal(read.point_data[name], array)
    path = curve.to_trimesh()
    assert path.length == pytest.approx(curve.length) and path.is_closed == closed


@pytest.mark.parametrize("closed", [False, True])
def test_a_curve_becomes_one_of_pyvista(closed, mesh, picks):
    pytest.importorskip("pyvista")
    curve = mesh.curve(picks, closed=closed)
    line = curve.to_pyvista()
    assert line.n_cells == 1 and line.length > 0
    assert line.compute_arc_length()["arc_length"].max() == pytest.approx(curve.length)
    np.testing.assert_array_equal(line.point_data["face"], curve.faces)


def shares_of_the_line(plotter, curve):
    """Of points along a curve, how many are seen in red, or in the blue of a pick."""
    pixels = plotter.screenshot().astype(int)
    r, g, b = np.moveaxis(pixels, 2, 0)
    seen = red(pixels) | ((b > 90) & (r < 60) & (g < 60))
    hits = []
    for point in curve.sample(distances=np.linspace(0, curve.length, 2000, endpoint=False)).points:
        plotter.renderer.SetWorldPoint(*point, 1)
        plotter.renderer.WorldToDisplay()
        x, y, _ = plotter.renderer.GetDisplayPoint()
        hits.append(seen[int(len(pixels) - 1 - np.floor(y)), int(np.floor(x))])
    return np.mean(hits)


@pytest.mark.parametrize("n", [41, 261])
@pytest.mark.parametrize("view", ["xy", "isometric"])
def test_a_plotted_line_has_no_gaps(wavy, n, view):
    pyvista = pytest.importorskip("pyvista")
    vertices, faces = wavy(n)
    mesh = bspline_curve.Mesh(vertices, faces)
    curve, other = (mesh.curve(vertices[[n * n // a, n * n // 3, n * n // 2 + n // b, n * n - n * 9]]) for a, b in ((10, 3), (9, 2)))
    plotter = curve.plot(off_screen=True, window_size=(700, 700))
    assert other.plot(plotter) is plotter and isinstance(plotter, pyvista.Plotter)
    assert sum("mesh" in name for name in plotter.actors) == 1  # the mesh is there once
    getattr(plotter, f"view_{view}")()
    plotter.show(auto_close=False)
    assert shares_of_the_line(plotter, curve) > 0.985 and shares_of_the_line(plotter, other) > 0.985  # the rest: bends
    plotter.close()


def test_many_curves_on_a_large_mesh_are_plotted_fast(wavy):
    pyvista = pytest.importorskip("pyvista")
    vertices, faces = wavy(390)  # 302,642 faces
    mesh = bspline_curve.Mesh(vertices, faces)
    rng = np.random.default_rng(1)
    curves = [mesh.curve(vertices[rng.choice(len(vertices), 4)]) for _ in range(20)]
    pyvista.Plotter(off_screen=True).close()
    start = time.process_time()
    plotter = None
    for curve in curves:
        plotter = curve.plot(plotter, **({} if plotter else {"off_screen": True}))
    assert time.process_time() - start < 2
    plotter.close()


def test_curves_are_plotted_by_matplotlib_where_its_axes_are_given(mesh, picks):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    import matplotlib.pyplot as pyplot

    axes = pyplot.figure().add_subplot(projection="3d")
    curve = mesh.curve(picks, closed=True)
    assert curve.plot(axes) is axes and len(axes.lines) == 1
    np.testing.assert_allclose(np.array(axes.lines[0].get_data_3d()).T[:-1], curve.points)
    pyplot.close("all")


def red(pixels):
    r, g, b = np.moveaxis(pixels.astype(int), 2, 0)
    return (r > 110) & (g < r // 2) & (b < r // 2)


def test_notebooks_show_the_curve(mesh, picks):
    text = mesh.curve(picks)._repr_html_()
    picture = Image.open(io.BytesIO(b64decode(re.search(r"base64,([^']+)'", text)[1])))
    assert picture.size == (320, 280)
    assert 200 < red(np.asarray(picture)).sum() < 10_000
    for word in ("open", "converged", "length"):
        assert word in text


def test_the_demo_draws_a_picture(tmp_path):
    def run(*words):
        environment = {"PYTHONPATH": str(Path(bspline_curve.__file__).parents[1])}
        return subprocess.run([sys.executable, "-m", "bspline_curve", *words], cwd=tmp_path, env=environment, capture_output=True, text=True)

    done = run("demo")
    assert re.fullmatch(r"demo\.png: a curve of \d+ points, \d+\.\d+ long\n", done.stdout), done.stderr
    picture = np.asarray(Image.open(tmp_path / "demo.png"))
    assert picture.shape == (700, 800, 3) and 2000 < red(picture).sum() < 40_000
    for output, said in (("a.jpg", "a picture is written as .png"), ("nowhere/a.png", "cannot be written")):
        done = run("demo", "--size", "40", "40", "--output", output)
        assert done.returncode == 1 and said in done.stderr and len(done.stderr.splitlines()) == 1
    assert run("--version").stdout.strip() == bspline_curve.__version__
