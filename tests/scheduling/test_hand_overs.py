"""Hand-overs: the giver ends when the taker starts, by every scheduler, with numbers by hand."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.shared_resource import SharedResource
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.hand_overs import HandOvers, hand_overs_of
from missiontree.scheduling.precedence import task_graph
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, times, work

EVERY = pytest.mark.parametrize("scheduler", SCHEDULERS)
LINK = [("give", "take", "hand_over")]


def planned(made: Instance, scheduler: str, *types: RobotType, world: Scene | None = None) -> Schedule:
    return SCHEDULERS[scheduler](made.tree, made.alternative, Fleet(types), world or scene(p=10), Control())


@EVERY
def test_the_giver_waits_for_the_taker(scheduler: str) -> None:
    """The giver is at p (10 m, 2 m/s) after 5 s, the taker (30 m, 2 m/s) after 15 s: 3 s of giving end then, and 4 s of taking begin."""
    made = mission([Part("give", "a", [move("p"), work(3, at="p")]), Part("take", "b", [work(4, at="p")])], LINK)
    types = robots("a", 1, 2.0, position=at(0)), robots("b", 1, 2.0, position=at(40))
    result = planned(made, scheduler, *types)
    assert times(made, result) == {"give.0": (0, 5), "give.1": (12, 15), "take.0": (15, 19)}
    assert (result.status, result.makespan_s) == ("optimal", 19)


@EVERY
def test_the_taker_waits_for_the_giver(scheduler: str) -> None:
    """The giver is at p after 10 s and gives for 3 s; the taker is there after 5 s and starts at 13 s."""
    made = mission([Part("give", "a", [move("p"), work(3, at="p")]), Part("take", "b", [work(4, at="p")])], LINK)
    types = robots("a", 1, 1.0, position=at(0)), robots("b", 1, 2.0, position=at(20))
    result = planned(made, scheduler, *types)
    assert times(made, result) == {"give.0": (0, 10), "give.1": (10, 13), "take.0": (13, 17)}


@EVERY
def test_what_is_brought_moves_on_with_the_taker(scheduler: str) -> None:
    """The box (at 0) is at p (10 m at 1 m/s) after 10 s, if the taker is; it takes it 10 m on, to q: 20 s; and then it is used there."""
    made = mission(
        [
            Part("give", "a", [move("p", "box")]),
            Part("take", "b", [work(2, at="box"), move("q", "box")]),
            Part("use", "c", [work(1, at="box")]),
        ],
        [*LINK, ("take", "use")],
    )
    types = (
        robots("a", 1, 1.0, position=at(0)),
        robots("b", 1, 1.0, position=at(14)),
        robots("c", 1, 1.0, position=at(0)),
    )
    result = planned(made, scheduler, *types, world=scene(p=10, q=20, box=0))
    assert times(made, result) == {"give.0": (0, 10), "take.0": (10, 12), "take.1": (12, 22), "use.0": (22, 23)}


@EVERY
def test_a_move_that_ends_with_a_hand_over_sets_out_late_enough(scheduler: str) -> None:
    """The way to p takes 10 s; the taker is there after 30 s: the giver sets out at 20 s."""
    made = mission([Part("give", "a", [move("p")]), Part("take", "b", [work(2, at="p")])], LINK)
    types = robots("a", 1, 1.0, position=at(0)), robots("b", 1, 1.0, position=at(40))
    result = planned(made, scheduler, *types)
    assert times(made, result) == {"give.0": (20, 30), "take.0": (30, 32)}
    assert [(leg.start_s, leg.end_s) for leg in result.legs if leg.robot == "a-1"] == [(20, 30)]


@EVERY
def test_one_robot_cannot_hand_over_to_itself(scheduler: str) -> None:
    made = mission([Part("give", "a", [work(3, at="p")]), Part("take", "a", [work(4, at="p")])], LINK)
    assert planned(made, scheduler, robots("a", 1)).status in {"infeasible", "unknown"}
    assert planned(made, scheduler, robots("a", 2)).makespan_s == 7


@EVERY
def test_the_giver_is_held_until_it_has_handed_over(scheduler: str) -> None:
    """a gives after 3 s at the earliest, b takes after 8 s of other work before; what a does else comes after 8 s."""
    made = mission(
        [
            Part("give", "a", [work(2, at="p"), work(1, at="p")]),
            Part("take", "b", [work(4, at="p")]),
            Part("first", "b", [work(8)]),
            Part("else", "a", [work(5)]),
        ],
        [*LINK, ("first", "take"), ("give", "else")],
    )
    result = planned(made, scheduler, robots("a"), robots("b"))
    assert times(made, result)["give.1"] == (7, 8)
    assert times(made, result)["else.0"] == (8, 13)


@EVERY
def test_a_precedence_beside_a_hand_over_says_nothing_new(scheduler: str) -> None:
    made = mission(
        [Part("give", "a", [work(3, at="p")]), Part("take", "b", [work(4, at="p")])], [*LINK, ("give", "take")]
    )
    assert planned(made, scheduler, robots("a"), robots("b")).makespan_s == 7


@EVERY
def test_two_in_a_row_are_handed_on(scheduler: str) -> None:
    """a gives to b, which takes 2 s, carries on 3 s, and gives 1 s to c: 3 + 2 + 3 + 1 + 4 s."""
    made = mission(
        [
            Part("give", "a", [work(3, at="p")]),
            Part("take", "b", [work(2, at="p"), work(3), work(1, at="p")]),
            Part("last", "c", [work(4, at="p")]),
        ],
        [*LINK, ("take", "last", "hand_over")],
    )
    assert planned(made, scheduler, robots("a"), robots("b"), robots("c")).makespan_s == 13


@EVERY
def test_giver_and_taker_may_pass_on_what_has_room_for_one(scheduler: str) -> None:
    """Both hold the door; the giver lets go when the taker starts, and a third waits until both are through: 3 + 4 + 2 s."""
    made = mission(
        [
            Part("give", "a", [work(3, at="p", holds=["door"])]),
            Part("take", "b", [work(4, at="p", holds=["door"])]),
            Part("third", "c", [work(2, holds=["door"])]),
        ],
        [*LINK, ("take", "third")],
    )
    world = replace(scene(p=10), resources=(SharedResource(id="door"),))
    result = planned(made, scheduler, robots("a"), robots("b"), robots("c"), world=world)
    assert times(made, result) == {"give.0": (0, 3), "take.0": (3, 7), "third.0": (7, 9)}


@pytest.mark.parametrize(
    ("give", "take", "why"),
    [
        ([work(3, at="p")], [work(4)], "is not done at a place"),
        ([work(3, at="p")], [move("p")], "is not done at a place"),
        ([work(3, at="p")], [work(4, at="q")], "does not end where"),
        ([work(3)], [work(4, at="p")], "does not end where"),
        ([work(3, at="p", open_ended=True)], [work(4, at="p")], "has no end of its own"),
        ([work(3, at="p", sync=0)], [work(4, at="p", sync=0)], "they are done together"),
    ],
)
def test_what_can_never_be_handed_over_is_refused_with_the_reason(
    give: list[dict[str, object]], take: list[dict[str, object]], why: str
) -> None:
    made = mission([Part("give", "a", give), Part("take", "b", take)], LINK)
    result = planned(made, "greedy", robots("a"), robots("b"))
    assert (result.status, result.certificate.method) == ("infeasible", "hand_over")
    (reason,) = result.reasons
    assert reason.rule == "hand_over_unfit"
    assert why in reason.message


def test_a_single_action_cannot_both_take_over_and_hand_over() -> None:
    made = mission(
        [Part(name, "abc"[place], [work(1, at="p")]) for place, name in enumerate(("give", "take", "last"))],
        [*LINK, ("take", "last", "hand_over")],
    )
    (reason,) = planned(made, "greedy", robots("a"), robots("b"), robots("c")).reasons
    assert "both takes over and hands over" in reason.message


def test_what_others_may_take_away_in_between_is_no_place_to_meet_at() -> None:
    """The box stands at p since the giver's move; whether it is still there when the giver gives depends on a third, who moves it."""
    parts = [
        Part("give", "a", [move("p", "box"), work(1)]),
        Part("take", "b", [work(1, at="box")]),
        Part("third", "c", [move("q", "box")]),
    ]
    world, types = scene(p=10, q=20, box=0), (robots("a"), robots("b"), robots("c"))
    (reason,) = planned(mission(parts, LINK), "greedy", *types, world=world).reasons
    assert "may take away in between what they meet at" in reason.message
    ordered = mission(parts, [*LINK, ("take", "third")])
    assert planned(ordered, "greedy", *types, world=world).status != "infeasible"


def test_what_comes_after_the_giver_comes_after_the_taker_has_started() -> None:
    """In the graph: the end of the giver's node is not before the taker's start."""
    made = mission(
        [Part("give", "a", [work(3, at="p")]), Part("take", "b", [work(4, at="p")]), Part("then", "c", [work(1)])],
        [*LINK, ("give", "then")],
    )
    graph = task_graph(made.tree, made.alternative.choices)
    found = hand_overs_of(graph)
    assert isinstance(found, HandOvers)
    give, take, then = (graph.activity_of[made.node[name]] for name in ("give.0", "take.0", "then.0"))
    assert found.taker == {give: take}
    order = graph.order()
    assert order is not None
    before = graph.marks_before(order, {2 * take: 1})
    assert before[2 * then] == 1
