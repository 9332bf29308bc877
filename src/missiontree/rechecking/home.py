"""Ways home: where the mission asks for it, each robot that did something goes back to where it started."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.reason import Reason
from missiontree.mission.schedule import OwnLeg
from missiontree.rechecking.facts import TICK_MS, Facts, broken, milliseconds
from missiontree.rechecking.own_ways import leads
from missiontree.rechecking.places import apart, start_of
from missiontree.rechecking.walks import walk

RULE = "core_home"


def everybody_comes_home(facts: Facts) -> Iterator[Reason]:
    """Who did something is at its start in the end, by one way home if it was elsewhere; nobody else goes home."""
    legs: dict[str, list[OwnLeg]] = {}
    for leg in facts.schedule.returns if facts.schedule is not None else ():
        legs.setdefault(leg.robot, []).append(leg)
    busy = facts.roles_of_robot if facts.brief.return_home else {}
    for robot, several in legs.items():
        if robot not in busy or len(several) > 1:
            yield broken(RULE, f"{robot} goes home {len(several)} times, and is not to.", robot=robot)
    for robot in busy:
        *_, (_, here, free_ms) = walk(facts, robot)
        home = start_of(facts, robot)
        if robot in legs:
            yield from leads(facts, legs[robot][0], RULE, (here, home), free_ms)
        elif apart(here, (home,)):
            yield broken(RULE, f"{robot} does not go home.", robot=robot)


def home_in_time(facts: Facts) -> Iterator[Reason]:
    """Nobody is home after the mission is due."""
    due_s = facts.brief.deadline_s
    for leg in facts.schedule.returns if facts.schedule is not None and due_s is not None else ():
        if milliseconds(leg.end_s) > milliseconds(due_s or 0.0) + TICK_MS:
            yield broken(RULE, f"{leg.robot} is home at {leg.end_s} s, and due at {due_s} s.", robot=leg.robot)


HOME_RULES = (everybody_comes_home, home_in_time)
