# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves clicked and dragged on a mesh, in a window of pyvista or in a notebook."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._curve import Curve, drawn
from ._drawing import Drawing
from ._keywords import CURVE
from ._mesh import Mesh
from ._picture import LINE_WIDTH, add_mesh, in_front, thinned

if TYPE_CHECKING:
    from collections.abc import Callable

    from typing_extensions import Unpack

    from ._arrays import Floats
    from ._keywords import CurveOptions

LOOK = 15  # milliseconds between two looks at whether a curve is ready
BEFORE_THE_CAMERA = 10.0  # priority of our observers
KEYS = {
    "a": "add", "m": "move", "period": "next", "comma": "previous", "k": "next-curve", "Delete": "remove",
    "BackSpace": "remove", "c": "close", "n": "new-curve", "x": "cancel",
}  # fmt: skip
CONTROL_KEYS = {"z": "undo", "y": "redo"}
BUTTONS = {"Undo": "undo", "Redo": "redo", "New": "new-curve", "Close": "close", "Remove": "remove"}


class Pointer(NamedTuple):
    """Where the mouse is."""

    ray: Floats  # (2, 3): from where, and the unit direction
    pixel: float  # width: at distance 1, or anywhere if the view is orthographic
    is_orthographic: bool


class Picker:
    """A plotter of pyvista in which curves are clicked and dragged on a mesh; pick() shows one in a window.

    A click on the mesh adds a pick, a drag of a pick moves it while the curve follows, a click on the curve inserts a pick. A
    click on the first pick closes the curve. Shift and a click remove a pick, Ctrl snaps to boundaries, creases and vertices.
    Keys: n begins a new curve, c closes or opens, Delete removes, Ctrl+Z and Ctrl+Y undo and redo, A and M act where the mouse
    is. Dragging beside the mesh turns the camera, as does everything that is not of the left button.

    Attributes
    ----------
    mesh : Mesh
    plotter : pyvista.Plotter
        With the mesh in it; more may be added.
    curves : list of Curve
        Those that are drawn so far, as Mesh.curve() draws them through the same picks.
    problems : list of str
        Why there is no curve, a line for each that has enough picks and cannot be drawn.

    Parameters
    ----------
    mesh : Mesh, or what Mesh takes
    plotter : pyvista.Plotter, optional
        To draw in; one is made otherwise.
    field, avoid, **options
        As of Mesh.curve(), but for `closed`, which is of each curve that is drawn.
    """

    def __init__(self, mesh: Any, plotter: Any = None, **options: Unpack[CurveOptions]) -> None:
        import pyvista

        self.mesh = mesh if isinstance(mesh, Mesh) else Mesh(mesh)
        self._drawing = _drawing(self.mesh, dict(options))
        self._session = _core.DrawingSession(self.mesh._core, *self._drawing.resolved())
        self.plotter: Any = pyvista.Plotter() if plotter is None else plotter
        self._iren: Any = self.plotter.iren
        self._parts = _Parts(self.plotter, self.mesh)
        self._watch: object = None  # what a notebook keeps
        self._observe()

    @property
    def curves(self) -> list[Curve]:
        self._session.settle()
        self._show()
        curves: list[Curve] = []
        for picks, points, closed, problem in self._session.curves:
            if len(points) and not problem:
                options = {**self._drawing.options, **({"closed": True} if closed else {})}
                curves.append(drawn(self._drawing._replace(picks=picks, options=options)))
        return curves

    @property
    def problems(self) -> list[str]:
        """Why there is no curve, a line for each that has enough picks and cannot be drawn."""
        self._session.settle()
        return [problem for _, _, _, problem in self._session.curves if problem]

    def do(self, action: str) -> None:
        """Do what a key does.

        Parameters
        ----------
        action : str
            "undo", "redo", "new-curve", "close", "remove", "next", "previous", "next-curve" or "cancel".

        Examples
        --------
        >>> picker = bspline_curve.Picker(mesh, plotter=pyvista.Plotter(off_screen=True))
        >>> picker.do("new-curve")
        """
        self._session.key(action, *self._pointer(), False)
        self._show()

    def update(self) -> bool:
        """Show what was solved since the last call; whether there was something.

        Examples
        --------
        >>> picker = bspline_curve.Picker(mesh, plotter=pyvista.Plotter(off_screen=True))
        >>> picker.update()
        False
        """
        if not self._session.update():
            return False
        self._show()
        return True

    def show(self, **options: Any) -> Any:
        """Show the plotter: a window until it is closed, or in a notebook a view with buttons. `options` are those of
        Plotter.show().

        Examples
        --------
        >>> picker = bspline_curve.Picker(mesh, plotter=pyvista.Plotter(off_screen=True))
        >>> shown = picker.show()
        """
        if self.plotter.notebook:
            from ._notebook import show

            return show(self, **options)
        if not self.plotter.off_screen:
            self._iren.initialize()
            self._iren.create_timer(LOOK, repeating=True)
        return self.plotter.show(**options)

    # ---- events ----

    def _observe(self) -> None:
        interactor = self._iren.interactor
        session = self._session

        def observe(event: str, call: Callable[[], bool]) -> None:
            def forward(caller: Any, _: str) -> None:
                if call():
                    interactor.GetCommand(tags[event]).SetAbortFlag(1)  # not the camera's
                self._show()

            tags[event] = interactor.AddObserver(event, forward, BEFORE_THE_CAMERA)

        tags: dict[str, int] = {}
        observe("LeftButtonPressEvent", lambda: session.press(*self._pointer(), *self._modifiers()))
        observe("MouseMoveEvent", lambda: session.move(*self._pointer(), *self._modifiers()))
        observe("LeftButtonReleaseEvent", lambda: session.release(*self._pointer(), *self._modifiers()))
        observe("LeaveEvent", self._leave)
        observe("KeyPressEvent", self._key)
        interactor.AddObserver("TimerEvent", lambda *_: self.update())

    def _leave(self) -> bool:
        self._session.leave()
        return False

    def _key(self) -> bool:
        interactor = self._iren.interactor
        name = interactor.GetKeySym() or ""
        with_control = bool(interactor.GetControlKey())
        action = CONTROL_KEYS.get(name.lower()) if with_control else KEYS.get(name, KEYS.get(name.lower()))
        if action is None:
            return False
        return self._session.key(action, *self._pointer(), False)

    def _modifiers(self) -> tuple[bool, bool]:
        """Whether picks snap, and whether clicks remove them."""
        interactor = self._iren.interactor
        return bool(interactor.GetControlKey()), bool(interactor.GetShiftKey())

    def _pointer(self) -> Pointer:
        x, y = self._iren.interactor.GetEventPosition()
        renderer = self.plotter.renderer
        camera = renderer.GetActiveCamera()
        near, far = (_world(renderer, x, y, depth) for depth in (0.0, 1.0))
        direction = far - near
        direction /= np.linalg.norm(direction)
        height = renderer.GetSize()[1]
        if camera.GetParallelProjection():
            return Pointer(np.stack([near, direction]), 2 * camera.GetParallelScale() / height, True)
        pixel = 2 * np.tan(np.radians(camera.GetViewAngle()) / 2) / height
        return Pointer(np.stack([np.array(camera.GetPosition()), direction]), float(pixel), False)

    def _show(self) -> None:
        if self.plotter.render_window is not None and self._parts.show(self._session):
            self.plotter.render()


class _Parts:
    """What is drawn of a session: lines and picks, beside the mesh."""

    def __init__(self, plotter: Any, mesh: Mesh) -> None:
        import pyvista

        add_mesh(plotter, mesh)
        self._shown: Any = None
        self._diagonal = mesh.diagonal
        self._lines = {}
        for name, color, width in (("others", "darkorange", 4), ("active", "firebrick", LINE_WIDTH), ("preview", "lightcoral", 2)):
            self._lines[name] = self._add(plotter, pyvista.PolyData(), color=color, line_width=width)
        self._picks = {}
        for name, color, size in (("picks", "navy", 12), ("chosen", "royalblue", 16)):
            self._picks[name] = self._add(plotter, pyvista.PolyData(), color=color, point_size=size, style="points")
            self._picks[name].prop.render_points_as_spheres = True

    @staticmethod
    def _add(plotter: Any, shape: Any, **look: Any) -> Any:
        actor = in_front(shape, **look)
        plotter.add_actor(actor, pickable=False, reset_camera=False, render=False)
        return actor

    def show(self, session: _core.DrawingSession) -> bool:
        """Whether anything is other than before."""
        curves, active, hovered = session.curves, session.active, session.hovered
        preview = session.preview
        state = (
            [(picks.tobytes(), points.tobytes(), closed) for picks, points, closed, _ in curves],
            active, session.selected, hovered, None if preview is None else preview.tobytes(),
        )  # fmt: skip
        if state == self._shown:
            return False
        self._shown = state
        lines = [_closed(points) if closed else points for _, points, closed, _ in curves]
        lines = [thinned(line, self._diagonal) if len(line) > 1 else line for line in lines]
        self._lines["others"].mapper.dataset = _polylines([line for i, line in enumerate(lines) if i != active])
        self._lines["active"].mapper.dataset = _polylines(lines[active:active + 1] if active >= 0 else [])
        self._lines["preview"].mapper.dataset = _polylines([] if preview is None else [preview])
        chosen = [(active, session.selected), hovered]
        split: dict[bool, list[Floats]] = {False: [np.empty((0, 3))], True: [np.empty((0, 3))]}
        for i, (picks, _, _, _) in enumerate(curves):
            for j, pick in enumerate(picks):
                split[(i, j) in chosen].append(pick[None])
        self._picks["picks"].mapper.dataset = _points(np.concatenate(split[False]))
        self._picks["chosen"].mapper.dataset = _points(np.concatenate(split[True]))
        return True


def _drawing(mesh: Mesh, options: dict[str, Any]) -> Drawing:
    guides = {name: options.pop(name, None) for name in ("field", "avoid", "quality", "field_region")}
    if "closed" in options:
        raise TypeError("closed is of each curve that is drawn: a click on its first pick closes it")
    for name in ("corners", "tangents"):
        if name in options:
            raise TypeError(f"{name} are of a curve's own picks: draw it, and take curve.with_options({name}=…)")
    if not isinstance(options.get("pick_tolerance", ""), (str, int, float)):
        raise TypeError("pick_tolerance is one for all picks here: draw a curve, and take curve.with_options(pick_tolerance=…)")
    unknown = sorted(options.keys() - CURVE.keys())
    if unknown:
        raise TypeError(f"there is no option {unknown[0]!r}; there are {', '.join([*sorted(CURVE), *guides])}")
    return mesh._drawing(np.empty((0, 3)), options, guides)


def _closed(points: Floats) -> Floats:
    return np.concatenate([points, points[:1]])


def _world(renderer: Any, x: int, y: int, depth: float) -> npt.NDArray[np.float64]:
    renderer.SetDisplayPoint(x, y, depth)
    renderer.DisplayToWorld()
    homogeneous = np.array(renderer.GetWorldPoint())
    return np.asarray(homogeneous[:3] / homogeneous[3])


def _polylines(lines: list[Floats]) -> Any:
    import pyvista

    lines = [line for line in lines if len(line) > 1]
    if not lines:
        return pyvista.PolyData()
    cells, start = [], 0
    for line in lines:
        cells.append(np.r_[len(line), np.arange(start, start + len(line))])
        start += len(line)
    return pyvista.PolyData(np.concatenate(lines), lines=np.concatenate(cells))


def _points(points: Floats) -> Any:
    import pyvista

    return pyvista.PolyData(points) if len(points) else pyvista.PolyData()


def pick(mesh: Any, **options: Unpack[CurveOptions]) -> list[Curve]:
    """Draw curves on a mesh in a window of pyvista, and return them when it is closed. Needs pyvista.

    Parameters
    ----------
    mesh : Mesh, or what Mesh takes
    **options
        Those of Mesh.curve() but `closed`: a click on its first pick closes a curve. Picker tells mouse and keys.

    Returns
    -------
    list of Curve
        In the order in which they were begun.

    Examples
    --------
    >>> curves = bspline_curve.pick(mesh, field="valley")  # doctest: +SKIP
    """
    picker = Picker(mesh, **options)
    if picker.plotter.notebook:
        raise RuntimeError("a notebook does not wait for a window: picker = bspline_curve.Picker(mesh); picker.show(), and "
                           "picker.curves in a later cell")
    picker.show()
    return picker.curves
