"""Are visits to chargers possible, and do levels stay between nothing and full?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.budgets import beyond
from missiontree.checking.case import Case
from missiontree.checking.clock import TICKS_PER_S, TOLERANCE, shown, tick
from missiontree.checking.fault import Fault
from missiontree.checking.levels import levels, refillable
from missiontree.checking.timetable import Timetable
from missiontree.mission.charger import Charger
from missiontree.mission.schedule import Recharge


def recharge_unknown(case: Case) -> Iterator[Fault]:
    """A visit to a charger that the scene does not have, or by a robot that does nothing else."""
    for timetable in case.timetables:
        for visit in timetable.schedule.recharges:
            known = visit.charger in {charger.id for charger in case.scene.chargers}
            if not known or visit.robot not in timetable.by_robot:
                what = "fills no role" if known else "is at a charger that the scene does not have"
                yield _fault(timetable, visit, what, visit.charger, "a charger of the scene, by a robot with a role")


def recharge_not_allowed(case: Case) -> Iterator[Fault]:
    """A robot is at a charger that its type may not use, or that refills nothing that the type has a limit of."""
    for timetable, visit, charger in _visits(case):
        kind = case.fleet.type_of.get(visit.robot)
        if kind is not None and (
            charger.stock not in refillable(case, kind.id)
            or (charger.types is not None and kind.id not in charger.types)
        ):
            yield _fault(
                timetable, visit, f"may not refill {charger.stock} there", kind.id, f"a robot that {charger.id} serves"
            )


def recharge_overlap(case: Case) -> Iterator[Fault]:
    """A robot refills while it travels, is held in a role, or refills elsewhere."""
    for timetable in case.timetables:
        for number, visit in enumerate(timetable.schedule.recharges):
            start, end = tick(visit.start_s), tick(visit.end_s)
            for what, since, until in _busy(timetable, number, visit.robot):
                if start + TOLERANCE < until and since + TOLERANCE < end:
                    found = f"{shown(start)} to {shown(end)}"
                    yield _fault(
                        timetable,
                        visit,
                        f"refills from {found} and {what} from {shown(since)} to {shown(until)}",
                        found,
                        "nothing else at that time",
                    )


def recharge_too_fast(case: Case) -> Iterator[Fault]:
    """A robot takes in more than the charger gives in the time."""
    for timetable, visit, charger in _visits(case):
        most = charger.rate_per_s * (tick(visit.end_s) - tick(visit.start_s) + TOLERANCE) / TICKS_PER_S
        if beyond(visit.amount, most):
            yield _fault(
                timetable,
                visit,
                f"takes in {visit.amount:g} of {charger.stock} in {visit.end_s - visit.start_s:g} s",
                f"{visit.amount:g}",
                f"at most {charger.rate_per_s * (visit.end_s - visit.start_s):g}",
            )


def charger_crowded(case: Case) -> Iterator[Fault]:
    """More robots refill at a charger at one time than it has room for."""
    for timetable, visit, charger in _visits(case):
        start = tick(visit.start_s)
        others = [
            other
            for other in timetable.schedule.recharges
            if other.charger == charger.id and tick(other.start_s) <= start and start + TOLERANCE < tick(other.end_s)
        ]
        if len(others) > charger.capacity:
            yield _fault(
                timetable,
                visit,
                f"is one of {len(others)} robots there at {shown(start)}",
                f"{len(others)} robots",
                f"at most {charger.capacity}",
            )


def level_below_nothing(case: Case) -> Iterator[Fault]:
    """A robot uses up more of what it can refill than it has at that time."""
    for timetable in case.timetables:
        seen: set[tuple[str, str]] = set()
        for level in levels(case, timetable):
            if level.amount < -1e-6 - 1e-9 * level.full and (level.robot, level.name) not in seen:
                seen.add((level.robot, level.name))
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {level.robot} is out of {level.name} after {level.after}, "
                    f"{-level.amount:g} short.",
                    robot=level.robot,
                    found=f"{level.name} {level.amount:g}",
                    needed=f"{level.name} at least 0",
                )


def level_above_full(case: Case) -> Iterator[Fault]:
    """A robot has more of something after a visit to a charger than it holds."""
    for timetable in case.timetables:
        for level in levels(case, timetable):
            if beyond(level.amount, level.full):
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {level.robot} has {level.amount:g} of {level.name} after {level.after}; "
                    f"full is {level.full:g}.",
                    robot=level.robot,
                    found=f"{level.name} {level.amount:g}",
                    needed=f"{level.name} at most {level.full:g}",
                )


def _visits(case: Case) -> Iterator[tuple[Timetable, Recharge, Charger]]:
    chargers = {charger.id: charger for charger in case.scene.chargers}
    for timetable in case.timetables:
        for visit in timetable.schedule.recharges:
            if visit.charger in chargers:
                yield timetable, visit, chargers[visit.charger]


def _busy(timetable: Timetable, number: int, robot: str) -> Iterator[tuple[str, int, int]]:
    """What else a robot does, and from when to when."""
    for place, other in enumerate(timetable.schedule.recharges):
        if other.robot == robot and place != number:
            yield "refills", tick(other.start_s), tick(other.end_s)
    for leg in timetable.schedule.ways:
        if leg.robot == robot:
            yield "travels", tick(leg.start_s), tick(leg.end_s)
    for deeds in timetable.by_role.values():
        own = [deed for deed in deeds if deed.robot == robot]
        if own:
            yield "is held in a role", min(deed.start for deed in own), max(deed.end for deed in own)


def _fault(timetable: Timetable, visit: Recharge, what: str, found: str, needed: str) -> Fault:
    return Fault(
        f"schedule {timetable.schedule.rank}: {visit.robot}, at the charger {visit.charger}, {what}.",
        robot=visit.robot,
        found=found,
        needed=needed,
    )
