# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter keeps simplified shells in the same cache as the program."""
import subprocess
import sys
from pathlib import Path

import numpy as np
import pymeshlab
from curves import FILTER, CurveLayer, as_text, draw, write_pp
from made_meshes import write_obj
from meshes import wavy_plate


def log_of_a_curve(plugin_path, picks):
    """What pymeshlab logs in a process of its own: after an error in this one it logs no more (its issue 399)."""
    code = f"""
import sys
sys.path.insert(0, {str(Path(__file__).parent)!r})
import pymeshlab
from meshes import wavy_plate
pymeshlab.load_plugin({str(plugin_path)!r})
document = pymeshlab.MeshSet(verbose=True)
document.add_mesh(pymeshlab.Mesh(*wavy_plate()), "plate")
document.apply_filter({FILTER!r}, picks={as_text(picks)!r}, shell="simplified")
"""
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    return done.stdout + done.stderr


def plate_of_its_own(n):
    """A plate that no other test draws on, so that the session has kept nothing of it; and picks."""
    vertices, faces = wavy_plate(n)
    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(vertices, faces), "plate")
    return document, vertices[[4 * (n + 1) + 5, 15 * (n + 1) + 30, 33 * (n + 1) + 20]]


def test_the_second_curve_is_served_from_the_cache(cache):
    plate, picks = plate_of_its_own(35)
    first, figures = draw(plate, picks, shell="simplified")
    assert not figures["shell_cached"]
    second, again = draw(plate, picks, shell="simplified")
    assert again["shell_cached"] and again["prisms"] == figures["prisms"]
    np.testing.assert_array_equal(CurveLayer(second).points, CurveLayer(first).points)
    np.testing.assert_array_equal(again["control_points"], figures["control_points"])


def test_the_log_says_where_the_shell_came_from(cache, plate_picks, plugin_path):
    assert " shell_cached=false " in log_of_a_curve(plugin_path, plate_picks)
    assert " shell_cached=true " in log_of_a_curve(plugin_path, plate_picks)


def test_a_damaged_entry_is_rebuilt_and_the_log_says_so(cache, plate_picks, plugin_path):
    log_of_a_curve(plugin_path, plate_picks)
    (entry,) = cache.iterdir()
    stored = entry.read_bytes()
    entry.write_bytes(stored[:-9])
    log = log_of_a_curve(plugin_path, plate_picks)
    assert " shell=simplified " in log and " shell_cached=false " in log and entry.name in log
    assert entry.read_bytes() == stored
    assert " shell_cached=true " in log_of_a_curve(plugin_path, plate_picks)


def test_the_program_has_stored_it_for_the_filter(cache, plate, plate_picks, program, tmp_path):
    plate.set_current_mesh(0)
    write_obj(tmp_path / "plate.obj", *wavy_plate())
    subprocess.run([program, tmp_path / "plate.obj", "--picks", write_pp(tmp_path / "picks.pp", plate_picks),
                    "--output", tmp_path / "curve.ply", "--shell", "simplified", "--target-thickness", "0.1"], check=True)
    assert draw(plate, plate_picks, shell="simplified", target_thickness=0.1)[1]["shell_cached"]


def test_full_shells_are_not_kept_in_files(cache):
    plate, picks = plate_of_its_own(36)
    assert not draw(plate, picks, shell="full")[1]["shell_cached"]
    assert not cache.exists()


# ---- kept within the session ----


def kept(document, picks, **parameters):
    """Whether a further curve on layer 0 found what an earlier one had left."""
    document.set_current_mesh(0)
    _, figures = draw(document, picks, **parameters)
    assert figures["usable"]
    assert (figures["seconds_surface"] == 0) == figures["surface_kept"]
    return figures["surface_kept"]


def test_a_further_curve_builds_no_shell_whatever_else_changed():
    document, picks = plate_of_its_own(37)
    assert not kept(document, picks)
    assert kept(document, picks, closed=True, degree=2)
    # Layers come, names and qualities change.
    document.create_sphere()
    document.set_current_mesh(0)
    document.set_mesh_name(newname="another name")
    document.compute_scalar_by_function_per_vertex(q="x")
    document.compute_selection_by_condition_per_face(condselect="x0 > 0.5")
    assert kept(document, picks, field="quality", field_weight=1.0)
    # Not even the document has to be the same.
    assert kept(plate_of_its_own(37)[0], picks)
    assert not kept(document, picks, shell_thickness=0.5)


def test_a_mesh_that_changed_gets_a_new_shell_and_one_that_changed_back_its_old_one():
    document, picks = plate_of_its_own(38)
    assert not kept(document, picks)
    moved = np.array([0, 0, 0.25])
    document.set_current_mesh(0)
    document.compute_matrix_from_translation(axisz=0.25, freeze=False)
    assert not kept(document, picks + moved), "the layer's matrix counts"
    document.set_current_mesh(0)
    document.compute_matrix_from_translation(axisz=-0.25, freeze=False)
    assert kept(document, picks)
    document.set_current_mesh(0)
    document.compute_selection_by_condition_per_face(condselect="(x0+x1+x2 > 2.8) && (y0+y1+y2 > 2.8)")
    assert document.current_mesh().selected_face_number() > 0
    document.meshing_remove_selected_faces()
    assert not kept(document, picks), "some faces are gone"
