"""An until link from something that ends by itself means nothing, and is refused wherever it comes from."""

from __future__ import annotations

import pytest

from missiontree.authoring.author import authored_from_tree
from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.tools import ToolBox
from missiontree.errors import InputError
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.routines.ground import ground
from missiontree.routines.library import built_in
from missiontree.routines.open_ended import is_open_ended
from tests.builders import paper_fleet, routine_node

PEOPLE = (Entity(id="Ann", kind="person"), Entity(id="Bob", kind="person"))


def until(first: str) -> MissionTree:
    """A routine for Ann until Bob is reached."""
    return MissionTree(
        objective="x",
        nodes=(
            MissionNode(id="root", label="x", gate="and", children=("a", "b")),
            routine_node("a", first, agent="Ann"),
            routine_node("b", "Reach", agent="Bob"),
        ),
        links=(Link("a", "b", "until"),),
        entities=PEOPLE,
    )


def brief() -> MissionBrief:
    return MissionBrief(text="Watch Ann and reach Bob", fleet=paper_fleet(), routines=built_in())


def test_following_goes_on_and_so_does_what_is_composed_of_it() -> None:
    library = built_in()
    lasting = {routine.id for routine in library.routines if is_open_ended(routine, library)}
    assert lasting == {"Follow", "SearchAndFollow"}


@pytest.mark.parametrize("routine", ["Reach", "Search"])
def test_what_ends_by_itself_is_refused_in_a_tree_that_is_handed_in(routine: str) -> None:
    authored = authored_from_tree(until(routine), brief())
    assert [reason.rule for reason in authored.reasons] == ["not_open_ended"]
    with pytest.raises(InputError, match="without an end of its own"):
        ground(until(routine), brief())


@pytest.mark.parametrize("routine", ["Follow", "SearchAndFollow"])
def test_what_goes_on_is_taken(routine: str) -> None:
    assert authored_from_tree(until(routine), brief()).status == "complete"
    assert ground(until(routine), brief()).tree.links[0].kind == "until"


def test_the_call_is_refused_and_says_what_goes_on() -> None:
    box = ToolBox(TreeBuilder(brief()))
    box.call("HierarchicalTree_init", {"objective": "x"})
    attached = {
        "parentString": "x",
        "treeNames": ["ReachTree", "FollowTree"],
        "treeArguments": [["Bob"], ["Ann"]],
        "LogicalConstraint": "AND",
    }
    refused = box.call("attachMultiSubTrees", {**attached, "constraintPairs": [[0, 1, "Until"]]})
    assert [reason.rule for reason in refused.reasons] == ["not_open_ended"]
    assert "Follow" in refused.reasons[0].hint
    assert box.call("attachMultiSubTrees", {**attached, "constraintPairs": [[1, 0, "Until"]]}).ok
