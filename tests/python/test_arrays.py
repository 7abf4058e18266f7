# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of every layout, meshes of other packages, threads, interrupts and memory."""
import gc
import os
import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import bspline_curve
import numpy as np
import psutil
import pytest


def frozen(array):
    array = array.copy()
    array.flags.writeable = False
    return array


@pytest.mark.parametrize("change", [
    np.asfortranarray, frozen, lambda a: np.repeat(a, 2, axis=0)[::2], lambda a: a[::-1][::-1], np.ndarray.tolist,
    lambda a: a.astype(a.dtype.newbyteorder(">")),
])
@pytest.mark.parametrize("index", [np.int32, np.int64, np.uint32, np.uint64])
def test_arrays_of_every_layout_give_the_same_curve(change, index, arrays, mesh, picks):
    other = bspline_curve.Mesh(change(arrays[0]), change(arrays[1].astype(index)))
    np.testing.assert_array_equal(other.curve(change(picks)).points, mesh.curve(picks).points)


def test_single_precision_is_taken_as_it_is(arrays, picks):
    mesh = bspline_curve.Mesh(arrays[0].astype(np.float32), arrays[1])
    np.testing.assert_array_equal(mesh.vertices, arrays[0].astype(np.float32))


def test_results_are_read_only_views(mesh, picks):
    curve = mesh.curve(picks, field="ridge")
    for name in ("points", "faces", "barycentrics", "t", "values", "knots", "control_points", "picks", "pick_parameters"):
        array = getattr(curve, name)
        with pytest.raises(ValueError, match="read-only"):
            array[:] = 0
    assert np.shares_memory(curve.points, curve.points) and np.shares_memory(mesh.vertices, mesh.vertices)
    points, expected = curve.points, curve.points.copy()
    del curve
    gc.collect()
    np.testing.assert_array_equal(points, expected)


def test_what_is_given_is_not_changed_and_not_kept(arrays, picks):
    vertices, faces = arrays[0].copy(), arrays[1].copy()
    mesh = bspline_curve.Mesh(vertices, faces)
    curve = mesh.curve(picks)
    np.testing.assert_array_equal(vertices, arrays[0])
    vertices[:] = 0
    faces[:] = 0
    np.testing.assert_array_equal(mesh.curve(picks).points, curve.points)


def test_meshes_of_other_packages_are_taken(arrays, mesh, picks):
    import meshio
    import pymeshlab
    import trimesh

    document = pymeshlab.MeshSet()
    document.add_mesh(pymeshlab.Mesh(*arrays))
    packed = np.c_[np.full(len(arrays[1]), 3), arrays[1]].ravel()

    class OfPyvista:
        points, faces = arrays[0], packed

    for other in (tuple(arrays), trimesh.Trimesh(*arrays, process=False), meshio.Mesh(arrays[0], [("triangle", arrays[1])]),
                  document, document.current_mesh(), OfPyvista()):
        np.testing.assert_array_equal(bspline_curve.Mesh(other).curve(picks).points, mesh.curve(picks).points)
    with pytest.raises(bspline_curve.MeshError, match="quad"):
        bspline_curve.Mesh(meshio.Mesh(arrays[0], [("quad", [[0, 1, 42, 41]])]))


@pytest.fixture
def broken(arrays):
    """A duplicate face, one without area and one turned over."""
    vertices, faces = arrays
    broken = np.r_[faces[:1], faces, [[0, 0, 1]]]
    broken[8] = broken[8][::-1]
    return vertices, broken


def test_a_broken_mesh_is_mended_and_ids_stay_those_given(arrays, broken, mesh, picks):
    vertices, faces = broken
    with pytest.warns(bspline_curve.MeshWarning, match="duplicate.*strict refuses it"):
        mended = bspline_curve.Mesh(vertices, faces)
    assert "duplicate" in mended.mending and mesh.mending == ""
    np.testing.assert_array_equal(mended.faces, faces)
    field = mended.field("valley")
    np.testing.assert_allclose(field, mesh.field("valley"))
    curve = mended.curve(picks, field="valley", avoid=[8])
    np.testing.assert_allclose(curve.points, mesh.curve(picks, field="valley", avoid=[7]).points, atol=1e-12)
    on_faces = (vertices[faces[curve.faces]] * curve.barycentrics[..., None]).sum(1)
    np.testing.assert_allclose(on_faces, curve.points, atol=1e-14)
    moved = curve.move(1, picks[1] + 0.01)
    assert moved.usable
    found = mended.project(picks)
    np.testing.assert_allclose((vertices[faces[found.faces]] * found.barycentrics[..., None]).sum(1), picks, atol=1e-14)


def test_a_field_is_of_both_sheets_where_they_share_a_vertex(arrays):
    """Mending gives each its own; a vertex of the caller's has one value, but the curve under the field has both."""
    vertices, faces = arrays
    middle = 20 * 41 + 20
    other = (vertices - vertices[middle])[:, [1, 2, 0]] * [1, 3, 1] + vertices[middle]
    ids = np.arange(len(vertices)) + len(vertices)
    ids[middle] = middle
    pinched = np.vstack([vertices, other]), np.vstack([faces, ids[faces]])
    with pytest.warns(bspline_curve.MeshWarning, match="vert"):
        mended = bspline_curve.Mesh(*pinched)
    repaired = bspline_curve.repair(*pinched).mesh
    for sheet in vertices, other:
        through = sheet[[middle - 8, middle - 1, middle + 41, middle + 41 * 8]]
        expected = repaired.curve(through, field="valley", field_weight=5)
        curve = mended.curve(through, field="valley", field_weight=5)
        np.testing.assert_array_equal(curve.points, expected.points)
        again = mended.curve(through, field=mended.field("valley"), field_cost="exp-minus", field_weight=5)
        np.testing.assert_array_equal(again.points, expected.points)


def test_strict_refuses_a_broken_mesh(broken):
    with pytest.raises(bspline_curve.MeshError, match="; without strict=True the mesh is mended$"):
        bspline_curve.Mesh(*broken, strict=True)


def test_a_mesh_is_repaired(arrays, broken):
    mended = bspline_curve.repair(*broken)
    assert len(mended.mesh.faces) == len(arrays[1])
    assert mended.changes["removed_duplicate_faces"] == [1]
    assert mended.changes["removed_degenerate_faces"] == [len(arrays[1]) + 1]
    assert mended.changes["reversed_faces"] == [8] and "duplicate" in mended.summary


def test_points_are_projected(mesh):
    queries = np.random.default_rng(3).uniform(-1, 1, (100, 3))
    points, faces, barycentrics, distances = mesh.project(queries)
    np.testing.assert_allclose(np.linalg.norm(points - queries, axis=1), distances, atol=1e-14)
    np.testing.assert_allclose((mesh.vertices[mesh.faces[faces]] * barycentrics[..., None]).sum(1), points, atol=1e-14)
    centres = mesh.vertices[mesh.faces].mean(1)
    assert (distances <= np.linalg.norm(queries[:, None] - centres[None], axis=2).min(1) + 1e-14).all()


def test_points_whose_squares_overflow_are_projected(mesh):
    far = np.array([[1e160, 0, 0], [0, -1e300, 1e300]])
    points, faces, barycentrics, distances = mesh.project(far)
    assert (faces >= 0).all()
    np.testing.assert_allclose((mesh.vertices[mesh.faces[faces]] * barycentrics[..., None]).sum(1), points, atol=1e-14)
    np.testing.assert_allclose(distances, [1e160, np.sqrt(2) * 1e300])


def test_a_shell_lies_above_and_below(mesh):
    top, bottom = mesh.shell()
    assert top.vertices.shape[1] == bottom.faces.shape[1] == 3
    assert mesh.project(top.vertices).distances.min() > 0
    assert top.vertices[:, 2].mean() > bottom.vertices[:, 2].mean()


def test_threads_on_one_mesh_give_the_same_bits(mesh, picks):
    numbers = list(range(4)) * 25
    single = [mesh.curve(picks + 0.001 * i, closed=bool(i % 2)).points for i in range(4)]
    with ThreadPoolExecutor(4) as pool:
        drawn = list(pool.map(lambda i: mesh.curve(picks + 0.001 * i, closed=bool(i % 2)).points, numbers))
    for i, points in zip(numbers, drawn, strict=True):
        np.testing.assert_array_equal(points, single[i])


def test_progress_is_told_and_can_cancel(wavy):
    mesh, told = bspline_curve.Mesh(*wavy(400)), []
    picks = mesh.vertices[[1000, 50000, 90000, 150000]]

    def tell(fraction, stage):
        told.append((fraction, stage))

    mesh.field("ridge", progress=tell)
    assert told and all(0 <= fraction <= 1 and stage for fraction, stage in told)
    assert [fraction for fraction, _ in told] == sorted(fraction for fraction, _ in told)
    with pytest.raises(bspline_curve.Cancelled):
        mesh.field("ridge", progress=lambda *_: False)

    def fail(*_):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        mesh.field("ridge", progress=fail)
    assert mesh.curve(picks).usable
    # A curve tells of its field too, and one that was not made is not kept.
    with pytest.raises(bspline_curve.Cancelled):
        mesh.curve(picks, field="valley", progress=lambda *_: False)
    told.clear()
    assert mesh.curve(picks, field="valley", progress=tell).usable
    assert told and [fraction for fraction, _ in told] == sorted(fraction for fraction, _ in told)
    assert {"curvature", "smoothing"} <= {stage for _, stage in told}


def test_an_interrupt_ends_a_computation(wavy):
    mesh = bspline_curve.Mesh(*wavy(700))
    # A shell that starts programs in the background has them ignore SIGINT.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        mesh.field("ridge")
        mesh.shell()
        pytest.fail("the interrupt came too late")
    timer.join()
    signal.signal(signal.SIGINT, before)


def test_other_threads_go_on_while_the_core_computes(wavy):
    mesh, count, done = bspline_curve.Mesh(*wavy(400)), 0, threading.Event()

    def work():
        mesh.field("ridge")
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.wait(0.001):
        count += 1
    thread.join()
    assert count > 20


def test_memory_does_not_grow(mesh, picks):
    process = psutil.Process()

    def draw(count):
        curve = mesh.curve(picks)
        for i in range(count):
            curve = curve.move(1, picks[1] + [1e-4 * (i % 7), 0, 0]) if i % 2 else mesh.curve(picks)
            assert len(curve.faces) == len(curve.points)
        gc.collect()
        return process.memory_info().rss

    before = draw(300)
    assert draw(3000) - before < 2e6


def test_the_import_needs_no_other_package():
    import pathlib

    folder = pathlib.Path(bspline_curve.__file__).parents[1]
    code = (
        f"import sys; sys.path.insert(0, {str(folder)!r}); import numpy; before = set(sys.modules); import bspline_curve\n"
        "new = {name.split('.')[0] for name in set(sys.modules) - before} - set(sys.stdlib_module_names)\n"
        "print(sorted(new - {'numpy'}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "['bspline_curve']"


def test_parts_that_only_look_joined_are_welded(wavy):
    vertices, faces = wavy(21)
    mirrored = vertices * [-1, 1, 1] + [2 + 1e-8, 0, 0]
    both = np.vstack([vertices, mirrored]), np.vstack([faces, faces[:, ::-1] + len(vertices)])
    picks = both[0][[30, 500, 860]]
    with pytest.raises(bspline_curve.PickError, match=r"; Mesh\(\.\.\., weld=1e-06\) joins these components$"):
        bspline_curve.Mesh(*both).curve(picks)
    with pytest.warns(bspline_curve.MeshWarning, match="vertices merged$"):
        welded = bspline_curve.Mesh(*both, weld=1e-6)
    assert welded.components == 1
    curve = welded.curve(picks)
    on_faces = (both[0][both[1][curve.faces]] * curve.barycentrics[..., None]).sum(1)
    np.testing.assert_allclose(on_faces, curve.points, atol=2e-8)
    repaired = bspline_curve.repair(*both, weld=1e-6)
    assert len(repaired.changes["merged_vertices"]) == 21 and repaired.mesh.components == 1
    with pytest.raises(bspline_curve.OptionError, match="choose one"):
        bspline_curve.Mesh(*both, weld=1e-6, strict=True)
