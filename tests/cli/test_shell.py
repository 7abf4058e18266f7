# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb shell as a user runs it: files as independent readers see them, figures, refusals."""

import json

import made_meshes as meshes
import meshio
import numpy as np
import pymeshlab
import pytest
from curve_files import succeed

INVARIANTS = ["positive tetrahedra", "separate layers", "separate components", "transversal surface",
              "contained surface", "single crossings", "complete tracking", "consistent neighbours"]


@pytest.fixture
def hill(tmp_path):
    """A hill away from the origin, in hill.ply; returns vertices and faces."""
    V, F = meshes.plate(cells=10, size=3.0, height=0.4)
    V = V + [20.0, -7.0, 3.0]
    meshes.write_ply(tmp_path / "hill.ply", V, F)
    return V, F


def volumes(P, T):
    a, b, c, d = (P[T[:, k]] for k in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6


@pytest.mark.parametrize("extension", ["vtu", "msh", "VTU"])
def test_tetrahedra_conform_and_know_f_prism_slab_and_ghost(run, tmp_path, hill, extension):
    V, F = hill
    succeed(run("shell", "hill.ply", "--shell", "full", "--output", f"shell.{extension}", "--report", "r.json"))
    file = (tmp_path / f"shell.{extension}").rename(tmp_path / f"shell.{extension.lower()}")
    grid = meshio.read(file)
    report = json.loads((tmp_path / "r.json").read_text())
    assert [block.type for block in grid.cells] == ["tetra"]
    P, T = grid.points, grid.cells[0].data
    f = grid.point_data["f"].ravel()
    prism, slab, ghost = (grid.cell_data[name][0].ravel().astype(int) for name in ("prism", "slab", "ghost"))
    assert volumes(P, T).min() > 0
    assert len(T) == 6 * report["prisms"] and len(set(prism)) == report["prisms"]
    assert (ghost == 1).sum() == 6 * report["ghost_prisms"] > 0
    assert set(f) == {-1, 0, 1} and len(f) == 3 * report["pillars"]
    # A slab lies on one side of the middle: the top slab has no point with f = -1.
    assert ((f[T] >= 0).all(1) == (slab == 0)).all() and ((f[T] <= 0).all(1) == (slab == 1)).all()
    # Faces are shared by two tetrahedra at most, and no point is there twice.
    corners = np.sort(np.concatenate([np.delete(T, k, 1) for k in range(4)]), 1)
    assert np.unique(corners, axis=0, return_counts=True)[1].max() == 2
    assert len(np.unique(P, axis=0)) == len(P)
    # In a shell of full resolution every vertex of the mesh is a point with f = 0, in the mesh's coordinates.
    middle = P[f == 0]
    assert np.abs(V[:, None] - middle[None]).sum(2).min(1).max() < 1e-12
    if extension == "msh":
        assert grid.field_data["top"].tolist() == [1, 3] and grid.field_data["bottom"].tolist() == [2, 3]
        assert (grid.cell_data["gmsh:physical"][0] == slab + 1).all()


@pytest.mark.parametrize("extension", ["vtu", "msh"])
def test_tetrahedra_conform_to_the_surface_where_that_is_asked(run, tmp_path, hill, extension):
    V, F = hill
    output = f"shell.{extension}"
    succeed(run("shell", "hill.ply", "--conforming-to-surface", "--output", output, "--report", "r.json"))
    grid = meshio.read(tmp_path / output)
    P, T = grid.points, grid.cells[0].data
    side = grid.cell_data["side"][0].ravel().astype(int)
    assert np.array_equal(P[:len(V)], V), "the vertices of the mesh come first"
    assert volumes(P, T).min() > 0
    beside = {}
    for tet, corners in enumerate(np.sort(T, 1).tolist()):
        for k in range(4):
            beside.setdefault(tuple(corners[:k] + corners[k + 1:]), []).append(tet)
    for face in np.sort(F, 1).tolist():
        assert sorted(side[beside[tuple(face)]]) == [0, 1], "each face lies between above and below"
    f = grid.point_data["f"].ravel()
    assert f.min() == -1 and f.max() == 1 and np.abs(f[:len(V)]).max() < 1


@pytest.mark.parametrize("options, said", [
    (["--output", "shell.ply"], "holds no tetrahedra"),
    (["--output", "shell.vtu", "--shell", "full"], "conform to the surface as they are"),
    (["--check"], "--output"),
])
def test_tetrahedra_that_cannot_conform_are_refused_before_any_work(run, tmp_path, hill, options, said):
    result = run("shell", "hill.ply", "--conforming-to-surface", *options)
    assert result.returncode == 2 and said in result.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["hill.ply"]


@pytest.mark.parametrize("kind", ["simplified", "full"])
def test_the_ply_has_three_layers_that_meshlab_colours_by_f(run, tmp_path, hill, kind):
    succeed(run("shell", "hill.ply", "--shell", kind, "--output", "shell.ply", "--report", "r.json"))
    report = json.loads((tmp_path / "r.json").read_text())
    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(tmp_path / "shell.ply"))
    mesh = document.current_mesh()
    quality, F = mesh.vertex_scalar_array(), mesh.face_matrix()
    assert mesh.vertex_number() == 3 * report["pillars"] and mesh.face_number() == 3 * report["prisms"]
    assert set(quality) == {-1, 0, 1}
    assert (quality[F] == quality[F][:, :1]).all(), "a triangle lies in one layer"
    colours = mesh.vertex_color_matrix()
    assert len({tuple(c) for c in colours}) == 3
    # Each layer looks outwards, here upwards on the whole.
    V = mesh.vertex_matrix()
    normals = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
    for level in (-1, 0, 1):
        assert normals[quality[F[:, 0]] == level].sum(0)[2] > 0
    read = meshio.read(tmp_path / "shell.ply")
    assert np.array_equal(read.cells_dict["triangle"], F) and np.array_equal(read.point_data["quality"], quality)


@pytest.mark.parametrize("kind", ["simplified", "full"])
def test_the_report_gives_counts_thickness_times_and_memory(run, tmp_path, hill, kind):
    V, F = hill
    succeed(run("shell", "hill.ply", "--shell", kind, "--output", "shell.vtu", "--report", "r.json"))
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["shell"] == kind
    assert report["faces"] == len(F) and report["blocked_faces"] == 0 and report["moved_vertices"] == 0
    assert report["mesh"]["boundary_edges"] == 40 and report["mesh"]["components"] == 1
    grid = meshio.read(tmp_path / "shell.vtu")
    P = grid.points.reshape(-1, 3, 3)  # bottom, middle, top of each pillar
    T, ghost = grid.cells[0].data, grid.cell_data["ghost"][0].ravel()
    pillars = np.unique(T[ghost == 0]) // 3
    lengths = np.linalg.norm(np.diff(P, axis=1), axis=2).sum(1)[np.unique(pillars)] / np.ptp(V, axis=0).max()
    assert report["thickness"]["mean"] == pytest.approx(lengths.mean())
    assert report["thickness"]["p5"] == pytest.approx(np.percentile(lengths, 5))
    assert report["thickness"]["min"] == pytest.approx(lengths.min())
    seconds = report["seconds"]
    assert 0 < seconds["cpu"] and seconds["validate"] + seconds["base"] + seconds["shell"] <= seconds["wall"] * 1.01
    assert seconds["read"] > 0 and seconds["check"] == 0
    assert 1e6 < report["peak_memory_bytes"] < 1e8, "not the memory of the program that started this one"
    assert report["check"] is None


@pytest.mark.parametrize("kind", ["simplified", "full"])
def test_check_names_every_invariant(run, tmp_path, hill, kind):
    succeed(run("shell", "hill.ply", "--shell", kind, "--check", "--report", "r.json"))
    report = json.loads((tmp_path / "r.json").read_text())
    assert list(report["check"]) == INVARIANTS
    for entry in report["check"].values():
        assert entry == {"holds": True, "violations": 0, "first_ids": []}
    assert report["seconds"]["check"] > 0
    assert sorted(p.name for p in tmp_path.iterdir()) == ["hill.ply", "r.json"]


def test_output_may_be_left_out_with_check_or_report_only(run, refused, hill):
    succeed(run("shell", "hill.ply", "--check"))
    refused(2, "shell", "hill.ply", says=["--output"])


def test_thickness_of_a_full_shell_follows_its_option(run, tmp_path, hill):
    means = []
    for thickness in (0.1, 0.4):
        succeed(run("shell", "hill.ply", "--shell", "full", "--report", "r.json", "--shell-thickness", thickness))
        means.append(json.loads((tmp_path / "r.json").read_text())["thickness"]["mean"])
    assert means[1] > 2 * means[0]


def test_a_simplified_shell_is_the_default_and_has_few_thick_prisms(run, tmp_path):
    document = pymeshlab.MeshSet(verbose=False)
    document.create_torus(hradius=3, vradius=1, hsubdiv=60, vsubdiv=30)
    document.save_current_mesh(str(tmp_path / "torus.ply"))
    reports = {}
    for name, words in {
        "default": (), "simplified": ("--shell", "simplified"), "full": ("--shell", "full"),
        "thin": ("--target-thickness", 0.03), "short": ("--target-edge-length", 0.1),
    }.items():
        succeed(run("shell", "torus.ply", "--check", "--report", "r.json", "--output", f"{name}.vtu", *words))
        reports[name] = json.loads((tmp_path / "r.json").read_text())
    assert (tmp_path / "default.vtu").read_bytes() == (tmp_path / "simplified.vtu").read_bytes()
    few, full, thin, short = (reports[name] for name in ("default", "full", "thin", "short"))
    assert few["prisms"] < 0.1 * full["prisms"] == 360
    assert few["thickness"]["mean"] > 2 * thin["thickness"]["mean"]
    assert short["prisms"] > 1.5 * few["prisms"]
    grid = meshio.read(tmp_path / "thin.vtu")
    assert volumes(grid.points, grid.cells[0].data).min() > 0


def test_the_same_command_gives_the_same_bytes(run, tmp_path, hill):
    for extension in ("vtu", "msh", "ply"):
        for name in ("a", "b"):
            succeed(run("shell", "hill.ply", "--output", f"{name}.{extension}"))
        assert (tmp_path / f"a.{extension}").read_bytes() == (tmp_path / f"b.{extension}").read_bytes()


@pytest.mark.parametrize(
    "status, words, part",
    [
        (2, (), "MESH"),
        (2, ("hill.ply", "--output", "a.vtu", "--frobnicate"), "--frobnicate"),
        (2, ("hill.ply", "--output", "a.vtu", "--shell-thickness", "0"), "(0, 1000]"),
        (2, ("hill.ply", "--output", "a.vtu", "--shell", "thin"), "local|full|simplified"),
        (2, ("hill.ply", "--output", "a.vtu", "--shell", "local"), "use simplified or full"),
        (2, ("hill.ply", "--output", "a.vtu", "--target-thickness", "1.5"), "(0, 1]"),
        (2, ("hill.ply", "--output", "a.vtu", "--target-edge-length", "0"), "(0, 1]"),
        (2, ("hill.ply", "--output", "a.vtu", "--picks", "picks.json"), "--picks"),
        (1, ("none.ply", "--output", "a.vtu"), "none.ply"),
        (1, ("hill.ply", "--output", "a.vtk"), ".vtu"),
        (1, ("hill.ply", "--output", "none/a.vtu"), "does not exist"),
        (1, ("hill.ply", "--check", "--report", "r.txt"), ".json"),
        (1, ("nan.ply", "--output", "a.vtu", "--strict"), "vertices 7"),
    ],
)
def test_what_the_verb_refuses(refused, tmp_path, hill, status, words, part):
    V, F = hill
    V = V.copy()
    V[7, 1] = np.nan
    meshes.write_ply(tmp_path / "nan.ply", V, F)
    refused(status, "shell", *words, says=[part])


def test_a_mesh_that_lies_on_itself_everywhere_has_no_shell(refused, tmp_path):
    V, F = meshes.plate(cells=4)
    meshes.write_ply(tmp_path / "twice.ply", np.vstack([V, V]), np.vstack([F, F + len(V)]))
    refused(1, "shell", "twice.ply", "--check", says=["no face got a prism"])
