"""What a robot does one after the other, and where it is in between."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from missiontree.mission.schedule import Recharge
from missiontree.rechecking.facts import Facts, Places, milliseconds
from missiontree.rechecking.places import reached, start_of

Step = int | Recharge
"""An action, as its leaf, or a visit to a charger."""


def steps(facts: Facts, robot: str) -> list[Step]:
    """What a robot does, in the order of its roles, and its visits to chargers in between, in order of time."""
    visits = facts.schedule.recharges if facts.schedule is not None else ()
    own = sorted((one for one in visits if one.robot == robot), key=lambda one: (one.start_s, one.end_s))
    found = list[Step]()
    for leaf in [leaf for role in facts.roles_of_robot.get(robot, ()) for leaf in facts.leaves_of_role[role]]:
        while own and milliseconds(own[0].start_s) < facts.start_ms[leaf]:
            found.append(own.pop(0))
        found.append(leaf)
    return [*found, *own]


class Stand(NamedTuple):
    """Where a robot may be before a step, None if unknown, and from when it is free; ``step`` is None after the last."""

    step: Step | None
    here: Places
    free_ms: int


def walk(facts: Facts, robot: str) -> Iterator[Stand]:
    """Where a robot is before each of its steps, and after the last."""
    here: Places = (start_of(facts, robot),)
    free_ms = 0
    for step in steps(facts, robot):
        yield Stand(step, here, free_ms)
        if isinstance(step, Recharge):
            here, free_ms = (facts.world.charger_spots.get(step.charger),), max(free_ms, milliseconds(step.end_s))
            continue
        action = facts.leaves[step]
        if action.at is not None or action.moves:
            here = reached(facts, step)
        free_ms = max(free_ms, facts.end_ms[step])
    yield Stand(None, here, free_ms)
