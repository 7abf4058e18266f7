# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters as filters.json describes them, and options checked against that."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from functools import cache
from numbers import Integral, Real
from pathlib import Path
from typing import Any

import numpy as np

CURVE = "generate_bspline_curve_on_surface"
FIELD = "compute_scalar_field_for_curves_per_vertex"


@cache
def parameters(filter_name: str) -> dict[str, dict[str, Any]]:
    """The descriptions of a filter's parameters by id."""
    described = json.loads((Path(__file__).parent / "filters.json").read_text(encoding="utf-8"))
    found = next(each for each in described["filters"] if each["pythonName"] == filter_name)
    return {parameter["id"]: parameter for parameter in found["parameters"]}


def checked(filter_name: str, options: Mapping[str, object]) -> dict[str, Any]:
    """The options, with numbers of numpy as Python's own.

    Raises TypeError or ValueError where one is not what its description allows; pymeshlab itself moves some values into
    their range and goes on.
    """
    described = parameters(filter_name)
    return {name: checked_option(described[name], value) for name, value in options.items()}


def checked_option(parameter: Mapping[str, Any], value: object) -> bool | int | float | str:
    name, kind = parameter["id"], parameter["type"]
    if kind in ("int", "double", "absperc"):
        return checked_number(parameter, value)
    if kind == "bool":
        if not isinstance(value, (bool, np.bool_)):
            raise TypeError(f"{name} is {value!r}, but must be True or False")
        return bool(value)
    if kind == "tolerances" and isinstance(value, (list, tuple, np.ndarray)) and np.ndim(value) > 0:  # one for each pick
        return ", ".join(str(checked_option(parameter, each)) for each in value)
    if kind in ("length", "tolerances") and isinstance(value, Real) and not isinstance(value, bool):
        return repr(float(value))
    if not isinstance(value, str):
        raise TypeError(f"{name} is {value!r}, but must be text")
    if kind == "enum":
        allowed = [option["id"] for option in parameter["enumOptions"]]
        if value not in allowed:
            raise ValueError(f"{name} is {value!r}, but must be one of {', '.join(map(repr, allowed))}")
    return str(value)


def checked_number(parameter: Mapping[str, Any], value: object) -> int | float:
    name, is_integer = parameter["id"], parameter["type"] == "int"
    if isinstance(value, bool) or not isinstance(value, Integral if is_integer else Real):
        raise TypeError(f"{name} is {value!r}, but must be {'an integer' if is_integer else 'a number'}")
    number = int(value) if isinstance(value, Integral) else float(value)
    low, high = parameter.get("min", -math.inf), parameter.get("max", math.inf)
    is_above = number > low if parameter.get("excludesMin") else number >= low
    if not (is_above and number <= high and math.isfinite(number)):
        raise ValueError(f"{name} is {number!r}, but must be {allowed_range(parameter)}")
    return number


def allowed_range(parameter: Mapping[str, Any]) -> str:
    """ "in (0, 1]", "at least 0", "more than 0" or "finite"."""
    low, high, excludes = parameter.get("min"), parameter.get("max"), parameter.get("excludesMin")
    if high is not None:
        return f"in {'(' if excludes else '['}{low:g}, {high:g}]"
    if low is not None:
        return f"finite and {'more than' if excludes else 'at least'} {low:g}"
    return "finite"
