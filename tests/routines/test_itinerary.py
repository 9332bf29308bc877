"""Travel through a role: the approach is an estimate, the way inside is certain where nothing else moves its ends."""

from __future__ import annotations

from typing import Any

from missiontree.mission.area import Area, KeepOut
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Capability, CostModel, DurationModel, Fleet, Robot, RobotType
from missiontree.mission.grounded import Action
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from tests.builders import (
    actions_of,
    flat_tree,
    grounding_of,
    paper_fleet,
    routine_node,
    trivial_fleet,
    with_type,
)

CRATE = Entity(id="crate", position=Position(30, 40))
DOCK = Entity(id="dock", kind="place", position=Position(30, 100))


def measured(**tug: Any) -> list[Action]:
    fleet = Fleet(
        (
            RobotType(
                id="tug",
                **{
                    "count": 1,
                    "position": Position(0, 0),
                    "capabilities": {"reach": 0.5, "carry": 0.9},
                    "limits": {"max_speed_mps": 2.0, "energy_j": 1000},
                    "uses_per_m": {"energy_j": 3},
                    **tug,
                },
            ),
        )
    )
    tree = flat_tree(routine_node("n", "ReachAndTransport", agent="crate", location="dock"))
    return actions_of(grounding_of(tree, fleet=fleet, scene=Scene(places=(DOCK,), entities=(CRATE,))).tree)


def test_estimates_count_the_approach_and_bounds_do_not() -> None:
    get, go, carry, bring = measured()
    # From (0, 0) to the crate at (30, 40): 50 m at 2 m/s. From there to the dock at (30, 100): 60 m.
    assert [each.estimate.duration_s for each in (get, go, carry, bring)] == [5, 25, 20, 30]
    # The approach may be shorter when the time comes; the way with the crate is certain: 60 m * 3 J/m.
    assert [dict(each.uses_at_least) for each in (get, go, carry, bring)] == [{}, {}, {}, {"energy_j": 180}]
    assert dict(bring.uses) == {}
    assert (bring.at, bring.brings, bring.moves, bring.duration_s) == ("dock", ("crate",), True, 60)


def test_the_nearest_robot_counts() -> None:
    robots = (Robot(id="far", position=Position(0, 0)), Robot(id="near", position=Position(30, 30)), Robot(id="lost"))
    assert measured(count=None, position=None, robots=robots)[1].estimate.duration_s == 5  # 10 m at 2 m/s


def test_without_a_speed_moves_take_their_nominal_time_and_metres_still_cost() -> None:
    _, go, _, bring = measured(limits={})
    assert (go.estimate.duration_s, bring.estimate.duration_s) == (60, 60)
    assert dict(bring.uses_at_least) == {"energy_j": 180}


def test_without_a_start_the_first_move_takes_its_nominal_time() -> None:
    _, go, _, bring = measured(position=None)
    assert (go.estimate.duration_s, bring.estimate.duration_s) == (60, 30)


def test_duration_and_cost_models() -> None:
    carry = Capability(0.9, DurationModel(scale=2, plus_s=1), CostModel(fixed=10, per_s=0.5, per_m=0.1))
    _, _, lift, bring = measured(capabilities={"reach": 0.5, "carry": carry})
    # Carry: 1 + 2 * 20 = 41 s, cost 10 + 0.5 * 41. Bring: 30 s of travel, cost 10 + 0.5 * 30 + 0.1 * 60.
    assert (lift.estimate.duration_s, lift.estimate.cost, lift.duration_s) == (41, 30.5, 41)
    assert (bring.estimate.duration_s, bring.estimate.cost, bring.duration_s) == (30, 31, 121)


def test_a_way_with_something_that_others_move_is_not_certain() -> None:
    fleet = with_type(paper_fleet(), "transportation_robot", uses_per_m={"energy_j": 3})
    nodes = [routine_node(f"n{i}", "ReachAndTransport", agent="crate", location="dock") for i in range(2)]
    grounding = grounding_of(flat_tree(*nodes), fleet=fleet, scene=Scene(places=(DOCK,), entities=(CRATE,)))
    assert all(not each.uses_at_least for each in actions_of(grounding.tree))


def test_a_type_that_can_never_get_there_is_refused() -> None:
    ring = [
        Area(corners=c)
        for c in (
            ((20, 20), (40, 20), (40, 25), (20, 25)),
            ((20, 55), (40, 55), (40, 60), (20, 60)),
            ((20, 20), (25, 20), (25, 60), (20, 60)),
            ((35, 20), (40, 20), (40, 60), (35, 60)),
        )
    ]
    scene = Scene(
        entities=(CRATE,),
        keep_outs=tuple(KeepOut(id=f"wall{i}", area=area, types=("tug",)) for i, area in enumerate(ring)),
    )
    fleet = trivial_fleet(["tug", "drone"], capabilities={"reach": 1}, position=Position(0, 0))
    grounding = grounding_of(flat_tree(routine_node("n", "Reach", agent="crate")), fleet=fleet, scene=scene)
    assert {each.robot_type for each in actions_of(grounding.tree)} == {"drone"}
    assert [(reason.rule, reason.robot, reason.node) for reason in grounding.not_offered] == [
        ("unreachable", "tug", "n")
    ]
