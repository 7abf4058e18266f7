# SPDX-License-Identifier: GPL-3.0-or-later
"""The typed keywords of the package bspline_curve, as text, from filters/filters.json; scripts/python_filters.py writes them."""

import textwrap

from python_text import HEAD, WIDTH, aliases, camel, default_of, docstring, function, options_of, range_of, type_of

# Arguments of the package's own, or of no use where there are neither layers nor files.
LEFT_OUT = {
    "surface_layer", "picks_layer", "picks_file", "picks", "control_polygon", "shell_layers", "tube_radius", "save",
    "field", "avoid", "field_region", "kind", "region",
}
HELP = {
    "closed": "True: a closed curve through at least 3 picks. False: an open one from the first to the last of at least 2.",
    "max_segment_length": "No segment of the polyline is longer, in the unit of the mesh. 0: no limit.",
    "shell": "Where curves are sought.",
    "tangents": "Directions in which the curve passes picks, by their indices, as {0: (1, 0, 0)}. Their part along the surface counts, "
                "not their length. Such picks are passed whatever their tolerance. A corner has two, before and after it: "
                "{2: ((1, 0, 0), (0, 1, 0))}; None in place of one that is free.",
    "pick_tolerance": "How far from each pick the curve may pass: it is as fair as possible within that distance. A length in the unit "
                      "of the mesh, or text like '1.5 edges', in mean edges; one for all picks, or one for each. 0: it passes the picks. "
                      "In place of a length, 'weight 100': no bound, but a pull that grows with the distance.",
    "corners": "Picks at which the curve turns, by their indices, or 'all'. It passes them, and is as fair as possible on either side.",
}
PICKS = ("picks", "(p, 3) array of float, or p pairs (face, barycentrics)",
         "Points that the curve passes, in order. Those farther from the mesh than `pick_distance` are refused.")
FIELD = ("field", "str or (n,) array of float, optional",
         "Draws the curve to where it costs little: a kind of field(), or a value for each vertex. 'auto': the quality, mapped to "
         "[0, 1], where there is one that is finite and not constant and that no threshold of avoid is for; else none.")
AVOID = ("avoid", "str, (k,) array of int or (m,) array of bool, optional",
         "Faces that the curve does not enter: their ids, or a bool for each face. 'under-threshold', 'over-threshold': those over "
         "which the mean of the field, or without a field of the quality, is under or over avoid_threshold.")
QUALITY = ("quality", "(n,) array of float, optional",
           "A value for each vertex, for field 'quality' and 'auto' and for thresholds of avoid; None: the mesh's own.")
REGION = ("field_region", "(k,) array of int or (m,) array of bool, optional", "The faces of obstacles, for field 'obstacle'.")
PROGRESS = ("progress", "callable, optional",
            "Called now and then with a fraction in [0, 1] and the name of a stage; cancels by returning False.")
RAISES = [
    ("InputError", "An argument is wrong; which, and what to do. Its subclasses tell which kind of argument."),
    ("Cancelled", "`progress` returned False."),
]
NONE_IN_PYTHON = ("field", "avoid")  # None stands for their default, "none"


def is_of_shell(parameter):
    return parameter["id"] in ("shell", "strict", "weld", "slits") or parameter["group"] == "advanced.shell"


def parameters_of(flt, keep):
    return [p for p in flt["parameters"] if p["id"] not in LEFT_OUT and p["group"] != "window" and keep(p)]


def documented(parameter):
    kind, text = parameter["type"], parameter["help"]
    words = {"bool": "bool", "int": "int", "length": "float or str", "tolerances": "float or str, or a sequence of these", "picks": "sequence of int, or 'all'",
             "tangents": "mapping of int to (3,) arrays, or pairs of these, optional"}.get(kind, "float")
    if kind == "enum":
        words = "{" + ", ".join(repr(o["id"]) for o in options_of(parameter, False)) + "}"
        told = [f"{o['id']}: {o['help']}" for o in options_of(parameter, False) if "help" in o]
        text = HELP.get(parameter["id"], text) + " " + "; ".join(told) + "."
    else:
        words += range_of(parameter)
        text = HELP.get(parameter["id"], text)
    default = "" if kind == "tangents" else f", default {default_in_python(parameter)}".replace('"', "'")
    return parameter["id"], words + default, text


def type_in_python(parameter):
    """Picks are chosen by their indices, not by text."""
    own = {"picks": 'Sequence[int] | Literal["all"]', "tangents": "Mapping[int, npt.ArrayLike | tuple[npt.ArrayLike | None, npt.ArrayLike | None]] | None"}
    return own.get(parameter["type"]) or type_of(parameter, False)


def default_in_python(parameter):
    return {"picks": "()", "tangents": "None"}.get(parameter["type"]) or default_of(parameter)


def keyword(parameter):
    return f"{parameter['id']}: {type_in_python(parameter)} = {default_in_python(parameter)}"


def row(parameter):
    """What _options.py checks by."""
    kind = "double" if parameter["type"] == "absperc" else parameter["type"]
    words = tuple(o["id"] for o in options_of(parameter, False)) if kind == "enum" else ()
    numbers = [parameter.get("min"), parameter.get("max"), bool(parameter.get("excludesMin"))]
    return f'    "{parameter["id"]}": Option("{kind}", {default_in_python(parameter)}, {", ".join(map(repr, numbers))}, {words!r}),'.replace("'", '"')


def table(name, parameters):
    return "\n".join([f"{name}: dict[str, Option] = {{", *map(row, parameters), "}"])


GUIDES = {
    "field": "Field | npt.ArrayLike | None", "quality": "npt.ArrayLike | None", "avoid": "Avoid | npt.ArrayLike | None",
    "field_region": "npt.ArrayLike | None",
}


def typed_dict(parameters):
    lines = ["class CurveOptions(TypedDict, total=False):", '    """Options of Mesh.curve(), for Curve.with_options()."""', ""]
    lines += [f"    {p['id']}: {type_in_python(p)}" for p in parameters]
    return "\n".join([*lines, *(f"    {name}: {kind}" for name, kind in GUIDES.items())])


def options_of_mesh(parameters):
    lines = ["class MeshOptions(TypedDict, total=False):", '    """Options of Mesh(), for Mesh.load() and repair()."""', ""]
    lines += [f"    {p['id']}: {type_of(p, False)}" for p in parameters]
    return "\n".join([*lines, "    quality: npt.ArrayLike | None", "    progress: Progress | None"])


def method(name, positional, keywords, result, doc, body):
    return textwrap.indent(function(name, ["self", *positional], keywords, result, doc, body), "    ")


def given(parameters):
    return [f'            "{p["id"]}": {p["id"]},' for p in parameters]


def init(parameters):
    doc = docstring(
        "Prepare a triangle mesh for curves.",
        "Validates it once: finite, oriented, two-manifold, every face with area; boundaries and several components are "
        "allowed. Of another one a mended copy is drawn on where that helps, with a MeshWarning; ids stay those of the mesh that "
        "was given. bspline_curve.repair() returns such a copy.",
        {"Parameters": [
            ("vertices", "(n, 3) array of float, or a mesh",
             "A mesh of trimesh, pyvista, meshio or pymeshlab, or a pair of arrays, serves in place of both."),
            ("faces", "(m, 3) array of int, optional", "Ids of vertices, from 0 on, all oriented alike."),
            *map(documented, parameters),
            ("quality", "(n,) array of float, optional", "A value for each vertex, which curves follow with field 'quality' or 'auto'."),
            PROGRESS],
         "Raises": [("", kind, text) for kind, text in RAISES]},
        [">>> bspline_curve.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])",
         "<bspline_curve.Mesh: 3 vertices, 1 faces>"])
    body = ["    self._prepare(", "        vertices,", "        faces,", "        {", *given(parameters), "        },",
            "        quality,", "        progress,", "    )"]
    keywords = [*map(keyword, parameters), "quality: npt.ArrayLike | None = None", "progress: Progress | None = None"]
    return method("__init__", ["vertices: Any", "faces: npt.ArrayLike | None = None"], keywords, "None", doc, body)


def curve(parameters):
    doc = docstring(
        "Draw a smooth curve through points.",
        "A variational B-spline close to the surface, and its exact projection onto it, a polyline every segment of which "
        "lies inside one face.",
        {"Parameters": [PICKS, *map(documented, parameters), FIELD, QUALITY, AVOID, REGION, PROGRESS],
         "Returns": [("", "Curve", "Where it is not `usable`, it follows a shortest path, or shows how far it came.")],
         "Raises": [("", kind, text) for kind, text in RAISES]},
        [">>> curve = mesh.curve(picks, closed=True, field='ridge')",
         ">>> curve.closed, curve.usable, len(curve.picks)",
         "(True, True, 4)"])
    body = ["    return self._draw(", "        picks,", "        {", *given(parameters), "        },",
            "        {", *(f'            "{name}": {name},' for name in GUIDES), "        },", "        progress,", "    )"]
    keywords = [*map(keyword, parameters), *(f"{name}: {kind} = None" for name, kind in GUIDES.items()),
                "progress: Progress | None = None"]
    return method("curve", ["picks: Picks"], keywords, "Curve", doc, body)


def field(kind, parameters):
    doc = docstring(
        "Compute a scalar per vertex that curves can follow or avoid.",
        "It is the same in every unit and, but for the variation of normals, hardly depends on how fine the mesh is.",
        {"Parameters": [
            documented(kind),
            ("quality", "(n,) array of float, optional", "A value for each vertex, for kind 'quality'; None: the mesh's own."),
            ("region", "(k,) array of int or (m,) array of bool, optional", "The faces of obstacles, for kind 'obstacle'."),
            *map(documented, parameters), PROGRESS],
         "Returns": [("", "(n,) array of float", "A value for each vertex.")],
         "Raises": [("", kind, text) for kind, text in RAISES]},
        [">>> values = mesh.field('valley', curvature_scale=0.03)",
         ">>> values.shape",
         "(1681,)",
         ">>> curve = mesh.curve(picks, field=values, field_cost='exp-minus')"])
    body = ["    return self._make_field(", "        quality,", "        region,", "        {", *given([kind, *parameters]),
            "        },", "        progress,", "    )"]
    keywords = ["quality: npt.ArrayLike | None = None", "region: npt.ArrayLike | None = None",
                *map(keyword, parameters), "progress: Progress | None = None"]
    positional = [f"kind: FieldKind = {default_of(kind)}"]
    return method("field", positional, keywords, "Floats", doc, body)


def kinds(kind):
    words = ", ".join(f'"{o["id"]}"' for o in kind["enumOptions"])
    inner = textwrap.fill(words, WIDTH, initial_indent="    ", subsequent_indent="    ", break_on_hyphens=False)
    return f"FieldKind: TypeAlias = Literal[\n{inner},\n]"


def keywords(filters):
    """The text of _keywords.py."""
    of_curve, of_field = filters[:2]
    for parameter in of_curve["parameters"]:
        if parameter["id"] in NONE_IN_PYTHON and parameter["default"] != "none":
            raise SystemExit(f"{parameter['id']} is {parameter['default']} by default: None cannot stand for it in Python")
    shell = parameters_of(of_curve, is_of_shell)
    drawing = parameters_of(of_curve, lambda p: not is_of_shell(p))
    guides = [p for p in of_curve["parameters"] if p["id"] in NONE_IN_PYTHON]
    kind = next(p for p in of_field["parameters"] if p["id"] == "kind")
    fields = parameters_of(of_field, lambda p: p["id"] not in ("strict", "weld", "slits"))
    return "\n".join([
        HEAD + '"""Keywords of meshes, curves and fields."""', "",
        "from __future__ import annotations", "",
        "from abc import ABC, abstractmethod",
        "from collections.abc import Mapping, Sequence",
        "from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypedDict", "",
        "import numpy.typing as npt", "",
        "from ._arrays import Floats, Picks", "from ._options import Option, Progress", "",
        "if TYPE_CHECKING:", "    from ._curve import Curve", "",
        aliases([p for p in [*shell, *guides, *drawing, *fields] if p["type"] == "enum"], False), kinds(kind), "",
        table("SHELL", shell), table("CURVE", drawing), table("FIELD", [kind, *fields]), "", "",
        options_of_mesh(shell), "", "",
        typed_dict(drawing), "", "",
        "class MeshKeywords(ABC):",
        '    """What a mesh does, with its options as keywords."""', "",
        init(shell), "", curve(drawing), "", field(kind, fields), "",
        "    @abstractmethod",
        "    def _prepare(",
        "        self,",
        "        vertices: Any,",
        "        faces: npt.ArrayLike | None,",
        "        options: Mapping[str, object],",
        "        quality: npt.ArrayLike | None,",
        "        progress: Progress | None,",
        "    ) -> None: ...", "",
        "    @abstractmethod",
        "    def _draw(",
        "        self,",
        "        picks: Picks,",
        "        options: Mapping[str, object],",
        "        guides: Mapping[str, Any],",
        "        progress: Progress | None,",
        "    ) -> Curve: ...", "",
        "    @abstractmethod",
        "    def _make_field(",
        "        self,",
        "        quality: npt.ArrayLike | None,",
        "        region: npt.ArrayLike | None,",
        "        options: Mapping[str, object],",
        "        progress: Progress | None,",
        "    ) -> Floats: ...", "",
    ])
