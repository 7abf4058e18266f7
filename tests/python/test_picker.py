# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves are clicked and dragged in a plotter of pyvista; events come from its interactor, as those of a mouse do."""
import gc
import time
import weakref

import bspline_curve
import numpy as np
import pytest

pyvista = pytest.importorskip("pyvista")


class Mouse:
    """Moves and presses over points of the scene."""

    def __init__(self, picker, **keys):
        self.picker, self.keys = picker, keys
        self.interactor = picker.plotter.iren.interactor

    def place(self, point):
        renderer = self.picker.plotter.renderer
        renderer.SetWorldPoint(*point, 1)
        renderer.WorldToDisplay()
        return [round(each) for each in renderer.GetDisplayPoint()[:2]]

    def to(self, point, **keys):
        x, y = point if len(point) == 2 else self.place(point)
        held = self.keys | keys
        self.interactor.SetEventInformation(x, y, held.get("control", 0), held.get("shift", 0))
        self.interactor.MouseMoveEvent()

    def press(self, point, **keys):
        self.to(point, **keys)
        self.interactor.LeftButtonPressEvent()

    def release(self):
        self.interactor.LeftButtonReleaseEvent()

    def click(self, *points, **keys):
        for point in points:
            self.press(point, **keys)
            self.release()

    def key(self, name, control=0):
        x, y = self.interactor.GetEventPosition()
        self.interactor.SetEventInformation(x, y, control, 0, "\0", 0, name)
        self.interactor.KeyPressEvent()


def window(mesh, **options):
    plotter = pyvista.Plotter(off_screen=True, window_size=(500, 400))
    picker = bspline_curve.Picker(mesh, plotter=plotter, **options)
    plotter.view_xy()
    plotter.show(auto_close=False)
    return picker


@pytest.fixture
def picker(mesh):
    picker = window(mesh)
    yield picker
    picker.plotter.close()


@pytest.fixture
def mouse(picker):
    return Mouse(picker)


def red(picker):
    r, g, b = np.moveaxis(picker.plotter.screenshot().astype(int), 2, 0)
    return ((r > 130) & (g < 80) & (b < 80)).sum()


def wait(picker, seconds=20):
    """Until the solver has answered."""
    end = time.monotonic() + seconds
    while not picker.update():
        assert time.monotonic() < end, "no curve came"
        time.sleep(0.001)


def test_clicks_draw_the_curve_through_the_points_under_them(picker, mouse, mesh, picks):
    assert picker.curves == []
    mouse.click(*picks)
    [curve] = picker.curves
    assert np.abs(curve.picks[:, :2] - picks[:, :2]).max() < 0.01  # half a pixel
    np.testing.assert_array_equal(curve.points, mesh.curve(curve.picks).points)
    assert red(picker) > 500


def test_the_curve_follows_a_dragged_pick(picker, mouse, picks):
    mouse.click(*picks)
    before = picker.curves[0]
    camera = picker.plotter.camera_position
    mouse.press(picks[2])
    for step in (0.1, 0.2, 0.3):
        mouse.to(picks[2] + [0, step, 0])
        wait(picker)
        shown = picker._session.curves[0][1]
        assert np.abs(shown[:, :2] - (picks[2] + [0, step, 0])[:2]).sum(1).min() < 0.02
    mouse.release()
    [after] = picker.curves
    assert after.picks[2, 1] - before.picks[2, 1] == pytest.approx(0.3, abs=0.02)
    np.testing.assert_array_equal(np.delete(after.picks, 2, 0), np.delete(before.picks, 2, 0))
    assert picker.plotter.camera_position == camera
    mouse.key("z", control=1)
    np.testing.assert_array_equal(picker.curves[0].points, before.points)
    mouse.key("y", control=1)
    np.testing.assert_array_equal(picker.curves[0].points, after.points)


def test_a_click_on_the_first_pick_closes_the_curve_and_the_next_begins_another(picker, mouse, mesh, picks):
    mouse.click(*picks, picks[0])
    assert [curve.closed for curve in picker.curves] == [True]
    mouse.click([0.5, -0.9, 0.0], [0.9, -0.5, 0.0])
    ring, line = picker.curves
    assert ring.closed and not line.closed and len(line.picks) == 2
    np.testing.assert_array_equal(ring.points, mesh.curve(ring.picks, closed=True).points)


def test_clicks_on_the_curve_insert_and_shift_removes(picker, mouse, picks):
    mouse.click(*picks)
    [curve] = picker.curves
    first, second = curve.pick_vertices[:2]
    mouse.click(curve.points[(first + second) // 2])
    assert len(picker.curves[0].picks) == 5
    mouse.click(picks[0], shift=1)
    [shorter] = picker.curves
    np.testing.assert_array_equal(shorter.picks[1:], curve.picks[1:])


def test_the_next_curve_is_shown_before_the_click(picker, mouse, mesh, picks):
    mouse.click(*picks[:3])
    drawn = len(picker.curves)
    mouse.to(picks[3])
    wait(picker)
    preview = picker._session.preview
    assert drawn == 1 and np.abs(preview[-1] - picks[3]).max() < 0.01
    mouse.click(picks[3])
    assert picker._session.preview is None
    np.testing.assert_array_equal(picker.curves[0].points, preview)


def test_buttons_do_what_keys_do(picker, mouse, picks):
    mouse.click(*picks)
    picker.do("close")
    assert picker.curves[0].closed
    picker.do("undo")
    assert not picker.curves[0].closed
    mouse.key("c")
    assert picker.curves[0].closed
    mouse.key("n")
    mouse.click([0.5, -0.5, 0.0])
    assert len(picker.curves) == 1  # one pick is no curve
    with pytest.raises(ValueError, match="no key is called jump"):
        picker.do("jump")


def test_dragging_beside_the_mesh_turns_the_camera(picker, mouse, picks):
    before = picker.plotter.camera_position
    mouse.press((5, 5))
    mouse.to((60, 40))
    mouse.release()
    assert picker.plotter.camera_position != before and picker._session.curves == []


@pytest.mark.parametrize("parallel", [False, True])
def test_the_view_may_be_parallel_or_not(parallel, picker, mouse, picks):
    picker.plotter.camera.parallel_projection = parallel
    picker.plotter.camera.Azimuth(25)
    mouse.click(*picks)
    assert np.abs(picker.curves[0].picks - picks).max() < 0.015


def test_options_are_those_of_mesh_curve(mesh, picks):
    values = mesh.vertices[:, 0] ** 2
    for options in ({"field": "ridge", "degree": 4}, {"field": values, "field_cost": "square"}, {"tension": 0.3, "avoid": [1640, 1641]}):
        picker = window(mesh, **options)
        Mouse(picker).click(*picks)
        [curve] = picker.curves
        shown = picker._session.curves[0][1]
        expected = mesh.curve(curve.picks, **options)
        np.testing.assert_array_equal(curve.points, expected.points)
        np.testing.assert_array_equal(shown, expected.points)
        picker.plotter.close()
    with pytest.raises(TypeError, match="closed is of each curve"):
        bspline_curve.Picker(mesh, closed=True)
    with pytest.raises(TypeError, match="no option 'tenson'"):
        bspline_curve.Picker(mesh, tenson=1)
    with pytest.raises(bspline_curve.OptionError, match="tension"):
        bspline_curve.Picker(mesh, tension=7)


def test_picks_that_no_curve_passes_are_told(mesh, arrays):
    apart = np.concatenate([arrays[0], arrays[0] + [3, 0, 0]]), np.concatenate([arrays[1], arrays[1] + len(arrays[0])])
    picker = window(bspline_curve.Mesh(*apart))
    Mouse(picker).click([0, 0, 0], [3, 0, 0])
    assert picker.curves == []
    assert "component" in picker.problems[0]
    picker.plotter.close()


def test_a_mended_mesh_is_drawn_on(arrays, picks):
    with pytest.warns(bspline_curve.MeshWarning):
        mesh = bspline_curve.Mesh(arrays[0], np.concatenate([arrays[1], arrays[1][:1]]))
    picker = window(mesh)
    Mouse(picker).click(*picks)
    [curve] = picker.curves
    np.testing.assert_array_equal(curve.points, mesh.curve(curve.picks).points)
    picker.plotter.close()


def test_a_picker_goes_with_its_last_name(mesh, picks):
    picker = window(mesh)
    Mouse(picker).click(*picks)
    curves, gone = picker.curves, weakref.ref(picker)
    picker.plotter.close()
    del picker
    gc.collect()
    assert gone() is None and len(curves[0].points) > 4


def test_pick_returns_the_curves_of_the_window(mesh, picks, monkeypatch):
    show = pyvista.Plotter.show

    def shown(self, **_):
        self.view_xy()
        show(self, auto_close=False)
        Mouse(pickers[0]).click(*picks)
        self.close()

    class Watched(bspline_curve.Picker):
        def __init__(self, *words, **options):
            super().__init__(*words, **options)
            pickers.append(self)

    pickers = []
    monkeypatch.setattr(pyvista, "OFF_SCREEN", True)
    monkeypatch.setattr(pyvista.Plotter, "show", shown)
    monkeypatch.setattr("bspline_curve._picker.Picker", Watched)
    [curve] = bspline_curve.pick((mesh.vertices, mesh.faces), degree=4)
    assert curve.degree == 4 and len(curve.picks) == 4


# ---- the accessor ----


def surface(arrays):
    return pyvista.PolyData(arrays[0].copy(), np.c_[np.full(len(arrays[1]), 3), arrays[1]].ravel())


def test_meshes_of_pyvista_draw_curves(arrays, mesh, picks):
    import bspline_curve._accessor  # noqa: F401  (the entry point of an installed package does this)

    own = surface(arrays)
    np.testing.assert_array_equal(own.bspline_curve.curve(picks, degree=4).points, mesh.curve(picks, degree=4).points)
    assert own.bspline_curve.mesh is own.bspline_curve.mesh
    assert own.bspline_curve.line(picks).n_cells == 1
    np.testing.assert_array_equal(own.bspline_curve.field("ridge"), mesh.field("ridge"))
    own.point_data["heat"] = mesh.field("valley")
    expected = mesh.curve(picks, field=mesh.field("valley"), field_cost="exp-minus").points
    np.testing.assert_array_equal(own.bspline_curve.curve(picks, field="heat", field_cost="exp-minus").points, expected)
    own.points *= 2
    assert own.bspline_curve.curve(2 * picks).length == pytest.approx(2 * mesh.curve(picks).length, rel=1e-6)


def test_the_accessor_is_an_entry_point():
    import tomllib
    from importlib import import_module
    from pathlib import Path

    project = tomllib.loads((Path(__file__).resolve().parents[2] / "pyproject.toml").read_text())["project"]
    import_module(project["entry-points"]["pyvista.accessors"]["bspline_curve"])
    assert {entry.name for entry in pyvista.registered_accessors()} >= {"bspline_curve"}
