"""Are the estimates of a user's own estimator those that the plan says it gave? It itself is not asked: it may be gone."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault, named
from missiontree.mission.estimator_source import Estimated
from missiontree.mission.grounded import Action, Grounding
from missiontree.mission.routine import ActionStep


def estimates_differ(case: Case) -> Iterator[Fault]:
    """The plan holds other answers of the user's own estimator than grounding asks for; or some, and names no such estimator."""
    given, made = case.plan.grounding, case.regrounded
    if given is not None and isinstance(made, Grounding) and given.estimates != made.estimates:
        yield Fault(
            "the estimates that the plan holds are not those that grounding asks for.",
            found=f"{len(given.estimates)} answers",
            needed=f"{len(made.estimates)}",
        )


def estimate_unsaid(case: Case) -> Iterator[Fault]:
    """An action has an estimate that the user's own estimator did not give for such an action of the type."""
    if case.plan.brief.estimator is None or case.tree is None:
        return
    for leaf, node in enumerate(case.tree.nodes):
        if node.action is None:
            continue
        said = [one.estimate for one in _answers(case, node.action)]
        if node.action.estimate not in said:
            yield Fault(
                f"{named(case.tree, leaf)} has an estimate that {case.plan.brief.estimator.name} did not give.",
                node=named(case.tree, leaf),
                robot=node.action.robot_type,
                found=str(node.action.estimate),
                needed=f"{' or '.join(map(str, said)) or 'an answer':.200}",
            )


def alone_s(case: Case, action: Action, step: ActionStep) -> object:
    """Duration without travel by the word of the user's own estimator; if there is none, words for what is missing."""
    for said in _answers(case, action):
        asked_alone = not said.travel_m and not said.travel_s and said.nominal_s == step.duration_s
        if asked_alone and said.nominal_cost == step.cost:
            return said.estimate.duration_s
    return "what its estimator says"


def _answers(case: Case, action: Action) -> tuple[Estimated, ...]:
    """What was said of such an action of the type, with whatever travel."""
    return case.answers.get((action.robot_type, action.name, action.capability, action.at), ())
