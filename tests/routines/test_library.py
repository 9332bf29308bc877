"""The built-in routines are files like everybody's; users add theirs."""

from __future__ import annotations

from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.routines.library import built_in, load, with_routines
from missiontree.routines.python import collect

LOOK = """
format: routines/1
routines:
  - id: {id}
    purpose: "Look at {{thing}}."
    arguments: [{{name: thing, kinds: [object]}}]
    branches:
      - name: look
        roles: [{{name: looker, rating: look, actions: [{{name: look, text: "Look at {{thing}}"}}]}}]
"""


def write(folder: Path, name: str, text: str) -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_the_papers_six_are_built_in() -> None:
    names = [routine.id for routine in built_in().routines]
    assert names == ["Search", "Follow", "Reach", "Transport", "SearchAndFollow", "ReachAndTransport"]
    arguments = {routine.id: tuple(routine.argument_kinds) for routine in built_in().routines}
    assert arguments["ReachAndTransport"] == arguments["Transport"] == ("agent", "location")
    assert {arguments[name] for name in ("Search", "Follow", "Reach", "SearchAndFollow")} == {("agent",)}


@pytest.mark.parametrize(
    ("routine", "texts"),
    [
        (
            "Search",
            ["Get search path to find {agent}", "Detect {agent}", "Report detection of {agent} to server"],
        ),
        ("Follow", ["Get path to follow {agent}", "Follow {agent}", "Send location of {agent} to server"]),
        ("Reach", ["Get {agent} location to reach", "Get to {agent} location"]),
    ],
)
def test_action_texts_are_the_papers(routine: str, texts: list[str]) -> None:
    (branch,) = built_in().by_id[routine].branches
    assert [action.text for action in branch.roles[0].actions] == texts


def test_every_built_in_routine_has_verbs_and_no_two_share_one() -> None:
    verbs = [verb for routine in built_in().routines for verb in routine.verbs]
    assert all(routine.verbs for routine in built_in().routines)
    assert len(verbs) == len(set(verbs))


def test_users_files_come_after_the_built_in_ones_and_may_use_them(tmp_path: Path) -> None:
    composed = """
format: routines/1
routines:
  - id: ReachAndLook
    purpose: "Go to {thing} and look."
    arguments: [{name: thing, kinds: [object]}]
    parts: [{routine: Reach, arguments: {agent: thing}}, {routine: Look}]
    same_robot: [0, 1]
"""
    library = load([write(tmp_path, "a.yaml", composed), write(tmp_path, "b.yaml", LOOK.format(id="Look"))])
    assert [routine.id for routine in library.routines][6:] == ["ReachAndLook", "Look"]


@pytest.mark.parametrize("taken", ["Search", "SearchTree"])
def test_a_built_in_name_is_not_replaced_silently(tmp_path: Path, taken: str) -> None:
    path = write(tmp_path, "mine.yaml", LOOK.format(id=taken))
    with pytest.raises(InputError, match="already") as caught:
        load([path])
    assert caught.value.file == str(path)


def test_two_files_with_one_name_are_told_apart(tmp_path: Path) -> None:
    first, second = (write(tmp_path, name, LOOK.format(id="Look")) for name in ("a.yaml", "b.yaml"))
    with pytest.raises(InputError, match="defines it too") as caught:
        load([first, second])
    assert caught.value.file == str(second)


def test_an_unknown_part_names_the_file(tmp_path: Path) -> None:
    text = """
routines:
  - {id: Odd, purpose: p, arguments: [{name: a, kinds: [object]}], parts: [{routine: Missing}]}
"""
    path = write(tmp_path, "odd.yaml", text)
    with pytest.raises(InputError, match="'Missing', which is not known") as caught:
        load([path])
    assert caught.value.file == str(path)


def test_a_missing_file_is_bad_input(tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        load([tmp_path / "none.yaml"])
    assert caught.value.file == str(tmp_path / "none.yaml")


def test_python_files_load_like_yaml(tmp_path: Path) -> None:
    text = '''
from missiontree.mission.routine import ActionStep, Branch, RoleSpec
from missiontree.routines.python import routine

@routine(verbs=("look at",))
def Look(thing):
    """Look at {thing}."""
    look = ActionStep(name="look", text="Look at {thing}")
    return Branch(name="look", roles=(RoleSpec(name="looker", rating="look", actions=(look,)),))
'''
    library = load([write(tmp_path, "mine.py", text)])
    assert library.by_id["Look"].verbs == ("look at",)


def test_a_composition_that_cannot_be_flattened_is_refused_when_loaded(tmp_path: Path) -> None:
    pair = LOOK.format(id="PairLook").replace("rating: look,", "rating: look, robots: 2,")
    both = """
routines:
  - id: Both
    purpose: "Both"
    arguments: [{name: thing, kinds: [object]}]
    parts: [{routine: Reach, arguments: {agent: thing}}, {routine: PairLook}]
    same_robot: [0, 1]
"""
    with pytest.raises(InputError, match="part 1 is done by one robot"):
        load([write(tmp_path, "a.yaml", pair), write(tmp_path, "b.yaml", both)])


def test_with_routines_adds_values(tmp_path: Path) -> None:
    library = load([write(tmp_path, "a.yaml", LOOK.format(id="Look"))])
    assert with_routines(built_in(), collect(library.by_id["Look"])) == library


def test_a_file_named_twice_is_read_once(tmp_path: Path) -> None:
    path = write(tmp_path, "a.yaml", LOOK.format(id="Look"))
    assert load([path, tmp_path / "." / ".." / tmp_path.name / "a.yaml"]) == load([path])
