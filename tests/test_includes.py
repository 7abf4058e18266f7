# SPDX-License-Identifier: GPL-3.0-or-later
"""Includes point one way: each room knows those before it, and public headers know each other alone. Hosts stand on these."""
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
ROOMS = ["utility", "surface", "spline", "shell", "tetrahedra", "projection", "solver", "design", "imprint", "offset", "fill", "pattern", "field", "workpiece", "sketch", "io", "filters"]
HOSTS = ["cli", "filter_bspline_curve", "filter_bspline_curve_legacy", "edit_bspline_curve", "edit_bspline_curve_legacy",
         "python/core", "web/core"]

# What hosts include besides public headers and filters/, which is the layer of options and layers that is theirs.
BESIDES = {
    # The program's reports, tables of batches and formats of shells are files that it alone has.
    "cli": {"io/csv.h", "io/field_report.h", "io/fit_report.h", "io/imprint_writer.h", "io/job_results.h", "io/offset_report.h",
            "io/pattern_report.h", "io/report_writer.h", "io/shell_report.h", "io/shell_writer.h", "io/tetrahedral_grid.h",
            "tetrahedra/conforming_tetrahedra.h",
            # Shells from one run to the next; several files read on one tree, with its words for errors; the verb `shell`.
            "io/shell_cache.h", "shell/shell_store.h", "io/curves_on_surface.h",
            "workpiece/workpiece_parts.h"},
    # Layers of MeshLab: the cache of their workpieces, checksums of layers that are no mesh.
    "filter_bspline_curve": {"workpiece/layer_input.h", "workpiece/workpiece_cache.h", "surface/mesh_checksum.h"},
    "filter_bspline_curve_legacy": {"workpiece/workpiece_cache.h"},
    # What of a curve the surface hides, face by face.
    "edit_bspline_curve": {"sketch/hit_test.h", "sketch/tangent_handles.h", "surface/surface_point.h", "workpiece/workpiece_parts.h"},
    # The package has no library for JSON and XML: it reads and writes these itself, and takes the formats one by one.
    "python/core": {"io/curve_formats.h", "io/drawing_formats.h", "pattern/drawing_builder.h"},
    # Files in memory, and no XML.
    "web/core": {"io/picks_formats.h", "io/polyline_formats.h", "io/xml_tree.h"},
}
# Words for people, names and bytes of files, times: small, and the same in all hosts.
BESIDES_ALL = {"imprint/part_colours.h", "io/atomic_file.h", "io/carried_extras.h", "io/font_search.h", "io/length_unit.h",
               "io/number_text.h", "io/text_parsing.h", "surface/error_messages.h", "surface/picks.h", "utility/index_sets.h",
               "utility/stopwatch.h", "workpiece/curve_notes.h"}


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
def test_hosts_include_public_headers_and_what_is_listed(host):
    own = {"bspline_curve", "filters", *(other.split("/")[0] for other in HOSTS)}
    others = {header for _, header in included_by(host) if "/" in header and header.split("/")[0] not in own}
    besides = BESIDES.get(host, set())
    assert others - besides - BESIDES_ALL == set()
    assert besides - others == set(), "no longer needed"


def test_what_all_hosts_may_include_is_needed():
    assert BESIDES_ALL - {header for host in HOSTS for _, header in included_by(host)} == set()


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
