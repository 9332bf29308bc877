"""Some missions of a suite, by patterns."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase

from missiontree.errors import InputError
from missiontree.evaluation.suite import Setting, Suite
from missiontree.evaluation.suite_file import SuiteMission


def chosen(suite: Suite, patterns: Sequence[str]) -> tuple[tuple[Setting, SuiteMission], ...]:
    """
    The missions whose id or setting fits one of the patterns; all without patterns.

    Raises
    ------
    InputError
        If a pattern fits none.
    """
    every = tuple(suite.missions())
    fitting = {
        pattern: {
            mission.id
            for setting, mission in every
            if fnmatchcase(mission.id, pattern) or fnmatchcase(setting.id, pattern)
        }
        for pattern in patterns
    }
    if missed := [pattern for pattern, ids in fitting.items() if not ids]:
        settings = ", ".join(suite.ids)
        raise InputError(
            f"--only {missed[0]!r:.100} fits no mission",
            accepted=f"ids such as {every[0][1].id}, or settings: {settings}; * stands for any letters",
        )
    wanted = set().union(*fitting.values()) if patterns else {mission.id for _, mission in every}
    return tuple((setting, mission) for setting, mission in every if mission.id in wanted)
