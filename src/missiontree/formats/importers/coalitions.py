"""
Missions of coalitions in the JSON form of the Sadcher data set (8t3r), as values.

One mapping. ``Q[r][s]``: robot r has skill s (1) or not (0). ``R[t][s]``: task t needs skill s (1) or not (0). ``T_e[t]``: how long it
takes, in seconds. ``task_locations[t]``: where it is done, ``[x, y]`` in metres. Task 0 is the start of all robots and the last task is
where all of them end up; neither needs a skill or takes time. ``precedence_constraints`` (may be left out): pairs [before, after] of tasks.
``ref`` (may be left out): a makespan that was published.
"""

from __future__ import annotations

from math import isfinite
from pathlib import Path
from typing import Any

from missiontree.formats.fault import nearest
from missiontree.formats.parsed import Parsed
from missiontree.formats.place import found, quoted
from missiontree.formats.reader import parse
from missiontree.formats.source import load_text
from missiontree.mission.coalitions import MOST_COALITION_ROBOTS, MOST_TASKS, CoalitionMission, CoalitionTask

NEEDED = ("Q", "R", "T_e", "task_locations")
KEYS = (*NEEDED, "precedence_constraints", "ref")
MOST_SKILLS = 64
MOST_NUMBER = 1e9
"""Of metres and of seconds: below it, ticks of 1 ms are exact."""


def looks_like_coalitions(data: Any) -> bool:
    """Whether this is meant to be a mission of this form."""
    return isinstance(data, dict) and "format" not in data and sum(key in data for key in NEEDED) >= 2


def read_coalitions(path: Path) -> CoalitionMission:
    """
    Read a file.

    Raises
    ------
    InputError
        If it cannot be read or is no such mission; says which field, what was found and what is accepted.
    """
    return coalitions_of(parse(load_text(path), str(path)))


def coalitions_of(parsed: Parsed) -> CoalitionMission:
    """
    The mission that plain data describes.

    Raises
    ------
    InputError
        As :func:`read_coalitions`.
    """
    data = parsed.data
    if not isinstance(data, dict):
        raise parsed.refusal(f"{found(data)} stands here", (), f"a mapping with {', '.join(NEEDED)}")
    for key in data:
        if key not in KEYS:
            raise parsed.refusal(f"{quoted(str(key))} is not known", (key,), ", ".join(KEYS), nearest(str(key), KEYS))
    for key in NEEDED:
        if key not in data:
            raise parsed.refusal(f"{key!r} is missing", (), f"a mapping with {', '.join(NEEDED)}")
    skills = _matrix(parsed, "Q", 1, MOST_COALITION_ROBOTS, "robots")
    needs = _matrix(parsed, "R", 2, MOST_TASKS + 2, "tasks, the start and the end included", len(data["Q"][0]))
    durations, places = _durations(parsed, len(needs)), _places(parsed, len(needs))
    for last in (0, len(needs) - 1):
        what = "the start" if last == 0 else "the end"
        if needs[last]:
            raise parsed.refusal(f"task {last} is {what} and needs a skill", ("R", last), "zeros alone")
        if durations[last]:
            raise parsed.refusal(f"task {last} is {what} and takes {durations[last]:g} s", ("T_e", last), "0")
    return CoalitionMission(
        skills=skills,
        tasks=tuple(
            CoalitionTask(needs=needs[task], duration_s=durations[task], x_m=places[task][0], y_m=places[task][1])
            for task in range(1, len(needs) - 1)
        ),
        start=places[0],
        end=places[-1],
        precedence=_precedence(parsed, len(needs)),
        reference_s=_reference(parsed),
    )


def _list(parsed: Parsed, path: tuple[str | int, ...], given: Any, accepted: str) -> list[Any]:
    if not isinstance(given, list):
        raise parsed.refusal(f"{found(given)} stands here", path, accepted)
    return given


def _matrix(
    parsed: Parsed, name: str, least: int, most: int, what: str, width: int | None = None
) -> tuple[tuple[int, ...], ...]:
    """Rows of zeros and ones, as the places of the ones."""
    rows = _list(parsed, (name,), parsed.data[name], "a list of rows of zeros and ones")
    if not least <= len(rows) <= most:
        raise parsed.refusal(f"there are {len(rows)} rows", (name,), f"{least} to {most} {what}")
    answer = []
    for number, row in enumerate(rows):
        cells = _list(parsed, (name, number), row, "a list of zeros and ones")
        width = len(cells) if width is None else width
        if len(cells) != width:
            message = f"the row has {len(cells)} entries, and there are {width} skills"
            raise parsed.refusal(message, (name, number), "an entry per skill, as many as in Q[0]")
        if not 1 <= width <= MOST_SKILLS:
            raise parsed.refusal(f"there are {width} skills", (name, number), f"1 to {MOST_SKILLS} skills")
        for skill, cell in enumerate(cells):
            if isinstance(cell, bool) or not isinstance(cell, int | float) or cell not in {0, 1}:
                raise parsed.refusal(f"{found(cell)} stands here", (name, number, skill), "0 or 1")
        answer.append(tuple(skill for skill, cell in enumerate(cells) if cell))
    return tuple(answer)


def _number(parsed: Parsed, path: tuple[str | int, ...], given: Any, low: float, what: str) -> float:
    if isinstance(given, bool) or not isinstance(given, int | float) or not low <= given <= MOST_NUMBER:
        raise parsed.refusal(f"{found(given)} stands here", path, f"a number of {what} from {low:g} to {MOST_NUMBER:g}")
    assert isfinite(given)
    return float(given)


def _per_task(parsed: Parsed, name: str, tasks: int) -> list[Any]:
    given = _list(parsed, (name,), parsed.data[name], "a list with an entry per task")
    if len(given) != tasks:
        message = f"the list has {len(given)} entries, and there are {tasks} tasks"
        raise parsed.refusal(message, (name,), "an entry per task, as many as rows in R")
    return given


def _durations(parsed: Parsed, tasks: int) -> list[float]:
    given = _per_task(parsed, "T_e", tasks)
    return [_number(parsed, ("T_e", task), each, 0, "seconds") for task, each in enumerate(given)]


def _places(parsed: Parsed, tasks: int) -> list[tuple[float, float]]:
    places = []
    for task, pair in enumerate(_per_task(parsed, "task_locations", tasks)):
        path = ("task_locations", task)
        if not isinstance(pair, list) or len(pair) != 2:
            raise parsed.refusal(f"{found(pair)} stands here", path, "[x, y] in metres")
        x, y = (_number(parsed, (*path, axis), each, -MOST_NUMBER, "metres") for axis, each in enumerate(pair))
        places.append((x, y))
    return places


def _precedence(parsed: Parsed, tasks: int) -> tuple[tuple[int, int], ...]:
    """Pairs of tasks, counted without the start; pairs with the start before or the end after say nothing."""
    name = "precedence_constraints"
    accepted = f"[before, after]: two different tasks from 1 to {tasks - 2}"
    pairs = []
    for number, pair in enumerate(_list(parsed, (name,), parsed.data.get(name, []), "a list of pairs of tasks")):
        path = (name, number)
        if not isinstance(pair, list) or len(pair) != 2 or any(type(task) is not int for task in pair):
            raise parsed.refusal(f"{found(pair)} stands here", path, accepted)
        before, after = pair
        if before == after or not (1 <= before <= tasks - 2 and 1 <= after <= tasks - 2):
            raise parsed.refusal(f"the pair [{before}, {after}] stands here", path, accepted)
        pairs.append((before - 1, after - 1))
    _refuse_circle(parsed, pairs, tasks - 2)
    return tuple(pairs)


def _refuse_circle(parsed: Parsed, pairs: list[tuple[int, int]], tasks: int) -> None:
    left = set(range(tasks))
    while free := {task for task in left if not any(after == task and before in left for before, after in pairs)}:
        left -= free
    if left:
        place = next(place for place, pair in enumerate(pairs) if left.issuperset(pair))
        shown = ", ".join(str(task + 1) for task in sorted(left)[:8])
        message = f"the precedence runs in a circle, so no order keeps it; in it, or after it, are the tasks {shown}"
        raise parsed.refusal(
            message, ("precedence_constraints", place), "an order that can be kept", "Remove a pair of these."
        )


def _reference(parsed: Parsed) -> float | None:
    given = parsed.data.get("ref")
    return None if given is None else _number(parsed, ("ref",), given, 0, "seconds")
