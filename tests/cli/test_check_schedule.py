"""``missiontree check SCHEDULE --instance FILE``: what is sound, what is not and why, and what is no such schedule."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.cli.running import Shell
from tests.cli.test_schedule import SHOP, written
from tests.formats.test_coalitions import GOOD
from tests.formats.tree_files import small

INSTANCES = {"shop.txt": SHOP, "mission.json": json.dumps(GOOD), "tree.json": json.dumps(small())}


def scheduled(shell: Shell, folder: Path, name: str, damage: Callable[[Any], None] = lambda told: None) -> str:
    """A file with the schedule of an instance, damaged somehow."""
    told = json.loads(shell("schedule", written(folder, name, INSTANCES[name]), "--json", "--no-solver").out)
    damage(told)
    return written(folder, "schedule.json", json.dumps(told))


@pytest.mark.parametrize("name", INSTANCES)
def test_what_schedule_prints_is_sound_and_its_bound_is_taken_on_trust(shell: Shell, tmp_path: Path, name: str) -> None:
    file = scheduled(shell, tmp_path, name)
    ran = shell("check", file, "--instance", name)
    assert ran.code == 0
    assert ran.out.startswith(f"sound: schedule.json keeps every rule of {name}\nnot confirmed: none is shorter than ")
    told = json.loads(shell("check", file, "--instance", name, "--json").out)
    assert (told["sound"], told["findings"], len(told["taken_on_trust"])) == (True, [], 1)


def put_off(told: Any) -> None:
    """The last action with some length begins and ends a second later; the makespan stays."""
    last = next(one for one in reversed(told["actions"]) if one["end_s"] > one["start_s"])
    last["start_s"], last["end_s"] = last["start_s"] + 1, last["end_s"] + 1


def at_once(told: Any) -> None:
    """Everything begins at 0."""
    for one in told["actions"]:
        one["end_s"] -= one["start_s"]
        one["start_s"] = 0


def dropped(told: Any) -> None:
    del told["actions"][0]


def boasting(told: Any) -> None:
    """The bound lies above the makespan."""
    told["bound_s"] = told["makespan_s"] + 1


def by_magic(told: Any) -> None:
    told["method"] = "magic"


@pytest.mark.parametrize("damage", [put_off, at_once, dropped, boasting, by_magic])
@pytest.mark.parametrize("name", INSTANCES)
def test_a_damaged_schedule_is_not_sound(
    shell: Shell, tmp_path: Path, name: str, damage: Callable[[Any], None]
) -> None:
    ran = shell("check", scheduled(shell, tmp_path, name, damage), "--instance", name)
    assert ran.code == 6
    assert "found in schedule.json" in ran.out
    assert json.loads(shell("check", "schedule.json", "--instance", name, "--json").out)["sound"] is False


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (lambda told: told.pop("actions"), "'actions' is missing"),
        (lambda told: told.update(actions={}), "a list of actions"),
        (lambda told: told.update(status="best"), "optimal, feasible, infeasible, unknown"),
        (lambda told: told["actions"][0].update(node=99), "a whole number from 0 to"),
        (lambda told: told["actions"][0].update(node="a"), "a number of at least 0"),
        (lambda told: told["actions"][0].update(number=True), "a number of at least 0"),
        (lambda told: told["actions"][1].update(node=told["actions"][0]["node"]), "a second time"),
        (lambda told: told["actions"][0].update(end_s=77), "as the instance says"),
        (lambda told: told["actions"][0].update(start_s=0.5), "a whole number"),
        (lambda told: told.update(chosen=[1]), "a mapping from XOR to child"),
        (lambda told: told.update(chosen={"x": 1}), "the number of an XOR"),
        (lambda told: told.update(method=3), "the name of a method"),
        (lambda told: told.update(makespan_s=-1), "a number of at least 0"),
    ],
)
def test_what_is_no_such_schedule_is_refused_in_words(
    shell: Shell, tmp_path: Path, damage: Callable[[Any], None], words: str
) -> None:
    ran = shell("check", scheduled(shell, tmp_path, "shop.txt", damage), "--instance", "shop.txt")
    assert ran.code == 2
    assert words in " ".join(ran.err.split())
    assert "schedule.json" in ran.err
    assert "Traceback" not in ran.err


def test_a_schedule_of_another_instance_is_refused_or_found_out(shell: Shell, tmp_path: Path) -> None:
    file = scheduled(shell, tmp_path, "shop.txt")
    written(tmp_path, "tree.json", INSTANCES["tree.json"])
    assert shell("check", file, "--instance", "tree.json").code in {2, 6}
    written(tmp_path, "text.json", "[1]")
    assert shell("check", "text.json", "--instance", "shop.txt").code == 2
