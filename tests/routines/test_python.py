"""Python functions give the same Routine values as files."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType
from typing import Literal

import pytest

from missiontree.errors import InputError
from missiontree.formats.document import read_text
from missiontree.mission.routine import ActionStep, Branch, Part, RoleSpec
from missiontree.routines.python import collect, routine

YAML = """
routines:
  - id: Inspect
    purpose: "Inspect {thing} and report."
    arguments: [{name: thing, kinds: [object, place]}]
    verbs: [inspect]
    branches:
      - name: inspect
        roles:
          - name: inspector
            rating: inspect
            actions: [{name: look, text: "Look at {thing}", duration_s: 30, at: thing}]
"""


def branch(thing: str) -> Branch:
    look = ActionStep(name="look", text="Look at {thing}", duration_s=30, at=thing)
    return Branch(name="inspect", roles=(RoleSpec(name="inspector", rating="inspect", actions=(look,)),))


@routine(verbs=("inspect",))
def Inspect(thing: Literal["object", "place"]) -> Branch:
    """
    Inspect {thing}
    and report.

    Only the first paragraph is the purpose.
    """
    return branch(thing)


@routine
def Anything(thing):  # type: ignore[no-untyped-def]
    """Inspect {thing}."""
    yield branch(thing)


@routine(same_robot=(0, 1))
def ReachAndInspect(thing: Literal["object"]) -> tuple[Part, ...]:
    """Go to {thing} and inspect it."""
    return Part(routine="Reach", arguments={"agent": thing}), Part(routine="Inspect")


def test_a_function_and_a_file_give_the_same_value() -> None:
    assert Inspect == read_text(YAML, "routines").routines[0]


def test_no_annotation_accepts_every_kind() -> None:
    assert Anything.arguments[0].kinds == ("person", "animal", "object", "place")


def test_parts_make_a_composed_routine() -> None:
    assert [part.routine for part in ReachAndInspect.parts] == ["Reach", "Inspect"]
    assert ReachAndInspect.same_robot == (0, 1)


def test_collect_takes_routines_modules_and_lists() -> None:
    module = ModuleType("mine")
    vars(module).update({"B": Inspect, "alias": Inspect, "A": ReachAndInspect, "other": 3})
    assert collect(Inspect) == (Inspect,)
    assert collect([Inspect, Anything]) == (Inspect, Anything)
    assert collect(module) == (Inspect, ReachAndInspect)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x = 1\n", r"bad\.py: .*defines no routine"),
        ("x = 1\n1 / 0\n", r"bad\.py:2: .*ZeroDivisionError"),
        ("def (\n", r"bad\.py:1: .*SyntaxError"),
        ("import sys\nsys.exit(0)\n", r"bad\.py:2: .*SystemExit"),
    ],
)
def test_a_bad_module_is_named_with_what_is_wrong(tmp_path: Path, text: str, message: str) -> None:
    """Even one that would end the program: an exit code of 0 would say that there is a plan."""
    path = tmp_path / "bad.py"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=message):
        collect(path)


@pytest.mark.parametrize("source", ["no_such_module_anywhere", Path("none.py")])
def test_a_module_that_is_not_there(source: str | Path) -> None:
    with pytest.raises(InputError):
        collect(source)


def test_a_function_that_makes_no_routine_says_why() -> None:
    def Bad(thing: int) -> Branch:
        return branch(thing)  # type: ignore[arg-type]

    with pytest.raises(InputError, match="does not name entity kinds"):
        routine(Bad)

    def Wrong(other: Literal["object"]) -> Branch:
        return branch("thing")

    with pytest.raises(InputError, match="speaks of 'thing'"):
        routine(Wrong)
