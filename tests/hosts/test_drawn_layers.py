# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tool "Draw B-spline Curves" leaves: the filter's curve where it was clicked, and results of filters with it."""
import xml.etree.ElementTree as ElementTree

import numpy as np
import pymeshlab
import pytest
from drawing_tool import BAD, CLICKS, CURVE, DRAG, HANDLE, MADE, SELECTED, Tool, is_like
from meshlab_window import FIRST_LAYER, LAYER_ROW
from meshlabserver import run_server

CURVE_ROW = 1  # in the list of layers: the surface, the curve, its tube
only_2020 = pytest.mark.parametrize("meshlab", ["2020.09"], indirect=True)  # meshlabserver ended with it

# Pixels that the curve may be beside where it is projected, and that handles cover.
BESIDE, COVERED = 3, 12


def draw(tool):
    """Five picks, one dragged, one inserted, both undone, closed."""
    tool.draw()
    tool.drag(CLICKS[2], DRAG)
    tool.expect(CLICKS[2] + DRAG, SELECTED)
    tool.meshlab.wait_for_still_picture()
    inserted = tool.curve_between(CLICKS[3], CLICKS[4])
    tool.click(inserted)
    tool.expect(inserted, SELECTED)
    tool.meshlab.key("ctrl+z", "ctrl+z")
    tool.expect(CLICKS[2], HANDLE)
    tool.click(CLICKS[0])
    tool.meshlab.wait_for_still_picture()


def vertices_of(path):
    document = pymeshlab.MeshSet()
    document.load_new_mesh(str(path))
    return document.current_mesh().vertex_matrix()


def picks_of(script):
    """The picks of a script's only filter."""
    (filter_,) = ElementTree.parse(script).getroot().findall("filter")
    (text,) = [p.get("value") for p in filter_.findall("Param") if p.get("name") == "picks"]
    return np.array([[float(x) for x in pick.split()] for pick in text.split(";")])


class Camera:
    """MeshLab's, as it looks at a mesh about the origin at first: along -z, with 60 degrees."""

    def __init__(self, tool, picks):
        self.middle, self.focal = tool.middle, tool.view_height / 2 / np.tan(np.radians(30))
        distances = picks[:, 2] + self.focal * np.linalg.norm(picks[:, :2], axis=1) / np.linalg.norm(CLICKS, axis=1)
        assert np.ptp(distances) < 0.01 * distances.mean()  # the picks lie under the clicks
        self.eye = np.array([0, 0, distances.mean()])

    def places(self, points):
        return self.middle + self.focal * points[:, :2] * [1, -1] / (self.eye[2] - points[:, 2:])


@only_2020
def test_the_layer_is_the_curve_of_the_filter_where_it_was_clicked(meshlab, display, prefix, sphere, tmp_path):
    tool = Tool(meshlab)
    draw(tool)
    picture = display.picture()
    meshlab.key("Return")
    meshlab.wait_for_log(MADE)
    tool.end()
    meshlab.select_layer(CURVE_ROW)
    meshlab.export_layer(tmp_path / "layer.ply")
    meshlab.save_script(tmp_path / "drawn.mlx")

    run = run_server(display, prefix, "-i", sphere, "-s", tmp_path / "drawn.mlx", "-o", tmp_path / "filter.ply")
    assert run.status == 0, run.output
    layer = vertices_of(tmp_path / "layer.ply")
    np.testing.assert_allclose(vertices_of(tmp_path / "filter.ply"), layer, rtol=0, atol=1e-12)

    picks = picks_of(tmp_path / "drawn.mlx")
    assert len(picks) == len(CLICKS)
    camera = Camera(tool, picks)
    np.testing.assert_allclose(camera.places(picks), tool.middle + CLICKS, atol=BESIDE)
    handles = tool.middle + CLICKS
    uncovered = [p for p in camera.places(layer) if np.linalg.norm(handles - p, axis=1).min() > COVERED]
    assert len(uncovered) > len(layer) / 2
    pixels = np.array(picture)
    for x, y in np.round(uncovered).astype(int):
        around = pixels[y - BESIDE : y + BESIDE + 1, x - BESIDE : x + BESIDE + 1].reshape(-1, 3)
        assert any(is_like(pixel, CURVE) for pixel in around), f"no curve at {x}, {y}"


def test_a_curve_follows_the_field_that_is_chosen(meshlab):
    tool = Tool(meshlab)
    tool.draw()
    tool.choose_field("Distance")  # to creases, which a sphere has none of
    for offset in CLICKS:
        tool.expect(offset, BAD)
    tool.choose_field("Ridges")
    tool.expect(CLICKS[0], HANDLE)
    meshlab.key("Return")
    meshlab.wait_for_log('^Open curve through .* usable: .*follows the field "Ridges"')


# Of the columns in the list of layers: the eye, from the left edge of the list.
EYE = 18


def eye(meshlab, row):
    """The eye of a layer in the list, which tells whether it is visible."""
    view = meshlab.view()
    x, y = view.x + view.width + EYE, meshlab.main.y + FIRST_LAYER + row * LAYER_ROW
    return np.array(meshlab.display.picture().crop((x, y - 8, x + 20, y + 8)), dtype=int)


@pytest.mark.parametrize("button", ["Imprint", "Cut", "Segment"])
def test_a_button_uses_the_curves_just_drawn(meshlab, button):
    tool = Tool(meshlab)
    tool.draw()
    tool.click(CLICKS[0])
    meshlab.wait_for_still_picture()
    tool.press(button)
    line = meshlab.wait_for_log("^1 curve ")
    assert " projected" not in line and "2 parts" in line, line
    tool.wait_for_end()
    # Surface, curve, tube, result; of a cut one for each part.
    assert meshlab.layers() == (5 if button == "Cut" else 4)
    if button == "Cut":
        meshlab.wait_for_log('^The mesh is parted into 2 layers: "sphere part 0" and "sphere part 1".$')
        meshlab.wait_for_still_picture()
        picture = meshlab.display.picture()
        inside, outside = (picture.getpixel(tuple(int(v) for v in tool.middle + offset)) for offset in ((20, 30), (-180, 30)))
        assert not is_like(inside, outside, 80)
    # The surface is hidden, curve and tube are not, and the result is the current layer.
    assert np.abs(eye(meshlab, 1) - eye(meshlab, 2)).max() < 40
    assert np.abs(eye(meshlab, 0) - eye(meshlab, 1)).max() > 80
    assert meshlab.current_layer() == 3
