"""
Fields that are planned and that no stage enforces yet. A file that has one is refused: a rule that is accepted and then ignored
would make a plan look better than it is.
"""

from __future__ import annotations

DEADLINES = "deadlines and release times of entities and of single actions"
WINDOWS = "time windows"
SHARED = "capacities of roads, lifts, zones and entities"
COMMANDS = "commands to real robots and what they report back"
GATES = "optional tasks, rewards and gates other than 'and' and 'xor'"

_WINDOWS = {"windows": WINDOWS, "window": WINDOWS}
_TIMES = {"deadline_s": DEADLINES, "release_s": DEADLINES, **_WINDOWS}
_CAPACITY = {"capacity": SHARED}

FIELDS: dict[str, dict[str, str]] = {
    "Entity": {**_TIMES, **_CAPACITY},
    "Lift": _CAPACITY,
    "Road": _CAPACITY,
    "Zone": _CAPACITY,
    "RoadNode": _CAPACITY,
    "ActionStep": {**_TIMES, "command": COMMANDS, "results": COMMANDS},
    "Action": {**_TIMES, "command": COMMANDS, "results": COMMANDS},
    "MissionNode": {**_WINDOWS, "k": GATES, "optional": GATES, "reward": GATES},
    "GroundedNode": {**_WINDOWS, "k": GATES, "optional": GATES, "reward": GATES},
    "MissionFile": _WINDOWS,
    "Goal": _WINDOWS,
}
"""Class name to field to the rule it belongs to."""

GATE_WORDS = ("k_of_n", "or", "optional", "sum", "max", "min")
"""Gates that a later version may have."""


def planned_field(class_name: str, name: str) -> str | None:
    """The rule that a field of a value will belong to; None if no such field is planned."""
    return FIELDS.get(class_name, {}).get(name)


def planned_word(class_name: str, name: str, found: object) -> str | None:
    """The rule that a word found in a field will belong to; None if no such word is planned."""
    if class_name == "MissionNode" and name == "gate" and found in GATE_WORDS:
        return GATES
    return None
