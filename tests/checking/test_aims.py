"""Worth, order and teams, where a mission asks for a mean, for the least utility or for different teams."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest

from missiontree.allocation.aimed import allocator_for
from missiontree.checking import check, taken_on_trust
from missiontree.formats.inputs import input_digests
from missiontree.mission.alternative import Ranking
from missiontree.mission.brief import MissionBrief
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.grounded import Grounding
from missiontree.mission.plan import Plan, Provenance
from missiontree.planner import NOTHING_FOUND
from missiontree.routines.library import built_in
from tests.builders import and_, grounded, leaf, trivial_fleet, xor_
from tests.checking.missions import random_mission, ruled_mission
from tests.checking.plans import made, measured

PROVEN = Certificate(claim="proven", method="dinkelbach")


def rules(plan: Plan) -> set[str]:
    return {finding.rule for finding in check(plan)}


def with_list(plan: Plan, *places: int) -> Plan:
    """The plan with only the alternatives in these places, ranked anew."""
    assert plan.ranking is not None
    kept = tuple(replace(plan.ranking.alternatives[place], rank=rank) for rank, place in enumerate(places, start=1))
    schedules = tuple(replace(plan.schedules[place], rank=rank) for rank, place in enumerate(places, start=1))
    return replace(plan, ranking=replace(plan.ranking, alternatives=kept), schedules=schedules)


@pytest.mark.parametrize("batch", range(3))
def test_plans_for_any_aim_have_no_findings(batch: int) -> None:
    """Sixty missions, half of them under rules for the whole, each for an aim drawn by luck."""
    outcomes = set()
    for seed in range(batch * 20, (batch + 1) * 20):
        luck = Random(f"aimed:{seed}")  # noqa: S311 - luck for tests, not for secrets
        tree, brief = (random_mission if seed % 2 else ruled_mission)(seed)
        aimed = replace(brief, accumulate=luck.choice(("sum", "mean", "min")), diverse=luck.random() < 0.6)
        plan = made(tree, aimed, k=luck.choice((1, 3, 6)))
        assert check(plan) == (), f"seed {seed}"
        outcomes.add(plan.outcome)
    assert "delivered" in outcomes


def test_claims_about_teams_are_confirmed_where_all_can_be_written_out() -> None:
    assert taken_on_trust(measured()) == ()


def test_a_team_that_is_left_out_refutes_the_claims() -> None:
    """Without the second team the third is no proven second; without the third there are more teams."""
    assert "claim_refuted" in rules(with_list(measured(), 0, 2))
    assert "claim_refuted" in rules(with_list(measured(), 0, 1))


def test_a_bound_on_other_teams_is_held_against_them() -> None:
    """The third team has 0.9: a bound of 0.9 on what is not listed holds, one of 0.8 does not."""
    plan = with_list(measured(), 0, 1)
    assert plan.ranking is not None
    for bound, refuted in ((0.9, False), (0.8, True)):
        certificate = replace(plan.ranking.certificate, bound=bound)
        claimed = replace(plan, ranking=replace(plan.ranking, certificate=certificate))
        assert ("claim_refuted" in rules(claimed)) == refuted


def test_two_alternatives_of_one_team_are_named_with_it() -> None:
    """The plain list of the same mission has several alternatives of both types."""
    plan = measured()
    assert plan.tree is not None
    plain = made(plan.tree, replace(plan.brief, diverse=False))
    claimed = replace(plain, brief=plan.brief, digests=plan.digests)
    messages = [finding.message for finding in check(claimed) if finding.rule == "team_repeated"]
    assert messages[0] == (
        "Alternatives 2 and 3 have the same team (arm, claw), and the mission asks for teams that differ."
    )


def by_hand(*, swapped: bool) -> Plan:
    """
    One action of 333,333 millionths, or three that add up to 1,000,000: both are told as 0.333333, and the second is better.

    Nothing is scheduled, so that only the ranking speaks.
    """
    thirds = [leaf(name, quality=quality) for name, quality in (("a", 0.333333), ("b", 0.333333), ("c", 0.333334))]
    tree = grounded(xor_(leaf("alone", quality=0.333333), and_(*thirds)))
    brief = MissionBrief(text="By hand", fleet=trivial_fleet(), routines=built_in(), accumulate="mean")
    ranking = allocator_for("exact", brief.aim)(tree, brief.fleet, brief.weights, 2, Control())
    first, second = ranking.alternatives
    if swapped:
        first, second = replace(second, rank=1), replace(first, rank=2)
    listed: Ranking = replace(ranking, alternatives=(first, second))
    return Plan(
        outcome="exhausted",
        brief=brief,
        grounding=Grounding(tree=tree),
        ranking=listed,
        reasons=(NOTHING_FOUND,),
        digests=input_digests(brief, None),
        provenance=Provenance(author="given"),
    )


def test_means_that_look_equal_are_ordered_by_what_they_are() -> None:
    assert not {"ranking_unsorted", "utility_wrong", "claim_refuted"} & rules(by_hand(swapped=False))
    assert {"ranking_unsorted", "claim_refuted"} <= rules(by_hand(swapped=True))
