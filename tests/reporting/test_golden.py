"""Pictures that are part of the contract are drawn as they were when somebody last looked at them."""

from __future__ import annotations

import pytest

from tests.reporting.golden import FOLDER, PICTURES
from tests.reporting.golden_trees import deep, large, wide
from tests.reporting.tree_builders import parsed


@pytest.mark.parametrize("name", PICTURES)
def test_the_picture_is_the_one_that_was_looked_at(name: str) -> None:
    """``python -m tests.reporting.golden`` renews it; look at it then."""
    made = PICTURES[name]()
    if name.endswith(".svg"):
        parsed(made)
    assert made == (FOLDER / name).read_text(encoding="utf-8")


def test_no_other_pictures_are_kept() -> None:
    assert {file.name for file in FOLDER.iterdir()} == set(PICTURES)


def test_the_charts_are_those_of_the_papers_missions_that_can_be_planned() -> None:
    charts = {name for name in PICTURES if name.startswith("gantt-")}
    assert charts == {
        f"gantt-{name}-{rank}.svg" for name in ("reunite", "rescue", "luggage", "monster") for rank in (1, 2)
    }


def test_the_trees_are_as_large_as_deep_and_as_wide_as_they_are_said_to_be() -> None:
    # five parts, four levels deep: 1 + 5 + 25 + 125 + 625
    assert len(large().nodes) == 781
    assert max(sum(1 for _ in deep().ancestors(node.id)) for node in deep().nodes) == 24
    assert len(wide().root.children) == 60
