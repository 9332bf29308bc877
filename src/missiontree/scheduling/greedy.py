"""
Greedy list scheduling: instant, honest about what it proves.

First what cannot be is proven: a cycle, a place out of reach, a budget too small, a deadline too soon, robots that must be one and
two. Then a few deterministic runs of serial schedule generation (:mod:`missiontree.scheduling.runs`) with different rules, and the best of
them is kept. If its makespan equals a lower bound it is optimal. If not, and the mission is so small that everything can be tried out in
few steps (:mod:`missiontree.scheduling.enumeration`), that is done, and proves what is best. Further runs follow: many where nothing is
proven, and a moment of large neighbourhood search (:mod:`missiontree.scheduling.neighbourhood`); else a few for the sake of shorter ways.
"""

from __future__ import annotations

from missiontree.mission.alternative import Alternative
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.mission.ticks import ticks_within
from missiontree.scheduling.alike import alike_roles
from missiontree.scheduling.approach_budget import approaches_too_dear
from missiontree.scheduling.availability import gone_before, least_holds, some_leave
from missiontree.scheduling.bounds import lower_bounds
from missiontree.scheduling.bundles import bundles_of, crews_of
from missiontree.scheduling.chargers import chargers_of
from missiontree.scheduling.deadlines import deadlines_out_of_reach
from missiontree.scheduling.hand_overs import HandOvers, hand_overs_of
from missiontree.scheduling.holding import order_held_roles
from missiontree.scheduling.homing import home_too_late, never_home
from missiontree.scheduling.impossible import budgets_exceeded, cycle_reason, group_needs, unreachable_places
from missiontree.scheduling.mission_terms import required_in_vain, shared_by_all, shared_exceeded
from missiontree.scheduling.neighbourhood.shortly import regroup_shortly
from missiontree.scheduling.overlap import overlaps_of_one_robot
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import task_graph
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.recharging import never_enough
from missiontree.scheduling.runs import MAX_RUNS, Runs
from missiontree.scheduling.settling import settled
from missiontree.scheduling.sharing import order_open_ended, sharing_of, too_crowded
from missiontree.scheduling.staffing import staffing_conflicts, staffing_of
from missiontree.scheduling.trips import Trips
from missiontree.scheduling.writing import (
    found_schedule,
    impossible_schedule,
    no_schedule,
    unknown_schedule,
)

FIRST_RUNS = 6  # before everything is tried out
IN_VAIN = 12  # further runs that change nothing, after which it is taken that no way gets shorter
FEW_STEPS = 1_000  # of trying everything out


def greedy(
    tree: GroundedTree,
    alternative: Alternative,
    fleet: Fleet,
    scene: Scene,
    control: Control,
    terms: Terms = NO_TERMS,
) -> Schedule:
    """Schedule an alternative, see :class:`missiontree.scheduling.scheduler.Scheduler`."""
    problem = read_problem(tree, alternative, terms.team_of(fleet), scene, terms)
    if not isinstance(problem, Problem):
        return impossible_schedule(alternative, *problem)
    runs = Runs(problem, alternative, control)
    runs.go(FIRST_RUNS, anyway=True)
    proof = _tried(runs, control)
    if proof is not None or runs.shortest:
        if runs.best is not None:
            runs.go(MAX_RUNS, IN_VAIN)
    else:
        before = runs.best
        runs.go(MAX_RUNS)
        regroup_shortly(runs, control)
        if runs.best is not None and (before is None or runs.best.makespan < before.makespan):
            proof = _tried(runs, control)
    runs.refill_for_tours()
    if runs.best is not None:
        return found_schedule(problem, alternative, runs.best, proof)
    if proof is not None:
        return no_schedule(alternative, proof, runs.failures)
    return unknown_schedule(problem, alternative, runs.failures)


def _tried(runs: Runs, control: Control) -> Certificate | None:
    """The certificate of having tried everything that could be shorter, if that took few steps."""
    return None if runs.shortest else settled(runs, FEW_STEPS, control.ended)


def read_problem(
    tree: GroundedTree, alternative: Alternative, fleet: Fleet, scene: Scene, terms: Terms
) -> Problem | tuple[str, list[Reason]]:
    """The problem, or the method and the reasons of the proof that it cannot be solved."""
    graph = task_graph(tree, alternative.choices)
    hand_overs = hand_overs_of(graph)
    if not isinstance(hand_overs, HandOvers):
        return "hand_over", hand_overs
    if graph.order() is None:
        return "precedence", [cycle_reason(graph, rule="cycle", why="Each of these waits for the one before it")]
    staffing = staffing_of(graph)
    if reasons := [*staffing_conflicts(graph, staffing, fleet), *required_in_vain(staffing, fleet, terms)]:
        return "staffing", reasons
    if reasons := overlaps_of_one_robot(graph, staffing, fleet):
        return "overlap", reasons
    sharing = sharing_of(graph, scene)
    if reasons := too_crowded(graph, sharing, scene):
        return "sharing", reasons
    order = order_held_roles(graph, staffing, fleet)
    if order is not None and order_open_ended(graph, sharing, hand_overs, order):
        order = order_held_roles(graph, staffing, fleet)
        if order is None:
            why = "A shared resource would be held while waiting for an action that needs it, too"
            return "sharing", [cycle_reason(graph, rule="deadlock", why=why)]
    if order is None:
        why = "One robot would be held in a role while waiting for another role that only it can fill"
        return "holding", [cycle_reason(graph, rule="deadlock", why=why)]
    trips = Trips(fleet, scene)
    places = Places(graph, order, trips)
    back = never_home(graph, places, trips) if terms.return_home else []
    if reasons := [*unreachable_places(graph, places, fleet, trips), *back]:
        return "reachability", reasons
    needs, shared, chargers = (
        group_needs(graph, staffing),
        shared_by_all(fleet, terms),
        chargers_of(fleet, scene, terms),
    )
    too_much = [*budgets_exceeded(graph, staffing, fleet, chargers), *shared_exceeded(needs, shared)]
    too_much += never_enough(graph, places, trips, chargers, terms.return_home)
    if reasons := [*too_much, *approaches_too_dear(graph, places, trips, terms.return_home, chargers)]:
        return "budget_bound", reasons
    returning, home_by = terms.return_home, None if terms.home_by_s is None else ticks_within(terms.home_by_s)
    bounds = lower_bounds(graph, order, staffing, places, fleet, trips, sharing, returning, chargers)
    late = [*deadlines_out_of_reach(graph, staffing, bounds, fleet), *gone_before(graph, bounds, fleet)]
    if reasons := late or home_too_late(bounds, home_by):
        return "deadline_bound", reasons
    alike = alike_roles(graph, staffing, needs)
    bundles, crews, required = bundles_of(graph, hand_overs), crews_of(graph, hand_overs), terms.required_robots(fleet)
    holds, leaving = least_holds(graph, bounds), some_leave(fleet)
    return Problem(
        graph,
        staffing,
        bounds,
        fleet,
        trips,
        places,
        bundles,
        crews,
        needs,
        alike,
        shared,
        required,
        holds,
        leaving,
        sharing,
        returning,
        home_by,
        hand_overs,
        chargers,
    )
