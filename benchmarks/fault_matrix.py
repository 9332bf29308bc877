"""
Every fault of a provider at every turn of a dialogue, streamed or not, once and for ever: the real loop and the real SDK against a real
HTTP server on loopback, which takes no history that the strictest provider would refuse. Exits with 1 if a cell is wrong.

usage: python -m benchmarks.fault_matrix [--fault NAME] [--hold SECONDS]
"""

from __future__ import annotations

import argparse
import itertools
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache

from benchmarks.machine import machine_line
from missiontree.authoring.author import author_tree
from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.dialogue import Company
from missiontree.authoring.outcome import Authored
from missiontree.authoring.tools import ToolBox
from missiontree.llm.openai import OpenAIModel
from missiontree.llm.patience import Patience
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.tree import MissionTree
from missiontree.routines.library import built_in
from tests.builders import paper_fleet
from tests.llm.endpoint import KEY, Endpoint
from tests.llm.endpoint_faults import CASES, Case
from tests.llm.endpoint_replies import Turn

_LONGEST = 1_000
MISSION = "Reunite mom with her lost child"
TURNS = (
    Turn(
        "First the child is searched for, then both are brought together.",
        (
            ("HierarchicalTree_init", {"objective": MISSION}),
            (
                "addMultiSubtasks",
                {
                    "parentString": MISSION,
                    "isPrimitiveList": [False, False],
                    "taskNameList": ["Locate the child", "Bring the child to mom"],
                    "LogicalConstraint": "AND",
                    "constraintPairs": [[0, 1]],
                },
            ),
        ),
    ),
    Turn(
        "The first task is a search.",
        (
            (
                "attachMultiSubTrees",
                {
                    "parentString": "Locate the child",
                    "treeNames": ["SearchTree"],
                    "treeArguments": [["Child"]],
                    "LogicalConstraint": "AND",
                    "constraintPairs": None,
                },
            ),
        ),
    ),
    Turn("That is all there is to do."),
    Turn(
        "The second task is still open. It brings the child.",
        (
            (
                "attachMultiSubTrees",
                {
                    "parentString": "Bring the child to mom",
                    "treeNames": ["ReachAndTransportTree"],
                    "treeArguments": [["Child", "Mom"]],
                    "LogicalConstraint": "AND",
                    "constraintPairs": None,
                },
            ),
            ("checkTree", {}),
        ),
    ),
    Turn("Each part is covered, and the order is right."),
)
"""The dialogue without a fault: the model stops too early and is reminded once; its last turn answers the review."""


@dataclass
class Slept:
    """A clock that moves only when somebody sleeps."""

    now: float = 0.0
    naps: list[float] = field(default_factory=list)

    def sleep(self, seconds: float) -> None:
        """Let that time pass at once."""
        self.naps.append(seconds)
        self.now += seconds


@dataclass(frozen=True)
class Cell:
    """
    A cell of the matrix.

    Parameters
    ----------
    case
        The fault.
    turn
        The turn before which it is met, from 1.
    stream
        Whether answers are streamed.
    for_ever
        Whether it is met at every attempt, or at the first only.
    """

    case: Case
    turn: int
    stream: bool
    for_ever: bool

    def __str__(self) -> str:
        often = "for ever" if self.for_ever else "once"
        return f"{self.case.name}, turn {self.turn}, {'streamed' if self.stream else 'whole'}, {often}"


def cells() -> Iterator[Cell]:
    """All of them. What is final is so at the first time; and what a model is told for ever is a matter of budgets, not of faults."""
    for case, turn, stream in itertools.product(CASES, range(1, len(TURNS) + 1), (True, False)):
        yield Cell(case, turn, stream, for_ever=False)
        if case.fate == "passes":
            yield Cell(case, turn, stream, for_ever=True)


def brief() -> MissionBrief:
    """The paper's first mission with its fleet."""
    return MissionBrief(text=MISSION, fleet=paper_fleet(), routines=built_in())


@dataclass(frozen=True)
class Seen:
    """What a dialogue came to, and what the server and the clock saw of it."""

    authored: Authored
    violations: tuple[str, ...]
    requests: int
    naps: tuple[float, ...]
    turn: int


def held(faults: dict[int, Iterator[object]] | None, stream: bool, timeout_s: float) -> Seen:
    """Hold the dialogue against a server with those faults."""
    slept = Slept()
    patience = Patience(timeout_s=timeout_s, sleep=slept.sleep, clock=lambda: slept.now)
    with Endpoint(TURNS, faults) as endpoint:  # type: ignore[arg-type]  # faults of all cases are of one type
        model = OpenAIModel("played", base_url=endpoint.url, api_key=KEY, stream=stream, patience=patience)
        company = Company(control=Control(clock=lambda: slept.now))
        authored = author_tree(brief(), model, company=company)
    return Seen(authored, tuple(endpoint.violations), len(endpoint.requests), tuple(slept.naps), endpoint.turn)


@cache
def faultless() -> Seen:
    """The dialogue without a fault."""
    return held(None, stream=True, timeout_s=30)


@cache
def tree_before(turn: int) -> MissionTree | None:
    """The tree that the turns before that one build, made without any model."""
    box = ToolBox(TreeBuilder(brief()))
    for said in TURNS[: turn - 1]:
        for name, arguments in said.calls:
            assert box.call(name, arguments).ok, name
    return box.builder.tree


def wrong_in(cell: Cell, timeout_s: float = 0.5) -> list[str]:
    """
    What is wrong with a cell; empty if nothing is.

    Parameters
    ----------
    cell
        The cell.
    timeout_s
        How long the client waits where the server is silent.
    """
    case = cell.case
    ended = cell.for_ever or case.fate == "final"
    fault = itertools.repeat(case.fault) if ended else iter([case.fault])
    seen = held({cell.turn: fault}, cell.stream, timeout_s if case.holds else 30)
    waits = (case.waits if cell.for_ever else case.waits[:1]) if case.fate == "passes" else ()
    expected = {
        "violations of the server's rules": (seen.violations, ()),
        "seconds slept": (seen.naps, waits),
        **(_ended(cell, seen) if ended else _recovered(cell, seen)),
    }
    wrong = [f"{what}: {got!r}, not {wanted!r}" for what, (got, wanted) in expected.items() if got != wanted]
    limits = Patience()
    if any(nap > limits.longest_wait_s for nap in seen.naps) or sum(seen.naps) > limits.total_s:
        wrong.append(f"slept beyond the cap: {seen.naps}")
    return wrong


def _ended(cell: Cell, seen: Seen) -> dict[str, tuple[object, object]]:
    """The right end: the outcome with its rule, and the tree as the turns before built it."""
    rules = [reason.rule for reason in seen.authored.reasons]
    case, asked = cell.case, seen.requests - (cell.turn - 1)
    allowed = range(1, case.requests + 1) if case.fate == "final" else range(4, 5)
    return {
        "status": (seen.authored.status, "provider_failed"),
        "rules": (rules, [f"provider_{case.kind}"]),
        "tree so far": (seen.authored.tree, tree_before(cell.turn)),
        "turns said": (seen.turn, cell.turn),
        f"requests among {list(allowed)}": (asked in allowed, True),
    }


def _recovered(cell: Cell, seen: Seen) -> dict[str, tuple[object, object]]:
    """The same tree as without the fault, every call made once; and if the fault passed, the very same transcript."""
    whole = faultless()
    expected: dict[str, tuple[object, object]] = {
        "status": (seen.authored.status, "complete"),
        "tree": (seen.authored.tree, whole.authored.tree),
        "calls that applied": (_answers(seen, "true"), _answers(whole, "true")),
        "calls that were refused": (_answers(seen, "false"), cell.case.refused),
        "requests": (seen.requests, whole.requests + 1),
    }
    if cell.case.fate == "passes":
        expected["transcript"] = (seen.authored.transcript, whole.authored.transcript)
    return expected


def _answers(seen: Seen, ok: str) -> int:
    return sum(f'"kind":"answer","ok":{ok}' in line for line in seen.authored.transcript)


def main() -> None:
    """Go through the matrix and print it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fault", help="this fault only")
    parser.add_argument(
        "--hold", type=float, default=0.5, metavar="SECONDS", help="patience with silence (default 0.5)"
    )
    options = parser.parse_args()
    whole = faultless()
    assert (whole.authored.status, whole.authored.tree) == ("complete", tree_before(len(TURNS) + 1)), whole.authored
    assert (whole.requests, whole.violations) == (len(TURNS), ()), whole
    wrong = {cell: wrong_in(cell, options.hold) for cell in cells() if options.fault in {None, cell.case.name}}
    print(machine_line("openai"))
    print(f"{len(TURNS)} turns; streamed and whole; patience with silence {options.hold:g} s\n")
    print("| fault | must come to | cells | right | wrong |\n|---|---|---|---|---|")
    for case in CASES:
        found = [bool(what) for cell, what in wrong.items() if cell.case is case]
        if found:
            print(f"| {case.name} | {_fate(case)} | {len(found)} | {found.count(False)} | {found.count(True)} |")
    amiss = {cell: what for cell, what in wrong.items() if what}
    print(f"| all | | {len(wrong)} | {len(wrong) - len(amiss)} | {len(amiss)} |")
    for cell, what in amiss.items():
        print(f"\n{cell}", *(line[:_LONGEST] for line in what), sep="\n  ")
    raise SystemExit(1 if amiss else 0)


def _fate(case: Case) -> str:
    if case.fate == "passes":
        return f"the same transcript; for ever: provider_{case.kind}"
    return "the same tree" if case.fate == "told" else f"provider_{case.kind}"


if __name__ == "__main__":
    main()
