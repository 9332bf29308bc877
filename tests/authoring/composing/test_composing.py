"""Clauses put together: what is added for the operator, and what is done once."""

from __future__ import annotations

from missiontree.authoring.methods.method import built_in_methods
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.formats.document import read_file
from missiontree.mission.brief import MissionBrief
from missiontree.routines.library import built_in
from missiontree.samples.catalogue import FOLDER


def authored(text: str) -> Authored:
    fleet = read_file(FOLDER / "fleet.yaml", "fleet")
    return author_offline(MissionBrief(text=text, fleet=fleet, routines=built_in()), built_in_methods())


def leaves(made: Authored) -> list[str]:
    assert made.tree is not None, made.reasons
    return [node.label for node in made.tree.nodes if node.routine]


def test_search_for_the_lost_is_added_in_the_order_in_which_they_are_named() -> None:
    made = authored("Bring the lost dog and the lost cat to Anna")
    assert leaves(made)[:2] == ["Search(Dog)", "Search(Cat)"]
    assert [notice.rule for notice in made.notices].count("search_added") == 2


def test_search_of_an_earlier_clause_serves_a_later_method() -> None:
    made = authored("Find the cat, then rescue it")
    assert leaves(made) == ["Search(Cat)", "ReachAndTransport(Cat, Safe Area)"]
    assert "searched_once" in {notice.rule for notice in made.notices}


def test_event_that_names_what_was_asked_for_is_no_second_task() -> None:
    made = authored("Find the dog, and when it is found, go to the lobby")
    assert leaves(made) == ["Search(Dog)", "Reach(Lobby)"]
    assert made.tree is not None
    assert [(link.first, link.second) for link in made.tree.links] == [("search-dog", "reach-lobby")]


def test_statement_makes_no_task_and_is_told_if_it_changes_nothing() -> None:
    made = authored("The cat is lost. Follow the dog.")
    assert leaves(made) == ["Follow(Dog)"]
    assert any("The cat is lost" in assumption.message for assumption in made.assumptions)


def test_until_needs_something_that_lasts() -> None:
    made = authored("Go to the lobby until you find the dog")
    assert made.status == "incomplete"
    assert made.reasons[0].rule == "until_without_open_end"


def test_same_words_twice_become_two_tasks_with_names_of_their_own() -> None:
    made = authored("Go to the lobby and the gate, then go to the lobby and the gate")
    assert made.tree is not None
    tasks = [node.label for node in made.tree.nodes[1:] if not node.routine]
    assert len(tasks) == len(set(tasks)) == 2
