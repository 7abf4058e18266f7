# SPDX-License-Identifier: GPL-3.0-or-later
"""Text on a mesh: the letters are those that the program carries."""
import json
import os
import subprocess
import sys

import numpy as np
import pytest

from bspline_curve import FileError, InputError, Mesh, OptionError, _core

CENTRE = [0.5, 0.5, 0]


@pytest.fixture(scope="module")
def plate(wavy):
    return Mesh(*wavy(13, height=0, low=0))


@pytest.fixture(scope="module")
def font():
    pytest.importorskip("fontTools")
    try:
        return _core.font_or_default("")
    except InputError:
        pytest.skip("no well-known font on this system")


def curves_of_program(build_folder, plate, folder, *options):
    vertices = "\n".join(f"{x!r} {y!r} {z!r}" for x, y, z in plate.vertices.tolist())
    faces = "\n".join(f"3 {a} {b} {c}" for a, b, c in plate.faces.tolist())
    (folder / "plate.off").write_text(f"OFF\n{len(plate.vertices)} {len(plate.faces)} 0\n{vertices}\n{faces}\n")
    program = build_folder / "bin" / "bspline_curve"
    run = subprocess.run([program, "pattern", "plate.off", *options, "--output", "p.json"], cwd=folder, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return json.loads((folder / "p.json").read_text())["curves"]


def dense(points):
    return np.concatenate([np.linspace(a, b, 50) for a, b in zip(points, points[1:])])


# Letters with holes, with accents made of parts, pairs that are kerned, blanks.
@pytest.mark.parametrize("text", ["B8&g", "ÄéÅ", "AVATo", "i j"])
def test_its_curves_are_those_of_the_program(build_folder, plate, font, text, tmp_path):
    pattern = plate.pattern(text=text, font=font, centre=CENTRE, size=0.6)
    other = curves_of_program(build_folder, plate, tmp_path, "--text", text, "--font", font, "--centre", "0.5,0.5,0", "--size", "0.6")
    assert len(pattern.curves) == len(other) > 0
    # FreeType rounds points of the outline that a font leaves out to its unit, about 1/2000 em.
    reach = 2 * pattern.tolerance + 0.6 / 1000
    for curve, same in zip(pattern.curves, other):
        points = np.array(same["polyline"]["points"])
        assert curve.closed == same["closed"]
        assert curve.length == pytest.approx(np.linalg.norm(np.diff(points, axis=0), axis=1).sum(), rel=0.01, abs=curve.closed * 0.02)
        apart = np.linalg.norm(curve.points[:, None] - dense(points), axis=2).min(axis=1)
        assert apart.max() <= reach


def test_letters_stand_on_a_curve(plate, font):
    line = plate.curve([[0.1, 0.5, 0], [0.9, 0.5, 0]])
    points = np.concatenate([curve.points for curve in plate.pattern(text="HE", along=line, size=0.2).curves])
    assert points[:, 1].min() == pytest.approx(0.5, abs=1e-6)


def test_refusals(plate, font, tmp_path):
    (tmp_path / "no.ttf").write_text("no font")
    for error, said, arguments in [
        (InputError, "drawing and text", {}),
        (InputError, "drawing and text", {"text": "a", "drawing": "M0 0L1 1"}),
        (InputError, "font is for text", {"drawing": "M0 0L1 1", "font": font}),
        (InputError, r"in \.dxf alone", {"text": "a", "layers": ["x"]}),
        (OptionError, "nothing but blanks", {"text": " "}),
        (TypeError, "text is 3", {"text": 3}),
        (FileError, r"no glyph for the character U\+13000", {"text": "\U00013000", "font": font}),
        (FileError, "no.ttf: is no font", {"text": "a", "font": tmp_path / "no.ttf"}),
        (FileError, "there is no such file", {"text": "a", "font": tmp_path / "none.ttf"}),
    ]:
        with pytest.raises(error, match=said):
            plate.pattern(centre=CENTRE, **arguments)


def test_without_fonttools_it_says_what_to_install(plate, monkeypatch):
    monkeypatch.setitem(sys.modules, "fontTools.pens.svgPathPen", None)
    with pytest.raises(ImportError, match="pip install fonttools"):
        plate.pattern(text="a", centre=CENTRE)


def test_without_any_font_it_is_refused(plate, monkeypatch, tmp_path):
    pytest.importorskip("fontTools")
    for name in ("HOME", "XDG_DATA_DIRS", "XDG_DATA_HOME"):
        monkeypatch.setitem(os.environ, name, str(tmp_path))
    with pytest.raises(InputError, match="no font was found"):
        plate.pattern(text="a", centre=CENTRE)
