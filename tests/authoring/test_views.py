from dataclasses import replace

from missiontree.authoring.views import MOST_SHOWN, named, outline, state_of
from missiontree.mission.tree import MissionNode, MissionTree
from tests.builders import flat_tree, reunite_tree, routine_node


def wide(count: int) -> MissionTree:
    leaves = tuple(MissionNode(id=f"t{number}", label="t\nt") for number in range(count))
    root = MissionNode(id="root", label="root", gate="and", children=tuple(leaf.id for leaf in leaves))
    return MissionTree(objective="x", nodes=(root, *leaves))


def test_the_outline_shows_gates_and_links() -> None:
    assert outline(reunite_tree()).splitlines() == [
        "- Reunite mom with her lost child (root) [AND]",
        "  - Locate the Lost Child (locate) [AND]",
        "    - Search(Child) (search)",
        "  - Reunite the Child with Mom (reunite) [AND]",
        "    - ReachAndTransport(Child, Mom) (transport)",
        "Precedence: locate -> reunite",
    ]


def test_a_label_cannot_pass_for_a_line_of_its_own() -> None:
    assert outline(wide(1)).splitlines() == ["- root (root) [AND]", "  - t t (t0) [open]"]


def test_a_long_outline_says_what_is_left_out() -> None:
    """The root and 600 leaves are 601 lines, of which 500 are shown."""
    lines = outline(wide(600)).splitlines()
    assert len(lines) == MOST_SHOWN + 1
    assert lines[-1] == "... and 101 more lines"


def test_the_state_counts_open_leaves_that_it_does_not_list() -> None:
    state = state_of(wide(60))
    assert (len(state["open_leaves"]), state["open_leaves_not_shown"], state["nodes"]) == (50, 10, 61)
    assert "open_leaves_not_shown" not in state_of(wide(50))


def test_nodes_are_named_by_id_and_label() -> None:
    assert named(reunite_tree().nodes[:1]) == [{"id": "root", "label": "Reunite mom with her lost child"}]


def test_the_outline_shows_times() -> None:
    node = routine_node("search", "Search", agent="Child")
    tree = flat_tree(replace(node, release_s=5.0, deadline_s=62.5))
    assert outline(tree).splitlines()[1].endswith("(search), from 5 s, by 62.5 s")
