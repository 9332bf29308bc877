"""The alternatives in a terminal, wide or narrow."""

from __future__ import annotations

from dataclasses import replace

import pytest
from rich.cells import cell_len

from missiontree import plan
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.plan import Plan
from missiontree.reporting.team.table import MOST_COLUMNS, MOST_LIMITS, doers_in_words, team_table
from missiontree.reporting.team.view import Doers
from missiontree.reporting.text import render
from missiontree.samples.catalogue import sample_file
from tests.reporting.strict import check_terminal


def shown(made: Plan, width: int) -> str:
    table = team_table(made)
    assert table is not None
    return render(table, width)


def test_where_there_is_room_alternatives_stand_side_by_side() -> None:
    """What each comes to, and who does what; what is not as in the first is marked."""
    lines = shown(plan(sample_file("reunite")), 160).splitlines()
    assert [line for line in lines if line.count("alternative") == 4]
    (utility,) = [line for line in lines if line.startswith("utility")]
    assert [word for word in utility.replace(",", "").split() if word in {"5.6", "3.5"}] == ["5.6", "5.6", "3.5", "3.5"]
    (search,) = [line for line in lines if line.startswith("Search(Child)")]
    assert search.count("≠") == 2
    assert lines[-1] == "≠ otherwise than in alternative 1"


def test_where_there_is_none_they_stand_below_one_another() -> None:
    """The second and further ones tell of tasks only what differs."""
    text = shown(plan(sample_file("reunite")), 60)
    blocks = text.split("alternative ")[1:]
    assert len(blocks) >= 4
    assert "Search(Child)" in blocks[0]
    assert "Search(Child)" not in blocks[1]
    assert "≠ Social Robot" in blocks[1]
    assert "≠ Transportation Robot" in blocks[2]


@pytest.mark.parametrize("width", [20, 34, 72, 90, 200])
@pytest.mark.parametrize("sample", ["reunite", "site"])
def test_no_line_is_wider_than_asked_and_nothing_is_lost(sample: str, width: int) -> None:
    text = shown(plan(sample_file(sample)), width)
    assert max(map(cell_len, text.splitlines())) <= width
    assert "…" not in text


def test_limits_are_told_with_what_is_allowed() -> None:
    """The guide called ben, 105 m at 50 J a metre: 5,236 of the 30,000 J that it has left."""
    text = " ".join(shown(plan(sample_file("site")), 300).split())
    assert "ben: energy_j 5,236.07 of 30,000" in text


def test_of_many_alternatives_and_limits_the_first_are_shown_and_the_rest_counted() -> None:
    kinds = tuple(
        RobotType(id=f"t{number}", count=1, capabilities={"search": 1.0 - number / 100})
        for number in range(MOST_COLUMNS + 3)
    )
    text = shown(plan("Find the cup", fleet=Fleet(kinds), k=MOST_COLUMNS + 3), 200)
    assert "and 3 alternatives more" in text
    assert text.count("alternative ") == MOST_COLUMNS + 1  # the last line tells what the mark means
    assert MOST_LIMITS == 4


def test_doers_are_told_in_words() -> None:
    assert doers_in_words(Doers((), (), "", differs=True)) == "–"
    two = Doers(("Scout", "Scout", "Hauler"), ("s-1", "s-2", "h-1"), "carry", differs=False)
    assert doers_in_words(two) == "2 × Scout, Hauler: s-1, s-2, h-1 (carry)"


def test_a_mission_that_cannot_be_done_has_no_table() -> None:
    assert team_table(plan(sample_file("restaurants"))) is None


def test_names_do_not_act() -> None:
    fleet = Fleet(
        (RobotType(id="bad", label="[red]\x1b[31m\u202eevil\nline[/red]", count=1, capabilities={"search": 1.0}),)
    )
    text = shown(plan("Find the keys", fleet=fleet), 100)
    check_terminal(text)
    assert "[red]evil line[/red]" in text


@pytest.mark.parametrize("width", [40, 120])
def test_names_of_tasks_are_words_too(width: int) -> None:
    made = plan(sample_file("reunite"))
    assert made.tree is not None
    nodes = tuple(replace(node, label="[bold]Search[/bold]") if node.routine else node for node in made.tree.nodes)
    assert "[bold]Search[/bold]" in shown(replace(made, tree=replace(made.tree, nodes=nodes)), width)
