"""Whether there are robots enough for the roles of a branch that need different robots."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.mission.fleet import Fleet
from missiontree.mission.reason import Reason
from missiontree.routines.compose import FlatBranch


def shortage(branch: FlatBranch, types: Sequence[Sequence[str]], fleet: Fleet, task: str) -> Reason | None:
    """
    Why the robots are too few, or None if each team of the branch can be filled by different robots.

    A bipartite matching by augmenting paths (M. Hall, 1956; as in Kuhn's Hungarian method): where it gets stuck, the types
    reached are all that the roles reached could ever use.

    Parameters
    ----------
    branch
        The roles and their teams.
    types
        For each role, the types able to fill it.
    fleet
        How many robots each type has.
    task
        Name of the work in messages.
    """
    teams = dict.fromkeys(role.team for role in branch.roles if role.team is not None)
    for team in teams:
        slots = [index for index, role in enumerate(branch.roles) if role.team == team for _ in range(role.robots)]
        filled: dict[str, list[int]] = {}
        for slot in slots:
            stuck = _fill(slot, types, fleet, filled)
            if stuck is not None:
                return _too_few(stuck, sum(len(filled.get(name, ())) for name in stuck) + 1, fleet, task)
    return None


def _fill(slot: int, types: Sequence[Sequence[str]], fleet: Fleet, filled: dict[str, list[int]]) -> list[str] | None:
    """Give the slot a robot, moving others to other types where needed; else return the types that are all in use."""
    came_from: dict[str, tuple[int, str | None]] = dict.fromkeys(types[slot], (slot, None))
    queue = list(came_from)
    for name in queue:  # grows while it is walked: breadth first
        held = filled.setdefault(name, [])
        if len(held) < fleet.by_id[name].usable:
            _shift(name, came_from, filled)
            return None
        for role in dict.fromkeys(held):
            for other in types[role]:
                if other not in came_from:
                    came_from[other] = (role, name)
                    queue.append(other)
    return queue


def _shift(name: str, came_from: dict[str, tuple[int, str | None]], filled: dict[str, list[int]]) -> None:
    role, before = came_from[name]
    filled[name].append(role)
    while before is not None:
        filled[before].remove(role)
        role, earlier = came_from[before]
        filled[before].append(role)
        before = earlier


def _too_few(stuck: Sequence[str], needed: int, fleet: Fleet, task: str) -> Reason:
    counts = [f"{fleet.by_id[name].label} {fleet.by_id[name].usable}" for name in stuck]
    return Reason(
        rule="too_few_robots",
        message=f"{task} needs {needed} different robots, and those able are too few: {', '.join(counts)}.",
        robot=stuck[0] if len(stuck) == 1 else "",
        found=", ".join(counts),
        needed=f"{needed} robots",
    )
