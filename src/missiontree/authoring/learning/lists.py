"""Lists in a clause: "the crate, the box and the bag" is one slot that holds several, if the same is done with each of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from missiontree.authoring.learning.spotting import HAZARD, Named
from missiontree.authoring.reading.words import Word
from missiontree.errors import InputError
from missiontree.mission.tree import MissionTree

_JOINING = frozenset({"and", ",", "&"})


def lists_joined(named: Sequence[Named], words: Sequence[Word], tree: MissionTree) -> tuple[Named, ...]:
    """
    Those named, with each list as one.

    Two who are joined by *and*, and with whom the tree does different things, stay two: "reunite mom and her child".

    Raises
    ------
    InputError
        If a list names more than two, or commas, and the tree does not do the same with each.
    """
    made: list[Named] = []
    for run in _runs(named, words):
        if len(run) == 1 or any(one.kind == HAZARD for one in run):
            made += run
            continue
        parts = [_parts(tree, one.mention.name) for one in run]
        if all(part == parts[0] for part in parts):
            others = tuple(one.mention for one in run[1:])
            start = run[0].start - (run[0].start > 0 and words[run[0].start - 1].low == "both")
            used = any(one.used for one in run)
            made.append(replace(run[0], start=start, end=run[-1].end, used=used, others=others))
        elif len(run) == 2 and run[1].start - run[0].end == 1 and words[run[0].end].low != ",":
            made += run
        else:
            text = " ".join(word.text for word in words[run[0].start : run[-1].end]).replace(" ,", ",")
            hint = "Learn from a mission that names one: its slot may then hold several."
            raise InputError(f"{text!r} is a list, and the tree does not do the same with each of it", hint=hint)
    return tuple(made)


def _runs(named: Sequence[Named], words: Sequence[Word]) -> list[list[Named]]:
    """Those named, by what is joined by nothing but commas and *and*."""
    runs: list[list[Named]] = []
    for one in named:
        between = [word.low for word in words[runs[-1][-1].end : one.start]] if runs else []
        if between and set(between) <= _JOINING:
            runs[-1].append(one)
        else:
            runs.append([one])
    return runs


def _parts(tree: MissionTree, name: str) -> Counter[tuple[str, str]]:
    """In which arguments of which routines somebody stands."""
    return Counter(
        (node.routine or "", argument)
        for node in tree.nodes
        for argument, entity in node.arguments.items()
        if entity == name
    )
