"""What was taken from one world to make another, computed from the two: capabilities, limits, places, or something else."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from missiontree.formats.plain import to_plain
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason

Kind = Literal["capability", "limit", "place", "other"]
Path = tuple[str, ...]
Change = tuple[Path, Any, Any]
KINDS: tuple[Kind, ...] = ("capability", "limit", "place")
_LIMIT_RULES = frozenset({"limit_too_low", "budget_exceeded", "limits_clash"})


@dataclass(frozen=True, slots=True)
class Removal:
    """
    One thing that is there before and not afterwards.

    Parameters
    ----------
    kind
        ``capability``: types lost it, and nobody has it. ``limit``: a number of types became smaller. ``place``: a zone that types may
        enter no more, or a road or lift that is blocked. ``other``: anything else that differs.
    name
        The capability, the limit, the zone, the ends of the road or the id of the lift; for anything else where it stands.
    types
        Robot types that lost it; empty if it was taken from the scene.
    """

    kind: Kind
    name: str
    types: tuple[str, ...] = ()

    def is_missing_in(self, reasons: Sequence[Reason]) -> bool:
        """Whether a reason says that this is what is missing, and to whom."""
        return any(self.is_said_by(reason) for reason in reasons)

    def is_said_by(self, reason: Reason) -> bool:
        """Whether the reason is about what was removed, and not about anything that was never there."""
        if self.types and reason.robot not in self.types:
            return False
        if self.kind == "capability":
            return reason.rule == "capability_missing" and reason.needed == self.name
        if self.kind == "limit":
            return reason.rule in _LIMIT_RULES and reason.needed.startswith(f"{self.name} ")
        if self.types:
            return reason.rule == "zone_forbidden" and reason.needed == self.name
        return self.kind == "place" and reason.rule == "unreachable" and self.name in reason.message


def removals(before: MissionBrief, after: MissionBrief) -> tuple[Removal, ...]:
    """All that differs between two missions and their worlds; what several types lost under one name is one thing."""
    found: dict[tuple[Kind, str], list[str]] = {}
    for change in _changes((), to_plain(before), to_plain(after)):
        kind, name, robot_type = _read(change, before, after)
        found.setdefault((kind, name), []).extend([robot_type] if robot_type else [])
    return tuple(Removal(kind, name, tuple(types)) for (kind, name), types in found.items())


def _read(change: Change, before: MissionBrief, after: MissionBrief) -> tuple[Kind, str, str]:
    path, old, new = change
    match path:
        case ("fleet", "types", robot_type, "capabilities", name):
            if new is None and all(kind.capability(name) is None for kind in after.fleet.types):
                return "capability", name, robot_type
        case ("fleet", "types", robot_type, "limits", name):
            if new is not None and old is not None and new < old:
                return "limit", name, robot_type
        case ("fleet", "types", robot_type, "zones", zone):
            if new is None and after.fleet.by_id[robot_type].zones is not None:  # None allows all
                return "place", zone, robot_type
        case ("scene", "roads", "roads", index, "blocked"):
            if new and before.scene is not None and before.scene.roads is not None:
                return "place", " - ".join(before.scene.roads.roads[int(index)].ends), ""
        case ("scene", "roads", "lifts", name, "blocked"):
            if new:
                return "place", name, ""
        case _:
            pass
    return "other", ".".join(path), ""


def _changes(path: Path, old: Any, new: Any) -> Iterator[Change]:
    """Where plain data differs: what stands there before, and what afterwards; None if nothing does."""
    if isinstance(old, Mapping | list) or isinstance(new, Mapping | list):
        olds, news = _members(old), _members(new)
        whole = isinstance(old, list) and isinstance(new, list)  # who is gone altogether is one change
        for key in dict.fromkeys((*olds, *news)):
            if whole and (key in olds) != (key in news):
                yield (*path, key), olds.get(key), news.get(key)
            else:
                yield from _changes((*path, key), olds.get(key), news.get(key))
    elif old != new:
        yield path, old, new


def _members(data: Any) -> Mapping[str, Any]:
    """Members by name: those of a list by their id, by themselves if they are texts, else by their place."""
    if isinstance(data, Mapping):
        return data
    if not isinstance(data, list):
        return {} if data is None else {"": data}
    named = (isinstance(member, Mapping) and "id" in member for member in data)
    if data and all(named):
        return {member["id"]: member for member in data}
    texts = all(isinstance(member, str) for member in data)
    return {member if texts else str(place): member for place, member in enumerate(data)}
