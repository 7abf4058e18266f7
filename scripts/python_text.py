# SPDX-License-Identifier: GPL-3.0-or-later
"""Python code as text, from descriptions of parameters; for scripts/python_filters.py and scripts/python_keywords.py."""

import json
import textwrap

WIDTH = 120
HEAD = """\
# SPDX-License-Identifier: GPL-3.0-or-later
# Made from filters/filters.json by scripts/python_filters.py; do not edit.
"""


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
    if kind == "length":
        return "float | str"
    if kind == "tolerances":
        return "float | str | Sequence[float | str]"
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


def docstring(summary, extended, sections, examples=()):
    """numpydoc; sections: title -> [(name, type, text)], without a name where it is empty; examples: lines as they are."""
    lines = [f'"""{summary}', "", *textwrap.wrap(extended, WIDTH - 4, break_on_hyphens=False)]
    for title, entries in sections.items():
        lines += ["", title, "-" * len(title)]
        for name, kind, text in entries:
            head = f"{name} : {kind}" if name else kind
            lines += textwrap.wrap(head, WIDTH - 4, subsequent_indent="    ", break_on_hyphens=False)
            lines += textwrap.wrap(text, WIDTH - 4, initial_indent="    ", subsequent_indent="    ", break_on_hyphens=False)
    if examples:
        lines += ["", "Examples", "--------", *examples]
    return "\n".join(("    " + line).rstrip() for line in [*lines, '"""'])


def plain(markdown):
    return markdown.replace("*", "").replace("\n\n", " ")


def function(name, positional, keywords, result, doc, body):
    arguments = [*positional, "*", *keywords]
    lines = [f"def {name}(", *(f"    {argument}," for argument in arguments), f") -> {result}:", doc, *body]
    return "\n".join(lines)
