"""What is known before the first clause is read."""

from __future__ import annotations

from missiontree.authoring.methods.method import built_in_methods
from missiontree.authoring.reading.hearing import hearing_of
from missiontree.authoring.reading.words import words_of_text
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene
from tests.authoring.reading.heard import hearing, own_methods, own_routine
from tests.builders import brief_of

YARD = Scene(
    places=(Entity(id="north_gate", kind="place", label="The Gate", aliases=("way-out",)),),
    entities=(Entity(id="rex", kind="dog", label="Rex"),),
    kinds={"dog": "animal"},
)


def test_names_of_the_scene_are_known_with_their_base_kinds() -> None:
    known = hearing(YARD).phrases.known
    for name in ("north_gate", "north gate", "the gate", "way-out", "way out"):
        assert known[name] == "place"
    assert known["rex"] == "animal"
    assert "dog" not in known


def test_whether_somebody_wrote_down_what_there_is() -> None:
    assert hearing(YARD).speakers.complete
    assert not hearing().speakers.complete


def test_verbs_of_methods_and_routines_are_known_beside_those_of_the_language() -> None:
    assert hearing().lexicon.verb_at(["hydrate"], 0, "base") is None
    assert hearing(methods=own_methods("do: Search(x)", "hydrate {x}")).lexicon.verb_at(["hydrate"], 0, "base")
    heard = hearing(routines=own_routine("Hydrate", "object"))
    assert heard.lexicon.verb_at(["hydrating"], 0, "gerund")


def test_robots_are_known_by_name_but_for_those_that_the_scene_calls_so() -> None:
    assert hearing().advice.named_in("the social robot") == ["Social Robot"]
    statue = Scene(entities=(Entity(id="social_robot", label="Social Robot"),))
    assert hearing(statue).advice.named_in("the social robot") == []


def test_nobody_was_mentioned_and_nothing_is_wrong() -> None:
    heard = hearing_of(brief_of(scene=YARD), built_in_methods())
    assert (heard.speakers.said, heard.hazards, heard.called_for) == ([], [], set())
    assert heard.phrases.phrases(words_of_text("Rex"))
