"""Goals that wait for an option of a choice: what the order comes to if another option is taken."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from missiontree.mission.goal import Bond, Goal
from missiontree.mission.reason import Reason

BINDS: Mapping[Bond, str] = {
    "after": "starts after",
    "until": "lasts until",
    "same_robot": "has the robot of",
    "different_robot": "has another robot than",
    "takes_over_from": "takes over from",
}
"""How what a goal says of another reads."""
ELSE: Mapping[Bond, str] = {
    "after": "waits for nothing there",
    "until": "ends by itself",
    "same_robot": "may have any robot",
    "different_robot": "may have any robot",
    "takes_over_from": "takes over from nobody",
}
"""And what it comes to where the other is not done."""
Options = Mapping[int, tuple[Goal, int]]
"""The choices above a goal, outermost first, by the identity of their tasks: goals may look alike. Each with the option that holds it."""


def conditional_links(goals: Sequence[Goal]) -> Iterator[Reason]:
    """
    What to know of each field of a goal that names an option of a choice as another goal.

    Of a choice one option is done, so a link between two options never binds, and one that names an option from outside binds only if
    that option is taken.
    """
    every = [found for goal in goals for found in _within(goal, {})]
    named = {goal.name: (goal, options) for goal, options in every if goal.name}
    for goal, options in every:
        for bond, name in goal.bonds:
            other, others = named[name]
            if any(others[choice][1] != options[choice][1] for choice in options if choice in others):
                yield _never(goal, bond, other)
            elif outside := [choice for choice in others if choice not in options]:
                yield _maybe(goal, bond, other, others[outside[0]][0])


def _within(goal: Goal, options: Options) -> Iterator[tuple[Goal, Options]]:
    """A goal and all below it, each with the choices above it."""
    waiting = [(goal, options)]
    while waiting:
        here, above = waiting.pop()
        yield here, above
        choice = here.gate == "xor" and len(here.goals) > 1
        below = [
            (inner, {**above, id(here): (here, number)} if choice else above) for number, inner in enumerate(here.goals)
        ]
        waiting += reversed(below)


def _never(goal: Goal, bond: Bond, other: Goal) -> Reason:
    message = (
        f"Goal {goal.shown[:200]!r} {BINDS[bond]} {other.shown[:200]!r}, and they are options of one choice, of which only one is done: "
        "the link never binds."
    )
    return Reason(
        rule="link_never_binds", message=message, severity="warning", node=goal.shown[:200], hint="Leave it out."
    )


def _maybe(goal: Goal, bond: Bond, other: Goal, choice: Goal) -> Reason:
    message = (
        f"Goal {goal.shown[:200]!r} {BINDS[bond]} {other.shown[:200]!r} only if that option of "
        f"{choice.task!r} is taken; if another is, it {ELSE[bond]}."
    )
    hint = f"Name the task {choice.task!r} instead, if that is to hold whichever option is taken."
    return Reason(rule="link_may_not_bind", message=message, severity="notice", node=goal.shown[:200], hint=hint)
