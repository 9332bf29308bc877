"""Windows: nothing before it may start, nothing after it is due, and no robot before it comes or after it has left."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Leg, Recharge, ScheduledAction
from missiontree.rechecking.facts import TICK_MS, Facts, broken, milliseconds


def releases(facts: Facts) -> Iterator[Reason]:
    """No selected leaf below a node starts before the node's release."""
    for node in facts.selected:
        release = milliseconds(facts.tree.nodes[node].release_s)
        for leaf in facts.below(node) if release else ():
            if facts.start_ms[leaf] + TICK_MS < release:
                message = f"{facts.label(leaf)} starts at {facts.start_ms[leaf] / 1000} s, before {release / 1000} s."
                yield broken("core_release", message, node=leaf)


def deadlines(facts: Facts) -> Iterator[Reason]:
    """No selected leaf below a node ends after the node's deadline, and none after the mission's."""
    for node in facts.selected:
        dues = [facts.tree.nodes[node].deadline_s, facts.brief.deadline_s if node == 0 else None]
        for due in [milliseconds(due) for due in dues if due is not None]:
            for leaf in facts.below(node):
                if facts.end_ms[leaf] > due + TICK_MS:
                    message = (
                        f"{facts.label(leaf)} ends at {facts.end_ms[leaf] / 1000} s, and is due at {due / 1000} s."
                    )
                    yield broken("core_deadline", message, node=leaf)


def robots_are_there(facts: Facts) -> Iterator[Reason]:
    """No robot travels or acts before it takes part, or after that; its own times go before those of its type."""
    if facts.schedule is None:
        return
    busy: list[ScheduledAction | Leg | Recharge] = [
        *facts.schedule.actions,
        *facts.schedule.ways,
        *facts.schedule.recharges,
    ]
    for one in busy:
        kind, robot = facts.brief.fleet.type_of.get(one.robot), facts.brief.fleet.robots.get(one.robot)
        if kind is None or robot is None:
            continue
        comes_s = kind.available_from_s if robot.available_from_s is None else robot.available_from_s
        leaves_s = kind.available_until_s if robot.available_until_s is None else robot.available_until_s
        early = comes_s is not None and milliseconds(one.start_s) + TICK_MS < milliseconds(comes_s)
        late = leaves_s is not None and milliseconds(one.end_s) > milliseconds(leaves_s) + TICK_MS
        if early or late:
            message = f"{one.robot} is busy from {one.start_s} s to {one.end_s} s, and not there all the time."
            yield broken("core_available", message, robot=one.robot)


WINDOW_RULES = (releases, deadlines, robots_are_there)
