"""Goals: one of three forms, checked at birth, and named without contradiction."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from missiontree.mission.goal import Goal, all_goals, check_goals, in_words


def goal(**fields: Any) -> Goal:
    """A goal whose lists are written as lists."""
    return Goal(**fields)


RESCUE = goal(method="rescue", slots={"victim": ["Anna", "Tom"], "site": "barn"}, name="save")
CARRY = goal(do=" ReachAndTransport( red box ,Anna )", after=("save",))


def test_a_goal_shows_what_it_names() -> None:
    assert (CARRY.routine, CARRY.arguments) == ("ReachAndTransport", ("red box", "Anna"))
    assert RESCUE.entities == ("Anna", "Tom", "barn")
    assert RESCUE.shown == "rescue(victim = Anna and Tom, site = barn)"
    task = goal(task="Tidy up", goals=(RESCUE, CARRY))
    assert list(all_goals((task,))) == [task, RESCUE, CARRY]
    assert in_words((task, goal(do="Search(keys)"))) == "Tidy up; Search(keys)"
    assert (RESCUE.routine, RESCUE.arguments) == ("", ())


def test_a_goal_can_be_hashed_whatever_its_slots_were_given_as() -> None:
    assert len({RESCUE, goal(method="rescue", slots={"victim": ("Anna", "Tom"), "site": "barn"}, name="save")}) == 1


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({}, "has one of do"),
        ({"do": "Search(x)", "method": "rescue"}, "has one of do"),
        ({"do": "Search"}, "is not of the form Routine"),
        ({"do": "Search(x,)"}, "is not of the form Routine"),
        ({"do": "Search()"}, "is not of the form Routine"),
        ({"do": "Search(cow); Reach(gate)"}, r"names 'cow\); Reach\(gate', and a name in a goal has no '\)'"),
        ({"do": "Search(cow; hen)"}, "has no ';'"),
        ({"do": "Search([cow])"}, r"has no '\['"),
        ({"do": "Search(x)", "by": ()}, "leave it out to allow all"),
        ({"task": "Tidy up"}, "has no goals"),
        ({"do": "Search(x)", "gate": "xor"}, "belong to tasks"),
        ({"method": "rescue", "goals": (CARRY,)}, "belong to tasks"),
        ({"do": "Search(x)", "slots": {"victim": "Anna"}}, "slots belong to methods"),
        ({"method": "rescue", "slots": {"victim": ()}}, "'victim' is filled with nothing"),
        ({"method": "rescue", "slots": {"victim": " "}}, "'victim' is filled with nothing"),
        ({"method": "rescue", "slots": {"victim": 5}}, r"slots\.victim must be text or a list of texts"),
        ({"do": "Search(x)", "by": ("crane",), "not_by": ("crane",)}, "'crane' by 'by' and not by 'not_by'"),
        ({"do": "Search(x)", "by": ("tele robot",)}, "must be an id"),
    ],
)
def test_a_goal_that_says_too_little_or_too_much_is_refused(fields: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        Goal(**fields)


def search(who: str, **more: Any) -> Goal:
    return goal(do=f"Search({who})", name=who, **more)


@pytest.mark.parametrize(
    ("goals", "words"),
    [
        ((search("a"), search("a")), "goal 'a' stands twice"),
        ((search("a"), search("b", after=["c"])), r"refers to goal 'c'; named goals are: a, b\."),
        ((goal(do="Search(x)", until="c"),), "refers to goal 'c'; named goals are: none"),
        ((search("a", after=["a"]),), "cannot wait for 'a'; that is the same goal"),
        ((goal(task="t", name="t", goals=[search("a", after=["t"])]),), "cannot wait for 't'; one is part"),
        ((goal(task="t", after=["a"], goals=[search("a")]),), "cannot wait for 'a'; one is part"),
        # c waits for a, which is in no circle itself: only a and b, which wait for each other, are named.
        (
            (search("c", after=["a"]), search("a", after=["b"]), search("b", after=["a"])),
            "circle: 'a' after 'b' after 'a'",
        ),
    ],
)
def test_goals_that_refer_to_each_other_in_vain_are_refused(goals: tuple[Goal, ...], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        check_goals(goals)


def test_goals_may_wait_for_those_that_stand_behind_them_or_inside_others() -> None:
    check_goals((search("a", after=["b", "c"]), search("b"), goal(task="t", goals=[search("c", after=["b"])])))


@pytest.mark.parametrize("apart", [{"different_robot": ["a"]}, {"takes_over_from": "a"}])
def test_goals_without_a_name_are_not_one_goal(apart: dict[str, Any]) -> None:
    """The second is done by the robot of the first, the third by another: that is no contradiction; of one goal it is."""
    together = goal(do="Search(b)", same_robot=["a"])
    check_goals((search("a"), together, goal(do="Search(c)", **apart)))
    for both in ((search("a", same_robot=["b"]), search("b", **apart)), (search("a"), replace(together, **apart))):
        with pytest.raises(ValueError, match="one robot is to do both by same_robot"):
            check_goals(both)
