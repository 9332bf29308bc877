"""The words over a Gantt chart and in its description; and the picture of a schedule that there is not."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.called import called
from missiontree.reporting.escape import one_line
from missiontree.reporting.gantt.content import Content
from missiontree.reporting.gantt.time import exact, in_words
from missiontree.reporting.left_out import left_out_in_short
from missiontree.reporting.palette import MUTED
from missiontree.reporting.svg_page import opening, text
from missiontree.reporting.text_box import wrapped

TITLE = 15.0
UNDER = 12.0
_MOST_ROLES = 40
_LINE = 18.0
_MARGIN = 16.0


def mission_of(plan: Plan) -> str:
    """What the mission is called."""
    return one_line(plan.tree.objective if plan.tree is not None else plan.brief.text).rstrip(".") or "Mission"


def summary(plan: Plan, schedule: Schedule, content: Content) -> str:
    """Alternative, length, and what is known of it, in a line."""
    chosen = bool(plan.brief.routines.routines)  # an instance has no routines, and nothing is ranked there
    parts = [called(plan, schedule.rank).removeprefix("the ").capitalize()] if chosen else []
    parts += [left_out_in_short(plan.partial)] if plan.partial is not None else []
    alternatives = plan.ranking.alternatives if plan.ranking is not None and chosen else ()
    parts += [f"utility {one.utility:g}" for one in alternatives if one.rank == schedule.rank]
    makespan_s, deadline_s = content.makespan_s, content.deadline_s
    parts.append(f"{'done' if chosen else 'Done'} after {in_words(makespan_s)}")
    if deadline_s is not None:
        parts.append(f"due by {in_words(deadline_s)}")
    method, bound = schedule.certificate.method.replace("_", " "), schedule.certificate.bound
    if schedule.status == "optimal":
        parts.append(f"no schedule is shorter, proven by {method}")
    elif bound is not None and schedule.certificate.claim == "solver_word":
        least = in_words(bound, least=60 if makespan_s >= 600 else 600)
        parts.append(f"none is shorter than {least} by the solver's word ({method})")
    elif bound is not None:
        parts.append(f"none can be shorter than {in_words(bound, least=60 if makespan_s >= 600 else 600)}, by {method}")
    return " · ".join(parts)


def description(content: Content) -> str:
    """The chart in sentences, for whoever hears it: who does which role when, and what makes it take as long as it does."""
    roles = [
        f"{row.robot}: {role.label}, {exact(role.start_s)} to {exact(role.end_s)}."
        for row in content.rows
        for role in row.roles
    ]
    if len(roles) > _MOST_ROLES:
        roles = [*roles[:_MOST_ROLES], f"And {len(roles) - _MOST_ROLES} more roles."]
    robots = list(dict.fromkeys(step.robot for step in content.chain))
    chain = f" The critical chain runs through {', '.join(robots[:20])}." if robots else ""
    held = [
        f"{row.name} is held by {hold.robot}, {exact(hold.start_s)} to {exact(hold.end_s)}."
        for row in content.shared
        for hold in row.holds
    ]
    held = [*held[:_MOST_ROLES], *([f"And {len(held) - _MOST_ROLES} more times."] if len(held) > _MOST_ROLES else [])]
    told = " ".join([*roles, *held])
    return f"Robots as rows, time to the right, done after {exact(content.makespan_s)}. {told}{chain}"


def without_schedule(plan: Plan, rank: int, schedule: Schedule | None, width: float, prefix: str) -> str:
    """A picture that says in words why there is nothing to draw."""
    headline, why = _why(plan, rank, schedule)
    room = width - 2 * _MARGIN
    body = [(line, TITLE, True) for line in wrapped(mission_of(plan), TITLE * 1.08, room, 2)]
    body += [(line, UNDER + 1, True) for line in wrapped(headline, (UNDER + 1) * 1.08, room, 2)]
    for sentence in why:
        body += [(line, UNDER, False) for line in wrapped(sentence, UNDER, room, 4)]
    lines, y = [], _MARGIN
    for line, size, bold in body:
        y += _LINE + (4.0 if bold else 0.0)
        lines.append(text(_MARGIN, y - 4, line, size=size, bold=bold, **({} if bold else _QUIETLY)))
    page = opening(width, y + _MARGIN, f"{mission_of(plan)}: {headline}", " ".join([headline, *why]), prefix)
    return "\n".join([page, *lines, "</svg>"]) + "\n"


_QUIETLY = {"fill": MUTED, "kind": "mt-muted"}


def _why(plan: Plan, rank: int, schedule: Schedule | None) -> tuple[str, Sequence[str]]:
    if schedule is None:
        reasons = [one_line(reason.message) for reason in plan.reasons[:8]]
        return f"There is no schedule of an alternative {rank}", reasons
    reasons = [one_line(f"{reason.message} {reason.hint}") for reason in schedule.reasons[:8]]
    if schedule.status == "infeasible":
        return f"Alternative {rank} cannot be scheduled, which is proven", reasons
    if schedule.status == "unknown":
        detail = one_line(schedule.certificate.detail)
        return f"No schedule of alternative {rank} was found, and none is excluded", [
            *filter(None, (detail,)),
            *reasons,
        ]
    if not schedule.actions:
        return f"Alternative {rank} asks for no action", reasons
    headline = f"Alternative {rank}: no action takes time, as far as is known; only the order can be told"
    return headline, _order(plan, schedule)


def _order(plan: Plan, schedule: Schedule) -> list[str]:
    """What each robot does, one thing after the other."""
    assert plan.grounding is not None
    own: dict[str, list[str]] = {}
    for one in sorted(schedule.actions, key=lambda one: one.leaf):
        own.setdefault(one.robot, []).append(one_line(plan.grounding.tree.action(one.leaf).text))
    lines = [f"{robot}: {', then '.join(texts)}" for robot, texts in own.items()]
    return lines if len(lines) <= _MOST_ROLES else [*lines[:_MOST_ROLES], f"and {len(lines) - _MOST_ROLES} more robots"]
