# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves in files: the program's JSON, and besides it what the curve was drawn by.

What only files need is imported with the first of them: json, pathlib and tempfile take as long as the whole package.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._arrays import Floats, file_name
from ._curve import Curve, restored
from ._drawing import Drawing
from ._errors import FileError
from ._identity import require_mesh
from ._keywords import CURVE
from ._mesh import Mesh
from ._options import Direction, TwoDirections, changed

if TYPE_CHECKING:
    from pathlib import Path

# A file's points may be those of the mesh to rounding, relative to its diagonal.
SAME_PLACE = 1e-9


def _written_tangent(pick: int, tangent: Direction | TwoDirections) -> dict[str, Any]:
    if len(tangent) == 3:
        return {"pick": pick, "direction": list(tangent)}
    sides = zip(("before", "after"), tangent)
    return {"pick": pick, **{name: list(side) for name, side in sides if side is not None}}


def _read_tangent(written: dict[str, Any]) -> tuple[int, Any]:
    if "direction" in written:
        return written["pick"], written["direction"]
    return written["pick"], (written.get("before"), written.get("after"))


def document_of(curve: Curve) -> dict[str, Any]:
    drawing = curve._bound()
    made = drawing.made_field()
    polyline = {
        "points": curve.points.tolist(),
        "faces": curve.faces.tolist(),
        "barycentrics": curve.barycentrics.tolist(),
        "t": curve.t.tolist(),
        "picks": curve.pick_vertices.tolist(),
    }
    if made is not None:
        polyline["quality"] = curve.values.tolist()
    asked: Any = drawing.options.get("tangents", ())
    tangents = [_written_tangent(pick, direction) for pick, direction in asked]
    return {
        "closed": curve.closed,
        **({"tangents": tangents} if tangents else {}),
        "polyline": polyline,
        "spline": {
            "degree": curve.degree,
            "closed": curve.closed,
            "knots": curve.knots.tolist(),
            "control_points": curve.control_points.tolist(),
            "pick_parameters": curve.pick_parameters.tolist(),
        },
        "mesh": named(curve.mesh),
        "drawn_by": {
            "picks": curve.picks.tolist(),
            "options": drawing.options,
            "field": drawing.field if isinstance(drawing.field, (str, type(None))) else drawing.field.values.tolist(),
            "avoid": drawing.avoid if isinstance(drawing.avoid, (str, type(None))) else drawing.avoid.tolist(),
            "quality": None if drawing.quality is None else drawing.quality.tolist(),
            "field_region": None if drawing.region is None else drawing.region.tolist(),
            "fixed": drawing.fixed,
        },
        "report": finite(curve.report),
    }


def named(mesh: Mesh) -> dict[str, Any]:
    """By what a mesh is known again: as docs/FILES.md tells."""
    return {"vertices": len(mesh.vertices), "faces": len(mesh.faces), "crc32": mesh.checksum}


def finite(value: Any) -> Any:
    """JSON has no infinity: null."""
    if isinstance(value, dict):
        return {name: finite(each) for name, each in value.items()}
    if isinstance(value, list):
        return [finite(each) for each in value]
    return value if not isinstance(value, float) or np.isfinite(value) else None


def save(curve: Curve, file: str | os.PathLike[str], unit: str) -> None:
    from pathlib import Path

    path = Path(file_name(file))
    name = path.name.lower()
    ends = _core.curve_extensions().split(", ")
    end = next((end for end in ends if name.endswith(end) and name != end), None)
    if end is not None:
        field = curve.values if curve._bound().made_field() is not None else np.empty(0)
        write_wholly(path, _core.curve_bytes(curve._core, end, np.ascontiguousarray(field), unit))
        return
    if path.suffix.lower() != ".json":
        raise FileError(f"{path}: a curve is saved as .json, {', '.join(ends)}", "unwritable-file")
    import json

    write_wholly(path, (json.dumps(document_of(curve), allow_nan=False) + "\n").encode())


def write_wholly(path: Path, data: bytes) -> None:
    """The file appears wholly, or not at all."""
    import contextlib
    import tempfile

    try:
        with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as part:
            try:
                part.write(data)
                part.close()
                umask = os.umask(0)
                os.umask(umask)
                os.chmod(part.name, 0o666 & ~umask)
                os.replace(part.name, path)
            except BaseException:
                with contextlib.suppress(FileNotFoundError):
                    os.unlink(part.name)
                raise
    except OSError as error:
        raise FileError(f"{path} cannot be written: {error}", "unwritable-file") from error


def load(file: str | os.PathLike[str], mesh: Mesh) -> Curve:
    """Read a curve that Curve.save() or the program wrote as .json, on the mesh that it was drawn on.

    Parameters
    ----------
    file : str or path
    mesh : Mesh

    Returns
    -------
    Curve
        Of a file of the program, with default options and the picks as they are on the surface.

    Raises
    ------
    FileError
        The file cannot be read, holds no curve or several, or its points are not on this mesh, or the mesh changed since.

    Examples
    --------
    >>> curve.save("curve.json")
    >>> bool((bspline_curve.load("curve.json", mesh).points == curve.points).all())
    True
    """
    curves = load_all(file, mesh)
    if len(curves) != 1:
        raise FileError(f"{os.fspath(file)} holds {len(curves)} curves: load_all() reads them", "unreadable-file")
    return curves[0]


def load_all(file: str | os.PathLike[str], mesh: Mesh) -> list[Curve]:
    """Read all curves of a .json file, as of a pattern that the program made: one or several.

    Parameters
    ----------
    file : str or path
    mesh : Mesh

    Returns
    -------
    list of Curve
        In the order of the file, each as of load().

    Raises
    ------
    FileError
        As load() raises it.

    Examples
    --------
    >>> curve.save("curve.json")
    >>> len(bspline_curve.load_all("curve.json", mesh))
    1
    """
    import json
    from pathlib import Path

    require_mesh(mesh)
    path = Path(file_name(file))
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise FileError(f"{path} cannot be read: {error.strerror}", "unreadable-file") from error
    except ValueError as error:
        raise FileError(f"{path} holds no curve: it is not JSON ({error})", "unreadable-file") from error
    if not isinstance(document, dict) or not ("polyline" in document or isinstance(document.get("curves"), list)):
        raise FileError(f"{path} holds no curve: it has neither polyline nor curves", "unreadable-file")
    entries = document["curves"] if "curves" in document else [document]
    parts = [parts_of(entry, mesh, path) for entry in entries]
    require_same(mesh, document.get("mesh"), path)
    for _, state, _ in parts:
        require_on(mesh, state, path)
    return [restored(*part) for part in parts]


def parts_of(document: Any, mesh: Mesh, path: Path) -> tuple[Drawing, dict[str, Any], dict[str, Any] | None]:
    """What restored() takes, of an entry of a file."""
    try:
        line, spline = document["polyline"], document["spline"]
        drawn = document.get("drawn_by", {})
        report = document.get("report")
        told = report or {}
        state = {
            "points": rows(line["points"]),
            "faces": np.array(line["faces"], dtype=np.int32),
            "barycentrics": rows(line["barycentrics"]),
            "t": np.array(line["t"], dtype=np.float64),
            "control_points": rows(spline["control_points"]),
            "knots": spline["knots"],
            "pick_parameters": spline["pick_parameters"],
            "pick_vertices": line["picks"],
            "degree": spline["degree"],
            "closed": document["closed"],
            "usable": told.get("usable", True),
            "is_sampled": told.get("is_sampled", False),
            "alpha": told["rounds"][-1]["alpha"] if told.get("rounds") else 0.0,
        }
        picks = rows(drawn["picks"]) if drawn else state["points"][np.array(line["picks"], dtype=np.intp)]
        tangents = [_read_tangent(each) for each in document.get("tangents", ())]
        of_spline = {"closed": document["closed"], "degree": spline["degree"], "corners": corners_of(spline), "tangents": tangents}
        options = drawn.get("options", of_spline)
        guides = {name: drawn.get(name) for name in ("field", "avoid", "quality", "field_region")}
        drawing = Drawing(
            mesh,
            picks,
            changed(CURVE, {name: value for name, value in options.items() if name != "degree" or value > 1}),
            **mesh._guides(**{name: value if isinstance(value, str) or value is None else np.array(value) for name, value in guides.items()}),
            fixed=drawn.get("fixed", "" if len(picks) else "of a file without picks"),
        )
    except (ValueError, KeyError, TypeError, IndexError, AttributeError) as error:
        reason = f"an entry {error} is missing" if isinstance(error, KeyError) else str(error)
        raise FileError(f"{path} holds no curve: {reason}", "unreadable-file") from error
    return drawing, state, report


def corners_of(spline: dict[str, Any]) -> list[int]:
    """Picks at which the spline has knots whose multiplicity is its degree."""
    degree, closed, knots = spline["degree"], spline["closed"], spline["knots"]
    return [
        index
        for index, t in enumerate(spline["pick_parameters"])
        if degree > 1 and knots.count(t) >= degree and (closed or 0.0 < t < 1.0)
    ]


def rows(numbers: Any) -> Floats:
    array = np.array(numbers, dtype=np.float64)
    if array.size == 0:
        return array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError("rows of three numbers are needed")
    return array


def require_same(mesh: Mesh, then: Any, path: Path) -> None:
    """Refuses the mesh where the file names another; older files name none."""
    if then is not None and then != named(mesh):
        raise FileError(
            f"{path} is a curve of another mesh, or the mesh changed since the curve was drawn: draw it again",
            "unreadable-file",
        )


def require_on(mesh: Mesh, state: dict[str, Any], path: Path) -> None:
    """Refuses points that are not where their face and barycentric coordinates say."""
    faces = state["faces"]
    if not len(state["points"]) == len(faces) == len(state["barycentrics"]) == len(state["t"]):
        raise FileError(f"{path} holds no curve: its lists have different lengths", "unreadable-file")
    if faces.min() < 0 or faces.max() >= len(mesh.faces):
        raise FileError(f"{path} is a curve of another mesh: it names face {faces.max()}", "unreadable-file")
    places = (mesh.vertices[mesh.faces[faces]] * state["barycentrics"][..., None]).sum(1)
    away = np.abs(places - state["points"]).max()
    if not away <= SAME_PLACE * mesh.diagonal:
        raise FileError(f"{path} is a curve of another mesh: its points are up to {away:g} off", "unreadable-file")
