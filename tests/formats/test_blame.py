"""A value says what is wrong in it; the line comes from where the name it quotes was written last."""

from missiontree.formats.blame import culprit

SCENE = {"places": [{"id": "hall"}], "entities": [{"id": "tom", "place": "kitchn"}, {"id": "hall"}]}


def test_the_last_of_equal_names_is_to_blame() -> None:
    assert culprit("entity 'hall' stands twice.", SCENE, ()) == ("entities", 1, "id")


def test_the_last_name_of_the_first_clause_is_to_blame() -> None:
    message = "'tom' is at place 'kitchn', which the scene does not have; 'hall' is one."
    assert culprit(message, SCENE, ()) == ("entities", 0, "place")


def test_keys_and_texts_with_a_field_count_as_names() -> None:
    assert culprit("kind 'cat' stands under itself.", {"kinds": {"cat": "pet"}}, ("x",)) == ("x", "kinds", "cat")
    assert culprit("speaks of 'it'", {"text": "Look at {it}", "note": "it is"}, ()) == ("text",)


def test_without_a_name_the_value_itself_is_to_blame() -> None:
    assert culprit("a fleet needs at least one robot type.", SCENE, ("x", 1)) == ("x", 1)
    assert culprit("robot 'ann' stands twice.", SCENE, ()) == ()
