"""The steps of a method with its slots filled."""

from __future__ import annotations

import pytest

from missiontree.authoring.methods.mention import Mention
from missiontree.authoring.methods.method import Method, read_methods
from missiontree.authoring.methods.outline import NobodyError, Outline, StepError, fill, outline_of, restrict
from missiontree.formats.document import read_file
from missiontree.mission.fleet import Fleet
from missiontree.routines.library import built_in
from missiontree.samples.catalogue import FOLDER

FLEET: Fleet = read_file(FOLDER / "fleet.yaml", "fleet")
DOG, CAT = (Mention(name, name, f"Lost {name}", "animal") for name in ("Dog", "Cat"))
ANNA = Mention("Anna", "Anna", "Anna", "person", determined=False)
KNOWN = Mention("box", "Box", "Box", "object", new=False, known=True)


def method(steps: str) -> Method:
    text = f"""format: methods/1
methods:
  - id: own
    purpose: For a test.
    says: ["<bring> {{x}} to {{y}}"]
    steps:
{steps}"""
    return read_methods(text, "own.yaml").methods[0]


def shown(outline: Outline) -> list[str]:
    return [piece.label for piece in outline.all_pieces]


TASK = """
      - {do: Search(x), name: find, unless_known: x}
      - task: "Unite {the x} and {the y}"
        after: [find]
        gate: xor
        steps:
          - {do: "ReachAndTransport(x, y)"}
          - {do: "ReachAndTransport(y, x)"}
"""


def test_tasks_stand_before_what_they_consist_of() -> None:
    built = outline_of(method(TASK), {"x": (DOG,), "y": (ANNA,)}, built_in(), FLEET)
    assert shown(built) == [
        "Search(Dog)",
        "Unite the Dog and Anna",
        "ReachAndTransport(Dog, Anna)",
        "ReachAndTransport(Anna, Dog)",
    ]
    assert built.pieces[1].gate == "xor"
    assert [(first.label, second.label, kind) for first, second, kind in built.links] == [
        ("Search(Dog)", "Unite the Dog and Anna", "precedence")
    ]


def test_step_is_built_for_each_and_left_out_for_nobody() -> None:
    assert shown(outline_of(method(TASK), {"x": (DOG, CAT), "y": (ANNA,)}, built_in(), FLEET))[:2] == [
        "Search(Dog)",
        "Search(Cat)",
    ]
    assert shown(outline_of(method(TASK), {"x": (), "y": (ANNA,)}, built_in(), FLEET)) == []


def test_what_is_known_is_not_searched_for_and_leaves_no_link() -> None:
    built = outline_of(method(TASK), {"x": (KNOWN,), "y": (ANNA,)}, built_in(), FLEET)
    assert shown(built)[0] == "Unite the Box and Anna"
    assert built.links == []


def test_task_that_is_left_out_takes_its_steps_with_it() -> None:
    steps = """
      - task: "Find {x}"
        unless_known: x
        steps: [{do: Search(x), name: find}]
      - {do: Reach(x), after: [find]}
"""
    built = outline_of(method(steps), {"x": (KNOWN,), "y": (ANNA,)}, built_in(), FLEET)
    assert shown(built) == ["Reach(Box)"]
    assert built.links == []


def test_deep_steps_are_built_without_recursion() -> None:
    steps = '{do: "Search(x)"}'
    for number in range(12):
        steps = f'{{task: "Level {number}", steps: [{steps}]}}'
    built = outline_of(method(f"      - {steps}\n"), {"x": (DOG,), "y": (ANNA,)}, built_in(), FLEET)
    assert shown(built) == [*(f"Level {number}" for number in range(11, -1, -1)), "Search(Dog)"]


def test_wrong_number_of_arguments_is_said() -> None:
    with pytest.raises(StepError, match="it takes 1"):
        outline_of(method('      - {do: "Search(x, y)"}\n'), {"x": (DOG,), "y": (ANNA,)}, built_in(), FLEET)


def test_slots_are_filled_with_and_without_article_and_states() -> None:
    bindings = {"x": (DOG, ANNA)}
    assert fill("{x}; {the x}; {full x}; {the full x}", bindings) == (
        "Dog and Anna; the Dog and Anna; Lost Dog and Anna; the Lost Dog and Anna"
    )


def allowed(steps: str) -> list[tuple[str, ...]]:
    built = outline_of(method(steps), {"x": (DOG,), "y": (ANNA,)}, built_in(), FLEET)
    return [piece.resources for piece in built.all_pieces if piece.routine is not None]


def test_a_step_names_the_robot_types_that_may_do_it_and_what_it_consists_of() -> None:
    steps = """
      - task: "Fetch {x}"
        by: [tele_robot, social_robot]
        steps:
          - {do: Search(x)}
          - {do: Follow(x), by: [mobile_scooter, social_robot]}
      - {do: Reach(y)}
"""
    # Follow: those of its own that the task allows too.
    assert allowed(steps) == [("tele_robot", "social_robot"), ("social_robot",), ()]


def test_a_step_asks_for_a_capability_and_only_the_types_that_have_it_may_do_it() -> None:
    # In the paper's team two types can search, and one can display a message.
    assert allowed("      - {do: Search(x), capability: search}\n") == [("tele_robot", "transportation_robot")]
    assert allowed("      - {do: Reach(x), capability: message_display}\n") == [("social_robot",)]
    with pytest.raises(NobodyError, match="no robot type has the capability teleport") as caught:
        allowed("      - {do: Reach(x), capability: teleport}\n")
    assert caught.value.capability == "teleport"


def test_robot_types_that_leave_nobody_are_refused_in_words() -> None:
    with pytest.raises(StepError, match="allows only robot type crane; the fleet has mobile_scooter"):
        allowed("      - {do: Reach(x), by: [crane]}\n")
    with pytest.raises(StepError, match="none has the capability search"):
        allowed("      - {do: Reach(x), by: [social_robot], capability: search}\n")
    apart = """
      - task: "Fetch {x}"
        by: [tele_robot]
        steps: [{do: Search(x), by: [social_robot]}]
"""
    with pytest.raises(StepError, match="social_robot on the one hand, tele_robot on the other"):
        allowed(apart)
    built = outline_of(method("      - {do: Reach(x), by: [tele_robot]}\n"), {"x": (DOG,), "y": ()}, built_in(), FLEET)
    restrict(built.pieces, ("tele_robot", "social_robot"))
    assert built.pieces[0].resources == ("tele_robot",)
