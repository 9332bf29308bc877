"""What an alternative uses of its limits, a line per budget: ``energy_j: rover-1 3,000 of 4,000, the whole mission 6,500 of 7,000``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from missiontree.reporting.team.limits import LimitUse

MOST_NAMES = 6
MOST_HOLDERS = 6


def limit_lines(limits: Sequence[LimitUse]) -> Iterator[str]:
    """Budgets in order, each with those that have used most of theirs."""
    names = list(dict.fromkeys(limit.name for limit in limits))
    for name in names[:MOST_NAMES]:
        holders = [limit for limit in limits if limit.name == name]
        tightest = sorted(holders, key=lambda limit: -limit.share)[:MOST_HOLDERS]
        told = [_of(limit) for limit in holders if limit in tightest]
        more = len(holders) - len(tightest)
        yield f"{name}: {', '.join(told)}{f', and {more} that have used less' if more else ''}"
    if len(names) > MOST_NAMES:
        yield f"… and {len(names) - MOST_NAMES} more; --json lists them all"


def _of(limit: LimitUse) -> str:
    lead = "at least " if limit.at_least else ""
    refilled = f" ({limit.refilled:,.6g} of them refilled)" if limit.refilled else ""
    return f"{limit.who} {lead}{limit.used:,.6g} of {limit.allowed:,.6g}{refilled}"
