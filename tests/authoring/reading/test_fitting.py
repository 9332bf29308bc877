"""A clause held against one way of understanding it."""

from __future__ import annotations

import pytest

from missiontree.authoring.methods.mention import UnclearError
from missiontree.authoring.methods.method import MethodLibrary, built_in_methods
from missiontree.authoring.methods.outline import NobodyError
from missiontree.authoring.reading.candidates import candidates
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.clauses import clauses_of
from missiontree.authoring.reading.fitting import Fitting
from missiontree.authoring.reading.hearing import Hearing
from missiontree.authoring.reading.outcomes import Goal
from missiontree.authoring.reading.words import words_of_text
from tests.authoring.reading.heard import before, clause_of, hearing, only_by, own_methods, own_routine

TELE, TRUCK, SOCIAL, SCOOTER = "tele_robot", "transportation_robot", "social_robot", "mobile_scooter"


def fitted(clause: Clause, heard: Hearing) -> Goal | None:
    """What the clause comes to by the first way that fits; None if none does."""
    assert clause.verb is not None
    ways = candidates(clause.verb, heard.library, heard.brief.routines, heard.lexicon)
    fitting = (Fitting(heard).fitted(way, clause, clause.words) for way in ways)
    return next((goal for goal in fitting if goal is not None), None)


def goal(text: str, heard: Hearing) -> Goal:
    found = fitted(clause_of(text), heard)
    assert found is not None
    return found


def calls(made: Goal) -> list[str]:
    return [leaf.label for piece in made.outline.pieces for leaf in piece.leaves]


def resources(library: MethodLibrary, *asked: str, without: tuple[str, ...] = ()) -> list[tuple[str, ...]]:
    made = fitted(only_by(clause_of("bring the cup to Anna"), *asked, without=without), hearing(methods=library))
    assert made is not None
    return [leaf.resources for piece in made.outline.pieces for leaf in piece.leaves]


ANYBODY = own_methods('do: "ReachAndTransport(x, y)"')
SOME = own_methods(f'{{do: "ReachAndTransport(x, y)", by: [{SOCIAL}, {TRUCK}]}}')
DISPLAY = own_methods('{do: "ReachAndTransport(x, y)", capability: message_display}')


def test_who_may_do_it_is_who_is_asked_for_of_those_that_the_method_allows_but_for_those_left_out() -> None:
    # In the order of the fleet: scooter, tele-robot, transportation robot, social robot.
    assert resources(ANYBODY) == [()]
    assert resources(ANYBODY, SOCIAL, TELE) == [(TELE, SOCIAL)]
    assert resources(ANYBODY, without=(TELE,)) == [(SCOOTER, TRUCK, SOCIAL)]
    assert resources(SOME) == [(TRUCK, SOCIAL)]
    assert resources(SOME, TRUCK, TELE) == [(TRUCK,)]
    assert resources(SOME, without=(TRUCK,)) == [(SOCIAL,)]
    assert resources(SOME, TRUCK, SOCIAL, without=(SOCIAL,)) == [(TRUCK,)]


def test_nobody_is_left() -> None:
    for asked, without in (((TELE,), ()), ((), (TRUCK, SOCIAL)), ((TRUCK,), (TRUCK,))):
        with pytest.raises(UnclearError, match="no robot type is left that may do it"):
            resources(SOME, *asked, without=without)


def test_capability_that_only_those_left_out_have_is_named() -> None:
    """Of the paper's team only the social robot can display a message."""
    assert resources(DISPLAY) == [(SOCIAL,)]
    for asked, without in (((), (SOCIAL,)), ((TELE,), ())):
        with pytest.raises(NobodyError) as caught:
            resources(DISPLAY, *asked, without=without)
        assert caught.value.capability == "message_display"


def test_pronoun_is_resolved_after_names_and_means_somebody_else() -> None:
    heard = hearing()
    before(heard, "Bob", kind="person")
    before(heard, "doctor", kind="person")
    assert calls(goal("bring him to the doctor", heard)) == ["ReachAndTransport(Bob, Doctor)"]


def test_pronouns_may_fill_both_slots() -> None:
    heard = hearing()
    before(heard, "cup")
    before(heard, "Anna", kind="person")
    assert calls(goal("bring it to her", heard)) == ["ReachAndTransport(Cup, Anna)"]


@pytest.mark.parametrize(
    ("kinds", "kind"),
    [(("place",), "place"), (("animal",), "animal"), (("object", "place"), "object")],  # of two, neither is said
)
def test_kind_of_an_unknown_noun_is_that_of_the_argument_if_it_takes_one_alone(
    kinds: tuple[str, ...], kind: str
) -> None:
    heard = hearing(routines=own_routine("hydrate", *kinds))
    (clause,) = clauses_of(words_of_text("hydrate the blorp"), heard.lexicon)
    made = fitted(clause, heard)
    assert made is not None
    assert [one.kind for piece in made.outline.pieces for one in piece.mentions] == [kind]


def test_condition_that_does_not_hold_is_no_fit() -> None:
    for where, source in (("{x: [object]}", "method own"), ("{x: [lost]}", "routine"), ("{x: [animal]}", "routine")):
        heard = hearing(methods=own_methods('do: "ReachAndTransport(x, y)"', where=where))
        assert f"'bring the cup to Anna': {source}" in goal("bring the cup to Anna", heard).reading


def test_words_that_are_left_over_are_no_fit() -> None:
    for text in ("bring the cup to Anna tomorrow", "bring the cup", "bring to Anna"):
        assert fitted(clause_of(text), hearing()) is None


@pytest.mark.parametrize(
    ("text", "question"),
    [
        ("bring the cup to Anna and Bob", "not clear which of Anna and Bob is meant for which"),
        ("bring each parcel to its owner", "not clear who 'its owner' is for each one"),
        ("bring the cup in the hall and the kitchen to Anna", "not clear what goes with 'in the hall'"),
        ("bring the tele-robot to Anna", "is a robot of the fleet"),
        ("bring it to Anna", "not clear what 'it' means"),
    ],
)
def test_what_fits_and_nobody_can_have_meant_is_asked_for(text: str, question: str) -> None:
    with pytest.raises(UnclearError, match=question):
        fitted(clause_of(text), hearing(methods=ANYBODY))


def test_several_in_the_first_slot_are_each_done() -> None:
    made = goal("bring the cup and the bag to Anna", hearing(methods=ANYBODY))
    assert calls(made) == ["ReachAndTransport(Cup, Anna)", "ReachAndTransport(Bag, Anna)"]
    assert made.slots == 2


def test_reading_names_method_words_and_robots() -> None:
    clause = only_by(clause_of("please bring the cup to Anna"), TELE, TRUCK, without=(SOCIAL,))
    made = fitted(clause, hearing(methods=ANYBODY))
    assert made is not None
    assert made.reading == (
        "'bring the cup to Anna': method own, <bring> {x} to {y}; x = the cup (Cup), y = Anna (Anna); "
        f"only by {TELE}, {TRUCK}; not by {SOCIAL}; passed over: please"
    )


def test_who_was_mentioned_is_remembered_slot_by_slot_and_where_it_came_from() -> None:
    heard = hearing()
    assert goal("bring the cup from the shed to Anna", heard).returns is False
    assert [[one.label for one in group] for group in heard.speakers.said[-1]] == [["Cup"], ["Anna"]]
    assert heard.speakers.starts == {"Cup": "shed"}


def test_those_who_are_called_for_a_hazard_are_told_apart_from_it() -> None:
    heard = hearing(methods=built_in_methods())
    made = goal("rescue the cat from the fire", heard)
    assert "Search(Firefighter)" in calls(made)
    assert heard.called_for == {"fire"}
    assert not any("Fire)" in call for call in calls(made))
