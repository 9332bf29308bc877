"""Who waits for room at a charger: on the chain, in rows, and what more room there would bring. All times are derived by hand."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.explaining.enlarging import with_plugs
from missiontree.explaining.shortening import why_so_long
from missiontree.mission.charger import Charger
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.plan import Plan
from missiontree.mission.terms import Terms
from missiontree.reporting.critical.chain import chain_of
from missiontree.reporting.critical.parts import parts_of
from missiontree.reporting.gantt.reading import content_of
from missiontree.scheduling.greedy import greedy
from tests.reporting.charts import plan_of
from tests.scheduling.instances import Part, at, mission, robots, scene, work


def planned(plug_m: float, comes_s: float = 0.0, room: int = 1) -> Plan:
    """
    Two robots at 0 with 20 J, r2 from a moment on; each works for 10 s, with 10 J, 20 m to one side of the charger; a metre takes 1 J.

    The charger gives 1 J in a second. Whoever leaves it for a job needs 20 + 10 J.
    """
    instance = mission(
        [Part(name, "r", [work(10, at=name.lower(), uses={"energy_j": 10.0})]) for name in ("A", "B")],
        [("A", "B", "different_robot")],
    )
    plug = Charger(id="plug", label="Big Plug", position=at(plug_m), rate_per_s=1, capacity=room)
    kind = robots(
        "r",
        speed=1.0,
        robots=(
            Robot(id="r1", position=at(0), remaining={"energy_j": 20.0}),
            Robot(id="r2", position=at(0), remaining={"energy_j": 20.0}, available_from_s=comes_s),
        ),
        limits={"energy_j": 100.0},
        uses_per_m={"energy_j": 1.0},
    )
    world = replace(scene(a=plug_m + 20, b=plug_m - 20), chargers=(plug,))
    fleet = Fleet((kind,))
    result = greedy(instance.tree, instance.alternative, fleet, world, Control(), Terms(chargers=(plug,)))
    alternative = replace(instance.alternative, utility=2.0)
    plan = plan_of(replace(instance, alternative=alternative), result, fleet)
    return replace(plan, brief=replace(plan.brief, scene=world))


def told(plan: Plan) -> list[tuple[str, str, float, float, str]]:
    steps = chain_of(plan, plan.schedules[0]).steps
    return [(step.kind, step.robot, step.start_s, step.end_s, step.bond) for step in steps]


@pytest.mark.parametrize(
    ("plug_m", "comes_s", "refilled_s", "again_s"),
    [
        (0.0, 0.0, 10.0, 20.0),  # there at once, 10 J are missing: 0 to 10 s, and 10 to 20 s
        (0.0, 3.0, 10.0, 20.0),  # the second comes at 3 s, and waits until 10 s all the same
        (-5.0, 0.0, 20.0, 35.0),  # there at 5 s with 15 J, 15 J are missing: 5 to 20 s, and 20 to 35 s
    ],
)
def test_the_chain_leads_on_with_who_had_to_leave_the_charger_first(
    plug_m: float, comes_s: float, refilled_s: float, again_s: float
) -> None:
    """Refilling of one, then of the other, then 20 s on the way and 10 s of work."""
    plan = planned(plug_m, comes_s)
    (first, second) = ("r1", "r2") if told(plan)[0][1] == "r1" else ("r2", "r1")
    assert told(plan) == [
        ("refill", first, 0.0, refilled_s, "start"),
        ("refill", second, refilled_s, again_s, "resource"),
        ("travel", second, again_s, again_s + 20, "refill"),
        ("action", second, again_s + 20, again_s + 30, "travel"),
    ]
    parts = parts_of(plan, plan.schedules[0])
    assert [(part.what, part.after) for part in parts[:2]] == [
        ("refilling, the way to the charger included", ""),
        ("refilling", f"once {first} has left Big Plug"),
    ]


@pytest.mark.parametrize(("plug_m", "since_s", "until_s"), [(0.0, 0.0, 10.0), (-5.0, 5.0, 20.0)])
def test_a_wait_for_room_is_shown_where_the_robot_is_there_already_too(
    plug_m: float, since_s: float, until_s: float
) -> None:
    plan = planned(plug_m)
    waits = [wait for row in content_of(plan, plan.schedules[0]).rows for wait in row.waits]
    assert [(wait.start_s, wait.end_s, wait.label) for wait in waits] == [(since_s, until_s, "for room at Big Plug")]


def test_a_wait_begins_when_a_robot_comes() -> None:
    plan = planned(0.0, comes_s=3.0)
    waits = [wait for row in content_of(plan, plan.schedules[0]).rows for wait in row.waits]
    assert [(wait.start_s, wait.end_s) for wait in waits] == [(3.0, 10.0)]


def test_where_there_is_room_for_both_nobody_waits() -> None:
    """Both refill from 0 to 10 s, and are done at 40 s."""
    plan = planned(0.0, room=2)
    assert [step[0] for step in told(plan)] == ["refill", "travel", "action"]
    assert chain_of(plan, plan.schedules[0]).makespan_s == 40
    assert not any(row.waits for row in content_of(plan, plan.schedules[0]).rows)


def test_one_more_place_at_the_charger_shortens_it() -> None:
    """From 50 s to 40 s, by hand; the robots are two already, and one more of them waits as well."""
    plan = planned(0.0)
    (best, *_) = why_so_long(plan, 1).additions
    assert (dict(best.resources), dict(best.robots), best.verdict, best.makespan_s) == (
        {"plug": 1},
        {},
        "shorter",
        40.0,
    )


def test_room_is_made_at_chargers_that_there_are() -> None:
    world = planned(0.0).brief.world
    assert with_plugs(world, "plug", 2).chargers[0].capacity == 3
    with pytest.raises(ValueError, match="no charger 'tap'"):
        with_plugs(world, "tap")
