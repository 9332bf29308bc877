"""Shared resources: no more robots at once than there is room for, by every scheduler, with numbers by hand."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from random import Random
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from benchmarks.scheduling_agreement import judge
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.shared_resource import SharedResource
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.room import Hold, first_room, turns
from missiontree.scheduling.sharing import Sharing
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, times, work

EVERY = pytest.mark.parametrize("scheduler", SCHEDULERS)


def shared(made: Instance, scheduler: str, *types: RobotType, world: Scene | None = None, **capacity: int) -> Schedule:
    """The schedule in a world with shared resources by name."""
    resources = tuple(SharedResource(id=name, capacity=room) for name, room in capacity.items())
    there = replace(world or Scene(), resources=resources)
    return SCHEDULERS[scheduler](made.tree, made.alternative, Fleet(types), there, Control())


def parts(*durations_s: float, holds: tuple[str, ...] = ("door",), **more: Any) -> list[Part]:
    """Roles of one action each, named a, b, c, ..."""
    return [
        Part(name, "r", [work(duration_s, holds=holds, **more)])
        for name, duration_s in zip("abcdef", durations_s, strict=False)
    ]


@EVERY
def test_where_there_is_room_for_one_the_other_waits(scheduler: str) -> None:
    """Two robots, 3 s each at one door: 0-3 and 3-6. The critical path is 3 s, the load of two robots 3 s, of the door 6 s."""
    made = mission(parts(3, 3))
    result = shared(made, scheduler, robots("r", 2), door=1)
    assert sorted(times(made, result).values()) == [(0, 3), (3, 6)]
    assert (result.status, result.certificate.method, result.certificate.bound) == ("optimal", "resource_load", 6)


@EVERY
def test_as_many_as_there_is_room_for_hold_it_at_once(scheduler: str) -> None:
    """Three robots, 3 s each, room for two: two at 0-3, the third at 3-6; half of 9 s is 4.5 s, so no more is proven by load."""
    made = mission(parts(3, 3, 3))
    result = shared(made, scheduler, robots("r", 3), door=2)
    assert sorted(times(made, result).values()) == [(0, 3), (0, 3), (3, 6)]


@EVERY
def test_room_for_all_changes_nothing(scheduler: str) -> None:
    made = mission(parts(3, 3))
    assert set(times(made, shared(made, scheduler, robots("r", 2), door=2)).values()) == {(0, 3)}


@EVERY
def test_a_move_holds_all_the_way(scheduler: str) -> None:
    """Two robots go 10 m at 1 m/s and at 2 m/s through one corridor: together 15 s."""
    made = mission([Part("a", "r", [move("p", holds=["door"])]), Part("b", "s", [move("p", holds=["door"])])])
    types = robots("r", 1, 1.0, position=at(0)), robots("s", 1, 2.0, position=at(0))
    result = shared(made, scheduler, *types, world=scene(p=10), door=1)
    assert {end - start for start, end in times(made, result).values()} == {5, 10}
    assert result.makespan_s == 15


@EVERY
def test_nothing_is_held_while_a_robot_waits(scheduler: str) -> None:
    """Two doors, taken in opposite orders, with room for one each: a holds x at 0-2, b holds y at 0-2, then they change over."""
    first = Part("a", "r", [work(2, holds=["x"]), work(2, holds=["y"])])
    second = Part("b", "r", [work(2, holds=["y"]), work(2, holds=["x"])])
    result = shared(mission([first, second]), scheduler, robots("r", 2), x=1, y=1)
    assert (result.status, result.makespan_s) == ("optimal", 4)


@EVERY
def test_an_action_takes_all_that_it_holds_at_once(scheduler: str) -> None:
    """c needs both doors for 2 s, a and b one of them each for 3 s: together before or after, 5 s in all."""
    made = mission(
        [*parts(3, holds=("x",)), Part("b", "r", [work(3, holds=["y"])]), Part("c", "r", [work(2, holds=["x", "y"])])]
    )
    result = shared(made, scheduler, robots("r", 3), x=1, y=1)
    assert (result.status, result.makespan_s) == ("optimal", 5)


@EVERY
def test_joint_work_takes_a_place_for_each_robot(scheduler: str) -> None:
    """Two lift together, 4 s, beside one alone, 3 s: room for two, so 7 s; with room for three, 4 s."""
    pair = [Part(name, "r", [work(4, holds=["lift"], sync=0)]) for name in "ab"]
    made = mission([*pair, Part("c", "r", [work(3, holds=["lift"])])])
    assert shared(made, scheduler, robots("r", 3), lift=2).makespan_s == 7
    assert shared(made, scheduler, robots("r", 3), lift=3).makespan_s == 4


@EVERY
def test_joint_work_of_more_than_there_is_room_for_is_proven_impossible(scheduler: str) -> None:
    made = mission([Part(name, "r", [work(4, holds=["lift"], sync=0)]) for name in "ab"])
    result = shared(made, scheduler, robots("r", 2), lift=1)
    assert (result.status, result.certificate.method) == ("infeasible", "sharing")
    (reason,) = result.reasons
    assert (reason.rule, reason.found, reason.needed) == ("resource_too_small", "capacity 1", "capacity 2")


@EVERY
def test_what_lasts_until_another_ends_holds_until_then(scheduler: str) -> None:
    """u holds the door until b ends; b is after a, which needs the door for 2 s. So a 0-2, u from 2, b 2-5, u until 5; then c, 5-6."""
    made = mission(
        [
            Part("u", "r", [work(0, open_ended=True, holds=["door"])]),
            Part("a", "r", [work(2, holds=["door"])]),
            Part("b", "r", [work(3)]),
            Part("c", "r", [work(1, holds=["door"])]),
        ],
        [("u.0", "b", "until"), ("a", "b"), ("b", "c")],
    )
    result = shared(made, scheduler, robots("r", 4), door=1)
    assert times(made, result)["a.0"] == (0, 2)
    assert times(made, result)["u.0"][1] == 5
    assert times(made, result)["u.0"][0] >= 2
    assert (result.makespan_s, result.status) == (6, "optimal")


@EVERY
def test_what_is_held_until_its_own_end_needs_it_is_proven_impossible(scheduler: str) -> None:
    """u holds the door until b ends, and b cannot begin without the door."""
    made = mission(
        [Part("u", "r", [work(0, open_ended=True, holds=["door"])]), Part("b", "r", [work(3, holds=["door"])])],
        [("u.0", "b", "until")],
    )
    result = shared(made, scheduler, robots("r", 2), door=1)
    assert (result.status, result.certificate.method, result.reasons[0].rule) == ("infeasible", "sharing", "deadlock")


@EVERY
def test_what_takes_no_time_does_not_stand_inside_another(scheduler: str) -> None:
    """c takes no time, after b of 1 s; a fills the door for 3 s. At 1 s a is inside, so c is done at 3 s."""
    made = mission([*parts(3), Part("b", "r", [work(1)]), Part("c", "r", [work(0, holds=["door"])])], [("b", "c")])
    result = shared(made, scheduler, robots("r", 3), door=1)
    when = times(made, result)
    assert not when["a.0"][0] < when["c.0"][0] < when["a.0"][1]
    assert result.makespan_s == 3


@st.composite
def held(draw: st.DrawFn) -> list[Hold]:
    """Holds, some without length, some without an end."""
    spans = draw(
        st.lists(st.tuples(st.integers(0, 8), st.integers(0, 4), st.integers(1, 2), st.integers(0, 9)), max_size=5)
    )
    return [Hold(start, None if luck == 0 else start + length, robots) for start, length, robots, luck in spans]


def crowd(holds: list[Hold], half: int) -> int:
    """How many robots hold something at half a tick, counted in halves; what takes no time counts at its moment."""
    count = 0
    for start, end, number in holds:
        until = 10**6 if end is None else end
        inside = 2 * start < half < 2 * until
        count += number if inside or 2 * start == half == 2 * until else 0
    return count


@given(held(), st.integers(1, 3), st.integers(1, 2), st.integers(0, 9), st.one_of(st.none(), st.integers(0, 4)))
def test_the_first_room_is_the_first(
    holds: list[Hold], capacity: int, wanted: int, ready: int, length: int | None
) -> None:
    """Against counting at every half tick: between ticks only what lasts counts, at a tick also what takes no time there."""

    def fits(start: int) -> bool:
        new = Hold(start, None if length is None else start + length, wanted)
        last = 60 if length is None else 2 * (start + length)
        beside = [one for one in holds if one.end is None or one.end > one.start]
        instants = [one for one in holds if one.end == one.start]
        if length == 0:
            return crowd(beside, 2 * start) + wanted <= capacity
        open_halves = range(2 * start + 1, last)
        lasting = all(crowd([*beside, new], half) <= capacity for half in open_halves if half % 2)
        return lasting and all(
            crowd([*beside, new], 2 * one.start) + one.robots <= capacity
            for one in instants
            if 2 * start < 2 * one.start < last
        )

    # what is held already may itself be more than there is room for; then only that there is room is compared
    found = first_room(holds, capacity, wanted, ready, length)
    expected = next((start for start in range(ready, 20) if fits(start)), None)
    assert found == expected


@given(
    st.lists(st.tuples(st.integers(0, 9), st.integers(0, 4), st.integers(1, 2)), min_size=1, max_size=6),
    st.integers(2, 3),
)
def test_turns_keep_room_whatever_the_times(spans: list[tuple[int, int, int]], capacity: int) -> None:
    """Actions put down anew, each as soon as those that it waits for are over, never crowd the resource."""
    sharing = Sharing({"lift": capacity}, {number: {"lift": robots} for number, (_, _, robots) in enumerate(spans)})
    given_spans = {number: (start, start + length) for number, (start, length, _) in enumerate(spans)}
    numbers = sorted(given_spans, key=lambda one: (*given_spans[one], one))
    pairs = turns(sharing, given_spans, in_turn(numbers))
    again: dict[int, tuple[int, int]] = {}
    for number in numbers:
        start = max([again[first][1] for first, second in pairs if second == number], default=0)
        again[number] = start, start + spans[number][1]
    holds = [Hold(*again[number], spans[number][2]) for number in again]
    assert all(crowd(holds, half) <= capacity for half in range(1, 80, 2))


@given(
    st.lists(st.tuples(st.integers(0, 6), st.integers(0, 4), st.integers(1, 2)), min_size=1, max_size=7),
    st.integers(2, 3),
    st.randoms(use_true_random=False),
)
def test_turns_ask_nobody_to_wait_for_what_is_not_over(
    wanted: list[tuple[int, int, int]], capacity: int, luck: Random
) -> None:
    """Whatever the order of unrelated events at one moment: where there is room at these times, turns keep to them."""
    spans, holds = dict[int, tuple[int, int]](), list[Hold]()
    for number, (ready, length, wide) in enumerate(sorted(wanted)):
        start = first_room(holds, capacity, wide, ready, length)
        assert start is not None
        spans[number] = start, start + length
        holds.append(Hold(start, start + length, wide))
    sharing = Sharing({"lift": capacity}, {number: {"lift": hold.robots} for number, hold in enumerate(holds)})
    events = [(time, luck.random(), 2 * one + end) for one, span in spans.items() for end, time in enumerate(span)]
    order = {event: place for place, (_, _, event) in enumerate(sorted(events))}
    pairs = turns(sharing, spans, order)
    assert all(spans[first][1] <= spans[second][0] for first, second in pairs)


def in_turn(activities: list[int]) -> dict[int, int]:
    """An order of events in which one activity is wholly before the next."""
    return {2 * one + event: 2 * place + event for place, one in enumerate(activities) for event in (0, 1)}


def test_places_are_passed_on_in_order_of_the_starts() -> None:
    """Room for one: each waits for the one before it, and for nobody else."""
    sharing = Sharing({"door": 1}, {number: {"door": 1} for number in range(3)})
    order = [2, 0, 1]
    spans = {number: (3 * place, 3 * place + 3) for place, number in enumerate(order)}
    assert turns(sharing, spans, in_turn(order)) == list(pairwise(order))


def test_what_lasts_until_another_ends_does_not_make_way_for_it() -> None:
    """
    Room for two: activity 0 lasts until activity 2 ends, at 4, where that takes no time; activity 1 is there from 0 to 3. So 2 takes the
    place of 1, though that of 0 is the one that is given up last.
    """
    sharing = Sharing({"lift": 2}, {number: {"lift": 1} for number in range(3)})
    spans = {0: (0, 4), 1: (0, 3), 2: (4, 4)}
    events = [0, 2, 3, 4, 5, 1]  # 2 begins and ends, then 0 ends
    assert turns(sharing, spans, {event: place for place, event in enumerate(events)}) == [(1, 2)]


def test_the_campaign_s_case_of_a_lift_given_up_at_one_moment_is_closed() -> None:
    """One robot in two roles one after the other, both ending where a third, which lasts until one of them ends, gives up the lift."""
    assert judge(11, 6662).violations == ()


def test_the_campaign_s_case_of_an_answer_that_nobody_can_play_through_is_closed() -> None:
    """A door is held until something ends that needs it in no time; what is tried out anyway is found, and not called shortest."""
    assert judge(50, 50425).violations == ()


def test_the_campaign_s_case_of_a_door_passed_through_in_no_time_is_closed() -> None:
    """What is moved in no time, through a door with room for two, once somebody has begun at it who keeps the other place."""
    assert judge(49, 4502).violations == ()


@pytest.mark.parametrize("number", [17_628, 125_466])
def test_what_takes_no_time_has_room_in_the_model_and_in_trials_only_where_it_can_be_played_through(
    number: int,
) -> None:
    """A lift with room for two, both of whom hold it before and after; a door that whoever begins just then, and must, keeps."""
    assert judge(51, number).violations == ()


@pytest.mark.parametrize("number", [806, 856])
def test_what_happens_at_one_moment_is_taken_alike_by_schedulers_and_checkers(number: int) -> None:
    """A box that is moved on in no time just before joint work at it; something of no length at the moment of a hand-over."""
    assert judge(202, number).violations == ()
