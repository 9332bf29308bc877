"""
A tree in columns as a 0-1 programme, the form in which solvers of other people take it.

Every child of an XOR has a variable that says whether it is selected. What stands below it, down to the next XOR, is selected with
it, so the variables at 1 are the alternative, and a sum over the tree is a sum over variables. Reads the file itself and imports
nothing of missiontree, so that nothing of ours takes part in what a peer is measured by.
"""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from time import perf_counter
from typing import Any

LEAF, AND, XOR = range(3)
ALWAYS = -1


@dataclass
class Programme:
    """
    Maximise the sum of ``gain``, within the rows.

    Parameters
    ----------
    variables
        How many there are.
    gain
        Utility by variable; under ``ALWAYS`` what is selected whatever happens.
    exactly_one
        For every XOR: the variable of which it is a part, or ``ALWAYS``, and the variables of its children.
    uses
        Per robot that has a budget: consumption by variable, or under ``ALWAYS``.
    budget
        What each of these may use.
    """

    variables: int = 0
    gain: Counter[int] = field(default_factory=Counter)
    exactly_one: list[tuple[int, list[int]]] = field(default_factory=list)
    uses: list[Counter[int]] = field(default_factory=list)
    budget: list[int] = field(default_factory=list)


def programme(tree: dict[str, Any], budgets: bool) -> Programme:
    """The programme of a tree, with or without its budgets."""
    made = Programme()
    uses: list[Counter[int]] = [Counter() for _ in range(tree["robots"])]
    of, row_of = [ALWAYS] * len(tree["kind"]), dict[int, list[int]]()
    for node, (kind, parent) in enumerate(zip(tree["kind"], tree["parent"], strict=True)):
        if parent in row_of:
            of[node] = made.variables
            row_of[parent].append(made.variables)
            made.variables += 1
        elif parent >= 0:
            of[node] = of[parent]
        if kind == XOR:
            row_of[node] = []
            made.exactly_one.append((of[node], row_of[node]))
        elif kind == LEAF:
            made.gain[of[node]] += tree["utility"][node]
            uses[tree["robot"][node]][of[node]] += tree["consumption"][node]
    if budgets and tree.get("budget") is not None:
        made.uses, made.budget = uses, tree["budget"]
    return made


@dataclass
class Answer:
    """
    What a solver says of one instance.

    Parameters
    ----------
    values
        Utilities, best first.
    bound
        No alternative is better; None if nothing is known.
    proven
        Whether ``values`` are proven to be the k best, or all there are.
    seconds
        From arrays to this answer.
    note
        What went wrong; empty if nothing.
    """

    values: list[float] = field(default_factory=list)
    bound: float | None = None
    proven: bool = False
    seconds: float = 0.0
    note: str = ""


SMALL = Programme(variables=2, gain=Counter({0: 1, 1: 2}), exactly_one=[(ALWAYS, [0, 1])])
"""Something to load a solver by."""
Solve = Callable[[Programme, int, Callable[[], float], int], Answer]
"""Programme, k, seconds left, seed → answer."""


def answer_from_command_line(solve: Solve) -> None:
    """``FILE K LIMIT SEED BUDGETS`` → the answer as one line of JSON. Reading the file and loading the solver do not count."""
    file, k, limit, seed, budgets = sys.argv[1:]
    tree = json.loads(Path(file).read_text(encoding="utf-8"))
    solve(SMALL, 1, lambda: 1.0, 0)
    started = perf_counter()
    answer = solve(
        programme(tree, budgets == "True"), int(k), lambda: float(limit) - (perf_counter() - started), int(seed)
    )
    answer.seconds = perf_counter() - started
    print(json.dumps(vars(answer)))
