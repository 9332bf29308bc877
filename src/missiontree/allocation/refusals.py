"""Why candidates were refused, counted: one reason per rule, type and budget instead of one per candidate."""

from __future__ import annotations

from dataclasses import replace

from missiontree.mission.reason import Reason, Severity

Kind = tuple[str, str, str]


class Refusals:
    """Collects the reasons of refused candidates."""

    def __init__(self) -> None:
        self._count: dict[Kind, int] = {}
        self._first: dict[Kind, Reason] = {}

    def add(self, reason: Reason | None) -> None:
        """Count one refusal."""
        if reason is None:
            return
        kind = (reason.rule, reason.robot, reason.needed.partition(" ")[0])
        self._count[kind] = self._count.get(kind, 0) + 1
        self._first.setdefault(kind, reason)

    def summary(self, severity: Severity) -> tuple[Reason, ...]:
        """The most frequent first; each tells the best candidate that it refused."""
        kinds = sorted(self._count, key=lambda kind: (-self._count[kind], kind))
        return tuple(
            replace(
                self._first[kind],
                message=f"{_candidates(self._count[kind])} refused. The best of them: {self._first[kind].message}",
                severity=severity,
            )
            for kind in kinds
        )


def _candidates(count: int) -> str:
    return "1 candidate was" if count == 1 else f"{count} candidates were"
