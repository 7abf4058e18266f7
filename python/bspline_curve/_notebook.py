# SPDX-License-Identifier: GPL-3.0-or-later
"""The view of a Picker in a notebook: pictures that pyvista's trame backend sends, with buttons for what keys do elsewhere."""

from __future__ import annotations

import asyncio
import weakref
from typing import TYPE_CHECKING, Any

from ._picker import BUTTONS, LOOK, Picker

if TYPE_CHECKING:
    from collections.abc import Callable


def show(picker: Picker, **options: Any) -> Any:
    """The widget of the last line of a cell. The kernel looks for answers of the solver for as long as the picker lives."""
    given = {"add_menu_items": buttons(picker), **options.pop("jupyter_kwargs", {})}
    widget = picker.plotter.show(jupyter_backend="server", jupyter_kwargs=given, return_viewer=True, **options)
    watch(picker)
    return widget


def buttons(picker: Picker) -> Callable[[], None]:
    """What pyvista calls to add to its menu."""

    def add() -> None:
        from trame.widgets import vuetify3

        for text, action in BUTTONS.items():
            vuetify3.VBtn(text, click=lambda action=action: picker.do(action), size="small", variant="text")

    return add


def watch(picker: Picker) -> None:
    """Updates the picker from the loop that runs, until it is gone."""
    reference = weakref.ref(picker)

    async def look() -> None:
        while True:
            await asyncio.sleep(LOOK / 1000)
            alive = reference()
            if alive is None or alive.plotter.render_window is None:
                return
            alive.update()
            del alive

    picker._watch = asyncio.get_running_loop().create_task(look())
