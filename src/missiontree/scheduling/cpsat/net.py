"""The task graph as few precedences as possible: inner events that say nothing, or that only pass on, are left out."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.scheduling.precedence import TaskGraph


def precedences(graph: TaskGraph) -> Iterator[tuple[int, int]]:
    """
    Pairs of events, the first no later than the second, from which all such pairs of activities follow.

    An inner event with one event before it, or one after it, is skipped by joining the two sides; what no end of an activity leads to,
    or what leads to no activity, is dropped.
    """
    activities = 2 * len(graph.activities)
    after = [set(successors) for successors in graph.successors]
    before: list[set[int]] = [set() for _ in after]
    for event, successors in enumerate(after):
        for later in successors:
            before[later].add(event)
    queue = list(range(activities, len(after)))
    while queue:
        event = queue.pop()
        into, out = before[event], after[event]
        if min(len(into), len(out)) > 1 or not (into or out):
            continue
        for earlier in into:
            after[earlier].discard(event)
        for later in out:
            before[later].discard(event)
        for earlier in into:
            for later in out:
                after[earlier].add(later)
                before[later].add(earlier)
        queue += [one for one in (*into, *out) if one >= activities]
        after[event], before[event] = set(), set()
    for event, successors in enumerate(after):
        yield from (
            (event, later) for later in sorted(successors) if later != event + 1 or event % 2 or later >= activities
        )
