"""Who is meant: pronouns, those who were stated to be lost, and what the scene has under another name."""

from __future__ import annotations

import pytest

from missiontree.authoring.methods.mention import UnclearError
from missiontree.authoring.reading.entities import Speakers
from missiontree.authoring.reading.phrase import Phrase
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene

THEM = Phrase(name="them", text="them", pronoun="several")
IT = Phrase(name="it", text="it", pronoun="thing")


def named(name: str) -> Phrase:
    return Phrase(name=name, text=f"the {name}", determined=True)


def speakers(*clauses: tuple[tuple[str, ...], ...], scene: Scene | None = None) -> Speakers:
    """Those who were mentioned, clause by clause, group by group."""
    made = Speakers(scene or Scene())
    for groups in clauses:
        made.next_clause()
        made.remember(tuple(tuple(m for name in group for m in made.resolve(named(name))) for group in groups))
    made.next_clause()
    return made


def who(made: Speakers, phrase: Phrase) -> list[str]:
    return [mention.label for mention in made.resolve(phrase)]


def test_them_are_those_named_together_though_one_of_them_is_a_plural() -> None:
    assert who(speakers((("keys", "wallet"),)), THEM) == ["Keys", "Wallet"]


ROOMS = Scene(
    places=(Entity(id="lobby", kind="place", label="Lobby"),),
    entities=(
        Entity(id="otto", kind="person", label="Otto"),
        Entity(id="box_1", label="Box 1", traits=("red",)),
        Entity(id="box_2", label="Box 2"),
        Entity(id="box", label="Box"),
    ),
)


def every(name: str, *states: str) -> Phrase:
    return Phrase(name=name, text=f"all {name}", determined=True, every=True, states=states)


def test_all_are_each_of_those_that_the_scene_has() -> None:
    made = speakers(scene=ROOMS)
    assert who(made, every("boxes")) == ["Box 1", "Box 2", "Box"]
    assert who(made, every("boxes", "red")) == ["Box 1"]
    assert who(made, every("places")) == ["Lobby"]
    assert who(made, every("people")) == ["Otto"]


def test_all_of_a_noun_are_those_that_a_number_or_letter_tells_apart() -> None:
    labels = ("Ward Three", "Ward 4", "Gallery A", "Gallery B", "Ward Office")
    places = tuple(Entity(id=label.lower().replace(" ", "_"), kind="place", label=label) for label in labels)
    made = speakers(scene=Scene(places=places))
    assert who(made, every("wards")) == ["Ward Three", "Ward 4"]
    assert who(made, every("galleries")) == ["Gallery A", "Gallery B"]


def test_all_that_the_scene_does_not_tell_apart_are_asked_for() -> None:
    with pytest.raises(UnclearError, match="does not say which of Box 1, Box 2, Box are heavy"):
        speakers(scene=ROOMS).resolve(every("boxes", "heavy"))


def test_several_of_which_a_scene_has_none_are_asked_for_and_not_invented() -> None:
    with pytest.raises(UnclearError, match="has no 'crates'; its objects are Box 1, Box 2, Box"):
        Speakers(ROOMS, complete=True).resolve(every("crates"))
    # Nobody wrote down what there is, so all crates may be.
    assert who(Speakers(Scene()), every("crates")) == ["Crates"]


@pytest.mark.parametrize("name", ["Ötto", "Botto", "Otot", "Ottp"])
def test_name_that_is_nearly_one_of_the_scene_is_asked_for(name: str) -> None:
    with pytest.raises(UnclearError, match=r"did you mean Otto\?"):
        Speakers(ROOMS, complete=True).resolve(Phrase(name=name, text=name))


@pytest.mark.parametrize("name", ["Ottokar", "Thomas", "Mrs Jones"])
def test_name_that_is_like_none_of_the_scene_is_somebody_new(name: str) -> None:
    (new,) = Speakers(ROOMS, complete=True).resolve(Phrase(name=name, text=name))
    assert (new.label, new.kind, new.new, new.plural) == (name, "person", True, False)


def test_them_are_the_two_named_one_by_one() -> None:
    assert who(speakers((("dog",),), (("cat",),)), THEM) == ["Dog", "Cat"]


def test_them_are_the_plural_of_the_nearest_clause() -> None:
    assert who(speakers((("dog",),), (("boxes",), ("cat",))), THEM) == ["Boxes"]


@pytest.mark.parametrize(
    "clauses",
    [
        [(("dog",),)],  # one is not several
        [(("dog",),), (("cat",),), (("bird",),)],  # two of three, or all
        [(("boxes",), ("bags",))],
        [(("boxes",),), (("dog",),)],  # the boxes, or the dog with them
        [],
    ],
)
def test_them_may_be_a_question(clauses: list[tuple[tuple[str, ...], ...]]) -> None:
    with pytest.raises(UnclearError):
        speakers(*clauses).resolve(THEM)


def test_it_may_be_a_child_but_no_other_person() -> None:
    assert who(speakers((("child",),)), IT) == ["Child"]
    with pytest.raises(UnclearError):
        speakers((("nurse",),)).resolve(IT)


def test_who_was_stated_to_be_lost_is_lost_under_every_name() -> None:
    made = speakers((("dog",),))
    made.lost.add("Dog")
    assert made.resolve(named("dog"))[0].to_be_found
    assert made.resolve(IT)[0].to_be_found


def test_what_the_scene_has_under_another_name_is_not_made_anew() -> None:
    scene = Scene(entities=(Entity(id="cup_1", label="Cup 1"), Entity(id="cup_2", label="Cup 2")))
    for name in ("cup 3", "kitchen cup"):
        with pytest.raises(UnclearError, match="Cup 1, Cup 2"):
            Speakers(scene).resolve(named(name))
    assert Speakers(scene).resolve(named("bottle"))[0].new


def test_bare_word_that_is_no_known_noun_is_asked_for() -> None:
    with pytest.raises(UnclearError, match="sleep"):
        Speakers(Scene()).resolve(Phrase(name="sleep", text="sleep"))
    assert Speakers(Scene()).resolve(named("sleep"))[0].kind == "object"
