"""Every kind of difference between a tree and the plan that was expected, and everything that makes no difference."""

from typing import Any

import pytest

from missiontree.evaluation.differences import differences
from missiontree.evaluation.expected import Expected
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, LinkKind, MissionTree
from tests.evaluation.trees import HOUSE, brief, leaf, task, tree


def plan(*entries: Any, order: tuple[str, ...] = ()) -> Expected:
    return Expected(plan=entries, order=order)


def found(expected: Expected, made: MissionTree, scene: Scene | None = None) -> tuple[str, ...]:
    return differences(expected, made, brief(scene))


FETCH = tree(
    task("look", "and", leaf("s", "Search(dog)")),
    leaf("f", "ReachAndTransport(dog, safe_area)"),
    links=[Link("look", "f")],
    new=["Dog", "Safe Area"],
)


def test_tasks_order_of_listing_and_state_words_make_no_difference() -> None:
    assert (
        found(plan("ReachAndTransport(Injured Dog, the safe area)", "Search(Injured Dog)", order=("2 < 1",)), FETCH)
        == ()
    )


@pytest.mark.parametrize(
    ("expected", "differs"),
    [
        (plan("Search(Dog)"), ("not expected: ReachAndTransport(Dog, Safe Area)",)),
        (
            plan("Search(Dog)", "Transport(Dog, Safe Area)"),
            ("missing: Transport(Dog, Safe Area)", "not expected: ReachAndTransport(Dog, Safe Area)"),
        ),
        (
            plan("Search(Cat)", "ReachAndTransport(Cat, Safe Area)", order=("1 < 2",)),
            (
                "missing: Search(Cat)",
                "missing: ReachAndTransport(Cat, Safe Area)",
                "not expected: Search(Dog)",
                "not expected: ReachAndTransport(Dog, Safe Area)",
            ),
        ),
        (  # a name means one thing throughout: Old Dog and Young Dog cannot both be the author's Dog
            plan("Search(Old Dog)", "ReachAndTransport(Young Dog, Safe Area)", order=("1 < 2",)),
            ("missing: ReachAndTransport(Young Dog, Safe Area)", "not expected: ReachAndTransport(Dog, Safe Area)"),
        ),
        (
            plan("Search(Dog)", "ReachAndTransport(Dog, Safe Area)"),
            ("order not expected: Search(Dog) before ReachAndTransport(Dog, Safe Area)",),
        ),
        (
            plan("Search(Dog)", "ReachAndTransport(Dog, Safe Area)", order=("2 < 1",)),
            (
                "missing order: ReachAndTransport(Dog, Safe Area) before Search(Dog)",
                "order not expected: Search(Dog) before ReachAndTransport(Dog, Safe Area)",
            ),
        ),
        (
            plan({"xor": ["Search(Dog)", "ReachAndTransport(Dog, Safe Area)"]}),
            (
                "choices: expected xor(Search(Dog), ReachAndTransport(Dog, Safe Area)); "
                "got and(Search(Dog), ReachAndTransport(Dog, Safe Area))",
                "order not expected: Search(Dog) before ReachAndTransport(Dog, Safe Area)",
            ),
        ),
        (
            plan("Search(Dog) by tele_robot", "ReachAndTransport(Dog, Safe Area)", order=("1 < 2",)),
            (
                "robot types of Search(Dog): expected tele_robot; "
                "got mobile_scooter, social_robot, tele_robot, transportation_robot",
            ),
        ),
    ],
)
def test_what_differs_is_told(expected: Expected, differs: tuple[str, ...]) -> None:
    assert found(expected, FETCH) == differs


def test_left_out_types_are_the_others() -> None:
    made = tree(leaf("a", "Reach(anna)", "social_robot", "mobile_scooter", "transportation_robot"), new=["Anna"])
    assert found(plan("Reach(Anna) not by tele_robot"), made) == ()


def test_until_is_compared() -> None:
    made = tree(
        leaf("f", "Follow(dog)"), leaf("r", "Reach(anna)"), links=[Link("f", "r", "until")], new=["Dog", "Anna"]
    )
    assert found(plan("Reach(Anna)", "Follow(Dog)", order=("2 ~ 1",)), made) == ()
    assert found(plan("Reach(Anna)", "Follow(Dog)"), made) == (
        "order not expected: Follow(Dog) until the end of Reach(Anna)",
    )


def test_options_of_a_choice_have_no_order_of_listing_but_belong_to_their_choice() -> None:
    made = tree(
        task("c", "xor", leaf("a", "Reach(a)"), leaf("b", "Reach(b)")),
        task("d", "xor", leaf("x", "Reach(x)"), leaf("y", "Reach(y)")),
        new=["A", "B", "X", "Y"],
    )
    assert found(plan({"xor": ["Reach(Y)", "Reach(X)"]}, {"xor": ["Reach(B)", "Reach(A)"]}), made) == ()
    assert len(found(plan({"xor": ["Reach(A)", "Reach(X)"]}, {"xor": ["Reach(B)", "Reach(Y)"]}), made)) == 1


def test_equal_leaves_are_matched_by_what_relates_them() -> None:
    # Go to Anna, fetch the cup, go to Anna: of the two equal leaves, the tree lists the later one first.
    made = tree(
        leaf("late", "Reach(anna)"),
        leaf("early", "Reach(anna)"),
        leaf("cup", "Search(mug)"),
        links=[Link("early", "cup"), Link("cup", "late")],
        new=["Anna", "Mug"],
    )
    assert found(plan("Reach(Anna)", "Search(Mug)", "Reach(Anna)", order=("1 < 2", "2 < 3")), made) == ()
    assert found(plan("Reach(Anna)", "Search(Mug)", "Reach(Anna)", order=("1 < 2",)), made) != ()


@pytest.mark.parametrize(("kind", "by"), [("same_robot", "the same robot"), ("different_robot", "different robots")])
def test_links_between_robots_are_a_difference(kind: LinkKind, by: str) -> None:
    made = tree(leaf("a", "Reach(x)"), leaf("b", "Reach(y)"), links=[Link("a", "b", kind)], new=["X", "Y"])
    assert f"order not expected: Reach(X) and Reach(Y) by {by}" in found(plan("Reach(X)", "Reach(Y)"), made)


def test_the_scene_says_whom_a_name_means() -> None:
    made = tree(leaf("a", "ReachAndTransport(cup_2, anna)"))
    assert found(plan("ReachAndTransport(cup_2, the nurse)"), made, HOUSE) == ()
    assert found(plan("ReachAndTransport(cup_1, Anna Berg)"), made, HOUSE) != ()


def test_somebody_introduced_is_not_whom_the_scene_has() -> None:
    made = tree(leaf("a", "Reach(anna_berg)"), new=["Anna Berg"])
    assert found(plan("Reach(Anna Berg)"), made, HOUSE) == (
        "missing: Reach(Anna Berg)",
        "not expected: Reach(a new Anna Berg)",
    )


def test_an_id_is_no_name() -> None:
    """The author's entity has the id of what was expected, and is called otherwise."""
    made = tree(leaf("a", "Reach(cat)"), new=["Cat"])
    assert found(plan("Reach(Dog)"), made) == ("missing: Reach(Dog)", "not expected: Reach(Cat)")


def test_an_open_leaf_is_a_difference() -> None:
    made = tree(leaf("a", "Reach(x)"), task("later", "and"), new=["X"])
    assert found(plan("Reach(X)"), made) == ("unfinished: later",)
