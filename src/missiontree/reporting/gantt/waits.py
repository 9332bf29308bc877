"""What a robot waits for that is held and does nothing."""

from __future__ import annotations

from missiontree.reporting.critical.bonds import Bonds, Cause, Event
from missiontree.reporting.escape import one_line
from missiontree.reporting.gantt.time import exact

_TOLD = ("order", "entity", "resource", "partner", "under_way")


def why_waited(bonds: Bonds, leaf: int) -> str:
    """In a line, what binds the start of an action, or its end; empty if the schedule does not say."""
    causes = [*_binding(bonds, Event("start", leaf)), *_binding(bonds, Event("end", leaf))]
    if leaf in bonds.legs:
        causes += _binding(bonds, Event("departure", leaf))
    told = [cause for cause in causes if cause.bond in _TOLD and not _idle_partner(bonds, cause)]
    cause = min(told, key=lambda cause: _TOLD.index(cause.bond), default=None)
    if cause is None and leaf in bonds.taker:
        return f"for {bonds.at[bonds.taker[leaf]].robot}, to hand over"
    if cause is None and bonds.released(Event("start", leaf)):
        return f"until it may start, at {exact(bonds.at[leaf].start_s)}"
    return "" if cause is None else _told(bonds, cause, leaf)


def _binding(bonds: Bonds, event: Event) -> list[Cause]:
    time = bonds.time(event)
    return [cause for cause in bonds.causes(event) if bonds.time(cause.event) + cause.lag == time]


def _idle_partner(bonds: Bonds, cause: Cause) -> bool:
    """Whether a cause is a joint partner that starts then for no reason of its own."""
    if cause.bond != "partner":
        return False
    return all(deeper.bond == "partner" for deeper in _binding(bonds, cause.event))


def _told(bonds: Bonds, cause: Cause, leaf: int) -> str:
    text, who = one_line(bonds.tree.action(cause.event.leaf).text), bonds.at[cause.event.leaf].robot
    if cause.bond == "partner":
        return f"for {who}, to do it together"
    if cause.bond == "resource":
        return f"for {_shared(bonds, leaf, cause)}, which {who} holds: {text}"
    if cause.bond == "under_way":
        return f"until {who} has begun: {text}"
    return f"for {who}: {text}"


def _shared(bonds: Bonds, leaf: int, cause: Cause) -> str:
    """What two actions both hold, by its label."""
    theirs = cause.event if cause.event.kind == "departure" else Event("start", cause.event.leaf)
    held = {*bonds.holds(theirs)} & bonds.shared.keys()
    own = dict.fromkeys((*bonds.holds(Event("start", leaf)), *bonds.holds(Event("departure", leaf))))
    return " and ".join(one_line(bonds.shared[name].label) for name in own if name in held)
