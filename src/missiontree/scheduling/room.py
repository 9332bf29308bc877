"""When there is room in a shared resource, given who holds it already."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

from missiontree.scheduling.precedence import TaskGraph, indegrees
from missiontree.scheduling.sharing import Sharing


class Hold(NamedTuple):
    """From when to when (ticks) so many robots hold a resource; None if nobody knows yet how long."""

    start: int
    end: int | None
    robots: int


def first_room(holds: Iterable[Hold], capacity: int, wanted: int, ready: int, length: int | None) -> int | None:
    """
    The first tick from which so many more robots find room for so long.

    Parameters
    ----------
    holds
        Who holds it.
    capacity, wanted
        How many robots may hold it, and how many more are to.
    ready
        Not before.
    length
        For how many ticks; None if nobody knows, so that there must be room from then on for good. What takes no time finds no
        room strictly inside what fills the resource.

    Returns
    -------
    int or None
        None if there is none as far as is known now.
    """
    taken = [hold for hold in holds if hold.end is None or hold.end >= ready]
    for start in sorted({ready, *(hold.end for hold in taken if hold.end is not None)}):
        end = None if length is None else start + length
        if peak([hold for hold in taken if _meet(hold, start, end)], start) + wanted <= capacity:
            return start
    return None


def peak(holds: Sequence[Hold], since: int) -> int:
    """The most robots that ever hold a resource at one time from a tick on."""
    most = 0
    for one in holds:
        moment = max(one.start, since)
        instant = one.end == moment
        among = 0
        for hold in holds:
            began = hold.start < moment or (hold.start == moment and not instant)
            lasts = hold.end is None or hold.end > moment
            if hold is one or (began and lasts):
                among += hold.robots
        most = max(most, among)
    return most


def _meet(hold: Hold, start: int, end: int | None) -> bool:
    return (hold.end is None or start < hold.end) and (end is None or hold.start < end)


def room_for(
    sharing: Sharing,
    wanted: Mapping[str, int],
    held: Callable[[str], Iterable[Hold]],
    ready: int,
    length: int | None,
) -> int | None:
    """The first tick at which so many robots find room in each of several resources; None if in something there is none as yet."""
    while wanted:
        start = ready
        for name, robots in wanted.items():
            found = first_room(held(name), sharing.capacity[name], robots, start, length)
            if found is None:
                return None
            start = found
        if start == ready:
            break
        ready = start
    return ready


def order_of_events(
    graph: TaskGraph,
    spans: Mapping[int, tuple[int, int]],
    after_end: Iterable[tuple[int, int]] = (),
    after_start: Iterable[tuple[int, int]] = (),
) -> dict[int, int]:
    """
    Which event comes before which, by times, and at one time by what must come first.

    Parameters
    ----------
    graph
        Activities and their order.
    spans
        Start and end of every activity.
    after_end, after_start
        Further pairs of activities: the second starts no sooner than the first has ended, or has started.

    Returns
    -------
    dict of int to int
        By event, its place; of unrelated ones at one time, ends come before starts. Events on a cycle are left out.
    """
    later = [list(after) for after in graph.successors]
    for first, second in after_end:
        later[2 * first + 1].append(2 * second)
    for first, second in after_start:
        later[2 * first].append(2 * second)
    times = [0] * len(later)
    for activity, (start, end) in spans.items():
        times[2 * activity], times[2 * activity + 1] = start, end
    missing, count = indegrees(later), 2 * len(graph.activities)
    ready = [(times[event], event < count and event % 2 == 0, event) for event, left in enumerate(missing) if not left]
    heapq.heapify(ready)
    order: dict[int, int] = {}
    while ready:
        time, _, event = heapq.heappop(ready)
        order[event] = len(order)
        for after in later[event]:
            missing[after] -= 1
            if after >= count:  # what only ties others together is when the last of those before it is
                times[after] = max(times[after], time)
            if not missing[after]:
                heapq.heappush(ready, (max(times[after], time), after < count and after % 2 == 0, after))
    return order


def turns(sharing: Sharing, spans: Mapping[int, tuple[int, int]], order: Mapping[int, int]) -> list[tuple[int, int]]:
    """
    Who waits for whom at shared resources, so that the same order is kept whatever the times: pairs of activities, the second starts no
    sooner than the first has ended.

    Each place in a resource is passed on from one holder to the next (interval colouring), in order of the starts. At one moment a place
    goes rather to whom order lets come after the end of who had it: an action that lasts until another ends has its place until then. If
    no other place is free, and order says so for a reason, nobody can keep to the pair.

    Parameters
    ----------
    sharing
        Who holds what.
    spans
        Start and end of every activity.
    order
        The order of events, see :func:`order_of_events`.
    """
    pairs: dict[tuple[int, int], None] = {}
    for name, capacity in sharing.capacity.items():
        holders = sharing.holders(name)
        places: list[tuple[int, int]] = [(0, -1)] * capacity  # from when each is free, and who was there last
        for activity in sorted(holders, key=lambda one: (*spans[one], order.get(2 * one, 0))):
            start, end = spans[activity]

            def early(place: tuple[int, int], start: int = start, begins: int = order.get(2 * activity, 0)) -> bool:
                """Whether whoever has the place gives it up just then, and only after this has begun."""
                return place[0] == start and order.get(2 * place[1] + 1, -1) > begins

            places.sort(key=lambda place, start=start: (max(0, place[0] - start), early(place), -place[0], place[1]))  # type: ignore[misc]
            for number in range(min(capacity, holders[activity])):
                if places[number][1] >= 0:
                    pairs[places[number][1], activity] = None
                places[number] = (end, activity)
    return list(pairs)
