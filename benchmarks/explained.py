"""
Are explanations right? Missions made impossible by one known change, and as many that can be done.

usage: python -m benchmarks.explained --count 10000 --seed 1 --state explained.json

Runs with even numbers are missions that the planner proves impossible after one change, and could do before it. Their explanation must
tell a cause that names what was changed, and offer what undoes it, or something cheaper; every repair must lead to a plan that the checker
finds sound, and where a number is said to be the smallest proven, the next smaller one, planned apart with the exhaustive allocator and the
constraint solver, must not do. Of every fifth of them changes that cost less than what is said to be the cheapest are planned apart, too.
Runs with odd numbers are missions that can be done, and must be told so.
"""

from __future__ import annotations

import time
from dataclasses import replace
from random import Random

from benchmarks.campaign import Campaign, Verdict, luck, run
from benchmarks.explained_breaks import BREAKS, Break, Mission
from benchmarks.explained_missions import drawn
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.checking import check
from missiontree.explaining.case import Case
from missiontree.explaining.changes.families import applied, candidates, in_words
from missiontree.explaining.explain import explained
from missiontree.explaining.grid import WHOLE, at_step, sized, step_of
from missiontree.mission.change import Change
from missiontree.mission.control import Control
from missiontree.mission.explanation import Explanation, Repair
from missiontree.mission.plan import Plan
from missiontree.planner import plan_authored

MOST_DRAWN = 400
MOST_OF_ONE_WAY = 10
MOST_REPAIRS = 40
NO_CAUSE, NO_REPAIR, UNSOUND, NOT_SMALLEST, CHEAPER, DENIED = (
    "cause not found", "known repair not offered", "repair without a sound plan", "smaller would do",
    "cheaper would do", "possible, called impossible",
)  # fmt: skip


def judge(seed: int, index: int) -> Verdict:
    """One mission, explained and held against what is known of it."""
    rng = luck(seed, index)
    return _possible(rng) if index % 2 else _broken(rng, BREAKS[index // 2 % len(BREAKS)], index)


def _possible(rng: Random) -> Verdict:
    request, plan = _can_be_done(rng)
    told = explained(plan, request, Control()).told
    denied = () if told.outcome == "delivered" and not told.causes else ((DENIED, str(told.causes)),)
    return Verdict("can be done", violations=denied)


def _broken(rng: Random, first: Break, index: int) -> Verdict:
    request, known, name, plan = cannot_be_done(rng, first)
    began = time.perf_counter()
    told = explained(plan, request, Control(), MOST_REPAIRS).told
    took = time.perf_counter() - began
    assert request.tree is not None, "every mission drawn here has a tree"
    case = Case(request.brief, request.tree)
    violations = [(NO_CAUSE, f"{name}: {known}")] if not cause_named(told, known) else []
    if not offered(told, known, request):
        violations.append((NO_REPAIR, f"{name}: {known}; {[repair.words for repair in told.repairs]}"))
    for repair in told.repairs:
        if repair.plan is None or repair.plan.outcome != "delivered" or check(repair.plan):
            violations.append((UNSOUND, repair.words))
    violations += [(NOT_SMALLEST, repair.words) for repair in told.repairs[:2] if smaller_does(case, request, repair)]
    if told.cheapest == "proven" and index % 10 == 0:
        violations += [(CHEAPER, words) for words in cheaper_ones(case, request, told.repairs[0])]
    cheapest = told.repairs[0].changes[0].kind if told.repairs else "none"
    counts = {
        "smallest proven": sum(repair.claim == "smallest_proven" for repair in told.repairs),
        "repairs": len(told.repairs),
        "cheapest proven": int(told.cheapest == "proven"),
        "undone as it was done": int(cheapest == known.kind),
        "within 0.5 s": int(took < 0.5),
    }
    return Verdict(f"cannot: {name}", counts, tuple(violations))


def _can_be_done(rng: Random) -> tuple[Request, Plan]:
    for _ in range(MOST_DRAWN):
        request = drawn(rng)
        plan = _plan(request)
        if plan.outcome == "delivered":
            return request, plan
    raise RuntimeError("no mission that can be done was drawn.")


def cannot_be_done(rng: Random, first: Break) -> tuple[Request, Change, str, Plan]:
    """A mission, proven impossible, with what undoes the one change that made it so: of the way asked for if that succeeds soon."""
    for tried in range(MOST_DRAWN):
        before, plan = _can_be_done(rng)
        assert before.tree is not None, "every mission drawn here has a tree"
        for way in (first,) if tried < MOST_OF_ONE_WAY else rng.sample(list(BREAKS), 6):
            made = way(rng, before.brief, before.tree, plan)
            if made is None:
                continue
            request = _with(before, made[0])
            broken = _plan(replace(request, scheduler="auto"))
            if broken.outcome == "cannot_be_done":
                return request, made[1], way.__name__, broken
    raise RuntimeError("no mission was made impossible.")


def _with(request: Request, mission: Mission) -> Request:
    return replace(request, brief=mission[0], tree=mission[1])


def _plan(request: Request) -> Plan:
    return plan_authored(request, Authored(status="complete", tree=request.tree, author="given"), Control())


def cause_named(told: Explanation, known: Change) -> bool:
    """Whether the causes name what was changed."""
    reasons = [reason for cause in told.causes for reason in cause.reasons]
    text = " ".join(
        [
            *(cause.words for cause in told.causes),
            *(f"{one.message} {one.found} {one.needed} {one.robot}" for one in reasons),
        ]
    )
    rules = {reason.rule for reason in reasons}
    match known.kind:
        case "add_capability":
            return any(one.robot == known.target and known.name in one.needed for one in reasons)
        case "raise_limit" | "raise_total" | "allow_zone":
            return known.name in text and known.target in text
        case "raise_stock":
            return known.name in text
        case "extend_deadline":
            return "must end by" in text or "deadline_missed" in rules
        case "extend_stay":
            return "robot_away" in rules
        case "lower_min_quality":
            return "quality_below_minimum" in rules
        case "allow_type":
            return "resource_excluded" in rules
        case "ignore_kinds":
            return "kind_refused" in rules
        case "drop_link":
            return "same robot" in text or "one robot" in text or "different robots" in text or "same_robot" in text
        case _:
            return known.target in text


def offered(told: Explanation, known: Change, request: Request) -> bool:
    """Whether the change is offered that undoes the known one, or one that is no dearer, with a proof that it is the cheapest."""
    for repair in told.repairs:
        change = repair.changes[0]
        same = len(repair.changes) == 1 and (change.kind, change.target) == (known.kind, known.target)
        if (
            same
            and (change.name == known.name or not known.name)
            and not (known.to and change.to and change.to > known.to)
        ):
            return True
    cheaper = told.repairs[0].cost <= request.costs.of(known) if told.repairs else False
    return cheaper and told.cheapest == "proven"


def smaller_does(case: Case, request: Request, repair: Repair) -> bool:
    """Whether a repair that is said to be the smallest works with a number that is one step smaller; planned apart."""
    if repair.claim != "smallest_proven" or len(repair.changes) > 1:
        return False
    change = repair.changes[0]
    if change.was is None or change.to is None or change.kind == "raise_quality":
        return False
    step = step_of(change, change.to) - 1
    if step < 1 and change.kind in WHOLE:
        return False
    less = applied(case, [at_step(change, max(0, step))])
    apart = replace(request, brief=less.brief, tree=less.tree, allocator="exhaustive", scheduler="cpsat", k=20)
    return _plan(apart).outcome == "delivered"


def cheaper_ones(case: Case, request: Request, first: Repair) -> list[str]:
    """Changes without a number that cost less than the repair said to be the cheapest, and work all the same; planned apart."""
    found = []
    for change in candidates(case):
        if sized(change) or change.kind in {"drop_part", "clear_cells"} or request.costs.of(change) >= first.cost:
            continue
        changed = applied(case, [change])
        apart = replace(
            request, brief=changed.brief, tree=changed.tree, allocator="exhaustive", scheduler="cpsat", k=20
        )
        if _plan(apart).outcome == "delivered":
            found.append(in_words(case, [change]))
    return found


CAMPAIGN = Campaign(
    "explained", __doc__ or "", 10_000, judge, (NO_CAUSE, NO_REPAIR, UNSOUND, NOT_SMALLEST, CHEAPER, DENIED), "missions"
)

if __name__ == "__main__":
    run(CAMPAIGN)
