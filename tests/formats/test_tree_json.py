"""Trees in columns: what they become, and how whatever is wrong with one is said."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from missiontree.allocation.flat import flatten
from missiontree.allocation.kbest import ExactKBest
from missiontree.errors import InputError
from missiontree.formats.importers.tree_grounded import fleet_of, grounded_of
from missiontree.formats.importers.tree_json import looks_like_tree, read_tree
from missiontree.formats.reader import parse
from missiontree.mission.columns import WEIGHTS
from missiontree.mission.control import Control
from missiontree.mission.grounded import GroundedLink
from missiontree.mission.scene import Scene
from missiontree.scheduling import SCHEDULERS
from tests.formats.tree_files import read, small


def refusal(**changes: Any) -> InputError:
    """What is said of the small tree with these keys changed; those that are None are left out."""
    data = {key: value for key, value in (small() | changes).items() if value is not None}
    with pytest.raises(InputError) as caught:
        read(data)
    return caught.value


def test_a_robot_is_a_type_of_one_with_its_budget_as_a_limit() -> None:
    fleet = fleet_of(read(small()))
    assert [(kind.id, kind.count, dict(kind.limits)) for kind in fleet.types] == [
        ("robot-0", 1, {"consumption": 8.0}),
        ("robot-1", 1, {"consumption": 3.0}),
    ]


def test_without_budgets_nothing_limits_a_robot() -> None:
    data = small()
    assert all(not kind.limits for kind in fleet_of(read(data), budgets=False).types)
    del data["budget"]
    assert all(not kind.limits for kind in fleet_of(read(data)).types)


def test_a_leaf_is_an_action_with_a_role_of_its_own() -> None:
    tree = grounded_of(read(small()))
    assert [node.kind for node in tree.nodes] == ["and", "xor", "action", "action", "action"]
    assert [tree.action(leaf).role for leaf in (2, 3, 4)] == [0, 1, 2]
    action = tree.action(4)
    assert (action.robot_type, action.estimate.quality, action.duration_s) == ("robot-1", 7.0, 1.0)
    assert action.uses == action.uses_at_least == {"consumption": 1.0}
    assert tree.links == (GroundedLink(2, 1, "precedence"),)


def test_disjoint_robots_are_kept_only_if_asked_for() -> None:
    """The children of node 0 are 1 and 2."""
    columns = read(small())
    assert [link.kind for link in grounded_of(columns).links] == ["precedence"]
    assert grounded_of(columns, disjoint=True).links[1:] == (GroundedLink(1, 2, "different_robot"),)


def test_a_negative_utility_is_a_cost() -> None:
    tree = grounded_of(read(small() | {"utility": [0, 0, -10, 9, 7]}))
    assert (tree.action(2).estimate.quality, tree.action(2).estimate.cost) == (0.0, 10.0)
    assert flatten(tree, fleet_of(read(small())), WEIGHTS).utility[2] == -10_000_000


def test_the_grounded_tree_is_ranked_and_scheduled_like_any_other() -> None:
    """Robot 0 has 8 and would use 4 + 5, so leaf 4 is taken: 10 + 7. It starts when leaf 2 has ended: 3 s + 1 s."""
    columns = read(small())
    tree, fleet = grounded_of(columns), fleet_of(columns)
    ranking = ExactKBest()(tree, fleet, WEIGHTS, 5, Control())
    assert [(one.utility, one.choices[0].child) for one in ranking.alternatives] == [(17.0, 4)]
    schedule = SCHEDULERS["greedy"](tree, ranking.alternatives[0], fleet, Scene(), Control())
    assert schedule.makespan_s == 4.0


def test_a_tree_may_be_one_leaf() -> None:
    columns = read({"kind": [0], "parent": [-1], "robot": [0], "utility": [3], "robots": 1})
    assert (columns.duration, columns.consumption, columns.budget) == ([0], [0], None)


def test_what_is_a_tree_in_columns_is_told_by_its_keys() -> None:
    assert looks_like_tree(small())
    assert not looks_like_tree({"format": "plan/1", "kind": []})
    assert not looks_like_tree([1])


def test_a_file_is_read_and_blamed_by_name_line_and_field(tmp_path: Path) -> None:
    file = tmp_path / "tree.json"
    file.write_text(json.dumps(small()), encoding="utf-8")
    assert read_tree(file) == read(small())
    file.write_text(json.dumps(small() | {"parent": [-1, 0, 0, 1, 9]}, indent=1), encoding="utf-8")
    with pytest.raises(InputError) as caught:
        read_tree(file)
    assert (caught.value.file, caught.value.where) == (str(file), "parent[4]")
    # Line 1 is the bracket; 2 to 8 are kind, its 5 numbers and the bracket after them; 9 is parent.
    assert caught.value.line == 14


@pytest.mark.parametrize(
    ("changes", "where", "words"),
    [
        ({"utility": None}, "", "'utility' is missing"),
        ({"robots": None}, "", "'robots' is missing"),
        ({"buget": [1, 2]}, "buget", "'buget' is not known"),
        ({"kind": 3}, "kind", "3 stands here"),
        ({"kind": [], "parent": []}, "kind", "the list is empty"),
        ({"kind": [1, 2, 0, 0, 7]}, "kind[4]", "7 stands here"),
        ({"kind": [1, 2, 0, 0, "leaf"]}, "kind[4]", "'leaf' (text) stands here"),
        ({"kind": [1, 2, 0, 0, True]}, "kind[4]", "true (a truth value) stands here"),
        ({"utility": [0, 0, 10, 9.5, 7]}, "utility[3]", "9.5 stands here"),
        ({"utility": [0, 0, 10, 9, 2 * 10**9]}, "utility[4]", "2000000000 stands here"),
        ({"utility": [0, 0, 10, 9]}, "utility", "the list has 4 numbers, and there are 5 nodes"),
        ({"parent": [-1, 0, 0, 1]}, "parent", "the list has 4 numbers, and there are 5 nodes"),
        ({"utility": [0, 4, 10, 9, 7]}, "utility[1]", "node 1 is an XOR and has utility 4"),
        ({"consumption": [1, 0, 4, 5, 1]}, "consumption[0]", "node 0 is an AND and has consumption 1"),
        ({"consumption": [0, 0, 4, -5, 1]}, "consumption[3]", "-5 stands here"),
        ({"duration": [0, 0, 4, -5, 1]}, "duration[3]", "-5 stands here"),
        ({"robot": [0, 0, 0, 0, 2]}, "robot[4]", "2 stands here"),
        ({"robots": 0}, "robots", "0 stands here"),
        ({"robots": "two"}, "robots", "'two' (text) stands here"),
        ({"parent": [0, 0, 0, 1, 1]}, "parent[0]", "node 0 has parent 0"),
        ({"parent": [-1, 0, -1, 1, 1]}, "parent[2]", "node 2 is a second root"),
        ({"parent": [-1, 3, 0, 1, 1]}, "parent[1]", "node 1 has parent 3, which does not stand before it"),
        ({"parent": [-1, 1, 0, 1, 1]}, "parent[1]", "node 1 has parent 1, which does not stand before it"),
        ({"parent": [-1, 0, 0, 1, 5]}, "parent[4]", "node 4 has parent 5, and there are 5 nodes"),
        ({"parent": [-1, 0, 0, 1, 2]}, "parent[4]", "node 4 has parent 2, which is a leaf"),
        ({"budget": [8]}, "budget", "the list has 1 numbers, and there are 2 robots"),
        ({"budget": [8, -1]}, "budget[1]", "-1 stands here"),
        ({"disjoint": [1]}, "disjoint[0]", "1 stands here"),
        ({"disjoint": [9]}, "disjoint[0]", "9 stands here"),
        ({"precedence": {}}, "precedence", "an empty mapping stands here"),
        ({"precedence": [[2, 1], [1]]}, "precedence[1]", "a list of 1 stands here"),
        ({"precedence": [[2, "1"]]}, "precedence[0]", "a list of 2 stands here"),
        ({"precedence": [[2, 5]]}, "precedence[0]", "the pair [2, 5] names a node that there is not; there are 5"),
        ({"precedence": [[2, 2]]}, "precedence[0]", "the pair [2, 2] names one node twice"),
        ({"precedence": [[0, 4]]}, "precedence[0]", "names two nodes of which one stands below the other"),
        ({"precedence": [[4, 1]]}, "precedence[0]", "names two nodes of which one stands below the other"),
        ({"precedence": [[2, 1], [1, 2]]}, "precedence[0]", "the precedence runs in a circle"),
        ({"precedence": [[2, 1], [4, 2]]}, "precedence[0]", "the precedence runs in a circle"),
    ],
)
def test_what_is_wrong_is_named_with_its_place(changes: dict[str, Any], where: str, words: str) -> None:
    error = refusal(**changes)
    assert error.where == where
    assert words in error.message
    assert error.accepted
    assert error.line == 1


def test_a_misspelt_key_is_answered_with_the_nearest() -> None:
    assert "budget" in refusal(buget=[1, 2]).hint


def test_what_is_no_mapping_is_refused() -> None:
    with pytest.raises(InputError, match="a list of 2 stands here"):
        read([1, 2])  # type: ignore[arg-type]


def test_order_against_the_order_of_nodes_is_accepted_where_it_can_be_kept() -> None:
    """Leaf 2 comes after the XOR in the tree, and before both of its children in time; 4 before 3 binds never, both being of one XOR."""
    read(small() | {"precedence": [[2, 3], [2, 4], [4, 3]]})
    read(small() | {"precedence": [[2, 3], [4, 2]]})


def test_a_chain_a_hundred_thousand_deep_is_read() -> None:
    """Every node is below the one before it; the last pair joins the first child and the far end, past no limit of recursion."""
    depth = 100_000
    kind = [1] * depth + [0, 0]
    parent = [-1, *range(depth), 0]
    rest: dict[str, Any] = {name: [0] * len(kind) for name in ("robot", "utility")}
    tree = read({"kind": kind, "parent": parent, "robots": 1, "precedence": [[depth + 1, depth]], **rest})
    assert len(tree.kind) == depth + 2


def test_the_text_of_a_file_passes_the_common_door() -> None:
    """A key that stands twice is refused before the tree is looked at."""
    with pytest.raises(InputError, match="stands twice"):
        parse('{"kind": [0], "kind": [1]}', "tree.json")
