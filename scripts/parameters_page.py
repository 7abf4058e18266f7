#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/PARAMETERS.md from filters/filters.json.

    scripts/parameters_page.py           # writes the page
    scripts/parameters_page.py --check   # exit status 1 where the page is not what the description says
"""

import argparse
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DESCRIPTION = ROOT / "filters" / "filters.json"
PAGE = ROOT / "docs" / "PARAMETERS.md"

INTRODUCTION = """\
# Parameters

`scripts/parameters_page.py` makes this page from [filters/filters.json](../filters/filters.json); the dialogs of MeshLab,
pymeshlab, scripts and the program show the same texts. The program writes dashes for underscores (`--avoid-margin`) and
flags without a value. It does not have the parameters marked with °, which name layers and selections; it has options for
files instead ([COMMAND_LINE.md](COMMAND_LINE.md)).
"""

GROUPS = {
    "main": "",
    "window": "In MeshLab's window alone",
    "further.picks": "Picks from elsewhere",
    "further.field": "Cost of the field",
    "further.avoid": "Faces to avoid",
    "further.polyline": "The polyline",
    "further.shell": "Where the curve is sought",
    "further.pattern": "More of patterns",
    "further.join": "More of joints",
    "advanced.curves": "How curves come onto the mesh",
    "advanced.layers": "Further layers",
    "advanced.avoid": "How faces are avoided",
    "advanced.field": "The field",
    "advanced.method": "The method",
    "advanced.shell": "The shell",
    "advanced.paper": "The paper's numbers",
    "advanced.solids": "Solids",
    "advanced.limits": "Limits",
}

# Those that the program has no option for: it has files in place of layers and selections.
OF_HOSTS = {
    "surface_layer", "replace", "picks_layer", "picks_file", "picks", "field_region", "region",
    "tube_radius", "save", "control_polygon", "shell_layers",
    "curve_layer", "max_distance", "project_curves", "seed", "offset", "select_band",
}


def number(value):
    return f"{value:g}" if isinstance(value, float) else str(value)


def default_of(parameter):
    value = parameter["default"]
    if parameter["type"] == "mesh":
        return "current layer"
    if isinstance(value, bool):
        return "on" if value else "off"
    return "none" if value == "" else number(value)


def values_of(parameter):
    """What may be given."""
    kind = parameter["type"]
    if kind == "enum":
        return ", ".join(f"`{option['id']}`" for option in parameter["enumOptions"])
    if kind == "bool":
        return "on, off"
    if kind == "mesh":
        return "a layer"
    if kind in ("openFile", "saveFile"):
        return ", ".join(f"`{extension}`" for extension in parameter["extensions"])
    if kind == "length":
        return "a length, or so many `edges`"
    if kind == "tolerances":
        return "a length, or so many `edges`, or a `weight`; or one for each pick"
    if kind == "picks":
        return "numbers of picks, or `all`"
    if kind == "tangents":
        return "numbers of picks, each with a direction, or two"
    if kind == "string":
        return "text"
    low, high = parameter.get("min"), parameter.get("max")
    if kind == "absperc":
        return "a length, or a share of the diagonal"
    if high is not None:
        return f"{'(' if parameter.get('excludesMin') else '['}{number(low)}, {number(high)}]"
    if low is None:
        return "any number"
    return f"{'>' if parameter.get('excludesMin') else '≥'} {number(low)}"


def meaning_of(parameter):
    text = parameter["help"]
    options = [f"`{o['id']}`: {o['help']}" for o in parameter.get("enumOptions", []) if "help" in o]
    if options:
        text += " " + "; ".join(options) + "."
    if condition := parameter.get("enabledWhen"):
        text += f" Only with `{condition['parameter']}` " + " or ".join(f"`{v}`" for v in condition["in"]) + "."
    return text.replace("|", "\\|")


def table(parameters):
    lines = ["| parameter | default | values | meaning |", "|---|---|---|---|"]
    for p in parameters:
        mark = "°" if p["id"] in OF_HOSTS else ""
        lines.append(f"| `{p['id']}`{mark} | {default_of(p)} | {values_of(p)} | {meaning_of(p)} |")
    return "\n".join(lines)


def section(description, flt):
    references = {r["id"]: r for r in description["references"]}
    parts = [f"## {flt['name']}", f"`{flt['pythonName']}`", flt["longDescriptionMarkdown"]]
    for key in flt["referenceIds"]:
        reference = references[key]
        year = reference["issued"]["date-parts"][0][0]
        parts.append(f"[*{reference['title']}*]({reference['URL']}), {reference['container-title']}, {year}.")
    for group, title in GROUPS.items():
        members = [p for p in flt["parameters"] if p["group"] == group]
        if members:
            parts += ([f"### {title}"] if title else []) + [table(members)]
    unknown = {p["group"] for p in flt["parameters"]} - set(GROUPS)
    if unknown:
        raise SystemExit(f"parameters_page.py: groups without a title: {', '.join(sorted(unknown))}")
    return "\n\n".join(parts)


def page():
    description = json.loads(DESCRIPTION.read_text())
    return "\n".join([INTRODUCTION, *(section(description, f) + "\n" for f in description["filters"])])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    check = parser.parse_args().check
    text = page()
    if not check:
        PAGE.write_text(text)
    elif not PAGE.is_file() or PAGE.read_text() != text:
        sys.exit("docs/PARAMETERS.md is not what filters/filters.json says: run scripts/parameters_page.py")


if __name__ == "__main__":
    main()
