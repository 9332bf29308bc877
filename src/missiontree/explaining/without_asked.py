"""What would change if a robot failed, or a whole type of them? Planned again without it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.authoring.author import authored_from_tree
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.errors import InputError
from missiontree.explaining.answering import best_of, moved_in_words, side_by_side, verdict_of
from missiontree.explaining.nearest import nearest_part
from missiontree.explaining.tasks import moved_between, tasks_of
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.why_not import Verdict, WhyNot
from missiontree.planner import plan_authored
from missiontree.reporting.left_out import known_of_larger, parts_left_out

SHARE = 0.6


def what_without(plan: Plan, request: Request, names: Sequence[str], control: Control) -> WhyNot:
    """
    Say what would change without some robots or robot types.

    Parameters
    ----------
    plan, request
        A delivered plan, and how it was made.
    names
        Ids of robots and robot types.
    control
        Time limit.
    """
    best = best_of(plan)
    assert best is not None
    assert plan.tree is not None
    shown = " and ".join(_label(plan, name) for name in names)
    question = f"What would change without {shown}?"
    try:
        brief = replace(plan.brief, without=tuple(dict.fromkeys((*plan.brief.without, *names))))
    except ValueError as error:
        reason = Reason(rule="without_refused", message=_sentence(str(error)), robot=names[0])
        return WhyNot(
            question=question,
            verdict="refused",
            claim="proven",
            words=(f"Without {shown} the mission cannot even be stated.",),
            reasons=(reason,),
            utility=best[0].utility,
            makespan_s=best[1].makespan_s,
        )
    notice = Reason(
        rule="asked_without",
        message=f"This plan is one without {shown}, as it was asked for.",
        severity="notice",
        robot=names[0],
    )
    again = replace(request, brief=brief, tree=plan.tree)
    authored = _authored(plan, brief_request=again, notice=notice)
    made = plan_authored(again, authored, control.part(SHARE))
    other = best_of(made)
    if made.outcome != "delivered" or other is None:
        return _in_vain(plan, question, shown, made, again, authored, control)
    moved = moved_between(tasks_of(plan, *best), tasks_of(made, *other))
    compared = side_by_side(
        best[0].utility, other[0].utility, best[1].makespan_s, other[1].makespan_s, plan.brief.aim.worth
    )
    certificate = other[0].certificate if made.chosen is None else made.chosen.option.certificate
    proven = certificate.claim == "proven"
    what = "the mission" if plan.partial is None else "this part of the mission"
    unchanged = () if moved else ("Nobody does anything else than before.",)
    return WhyNot(
        question=question,
        verdict=verdict_of(
            best[0].utility, other[0].utility, best[1].makespan_s, other[1].makespan_s, plan.brief.objective
        ),
        claim="proven" if proven else "found",
        words=(f"Without {shown} {what} can still be done: {compared}.", *unchanged, *moved_in_words(moved)),
        asked_utility=other[0].utility,
        asked_makespan_s=other[1].makespan_s,
        moved=moved,
        plan=made,
        utility=best[0].utility,
        makespan_s=best[1].makespan_s,
    )


def _authored(plan: Plan, brief_request: Request, notice: Reason) -> Authored:
    """The plan's tree as one that is handed in."""
    assert plan.tree is not None
    given = authored_from_tree(plan.tree, brief_request.brief)
    if given.status != "complete":
        raise InputError(
            f"the tree of the plan cannot be planned again: {given.reasons[0].message}",
            hint="Check the plan: missiontree check.",
        )
    return replace(given, notices=(*given.notices, notice))


def _in_vain(
    plan: Plan, question: str, shown: str, made: Plan, request: Request, authored: Authored, control: Control
) -> WhyNot:
    """It cannot be done without; what part of it can."""
    best = best_of(plan)
    assert best is not None
    part = nearest_part(made, request, authored, control)
    proven = made.outcome == "cannot_be_done"
    words = [
        f"Without {shown} the mission cannot be done{'; proven' if proven else ', as far as was found out'}."
        if proven
        else f"Without {shown} no plan was found in the time given; none is excluded."
    ]
    if part is not None and part.partial is not None:
        words.append(known_of_larger(part.partial))
        words += [reason.message for reason in parts_left_out(part.partial)]
    verdict: Verdict = "part_only" if part is not None else "impossible" if proven else "undecided"
    found = best_of(part) if part is not None else None
    return WhyNot(
        question=question,
        verdict=verdict,
        claim="proven" if proven else "found",
        words=tuple(words),
        reasons=tuple(reason for reason in (part or made).reasons if reason.rule != "left_out"),
        utility=best[0].utility,
        makespan_s=best[1].makespan_s,
        asked_utility=found[0].utility if found is not None else None,
        asked_makespan_s=found[1].makespan_s if found is not None else None,
        moved=moved_between(tasks_of(plan, *best), tasks_of(part, *found))
        if part is not None and found is not None
        else (),
        plan=part,
    )


def _label(plan: Plan, name: str) -> str:
    """A type by its label, a robot by its name."""
    kind = plan.brief.fleet.by_id.get(name)
    return kind.label or kind.id if kind is not None else name


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")
