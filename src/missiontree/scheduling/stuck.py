"""The end of a run that cannot go on."""

from __future__ import annotations

from missiontree.mission.reason import Reason


class StuckError(Exception):
    """A run cannot go on; it carries the Reason."""

    def __init__(self, reason: Reason) -> None:
        super().__init__(reason.message)
        self.reason = reason
