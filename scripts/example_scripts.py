#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the filter scripts of examples/mlx from the description of the filters.

meshlabserver ends unless a script lists every parameter, so these are made, not typed: what an example changes is in
EXAMPLES below, all else are the defaults of filters/filters.json. Advanced parameters of the filter for curves are left
out: in MeshLab 2020.09 it has none (those are in its twin "(All Options)"), and later versions fill them in. Run this
again after the description changed; a test checks that the files are what it writes.

    scripts/example_scripts.py           writes them
    scripts/example_scripts.py --check   exit status 1 if one is not up to date
"""
import argparse
import json
import sys
from pathlib import Path
from xml.sax.saxutils import quoteattr

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "examples" / "mlx"
CURVE = "generate_bspline_curve_on_surface"
ALL_OPTIONS = CURVE + "_all_options"  # in MeshLab 2020.09 only
FIELD = "compute_scalar_field_for_curves_per_vertex"

# The picks of examples/bunny.pp.
BUNNY_PICKS = (
    "0.1 0.11 0.469543; 0.25 0.225 0.473064; 0.43 0.265 0.462532; 0.545 0.11 0.436417; 0.42 0 0.512757; "
    "0.325 0.08 0.532522; 0.4 0.155 0.537699"
)

# Of each script: what it is for, and its filters with the parameters that differ from the defaults.
EXAMPLES = {
    "curve_from_text.mlx": ("A curve through picks that stand in the script.", [(CURVE, {"picks": BUNNY_PICKS})]),
    "curve_from_file.mlx": (
        "A curve through the picks of a file; relative paths begin where the host was started.",
        [(CURVE, {"picks_file": "bunny.pp"})],
    ),
    "closed_curve.mlx": (
        "A closed curve of degree 4, no segment of which is longer than 0.005.",
        [(CURVE, {"picks": BUNNY_PICKS, "closed": True, "degree": 4, "max_segment_length": 0.005})],
    ),
    "field_and_curve.mlx": (
        "Valleys as the quality of the mesh, and a curve that follows them.",
        [
            (FIELD, {"kind": "valley", "smoothing": 0.02, "normalised": True}),
            (CURVE, {"picks": BUNNY_PICKS, "field": "quality", "field_cost": "exp-minus", "field_weight": 200.0}),
        ],
    ),
}


def attributes(parameter, value):
    """Type and value of a parameter as MeshLab 2020.09 spells them; later versions read the same."""
    kind = parameter["type"]
    if kind == "mesh":  # a layer's number; the default stands for the current layer
        return {"type": "RichMesh", "value": str(value if isinstance(value, int) else 0)}
    if kind == "bool":
        return {"type": "RichBool", "value": str(value).lower()}
    if kind == "int":
        return {"type": "RichInt", "value": str(value)}
    if kind == "double" and parameter.get("slider"):
        limits = {"min": repr(parameter["min"]), "max": repr(parameter["max"])}
        return {"type": "RichDynamicFloat", "value": repr(value), **limits}
    if kind == "double":
        return {"type": "RichFloat", "value": repr(value)}
    if kind == "absperc":
        return {"type": "RichAbsPerc", "value": repr(value), "min": "0", "max": "1"}
    if kind == "enum":
        ids = [option["id"] for option in parameter["enumOptions"]]
        listed = {f"enum_val{i}": name for i, name in enumerate(ids)}
        return {"type": "RichEnum", "value": str(ids.index(value)), "enum_cardinality": str(len(ids)), **listed}
    if kind == "openFile":
        patterns = ["*" + extension for extension in parameter["extensions"]]
        listed = {f"exts_val{i}": pattern for i, pattern in enumerate(patterns)}
        return {"type": "RichOpenFile", "value": value, "exts_cardinality": str(len(patterns)), **listed}
    if kind == "saveFile":
        patterns = " ".join("*" + extension for extension in parameter["extensions"])
        return {"type": "RichSaveFile", "value": value, "ext": patterns}
    if kind in ("string", "length", "tolerances", "picks", "tangents"):
        return {"type": "RichString", "value": value}
    raise ValueError(f"{parameter['id']}: unknown type {kind}")


def is_listed(filter_id, parameter):
    if parameter["group"] == "window":
        return False
    return filter_id != CURVE or not parameter["group"].startswith("advanced")


def filter_lines(description, changes):
    """The lines of one filter. Refuses changes of parameters that it does not have."""
    parameters = [parameter for parameter in description["parameters"] if is_listed(description["id"], parameter)]
    unknown = set(changes) - {parameter["id"] for parameter in parameters}
    if unknown:
        raise ValueError(f"{description['id']} has no parameter {', '.join(sorted(unknown))}")
    lines = [f" <filter name={quoteattr(description['name'])}>"]
    for parameter in parameters:
        value = changes.get(parameter["id"], parameter["default"])
        words = {"name": parameter["id"], **attributes(parameter, value), "description": parameter["label"]}
        lines.append("  <Param " + " ".join(f"{key}={quoteattr(word)}" for key, word in words.items()) + "/>")
    return [*lines, " </filter>"]


def script(purpose, filters, described):
    lines = ["<!DOCTYPE FilterScript>", f"<!-- {purpose} Made by scripts/example_scripts.py. -->", "<FilterScript>"]
    for name, changes in filters:
        lines += filter_lines(described[name], changes)
    return "\n".join([*lines, "</FilterScript>"]) + "\n"


def descriptions():
    """The filters' descriptions by id, with the twin that MeshLab 2020.09 has for all options."""
    described = {each["id"]: each for each in json.loads((ROOT / "filters" / "filters.json").read_text())["filters"]}
    twin = {**described[CURVE], "id": ALL_OPTIONS, "name": described[CURVE]["name"] + " (All Options)"}
    return {**described, ALL_OPTIONS: twin}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    arguments = parser.parse_args()
    described = descriptions()
    stale = []
    for name, (purpose, filters) in EXAMPLES.items():
        path, text = FOLDER / name, script(purpose, filters, described)
        if not path.is_file() or path.read_text() != text:
            stale.append(name)
            if not arguments.check:
                path.write_text(text)
    if arguments.check and stale:
        sys.exit(f"not up to date: {', '.join(stale)}; run scripts/example_scripts.py")


if __name__ == "__main__":
    main()
