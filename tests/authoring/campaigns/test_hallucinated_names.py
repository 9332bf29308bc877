"""A sample of the campaign of names, and its oracle argued by hand."""

from __future__ import annotations

from collections import Counter

import pytest

from benchmarks.campaign import luck, made
from benchmarks.campaign_letters import LOOK_ALIKES
from benchmarks.campaign_near import WAYS
from benchmarks.campaign_slots import SLOTS, Desk, desks
from benchmarks.hallucinated_names import ACCEPTED, CAMPAIGN, UNTOLD, judge

SAMPLE = 4_000


def desk(name: str) -> Desk:
    return next(known for known in desks() if known.world.name == name)


def test_a_sample_shows_nothing_that_must_never_be() -> None:
    state = made(CAMPAIGN, 1, 0, SAMPLE)
    assert state.violations == {}
    assert set(WAYS) < set(state.rows)
    total = sum((Counter(row) for row in state.rows.values()), Counter())
    assert total["names"] == SAMPLE
    assert sum(state.rows[way]["refused"] for way in LOOK_ALIKES) > 500
    # Three in fifteen and more of the places are each of routine, robot, entity, parent and kind.
    assert state.rows["wrong kind"]["refused"] == state.rows["wrong kind"]["names"] > SAMPLE / 8


def test_a_look_alike_is_never_taken_but_with_an_accent_in_a_parent() -> None:
    state = made(CAMPAIGN, 2, 0, SAMPLE)
    for way in LOOK_ALIKES:
        row = state.rows[way]
        taken = row["names"] - row["refused"]
        assert taken == (row.get("parent taken", 0) if way == "combining mark" else 0)


@pytest.mark.parametrize(
    ("name", "may"),
    [
        ("Frau Müller", True),
        ("FRAU MÜLLER", True),  # letter case
        ("Frau Mu\u0308ller", True),  # the same letter, written as two signs
        ("Frau Muller", False),
        ("Frau Miller", True),  # somebody else, who is there as well
        ("Frau Mıller", False),  # a dotless i
        ("mueller", True),
        ("\u017f1", False),  # a long s
        ("the patient in bed 3", True),
        ("patient in bed 3", False),
        ("Room 1", True),
        ("Room 12", False),
    ],
)
def test_who_may_be_called_what_in_a_scene(name: str, may: bool) -> None:
    assert desk("ward").oracle.may_be_entity(name) is may


@pytest.mark.parametrize(
    ("name", "may"),
    [
        ("lost child", True),
        ("Child", True),
        ("children", False),
        ("child mom", False),
        ("\u212aid", False),
        ("'kid'", True),
    ],
)
def test_without_a_scene_the_mission_says_who_is_there(name: str, may: bool) -> None:
    """ "Find the lost child and the firefighter's kid, then bring the suitcase to mom at the station"."""
    assert desk("words alone").oracle.may_be_entity(name) is may


@pytest.mark.parametrize(
    ("world", "name", "means"),
    [
        ("ward", "fetch the specimen A", {"fetch-specimen-a"}),  # case and article
        ("ward", "Fetch specimen", set()),  # A or B
        ("ward", "Visit patient", {"visit-patient"}),  # exact, however near the other is
        ("ward", "Fetch spécimen A", {"fetch-specimen-a"}),  # nearer to A than to B by the accent alone
        ("ward", "Fetch spеcimen A", set()),  # a Cyrillic е
        ("words alone", "Search room 3", set()),  # as near to 1 as to 2, and another number
        ("words alone", "Inspect the roosf", set()),  # one slip from roofs, one from roof
        ("site", "Deliver the tool box", {"deliver-the-toolbox"}),
        ("site", "Cook a meal", set()),
    ],
)
def test_what_a_parent_may_mean(world: str, name: str, means: set[str]) -> None:
    assert desk(world).oracle.may_mean(name) == means


def test_a_matching_that_takes_what_looks_alike_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the rule that no letter becomes a plain one, some of the same calls are accepted, and the campaign says so."""
    monkeypatch.setattr("missiontree.authoring.matching._is_disguised", lambda letter: False)
    found = {kind for number in range(1_500) for kind, _ in judge(1, number).violations}
    assert found == {ACCEPTED}


def test_a_near_parent_that_is_not_told_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("missiontree.authoring.builder.find_parent", silent_parent)
    found = {kind for number in range(1_500) for kind, _ in judge(1, number).violations}
    assert UNTOLD in found


def silent_parent(tree: object, name: str) -> tuple[object, tuple[()]]:
    from missiontree.authoring.nodes import find_parent

    return find_parent(tree, name)[0], ()  # type: ignore[arg-type]


def test_every_place_of_a_name_has_true_names_that_are_accepted() -> None:
    """A campaign of refusals alone would show nothing: the true name in the same place must do."""
    for at in desks():
        for slot in SLOTS.values():
            names = list(slot.names(at))
            assert names
            assert all(at.answer(*slot.call(luck(0, 0), at, name))[0].ok for name in names)
