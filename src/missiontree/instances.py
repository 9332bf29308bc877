"""
Instances from elsewhere: read, scheduled with their choices, and checked, on one page.

A flexible job shop, a mission of coalitions, or a tree in columns says itself what there is to choose from, so that there is nothing to
author. What counts is the makespan alone.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from missiontree.checking.coalitions import check_coalitions
from missiontree.checking.columns import check_tree
from missiontree.checking.fault import Fault
from missiontree.errors import InputError, InternalError
from missiontree.formats.importers.coalitions import coalitions_of, looks_like_coalitions
from missiontree.formats.importers.fjsp import looks_like_shop, shop_of
from missiontree.formats.importers.instance_plan import plan_of_coalitions, plan_of_tree
from missiontree.formats.importers.instance_schedule import schedule_of
from missiontree.formats.importers.tree_json import columns_of, looks_like_tree
from missiontree.formats.place import found
from missiontree.formats.reader import parse
from missiontree.formats.source import load_text
from missiontree.mission.coalitions import CoalitionMission, CoalitionSchedule
from missiontree.mission.columns import TreeColumns
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.mission.tree_schedule import TreeSchedule
from missiontree.scheduling.coalitions.coalitions import schedule_coalitions
from missiontree.scheduling.joint.joint import schedule_tree

ACCEPTED = "a flexible job shop (text), a mission of coalitions (JSON) or a tree in columns (JSON)"

Instance = TreeColumns | CoalitionMission


class Recognised(NamedTuple):
    """
    An instance, and the form that its file has.

    Parameters
    ----------
    form
        In words.
    instance
        What it describes.
    """

    form: str
    instance: Instance


def read_instance(file: Path) -> Instance:
    """
    Read a file in any of the three forms, which it is recognised by.

    Raises
    ------
    InputError
        If it has none of them, or is damaged: says where, what was found and what is accepted.
    """
    return read_recognised(file).instance


def read_recognised(file: Path) -> Recognised:
    """
    The same, and which form it was.

    Raises
    ------
    InputError
        As :func:`read_instance`.
    """
    text = load_text(file)
    if not text.strip():
        raise InputError("the file is empty", file=str(file), accepted=ACCEPTED)
    if looks_like_shop(text):
        return Recognised("flexible job shop", shop_of(text, str(file)))
    if all(line.lstrip().startswith("#") for line in text.splitlines() if line.strip()):
        raise InputError("the file holds nothing but comments", file=str(file), accepted=ACCEPTED)
    parsed = parse(text, str(file))
    if looks_like_coalitions(parsed.data):
        return Recognised("mission of coalitions", coalitions_of(parsed))
    if looks_like_tree(parsed.data):
        return Recognised("tree in columns", columns_of(parsed))
    message = f"this is no instance of a form that is known here, but {found(parsed.data)}"
    raise InputError(message, file=str(file), line=1, accepted=ACCEPTED)


def plan_of_instance(instance: Instance, schedule: TreeSchedule | CoalitionSchedule, title: str) -> Plan:
    """
    A schedule that works as a plan of one alternative, for whatever shows plans: chart, timeline, critical chain.

    Parameters
    ----------
    instance, schedule
        As :func:`read_instance` and :func:`schedule_instance` return them.
    title
        What the mission is called.

    Raises
    ------
    ValueError
        If nothing is scheduled.
    """
    if schedule.status not in {"optimal", "feasible"}:
        raise ValueError(f"the schedule is {schedule.status}, so there is nothing to show.")
    if isinstance(instance, CoalitionMission):
        assert isinstance(schedule, CoalitionSchedule)
        return plan_of_coalitions(instance, schedule, title)
    assert isinstance(schedule, TreeSchedule)
    return plan_of_tree(instance, schedule, title)


def schedule_instance(
    instance: Instance, control: Control | None = None, *, solver: bool = True, bound_share: float = 0.0
) -> TreeSchedule | CoalitionSchedule:
    """
    Choose and schedule for the least makespan. What is returned has passed the checker.

    Parameters
    ----------
    instance
        As :func:`read_instance` returns it.
    control
        Time limit, stop token, listener, seed. Default: no limit; then a job shop that resists may take very long.
    solver
        Whether CP-SAT may be asked where bounds and search leave a gap. Default true.
    bound_share
        Of the time that is left for CP-SAT, from 0 to 1, what goes into raising the bound. Default 0.
    """
    limits = control or Control()
    schedule: TreeSchedule | CoalitionSchedule
    if isinstance(instance, CoalitionMission):
        schedule = schedule_coalitions(instance, limits)
    else:
        schedule = schedule_tree(instance, limits, solver=solver, bound_share=bound_share)
    if faults := check_schedule(instance, schedule):
        raise InternalError(f"the checker refuses a schedule of our own making: {faults[0].message}")
    return schedule


def read_schedule(file: Path, instance: Instance) -> TreeSchedule | CoalitionSchedule:
    """
    Read a schedule as ``missiontree schedule --json`` prints it, from wherever it comes.

    Raises
    ------
    InputError
        If the file is no such schedule of this instance; says where, what was found and what is accepted.
    """
    return schedule_of(parse(load_text(file), str(file)), instance)


def check_schedule(instance: Instance, schedule: TreeSchedule | CoalitionSchedule) -> tuple[Fault, ...]:
    """
    Every fault of a schedule, by a checker that shares nothing with what makes schedules; none if it is sound.

    Choices, who does what when, ways, order, makespan, and that it claims no more than its certificate carries. Bounds are taken on trust.
    """
    if isinstance(instance, CoalitionMission):
        assert isinstance(schedule, CoalitionSchedule)
        return check_coalitions(instance, schedule)
    assert isinstance(schedule, TreeSchedule)
    return check_tree(instance, schedule)
