"""
The family of exceptions. An outcome that a user must expect (cannot be done, time limit, incomplete) is a value, never one of these.

::

    MissiontreeError
    ├── InputError              a file or an argument is not what it should be: says where, what was found, what is accepted
    │   └── NotEnforcedError    a field whose rule no stage keeps yet: refused, never accepted and ignored
    └── InternalError           missiontree broke a promise of its own; worth a report
"""

from __future__ import annotations

from dataclasses import dataclass


class MissiontreeError(Exception):
    """Everything that missiontree raises on purpose."""


@dataclass
class InputError(MissiontreeError):
    """
    Bad input. Maps to exit code 2.

    Parameters
    ----------
    message
        What was found, in words.
    file
        The file it was found in; empty for an argument.
    line
        Line in that file, from 1; 0 if it has none.
    where
        The field, written as a path: ``types[0].limits.max_speed_mps``.
    accepted
        What would be accepted instead.
    hint
        What to do, such as the nearest match of a misspelt word.
    """

    message: str
    file: str = ""
    line: int = 0
    where: str = ""
    accepted: str = ""
    hint: str = ""

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}" if self.file and self.line else self.file
        head = ": ".join(part for part in (place, self.where, self.message) if part)
        tail = [f"accepted: {self.accepted}"] if self.accepted else []
        return "\n  ".join([head, *tail, *([self.hint] if self.hint else [])])


class NotEnforcedError(InputError):
    """A field that is planned but that no stage enforces yet."""


class InternalError(MissiontreeError):
    """A promise of missiontree's own was broken. Maps to exit code 70."""
