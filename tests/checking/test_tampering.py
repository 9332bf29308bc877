"""
Single values of a plan file changed one at a time, as somebody might who wants to deceive, or whose disk does.

Every change is refused by the reader or found by the checker, unless it is in a field that carries no claim or makes another sound
plan; those are listed here and in ``docs/reference/checks.md``.
"""

from __future__ import annotations

import copy
import json
import random
import re
from collections.abc import Iterator
from typing import Any

import pytest

from missiontree.checking import check
from missiontree.errors import InputError
from missiontree.formats.document import read_text, write_text
from tests.checking.plans import PLANS

EDITS = 60
"""Edits per plan."""

FREE = tuple(
    re.compile(pattern)
    for pattern in (
        # words for the reader
        r"(ranking|ranking/alternatives/\d+|schedules/\d+)/certificate/detail",
        r"(front|front/options/\d+|chosen/option)(/alternative|/schedule)?/certificate/detail",
        r"ranking/(examined|reasons(/\d+(/\w+)?)?)",
        r"(assumptions|notices)/\d+/(rule|message|hint|found|needed|severity)",  # the author's; grounding's are compared
        # what an estimator of the user's own said of those who are not good enough, and more than is asked of it
        r"grounding/estimates/\d+/estimate/(quality|duration_s|cost)",
        # of a plan for a part of the mission: what is left out of it, and why; a sound plan says nothing of either
        r"partial/whole/(links|nodes/\d+/(arguments(/\w+)?|label|routine))|reasons(/\d+(/\w+)?)?",
        # how the author understood the text, and what took part
        r"provenance/(reading(/\d+)?|allocator|scheduler|seed|versions(/\w+)?)",
    )
)
"""Fields that carry no claim, as paths into the file."""

AS_SOUND = tuple(
    re.compile(pattern)
    for pattern in (
        # a detour, a robot that sets out at another time, a following that starts at another time
        r"(schedules/\d+|front/options/\d+/schedule|chosen/option/schedule)/legs/\d+/(distance_m|start_s|end_s)",
        r"(schedules/\d+|front/options/\d+/schedule|chosen/option/schedule)/(returns/\d+|recharges/\d+/leg)/distance_m",
        r"(schedules/\d+|front/options/\d+/schedule|chosen/option/schedule)/actions/\d+/start_s",
        # a weaker claim than could be made
        r"(ranking|ranking/alternatives/\d+|schedules/\d+)/certificate/(bound|claim)",
        r"(front|front/options/\d+|chosen/option)(/schedule)?/certificate/(bound|claim)",
    )
)
"""Fields that are checked, and in which another value may be just as sound."""

Path = tuple[str | int, ...]


def places(value: Any, path: Path = ()) -> Iterator[tuple[Path, Any]]:
    """Every value in a document with its path; lists and objects stand for themselves, too."""
    stack: list[tuple[Path, Any]] = [(path, value)]
    while stack:
        here, found = stack.pop()
        if here:
            yield here, found
        if isinstance(found, dict):
            stack += [((*here, key), item) for key, item in found.items()]
        elif isinstance(found, list):
            stack += [((*here, number), item) for number, item in enumerate(found)]


def otherwise(value: Any, rng: random.Random) -> Any:
    """Another value of the same kind."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, int | float):
        return value + rng.choice((1, -1, 0.25, 1000))
    if isinstance(value, str):
        return rng.choice((value + "x", value[1:] or "y"))
    if isinstance(value, list):
        return rng.choice(([], value[:-1], value[1:]))
    return {}


def tampered(plain: Any, path: Path, rng: random.Random) -> Any:
    changed = copy.deepcopy(plain)
    owner = changed
    for step in path[:-1]:
        owner = owner[step]
    owner[path[-1]] = otherwise(owner[path[-1]], rng)
    return changed


def unnoticed(text: str) -> bool:
    try:
        return not check(read_text(text, "plan"))
    except InputError:
        return False


@pytest.mark.parametrize("name", PLANS)
def test_every_edit_of_a_claim_is_noticed(name: str) -> None:
    """A sample of all single edits; what passes is in the lists above, and is little."""
    rng = random.Random(name)  # noqa: S311 - variation, not secrecy
    plain = json.loads(write_text(PLANS[name](), "plan"))
    every = sorted(places(plain), key=lambda place: list(map(str, place[0])))
    passed = []
    for path, value in rng.sample(every, EDITS):
        edited = tampered(plain, path, rng)
        if edited != plain and unnoticed(json.dumps(edited)):
            passed.append(("/".join(map(str, path)), value))
    assert [(path, value) for path, value in passed if not any(one.fullmatch(path) for one in FREE + AS_SOUND)] == []
    assert len(passed) <= EDITS / 6
