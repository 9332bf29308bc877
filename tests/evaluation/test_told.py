"""Trees in the notation of suites."""

from missiontree.evaluation.told import told
from missiontree.mission.tree import Link
from tests.evaluation.trees import brief, leaf, task, tree


def test_routines_choices_and_order_are_told() -> None:
    made = tree(
        leaf("s", "Search(hen)", "tele_robot"),
        task("c", "xor", leaf("a", "Reach(hen)"), leaf("b", "Follow(hen)")),
        links=[Link("s", "a")],
        new=["Hen"],
    )
    assert told(made, brief()) == "Search(Hen) by tele_robot; xor(Reach(Hen); Follow(Hen)) | 1 < 2"


def test_lasting_until_is_told_and_so_is_a_choice_alone() -> None:
    lasting = tree(leaf("f", "Follow(a)"), leaf("r", "Reach(b)"), links=[Link("f", "r", "until")], new=["A", "B"])
    assert told(lasting, brief()) == "Follow(A); Reach(B) | 1 ~ 2"
    chosen = tree(leaf("a", "Reach(a)"), leaf("b", "Reach(b)"), gate="xor", new=["A", "B"])
    assert told(chosen, brief()) == "xor(Reach(A); Reach(B))"
