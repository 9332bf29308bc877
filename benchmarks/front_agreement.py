"""
Are fronts and choices what trying everything finds? Random missions with a choice, each of whose alternatives is scheduled by an oracle.

::

    python -m benchmarks.front_agreement --count 2000 --seed 1 --state fronts.json

Missions are those of :mod:`choice_cases`, with every rule that schedules keep, chargers excepted. Wherever a front, an option of it or a
choice is called proven, it must be what the oracle finds; where a bound is told, the oracle must find nothing beyond it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from random import Random

from benchmarks.campaign import Campaign, Verdict, run
from benchmarks.choice_cases import ChoiceCase, Written, all_written, random_choice_case
from benchmarks.schedule_oracle import TooMuchError
from missiontree.choosing.choose import Choice, choose
from missiontree.mission.alternative import Ranking
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.front import Chosen, Front, Option
from missiontree.mission.objective import OBJECTIVES, Objective
from missiontree.scheduling import SCHEDULERS

MANY = 10_000_000
FALSE_FRONT, FALSE_OPTION = "a front called proven is not the front", "an option called proven is beaten"
FALSE_CHOICE, FALSE_BOUND = "a choice called proven is beaten", "something lies beyond a bound"
_NOTHING = Ranking(alternatives=(), status="unknown", certificate=Certificate(claim="unproven", method="lazy_k_best"))


def judge(seed: int, index: int) -> Verdict:
    """One mission: its front, and what each objective chooses."""
    try:
        case = random_choice_case(Random(seed * MANY + index))  # noqa: S311 - variation, not secrecy
        truth = tuple(all_written(case))
    except (TooMuchError, ValueError):
        return Verdict("too much to try", {}, ())
    front = _asked(case, "utility", front=True).front
    counts = {"unbeaten plans": len(unbeaten(truth)), "fronts proven": int(_proven(front))}
    violations = list(_of_front(front, truth)) if front is not None else []
    for objective in OBJECTIVES[1:]:
        chosen = _asked(case, objective).chosen
        if chosen is not None and truth:
            counts[f"{objective} proven"] = int(chosen.option.certificate.claim == "proven")
            violations += _of_choice(case, objective, chosen, truth)
    return Verdict("missions", counts, tuple((what, f"mission {index}") for what in violations))


def unbeaten(truth: tuple[Written, ...]) -> set[tuple[int, int]]:
    """Utility in millionths and makespan in ticks of every plan of the front."""
    found: list[tuple[int, int]] = []
    for one in sorted(truth, key=lambda one: (-one.utility, one.makespan)):
        if not found or one.makespan < found[-1][1]:
            found.append((one.utility, one.makespan))
    return set(found)


def _asked(case: ChoiceCase, objective: Objective, front: bool = False) -> Choice:
    brief = replace(case.brief, objective=objective)
    return choose(case.tree, brief, brief.world, SCHEDULERS["auto"], Control(), _NOTHING, (), front)


def _proven(front: Front | None) -> bool:
    return front is not None and front.certificate.claim == "proven"


def _told(option: Option) -> tuple[int, int]:
    return round(option.alternative.utility * 1e6), round(option.schedule.makespan_s * 1000)


def _of_front(front: Front, truth: tuple[Written, ...]) -> Iterator[str]:
    needed = unbeaten(truth)
    if _proven(front) and (front.found != len(needed) or not {_told(one) for one in front.options} <= needed):
        yield FALSE_FRONT
    if not {_told(one) for one in front.options if one.certificate.claim == "proven"} <= needed:
        yield FALSE_OPTION


def _of_choice(case: ChoiceCase, objective: Objective, chosen: Chosen, truth: tuple[Written, ...]) -> Iterator[str]:
    """By robot time the oracle knows no worth, since it makes schedules short and not spare: only bounds of the others are told."""
    certificate, (utility, makespan) = chosen.option.certificate, _told(chosen.option)
    if objective == "makespan":
        best = min((one.makespan, -one.utility) for one in truth)
        wrong, beyond = best != (makespan, -utility), best[0] / 1000 < (certificate.bound or 0) - 1e-6
    elif objective == "utility-makespan":
        best = min((-one.utility, one.makespan) for one in truth)
        wrong, beyond = best != (-utility, makespan), False
    elif objective == "weighted-team":
        most = max(one.timeless - case.brief.weights.beta * 1000 * one.makespan for one in truth) / 1e6
        wrong = abs(most - chosen.worth) > 1e-5
        beyond = certificate.bound is not None and most > certificate.bound + 1e-5
    else:
        return
    if certificate.claim == "proven" and wrong:
        yield FALSE_CHOICE
    if beyond:
        yield FALSE_BOUND


CAMPAIGN = Campaign(
    name="fronts and choices",
    about=__doc__,
    count=2000,
    judge=judge,
    never=(FALSE_FRONT, FALSE_OPTION, FALSE_CHOICE, FALSE_BOUND),
    unit="missions",
)


if __name__ == "__main__":
    run(CAMPAIGN)
