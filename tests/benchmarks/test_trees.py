"""The generator of instances: the same bytes for ever, and the shape that is promised."""

from __future__ import annotations

import json
import sys
from hashlib import sha256
from random import Random

import pytest

from benchmarks.trees import AND, LEAF, XOR, Growing, budgets, instance, main, text_of
from tests.formats.tree_files import read


@pytest.mark.parametrize(
    ("arguments", "digest"),
    [
        (("mission", 60, 4, 1), "29203618e1450eed86f56bfa205a7b80b4fc0b13f01fbbf4f9169dcc8f1b727a"),
        (("uniform", 50, 3, 2), "1bd9e6d51c5c5a7875fc8e17a1fc6b1396d0621a589b713c8df4ee8e77f42bc4"),
    ],
)
def test_same_arguments_same_bytes(arguments: tuple[str, int, int, int], digest: str) -> None:
    """Published tables rest on these bytes."""
    assert sha256(text_of(instance(*arguments)).encode()).hexdigest() == digest


def test_the_command_writes_those_bytes(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "argv", ["trees", "uniform", "50", "3", "2", "0.5"])
    main()
    assert capsys.readouterr().out == text_of(instance("uniform", 50, 3, 2, 0.5))


def test_a_tree_without_leaves_or_robots_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    for arguments in (("0", "3"), ("5", "0")):
        monkeypatch.setattr(sys, "argv", ["trees", "uniform", *arguments, "1"])
        with pytest.raises(SystemExit):
            main()


def test_every_tree_is_one_that_the_importer_reads() -> None:
    for family in ("mission", "uniform"):
        for seed in range(20):
            for leaves, robots in ((1, 1), (2, 3), (40, 2), (90, 5)):
                read(json.loads(text_of(instance(family, leaves, robots, seed))))


def test_a_uniform_tree_has_its_leaves_and_alternates() -> None:
    for leaves in (1, 2, 3, 17, 64):
        tree = instance("uniform", leaves, 3, leaves)
        kind, parent = tree["kind"], tree["parent"]
        assert kind.count(LEAF) == leaves
        assert all(
            kind[node] + kind[above] == AND + XOR for node, above in enumerate(parent) if above >= 0 and kind[node]
        )


def test_a_mission_has_leaves_enough_and_chains_of_three_by_one_robot() -> None:
    tree = instance("mission", 100, 5, 3)
    kind, parent, robot = tree["kind"], tree["parent"], tree["robot"]
    assert kind.count(LEAF) >= 100
    chains: dict[int, list[int]] = {}
    for node, gate in enumerate(kind):
        if gate == LEAF:
            chains.setdefault(parent[node], []).append(robot[node])
    assert all(len(chain) == 3 and len(set(chain)) == 1 for chain in chains.values())


def test_budgets_are_those_that_the_best_selection_gives() -> None:
    """
    The XOR takes leaf 3 (9 above 5), so robot 1 uses 60 and robot 0 its 20 of leaf 4: 40 on average. Half of 60 is 30 for the robot
    above the average, and the other may use the average. Tightness 0.1 gives 6, and 10 is the least.
    """
    tree = Growing(2, Random(0))  # noqa: S311 - nothing is drawn
    tree.kind, tree.parent = [AND, XOR, LEAF, LEAF, LEAF], [-1, 0, 1, 1, 0]
    tree.robot, tree.utility, tree.consumption = [0, 0, 0, 1, 0], [0, 0, 5, 9, 1], [0, 0, 40, 60, 20]
    assert budgets(tree, 0.5) == [40, 30]
    assert budgets(tree, 0.1) == [40, 10]
