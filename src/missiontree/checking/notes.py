"""Does the plan say all that was taken for granted, changed and warned of?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault, named
from missiontree.checking.journeys import NEAR_M, journeys
from missiontree.checking.provenance import GIVEN
from missiontree.checking.timetable import Timetable
from missiontree.checking.travel import least_gap


def note_dropped(case: Case) -> Iterator[Fault]:
    """An assumption, a notice or a finding of grounding, or an assumption of a schedule, does not stand in the plan's own list."""
    plan, grounding = case.plan, case.plan.grounding
    scheduled = [reason for schedule in plan.schedules for reason in schedule.assumptions]
    lists = (
        ("assumptions", plan.assumptions, [*(grounding.assumptions if grounding else ()), *scheduled]),
        ("notices", plan.notices, grounding.notices if grounding else ()),
        ("findings", plan.findings, grounding.findings if grounding else ()),
    )
    for what, said, needed in lists:
        dropped = [reason for reason in dict.fromkeys(needed) if reason not in said]
        if dropped:
            yield Fault(
                f"the plan leaves out {len(dropped)} of its {what}; the first is: {dropped[0].message}",
                node=dropped[0].node,
                robot=dropped[0].robot,
                found=f"{len(said)} {what}",
                needed=dropped[0].message,
            )


def remark_dropped(case: Case) -> Iterator[Fault]:
    """A remark that the dialogue ends with stands in the plan neither as a notice nor as an assumption or a finding."""
    said = {*case.plan.notices, *case.plan.assumptions, *case.plan.findings}
    found = {finding.rule for finding in case.plan.findings}  # grounding may find what the author was warned of
    for remark in case.ending("remarks"):
        if remark not in said and not (remark.severity == "warning" and remark.rule in found):
            yield Fault(
                f"the plan leaves out what its author remarked: {remark.message}",
                node=remark.node,
                needed=remark.message,
            )


def entity_unsaid(case: Case) -> Iterator[Fault]:
    """An entity was introduced in the dialogue that built the tree, and no assumption of the plan names it."""
    plan = case.plan
    said = {reason.node for reason in plan.assumptions}
    for entity in plan.tree.entities if plan.tree is not None and plan.provenance.author != GIVEN else ():
        if entity.id not in said:
            yield Fault(
                f"{entity.label or entity.id} was introduced by the author, and the plan does not say so.",
                node=entity.id,
                found="no assumption",
                needed="an assumption that names it",
            )


def assumption_missing(case: Case) -> Iterator[Fault]:
    """A schedule counts no travel for a robot whose place, or for a type whose speed, is not known, and does not say so."""
    for timetable in case.timetables:
        said = {reason.robot for reason in timetable.schedule.assumptions}
        for name, why, leaf in _guesses(case, timetable):
            if name not in said:
                said.add(name)
                yield Fault(
                    f"schedule {timetable.schedule.rank} does not say that {why} is not known.",
                    node=named(timetable.tree, leaf),
                    robot=name,
                    found="no assumption",
                    needed="an assumption that names it",
                )


def _guesses(case: Case, timetable: Timetable) -> Iterator[tuple[str, str, int]]:
    """Robot or type, what is not known of it, and the action for which that counts."""
    for journey in journeys(case, timetable):
        deed, kind = journey.deed, case.fleet.type_of.get(journey.deed.robot)
        if kind is None or None in journey.goals:
            continue
        gap = least_gap(journey.origins, journey.goals)
        if all(origin is None for origin in journey.origins):
            yield deed.robot, f"where {deed.robot} comes from", deed.leaf
        elif "max_speed_mps" not in kind.limits and gap is not None and gap > NEAR_M:
            yield kind.id, f"how fast {kind.label or kind.id} travels", deed.leaf
