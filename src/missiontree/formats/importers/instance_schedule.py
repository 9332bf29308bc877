"""
Schedules of instances in the JSON form that ``missiontree schedule --json`` prints, as values.

Read are ``status``, ``claim``, ``method``, ``bound_s``, ``makespan_s``, ``actions`` and, of a tree in columns, ``chosen``. An action has
``node`` (the leaf, or the task from 0; null where a robot gets to the end), ``number`` (the robot: from 0, of a tree among the equal ones),
``start_s`` and ``end_s``; whatever else stands there is for people.
"""

from __future__ import annotations

from typing import Any, Literal, cast, get_args

from missiontree.formats.parsed import Parsed
from missiontree.formats.place import found
from missiontree.mission.certificate import Certificate, Claim
from missiontree.mission.coalitions import CoalitionMission, CoalitionSchedule, Visit
from missiontree.mission.columns import TreeColumns
from missiontree.mission.schedule import ScheduleStatus
from missiontree.mission.tree_schedule import TreeSchedule

NEEDED = ("status", "claim", "method", "makespan_s", "actions")
MOST_NUMBER = 1e12
Place = tuple[str | int, ...]


def schedule_of(parsed: Parsed, instance: TreeColumns | CoalitionMission) -> TreeSchedule | CoalitionSchedule:
    """
    The schedule that plain data describes.

    Parameters
    ----------
    parsed
        The file.
    instance
        What it is a schedule of.

    Raises
    ------
    InputError
        If it is no schedule of this form; says where, what was found and what is accepted.
    """
    if not isinstance(parsed.data, dict):
        raise parsed.refusal(f"{found(parsed.data)} stands here", (), f"a mapping with {', '.join(NEEDED)}")
    for key in NEEDED:
        if key not in parsed.data:
            hint = "Write it with missiontree schedule FILE --json."
            raise parsed.refusal(f"{key!r} is missing", (), f"a mapping with {', '.join(NEEDED)}", hint)
    read = _Reading(parsed)
    if isinstance(instance, CoalitionMission):
        return read.coalitions(len(instance.skills))
    return read.tree(instance)


class _Reading:
    def __init__(self, parsed: Parsed) -> None:
        self._parsed, self._data = parsed, cast("dict[str, Any]", parsed.data)

    def tree(self, columns: TreeColumns) -> TreeSchedule:
        start_s: dict[int, int] = {}
        robot: dict[int, int] = {}
        for number, action in enumerate(self._actions()):
            at: Place = ("actions", number)
            node = self._whole(action.get("node"), (*at, "node"), len(columns.kind) - 1)
            if node in start_s:
                raise self._parsed.refusal(f"node {node} is done a second time", at, "every action once")
            start_s[node] = self._whole(action.get("start_s"), (*at, "start_s"))
            robot[node] = self._whole(action.get("number"), (*at, "number"))
            end = self._number(action.get("end_s"), (*at, "end_s"))
            if end != start_s[node] + columns.duration[node]:
                message = f"it ends {end - start_s[node]:g} s after its start"
                raise self._parsed.refusal(message, (*at, "end_s"), f"{columns.duration[node]} s, as the instance says")
        return TreeSchedule(
            status=self._status(),
            certificate=self._certificate(),
            chosen=self._chosen(),
            start_s=start_s,
            robot=robot,
            makespan_s=self._whole(self._data["makespan_s"], ("makespan_s",)),
        )

    def coalitions(self, robots: int) -> CoalitionSchedule:
        visits: dict[tuple[int, float, float], list[int]] = {}
        arrivals: dict[int, float] = {}
        for number, action in enumerate(self._actions()):
            at: Place = ("actions", number)
            robot = self._whole(action.get("number"), (*at, "number"), robots - 1)
            start, end = (self._number(action.get(name), (*at, name)) for name in ("start_s", "end_s"))
            if action.get("node") is None:
                arrivals[robot] = start
            else:
                visits.setdefault((self._whole(action["node"], (*at, "node")), start, end), []).append(robot)
        return CoalitionSchedule(
            status=self._status(),
            certificate=self._certificate(),
            visits=tuple(
                Visit(task=task, robots=tuple(sorted(own)), start_s=start, end_s=end)
                for (task, start, end), own in sorted(visits.items(), key=lambda item: (item[0][1], item[0][0]))
            ),
            arrivals_s=tuple(arrivals[robot] for robot in sorted(arrivals)),
            makespan_s=self._number(self._data["makespan_s"], ("makespan_s",)),
        )

    def _actions(self) -> list[dict[str, Any]]:
        given = self._data["actions"]
        if not isinstance(given, list):
            raise self._parsed.refusal(f"{found(given)} stands here", ("actions",), "a list of actions")
        for number, action in enumerate(given):
            if not isinstance(action, dict):
                accepted = "a mapping with node, number, start_s and end_s"
                raise self._parsed.refusal(f"{found(action)} stands here", ("actions", number), accepted)
        return given

    def _chosen(self) -> dict[int, int]:
        given = self._data.get("chosen", {})
        if not isinstance(given, dict):
            raise self._parsed.refusal(f"{found(given)} stands here", ("chosen",), "a mapping from XOR to child")
        chosen: dict[int, int] = {}
        for node, child in given.items():
            if not str(node).isdecimal() or len(str(node)) > 12:
                raise self._parsed.refusal(f"{found(node)} stands here", ("chosen",), "the number of an XOR")
            chosen[int(node)] = self._whole(child, ("chosen", node))
        return chosen

    def _status(self) -> ScheduleStatus:
        return cast("ScheduleStatus", self._word("status", ScheduleStatus))

    def _certificate(self) -> Certificate:
        bound = self._data.get("bound_s")
        method = self._data["method"]
        if not isinstance(method, str) or not method:
            raise self._parsed.refusal(f"{found(method)} stands here", ("method",), "the name of a method")
        return Certificate(
            claim=cast("Claim", self._word("claim", Claim)),
            method=method,
            bound=None if bound is None else self._number(bound, ("bound_s",)),
        )

    def _word(self, name: Literal["status", "claim"], kind: object) -> str:
        known = get_args(kind)
        if self._data[name] not in known:
            raise self._parsed.refusal(f"{found(self._data[name])} stands here", (name,), ", ".join(known))
        return str(self._data[name])

    def _number(self, given: object, place: Place) -> float:
        if isinstance(given, bool) or not isinstance(given, int | float) or not 0 <= given <= MOST_NUMBER:
            raise self._parsed.refusal(f"{found(given)} stands here", place, "a number of at least 0")
        return float(given)

    def _whole(self, given: object, place: Place, most: int | None = None) -> int:
        number = self._number(given, place)
        if number != int(number) or (most is not None and number > most):
            accepted = "a whole number" if most is None else f"a whole number from 0 to {most}"
            raise self._parsed.refusal(f"{found(given)} stands here", place, accepted)
        return int(number)
