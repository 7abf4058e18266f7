# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings the plugin into pymeshlab, once."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pymeshlab

from . import _built_for
from .errors import HostError

PLUGIN = Path(__file__).parent / "libfilter_bspline_curve.so"

REBUILD = "run BSPLINE_CURVE_MESHLAB=1 pip install --force-reinstall --no-deps on the checkout to build it anew"


def year_and_month(version: str) -> tuple[int, ...]:
    """(2025, 7) of "2025.7.post1", "2025.07" and "2025.07d"."""
    return tuple(int(number) for number in re.findall(r"\d+", version)[:2])


def precision() -> str:
    """The scalar of the pymeshlab that runs: "double" or "float"."""
    held = pymeshlab.Mesh(np.zeros((1, 3))).vertex_matrix().dtype
    return {"float64": "double", "float32": "float"}[held.name]


def check_host() -> None:
    """Raises HostError where pymeshlab has another version or precision than the plugin was built for."""
    running = str(pymeshlab.pmeshlab.__version__)
    if year_and_month(running) != year_and_month(_built_for.MESHLAB_VERSION):
        year, month = year_and_month(_built_for.MESHLAB_VERSION)
        raise HostError(
            f"meshlab_bspline_curve was built for pymeshlab {year}.{month}, but pymeshlab {running} is installed: "
            f'run pip install "pymeshlab=={year}.{month}.*"'
        )
    if precision() != _built_for.SCALAR:
        raise HostError(
            f"meshlab_bspline_curve was built for a pymeshlab with {_built_for.SCALAR} precision, but the one that is "
            f"installed ({running}) has {precision()} precision: install pymeshlab from PyPI, or build the plugin alone, "
            f"with -DBSPLINE_CURVE_SCALAR={precision()}, and load it by pymeshlab.load_plugin"
        )


def load_plugin(filters: tuple[str, ...]) -> None:
    """Loads the plugin unless its filters are there already, from whatever file: a second copy would be loaded beside it."""
    if set(filters) <= set(pymeshlab.filter_list()):
        return
    if not PLUGIN.is_file():
        raise HostError(f"{PLUGIN} is not there: {REBUILD}")
    try:
        pymeshlab.load_plugin(str(PLUGIN))
    except pymeshlab.PyMeshLabException as error:
        raise HostError(f"pymeshlab does not load the plugin: {error}; {REBUILD}") from error
