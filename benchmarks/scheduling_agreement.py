"""
Do the schedulers agree with the truth? Random missions of up to five roles with every rule, each against an oracle that tries everything
which is over as soon as what was found, and so tells whether that can be done and whether anything is shorter.

::

    python -m benchmarks.scheduling_agreement --count 500000 --seed 1 --state scheduling.json

The state file keeps what was done, so an interrupted run goes on where it was. What must never be: a schedule that the checker refuses, a
makespan below the least, a bound above it, "optimal" or "infeasible" where it is not so, or a gap that is left. Besides the scheduler as
it is used, its parts are put to the test one by one with every third mission: the model alone, the second formulation, and trying
everything out.
"""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.campaign import Campaign, Verdict, luck, run
from benchmarks.schedule_cases import THINGS, ScheduleCase, random_schedule_case
from benchmarks.schedule_oracle import TooMuchError, least_makespan
from missiontree.checking import check
from missiontree.mission.alternative import Ranking
from missiontree.mission.brief import MissionBrief
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.grounded import Action, Grounding
from missiontree.mission.plan import Plan, Provenance
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.schedule import Schedule
from missiontree.rechecking import recheck
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.cpsat.formulation import Formulation
from missiontree.scheduling.cpsat.search import Effort, search
from missiontree.scheduling.cpsat.second import SecondForm
from missiontree.scheduling.cpsat.unsupported import UnsupportedError
from missiontree.scheduling.cpsat.verify import broken
from missiontree.scheduling.enumeration.trying import Trying
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.horizon import horizon_of
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.replay import replay

NEVER = ("refused schedules", "false makespans", "false bounds", "false proofs", "gaps", "disagreements of parts")
INPUTS = {
    "digest_mismatch",
    "note_dropped",
    "assumption_missing",
    "limit_use_missing",
}  # of a plan made for the checker alone, without a road to it
FOUND = {"optimal", "feasible"}
LONG_S = 60.0
REFILLING_S = 1.0
"""For missions with chargers, whose gaps seldom close: no gap of theirs counts, and the rest of half a minute would show little."""
REFILLED = {"budget_bound", "deadline_bound"}
"""Proofs that may rest on what must be refilled, of which the oracle knows nothing."""
MOST_STEPS = 200_000
PARTS_EVERY = 3
"""Every third mission is put to the parts as well, which takes twice as long as the scheduler that is made of them."""


def judge(seed: int, index: int) -> Verdict:
    """One random mission."""
    case = random_schedule_case(luck(seed, index))
    limits = Control(seed=seed, time_limit_s=REFILLING_S if "chargers" in case.features else None)
    result = SCHEDULERS["cpsat"](case.tree, case.alternative, case.fleet, case.scene, limits, case.terms)
    try:
        truth = least_makespan(case, _ticks(result) + 1 if result.status in FOUND else None)
    except TooMuchError:
        return Verdict("too much to try", violations=tuple(_refused(case, result)))
    violations = list(_claims(case, result, truth))
    if index % PARTS_EVERY == 0:
        violations += _parts(case, truth)
    if "chargers" in case.features and _may_wait(
        case
    ):  # the oracle's world without chargers is not the looser one then
        violations = [one for one in violations if one[0] == "refused schedules"]
    counts = {f"{result.status}, {result.certificate.method}": 1}
    counts |= dict.fromkeys(case.features, 1)
    return Verdict("possible" if truth is not None else "impossible", counts, tuple(violations))


def _claims(case: ScheduleCase, result: Schedule, truth: int | None) -> Iterator[tuple[str, str]]:
    """What the scheduler says against what is."""
    makespan, bound = _ticks(result), result.certificate.bound
    if result.status in FOUND:
        yield from _refused(case, result)
        if truth is None:
            yield "false makespans", f"{makespan}, where nothing is over as soon"
        if bound is not None and round(bound * 1000) > makespan:
            yield "false bounds", f"{bound} by {result.certificate.method}, where {makespan} was found"
        if result.certificate.method == "refill_load":
            return  # the least that is known here has levels that last for ever
        if bound is not None and truth is not None and round(bound * 1000) > truth:
            yield "false bounds", f"{bound} by {result.certificate.method}, where the least is {truth}"
        if result.status == "optimal" and makespan != truth:
            yield "false proofs", f"{makespan} by {result.certificate.method}, where the least is {truth}"
        if truth is not None and makespan > truth and "chargers" not in case.features:
            yield "gaps", f"{makespan}, where the least is {truth}"
    elif truth is not None and not _may_be_without(case, result):
        yield (
            ("false proofs" if result.status == "infeasible" else "gaps"),
            f"{result.status}, and the least is {truth}",
        )


def _refused(case: ScheduleCase, result: Schedule) -> Iterator[tuple[str, str]]:
    """What the checkers say of what was found; the second is asked whatever the first says of the inputs."""
    if result.status in FOUND and _tells_order(case, result):
        plan = _plan(case, result)
        for fault in (*check(plan), *recheck(plan)):
            if fault.rule not in INPUTS:
                yield "refused schedules", f"{fault.rule}: {fault.message}"


def _ticks(result: Schedule) -> int:
    return round(result.makespan_s * 1000)


def _may_wait(case: ScheduleCase) -> bool:
    """Whether some role begins with a move or may begin anywhere, so that its robot may as well wait at a charger."""
    firsts: dict[int, Action] = {}
    for node in case.tree.nodes:
        if node.action is not None:
            firsts.setdefault(node.action.role, node.action)
    return any(action.moves or action.at is None for action in firsts.values())


def _may_be_without(case: ScheduleCase, result: Schedule) -> bool:
    """Whether a schedule may be missed, or levels, which the oracle takes to last for ever, may keep a mission from having one."""
    if "chargers" in case.features and result.certificate.method in REFILLED:
        return True
    return result.status == "unknown" and "chargers" in case.features


def _tells_order(case: ScheduleCase, result: Schedule) -> bool:
    """Whether times alone tell what comes first where that matters; the checker knows no more than a schedule says."""
    seen: set[tuple[str, float]] = set()
    held: dict[int, tuple[str, float, float]] = {}  # by role
    for done in result.actions:
        role = case.tree.action(done.leaf).role
        held[role] = done.robot, held.get(role, ("", done.start_s))[1], done.end_s
    instants = [(robot, start) for robot, start, end in held.values() if start == end]
    if len(set(instants)) < len(instants):
        return False  # one robot in two roles that take no time, at once: which comes first is not told
    for done in result.actions:
        action = case.tree.action(done.leaf)
        for name in {*action.brings, action.at} & {*THINGS}:
            assert name is not None
            if (name, done.start_s) in seen and action.sync is None:
                return False
            seen.add((name, done.start_s))
    return True


def _parts(case: ScheduleCase, truth: int | None) -> Iterator[tuple[str, str]]:
    """Each part alone."""
    problem = read_problem(case.tree, case.alternative, case.fleet, case.scene, case.terms)
    if not isinstance(problem, Problem):
        if truth is not None and not ("chargers" in case.features and problem[0] in REFILLED):
            yield "false proofs", f"{problem[0]}, and the least is {truth}"
        return
    horizon = horizon_of(problem)
    if truth is not None and horizon < truth:
        yield "disagreements of parts", f"the horizon is {horizon}, the least {truth}"
    tried = Trying(problem, horizon, MOST_STEPS, lambda: False)()
    draft = replay(problem, tried.course) if tried.course is not None else None
    if problem.bounds.method == "refill_load":
        return  # with levels that last for ever, as the oracle has them, less may do than the bound
    if "chargers" in case.features:
        if tried.complete and ((tried.course is None and truth is not None) or (draft is not None and truth is None)):
            yield "disagreements of parts", f"trying finds {tried.course}, the least is {truth}"
    elif tried.complete and (None if draft is None else draft.makespan) != truth:
        yield "disagreements of parts", f"trying comes to {draft and draft.makespan}, the least is {truth}"
    if (
        truth is not None
        and search(SecondForm(problem, truth).model, LONG_S, lambda: False, Effort(plain=True)).verdict == "infeasible"
    ):
        yield "disagreements of parts", f"the second formulation denies {truth}"
    yield from _model(problem, horizon, truth)


def _model(problem: Problem, horizon: int, truth: int | None) -> Iterator[tuple[str, str]]:
    try:
        formulation = Formulation(problem, horizon)
    except UnsupportedError:
        return
    found = search(formulation.model, LONG_S, lambda: False)
    if truth is not None and (found.verdict == "infeasible" or (found.bound or 0) > truth):
        yield "disagreements of parts", f"the model is {found.verdict} with bound {found.bound}, the least is {truth}"
    if found.values and any(broken(formulation.model, found.values)):
        yield "disagreements of parts", "the solver's answer does not keep the model"
    draft = replay(problem, formulation.course(found.values)) if found.values and not problem.chargers else None
    if draft is not None and found.objective is not None and draft.makespan > found.objective:
        yield "disagreements of parts", f"the model says {found.objective}, replayed it is {draft.makespan}"


def _plan(case: ScheduleCase, result: Schedule) -> Plan:
    """A plan for the checker, its inputs stated anew."""
    certificate = Certificate(claim="unproven", method="enumeration")
    brief = MissionBrief(
        text="A mission by chance.",
        fleet=case.fleet,
        scene=case.scene,
        routines=RoutineLibrary(routines=()),
        require=case.terms.require,
        return_home=case.terms.return_home,
        deadline_s=case.terms.home_by_s,
    )
    return Plan(
        outcome="delivered",
        brief=brief,
        grounding=Grounding(tree=case.tree),
        ranking=Ranking(status="partial", certificate=certificate, alternatives=(case.alternative,)),
        schedules=(result,),
        provenance=Provenance(author="given"),
    )


CAMPAIGN = Campaign(
    name="scheduling_agreement", about=__doc__ or "", count=500_000, judge=judge, never=NEVER, unit="missions"
)

if __name__ == "__main__":
    run(CAMPAIGN)
