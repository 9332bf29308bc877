"""Why a schedule is as long as it is, in words: the parts of its chain, each with what it waits for."""

from itertools import pairwise

from hypothesis import given, settings

from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.reporting.critical.chain import chain_of
from missiontree.reporting.critical.parts import parts_of
from missiontree.reporting.critical.spans import ms
from missiontree.reporting.critical.view import chain_view, title_and_view, title_of
from missiontree.reporting.text import plan_text, render
from tests.checking.plans import refilling
from tests.reporting.charts import planned, plans
from tests.scheduling.instances import Part, at, mission, move, robots, scene, work


def lines(plan: Plan, most: int | None = None) -> list[str]:
    return [" ".join(line.split()) for line in render(chain_view(plan, plan.schedules[0], most)).splitlines()]


def title(plan: Plan) -> str:
    return title_of(chain_of(plan, plan.schedules[0]), "alternative 1")


def test_what_a_robot_does_in_one_role_is_one_part_with_the_way_in_it() -> None:
    """3 s to p at 2 m/s, 5 s and 4 s of work; then B, 2 s, by another robot."""
    instance = mission([Part("A", "a", [work(5, at="p"), work(4)]), Part("B", "b", [work(2)])], [("A", "B")])
    plan = planned(instance, Fleet((robots("a", speed=2.0, position=at(0)), robots("b"))), scene(p=6))
    assert title(plan) == "Why alternative 1 takes 14 s: 11 s of work and 3 s on the way, one after the other"
    assert lines(plan) == ["0 to 12 s a-1 A, 3 s of it on the way", "12 to 14 s b-1 B; after a-1: A.1"]


def test_a_busy_robot_is_told_as_what_is_waited_for() -> None:
    plan = planned(mission([Part("A", "a", [work(3)]), Part("B", "a", [work(4)])]), Fleet((robots("a"),)))
    assert {line.partition("; ")[2] for line in lines(plan)} == {"", "once a-1 is free"}


def test_the_way_to_a_charger_is_on_the_way_and_the_visit_is_not() -> None:
    """
    20 m to the pump, 14.142 m to the charger, as much to the tank, 20 m home, at 1 m/s: 68.284 s. Twice 20 s of work. A metre takes 1 J.

    What the ways and both inspections take, 168.284 J, is 68.284 J more than the 100 there are: 13.657 s at 5 J/s.
    """
    plan = refilling()
    assert title(plan) == (
        "Why alternative 1 takes 121.9 s: 40 s of work, 68.3 s on the way and 13.7 s of refilling and waiting, one after the other"
    )


def test_a_release_and_a_late_robot_are_waited_for_by_name() -> None:
    released = mission([Part("A", "a", [work(2)])]).timed(A=(4, None))
    plan = planned(released, Fleet((robots("a"),)))
    assert title(plan) == "Why alternative 1 takes 6 s: 2 s of work and 4 s of waiting, one after the other"
    assert lines(plan)[0] == "0 to 4 s a-1 nothing: A.0 may not start before"
    late = planned(mission([Part("A", "a", [work(2)])]), Fleet((robots("a", available_from_s=4.0),)))
    assert lines(late)[0] == "0 to 4 s a-1 nothing: A.0 waits for a robot that comes then"


def test_joint_work_names_who_is_waited_for() -> None:
    instance = mission([Part("A", "a", [work(2), work(3, sync=0)]), Part("B", "b", [work(7), work(3, sync=0)])])
    plan = planned(instance, Fleet((robots("a"), robots("b"))))
    assert lines(plan)[-1] == "7 to 10 s a-1 A; for joint work, after b-1: B.0"


def test_a_part_that_is_nothing_but_travel_says_so() -> None:
    plan = planned(mission([Part("A", "a", [move("p")])]), Fleet((robots("a", speed=2.0, position=at(0)),)), scene(p=6))
    assert title(plan) == "Why alternative 1 takes 3 s: 3 s on the way"
    assert lines(plan) == ["0 to 3 s a-1 A, all of it on the way"]


def test_of_a_long_chain_both_ends_are_told_beside_other_things() -> None:
    """Twenty roles of one second one after the other; four lines of them, and how many are left out."""
    names = [f"P{number:02d}" for number in range(20)]
    instance = mission([Part(name, "a", [work(1)]) for name in names], list(pairwise(names)))
    plan = planned(instance, Fleet((robots("a"),)))
    shown = lines(plan, 4)
    assert [line.split()[5].rstrip(";") for line in shown[:2] + shown[3:]] == ["P00", "P01", "P18", "P19"]
    assert shown[2] == "… 16 more; missiontree show --why-so-long tells all of them"
    assert len(lines(plan)) == 20


def test_the_whole_plan_says_why_it_takes_so_long() -> None:
    plan = planned(mission([Part("A", "a", [work(3)])]), Fleet((robots("a"),)))
    assert "Why alternative 1 takes 3 s: 3 s of work\n  0 to 3 s  a-1  A\n" in plan_text(plan)


def test_where_nothing_takes_time_nothing_is_told() -> None:
    plan = planned(mission([Part("A", "a", [work(0)])]), Fleet((robots("a"),)))
    assert title_and_view(plan, plan.schedules[0], "it")[1] == []
    assert "Why alternative" not in plan_text(plan)


@given(plans())
@settings(max_examples=40)
def test_parts_follow_each_other_without_a_gap(plan: Plan) -> None:
    parts = parts_of(plan, plan.schedules[0])
    assert sum(ms(part.end_s) - ms(part.start_s) for part in parts) == ms(plan.schedules[0].makespan_s)
    assert all(before.end_s == after.start_s for before, after in pairwise(parts))
    assert all(0 <= ms(part.travel_s) <= ms(part.end_s) - ms(part.start_s) for part in parts)
