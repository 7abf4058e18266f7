# SPDX-License-Identifier: GPL-3.0-or-later
"""Includes point one way: each room knows those before it, and public headers know each other alone."""
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
ROOMS = ["utility", "surface", "spline", "shell", "tetrahedra", "projection", "solver", "design", "imprint", "offset", "fill", "pattern", "sketch", "field", "workpiece", "io", "filters"]
HOSTS = ["cli", "filter_bspline_curve", "filter_bspline_curve_legacy", "edit_bspline_curve", "edit_bspline_curve_legacy",
         "python/core", "web/core"]


def included_by(room):
    """(file, header) of each #include "…" in a room."""
    for path in sorted((ROOT / room).rglob("*.[hc]*")):
        if path.suffix in (".h", ".cpp"):
            for header in re.findall(r'^#include "([^"]+)"', path.read_text(), re.M):
                yield path.relative_to(ROOT), header


@pytest.mark.parametrize("room", [*ROOMS, *HOSTS])
def test_rooms_include_rooms_before_them(room):
    known = {"bspline_curve", *(ROOMS if room in HOSTS else ROOMS[: ROOMS.index(room) + 1]), *(host.split("/")[0] for host in HOSTS if room in HOSTS)}
    includes = list(included_by(room))
    assert includes
    wrong = [
        f"{path} includes {header}"
        for path, header in includes
        if "/" in header and header.split("/")[0] not in known
    ]
    assert wrong == []


def test_public_headers_include_public_headers_alone():
    includes = list(included_by("include"))
    assert includes
    wrong = [f"{path} includes {header}" for path, header in includes if not (ROOT / "include" / header).exists()]
    assert wrong == []


def test_headers_of_fields_and_hosts_are_in_no_public_header():
    text = "".join(path.read_text() for path in (ROOT / "include").rglob("*.h"))
    assert set(re.findall(r"^#include <(\w+)/", text, re.M)) == {"Eigen"}
