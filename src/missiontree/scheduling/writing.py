"""From what a run came to, to the schedule that people read: certificate, legs, and what was taken for granted."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from missiontree.mission.alternative import Alternative, Assignment
from missiontree.mission.certificate import Certificate
from missiontree.mission.fleet import RobotType
from missiontree.mission.grounded import Action
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import OwnLeg, Recharge, Schedule, ScheduledAction, TravelLeg
from missiontree.mission.ticks import seconds
from missiontree.scheduling.problem import Done, Draft, Homeward, Problem
from missiontree.scheduling.trips import Trip


def impossible_schedule(alternative: Alternative, method: str, reasons: Sequence[Reason]) -> Schedule:
    """The schedule of an alternative that is proven to have none."""
    return Schedule(
        rank=alternative.rank,
        status="infeasible",
        certificate=Certificate(claim="proven", method=method, detail=reasons[0].message),
        reasons=tuple(reasons),
    )


def no_schedule(alternative: Alternative, proof: Certificate, failures: Sequence[Reason]) -> Schedule:
    """The schedule of an alternative of which a search has proven that there is none; beside that, why runs got stuck."""
    reason = Reason(
        rule="no_schedule",
        message="No choice of robots and no order keep all rules of this alternative.",
        hint="Loosen a link, a budget or a limit, or give the fleet another robot.",
    )
    tries = (replace(failure, hint="") for failure in failures[:7])  # which say what might help, if it were not proven
    return impossible_schedule(alternative, proof.method, (reason, *tries))


def unknown_schedule(
    problem: Problem, alternative: Alternative, failures: list[Reason], certificate: Certificate | None = None
) -> Schedule:
    """The schedule of an alternative for which no run found one, and why."""
    return Schedule(
        rank=alternative.rank,
        status="unknown",
        certificate=certificate
        or Certificate(
            claim="unproven",
            method="serial_generation",
            bound=seconds(problem.bounds.makespan),
            detail="No run found a schedule, and nothing proves that there is none.",
        ),
        reasons=tuple(failures[:8]),
    )


def untried_schedule(alternative: Alternative) -> Schedule:
    """The schedule of an alternative that nothing was tried for, since time was up when others had been."""
    detail = "Nothing was tried for this alternative: time was up."
    return Schedule(
        rank=alternative.rank,
        status="unknown",
        certificate=Certificate(claim="unproven", method="serial_generation", detail=detail),
        reasons=(TIME_IS_UP,),
    )


TIME_IS_UP = Reason(rule="time_limit", message="Time was up before a schedule was complete.")


def by_bound(problem: Problem, draft: Draft) -> Certificate:
    """What the bounds alone prove of a draft."""
    bound = problem.bounds.makespan
    optimal = draft.makespan == bound
    name = problem.bounds.method.replace("_", " ")
    detail = (
        f"The makespan equals the lower bound by {name}."
        if optimal
        else f"No schedule is shorter than {seconds(bound):g} s, the lower bound by {name}."
    )
    return Certificate(
        claim="proven" if optimal else "bounded", method=problem.bounds.method, bound=seconds(bound), detail=detail
    )


def found_schedule(
    problem: Problem, alternative: Alternative, draft: Draft, certificate: Certificate | None = None
) -> Schedule:
    """The schedule that a draft makes, with what is known of it. Default: what the bounds alone prove."""
    certificate = certificate or by_bound(problem, draft)
    return Schedule(
        rank=alternative.rank,
        status="optimal" if certificate.claim == "proven" else "feasible",
        certificate=certificate,
        assignments=tuple(Assignment(role, robot) for role, robot in draft.robot_of.items()),
        actions=tuple(
            ScheduledAction(leaf=one.leaf, robot=one.robot, start_s=seconds(one.start), end_s=seconds(one.end))
            for one in draft.done
        ),
        legs=_legs(problem, draft),
        recharges=_recharges(draft),
        returns=_returns(draft),
        makespan_s=seconds(draft.makespan),
        assumptions=_assumptions(problem, draft),
    )


def _legs(problem: Problem, draft: Draft) -> tuple[TravelLeg, ...]:
    legs = [leg for one in draft.done if (leg := _leg(one, problem.graph.tree.action(one.leaf).moves)) is not None]
    return tuple(sorted(legs, key=lambda leg: (leg.start_s, leg.leaf, leg.robot)))


def _recharges(draft: Draft) -> tuple[Recharge, ...]:
    found = [
        Recharge(
            robot=one.robot,
            charger=one.station.id,
            start_s=seconds(one.start),
            end_s=seconds(one.end),
            amount=one.amount,
            leg=_own_leg(one.robot, one.trip, one.leaves_at, one.arrives_at),
        )
        for one in draft.refills
    ]
    return tuple(sorted(found, key=lambda one: (one.start_s, one.robot)))


def _own_leg(robot: str, trip: Trip, start: int, end: int) -> OwnLeg | None:
    """A way for a robot's own sake; None if an end of it is not known, or both are one."""
    if trip.origin is None or trip.destination is None:
        return None
    if not (trip.metres or trip.ticks or trip.origin != trip.destination):
        return None
    return OwnLeg(
        robot=robot,
        start_s=seconds(start),
        end_s=seconds(end),
        origin=trip.origin,
        destination=trip.destination,
        distance_m=trip.metres,
        via=trip.via,
    )


def _returns(draft: Draft) -> tuple[OwnLeg, ...]:
    legs = [leg for one in draft.returns if (leg := _own_leg(one.robot, one.trip, one.start, one.end)) is not None]
    return tuple(sorted(legs, key=lambda leg: (leg.start_s, leg.robot)))


def _leg(one: Done, moves: bool) -> TravelLeg | None:
    trip = one.trip
    if trip is None or trip.origin is None or trip.destination is None or not (moves or trip.metres or trip.ticks):
        return None
    return TravelLeg(
        robot=one.robot,
        leaf=one.leaf,
        start_s=seconds(one.leaves_at),
        end_s=seconds(one.arrives_at),
        origin=trip.origin,
        destination=trip.destination,
        distance_m=trip.metres,
        via=trip.via,
    )


def _assumptions(problem: Problem, draft: Draft) -> tuple[Reason, ...]:
    """What was taken for granted on the way, each thing once."""
    reasons: dict[tuple[str, str], Reason] = {}
    lost: dict[str, Action] = {}  # by robot: the action that took it to where nobody knows
    for one in draft.done:
        kind = problem.fleet.type_of[one.robot]
        trip, action = one.trip, problem.graph.tree.action(one.leaf)
        if trip is None or trip.destination is None:
            if action.at is not None:
                lost[one.robot] = action
            continue
        if trip.origin is None and one.robot in lost:
            reason = _whereabouts_unknown(problem, lost[one.robot], one.robot)
            reasons.setdefault(("whereabouts_unknown", reason.message), reason)
        elif trip.origin is None:
            reasons.setdefault(
                ("start_unknown", one.robot),
                Reason(
                    rule="start_unknown",
                    message=f"Where {one.robot} comes from is not known; getting to its first place is counted as no travel.",
                    severity="assumption",
                    robot=one.robot,
                    hint="Give the robot a position or a place.",
                ),
            )
        elif trip.origin != trip.destination and not problem.trips.speed_known(kind.id):  # no metre may be, by lift
            reasons.setdefault(("speed_unknown", kind.id), _speed_unknown(kind))
        lost.pop(one.robot, None)
    for home in draft.returns:
        for key, reason in _of_return(problem, home, lost.get(home.robot)):
            reasons.setdefault(key, reason)
    return tuple(reasons[key] for key in sorted(reasons))


def _of_return(problem: Problem, home: Homeward, lost: Action | None) -> Iterator[tuple[tuple[str, str], Reason]]:
    """What was taken for granted of a way home, with a key of it."""
    trip, kind = home.trip, problem.fleet.type_of[home.robot]
    if trip.destination is None:
        yield (
            ("home_unknown", home.robot),
            Reason(
                rule="home_unknown",
                message=f"Where {home.robot} started is not known; its way home is counted as no travel.",
                severity="assumption",
                robot=home.robot,
                hint="Give the robot a position or a place.",
            ),
        )
    elif trip.origin is None and lost is not None:
        reason = _whereabouts_unknown(problem, lost, home.robot)
        yield ("whereabouts_unknown", reason.message), reason
    elif trip.origin != trip.destination and not problem.trips.speed_known(kind.id):
        yield ("speed_unknown", kind.id), _speed_unknown(kind)


def _speed_unknown(kind: RobotType) -> Reason:
    return Reason(
        rule="speed_unknown",
        message=f"How fast {kind.label} travels is not known; ways to actions take no time, moves their nominal duration.",
        severity="assumption",
        robot=kind.id,
        needed="max_speed_mps",
        hint="Give the type the limit max_speed_mps.",
    )


def _whereabouts_unknown(problem: Problem, action: Action, robot: str) -> Reason:
    entity = problem.trips.scene.by_id.get(action.at or "")
    label = entity.label if entity is not None else action.at
    return Reason(
        rule="whereabouts_unknown",
        message=f"Where {robot} is after {action.text!r} is not known, because {label} has no position; getting from there to its next "
        "place is counted as no travel, or as a move's nominal time.",
        severity="assumption",
        node=action.text,
        robot=robot,
        hint=f"Give {label} a position, a last_seen or a search_area in the scene.",
    )
