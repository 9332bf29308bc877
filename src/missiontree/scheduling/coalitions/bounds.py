"""What is still to come at least, whatever is decided."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.mission.coalitions import CoalitionMission


@dataclass(frozen=True)
class Outlook:
    """
    Bounds on the end of the mission, from what is done, where robots are, and when they are free.

    Parameters
    ----------
    mission
        The mission.
    visit
        Of each task, its ticks and the least way to it.
    home
        Of each task, the ticks from it to the end.
    sure
        For each robot, the tasks (as a mask of bits) that cannot be done without it.
    groups
        Sets of robots; of each, the fewest of them that each task takes.
    chain
        Of each task, the longest sequence of tasks that must follow each other from its start on, to the end of the mission.
    """

    mission: CoalitionMission
    visit: list[int]
    home: list[int]
    sure: list[list[int]]
    least: list[int]
    chain: list[int]

    def bound(self, done: int, places: Sequence[int], free: Sequence[int], ready: Sequence[int]) -> int:
        """
        No completion of this beginning ends before.

        Parameters
        ----------
        done
            Tasks done, as a mask of bits.
        places, free
            Where each robot is, and since when.
        ready
            Of each task, when those before it have ended, as far as they are done.
        """
        travel, end = self.mission.travel, len(self.mission.tasks) + 1
        latest, together = 0, 0
        for robot, tasks in enumerate(self.sure):
            place = places[robot]
            work, nearest, last, least_home = 0, -1, 0, -1
            for task in tasks:
                if done >> task & 1:
                    continue
                work += self.visit[task]
                last = max(last, free[robot] + travel[place][task] + self.chain[task], ready[task] + self.chain[task])
                way = self.home[task]
                least_home = way if least_home < 0 else min(least_home, way)
                nearest = travel[place][task] if nearest < 0 else min(nearest, travel[place][task])
            latest = max(latest, last, free[robot] + (work + least_home if work else travel[place][end]))
            together += free[robot]
        for task, least in enumerate(self.least):
            if not done >> task & 1:
                together += least * self.visit[task]
                latest = max(latest, ready[task] + self.chain[task])
        return max(latest, -(-together // len(places)))


def outlook_of(mission: CoalitionMission) -> Outlook:
    """What can be known before anything is decided."""
    tasks = range(len(mission.tasks))
    start, end = len(mission.tasks), len(mission.tasks) + 1
    way_in = [
        min([mission.travel[other][task] for other in tasks if other != task] + [mission.travel[start][task]])
        for task in tasks
    ]
    visit = [mission.lengths[task] + way_in[task] for task in tasks]
    home = [mission.travel[task][end] for task in tasks]
    sure = [
        [task for task in tasks if all(robot in members for members in mission.coalitions[task])]
        for robot in range(len(mission.skills))
    ]
    least = [min((len(members) for members in mission.coalitions[task]), default=0) for task in tasks]
    after: dict[int, list[int]] = {}
    for first, second in mission.precedence:
        after.setdefault(first, []).append(second)
    chain = [0] * len(mission.tasks)
    for task in reversed(in_order(mission)):
        follow = [chain[other] for other in after.get(task, ())]
        chain[task] = mission.lengths[task] + max([home[task], *follow])
    return Outlook(mission, visit, home, sure, least, chain)


def in_order(mission: CoalitionMission) -> list[int]:
    """Tasks, each after all that it must wait for; fewer than there are if precedence runs in a circle."""
    waiting = [0] * len(mission.tasks)
    for _, second in mission.precedence:
        waiting[second] += 1
    found = [task for task, count in enumerate(waiting) if not count]
    for task in found:  # grows as it is walked
        for first, second in mission.precedence:
            if first == task:
                waiting[second] -= 1
                if not waiting[second]:
                    found.append(second)
    return found
