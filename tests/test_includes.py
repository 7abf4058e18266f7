# SPDX-License-Identifier: GPL-3.0-or-later
"""Includes point one way: each room knows those before it, and public headers know each other alone. Hosts stand on these."""
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
ROOMS = ["utility", "text", "surface", "spline", "shell", "projection", "solver", "design", "imprint", "offset", "fill", "pattern", "field", "workpiece", "sketch", "io", "tetrahedra", "filters"]
HOSTS = ["cli", "filter_bspline_curve", "filter_bspline_curve_legacy", "edit_bspline_curve", "edit_bspline_curve_legacy",
         "python/core", "web/core"]

# What hosts include besides public headers: helpers that know nothing of meshes, and filters/, the layer of options and
# layers that is theirs.
HELPERS = {"utility", "text", "filters"}
# Built where TetGen is there, so no part of the library.
BESIDES = {"cli": {"tetrahedra/conforming_file.h"}}


def included_by(room):
    """(file, header) of each #include "…" in a room."""
    for path in sorted((ROOT / room).rglob("*.[hc]*")):
        if path.suffix in (".h", ".cpp"):
            for header in re.findall(r'^#include "([^"]+)"', path.read_text(), re.M):
                yield path.relative_to(ROOT), header


@pytest.mark.parametrize("room", ROOMS)
def test_rooms_include_rooms_before_them(room):
    known = {"bspline_curve", *ROOMS[: ROOMS.index(room) + 1]}
    includes = list(included_by(room))
    assert includes
    wrong = [
        f"{path} includes {header}"
        for path, header in includes
        if "/" in header and header.split("/")[0] not in known
    ]
    assert wrong == []


def test_the_solver_knows_nothing_of_the_paper():
    """solver/paper/ plugs itself in, by solver/solve_variant.h."""
    includes = [(path, header) for path, header in included_by("solver") if path.parts[1] != "paper"]
    assert includes
    wrong = [f"{path} includes {header}" for path, header in includes if "paper/" in header]
    assert wrong == []


@pytest.mark.parametrize("host", HOSTS)
def test_hosts_include_public_headers_and_helpers_alone(host):
    own = {"bspline_curve", *HELPERS, *(other.split("/")[0] for other in HOSTS)}
    others = {header for _, header in included_by(host) if "/" in header and header.split("/")[0] not in own}
    assert others == BESIDES.get(host, set())


@pytest.mark.parametrize("room", ["utility", "text"])
def test_helpers_know_no_mesh(room):
    known = {"bspline_curve/error.h", "bspline_curve/progress.h"}
    wrong = [f"{path} includes {header}" for path, header in included_by(room)
             if "/" in header and header.split("/")[0] not in ("utility", "text") and header not in known]
    assert wrong == []


def test_public_headers_include_public_headers_alone():
    includes = list(included_by("include"))
    assert includes
    made = {"bspline_curve/version.h"}  # of cmake/version.h.in
    wrong = [f"{path} includes {header}" for path, header in includes
             if header not in made and not (ROOT / "include" / header).exists()]
    assert wrong == []


def test_public_headers_know_no_library_but_eigen():
    text = "".join(path.read_text() for path in (ROOT / "include").rglob("*.h"))
    assert set(re.findall(r"^#include <(\w+)/", text, re.M)) == {"Eigen"}


def test_public_headers_name_no_type_that_they_do_not_define():
    """A class that is declared and not defined there is a private one."""
    text = "".join(path.read_text() for path in (ROOT / "include").rglob("*.h"))
    assert re.findall(r"^(?:class|struct) \w+;", text, re.M) == []


def test_the_umbrella_includes_every_public_header():
    headers = {path.name for path in (ROOT / "include" / "bspline_curve").glob("*.h")} - {"bspline_curve.h"} | {"version.h"}
    text = (ROOT / "include" / "bspline_curve" / "bspline_curve.h").read_text()
    assert set(re.findall(r'^#include "bspline_curve/([^"]+)"', text, re.M)) == headers
    page = (ROOT / "docs" / "CPP.md").read_text()
    assert [name for name in sorted(headers) if f"`{name}`" not in page] == []
