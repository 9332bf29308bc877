"""What was grounded anew beforehand serves the plan that it was made of, and no other."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.checking import check, regrounding
from missiontree.checking.regrounding import Regrounding
from missiontree.mission.grounded import Grounding
from missiontree.mission.plan import Plan
from tests.checking.plans import PLANS

EVERY = pytest.mark.parametrize("name", PLANS)


def beforehand(plan: Plan) -> Regrounding:
    assert plan.tree is not None
    assert plan.grounding is not None
    return regrounding.regrounding(plan.tree, plan.brief, plan.grounding.estimates)


@EVERY
def test_a_sound_plan_is_sound_with_it_and_needs_no_further_grounding(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = PLANS[name]()
    known = beforehand(plan)

    def refused(*given: object) -> Grounding:
        raise ValueError("grounded once more")

    monkeypatch.setattr(regrounding, "ground", refused)
    assert check(plan, known) == ()
    assert "grounded once more" in check(plan)[0].message


@EVERY
def test_it_says_nothing_of_another_plan(name: str) -> None:
    """The label of an action is changed in the grounding and in the tree grounded beforehand, which would pass together."""
    plan = PLANS[name]()
    assert plan.grounding is not None
    tree = plan.grounding.tree
    at = next(index for index, node in enumerate(tree.nodes) if node.action is not None)
    nodes = (*tree.nodes[:at], replace(tree.nodes[at], label="forged"), *tree.nodes[at + 1 :])
    grounding = replace(plan.grounding, tree=replace(tree, nodes=nodes))
    forged = replace(plan, grounding=grounding)
    known = beforehand(plan)._replace(found=grounding)
    assert check(replace(forged, brief=replace(plan.brief)), known)


def test_a_tree_that_cannot_be_grounded_is_told_of() -> None:
    plan = next(iter(PLANS.values()))()
    assert plan.tree is not None
    routine = next(index for index, node in enumerate(plan.tree.nodes) if node.routine)
    nodes = list(plan.tree.nodes)
    nodes[routine] = replace(nodes[routine], routine="no-such-routine")
    broken = replace(plan, tree=replace(plan.tree, nodes=tuple(nodes)))
    known = beforehand(broken)
    assert isinstance(known.found, str)
    assert check(broken, known) == check(broken) != ()
