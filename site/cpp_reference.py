# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of the public headers: site/cpp_reference.py XML FOLDER, from the XML that Doxygen makes of include/."""

import re
import sys
from collections import defaultdict
from pathlib import Path
from xml.etree import ElementTree

NAMESPACE = "bspline_curve::"
KINDS = {"struct": "struct", "class": "class", "enum": "enumeration", "function": "function", "typedef": "type", "variable": "constant"}


def escaped(text):
    return re.sub(r"([\\`*_\[\]<>|#$])", r"\\\1", text)


def inline(node):
    """The text of a paragraph, with what is marked as code."""
    parts = [escaped(node.text or "")]
    for child in node:
        if child.tag == "computeroutput":
            parts.append(f"`{''.join(child.itertext())}`")
        elif child.tag in ("itemizedlist", "orderedlist"):
            parts.append("\n\n" + "".join(f"- {described(item)}\n" for item in child) + "\n")
        elif child.tag not in ("parameterlist", "simplesect"):
            parts.append(inline(child))
        parts.append(escaped(child.tail or ""))
    return "".join(parts)


def described(node):
    """Comments of an element as Markdown."""
    paragraphs = [inline(para).strip() for tag in ("briefdescription", "detaileddescription", "inbodydescription")
                  for para in node.findall(f"{tag}/para")] or [inline(para).strip() for para in node.findall("para")]
    return "\n\n".join(text for text in paragraphs if text)


def words(node, path):
    return "".join(node.find(path).itertext()) if node.find(path) is not None else ""


def declared(member):
    """The declaration, without the names of what it is within."""
    kind, name = member.get("kind"), words(member, "name")
    if kind == "enum":
        return f"enum class {name}"
    if kind == "typedef":
        return f"using {name} = {words(member, 'type')}"
    text = " ".join(part for part in (words(member, "type"), name) if part) + words(member, "argsstring")
    initial = words(member, "initializer").strip()
    if initial and "\n" not in initial and len(initial) < 60:
        text += f" {initial}" if initial.startswith("=") else initial
    return text.replace(NAMESPACE, "").replace("< ", "<").replace(" >", ">").replace(" &", "&").replace(" *", "*")


def listed(members):
    """Members in the order of the header."""
    lines = []
    for member in members:
        text = described(member).replace("\n\n", " ").replace("\n", " ")
        lines.append(f"- `{declared(member)}`" + (f": {text}" if text else ""))
        for value in member.findall("enumvalue"):
            meant = described(value).replace("\n", " ")
            lines.append(f"  - `{words(value, 'name')}`" + (f": {meant}" if meant else ""))
    return "\n".join(lines)


def place(node):
    location = node.find("location")
    return Path(location.get("file")).name, int(location.get("line"))


def members_of(compound):
    found = [member for member in compound.iter("memberdef") if member.get("prot") == "public"]
    return sorted(found, key=lambda member: place(member)[1])


def entries(xml):
    """header -> [(line, title, text)]"""
    found = defaultdict(list)
    for file in sorted(xml.glob("*.xml")):
        for compound in ElementTree.parse(file).getroot().iter("compounddef"):
            kind, name = compound.get("kind"), words(compound, "compoundname").removeprefix(NAMESPACE)
            if kind in ("struct", "class"):
                header, line = place(compound)
                members = [m for m in members_of(compound) if m.get("kind") != "friend"]
                found[header].append((line, f"{name} ({kind})", "\n\n".join(filter(None, [described(compound), listed(members)]))))
            elif kind == "namespace" and words(compound, "compoundname") + "::" == NAMESPACE:
                for member in members_of(compound):
                    header, line = place(member)
                    body = f"```cpp\n{declared(member)};\n```"
                    values = "\n".join(listed([member]).splitlines()[1:])
                    text = "\n\n".join(filter(None, [body, described(member), values]))
                    found[header].append((line, f"{words(member, 'name')} ({KINDS[member.get('kind')]})", text))
    return found


def main():
    xml, output = map(Path, sys.argv[1:])
    output.mkdir(parents=True, exist_ok=True)
    pages = entries(xml)
    for header, parts in pages.items():
        sections = [f"## {title}\n\n{text}\n" for _, title, text in sorted(parts)]
        head = f"# {header}\n\n```cpp\n#include <bspline_curve/{header}>\n```\n"
        (output / f"{Path(header).stem}.md").write_text("\n".join([head, *sections]))
    names = "\n".join(sorted(Path(header).stem for header in pages))
    (output / "index.md").write_text(
        "# C++ reference\n\nThe public headers, made from their comments. [C++](../docs/CPP.md) tells how to link the library; "
        f"`bspline_curve.h` includes them all.\n\n```{{toctree}}\n{names}\n```\n")


if __name__ == "__main__":
    main()
