"""Links behind a cause: what is lacking may be told of the only robots that a link leaves, and then the link belongs to the cause."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from missiontree.explaining.causes.unable import ABOUT_ROBOTS
from missiontree.mission.explanation import Cause, Repair
from missiontree.mission.reason import Reason
from missiontree.mission.tree import MissionTree


def with_links(causes: Sequence[Cause], repairs: Sequence[Repair], tree: MissionTree) -> tuple[Cause, ...]:
    """
    The causes, each with the links without which the mission can be done, if no cause speaks of them.

    Parameters
    ----------
    causes
        What stands in the way.
    repairs
        What would make the mission possible. That giving up one link does, with nothing else changed, shows that the link has part in it.
    tree
        The mission as it stands.
    """
    said = " ".join([text for cause in causes for text in (cause.words, *(reason.message for reason in cause.reasons))])
    behind = tuple(
        reason for reason in _links(repairs, tree) if reason.message not in said and not _named(reason, said)
    )
    return tuple(replace(cause, reasons=(*cause.reasons, *behind)) for cause in causes) if behind else tuple(causes)


def _links(repairs: Sequence[Repair], tree: MissionTree) -> Iterator[Reason]:
    for repair in repairs:
        change = repair.changes[0]
        if len(repair.changes) > 1 or change.kind != "drop_link":
            continue
        ends = tree.by_id[change.target].label, tree.by_id[change.name].label
        kinds = {link.kind for link in tree.links if (link.first, link.second) == (change.target, change.name)}
        for kind in ABOUT_ROBOTS:
            if kind in kinds:
                who = "one robot does both" if kind == "same_robot" else "different robots do"
                yield Reason(
                    rule=f"{kind}_binds",
                    message=f'The mission asks that {who} "{ends[0]}" and "{ends[1]}"; without that it can be done.',
                    node=change.target,
                    found=ends[0],
                    needed=ends[1],
                )


def _named(reason: Reason, said: str) -> bool:
    """Whether a cause names both ends of a link already, and says that it is about robots."""
    return f'"{reason.found}"' in said and f'"{reason.needed}"' in said and "robot" in said
