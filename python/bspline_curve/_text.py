# SPDX-License-Identifier: GPL-3.0-or-later
"""A line of text as a drawing, in the letters of a font."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any

from . import _core
from ._errors import FileError, OptionError


def text_drawing(text: str, font: str | os.PathLike[str]) -> _core.Drawing:
    """The outlines of a text: one unit is the font's em, and the letters stand on y = 0. Needs fontTools."""
    if not isinstance(text, str):
        raise TypeError(f"text is {text!r}, but must be a str")
    if not text.strip():
        raise OptionError("the text has nothing but blanks", "bad-option")
    try:
        from fontTools.pens.svgPathPen import SVGPathPen
        from fontTools.pens.transformPen import TransformPen
    except ImportError:
        raise ImportError("text needs fontTools: run pip install fonttools") from None
    with _opened(_core.font_or_default(os.fspath(font))) as file:
        glyphs = file.getGlyphSet()
        pen = SVGPathPen(glyphs, ntos=repr)  # all digits
        em = 1.0 / file["head"].unitsPerEm
        for name, x in _places(file, text):
            # Path data have y downwards.
            glyphs[name].draw(TransformPen(pen, (em, 0.0, 0.0, -em, em * x, 0.0)))
        return _core.text_drawing(pen.getCommands())


def _opened(name: str) -> Any:
    from fontTools.ttLib import TTFont, TTLibError

    try:
        return TTFont(name, fontNumber=0, lazy=True)
    except FileNotFoundError:
        raise FileError(f"{name}: there is no such file", "unreadable-file") from None
    except (TTLibError, OSError) as error:
        raise FileError(f"{name}: is no font that can be read ({error}); give a .ttf or .otf", "unreadable-file") from None


def _places(file: Any, text: str) -> Iterator[tuple[str, int]]:
    """The glyphs and where they begin, in the font's units; kerning is that of the table kern."""
    names = file.getBestCmap()
    tables = file["kern"].kernTables if "kern" in file else []
    kerning: dict[tuple[str, str], int] = next((table.kernTable for table in tables if hasattr(table, "kernTable")), {})
    x, last = 0, ""
    for character in text:
        name = names.get(ord(character))
        if name is None:
            where = f"{file.reader.file.name}: the font has no glyph for the character U+{ord(character):04X}"
            raise FileError(where, "unreadable-file")
        x += kerning.get((last, name), 0)
        yield name, x
        x += file["hmtx"][name][0]
        last = name
