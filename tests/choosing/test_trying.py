"""What is known of alternatives once somebody says stop: nothing that takes long to find out."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.random_missions import write_mission
from missiontree import plan
from missiontree.choosing.trying import Trials
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.scheduling import SCHEDULERS


def least(made: Plan, control: Control) -> int:
    """What trials say of the best alternative of a plan before they schedule anything."""
    assert made.grounding is not None
    assert made.ranking is not None
    brief = made.brief
    trials = Trials(made.grounding.tree, brief, brief.world, SCHEDULERS["greedy"], control)
    return trials.least(made.ranking.alternatives[0]).least


@pytest.mark.parametrize("stopped", [False, True])
def test_the_bound_of_a_large_alternative_is_worked_out_only_if_somebody_waits_for_it(
    tmp_path: Path, stopped: bool
) -> None:
    made = plan(write_mission(tmp_path, 20, 6, 1), k=1)
    assert (least(made, Control(stop=lambda: stopped)) == 0) is stopped


def test_the_bound_of_a_small_alternative_is_worked_out_in_any_case() -> None:
    made = plan("Find the cat", k=1)
    assert least(made, Control(stop=lambda: True)) == least(made, Control()) > 0
