"""
What is moved in no time at the moment at which somebody comes to it: it may be where it was, or where it is brought.

Robots start at the origin and drive 2 m/s: to the box, 10 m, 5 s; from there to the far corner, 20 m, 10 s; from the origin to the far
corner sqrt(500) = 22.361 m, 11.181 s.
"""

from __future__ import annotations

from dataclasses import replace

from missiontree.checking import check
from missiontree.mission.entity import Entity
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import OwnLeg, TravelLeg
from missiontree.rechecking import recheck
from tests.builders import and_, grounded, leaf
from tests.checking.by_hand import FAR, HERE, SCENE, THERE, by_start, guessing, leg, plan_of, rules, team, times

WORLD = replace(SCENE, places=(*SCENE.places, Entity(id="here", kind="place", position=HERE)))
LOST = replace(WORLD, entities=(*WORLD.entities, Entity(id="lost")))

MOVED = grounded(
    and_(
        leaf("bring", role="x", at="here", moves=True, brings=("box",), duration_s=0),
        leaf("use", role="y", at="box", duration_s=2),
        leaf("rest", role="y", at="far", duration_s=1),
    )
)
IN_NO_TIME = leg(1, 5, 5, HERE, HERE, 0)
TO_BOX = leg(2, 0, 5, HERE, THERE, 10, "r-2")


def test_it_may_be_used_where_it_was_and_the_robot_goes_on_from_there() -> None:
    actions = times((1, "r-1", 5, 5), (2, "r-2", 5, 7), (3, "r-2", 17, 18))
    on = leg(3, 7, 17, THERE, FAR, 20, "r-2")
    assert check(plan_of(MOVED, actions, *by_start(IN_NO_TIME, TO_BOX, on), scene=WORLD)) == ()


def test_it_may_be_used_where_it_is_brought_and_the_robot_goes_on_from_there() -> None:
    actions = times((1, "r-1", 5, 5), (2, "r-2", 5, 7), (3, "r-2", 18.181, 19.181))
    on = leg(3, 7, 18.181, HERE, FAR, 22.361, "r-2")
    assert check(plan_of(MOVED, actions, *by_start(IN_NO_TIME, on), scene=WORLD)) == ()


def test_who_went_to_where_it_was_goes_on_from_nowhere_else() -> None:
    actions = times((1, "r-1", 5, 5), (2, "r-2", 5, 7), (3, "r-2", 18.181, 19.181))
    on = leg(3, 7, 18.181, HERE, FAR, 22.361, "r-2")
    plan = plan_of(MOVED, actions, *by_start(IN_NO_TIME, TO_BOX, on), scene=WORLD)
    assert rules(plan) == ["leg_origin_wrong"]
    assert [one.rule for one in recheck(plan)] == ["core_travel"]


def test_it_is_used_at_no_third_place() -> None:
    actions = times((1, "r-1", 5, 5), (2, "r-2", 5, 7), (3, "r-2", 18.181, 19.181))
    elsewhere = leg(2, 0, 5, HERE, replace(THERE, x_m=9), 9, "r-2")
    plan = plan_of(
        MOVED, actions, *by_start(IN_NO_TIME, elsewhere, leg(3, 7, 18.181, HERE, FAR, 22.361, "r-2")), scene=WORLD
    )
    assert rules(plan) == ["leg_destination_wrong"]
    assert {one.rule for one in recheck(plan)} == {"core_travel"}


def test_a_robot_goes_home_from_where_it_used_it() -> None:
    """Where the box was, 10 m from home, or at home, without a way."""
    tree = grounded(
        and_(
            leaf("bring", role="x", at="here", moves=True, brings=("box",)),
            leaf("use", role="y", at="box", duration_s=2),
        )
    )
    actions = times((1, "r-1", 5, 5), (2, "r-2", 5, 7))
    home = OwnLeg(robot="r-2", start_s=7, end_s=12, origin=THERE, destination=HERE, distance_m=10)
    there = plan_of(tree, actions, *by_start(IN_NO_TIME, TO_BOX), scene=WORLD, returns=(home,))
    assert check(there) == ()
    assert check(plan_of(tree, actions, IN_NO_TIME, scene=WORLD, returns=())) == ()
    stays = plan_of(tree, actions, *by_start(IN_NO_TIME, TO_BOX), scene=WORLD, returns=())
    assert rules(stays) == ["own_leg_missing"]
    assert [one.rule for one in recheck(stays)] == ["core_home"]
    beside = replace(home, origin=FAR, distance_m=22.361, end_s=18.181)
    astray = plan_of(tree, actions, *by_start(IN_NO_TIME, TO_BOX), scene=WORLD, returns=(beside,))
    assert rules(astray) == ["own_leg_misplaced"]
    assert [one.rule for one in recheck(astray)] == ["core_home"]


def test_what_comes_first_by_the_order_of_joint_work_comes_first() -> None:
    """Who looks does so jointly with who uses the box, and before it is brought away; so it is used where it was."""
    tree = grounded(
        and_(
            leaf("look", role="x", sync=0),
            leaf("use", role="y", at="box", sync=0),
            leaf("bring", role="z", at="here", moves=True, brings=("box",)),
        ),
        [("look", "bring")],
    )
    actions = times((1, "r-1", 5, 5), (2, "r-2", 5, 5), (3, "r-3", 5, 5))
    brings = leg(3, 5, 5, HERE, HERE, 0, "r-3")
    assert check(plan_of(tree, actions, *by_start(TO_BOX, brings), fleet=team(3), scene=WORLD)) == ()
    assert rules(plan_of(tree, actions, brings, fleet=team(3), scene=WORLD)) == ["leg_missing"]


def test_one_of_two_places_may_be_unknown() -> None:
    """
    r-1 takes the box somewhere, 60 s, and uses it; r-2 brings it to the origin at that very moment, in no time.

    So r-1 is somewhere, and gets to the far corner in no time, or at the origin, and needs 11.181 s; a move takes its nominal 60 s, or
    those.
    """
    tree = grounded(
        and_(
            leaf("lose", role="x", at="lost", moves=True, brings=("box",), duration_s=60),
            leaf("use", role="x", at="box", duration_s=2),
            leaf("go", role="x", at="far", moves=True, duration_s=60),
            leaf("bring", role="y", at="here", moves=True, brings=("box",)),
        )
    )
    brings = leg(4, 60, 60, HERE, HERE, 0, "r-2")

    def plan(*legs: TravelLeg, until_s: float) -> Plan:
        actions = times((1, "r-1", 0, 60), (2, "r-1", 60, 62), (3, "r-1", 62, until_s), (4, "r-2", 60, 60))
        return guessing(plan_of(tree, actions, *by_start(brings, *legs), scene=LOST), "r-1")

    assert check(plan(leg(3, 62, 73.181, HERE, FAR, 22.361), until_s=73.181)) == ()
    assert check(plan(until_s=122)) == ()
    short, beside = plan(until_s=73.181), plan(leg(3, 62, 72, THERE, FAR, 20), until_s=72)
    assert rules(short) == ["move_too_short"]
    assert rules(beside) == ["leg_origin_wrong"]
    assert [one.rule for one in recheck(short)] == [one.rule for one in recheck(beside)] == ["core_travel"]


def test_of_two_that_take_it_apart_jointly_the_last_of_the_tree_has_it() -> None:
    """Both take the box jointly, to the far corner and to the origin, at its 1 m/s; it is where the later leaf of the two brought it."""
    tree = grounded(
        and_(
            leaf("there", role="x", at="far", moves=True, brings=("box",), sync=0),
            leaf("here", role="y", at="here", moves=True, brings=("box",), sync=0),
            leaf("use", role="z", at="box", duration_s=2),
        ),
        [("there", "use")],
    )
    both = leg(1, 0, 22.361, HERE, FAR, 22.361), leg(2, 0, 22.361, HERE, HERE, 0, "r-2")
    actions = times((1, "r-1", 0, 22.361), (2, "r-2", 0, 22.361), (3, "r-3", 22.361, 24.361))
    assert check(plan_of(tree, actions, *by_start(*both), fleet=team(3), scene=WORLD)) == ()
    astray = leg(3, 0, 22.361, HERE, FAR, 22.361, "r-3")
    plan = plan_of(tree, actions, *by_start(*both, astray), fleet=team(3), scene=WORLD)
    assert rules(plan) == ["leg_destination_wrong"]
    assert [one.rule for one in recheck(plan)] == ["core_travel"]
