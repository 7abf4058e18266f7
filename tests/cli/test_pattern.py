# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb pattern: a drawing as curves on the surface."""

import json

import made_meshes as meshes
import numpy as np
import pytest

STAR = "<svg><path d='M0 -4 L1 -1 L4 0 L1 1 L0 4 L-1 1 L-4 0 L-1 -1Z'/><circle r='3'/></svg>"


@pytest.fixture
def scene(tmp_path):
    """A flat plate of 1 by 1, and a star with a circle of radius 3 of 8."""
    meshes.write_ply(tmp_path / "plate.ply", *meshes.plate(cells=12))
    (tmp_path / "star.svg").write_text(STAR)
    return tmp_path


def curves_of(path):
    return json.loads(path.read_text())["curves"]


def points_of(curve):
    return np.array(curve["polyline"]["points"])


def test_a_drawing_comes_out_as_drawn(run, scene):
    result = run("pattern", "plate.ply", "--drawing", "star.svg", "--centre", "0.5,0.4,0", "--size", 0.4,
                 "--output", "star.json", "--report", "report.json")
    assert (result.returncode, result.stderr) == (0, "")
    curves = curves_of(scene / "star.json")
    assert [curve["closed"] for curve in curves] == [False] * 8 + [True]
    assert np.allclose(points_of(curves[0])[[0, -1]], [[0.5, 0.6, 0], [0.55, 0.45, 0]], rtol=0, atol=1e-7)
    radii = np.linalg.norm(points_of(curves[8]) - [0.5, 0.4, 0], axis=1)
    assert np.abs(radii / 0.15 - 1).max() < 2e-3
    for curve, after in zip(curves[:8], [*curves[1:8], curves[0]]):
        assert curve["polyline"]["points"][-1] == after["polyline"]["points"][0]
    report = json.loads((scene / "report.json").read_text())
    assert [each["path"] for each in report["curves"]] == [0] * 8 + [1]
    assert report["largest_deviation"] <= report["tolerance"]
    for distortion in report["distortion"].values():
        assert distortion["ratio"] == pytest.approx(1, abs=2e-3)


def test_what_it_writes_is_what_imprint_takes(run, scene):
    run.ok("pattern", "plate.ply", "--drawing", "star.svg", "--centre", "0.5,0.5,0", "--output", "p.json")
    run.ok("imprint", "plate.ply", "--curve", "p.json", "--output", "i.ply", "--report", "r.json")
    report = json.loads((scene / "r.json").read_text())
    assert report["curves"] == 9
    # Outside, the star, the circle, and what of each is not in the other: four tips, four notches.
    assert len(report["parts"]) == 10
    assert report["crossings"] == 8


@pytest.mark.parametrize("name", ["p.ply", "p.obj", "p.dxf"])
def test_all_curves_are_in_one_file(run, scene, name):
    run.ok("pattern", "plate.ply", "--drawing", "star.svg", "--centre", "0.5,0.5,0", "--output", name)
    words = (scene / name).read_bytes()
    if name.endswith(".dxf"):
        assert words.count(b"\nPOLYLINE\n8\n") == 9
    else:
        run("pattern", "plate.ply", "--drawing", "star.svg", "--centre", "0.5,0.5,0", "--output", "p.json")
        counts = [len(points_of(curve)) for curve in curves_of(scene / "p.json")]
        segments = sum(counts) - 8
        expected = f"element edge {segments}\n".encode() if name.endswith(".ply") else b""
        assert expected in words
        assert name.endswith(".ply") or (words.count(b"\nl "), words.count(b"\nv ")) == (segments, sum(counts))


def test_along_a_curve(run, scene):
    (scene / "picks.json").write_text(json.dumps({"picks": [[0.1, 0.5, 0], [0.9, 0.5, 0]]}))
    run.ok("plate.ply", "--picks", "picks.json", "--output", "line.json")
    run.ok("pattern", "plate.ply", "--drawing", "star.svg", "--along", "line.json", "--repeat", 4, "--size", 0.1,
                 "--shift", 0.2, "--output", "row.json", "--report", "report.json")
    curves = curves_of(scene / "row.json")
    assert len(curves) == 36
    middles = np.array([points_of(curves[i]).mean(0) for i in range(8, 36, 9)])
    assert np.abs(middles[:, 1] - 0.7).max() < 2e-3
    assert np.abs(middles[:, 0] - np.linspace(0.15, 0.85, 4)).max() < 2e-3
    assert [each["copy"] for each in json.loads((scene / "report.json").read_text())["curves"]] == [i // 9 for i in range(36)]


def test_refusals(run, refused, scene):
    pattern = ["pattern", "plate.ply", "--drawing", "star.svg", "--output", "p.json"]
    refused(2, *pattern, says=["--centre", "--along"])
    refused(2, *pattern, "--centre", "0.5,0.5", says=["--centre"])
    refused(2, *pattern, "--centre", "0.5,0.5,0", "--size", 1, "--scale", 1, says=["--scale"])
    refused(2, *pattern, "--centre", "0.5,0.5,0", "--repeat", 2, says=["--along"])
    refused(1, *pattern, "--centre", "0.5,0.5,3", says=["the centre is 3 away"])
    refused(1, *pattern, "--centre", "0.5,0.5,0", "--up", "0,0,1", says=["normal"])
    refused(1, *pattern, "--centre", "0.5,0.5,0", "--size", 1.2, says=["path 0", "beyond the boundary"])
    refused(1, "pattern", "plate.ply", "--drawing", "no.svg", "--centre", "0.5,0.5,0", "--output", "p.json", says=["no.svg"])
    refused(1, "pattern", "plate.ply", "--drawing", "star.svg", "--centre", "0.5,0.5,0", "--output", "p.csv", says=["holds one curve"])
    refused(1, *pattern, "--centre", "0.5,0.5,0", "--layers", "a", says=["star.svg: layers are chosen in .dxf alone"])
    refused(2, *pattern, "--centre", "0.5,0.5,0", "--direction", "0,0,1", says=["--along"])
    (scene / "empty.json").write_text('{"curves": []}')
    refused(1, *pattern, "--along", "empty.json", says=["no list of curves"])


@pytest.fixture
def without_fonts(monkeypatch, tmp_path):
    """A system without fonts; what is put into fonts/ there is found."""
    for name in ("HOME", "XDG_DATA_DIRS", "XDG_DATA_HOME"):
        monkeypatch.setenv(name, str(tmp_path))
    return tmp_path


def test_a_text_takes_a_font_of_the_system_and_says_which(run, scene):
    text = ["pattern", "plate.ply", "--text", "io", "--centre", "0.5,0.5,0", "--report", "report.json"]
    found = run(*text, "--output", "found.json")
    if "no font was found" in found.stderr:
        pytest.skip("no well-known font on this system")
    assert found.returncode == 0, found.stderr
    font = json.loads((scene / "report.json").read_text())["font"]
    assert found.stderr == f"bspline_curve: note: the font is {font}; --font chooses another\n"
    given = run(*text, "--font", font, "--output", "given.json")
    assert (given.returncode, given.stderr) == (0, "")
    assert curves_of(scene / "given.json") == curves_of(scene / "found.json")
    assert json.loads((scene / "report.json").read_text())["font"] == font


def test_a_text_without_any_font_is_refused(refused, scene, without_fonts):
    refused(1, "pattern", "plate.ply", "--text", "io", "--centre", "0.5,0.5,0", "--output", "p.json",
            says=["no font was found", "give a font file"])
