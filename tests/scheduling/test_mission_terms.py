"""Schedules under rules for the whole mission: totals, stock, robots in use, who is left out and who must take part."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import Terms
from missiontree.scheduling.greedy import greedy
from tests.scheduling.brute_force import keeps_terms, least_makespan
from tests.scheduling.instances import Instance, Part, at, mission, robot_of, robots, scene, work
from tests.scheduling.strategies import fleets, instances, plane
from tests.scheduling.validator import faults

SLOW = settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)


@st.composite
def ruled(draw: st.DrawFn) -> tuple[Instance, Fleet, Terms]:
    """A small instance with a fleet, of which some robots are left out, some required, and so many in use."""
    instance, fleet = draw(instances()), draw(fleets())
    types = tuple(replace(kind, max_in_use=draw(st.sampled_from([None, 1]))) for kind in fleet.types)
    fleet = replace(fleet, types=types)
    out = tuple(kind.members[-1].id for kind in fleet.types if len(kind.members) > 1 and draw(st.integers(0, 3)) == 0)
    left = [robot for robot in fleet.robots if robot not in out]
    asked = draw(st.lists(st.sampled_from([*left, *fleet.by_id]), max_size=2, unique=True))
    return instance, fleet, Terms(without=out, require=tuple(asked))


@SLOW
@given(ruled())
def test_claims_under_terms_agree_with_brute_force(problem: tuple[Instance, Fleet, Terms]) -> None:
    """Schedules keep the terms; bound <= optimum <= makespan; what is called infeasible is."""
    instance, fleet, terms = problem
    result = greedy(instance.tree, instance.alternative, fleet, plane(), Control(), terms)
    optimum = least_makespan(instance, fleet, plane(), terms)
    if result.status in {"optimal", "feasible"}:
        assert faults(instance, fleet, plane(), result) == []
        assert keeps_terms({one.robot for one in result.assignments}, fleet, terms)
        assert optimum is not None
        assert result.certificate.bound is not None
        assert round(result.certificate.bound * 1000) <= optimum <= round(result.makespan_s * 1000)
    elif result.status == "infeasible" and result.reasons[0].rule != "cycle":
        assert optimum is None
    else:
        assert optimum is None or result.reasons[0].rule == "cycle"  # every binding is tried at this size


def under(instance: Instance, fleet: Fleet, terms: Terms | None = None, world: Scene | None = None) -> Schedule:
    return greedy(instance.tree, instance.alternative, fleet, world or Scene(), Control(), terms or Terms())


def parts(*uses: float, name: str = "coins") -> Instance:
    """Roles of one action of 1 s each, by types r and s in turn."""
    return mission([Part(f"p{i}", "rs"[i % 2], [work(1, uses={name: use})]) for i, use in enumerate(uses)])


def test_a_total_for_the_mission_counts_all_types() -> None:
    """3 + 3 coins: 5 are too few, which is proven; 6 do."""
    few = Fleet((robots("r"), robots("s")), total_limits={"coins": 5})
    result = under(parts(3, 3), few)
    assert (result.status, result.certificate.method) == ("infeasible", "budget_bound")
    assert result.reasons[0].message == "The mission needs at least 6 of coins; all robots together may use 5."
    assert under(parts(3, 3), replace(few, total_limits={"coins": 6})).status == "optimal"


def test_a_stock_counts_all_types_too() -> None:
    fleet = Fleet((robots("r"), robots("s")))
    assert under(parts(1, 1, 1), fleet, Terms(stock={"coins": 2})).status == "infeasible"
    assert under(parts(1, 1, 1), fleet, Terms(stock={"coins": 3})).status == "optimal"


def test_ways_are_taken_off_what_all_robots_share() -> None:
    """10 m out at 1 J a metre, by each of two: 20 J. With 15 J no bound proves that there is no schedule, but trying everything does."""
    made = mission([Part("a", "r", [work(1, at="p")]), Part("b", "s", [work(1, at="p")])])
    kinds = (robots(name, speed=1, position=at(0), uses_per_m={"energy_j": 1.0}) for name in "rs")
    fleet = Fleet(tuple(kinds), total_limits={"energy_j": 20})
    assert under(made, fleet, world=scene(p=10)).status in {"optimal", "feasible"}
    result = under(made, replace(fleet, total_limits={"energy_j": 15}), world=scene(p=10))
    assert (result.status, result.certificate.method, result.assignments) == ("infeasible", "enumeration", ())


def test_no_more_robots_work_than_may_be_in_use() -> None:
    """Four roles of 1 s: four robots take 1 s, two of them 2 s, and that is proven by their load."""
    made = mission([Part(name, "r", [work(1)]) for name in "abcd"])
    assert under(made, Fleet((robots("r", 4),))).makespan_s == 1
    result = under(made, Fleet((robots("r", 4, max_in_use=2),)))
    assert (len(set(robot_of(made, result).values())), result.makespan_s, result.status) == (2, 2, "optimal")


def test_a_team_larger_than_what_may_be_in_use_is_proven_impossible() -> None:
    made = mission([Part("a", "r", [work(1)], 0), Part("b", "r", [work(1)], 0)])
    result = under(made, Fleet((robots("r", 3, max_in_use=1),)))
    assert (result.status, result.certificate.method) == ("infeasible", "staffing")
    assert "there are 1 that may be in use" in result.reasons[0].message


def test_who_must_take_part_works_though_it_stands_far_off() -> None:
    """far comes 50 m at 1 m/s, near 0 m; left alone, near does the 1 s of work."""
    kind = robots("r", speed=1, robots=(Robot(id="near", position=at(0)), Robot(id="far", position=at(50))))
    made = mission([Part("a", "r", [work(1, at="p")])], witness={"a": "far"})
    assert robot_of(made, under(made, Fleet((kind,)), world=scene(p=0))) == {"a": "near"}
    result = under(made, Fleet((kind,)), Terms(require=("far",)), scene(p=0))
    assert (robot_of(made, result), result.makespan_s) == ({"a": "far"}, 51)


def test_a_schedule_that_leaves_out_who_must_take_part_is_none() -> None:
    """Both must, and there is one role: proven."""
    made = mission([Part("a", "r", [work(1)])])
    result = under(made, Fleet((robots("r", 2),)), Terms(require=("r-1", "r-2")))
    assert (result.status, result.reasons[0].rule) == ("infeasible", "required_idle")


def test_a_required_type_that_the_alternative_does_not_take_is_proven_impossible() -> None:
    made = mission([Part("a", "r", [work(1)])])
    result = under(made, Fleet((robots("r"), robots("s"))), Terms(require=("s",)))
    assert (result.status, result.reasons[0].robot) == ("infeasible", "s")


def test_who_is_left_out_does_nothing_and_its_place_counts_for_nothing() -> None:
    """near would be there at once; far takes 50 s and 1 s of work, and no bound is lower."""
    kind = robots("r", speed=1, robots=(Robot(id="near", position=at(0)), Robot(id="far", position=at(50))))
    made = mission([Part("a", "r", [work(1, at="p")])])
    result = under(made, Fleet((kind,)), Terms(without=("near",)), scene(p=0))
    assert (robot_of(made, result), result.makespan_s, result.status) == ({"a": "far"}, 51, "optimal")
