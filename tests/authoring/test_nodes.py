"""Which node a parent's name means, where names differ by a letter. Names that are exact or far off are tested with the builder."""

import pytest

from missiontree.authoring.answer import RefusalError
from missiontree.authoring.nodes import find_parent
from missiontree.mission.tree import MissionNode, MissionTree


def tree_of(*labels: str) -> MissionTree:
    """A root over open tasks of these names."""
    tasks = [MissionNode(id=f"t{number}", label=label) for number, label in enumerate(labels)]
    root = MissionNode(id="root", label="Mission", gate="and", children=tuple(task.id for task in tasks))
    return MissionTree(objective="Mission", nodes=(root, *tasks))


def test_one_slip_is_taken_with_a_notice() -> None:
    node, notices = find_parent(tree_of("Inspect the roofs", "Fetch the crane"), "Inspect the roosf")
    assert (node.id, [notice.rule for notice in notices]) == ("t0", ["parent_matched"])


@pytest.mark.parametrize(
    ("name", "labels"),
    [
        ("Inspect the roosf", ("Inspect the roofs", "Inspect the roof")),  # letters turned, or one too many
        ("Fetch the crame", ("Fetch the crane", "Fetch the crate")),
    ],
)
def test_a_slip_that_may_have_made_it_of_either_is_refused(name: str, labels: tuple[str, str]) -> None:
    with pytest.raises(RefusalError, match="may be any of t0, t1"):
        find_parent(tree_of(*labels), name)


@pytest.mark.parametrize("name", ["Fetch specimenB", "Fetch the specimen", "Fetch specimen"])
def test_a_task_that_bears_a_letter_is_not_meant_by_a_name_without_it(name: str) -> None:
    """ "A" tells one specimen from another; it is no article."""
    with pytest.raises(RefusalError, match="There is no task"):
        find_parent(tree_of("Fetch specimen A"), name)
