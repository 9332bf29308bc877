"""The form in which plans are compared."""

from missiontree.evaluation.expected import Expected, Group
from missiontree.evaluation.structure import structure_of_expected, structure_of_tree
from missiontree.mission.tree import Link
from tests.evaluation.trees import brief, leaf, task, tree


def test_gates_that_say_nothing_are_gone() -> None:
    made = tree(
        task("t1", "and", leaf("a", "Reach(x)"), task("t2", "and", leaf("b", "Reach(y)"))),
        task("t3", "xor", leaf("c", "Reach(x)"), task("t4", "and", leaf("d", "Reach(y)"), leaf("e", "Reach(z)"))),
        new=["X", "Y", "Z"],
    )
    assert structure_of_tree(made, brief()).shape == Group("and", (0, 1, Group("xor", (2, Group("and", (3, 4))))))


def test_order_between_tasks_is_order_between_all_their_leaves_and_what_follows() -> None:
    made = tree(
        leaf("a", "Reach(x)"),
        task("t", "and", leaf("b", "Reach(y)"), leaf("c", "Reach(z)")),
        leaf("d", "Reach(x)"),
        links=[Link("a", "t"), Link("t", "d")],
        new=["X", "Y", "Z"],
    )
    # a before b and c, which are before d; so a is before d.
    assert structure_of_tree(made, brief()).before == {(0, 1), (0, 2), (1, 3), (2, 3), (0, 3)}


def test_until_counts_for_what_has_no_end_and_to_the_latest_end() -> None:
    made = tree(
        task("t", "and", leaf("s", "Search(x)"), leaf("f", "Follow(x)")),
        task("u", "and", leaf("g", "Reach(y)"), leaf("h", "Reach(z)")),
        links=[Link("t", "u", "until"), Link("g", "h")],
        new=["X", "Y", "Z"],
    )
    # Search (0) ends by itself. Whoever follows (1) until h (3) has ended does so until g (2) before it has ended, too.
    assert structure_of_tree(made, brief()).until == {(1, 3)}


def test_robot_types_are_a_set_and_none_left_out_is_no_restriction() -> None:
    everybody = frozenset({"mobile_scooter", "tele_robot", "transportation_robot", "social_robot"})
    plan = Expected(
        plan=("Reach(X)", "Reach(Y) by tele_robot, social_robot", "Reach(Z) not by tele_robot"),
    )
    assert [leaf.types for leaf in structure_of_expected(plan, brief()).leaves] == [
        everybody,
        {"tele_robot", "social_robot"},
        everybody - {"tele_robot"},
    ]
    made = tree(leaf("a", "Reach(x)", *sorted(everybody)), leaf("b", "Reach(x)"), new=["X"])
    assert {leaf.types for leaf in structure_of_tree(made, brief()).leaves} == {everybody}


def test_options_of_a_choice_are_not_ordered() -> None:
    plan = Expected(plan=({"xor": ["Reach(X)", "Reach(Y)"]}, "Reach(Z)"), order=("1 < 2", "2 < 3"))
    # X and Y are never both done; that X comes before Z follows all the same.
    assert structure_of_expected(plan, brief()).before == {(1, 2), (0, 2)}
