# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves in files: the program's JSON, and besides it what the curve was drawn by.

What only files need is imported with the first of them: json, pathlib and tempfile take as long as the whole package.
"""

from __future__ import annotations

import os
import zlib
from typing import TYPE_CHECKING, Any

import numpy as np

from ._arrays import Floats
from ._curve import Curve, Drawing, restored
from ._errors import FileError
from ._keywords import CURVE
from ._mesh import Mesh
from ._options import changed

if TYPE_CHECKING:
    from pathlib import Path

# A file's points may be those of the mesh to rounding, relative to its diagonal.
SAME_PLACE = 1e-9
CAD = {".step": "step", ".stp": "step", ".iges": "iges", ".igs": "iges"}


def document_of(curve: Curve) -> dict[str, Any]:
    drawing = curve._drawing
    polyline = {
        "points": curve.points.tolist(),
        "faces": curve.faces.tolist(),
        "barycentrics": curve.barycentrics.tolist(),
        "t": curve.t.tolist(),
        "picks": curve.pick_vertices.tolist(),
    }
    if drawing.field is not None:
        polyline["quality"] = curve.values.tolist()
    return {
        "closed": curve.closed,
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
            "avoid": None if drawing.avoid is None else drawing.avoid.tolist(),
        },
        "report": finite(curve.report),
    }


def named(mesh: Mesh) -> dict[str, Any]:
    """By what a mesh is known again: as docs/FILES.md tells."""
    with np.errstate(over="ignore"):
        vertices = mesh.vertices.astype("<f4") + np.float32(0)  # -0 + 0 is 0
    crc32 = zlib.crc32(mesh.faces.astype("<i4").tobytes(), zlib.crc32(vertices.tobytes()))
    return {"vertices": len(vertices), "faces": len(mesh.faces), "crc32": f"{crc32:08x}"}


def finite(value: Any) -> Any:
    """JSON has no infinity: null."""
    if isinstance(value, dict):
        return {name: finite(each) for name, each in value.items()}
    if isinstance(value, list):
        return [finite(each) for each in value]
    return value if not isinstance(value, float) or np.isfinite(value) else None


def save(curve: Curve, file: str | os.PathLike[str], unit: str) -> None:
    from pathlib import Path

    path = Path(file)
    kind = CAD.get(path.suffix.lower())
    if kind is not None:
        is_polyline = path.stem.lower().endswith(".polyline")
        write_wholly(path, curve._core.cad_bytes(kind, is_polyline, unit))
        return
    if path.suffix.lower() != ".json":
        raise FileError(f"{path}: a curve is saved as .json, .step or .iges", "unwritable-file")
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
        The file cannot be read, holds no curve, or its points are not on this mesh, or the mesh changed since.
    """
    import json
    from pathlib import Path

    path = Path(file)
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        line, spline = document["polyline"], document["spline"]
        drawn = document.get("drawn_by", {})
        report = document.get("report", {})
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
            "usable": report.get("usable", True),
            "is_sampled": report.get("is_sampled", False),
            "alpha": report["rounds"][-1]["alpha"] if report.get("rounds") else 0.0,
        }
        picks = rows(drawn["picks"]) if drawn else state["points"][line["picks"]]
        of_spline = {"closed": document["closed"], "degree": spline["degree"], "corners": corners_of(spline)}
        options = drawn.get("options", of_spline)
        field = drawn.get("field")
        drawing = Drawing(
            mesh,
            picks,
            changed(CURVE, options),
            mesh._field_of(field),
            None if drawn.get("avoid") is None else np.array(drawn["avoid"], dtype=np.int32),
        )
    except OSError as error:
        raise FileError(f"{path} cannot be read: {error}", "unreadable-file") from error
    except (ValueError, KeyError, TypeError, IndexError, AttributeError) as error:
        raise FileError(f"{path} holds no curve: {error!r}", "unreadable-file") from error
    require_same(mesh, document.get("mesh"), path)
    require_on(mesh, state, path)
    return restored(drawing, state, report)


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
