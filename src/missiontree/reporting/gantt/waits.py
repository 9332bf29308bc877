"""What a robot waits for that does nothing: held in a role, or with a way before it that has no room."""

from __future__ import annotations

from missiontree.reporting.critical.bonds import Bonds, Cause, Event
from missiontree.reporting.escape import one_line
from missiontree.reporting.gantt.time import exact

_TOLD = ("order", "entity", "resource", "partner", "under_way")


def why_waited(bonds: Bonds, leaf: int) -> str:
    """In a line, what binds the start of an action, or its end; empty if the schedule does not say."""
    causes = [*_binding(bonds, Event("start", leaf)), *_binding(bonds, Event("end", leaf))]
    told = [cause for cause in causes if cause.bond in _TOLD and not _idle_partner(bonds, cause)]
    cause = min(told, key=lambda cause: _TOLD.index(cause.bond), default=None)
    if cause is None and leaf in bonds.taker:
        return f"for {bonds.at[bonds.taker[leaf]].robot}, to hand over"
    if cause is None and bonds.released(Event("start", leaf)):
        return f"until it may start, at {exact(bonds.at[leaf].start_s)}"
    return "" if cause is None else _told(bonds, cause, Event("start", leaf))


def why_stayed(bonds: Bonds, leaf: int) -> str:
    """In a line, what keeps a robot from setting out for an action; empty if the schedule does not say."""
    departure = Event("departure", leaf)
    cause = next((cause for cause in _binding(bonds, departure) if cause.bond == "resource"), None)
    return "" if cause is None else _told(bonds, cause, departure)


def _binding(bonds: Bonds, event: Event) -> list[Cause]:
    time = bonds.time(event)
    return [cause for cause in bonds.causes(event) if bonds.time(cause.event) + cause.lag == time]


def _idle_partner(bonds: Bonds, cause: Cause) -> bool:
    """Whether a cause is a joint partner that starts then for no reason of its own."""
    if cause.bond != "partner":
        return False
    return all(deeper.bond == "partner" for deeper in _binding(bonds, cause.event))


def _told(bonds: Bonds, cause: Cause, event: Event) -> str:
    text, who = one_line(bonds.tree.action(cause.event.leaf).text), bonds.at[cause.event.leaf].robot
    if cause.bond == "partner":
        return f"for {who}, to do it together"
    if cause.bond == "resource":
        way = "on the way to: " if cause.event.kind == "departure" else ""
        return f"for {_shared(bonds, event, cause)}, which {who} holds: {way}{text}"
    if cause.bond == "under_way":
        return f"until {who} has begun: {text}"
    return f"for {who}: {text}"


def _shared(bonds: Bonds, event: Event, cause: Cause) -> str:
    """What two actions both hold, by its label."""
    theirs = cause.event if cause.event.kind == "departure" else Event("start", cause.event.leaf)
    held = {*bonds.holds(theirs)} & bonds.shared.keys()
    return " and ".join(one_line(bonds.shared[name].label) for name in bonds.holds(event) if name in held)
