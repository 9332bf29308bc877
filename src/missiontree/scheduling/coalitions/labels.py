"""
Beginnings of schedules, layer by layer: those that a task more makes out of those before, without any that another one outdoes.

Every schedule can be told task by task in the order of starts, each as early as possible. A beginning outdoes another if the same tasks
are done and the robots are at the same places no later, and no task that is still to come has to wait longer for what is done. A beginning
that cannot end before the best schedule known is left out, too. As long as no layer is cut, what is found in the end is the least makespan
there is (dynamic programming with dominance, Held and Karp 1962); where one is cut, the least bound of what was cut off bounds it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from missiontree.mission.coalitions import CoalitionMission
from missiontree.scheduling.coalitions.bounds import Outlook


@dataclass(frozen=True, slots=True)
class Label:
    """
    A beginning.

    Parameters
    ----------
    done
        Tasks done, as a mask of bits.
    places, free
        Where each robot is, and since when.
    ready
        Of each task, when those before it have ended, as far as they are done; 0 for tasks done.
    task, members, began
        The last task told, by whom and from when.
    before
        The beginning that this one continues.
    bound
        No completion ends before.
    """

    done: int
    places: tuple[int, ...]
    free: tuple[int, ...]
    ready: tuple[int, ...]
    task: int
    members: tuple[int, ...]
    began: int
    before: Label | None
    bound: int


@dataclass(frozen=True, slots=True)
class Search:
    """
    What one walk through the layers came to.

    Parameters
    ----------
    best
        The last label of the best schedule; None if none is better than what was known.
    makespan
        Its makespan, or what was known.
    bound
        No schedule is shorter.
    finished
        Whether the walk came to its end.
    """

    best: Label | None
    makespan: int
    bound: int
    finished: bool


def search(mission: CoalitionMission, outlook: Outlook, upper: int, width: int, ended: Callable[[], bool]) -> Search:
    """
    Walk through the layers.

    Parameters
    ----------
    mission, outlook
        The mission, and bounds on what is to come.
    upper
        Only makespans below are looked for.
    width
        How many labels a layer may have.
    ended
        Whether to stop.
    """
    tasks, robots = len(mission.tasks), len(mission.skills)
    start, end = tasks, tasks + 1
    awaited = [0] * tasks
    followers: list[list[int]] = [[] for _ in range(tasks)]
    for first, second in mission.precedence:
        awaited[second] |= 1 << first
        followers[first].append(second)
    nothing = (0,) * tasks
    first_label = Label(0, (start,) * robots, (0,) * robots, nothing, -1, (), 0, None, 0)
    layer, cut = [first_label], upper
    looked = 0
    for _ in range(tasks):
        kept: dict[tuple[int, tuple[int, ...]], list[Label]] = {}
        for label in layer:
            looked += 1
            if looked % 64 == 0 and ended():
                return Search(None, upper, 0, False)
            for task in range(tasks):
                if label.done >> task & 1 or awaited[task] & ~label.done:
                    continue
                for members in mission.coalitions[task]:
                    label_next = _continued(mission, outlook, label, task, members, followers[task])
                    if label_next.bound < upper:
                        _keep(kept, label_next)
        layer = [label for labels in kept.values() for label in labels]
        if len(layer) > width:
            layer.sort(key=lambda label: (label.bound, sum(label.free)))
            cut = min(cut, layer[width].bound)
            layer = layer[:width]
    best, makespan = None, upper
    for label in layer:
        finish = max(free + mission.travel[place][end] for place, free in zip(label.places, label.free, strict=True))
        if finish < makespan:
            best, makespan = label, finish
    return Search(best, makespan, min(cut, makespan), True)


def _continued(
    mission: CoalitionMission, outlook: Outlook, label: Label, task: int, members: tuple[int, ...], followers: list[int]
) -> Label:
    began = label.ready[task]
    for robot in members:
        began = max(began, label.free[robot] + mission.travel[label.places[robot]][task])
    over = began + mission.lengths[task]
    places, free, ready = list(label.places), list(label.free), list(label.ready)
    for robot in members:
        places[robot], free[robot] = task, over
    ready[task] = 0
    for other in followers:
        ready[other] = max(ready[other], over)
    done = label.done | 1 << task
    bound = max(label.bound, outlook.bound(done, places, free, ready))
    return Label(done, tuple(places), tuple(free), tuple(ready), task, members, began, label, bound)


def _keep(kept: dict[tuple[int, tuple[int, ...]], list[Label]], label: Label) -> None:
    """Keep a label unless another one outdoes it, and only those that it does not outdo."""
    labels = kept.setdefault((label.done, label.places), [])
    if any(_outdoes(other, label) for other in labels):
        return
    labels[:] = [other for other in labels if not _outdoes(label, other)]
    labels.append(label)


def _outdoes(one: Label, other: Label) -> bool:
    return all(map(int.__le__, one.free, other.free)) and all(map(int.__le__, one.ready, other.ready))
