#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/PYTHON_REFERENCE.md from the docstrings of the package bspline_curve, which is read and not imported.

    scripts/python_reference.py           # writes the page
    scripts/python_reference.py --check   # exit status 1 where it is not what the docstrings say
"""

import argparse
import ast
import re
import sys
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "python" / "bspline_curve"
PAGE = ROOT / "docs" / "PYTHON_REFERENCE.md"

HEAD = """# Reference of bspline_curve

<!-- Made by scripts/python_reference.py from the docstrings; do not edit. -->

[PYTHON.md](PYTHON.md) introduces the package; `help(bspline_curve.Mesh.curve)` says the same as this page. In the examples
`mesh` is a wavy square, `picks` are four points on it, `curve` is the open curve through them and `ring` a closed one.
"""
# In this order; of a mesh, the methods with keywords stand in a class that is generated.
NAMES = ["Mesh", "Curve", "Samples", "load", "load_all", "pick", "Picker", "Imprint", "Part", "Cut", "Pattern", "Distortion", "repair",
         "Repair", "Projection", "Shell", "Layer",
         "InputError", "MeshError", "MeshWarning", "PickError", "FieldError", "OptionError", "FileError", "Cancelled"]
INHERITED = {"Mesh": "MeshKeywords"}


def definitions():
    found = {}
    for path in sorted(PACKAGE.glob("*.py")):
        for node in ast.parse(path.read_text()).body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                found[node.name] = node
    return found


def escaped(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def entries(lines):
    """Bullets of the entries of a section: heads stand at the margin, texts are indented."""
    bullets = []
    for line in lines:
        if line and not line.startswith(" "):
            name, colon, kind = line.partition(" : ")
            bullets.append([f"`{name}`" + (f" ({escaped(kind)})" if colon else ""), []])
        elif line.strip():
            if bullets:
                bullets[-1][1].append(line.strip())
    return "\n".join(f"- {head}" + (": " + escaped(" ".join(text)) if text else "") for head, text in bullets)


def unwrapped_heads(text):
    """A head that goes on in an indented line, before its text, is one line: types may be long."""
    return re.sub(r"(?m)^(\S[^\n]* : \{[^}\n]*)\n\s+([^}]*\}[^\n]*)$", lambda m: m[1] + " " + " ".join(m[2].split()), text)


def markdown(doc):
    parts = re.split(r"(?m)^(Parameters|Returns|Raises|Attributes|Examples)\n-+\n", unwrapped_heads(doc))
    text = [escaped(parts[0].strip())]
    for title, body in zip(parts[1::2], parts[2::2]):
        body = textwrap.dedent(body).rstrip()
        if title == "Examples":
            text.append(f"```python\n{body}\n```")
            continue
        listed, _, rest = body.partition("\n\n")
        text += [f"*{title}*", entries(listed.splitlines())]
        if rest.strip():
            text.append(escaped(textwrap.dedent(rest).strip()))
    return "\n\n".join(text)


def signature(node, owner=""):
    arguments = ast.parse(ast.unparse(node)).body[0].args
    for each in [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs, *filter(None, [arguments.kwarg])]:
        each.annotation = None
    if owner:
        arguments.args = arguments.args[1:]
    name = owner if node.name == "__init__" else f"{owner and owner.lower() + '.'}{node.name}"
    return "\n".join(textwrap.wrap(f"{name}({ast.unparse(arguments)})", 110, subsequent_indent="    "))


def section(name, node, found, level="##"):
    if isinstance(node, ast.FunctionDef):
        return f"{level} {name}\n\n```python\n{signature(node)}\n```\n\n{markdown(ast.get_docstring(node))}\n"
    doc = ast.get_docstring(node)
    parts = [f"{level} {name}\n"] + ([markdown(doc) + "\n"] if doc else [])
    members = [*(found[INHERITED[name]].body if name in INHERITED else []), *node.body]
    for member in members:
        if not isinstance(member, ast.FunctionDef) or any(
            isinstance(d, ast.Name) and d.id in ("property", "abstractmethod") for d in member.decorator_list
        ):
            continue
        text = ast.get_docstring(member)
        if text and (not member.name.startswith("_") or member.name == "__init__"):
            title = name if member.name == "__init__" else member.name
            parts.append(f"### {title}{' ' if title == name else ''}{'(…)' if title == name else ''}\n\n```python\n{signature(member, name)}\n```\n\n{markdown(text)}\n")
    return "\n".join(parts)


def page():
    found = definitions()
    return HEAD + "\n" + "\n".join(section(name, found[name], found) for name in NAMES)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing")
    text = page()
    if parser.parse_args().check:
        if not PAGE.is_file() or PAGE.read_text() != text:
            sys.exit(f"{PAGE.name} is not what the docstrings say; run scripts/python_reference.py")
        return
    PAGE.write_text(text)


if __name__ == "__main__":
    main()
