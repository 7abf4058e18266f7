#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the Python package's functions and methods, with their arguments and docstrings, from filters/filters.json.

    scripts/python_filters.py           # writes filters.py and methods.py in python/meshlab_bspline_curve
    scripts/python_filters.py --check   # exit status 1 where they are not what the description says
"""

import argparse
import json
import sys
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DESCRIPTION = ROOT / "filters" / "filters.json"
PACKAGE = ROOT / "python" / "meshlab_bspline_curve"
WIDTH = 120

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

HEAD = """\
# SPDX-License-Identifier: GPL-3.0-or-later
# Made from filters/filters.json by scripts/python_filters.py; do not edit.
"""

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


def camel(name):
    return "".join(word.capitalize() for word in name.split("_"))


def options_of(parameter, with_selections):
    return [o for o in parameter["enumOptions"] if with_selections or not o.get("needsSelection")]


def type_of(parameter, with_selections):
    """As an annotation."""
    kind = parameter["type"]
    if kind == "enum":
        return camel(parameter["id"])
    if kind == "absperc":
        return "float | pymeshlab.PercentageValue | pymeshlab.PureValue" if with_selections else "float"
    return {"bool": "bool", "int": "int", "double": "float", "mesh": "int | None"}.get(kind, "str")


def default_of(parameter):
    value = parameter["default"]
    return "None" if parameter["type"] == "mesh" else json.dumps(value) if isinstance(value, str) else repr(value)


def aliases(parameters, with_selections):
    """The words of the enumerations as types."""
    lines = []
    for p in parameters:
        if p["type"] == "enum":
            words = ", ".join(f'"{o["id"]}"' for o in options_of(p, with_selections))
            line = f"{camel(p['id'])}: TypeAlias = Literal[{words}]"
            if len(line) > WIDTH:
                inner = textwrap.fill(words, WIDTH, initial_indent="    ", subsequent_indent="    ", break_on_hyphens=False)
                line = f"{camel(p['id'])}: TypeAlias = Literal[\n{inner},\n]"
            lines.append(line.replace("'", '"'))
    return "\n".join(lines)


def range_of(parameter):
    low, high, opens = parameter.get("min"), parameter.get("max"), parameter.get("excludesMin")
    if high is not None:
        return f" in {'(' if opens else '['}{low:g}, {high:g}]"
    return "" if low is None else f" {'>' if opens else '≥'} {low:g}"


def documented(parameter, with_selections):
    """Name, type and meaning, as a docstring has them."""
    kind, default = parameter["type"], parameter["default"]
    words = {"saveFile": "str or path", "bool": "bool", "int": "int", "double": "float", "absperc": "float", "mesh": "int"}.get(kind, "str")
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


def docstring(summary, extended, sections):
    """numpydoc; sections: title -> [(name, type, text)], without a name where it is empty."""
    lines = [f'"""{summary}', "", *textwrap.wrap(extended, WIDTH - 4, break_on_hyphens=False)]
    for title, entries in sections.items():
        lines += ["", title, "-" * len(title)]
        for name, kind, text in entries:
            head = f"{name} : {kind}" if name else kind
            lines += textwrap.wrap(head, WIDTH - 4, subsequent_indent="    ", break_on_hyphens=False)
            lines += textwrap.wrap(text, WIDTH - 4, initial_indent="    ", subsequent_indent="    ", break_on_hyphens=False)
    return "\n".join(("    " + line).rstrip() for line in [*lines, '"""'])


def plain(markdown):
    return markdown.replace("*", "").replace("\n\n", " ")


def function(name, positional, keywords, result, doc, body):
    arguments = [*positional, "*", *keywords]
    lines = [f"def {name}(", *(f"    {argument}," for argument in arguments), f") -> {result}:", doc, *body]
    return "\n".join(lines)


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
    quality = (*QUALITY_HELP, "A value for each vertex, for field 'quality' and for faces to avoid where there is no field.")
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
    curve, field = ([p for p in f["parameters"] if p["id"] not in LEFT_OUT] for f in filters)
    return "\n".join([
        HEAD + '"""Curves and fields on arrays."""', "",
        "from __future__ import annotations", "", "import os", "from typing import Literal, TypeAlias", "",
        "import numpy.typing as npt", "", "from . import run", "from .arrays import Floats", "from .curve import Curve", "",
        aliases([p for p in curve if p["id"] not in ("field_region",)] + field, False), "", "",
        draw_function(filters[0], curve), "", "", field_function(filters[1], field), "",
    ])


def method(flt):
    parameters = flt["parameters"]
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
        "from __future__ import annotations", "", "from typing import Any, Literal, TypeAlias", "",
        "import pymeshlab", "", "from .run import apply", "", aliases(parameters, True), "", "",
        *("\n" + method(f) + "\n" if i else method(f) + "\n" for i, f in enumerate(filters)), "", *bind, "",
    ])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    check = parser.parse_args().check
    filters = json.loads(DESCRIPTION.read_text())["filters"]
    stale = []
    for name, text in (("filters.py", functions(filters)), ("methods.py", methods(filters))):
        if not (PACKAGE / name).is_file() or (PACKAGE / name).read_text() != text:
            stale.append(name)
            if not check:
                (PACKAGE / name).write_text(text)
    if check and stale:
        sys.exit(f"not what filters/filters.json says: {', '.join(stale)}; run scripts/python_filters.py")


if __name__ == "__main__":
    main()
