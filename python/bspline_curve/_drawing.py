# SPDX-License-Identifier: GPL-3.0-or-later
"""What a curve is drawn by: kept with it, so that it can be drawn again with something changed."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _core
from ._arrays import Floats, Int32s
from ._errors import FieldError, OptionError, PickError
from ._identity import AbsentMesh
from ._options import Progress, Value, part_of

if TYPE_CHECKING:
    from ._mesh import Mesh

OF_FIELD = "field_"  # options with this beginning are those of the field of this kind
NEED_AN_ARRAY = {"quality": "quality", "obstacle": "field_region"}
THRESHOLDS = ("under-threshold", "over-threshold")


class Drawing(NamedTuple):
    """What a curve is drawn by."""

    home: Mesh | AbsentMesh
    picks: Floats
    options: dict[str, Value]  # those that are not their defaults
    field: str | _core.Field | None = None  # "auto", a kind, or values
    avoid: str | Int32s | None = None  # a threshold, or ids
    quality: Floats | None = None
    region: Int32s | None = None  # of obstacles
    fixed: str = ""  # what the curve is, where it was not drawn through picks

    @property
    def mesh(self) -> Mesh:
        return self.home.found() if isinstance(self.home, AbsentMesh) else self.home

    def kind(self) -> str | None:
        """Of the field, if it is one of a kind: what "auto" stands for."""
        if self.field != "auto":
            return self.field if isinstance(self.field, str) else None
        is_used = self.avoid in THRESHOLDS if isinstance(self.avoid, str) else False
        if is_used or self.quality is None or not _core.can_be_followed(self.quality):
            return None
        return "quality"

    def field_options(self) -> dict[str, Value]:
        chosen = {
            name.removeprefix(OF_FIELD): value
            for name, value in self.options.items()
            if name.startswith(OF_FIELD) and name not in ("field_weight", "field_cost")
        }
        if self.field == "auto":
            chosen["normalised"] = True
        return chosen

    def made_field(self, progress: Progress | None = None) -> _core.Field | None:
        kind = self.kind()
        if kind is None:
            return None if isinstance(self.field, str) else self.field
        needed = {"quality": self.quality, "obstacle": self.region}
        if kind in needed and needed[kind] is None:
            raise FieldError(
                f"field is {kind!r}, but {NEED_AN_ARRAY[kind]} is not given"
                + (", and the mesh has none; give it, or a value for each vertex as field" if kind == "quality" else ""),
                "bad-field",
            )
        return self.mesh._chosen_field({**self.field_options(), "kind": kind}, self.quality, self.region, progress)

    def avoided(self, made: _core.Field | None) -> Int32s | None:
        """Ids of faces to avoid."""
        if self.avoid is None or not isinstance(self.avoid, str):
            return self.avoid
        values = self.quality if made is None else made.values
        if values is None:
            raise OptionError(f"avoid is {self.avoid!r}, which needs a field or quality: give one of them", "bad-option")
        threshold: Any = self.options.get("avoid_threshold", 0.0)
        find = _core.faces_under if self.avoid == "under-threshold" else _core.faces_over
        return find(self.mesh._core, values, float(threshold))

    def resolved(self, progress: Progress | None = None) -> tuple[dict[str, Value], _core.Field | None, Int32s | None]:
        """Options, field, and faces to avoid, as the core takes them."""
        made = self.made_field(progress)
        options = self.options
        if self.kind() is None and "field_cost" not in options:  # values are their own cost, whatever they were made from
            options = {**options, "field_cost": "identity"}
        return options, made, self.avoided(made)

    def renumbered(self, count: int, moved: Callable[[int], int | None]) -> Drawing:
        """Corners, tangents and tolerances of so many other picks: of `moved` of each, of none where that is None."""
        options = dict(self.options)
        tolerances: Any = options.get("pick_tolerance")
        if isinstance(tolerances, tuple):
            options["pick_tolerance"] = _spread(tolerances, count, moved)
        corners: Any = options.get("corners")
        if isinstance(corners, tuple):
            options["corners"] = tuple(each for each in map(moved, corners) if each is not None)
        tangents: Any = options.get("tangents") or ()
        if tangents:
            pairs = ((moved(pick), direction) for pick, direction in tangents)
            options["tangents"] = tuple((pick, direction) for pick, direction in pairs if pick is not None)
        return self._replace(options={name: value for name, value in options.items() if value != ()})

    def draw(self, start: _core.Curve | None, progress: Progress | None) -> tuple[_core.Curve, Drawing]:
        """The curve, and what it was drawn by, with the mesh in place."""
        if self.fixed:
            raise PickError(f"this curve is {self.fixed}: it has no picks to be drawn through; draw one with Mesh.curve()", "too-few-picks")
        placed = self._replace(home=self.mesh)
        share = 0.5 if isinstance(self.field, str) and placed.mesh._known_field({**self.field_options(), "kind": self.field}) is None else 0.0  # of the field
        resolved = placed.resolved(part_of(progress, 0.0, share))
        return placed.mesh._core.draw(self.picks, *resolved, start, part_of(progress, share, 1.0)), placed


def _spread(entries: tuple[str, ...], count: int, moved: Callable[[int], int | None]) -> tuple[str, ...]:
    """The entries of picks at their new places; a new pick has that of the one before it, at the start of the one behind."""
    placed = {at: entry for at, entry in ((moved(i), entry) for i, entry in enumerate(entries)) if at is not None}
    return tuple(placed[max((at for at in placed if at <= i), default=min(placed))] for i in range(count))
