"""Which expectations trees keep, all written by hand."""

from typing import Any

import pytest

from missiontree.evaluation.holding import held
from missiontree.evaluation.loose import Loose
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, MissionTree
from tests.evaluation.trees import HOUSE, brief, leaf, task, tree

BROUGHT = tree(
    leaf("s", "Search(anna)"),
    leaf("b", "ReachAndTransport(anna, ward_3)"),
    links=[Link("s", "b")],
    new=["Anna", "Ward 3"],
)


def broken(made: MissionTree, scene: Scene | None = None, **expected: Any) -> tuple[str, ...]:
    return held(Loose(**expected), made, brief(scene)).broken


def test_what_must_occur_does_and_the_rest_is_open() -> None:
    assert broken(BROUGHT, must=("Search(Anna)",)) == ()
    assert broken(BROUGHT, must=("Search(*)", "ReachAndTransport(*, Ward 3)")) == ()


def test_what_is_missing_is_named_and_the_share_counts() -> None:
    """Of two entries, one order and one name, the entry for the cat is broken, and so is the order with it: 2 of 4 hold."""
    loose = Loose(must=("Search(Anna)", "Search(Cat)"), order=("2 < 1",), entities=("Ward 3",))
    found = held(loose, BROUGHT, brief())
    assert found.broken == ("missing: Search(Cat)", "missing order: Search(Cat) before Search(Anna)")
    assert (found.count, found.share) == (4, 0.5)


def test_what_must_not_occur_is_found() -> None:
    assert broken(BROUGHT, must=("Search(*)",), must_not=("Follow(*)",)) == ()
    assert broken(BROUGHT, must=("Search(*)",), must_not=("ReachAndTransport(*, *)",)) == (
        "must not occur: ReachAndTransport(*, *)",
    )


def test_a_name_that_must_not_occur_is_found_with_words_left_out() -> None:
    """Nothing else is called so: an injured worker is a worker."""
    made = tree(leaf("f", "Follow(injured_worker)"), leaf("r", "Reach(cup)"), new=["Injured Worker", "Cup"])
    assert broken(made, must=("Reach(Cup)",), must_not=("Follow(Worker)",)) == ("must not occur: Follow(Worker)",)
    assert broken(made, must=("Reach(Cup)",), must_not=("Follow(Dog)",)) == ()


def test_only_what_is_named_must_not_occur_but_parts_count_as_done() -> None:
    """Reaching is a part of reaching and transporting."""
    assert broken(BROUGHT, must=("Reach(Anna)", "Transport(Anna, Ward 3)"), order=("1 < 2",)) == ()
    assert broken(BROUGHT, must=("Reach(Anna)",), must_not=("Transport(*, *)",)) == ()
    assert broken(BROUGHT, must=("Reach(Anna)", "Transport(Anna, Ward 3)"), order=("2 < 1",)) == (
        "missing order: Transport(Anna, Ward 3) before Reach(Anna)",
    )


def test_a_part_is_in_the_order_of_the_whole() -> None:
    assert broken(BROUGHT, must=("Search(Anna)", "Transport(Anna, *)"), order=("1 < 2",)) == ()


def test_an_entry_that_stands_twice_needs_two() -> None:
    once = tree(leaf("a", "Reach(cup)"), new=["Cup"])
    twice = tree(leaf("a", "Reach(cup)"), leaf("b", "Reach(cup)"), links=[Link("a", "b")], new=["Cup"])
    assert broken(once, must=("Reach(Cup)", "Reach(Cup)")) == ("missing: Reach(Cup)",)
    assert broken(twice, must=("Reach(Cup)", "Reach(Cup)"), order=("2 < 1",)) == ()


def test_different_entries_may_mean_the_same_routine() -> None:
    assert broken(tree(leaf("a", "Reach(cup)"), new=["Cup"]), must=("Reach(*)", "Reach(Cup)")) == ()


def test_some_matching_that_keeps_the_order_is_enough() -> None:
    """Only the second search comes before the follow."""
    made = tree(
        leaf("a", "Search(cup)"),
        leaf("b", "Search(dog)"),
        leaf("f", "Follow(dog)"),
        links=[Link("b", "f")],
        new=["Cup", "Dog"],
    )
    assert broken(made, must=("Search(*)", "Follow(*)"), order=("1 < 2",)) == ()
    assert broken(made, must=("Search(Cup)", "Follow(*)"), order=("1 < 2",)) == (
        "missing order: Search(Cup) before Follow(*)",
    )


def test_lasting_until_is_looked_at() -> None:
    made = tree(leaf("f", "Follow(dog)"), leaf("r", "Reach(cup)"), links=[Link("f", "r", "until")], new=["Dog", "Cup"])
    expected: dict[str, Any] = {"must": ("Follow(Dog)", "Reach(Cup)"), "order": ("1 ~ 2",)}
    assert broken(made, **expected) == ()
    apart = tree(leaf("f", "Follow(dog)"), leaf("r", "Reach(cup)"), new=["Dog", "Cup"])
    assert broken(apart, **expected) == ("missing order: Follow(Dog) until the end of Reach(Cup)",)


def test_it_is_to_hold_whatever_is_chosen() -> None:
    either = tree(task("c", "xor", leaf("a", "Reach(cup)"), leaf("b", "Reach(dog)")), new=["Cup", "Dog"])
    assert broken(either, must=("Reach(*)",)) == ()
    assert broken(either, must=("Reach(Cup)",)) == (
        "missing: Reach(Cup), in a way of choosing that the tree leaves open",
    )
    assert broken(either, must=("Reach(*)",), must_not=("Reach(Dog)",)) == ("must not occur: Reach(Dog)",)


def test_order_by_way_of_what_is_not_chosen_does_not_bind() -> None:
    """Search before the dog's branch before the follow: with the cup's branch nothing stands between search and follow."""
    made = tree(
        leaf("s", "Search(anna)"),
        task("c", "xor", leaf("d", "Reach(dog)"), leaf("e", "Reach(cup)")),
        leaf("f", "Follow(anna)"),
        links=[Link("s", "d"), Link("d", "f")],
        new=["Anna", "Dog", "Cup"],
    )
    assert broken(made, must=("Search(Anna)", "Follow(Anna)"), order=("1 < 2",)) == (
        "missing order: Search(Anna) before Follow(Anna), in a way of choosing that the tree leaves open",
    )


def test_names_of_a_scene_are_its_entities() -> None:
    made = tree(leaf("a", "Reach(anna)"))
    assert broken(made, HOUSE, must=("Reach(nurse)",), entities=("Anna Berg",)) == ()
    assert broken(made, HOUSE, must=("Reach(infirmary)",)) == ("missing: Reach(infirmary)",)
    assert broken(made, HOUSE, must=("Reach(*)",), entities=("cup_1",)) == ("nothing is done with cup_1",)


def test_one_name_means_one_thing_throughout() -> None:
    """Two workers: which of them is the worker is settled for all entries at once."""
    made = tree(leaf("a", "Search(old_worker)"), leaf("b", "Reach(young_worker)"), new=["Old Worker", "Young Worker"])
    assert len(broken(made, must=("Search(Worker)", "Reach(Worker)"))) == 1
    assert broken(made, must=("Search(Old Worker)", "Reach(Worker)")) == ()


@pytest.mark.parametrize(
    ("types", "call", "holds"),
    [
        (("social_robot",), "Reach(Anna) by social_robot", True),
        ((), "Reach(Anna) by social_robot", False),  # a mobile scooter might do it
        (("social_robot",), "Reach(Anna) by social_robot, tele_robot", True),
        (("social_robot",), "Reach(Anna) not by tele_robot", True),
        (("social_robot", "tele_robot"), "Reach(Anna) not by tele_robot", False),
    ],
)
def test_robot_types_that_are_named_are_kept(types: tuple[str, ...], call: str, holds: bool) -> None:
    made = tree(leaf("a", "Reach(anna)", *types), new=["Anna"])
    assert (broken(made, must=(call,)) == ()) == holds


def test_types_that_are_not_able_need_no_exclusion() -> None:
    """Of the paper's team only Tele-Robots and Transportation Robots search."""
    made = tree(leaf("a", "Search(anna)"), new=["Anna"])
    assert broken(made, must=("Search(Anna) not by mobile_scooter",)) == ()
    assert broken(made, must=("Search(Anna) by tele_robot, transportation_robot",)) == ()
    assert broken(made, must=("Search(Anna) by tele_robot",)) == ("missing: Search(Anna) by tele_robot",)


def test_the_name_of_a_language_model_for_a_routine_is_the_routine() -> None:
    assert broken(BROUGHT, must=("SearchTree(Anna)",)) == ()
