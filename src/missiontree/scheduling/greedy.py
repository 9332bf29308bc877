"""
Greedy list scheduling: instant, honest about what it proves.

First what cannot be is proven: a cycle, a place out of reach, a budget too small, robots that must be one and two. Then a few
deterministic runs of serial schedule generation (:mod:`missiontree.scheduling.serial`) with different rules, and the best of them is
kept. If its makespan equals a lower bound it is optimal.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from itertools import islice, product

from missiontree.mission.alternative import Alternative, Assignment
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control, Progress
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule, ScheduledAction, TravelLeg
from missiontree.scheduling.alike import alike_roles
from missiontree.scheduling.approach_budget import approaches_too_dear
from missiontree.scheduling.bounds import lower_bounds
from missiontree.scheduling.bundles import bundles_of, crews_of
from missiontree.scheduling.holding import order_held_roles
from missiontree.scheduling.impossible import budgets_exceeded, cycle_reason, group_needs, unreachable_places
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import task_graph
from missiontree.scheduling.problem import Crew, Done, Draft, Problem, Rule
from missiontree.scheduling.serial import Run
from missiontree.scheduling.staffing import staffing_conflicts, staffing_of
from missiontree.scheduling.ticks import seconds
from missiontree.scheduling.trips import Trips

LEAVES_PER_CALL = 20_000  # work that retries may cost, in scheduled leaves
MAX_RUNS = 40
MAX_BINDINGS = 512
_CREWS: tuple[Crew, ...] = ("joint", "bundle", "none")


def greedy(tree: GroundedTree, alternative: Alternative, fleet: Fleet, scene: Scene, control: Control) -> Schedule:
    """Schedule an alternative, see :class:`missiontree.scheduling.scheduler.Scheduler`."""
    problem = _read(tree, alternative, fleet, scene)
    if not isinstance(problem, Problem):
        method, reasons = problem
        return Schedule(
            rank=alternative.rank,
            status="infeasible",
            certificate=Certificate(claim="proven", method=method, detail=reasons[0].message),
            reasons=tuple(reasons),
        )
    best, failures = _best(problem, alternative, control)
    if best is None:
        return _unknown(problem, alternative, failures)
    return _schedule(problem, alternative, best)


def _read(
    tree: GroundedTree, alternative: Alternative, fleet: Fleet, scene: Scene
) -> Problem | tuple[str, list[Reason]]:
    """The problem, or the method and the reasons of the proof that it cannot be solved."""
    graph = task_graph(tree, alternative.choices)
    if graph.order() is None:
        return "precedence", [cycle_reason(graph, rule="cycle", why="Each of these waits for the one before it")]
    staffing = staffing_of(graph)
    if reasons := staffing_conflicts(graph, staffing, fleet):
        return "staffing", reasons
    order = order_held_roles(graph, staffing, fleet)
    if order is None:
        why = "One robot would be held in a role while waiting for another role that only it can fill"
        return "holding", [cycle_reason(graph, rule="deadlock", why=why)]
    trips = Trips(fleet, scene)
    places = Places(graph, order, trips)
    if reasons := unreachable_places(graph, places, fleet, trips):
        return "reachability", reasons
    if reasons := [*budgets_exceeded(graph, staffing, fleet), *approaches_too_dear(graph, places, trips)]:
        return "budget_bound", reasons
    bounds = lower_bounds(graph, order, staffing, places, fleet, trips)
    needs = group_needs(graph, staffing)
    alike = alike_roles(graph, staffing, needs)
    return Problem(graph, staffing, bounds, fleet, trips, bundles_of(graph), crews_of(graph), needs, alike)


def _best(problem: Problem, alternative: Alternative, control: Control) -> tuple[Draft | None, list[Reason]]:
    """The best draft of all runs, and why runs got stuck."""
    best: Draft | None = None
    failures: dict[Reason, None] = {}
    runs = max(3, min(MAX_RUNS, LEAVES_PER_CALL // max(1, len(problem.graph.activity_of))))
    for number, rule in enumerate(_rules(problem, alternative, runs, control.seed)):
        if number and (control.ended() or (best is not None and (number >= runs or _unbeatable(best, problem)))):
            break
        draft = Run(problem, rule)(control.ended)
        if draft is None:
            failures[Reason(rule="time_limit", message="Time was up before a schedule was complete.")] = None
            break
        if draft.reasons:
            failures.update(dict.fromkeys(draft.reasons))
        elif best is None or draft.value < best.value:
            best = draft
        control.report(Progress("scheduling", number + 1, int(best is not None), seconds(problem.bounds.makespan)))
    return best, list(failures)


def _unbeatable(draft: Draft, problem: Problem) -> bool:
    return draft.makespan == problem.bounds.makespan and draft.metres == 0


def _rules(problem: Problem, alternative: Alternative, runs: int, seed: int) -> Iterator[Rule]:
    """Ways of deciding: the plain ones, allocation's witness, then variations; if all fail, fixed bindings."""
    witness = {
        problem.staffing.group_of[one.role]: one.robot for one in alternative.witness if one.role in problem.graph.roles
    }
    yield Rule("joint")
    yield Rule("bundle")
    yield Rule("none")
    if witness:
        yield from (Rule(crew, binding=witness) for crew in _CREWS)
    spread = max(1, problem.bounds.makespan // 4)
    yield from (Rule(crew, patience) for patience in (spread // 16, spread // 4, spread) for crew in _CREWS[:2])
    rng = random.Random(seed)  # noqa: S311 - variation, not secrecy
    for number in range(runs):
        jitter = {activity: rng.randrange(spread) for activity in range(len(problem.graph.activities))}
        binding = witness if number % 4 == 3 else {}
        yield Rule(_CREWS[number % 3], rng.choice((0, 0, spread // 16, spread // 4)), jitter, binding)
    for binding in islice(_bindings(problem), MAX_BINDINGS):
        yield from (Rule(crew, binding=binding) for crew in _CREWS[:2])


def _bindings(problem: Problem) -> Iterator[dict[int, str]]:
    """Every way of giving the groups of roles a robot, up to the first few types' interchangeable ones."""
    groups = sorted(problem.staffing.members)
    if len(groups) > 16:
        return
    robots = [
        [robot.id for robot in problem.fleet.by_id[problem.staffing.type_of[group]].members[: len(groups)]]
        for group in groups
    ]
    for chosen in product(*robots):
        yield dict(zip(groups, chosen, strict=True))


def _unknown(problem: Problem, alternative: Alternative, failures: list[Reason]) -> Schedule:
    return Schedule(
        rank=alternative.rank,
        status="unknown",
        certificate=Certificate(
            claim="unproven",
            method="serial_generation",
            bound=seconds(problem.bounds.makespan),
            detail="No run found a schedule, and nothing proves that there is none.",
        ),
        reasons=tuple(failures[:8]),
    )


def _schedule(problem: Problem, alternative: Alternative, draft: Draft) -> Schedule:
    bound = problem.bounds.makespan
    optimal = draft.makespan == bound
    name = problem.bounds.method.replace("_", " ")
    detail = (
        f"The makespan equals the lower bound by {name}."
        if optimal
        else f"No schedule is shorter than {seconds(bound):g} s, the lower bound by {name}."
    )
    return Schedule(
        rank=alternative.rank,
        status="optimal" if optimal else "feasible",
        certificate=Certificate(
            claim="proven" if optimal else "bounded", method=problem.bounds.method, bound=seconds(bound), detail=detail
        ),
        assignments=tuple(Assignment(role, robot) for role, robot in draft.robot_of.items()),
        actions=tuple(
            ScheduledAction(leaf=one.leaf, robot=one.robot, start_s=seconds(one.start), end_s=seconds(one.end))
            for one in draft.done
        ),
        legs=_legs(problem, draft),
        makespan_s=seconds(draft.makespan),
        assumptions=_assumptions(problem, draft),
    )


def _legs(problem: Problem, draft: Draft) -> tuple[TravelLeg, ...]:
    legs = [leg for one in draft.done if (leg := _leg(one, problem.graph.tree.action(one.leaf).moves)) is not None]
    return tuple(sorted(legs, key=lambda leg: (leg.start_s, leg.leaf, leg.robot)))


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
    for one in draft.done:
        kind = problem.fleet.type_of[one.robot]
        trip = one.trip
        if trip is None or trip.destination is None:
            continue
        if trip.origin is None:
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
        elif trip.metres and not problem.trips.speed_known(kind.id):
            reasons.setdefault(
                ("speed_unknown", kind.id),
                Reason(
                    rule="speed_unknown",
                    message=f"How fast {kind.label} travels is not known; ways to actions take no time, moves their nominal duration.",
                    severity="assumption",
                    robot=kind.id,
                    needed="max_speed_mps",
                    hint="Give the type the limit max_speed_mps.",
                ),
            )
    return tuple(reasons[key] for key in sorted(reasons))
