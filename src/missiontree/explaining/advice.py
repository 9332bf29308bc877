"""
What is evident before a language model is asked, and paid: needs of the mission that this team does not meet.

It is advice and no verdict: the author without a model reads words only, and a model may understand them otherwise.
"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.authoring.formal import author_formal
from missiontree.authoring.methods.method import load_methods
from missiontree.authoring.nearly_able import nearly_able
from missiontree.authoring.offline import author_offline
from missiontree.authoring.routine_calls import able_types
from missiontree.briefing import Request
from missiontree.errors import InputError
from missiontree.explaining.causes.routines import routine_causes
from missiontree.explaining.understood import understood
from missiontree.mission.reason import Reason
from missiontree.routines.ground import ground

MOST_ADVICE = 8
ADVICE = "advice"


def asks_a_model(request: Request) -> bool:
    """Whether somebody will be asked who may cost money."""
    if request.tree is not None or request.brief.goals or request.model == "offline":
        return False
    return not (isinstance(request.model, str) and request.model.startswith("recorded:"))


def advice_on(request: Request) -> tuple[Reason, ...]:
    """
    Needs of a mission that its team evidently does not meet, as notices; empty if there are none.

    Parameters
    ----------
    request
        The mission, before it is authored. Nobody is asked for it, and nothing is spent.
    """
    return tuple(dict.fromkeys(_advice(request)))[:MOST_ADVICE]


def _advice(request: Request) -> Iterator[Reason]:
    made = understood(request)
    if made is not None and made.tree is not None:
        try:
            causes = routine_causes(made.tree, ground(made.tree, request.brief, request.estimator))
        except InputError:
            causes = ()
        for cause in causes:
            yield _said(" ".join(filter(None, (cause.words, nearly_able(cause.reasons)))), cause.node)
        return
    methods = load_methods(request.methods)
    author = author_formal if request.brief.goals else author_offline
    opinion = author(request.brief, methods)
    if opinion.status == "cannot_be_done":
        for reason in opinion.reasons:
            yield _said(reason.message, reason.node)
    for name, offers in able_types(request.brief).items():
        if not offers.able:
            yield _said(
                f"No robot of this fleet can do {name}, whoever it is about. {nearly_able(offers.refused)}".strip(),
                name,
            )


def _said(message: str, node: str) -> Reason:
    return Reason(
        rule=ADVICE,
        severity="notice",
        message=message,
        node=node,
        hint="This was read without a model, which may understand the mission otherwise; it is asked all the same.",
    )
