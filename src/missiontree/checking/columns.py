"""Whether a schedule of a tree in columns keeps its rules. A few passes over the columns, so that it is quick for large trees."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.fault import Fault
from missiontree.checking.instance_claims import claim_faults
from missiontree.mission.columns import AND, LEAF, XOR, TreeColumns
from missiontree.mission.tree_schedule import TreeSchedule


def check_tree(columns: TreeColumns, schedule: TreeSchedule) -> tuple[Fault, ...]:
    """
    Every fault of a schedule; none for one that nothing was scheduled in.

    Selection (exactly one child of a reached XOR, every child of a reached AND, no other action), one action at a time for each
    robot, durations, precedence over node ends, the makespan, and a bound that is not above it.
    """
    if schedule.status in {"infeasible", "unknown"}:
        return tuple(_nothing_scheduled(schedule))
    selected, faults = _selected(columns, schedule)
    faults += _times(columns, schedule, selected)
    if faults:
        return tuple(faults)  # the other rules take every selected action to have a time
    faults += _robots(columns, schedule)
    faults += _precedence(columns, schedule, selected)
    faults += _claims(columns, schedule)
    return tuple(faults)


def _nothing_scheduled(schedule: TreeSchedule) -> Iterator[Fault]:
    if schedule.start_s or schedule.chosen or schedule.makespan_s:
        yield Fault(f"the status is {schedule.status}, and yet something is scheduled.")


def _selected(columns: TreeColumns, schedule: TreeSchedule) -> tuple[list[bool], list[Fault]]:
    """Nodes that are selected by the choices, parents before children."""
    nodes = len(columns.kind)
    selected, faults, open_gates = [False] * nodes, list[Fault](), set[int]()
    for node in range(nodes):
        above = columns.parent[node]
        if above < 0:
            selected[node] = True
        elif selected[above]:
            selected[node] = columns.kind[above] == AND or schedule.chosen.get(above) == node
            if selected[node]:
                open_gates.discard(above)
        if selected[node] and columns.kind[node] == XOR:
            open_gates.add(node)
    for node in sorted(open_gates):
        found = str(schedule.chosen.get(node, "none"))
        faults.append(
            Fault(f"{columns.label(node)} is reached, and no child of it is taken.", columns.label(node), found=found)
        )
    for node in schedule.chosen:
        if not (0 <= node < nodes and columns.kind[node] == XOR and selected[node]):
            faults.append(Fault(f"a child is taken at node {node}, which is no XOR that is reached."))
    return selected, faults


def _times(columns: TreeColumns, schedule: TreeSchedule, selected: list[bool]) -> list[Fault]:
    """Every selected action, and no other, has a start and a robot."""
    faults = []
    for node, kind in enumerate(columns.kind):
        if kind == LEAF and selected[node] != (node in schedule.start_s and node in schedule.robot):
            state = "selected and has no time" if selected[node] else "not selected and has a time"
            faults.append(Fault(f"{columns.label(node)} is {state}.", columns.label(node)))
    for node, start in schedule.start_s.items():
        if not (0 <= node < len(columns.kind) and columns.kind[node] == LEAF):
            faults.append(Fault(f"node {node} has a time, and is no action."))
        elif start < 0:
            faults.append(Fault(f"{columns.label(node)} starts at {start}, before the mission.", columns.label(node)))
    return faults


def _robots(columns: TreeColumns, schedule: TreeSchedule) -> Iterator[Fault]:
    """Nobody does two things at once, and nobody is one robot too many."""
    spans: dict[tuple[int, int], list[tuple[int, int, int]]] = {}
    for leaf, start in schedule.start_s.items():
        kind, which = columns.robot[leaf], schedule.robot[leaf]
        there = 1 if columns.count is None else columns.count[kind]
        if not 0 <= which < there:
            yield Fault(
                f"{columns.label(leaf)} is done by robot {which} of {columns.robot_id(kind)}, of which there are {there}."
            )
        if columns.duration[leaf]:
            spans.setdefault((kind, which), []).append((start, start + columns.duration[leaf], leaf))
    for (kind, which), busy in spans.items():
        busy.sort()
        until, doing = -1, -1
        for start, end, leaf in busy:
            if start < until:
                yield Fault(
                    f"{columns.label(leaf)} starts at {start} s, while robot {which} of {columns.robot_id(kind)} does "
                    f"{columns.label(doing)} until {until} s.",
                    columns.label(leaf),
                    columns.robot_id(kind),
                    f"{start} s",
                    f"at least {until} s",
                )
            if end > until:
                until, doing = end, leaf


def _precedence(columns: TreeColumns, schedule: TreeSchedule, selected: list[bool]) -> Iterator[Fault]:
    """A node starts with its first selected action and ends with its last."""
    nodes = len(columns.kind)
    first: list[int | None] = [None] * nodes
    last = [0] * nodes
    for node in range(nodes - 1, -1, -1):
        if not selected[node]:
            continue
        if columns.kind[node] == LEAF:
            first[node] = schedule.start_s[node]
            last[node] = schedule.start_s[node] + columns.duration[node]
        above, start = columns.parent[node], first[node]
        if above >= 0 and start is not None:
            so_far = first[above]
            first[above] = start if so_far is None else min(so_far, start)
            last[above] = max(last[above], last[node])
    for before, after in columns.precedence:
        start = first[after]
        if selected[before] and selected[after] and start is not None and start < last[before]:
            yield Fault(
                f"{columns.label(after)} starts at {start} s, before {columns.label(before)} ends at {last[before]} s.",
                columns.label(after),
                found=f"{start} s",
                needed=f"at least {last[before]} s",
            )


def _claims(columns: TreeColumns, schedule: TreeSchedule) -> Iterator[Fault]:
    """The makespan is the last end, and no bound lies above it."""
    end = max((start + columns.duration[leaf] for leaf, start in schedule.start_s.items()), default=0)
    if end != schedule.makespan_s:
        yield Fault(
            "the makespan is not the end of the last action.", found=f"{schedule.makespan_s} s", needed=f"{end} s"
        )
    bound = schedule.certificate.bound
    if bound is not None and bound > end:
        yield Fault("the bound lies above the makespan.", found=f"{bound:g} s", needed=f"at most {end} s")
    if schedule.status == "optimal" and bound != end:
        yield Fault("the schedule is called optimal, and its bound is another.", found=f"{bound} s", needed=f"{end} s")
    yield from claim_faults(schedule.status, schedule.certificate)
