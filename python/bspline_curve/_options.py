# SPDX-License-Identifier: GPL-3.0-or-later
"""Options, checked against what filters.json says of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from numbers import Integral, Real
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from ._errors import OptionError

Progress: TypeAlias = Callable[[float, str], object]
Direction: TypeAlias = "tuple[float, float, float]"
TwoDirections: TypeAlias = "tuple[Direction | None, Direction | None]"  # before a corner, and after it
Tangents: TypeAlias = "tuple[tuple[int, Direction | TwoDirections], ...]"
Value: TypeAlias = "bool | int | float | str | tuple[int, ...] | tuple[str, ...] | Tangents | None"


def part_of(progress: Progress | None, start: float, end: float) -> Progress | None:
    """A callable for a part of the work, whose fractions 0 to 1 are `start` to `end` of the whole."""
    if progress is None:
        return None
    if not callable(progress):
        raise TypeError("progress must be a function of a fraction and a stage, or None")
    return lambda fraction, stage: progress(start + (end - start) * fraction, stage)


class Option(NamedTuple):
    """What an option may be."""

    kind: str  # bool, int, double, length, tolerances, picks, tangents or enum
    default: Any
    low: float | None
    high: float | None
    excludes_low: bool
    words: tuple[str, ...]


def changed(described: Mapping[str, Option], given: Mapping[str, object]) -> dict[str, Value]:
    """The options that are not their defaults, checked, as the core takes them. For the others the core takes what the
    preset says."""
    result: dict[str, Value] = {}
    for name, value in given.items():
        option = described[name]
        if value is not option.default:
            checked = checked_value(name, option, value)
            if checked != option.default:
                result[name] = checked
    return result


def checked_value(name: str, option: Option, value: object) -> Value:
    if option.kind in ("int", "double"):
        return checked_number(name, option, value)
    if option.kind == "bool":
        if not isinstance(value, (bool, np.bool_)):
            raise TypeError(f"{name} is {value!r}, but must be True or False")
        return bool(value)
    if option.kind == "length":
        return checked_length(name, value)
    if option.kind == "tolerances":
        return checked_tolerances(name, value)
    if option.kind == "picks":
        return checked_picks(name, value)
    if option.kind == "tangents":
        return checked_tangents(name, value)
    if not isinstance(value, str):
        raise TypeError(f"{name} is {value!r}, but must be one of {', '.join(map(repr, option.words))}")
    if value not in option.words:
        raise OptionError(f"{name} is {value!r}, but must be one of {', '.join(map(repr, option.words))}", "bad-option")
    return str(value)


def checked_number(name: str, option: Option, value: object) -> int | float:
    is_integer = option.kind == "int"
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, Integral if is_integer else Real):
        raise TypeError(f"{name} is {value!r}, but must be {'an integer' if is_integer else 'a number'}")
    number: int | float = int(value) if is_integer else float(value)  # type: ignore[call-overload]
    low = -math.inf if option.low is None else option.low
    high = math.inf if option.high is None else option.high
    is_above = number > low if option.excludes_low else number >= low
    if not (is_above and number <= high and math.isfinite(number)) or (is_integer and number > 2**31 - 1):
        raise OptionError(f"{name} is {number!r}, but must be {allowed_range(option)}", "bad-option")
    return number


def checked_length(name: str, value: object) -> str:
    """A length in the unit of the mesh, or text like "1.5 edges", as text."""
    if isinstance(value, str):
        return str(value)
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, Real):
        raise TypeError(f"{name} is {value!r}, but must be a number, or text like '1.5 edges'")
    return repr(float(value))


def checked_tolerances(name: str, value: object) -> str | tuple[str, ...]:
    """A length for all picks, or one for each."""
    given = value.tolist() if isinstance(value, np.ndarray) else value
    if isinstance(given, str) or not isinstance(given, Sequence):
        return checked_length(name, given)
    entries = tuple(checked_length(f"{name}[{i}]", each) for i, each in enumerate(given))
    if not entries:
        raise OptionError(f"{name} is {value!r}, but must have a length for each pick", "bad-option")
    return entries


def checked_picks(name: str, value: object) -> str | tuple[int, ...]:
    """Indices of picks, ascending; or "all"."""
    if isinstance(value, str):
        if value != "all":
            raise OptionError(f"{name} is {value!r}, but must be indices of picks, or 'all'", "bad-option")
        return value
    ids = np.asarray(value)
    if ids.ndim != 1 or (ids.size and ids.dtype.kind not in "iu"):
        raise TypeError(f"{name} is {value!r}, but must be indices of picks, or 'all'")
    if ids.size and ids.min() < 0:
        raise OptionError(f"{name} has {ids.min()}, but picks are counted from 0", "bad-option")
    return tuple(sorted({int(each) for each in ids}))


def checked_tangents(name: str, value: object) -> Tangents | None:
    """Pairs of a pick's index and a direction, or two of a corner, from such or from a mapping; None where there are none."""
    if value is None:
        return None
    if not isinstance(value, (Mapping, Sequence)) or isinstance(value, str):
        raise TypeError(f"{name} is {value!r}, but must be a mapping from indices of picks to directions")
    pairs = list(value.items()) if isinstance(value, Mapping) else [tuple(pair) for pair in value]
    checked = []
    for pick, given in pairs:
        if not isinstance(pick, Integral) or isinstance(pick, bool):
            raise TypeError(f"{name} has {pick!r}: {given!r}, but must have indices of picks and directions (x, y, z)")
        if pick < 0:
            raise OptionError(f"{name} has {pick}, but picks are counted from 0", "bad-option")
        checked.append((int(pick), _checked_tangent(name, given)))
    return tuple(sorted(checked, key=lambda pair: pair[0])) or None


def _checked_tangent(name: str, given: Any) -> Direction | TwoDirections:
    if not isinstance(given, (Sequence, np.ndarray)) or isinstance(given, str) or len(given) != 2:
        return _checked_direction(name, given)
    before, after = (None if side is None else _checked_direction(name, side) for side in given)
    if before is None and after is None:
        raise OptionError(f"{name} has {given!r}, but one of the two is a direction", "bad-option")
    return (before, after)


def _checked_direction(name: str, given: Any) -> Direction:
    direction = np.asarray(given, dtype=np.float64)
    if direction.shape != (3,):
        raise TypeError(f"{name} has {given!r}, but must have directions (x, y, z), or of a corner two, one of which can be None")
    if not np.isfinite(direction).all() or not direction.any():
        raise OptionError(f"{name} has {given!r}, but a direction is finite and not zero", "bad-option")
    x, y, z = direction.tolist()
    return (x, y, z)


def allowed_range(option: Option) -> str:
    """ "in (0, 1]", "finite and at least 0"."""
    if option.high is not None:
        return f"in {'(' if option.excludes_low else '['}{option.low:g}, {option.high:g}]"
    if option.low is not None:
        return f"finite and {'more than' if option.excludes_low else 'at least'} {option.low:g}"
    return "finite"
