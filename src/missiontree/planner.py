"""
The whole road on one page: words and files → mission tree → grounded tree → alternatives → schedules → check → plan.

Each step is a function from frozen value to frozen value; what takes long is given a :class:`Control`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from missiontree import __version__
from missiontree.allocation.aimed import allocator_for
from missiontree.allocation.flat import flatten
from missiontree.authoring.author import author_tree, authored_from_tree
from missiontree.authoring.budgets import Budgets
from missiontree.authoring.dialogue import Company
from missiontree.authoring.formal import author_formal
from missiontree.authoring.methods.method import load_methods
from missiontree.authoring.offline import author_offline
from missiontree.authoring.outcome import Authored
from missiontree.authoring.transcript import Origin, replay
from missiontree.briefing import Request, request_from
from missiontree.checking import check
from missiontree.checking.regrounding import regrounding
from missiontree.choosing.choose import NOTHING, Choice, choose
from missiontree.errors import InputError, InternalError
from missiontree.estimation.estimator import Estimator
from missiontree.formats.inputs import input_digests
from missiontree.formats.source import load_text
from missiontree.llm.chat import ChatModel, Listener, deaf
from missiontree.llm.feature_memory import usual_path
from missiontree.llm.opening import Settings, open_model
from missiontree.mission.aim import Accumulate
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import Grounding
from missiontree.mission.objective import Objective
from missiontree.mission.plan import Outcome, Plan, Provenance
from missiontree.mission.reason import Reason
from missiontree.mission.routine import Routine
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import MinQuality
from missiontree.mission.tree import MissionTree
from missiontree.reporting.tree.view import tree_svg
from missiontree.routines.ground import ground
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.serial import few_leaves
from missiontree.scheduling.writing import untried_schedule

MAX_DRAWN = 200
PLAIN_SCHEDULER = "greedy"
ALLOCATION_SHARE = 0.6
CHECKING, CHECKING_EACH = 1.0, 1.0
"""What checking takes, as a whole and for each alternative, in units of what grounding took: so much of a time limit is kept for it."""
MOST_FOR_CHECKING = 0.5
RANKING_SHARE = 0.5  # of the time, where alternatives and schedules are weighed against each other afterwards
RECORDED = "recorded:"
CALLED = re.compile(r" \([a-z]+[A-Z]\w*\)")  # names of functions, in hints that are worded for a model


def plan(
    mission: str | Path,
    *,
    fleet: Fleet | Path | str | None = None,
    scene: Scene | Path | str | None = None,
    routines: Sequence[Routine | Path | str] = (),
    methods: Sequence[Path | str] = (),
    weights: Weights | Sequence[float] | None = None,
    check_kinds: bool | None = None,
    without: Sequence[str] = (),
    require: Sequence[str] = (),
    min_quality: MinQuality | None = None,
    estimator: Estimator | Callable[..., Estimate] | Path | str | None = None,
    accumulate: Accumulate | None = None,
    diverse: bool | None = None,
    return_home: bool | None = None,
    objective: Objective | None = None,
    k: int | None = None,
    allocator: str | None = None,
    scheduler: str | None = None,
    front: bool = False,
    model: str | ChatModel | None = None,
    base_url: str | None = None,
    budgets: Budgets | None = None,
    seed: int | None = None,
    control: Control | None = None,
) -> Plan:
    """
    Plan a mission: author its tree, rank the ways to staff it, schedule them, and check all of it.

    Parameters
    ----------
    mission
        The mission in words, or the path of a mission file; text that ends in ``.yaml``, ``.yml`` or ``.json`` is such a path.
    fleet
        The team: a value or a file. Default: the mission file's, else the paper's sample fleet.
    scene
        The world: a value or a file. Default: the mission file's, else none.
    routines
        Further routines, or files of them (YAML, or Python files, which are run).
    methods
        Files of further mission methods for the offline author.
    weights
        What makes utility. Default: quality alone.
    check_kinds
        Whether kinds of arguments are enforced. Default true.
    without
        Robot types and robots that take no part, beside those that the mission file leaves out.
    require
        Robot types and robots that must take part in every alternative, beside those that the mission file requires.
    min_quality
        Quality that every action must have at least: a number for all, or numbers by routine or capability. It takes the place of
        all that the mission file says of it. Default: the mission file's, else 0.
    estimator
        What says how well, how long and how dear every action is: anything that fits
        :class:`missiontree.estimation.estimator.Estimator`, a function of the same arguments, or the path of a Python file that
        names one, which is run. Default: the mission file's, else the fleet's table.
    accumulate
        How the utilities of actions make that of an alternative: ``sum`` (default), ``mean`` or ``min``.
    diverse
        Whether alternatives are to differ in team, the set of robot types that take part. Default false.
    return_home
        Whether each robot that takes part goes back to where it started, after its last action. Default: as the mission file says,
        else false.
    objective
        What decides which alternative is chosen, schedules included: ``utility`` (default), ``makespan``, ``utility-makespan``,
        ``weighted-team`` or ``weighted-sum``; see :data:`missiontree.mission.objective.Objective`. ``Plan.chosen`` holds it. Ranks go
        by utility alone.
    k
        How many alternatives are asked for, at least 1. Default 4.
    allocator
        ``exact`` (default), ``pruned``, ``pruned_as_printed`` or ``exhaustive``. Those that prune rank by sums alone.
    scheduler
        ``greedy``, ``cpsat``, or ``auto``: greedy, then constraint programming where that is quick. Default: ``greedy``; ``auto`` if the
        objective looks at schedules, or a front is asked for.
    front
        Whether the utility-makespan front is sought, beside the alternatives: plans from the best staffed to the fastest, in
        ``Plan.front``. Default false.
    model
        ``offline`` (default), ``recorded:<file>`` to replay a transcript, a language model such as ``openai:NAME`` (see
        :mod:`missiontree.llm.opening`), or a chat model of your own: anything that fits :class:`missiontree.llm.chat.ChatModel`.
    base_url
        Address of an OpenAI-compatible endpoint, for ``openai:NAME`` and ``ollama:NAME``.
    budgets
        How long a dialogue with a language model may go on.
    seed
        Seed of everything random. Default 0.
    control
        Time limit, stop token, progress callback. Default: no limit.

    Returns
    -------
    Plan
        Also when the mission cannot be done or was not understood: ``outcome`` and ``reasons`` say so.

    Raises
    ------
    InputError
        If something handed in is not what it should be.
    """
    request = request_from(
        mission,
        fleet=fleet,
        scene=scene,
        routines=routines,
        methods=methods,
        weights=weights,
        check_kinds=check_kinds,
        without=without,
        require=require,
        min_quality=min_quality,
        estimator=estimator,
        accumulate=accumulate,
        diverse=diverse,
        return_home=return_home,
        objective=objective,
        k=k,
        allocator=allocator,
        scheduler=scheduler,
        front=front,
        model=model,
        base_url=base_url,
        budgets=budgets,
        seed=seed,
    )
    return plan_request(request, control or Control(seed=request.seed))


def plan_request(request: Request, control: Control) -> Plan:
    """Plan a request that is already gathered; see :func:`plan`."""
    check_methods(request)
    return plan_authored(request, author(request, control), control)


def check_methods(request: Request) -> None:
    """
    Refuse, before anybody is asked anything, an allocator or a scheduler that there is not, or an allocator that cannot reach the aim.

    Raises
    ------
    InputError
        With those that can be taken.
    """
    allocator_for(request.allocator, request.brief.aim)
    if request.scheduler not in SCHEDULERS:
        hint = "It is named by --scheduler, by scheduler: of the mission file, or by plan(scheduler=…)."
        raise InputError(f"there is no scheduler {request.scheduler!r}", accepted=", ".join(SCHEDULERS), hint=hint)


def plan_authored(request: Request, authored: Authored, control: Control) -> Plan:
    """The rest of the road, for a mission whose tree is built (:func:`author`)."""
    if authored.status != "complete" or authored.tree is None:
        return _told(request, authored, input_digests(request.brief, authored.tree))
    begun = control.clock()
    grounding = ground(authored.tree, request.brief, request.estimator)
    scene = request.brief.world.extended(authored.tree.entities)
    checking_s = (control.clock() - begun) * (CHECKING + CHECKING_EACH * request.k)
    # What the inputs alone tell, for the checker and for the plan, while there is time.
    known = regrounding(authored.tree, request.brief, grounding.estimates)
    digests = input_digests(request.brief, authored.tree)
    work = control.without(checking_s, MOST_FOR_CHECKING)
    choosing = request.front or request.brief.objective != "utility"
    ranking, schedules = staff_and_schedule(grounding, request, scene, work.part(RANKING_SHARE) if choosing else work)
    choice = NOTHING
    if choosing and _any_works(schedules):
        with_ = SCHEDULERS[request.scheduler]
        choice = choose(grounding.tree, request.brief, scene, with_, work, ranking, schedules, request.front)
    made = _told(request, authored, digests, grounding, ranking, schedules, choice)
    faults = check(made, known)
    if faults and request.scheduler != PLAIN_SCHEDULER:
        plain = plan_authored(replace(request, scheduler=PLAIN_SCHEDULER), authored, control)
        return replace(plain, notices=(*plain.notices, _distrusted(request.scheduler, faults[0])))
    if faults:
        raise InternalError(f"the checker refuses a plan of our own making: {faults[0].rule}: {faults[0].message}")
    return made


def _distrusted(scheduler: str, fault: Reason) -> Reason:
    return Reason(
        rule="scheduler_distrusted",
        message=f"The checker refuses what the scheduler {scheduler} made ({fault.rule}: {fault.message}); greedy schedules stand instead.",
        severity="notice",
        found=fault.rule,
        hint="Please report it; a smaller mission that shows the same would help.",
    )


def author(request: Request, control: Control | None = None, listen: Listener = deaf) -> Authored:
    """
    Have the mission tree built, or take the one that was handed in.

    Parameters
    ----------
    request
        The mission, and who is to author it.
    control
        Stop token, listener and clock, for a dialogue with a language model. Default: nobody stops it.
    listen
        Told a language model's words as they come in.

    Raises
    ------
    InputError
        If there is no such model, or a transcript or a tree that was handed in is damaged.
    """
    if request.tree is not None:
        return _handed_in(request.tree, request)
    if request.brief.goals:  # nothing is left to be read, whoever the model is
        return author_formal(request.brief, load_methods(request.methods))
    if request.model == "offline":
        return author_offline(request.brief, load_methods(request.methods))
    if isinstance(request.model, str) and request.model.startswith(RECORDED):
        return _replayed(Path(request.model.removeprefix(RECORDED)), request)
    methods = load_methods(request.methods)
    company = Company(lambda: author_offline(request.brief, methods), tree_svg, control or Control())
    if not isinstance(request.model, str):
        return author_tree(request.brief, request.model, request.budgets, company=company)
    opened = open_model(request.model, Settings(base_url=request.base_url, listen=listen, memory=usual_path()))
    origin = Origin(opened.source, opened.name, opened.endpoint)
    return author_tree(request.brief, opened.model, request.budgets, origin, company)


def _replayed(file: Path, request: Request) -> Authored:
    try:
        return replay(load_text(file).splitlines(), request.brief)
    except InputError as error:
        raise replace(error, file=str(file)) from error


def _handed_in(tree: MissionTree, request: Request) -> Authored:
    """A tree from a file: unfinished is an outcome, contradictory is bad input."""
    authored = authored_from_tree(tree, request.brief)
    if faults := [reason for reason in authored.reasons if reason.rule != "open_leaf"]:
        more = f" ({len(faults) - 1} more in the tree)" if len(faults) > 1 else ""
        hint = CALLED.sub("", faults[0].hint)
        raise InputError(faults[0].message + more, file=request.tree_file, accepted=faults[0].needed, hint=hint)
    return authored


def staff_and_schedule(
    grounding: Grounding, request: Request, scene: Scene, control: Control
) -> tuple[Ranking, tuple[Schedule, ...]]:
    """
    Rank k alternatives that can be scheduled, and schedule them.

    An alternative that is proven unschedulable stays in the list, with the reason in its schedule, and one more is drawn (one of
    another team, where teams are to differ); so ranks never depend on schedules. One that is not proven either way counts among the
    k, but drawing goes on until some alternative has a schedule. Once one was tried and time is up, no other is begun, unless that is
    a matter of a few actions.
    """
    brief, tree, wanted = request.brief, grounding.tree, request.k
    schedule_with, allocate = SCHEDULERS[request.scheduler], allocator_for(request.allocator, brief.aim)
    flat = flatten(tree, brief.fleet, brief.weights, brief.terms)
    done: dict[object, Schedule] = {}
    while True:
        ranking = allocate(flat, brief.fleet, brief.weights, wanted, control.part(ALLOCATION_SHARE))
        for position, alternative in enumerate(ranking.alternatives):
            if alternative.choices not in done or done[alternative.choices].rank != alternative.rank:
                if control.ended() and done and not few_leaves(tree, alternative):
                    done[alternative.choices] = untried_schedule(alternative)
                    continue
                left = len(ranking.alternatives) - position
                done[alternative.choices] = schedule_with(
                    tree, alternative, brief.fleet, scene, control.part(1 / left), brief.terms
                )
        schedules = tuple(done[alternative.choices] for alternative in ranking.alternatives)
        impossible = sum(schedule.status == "infeasible" for schedule in schedules)
        scheduled = _any_works(schedules)
        enough = (scheduled and len(schedules) - impossible >= request.k) or len(schedules) < wanted
        if enough or control.ended() or wanted >= max(MAX_DRAWN, request.k):
            return ranking, schedules
        wanted = request.k + impossible if scheduled else wanted * 2


def _any_works(schedules: Iterable[Schedule]) -> bool:
    return any(schedule.status in {"optimal", "feasible"} for schedule in schedules)


def _told(
    request: Request,
    authored: Authored,
    digests: Mapping[str, str],
    grounding: Grounding | None = None,
    ranking: Ranking | None = None,
    schedules: tuple[Schedule, ...] = (),
    choice: Choice = NOTHING,
) -> Plan:
    """Put everything known into one value."""
    outcome, reasons = _outcome(authored, grounding, ranking, schedules, request.brief.diverse)
    options = [*(choice.front.options if choice.front else ()), *([choice.chosen.option] if choice.chosen else ())]
    all_schedules = [*schedules, *(option.schedule for option in options)]
    scheduled = [reason for schedule in all_schedules for reason in schedule.assumptions]
    warnings = [notice for notice in authored.notices if notice.severity == "warning"]
    notices = [notice for notice in authored.notices if notice.severity != "warning"]
    found = grounding.findings if grounding else ()
    seen = {finding.rule for finding in found}  # the author's gate may have seen the same before grounding did
    return Plan(
        outcome=outcome,
        brief=request.brief,
        tree=authored.tree,
        grounding=grounding,
        ranking=ranking,
        schedules=schedules,
        chosen=choice.chosen,
        front=choice.front,
        reasons=reasons,
        notices=_distinct([*notices, *(grounding.notices if grounding else ())]),
        assumptions=_distinct([*authored.assumptions, *(grounding.assumptions if grounding else ()), *scheduled]),
        findings=_distinct([*found, *(warning for warning in warnings if warning.rule not in seen)]),
        digests=digests,
        provenance=Provenance(
            author=authored.author,
            model=authored.model,
            transcript=authored.transcript,
            reading=authored.reading,
            allocator=request.allocator if ranking else "",
            scheduler=request.scheduler if schedules else "",
            seed=request.seed,
            versions={"missiontree": __version__},
            spent=authored.spent,
        ),
    )


def _outcome(
    authored: Authored,
    grounding: Grounding | None,
    ranking: Ranking | None,
    schedules: tuple[Schedule, ...],
    diverse: bool = False,
) -> tuple[Outcome, tuple[Reason, ...]]:
    if authored.status != "complete":
        return authored.status, authored.reasons
    assert ranking is not None
    assert grounding is not None
    if ranking.status == "infeasible":
        return "cannot_be_done", _distinct([*ranking.reasons, *grounding.not_offered])
    if _any_works(schedules):
        return "delivered", ()
    unscheduled = [reason for schedule in schedules for reason in schedule.reasons]
    no_more = ranking.status == "exact" and ranking.certificate.bound is None
    proven = no_more and all(schedule.status == "infeasible" for schedule in schedules)
    if proven and diverse:  # another alternative of the same teams may have a schedule
        return "exhausted", _distinct([*ranking.reasons, *unscheduled, ONE_PER_TEAM])
    return ("cannot_be_done" if proven else "exhausted"), _distinct([*ranking.reasons, *unscheduled]) or (
        NOTHING_FOUND,
    )


NOTHING_FOUND = Reason(
    rule="nothing_found",
    message="No alternative with a schedule was found in the time given; none is excluded either.",
    hint="Give more time (--time-limit) or another allocator (--allocator exact).",
)


ONE_PER_TEAM = Reason(
    rule="one_per_team",
    message="The best alternative of every team was scheduled, and none of these can be; others of the same teams were not tried.",
    hint="Plan without --diverse.",
)


def _distinct(reasons: Sequence[Reason]) -> tuple[Reason, ...]:
    return tuple(dict.fromkeys(reasons))
