"""A schedule of an instance from elsewhere as people read it, and as JSON."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import NamedTuple

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from missiontree.instances import Instance
from missiontree.mission.chain import Addition, WhySoLong
from missiontree.mission.coalitions import CoalitionMission, CoalitionSchedule
from missiontree.mission.columns import LEAF, TreeColumns
from missiontree.mission.plan import Plan
from missiontree.mission.tree_schedule import TreeSchedule
from missiontree.reporting.critical.chain import chain_of
from missiontree.reporting.critical.view import chain_view, title_of, why_view
from missiontree.reporting.known import known_in_words
from missiontree.reporting.text import words

MOST_ACTIONS = 40
MOST_ROBOTS = 12
MOST_PARTS = 8


class Told(NamedTuple):
    """
    What there is to tell.

    Parameters
    ----------
    form
        Of the file, in words.
    instance, schedule
        What was asked, and the answer.
    source
        Name of the file.
    seed, time_limit_s
        What was asked for.
    elapsed_s
        Seconds that scheduling took.
    plan
        The schedule as a plan; None (default) if nothing is scheduled, or more than is looked at in passing.
    why
        Why it is so long, with what would shorten it; None (default) if that was not asked.
    """

    form: str
    instance: Instance
    schedule: TreeSchedule | CoalitionSchedule
    source: str
    seed: int
    time_limit_s: float
    elapsed_s: float
    plan: Plan | None = None
    why: WhySoLong | None = None


class Deed(NamedTuple):
    """
    Something that a robot does.

    Parameters
    ----------
    start_s, end_s, robot, what
        When, who and what, for people.
    node
        Leaf of a tree, or task from 0; None where a robot gets to the end.
    number
        Which robot it is, from 0: of a tree among the equal ones that the leaf names.
    """

    start_s: float
    end_s: float
    robot: str
    what: str
    node: int | None
    number: int


def view_of(told: Told) -> Group:
    """The schedule for a terminal."""
    return Group(*_sections(told))


def _sections(told: Told) -> Iterator[RenderableType]:
    schedule = told.schedule
    yield words(f"{told.source}, read as a {told.form}: {_size(told.instance)}", "dim")
    certificate = schedule.certificate
    if schedule.status == "infeasible":
        yield words(f"Cannot be done, {_known(told)}: {certificate.detail}", "bold")
        return
    yield Text(f"Makespan {_shown(schedule.makespan_s)} s, {_known(told)}", style="bold")
    yield words(certificate.detail)
    if isinstance(told.instance, CoalitionMission) and told.instance.reference_s is not None:
        yield Text(f"Published for this instance: {told.instance.reference_s:.3f} s.")
    deeds = deeds_of(told)
    if schedule.makespan_s:
        yield Padding(_robots(deeds, schedule.makespan_s), (0, 0, 0, 2), expand=False)
    if len(deeds) <= MOST_ACTIONS:
        yield Padding(_actions(deeds), (0, 0, 0, 2), expand=False)
    else:
        yield Text(f"{len(deeds):,} actions; --json lists them all", style="dim")
    if (why := _why(told)) is not None:
        yield from why
    yield Text(f"seed {told.seed}, time limit {told.time_limit_s:g} s: {told.elapsed_s:.2f} s", style="dim")


def _size(instance: Instance) -> str:
    if isinstance(instance, CoalitionMission):
        return f"{len(instance.tasks)} tasks, {len(instance.skills)} robots"
    robots = instance.robots if instance.count is None else sum(instance.count)
    return f"{len(instance.kind):,} nodes, {list(instance.kind).count(LEAF):,} leaves, {robots:,} robots"


def _known(told: Told) -> str:
    schedule = told.schedule
    return known_in_words(
        schedule.status, schedule.certificate, schedule.makespan_s, lambda seconds: f"{_shown(seconds)} s"
    )


def _shown(seconds: float) -> str:
    return f"{seconds:,.3f}".rstrip("0").rstrip(".")


def deeds_of(told: Told) -> list[Deed]:
    """What is done, by start."""
    instance, schedule = told.instance, told.schedule
    if isinstance(instance, CoalitionMission):
        assert isinstance(schedule, CoalitionSchedule)
        deeds = [
            Deed(visit.start_s, visit.end_s, f"robot-{robot}", f"Task {visit.task + 1}", visit.task, robot)
            for visit in schedule.visits
            for robot in visit.robots
        ]
        deeds += [
            Deed(at, at, f"robot-{robot}", "At the end", None, robot) for robot, at in enumerate(schedule.arrivals_s)
        ]
        return sorted(deeds, key=lambda deed: deed[:4])
    assert isinstance(schedule, TreeSchedule)
    deeds = [
        Deed(
            start,
            start + instance.duration[leaf],
            _robot(instance, schedule, leaf),
            instance.label(leaf),
            leaf,
            schedule.robot[leaf],
        )
        for leaf, start in schedule.start_s.items()
    ]
    return sorted(deeds, key=lambda deed: deed[:4])


def _robot(columns: TreeColumns, schedule: TreeSchedule, leaf: int) -> str:
    name = columns.robot_id(columns.robot[leaf])
    return name if columns.count is None else f"{name}-{schedule.robot[leaf] + 1}"


def _robots(deeds: list[Deed], makespan_s: float) -> Table:
    """Who is busy how long, the busiest first."""
    busy: dict[str, list[float]] = {}
    for deed in deeds:
        if deed.end_s > deed.start_s:
            busy.setdefault(deed.robot, []).append(deed.end_s - deed.start_s)
    table = _table("robot", "actions", "busy s", "of makespan", left=("robot",))
    ranked = sorted(busy.items(), key=lambda item: -sum(item[1]))
    for robot, times in ranked[:MOST_ROBOTS]:
        table.add_row(
            words(robot), str(len(times)), _shown(sum(times)), f"{100 * sum(times) / max(1e-9, makespan_s):.0f} %"
        )
    if len(ranked) > MOST_ROBOTS:
        table.add_row(f"… and {len(ranked) - MOST_ROBOTS} more", "", "", "")
    return table


def _actions(deeds: list[Deed]) -> Table:
    table = _table("from s", "to s", "robot", "what", left=("robot", "what"))
    for deed in deeds:
        table.add_row(_shown(deed.start_s), _shown(deed.end_s), words(deed.robot), words(deed.what))
    return table


def _table(*columns: str, left: tuple[str, ...]) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0), header_style="dim")
    for name in columns:
        table.add_column(name, justify="left" if name in left else "right")
    return table


def _why(told: Told) -> Iterator[RenderableType] | None:
    """Why it takes so long; None of a schedule that takes no time, or is too large to be looked at in passing."""
    if told.plan is None or not told.schedule.makespan_s:
        return None
    schedule = told.plan.schedules[0]
    if told.why is not None:
        return iter((why_view(told.why, told.plan, schedule, "it"),))
    chain = chain_of(told.plan, schedule)
    title = Text(title_of(chain, "it"), style="bold")
    parts = chain_view(told.plan, schedule, MOST_PARTS, "--why-so-long")
    return iter((title, Padding(parts, (0, 0, 0, 2), expand=False)))


def _chain(told: Told) -> dict[str, object] | None:
    if told.plan is None or told.plan.grounding is None:
        return None
    chain, tree = chain_of(told.plan, told.plan.schedules[0]), told.plan.grounding.tree
    steps = [
        {
            "kind": step.kind,
            "what": tree.action(step.leaf).text,
            "robot": step.robot,
            "start_s": step.start_s,
            "end_s": step.end_s,
            "bond": step.bond,
        }
        for step in chain.steps
    ]
    told_of = {"work_s": chain.work_s, "travel_s": chain.travel_s, "waiting_s": chain.waiting_s, "steps": steps}
    if told.why is None:
        return told_of
    return told_of | {"additions": [_addition(one) for one in told.why.additions], "untried": told.why.untried}


def _addition(one: Addition) -> dict[str, object]:
    return {
        "robots": dict(one.robots),
        "verdict": one.verdict,
        "status": one.status,
        "makespan_s": one.makespan_s,
        "bound_s": one.certificate.bound,
        "claim": one.certificate.claim,
        "method": one.certificate.method,
    }


def json_of(told: Told) -> str:
    """The schedule as JSON, an action per line."""
    schedule = told.schedule
    certificate = schedule.certificate
    head: dict[str, object] = {
        "form": told.form,
        "status": schedule.status,
        "known": _known(told),
        "makespan_s": schedule.makespan_s,
        "bound_s": certificate.bound,
        "claim": certificate.claim,
        "method": certificate.method,
        "detail": certificate.detail,
        "seed": told.seed,
        "time_limit_s": told.time_limit_s,
        "time_s": round(told.elapsed_s, 6),
    }
    if (chain := _chain(told)) is not None:
        head["critical_chain"] = chain
    if isinstance(schedule, TreeSchedule):
        head["chosen"] = {str(xor): child for xor, child in sorted(schedule.chosen.items())}
    lines = ",\n".join("    " + json.dumps(deed._asdict()) for deed in deeds_of(told))
    listed = f"[\n{lines}\n  ]" if lines else "[]"
    return json.dumps(head, indent=2).removesuffix("\n}") + f',\n  "actions": {listed}\n}}\n'
