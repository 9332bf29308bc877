"""Whoever ranks alternatives in the tables: ours in this process, peers each in a process of its own."""

from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import dataclass, replace
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from time import perf_counter

from benchmarks.peer_model import Answer
from benchmarks.trees import instance, text_of
from missiontree.allocation import ALLOCATORS
from missiontree.allocation.arrays import TreeArrays, k_best
from missiontree.allocation.columns import flat_of_columns
from missiontree.formats.importers.tree_grounded import fleet_of
from missiontree.formats.importers.tree_json import columns_of, read_tree
from missiontree.formats.reader import parse
from missiontree.mission.columns import WEIGHTS, TreeColumns
from missiontree.mission.control import Control

ROOT = Path(__file__).resolve().parents[1]
GRACE_S = 120.0
SHORT_S, REPEATS = 1.0, 5
"""What ours does in less than this is done that often again, and the quickest counts."""
PEERS = {"cp_sat": "ortools", "highs": "highspy"}
ARRAYS = "arrays"
"""The k best ways through bare arrays, compiled where numba is installed; takes no budgets."""
OURS = (*ALLOCATORS, ARRAYS)


@dataclass(frozen=True, slots=True)
class Question:
    """
    An instance and what is asked of it.

    Parameters
    ----------
    file
        The tree.
    k
        How many alternatives.
    budgets
        Whether budgets limit the robots.
    limit_s
        Seconds.
    seed
        Of everything random.
    """

    file: Path
    k: int
    budgets: bool
    limit_s: float
    seed: int


def installed(name: str) -> bool:
    """Whether the contender can take part here."""
    return name in OURS or find_spec(PEERS[name]) is not None


def answer_of(name: str, question: Question) -> Answer:
    """The answer of a contender; the clock runs from arrays to the list, when everything is loaded."""
    return _ours(name, question) if name in OURS else _peer(name, question)


def warm(name: str) -> None:
    """Let one of ours do something small, so that what is loaded or compiled at first is not measured."""
    small = columns_of(parse(text_of(instance("mission", 300, 6, 1)), "warm.json"))
    question = Question(Path(), k=10, budgets=True, limit_s=60.0, seed=0)
    ranked(name, small, question)
    if name == ARRAYS:  # which has a loop of its own for equal utilities
        ranked(name, replace(small, utility=[0] * len(small.kind)), question)


def _ours(name: str, question: Question) -> Answer:
    warm(name)
    return quickest(name, read_tree(question.file), question)


def quickest(name: str, columns: TreeColumns, question: Question) -> Answer:
    """The answer of one of ours, once; several times if it is quick, for then whatever else the machine does counts for more."""
    answer = ranked(name, columns, question)
    return answer if answer.seconds >= SHORT_S else ranked(name, columns, question, REPEATS)


def ranked(name: str, columns: TreeColumns, question: Question, times: int = 1) -> Answer:
    """The answer of one of ours, for a tree that is loaded; of several times, the seconds of the quickest."""
    if name == ARRAYS:
        return _ranked_in_arrays(columns, question, times)
    flat, fleet = flat_of_columns(columns, budgets=question.budgets), fleet_of(columns)
    seconds = []
    for _ in range(times):
        control = Control(time_limit_s=question.limit_s, seed=question.seed)
        started = perf_counter()
        ranking = ALLOCATORS[name](flat, fleet, WEIGHTS, question.k, control)
        seconds.append(perf_counter() - started)
    found = ranking.alternatives
    best = found[0].certificate if found else ranking.certificate
    return Answer(
        values=[alternative.utility for alternative in found],
        bound=best.bound,
        proven=ranking.status in {"exact", "infeasible"},
        seconds=min(seconds),
    )


def _ranked_in_arrays(columns: TreeColumns, question: Question, times: int) -> Answer:
    np = import_module("numpy")  # for this contender only
    tree = TreeArrays(*(np.array(column) for column in (columns.kind, columns.parent, columns.utility)))
    seconds = []
    for _ in range(times):
        started = perf_counter()
        found = k_best(tree, question.k)
        seconds.append(perf_counter() - started)
    return Answer(
        values=[float(way.utility) for way in found.ways],
        bound=float(found.ways[0].utility) if found.ways else None,
        proven=True,
        seconds=min(seconds),
    )


def _peer(name: str, question: Question) -> Answer:
    command = [sys.executable, "-m", f"benchmarks.peer_{name.replace('_', '')}", str(question.file), str(question.k)]
    command += [str(question.limit_s), str(question.seed), str(question.budgets)]
    try:
        ran = subprocess.run(
            command, cwd=ROOT, capture_output=True, text=True, timeout=question.limit_s + GRACE_S, check=False
        )
    except subprocess.TimeoutExpired:
        return Answer(seconds=question.limit_s + GRACE_S, note="did not stop")
    if ran.returncode:
        last = (ran.stderr.strip().splitlines() or [f"exit {ran.returncode}"])[-1]
        return Answer(note=last)
    return Answer(**json.loads(ran.stdout.splitlines()[-1]))
