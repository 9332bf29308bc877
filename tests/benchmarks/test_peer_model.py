"""The 0-1 programme that peers are given says the same as the tree."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from itertools import product
from pathlib import Path

import pytest

from benchmarks.peer_model import ALWAYS, Answer, Programme, answer_from_command_line, programme
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.formats.importers.tree_grounded import fleet_of, grounded_of
from missiontree.mission.columns import WEIGHTS
from missiontree.mission.control import Control
from tests.formats.tree_files import random_tree, read, small

FEW = 12


def enumerated(asked: Programme) -> list[float]:
    """Values of all that keeps the rows, best first."""
    values = []
    for point in product((0, 1), repeat=asked.variables):
        taken = {variable for variable, value in enumerate(point) if value} | {ALWAYS}
        one_each = all(
            (parent in taken) == sum(child in taken for child in children) for parent, children in asked.exactly_one
        )
        within = all(
            sum(amount for variable, amount in uses.items() if variable in taken) <= budget
            for uses, budget in zip(asked.uses, asked.budget, strict=True)
        )
        if one_each and within:
            values.append(float(sum(gain for variable, gain in asked.gain.items() if variable in taken)))
    return sorted(values, reverse=True)


def test_the_small_tree_row_by_row() -> None:
    """Variables 0 and 1 are leaves 3 and 4, of which the XOR takes one; leaf 2 is always selected."""
    asked = programme(small(), budgets=True)
    assert asked.variables == 2
    assert asked.gain == {ALWAYS: 10, 0: 9, 1: 7}
    assert asked.exactly_one == [(ALWAYS, [0, 1])]
    assert asked.uses == [{ALWAYS: 4, 0: 5}, {1: 1}]
    assert asked.budget == [8, 3]


def test_points_of_the_programme_are_the_alternatives_of_the_tree() -> None:
    looked_at = 0
    for seed in range(300):
        data = random_tree(seed) | {"disjoint": []}
        data.setdefault("consumption", [0] * len(data["kind"]))
        columns = read(data)
        for budgets in (True, False):
            asked = programme(data, budgets)
            if asked.variables > FEW:
                continue
            looked_at += 1
            truth = Exhaustive()(grounded_of(columns), fleet_of(columns, budgets=budgets), WEIGHTS, 10**6, Control())
            assert enumerated(asked) == [one.utility for one in truth.alternatives], seed
    assert looked_at > 200


def test_a_peer_is_asked_for_one_instance_and_answers_in_one_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """The first call loads the solver by a programme of its own; only the second is told."""
    file = tmp_path / "tree.json"
    file.write_text(json.dumps(small()), encoding="utf-8")
    asked: list[tuple[Programme, int, int]] = []

    def solve(given: Programme, k: int, left: Callable[[], float], seed: int) -> Answer:
        assert left() > 0
        asked.append((given, k, seed))
        return Answer(values=enumerated(given)[:k], proven=True)

    monkeypatch.setattr(sys, "argv", ["peer", str(file), "3", "60", "7", "True"])
    answer_from_command_line(solve)
    told = json.loads(capsys.readouterr().out)
    assert (told["values"], told["proven"], told["note"]) == ([17.0], True, "")
    assert asked[1] == (programme(small(), budgets=True), 3, 7)
    assert len(asked) == 2
