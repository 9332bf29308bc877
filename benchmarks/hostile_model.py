"""
Can a model do harm that says whatever it likes? Any sequence of calls, on small missions drawn by luck, through the whole road.

::

    python -m benchmarks.hostile_model --count 100000 --seed 1 --state hostile.json --jobs 2

Each dialogue is held by a player that means no good; what comes of it is looked at as in the campaign of malformed streams. A tree
that is complete goes on: it is grounded, staffed, scheduled and checked, and then audited by code that shares nothing with the checker.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from benchmarks.campaign import Campaign, Verdict, luck, run
from benchmarks.campaign_audit import plan_breaches, tree_breaches
from benchmarks.campaign_history import NEVER, Violation, asked_of, faults_of
from benchmarks.campaign_missions import random_mission
from benchmarks.campaign_player import HostileModel
from missiontree.authoring.author import author_tree
from missiontree.authoring.budgets import Budgets
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.errors import InternalError
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.planner import plan_authored

RULES = "plans that break a rule of the fleet or the scene"
CHECKER = "plans that the checker refuses"
COUNT = 100_000


def random_budgets(rng: Random) -> Budgets:
    """Those that are usual, or narrow ones."""
    if rng.random() < 0.65:
        return Budgets()
    return Budgets(
        turns=rng.randint(1, 12),
        calls=rng.randint(1, 20),
        refusals=rng.randint(1, 6),
        repeats=rng.randint(1, 4),
        tokens=rng.choice((5_000, 20_000, 500_000)),
        reminders=rng.randint(0, 2),
        reviews=rng.randint(0, 2),
    )


def judge(seed: int, index: int) -> Verdict:
    """Let a hostile model loose on a mission, and look at everything that comes of it."""
    rng = luck(seed, index)
    brief, budgets = random_mission(rng), random_budgets(rng)
    model = HostileModel(rng, brief)
    made = author_tree(brief, model, budgets)
    violations = list(faults_of(made, brief, budgets, model.seen))
    asked = asked_of(made.transcript)
    if made.tree is not None and made.status == "complete":
        violations += [(RULES, breach) for breach in tree_breaches(made.tree, brief, asked)]
    counts = {made.status: 1, "calls": len(asked), "calls accepted": sum(call.ok for call in asked)}
    if made.status == "complete":
        outcome, breaches = _rest_of_the_road(brief, made)
        violations += breaches
        counts[f"plan {outcome}"] = 1
    return Verdict("builds" if model.builds else "wild", counts, tuple(violations))


def _rest_of_the_road(brief: MissionBrief, made: Authored) -> tuple[str, list[Violation]]:
    request = Request(brief=brief, k=2)
    try:
        plan = plan_authored(request, made, Control())
    except InternalError as error:
        return "refused", [(CHECKER, str(error))]
    return plan.outcome, [(RULES, breach) for breach in _breaches(plan)]


def _breaches(plan: Plan) -> Iterator[str]:
    if plan.outcome == "delivered":
        yield from plan_breaches(plan)
    elif plan.schedules and any(schedule.actions for schedule in plan.schedules):
        yield f"the outcome is {plan.outcome}, and robots are given work"


CAMPAIGN = Campaign("hostile model", __doc__, COUNT, judge, (*NEVER, RULES, CHECKER))

if __name__ == "__main__":
    run(CAMPAIGN)
