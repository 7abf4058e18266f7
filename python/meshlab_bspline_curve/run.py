# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the filters on arrays, in a document of the package's own."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import numpy as np
import numpy.typing as npt
import pymeshlab

from . import arrays
from .arrays import Floats, Int32s
from .curve import Curve, Tube
from .description import CURVE, FIELD, checked, parameters
from .errors import CurveError

# One document for all calls: pymeshlab 2025.7 may crash where a document was deleted in which a filter had failed.
_document = pymeshlab.MeshSet()
_lock = threading.Lock()


@contextmanager
def document() -> Iterator[Any]:
    """The document, empty; one thread at a time has it."""
    with _lock:
        try:
            yield _document
        finally:
            _document.clear()
            _document.clear_filter_script()


def draw(
    mesh: tuple[npt.ArrayLike, npt.ArrayLike],
    picks: npt.ArrayLike,
    choices: Mapping[str, Any],
    save: str | os.PathLike[str] | None,
    options: Mapping[str, Any],
) -> Curve:
    """What draw_curve does. choices: field, quality, avoid and field_region, each a word or an array."""
    vertices, faces = mesh_arrays(mesh)
    through = arrays.points(picks, "picks")
    values = {**options, "picks": picks_text(through), "save": "" if save is None else os.fspath(save)}
    values["field"], quality = chosen_field(choices, len(vertices))
    values["avoid"], selected = chosen_faces(choices, values["field"], len(faces))
    if avoids_by_quality(values) and quality is None:
        raise ValueError(f"avoid is {values['avoid']!r}, which needs a field or quality: give one of them")
    if quality is not None and not uses_quality(values):
        raise ValueError("quality is given, but nothing uses it: set field to 'quality' or 'auto', or avoid to a threshold")
    values = checked(CURVE, values)
    if not len(through):
        raise ValueError("picks is empty: an open curve needs 2 points, a closed one 3")
    with document() as layers:
        figures = run_on(layers, CURVE, vertices, faces, quality, selected, values)
        return curve_of(layers, figures)


def compute(
    mesh: tuple[npt.ArrayLike, npt.ArrayLike],
    quality: npt.ArrayLike | None,
    region: npt.ArrayLike | None,
    options: Mapping[str, Any],
) -> Floats:
    """What compute_field does."""
    vertices, faces = mesh_arrays(mesh)
    options = checked(FIELD, options)
    kind = options["kind"]
    needed = {"quality": ("quality", quality), "obstacle": ("region", region)}
    if kind in needed and needed[kind][1] is None:
        raise ValueError(f"kind is {kind!r}, which needs {needed[kind][0]}")
    values = None if quality is None else arrays.per_vertex(quality, "quality", len(vertices))
    selected = None if region is None else arrays.face_mask(region, "region", len(faces))
    with document() as layers:
        run_on(layers, FIELD, vertices, faces, values, selected, options)
        return np.array(layers.current_mesh().vertex_scalar_array())


def mesh_arrays(mesh: tuple[npt.ArrayLike, npt.ArrayLike]) -> tuple[Floats, Int32s]:
    vertices = arrays.points(mesh[0], "vertices")
    faces = arrays.triangles(mesh[1], len(vertices))
    for name, array in (("vertices", vertices), ("faces", faces)):
        if not len(array):
            raise ValueError(f"{name} is empty: a triangle mesh is needed")
    return vertices, faces


def avoids_by_quality(values: Mapping[str, Any]) -> bool:
    return values["avoid"] in ("under-threshold", "over-threshold") and values["field"] in ("none", "auto")


def uses_quality(values: Mapping[str, Any]) -> bool:
    return values["field"] in ("quality", "auto") or avoids_by_quality(values)


def chosen_field(choices: Mapping[str, Any], vertices: int) -> tuple[str, Floats | None]:
    """The kind of the field, and the quality of the mesh: values that are given are both."""
    field, quality = choices["field"], choices["quality"]
    if isinstance(field, str):
        if quality is None:
            if field == "quality":
                raise ValueError("field is 'quality', but quality is not given: give the values as field or as quality")
            return field, None
        return field, arrays.per_vertex(quality, "quality", vertices)
    if quality is not None:
        raise ValueError("field and quality are both given as arrays: the field is the quality then; give one of them")
    return "quality", arrays.per_vertex(field, "field", vertices)


def chosen_faces(
    choices: Mapping[str, Any], field: str, faces: int
) -> tuple[str, npt.NDArray[np.bool_] | None]:
    """How faces are avoided, and which are selected for that or as region of obstacles."""
    avoid, region = choices["avoid"], choices["field_region"]
    if field == "obstacle" and region is None:
        raise ValueError("field is 'obstacle', which needs field_region, the faces of the obstacles")
    obstacles = None if region is None else arrays.face_mask(region, "field_region", faces)
    if isinstance(avoid, str):
        if avoid.startswith("selected"):
            raise ValueError(f"avoid is {avoid!r}, but arrays know no selection: give ids of faces, or a bool for each")
        return avoid, obstacles
    avoided = arrays.face_mask(avoid, "avoid", faces)
    if obstacles is not None and (obstacles != avoided).any():
        raise ValueError(
            "avoid and field_region name different faces, which one call cannot take: compute the field by "
            "compute_field(kind='obstacle') and give its values as field"
        )
    return "selected-faces", avoided


def picks_text(picks: Floats) -> str:
    """Digits enough for the same doubles."""
    return "; ".join(" ".join(map(repr, pick)) for pick in picks.tolist())


def run_on(
    layers: Any,
    filter_name: str,
    vertices: Floats,
    faces: Int32s,
    quality: Floats | None,
    selected: npt.NDArray[np.bool_] | None,
    options: Mapping[str, Any],
) -> dict[str, Any]:
    """Applies a filter to a layer with these arrays."""
    try:
        extra = {} if quality is None else {"v_scalar_array": quality}
        if selected is not None:
            # The way to a selection is by a scalar; the filters do not look at those of faces.
            extra["f_scalar_array"] = selected.astype(np.float64)
        layers.add_mesh(pymeshlab.Mesh(vertices, faces, **extra), "mesh")
        if selected is not None:
            layers.compute_selection_by_condition_per_face(condselect="fq > 0.5")
        return apply(layers, filter_name, options)
    except pymeshlab.PyMeshLabException as error:
        raise CurveError(reason(error)) from None


def reason(error: Exception) -> str:
    """What the filter said, without what pymeshlab says around it."""
    text = str(error)
    return text.partition("\nDetails: ")[2] or text


def apply(layers: Any, filter_name: str, options: Mapping[str, Any]) -> dict[str, Any]:
    """apply_filter with lengths as plain numbers; options that are None are left to the filter."""
    described = parameters(filter_name)
    given = {}
    for name, value in options.items():
        if value is None:
            continue
        is_length = described[name]["type"] == "absperc" and isinstance(value, (int, float))
        given[name] = pymeshlab.PureValue(float(value)) if is_length else value
    return dict(layers.apply_filter(filter_name, **given))


def curve_of(layers: Any, figures: dict[str, Any]) -> Curve:
    """From the layers that the filter added: the curve, which is the current one, and perhaps a tube."""
    layer = layers.current_mesh()
    taken = {name: np.array(figures.pop(name)) for name in ("knots", "control_points", "pick_parameters", "pick_vertices")}
    tube = None
    for other in layers:
        if other.label() == "mesh tube":
            tube = Tube(np.array(other.vertex_matrix()), other.face_matrix().astype(np.int64))
    return Curve(
        points=np.array(layer.vertex_matrix()),
        faces=layer.vertex_custom_scalar_attribute_array("face_index").astype(np.int64),
        barycentrics=np.array(layer.vertex_custom_point_attribute_matrix("barycentric")),
        t=np.array(layer.vertex_custom_scalar_attribute_array("t")),
        values=np.array(layer.vertex_scalar_array()),
        control_points=taken["control_points"].reshape(-1, 3),
        knots=taken["knots"],
        degree=int(figures["degree"]),
        closed=bool(figures["closed"]),
        pick_parameters=taken["pick_parameters"],
        pick_vertices=taken["pick_vertices"].astype(np.int64),
        tube=tube,
        figures=figures,
    )
