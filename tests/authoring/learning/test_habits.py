"""What methods with the goal of a pattern do."""

from __future__ import annotations

import pytest

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.learning.habits import Habits, habits_of, served_goals
from missiontree.authoring.methods.method import built_in_methods


@pytest.mark.parametrize(
    ("pattern", "habits"),
    [
        ("<evacuate> {place}", Habits(calls=True)),
        ("evacuate {place}", Habits(calls=True)),
        ("save {place} from {hazard}", Habits(calls=True)),  # to save is to rescue or to protect
        ("<bring> {person} to safety", Habits(calls=True)),
        ("<bring> {object} to {place}", Habits()),  # only what is brought to safety may be in danger
        ("<warn> {person}", Habits(capabilities=("message_display",))),
        ("frobnicate {object}", Habits()),
    ],
)
def test_the_habits_of_a_goal(pattern: str, habits: Habits) -> None:
    assert habits_of(pattern, built_in_methods(), Lexicon()) == habits


def test_goals_that_nothing_built_in_serves_are_told_apart() -> None:
    assert {"search", "follow", "reach", "bring", "transport", "rescue", "warn", "look at", "put"} <= served_goals()
    assert not {"switch", "load", "push", "open", "close", "pack"} & served_goals()
