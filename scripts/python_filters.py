#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the Python package's functions and methods, with their arguments and docstrings, from filters/filters.json.

    scripts/python_filters.py           # writes filters.py and methods.py of python/meshlab_bspline_curve and
                                        # _keywords.py of python/bspline_curve
    scripts/python_filters.py --check   # exit status 1 where they are not what the description says
"""

import argparse
import json
import sys
from pathlib import Path

from python_keywords import keywords
from python_text import HEAD, WIDTH, aliases, camel, default_of, docstring, function, options_of, plain, range_of, type_of

ROOT = Path(__file__).resolve().parents[1]
DESCRIPTION = ROOT / "filters" / "filters.json"
PYTHON = ROOT / "python"

# Of the functions on arrays: what needs a layer or a selection is an array there, or is not there.
LEFT_OUT = {"surface_layer", "replace", "picks_layer", "picks_file", "picks", "control_polygon", "shell_layers", "region"}
OWN = {
    "field": ("{} | npt.ArrayLike", "or (n,) array of float, its values"),
    "avoid": ("{} | npt.ArrayLike", "or (k,) array of int, ids of the faces, or (m,) array of bool"),
    "field_region": ("npt.ArrayLike | None", "(k,) array of int, ids of the faces, or (m,) array of bool"),
    "save": ("str | os.PathLike[str] | None", ""),
}
# Where words for layers and files are of no use.
HELP = {
    "closed": "True: a closed curve through at least 3 picks. False: an open one from the first to the last of at least 2.",
    "tube_radius": "A closed tube mesh around the curve is made too, with this radius in the unit of the mesh, at most its "
                   "diagonal. 0: none.",
    "save": "A file that the curve is written to: the polyline (.ply, .obj, .dxf, .vtu, .csv), the spline itself "
            "(.bspline.obj, .bspline.dxf) or both (.json).",
}
CHOICES = ("field", "avoid", "field_region")  # words or arrays, which run.draw looks at together

MESH_HELP = [
    ("vertices", "(n, 3) array of float", "Of the mesh."),
    ("faces", "(m, 3) array of int", "Of the mesh: ids of vertices, from 0 on, all oriented alike."),
]
PICKS_HELP = ("picks", "(p, 3) array of float",
              "Points that the curve passes, in order. Those farther from the mesh than 1 % of its diagonal are refused.")
QUALITY_HELP = ("quality", "(n,) array of float, optional")
RAISES = [
    ("ValueError, TypeError", "An argument has a wrong shape or type, or is out of its range."),
    ("CurveError", "The filter refuses the mesh or the picks, or fails; the message says which and what to do."),
]


def documented(parameter, with_selections):
    """Name, type and meaning, as a docstring has them."""
    kind, default = parameter["type"], parameter["default"]
    words = {"saveFile": "str or path", "bool": "bool", "int": "int", "double": "float", "absperc": "float", "length": "float or str", "tolerances": "float or str, or a sequence of these", "mesh": "int"}.get(kind, "str")
    text = parameter["help"]
    if kind == "enum":
        words = "{" + ", ".join(repr(o["id"]) for o in options_of(parameter, with_selections)) + "}"
        told = [f"{o['id']}: {o['help']}" for o in options_of(parameter, with_selections) if "help" in o]
        text += " " + "; ".join(told) + "."
    if condition := parameter.get("enabledWhen"):
        text += f" Only with {condition['parameter']} " + " or ".join(condition["in"]) + "."
    if not with_selections:
        text = HELP.get(parameter["id"], text)
    words += range_of(parameter) if kind in ("int", "double", "absperc") else ""
    optional = "optional" if kind == "mesh" or default == "" else f"default {default!r}"
    if not with_selections and parameter["id"] in OWN:
        note = OWN[parameter["id"]][1]
        if parameter["id"] == "field_region":
            words, text, optional = note, "Field of obstacles: the faces where they are.", "optional"
        elif note:
            words += " " + note
    return parameter["id"], f"{words}, {optional}", text


def keyword(parameter):
    """An argument of a function on arrays."""
    name = parameter["id"]
    if name not in OWN:
        return f"{name}: {type_of(parameter, False)} = {default_of(parameter)}"
    default = "None" if name in ("field_region", "save") else default_of(parameter)
    return f"{name}: {OWN[name][0].format(camel(name))} = {default}"


def passed(names):
    return [f'            "{name}": {name},' for name in names]


def draw_function(flt, parameters):
    names = [p["id"] for p in parameters]
    keywords = [keyword(p) for p in parameters]
    at = names.index("field") + 1
    keywords.insert(at, "quality: npt.ArrayLike | None = None")
    quality = (*QUALITY_HELP, "A value for each vertex, for field 'quality' or 'auto', and for faces to avoid where there is no field.")
    told = [documented(p, False) for p in parameters]
    told.insert(at, quality)
    doc = docstring(
        "Draw a smooth curve through points on a triangle mesh.",
        "A variational B-spline close to the surface, and its exact projection onto it, a polyline every segment of which "
        "lies inside one face. A further curve on the same arrays finds the surface prepared.",
        {"Parameters": [*MESH_HELP, PICKS_HELP, *told],
         "Returns": [("", "Curve", "Where it is not `usable`, it follows a shortest path, or shows how far it came.")],
         "Raises": [("", kind, text) for kind, text in RAISES]},
    )
    rest = [name for name in names if name not in (*CHOICES, "save")]
    body = [
        "    return run.draw(",
        "        (vertices, faces),",
        "        picks,",
        '        {"field": field, "quality": quality, "avoid": avoid, "field_region": field_region},',
        "        save,",
        "        {",
        *passed(rest),
        "        },",
        "    )",
    ]
    positional = [f"{name}: npt.ArrayLike" for name in ("vertices", "faces", "picks")]
    return function("draw_curve", positional, keywords, "Curve", doc, body)


def field_function(flt, parameters):
    kind, others = parameters[0], parameters[1:]
    doc = docstring(
        "Compute a scalar per vertex that curves can follow or avoid.",
        "It is the same in every unit and, but for the variation of normals, hardly depends on how fine the mesh is.",
        {"Parameters": [
            *MESH_HELP, documented(kind, False),
            (*QUALITY_HELP, "A value for each vertex, for kind 'quality'."),
            ("region", OWN["field_region"][1] + ", optional", "The faces of obstacles, for kind 'obstacle'."),
            *(documented(p, False) for p in others)],
         "Returns": [("", "(n,) array of float", "A value for each vertex.")],
         "Raises": [("", kind, text) for kind, text in RAISES]},
    )
    body = [
        "    return run.compute(",
        "        (vertices, faces),",
        "        quality,",
        "        region,",
        "        {",
        *passed([p["id"] for p in parameters]),
        "        },",
        "    )",
    ]
    positional = ["vertices: npt.ArrayLike", "faces: npt.ArrayLike", keyword(kind)]
    keywords = ["quality: npt.ArrayLike | None = None", "region: npt.ArrayLike | None = None", *map(keyword, others)]
    return function("compute_field", positional, keywords, "Floats", doc, body)


def functions(filters):
    curve, field = ([p for p in f["parameters"] if p["id"] not in LEFT_OUT] for f in filters[:2])
    return "\n".join([
        HEAD + '"""Curves and fields on arrays."""', "",
        "from __future__ import annotations", "", "import os", "from collections.abc import Sequence", "from typing import Literal, TypeAlias", "",
        "import numpy.typing as npt", "", "from . import run", "from .arrays import Floats", "from .curve import Curve", "",
        aliases([p for p in curve if p["id"] not in ("field_region",)] + field, False), "", "",
        draw_function(filters[0], curve), "", "", field_function(filters[1], field), "",
    ])


def method(flt):
    parameters = [p for p in flt["parameters"] if p["group"] != "window"]
    doc = docstring(
        flt["shortDescription"], plain(flt["longDescriptionMarkdown"]),
        {"Parameters": [documented(p, True) for p in parameters],
         "Returns": [("", "dict", "Figures, by name.")],
         "Raises": [("", "pymeshlab.PyMeshLabException", "The filter refuses something, or fails; the message says why.")]},
    )
    keywords = [f"{p['id']}: {type_of(p, True)} = {default_of(p)}" for p in parameters]
    body = [
        "    return apply(",
        "        self,",
        f'        "{flt["pythonName"]}",',
        "        {",
        *passed([p["id"] for p in parameters]),
        "        },",
        "    )",
    ]
    return function(flt["pythonName"], ["self: pymeshlab.MeshSet"], keywords, "dict[str, Any]", doc, body)


def methods(filters):
    parameters = {p["id"]: p for f in filters for p in f["parameters"]}.values()
    names = [f["pythonName"] for f in filters]
    bind = ["def bind() -> None:", '    """Makes them methods of pymeshlab.MeshSet."""',
            *(f"    pymeshlab.MeshSet.{name} = {name}" for name in names)]
    return "\n".join([
        HEAD + '"""The filters as methods of pymeshlab.MeshSet."""', "",
        "from __future__ import annotations", "", "from collections.abc import Sequence", "from typing import Any, Literal, TypeAlias", "",
        "import pymeshlab", "", "from .run import apply", "", aliases(parameters, True), "", "",
        *("\n" + method(f) + "\n" if i else method(f) + "\n" for i, f in enumerate(filters)), "", *bind, "",
    ])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    check = parser.parse_args().check
    filters = json.loads(DESCRIPTION.read_text())["filters"]
    stale = []
    files = {
        "meshlab_bspline_curve/filters.py": functions(filters),
        "meshlab_bspline_curve/methods.py": methods(filters),
        "bspline_curve/_keywords.py": keywords(filters),
    }
    for name, text in files.items():
        path = PYTHON / name
        if not path.is_file() or path.read_text() != text:
            stale.append(path.name)
            if not check:
                path.write_text(text)
    if check and stale:
        sys.exit(f"not what filters/filters.json says: {', '.join(stale)}; run scripts/python_filters.py")


if __name__ == "__main__":
    main()
