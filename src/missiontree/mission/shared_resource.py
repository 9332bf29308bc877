"""What robots share: a lift, a door, a charger, a narrow corridor, which only so many of them may hold at one time."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.value import Count, Id, Value


@dataclass(frozen=True, slots=True, kw_only=True)
class SharedResource(Value):
    """
    Something that robots hold while they do certain actions, and that has room for so many of them at a time.

    Parameters
    ----------
    id
        Name, unique among the shared resources of a scene. An entity or place of the same name is this resource, so that an
        argument of a routine may stand for it.
    capacity
        How many robots may hold it at one time, at least 1. A robot in one action counts 1. Default 1.
    label
        Name shown to people; default: the id.
    """

    id: Id
    capacity: Count = 1
    label: str = ""

    def _check(self) -> None:
        if not self.label:
            object.__setattr__(self, "label", self.id)
