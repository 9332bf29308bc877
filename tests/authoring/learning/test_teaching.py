"""A method that is learned from a tree, and tried before it is handed out."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.authoring.edits import with_times
from missiontree.authoring.learning import teaching
from missiontree.authoring.learning.teaching import method_from
from missiontree.authoring.methods.method import Method, MethodLibrary, built_in_methods, read_methods
from missiontree.authoring.offline import author_offline
from missiontree.errors import InputError
from tests.builders import brief_of

RESCUE = "Rescue the child from the barn"
BRING = "Bring the keys to Anna"
SAYS = "bring {keys} to {anna}"


def other(method_id: str, says: str) -> MethodLibrary:
    """The built-in methods, and one that only goes to where somebody is."""
    text = f"""format: methods/1
methods:
  - id: {method_id}
    purpose: For a test.
    says: ["{says}"]
    steps:
      - {{do: Reach(x)}}
"""
    return MethodLibrary(methods=(*read_methods(text, "own.yaml").methods, *built_in_methods().methods))


def learned(text: str, methods: MethodLibrary | None = None, method_id: str = "", says: str = "") -> Method:
    brief = replace(brief_of(), text=text)
    tree = author_offline(brief, built_in_methods()).tree
    assert tree is not None
    return method_from(tree, brief, methods or built_in_methods(), method_id, says)


def test_method_whose_mission_another_method_takes_is_refused() -> None:
    with pytest.raises(InputError, match=r"not understood by its pattern .* but by another method"):
        learned(BRING, other("another", "bring the keys to {x}"), says=SAYS)


def test_method_is_tried_in_place_of_the_one_of_its_id() -> None:
    made = learned(BRING, other("mine", "bring the keys to {x}"), method_id="mine", says=SAYS)
    assert (made.id, made.says) == ("mine", (SAYS,))


def test_tree_of_very_many_routines_is_no_lesson(monkeypatch: pytest.MonkeyPatch) -> None:
    learned(RESCUE)
    monkeypatch.setattr(teaching, "MAX_ROUTINES", 1)
    with pytest.raises(InputError, match="the tree has 2 routines") as raised:
        learned(RESCUE)
    assert raised.value.accepted == "at most 1"


@pytest.mark.parametrize("words", ["with the tele-robot", "without the tele-robot"])
def test_robots_that_the_words_name_are_no_part_of_the_method(words: str) -> None:
    (step,) = learned(f"Find the keys {words}").steps
    assert (step.do, step.by) == ("Search(object)", ())


def test_robots_that_the_words_do_not_name_are_a_part_of_it() -> None:
    (step,) = learned("Find the keys with the tele-robot", says="seek out {keys}").steps
    assert step.by == ("tele_robot",)


def test_a_tree_with_times_is_no_lesson() -> None:
    """A method could not hold them, and would drop them unsaid."""
    brief = replace(brief_of(), text=RESCUE)
    tree = author_offline(brief, built_in_methods()).tree
    assert tree is not None
    timed = with_times(tree, tree.nodes[-1].id, 0.0, 60.0)
    with pytest.raises(InputError, match=r"has times \(by 60 s\), and a method has none"):
        method_from(timed, brief, built_in_methods(), "", "")
