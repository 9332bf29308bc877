"""
Impossible missions beside possible twins, from whose world one thing was taken: are the right ones declined, for what is missing?

The offline author reads both, and both are planned to the end. What was taken is computed from the two worlds: a capability, a limit, or a
place. *Declared* is how authoring ended; some limits and ways are only looked at when robots are chosen, and *planned* is how that ended.
*Right thing missing* asks for a reason that says this of just those robots that lost it; *first reason* asks that of the first reason.

usage: python -m benchmarks.twins [--suite FOLDER] [--list]
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import missiontree
from benchmarks.machine import machine_line
from benchmarks.twin_removal import KINDS, Removal, removals
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.errors import InputError
from missiontree.evaluation.suite import Setting, Suite, load_suite
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.evaluation.verdict import Verdict, judge
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.planner import author, plan_request

SUITE = Path(missiontree.__file__).parent / "evaluation" / "suites" / "models"
HEAD = (
    "taken",
    "pairs",
    "impossible: declared by the author",
    "impossible: cannot be done when planned",
    "right thing missing",
    "right thing in the first reason",
    "possible: refused",
    "possible: right and delivered",
)


@dataclass(frozen=True)
class Twin:
    """One of a pair, what the offline author makes of it, and what planning that comes to."""

    setting: Setting
    mission: SuiteMission

    @cached_property
    def brief(self) -> MissionBrief:
        """What the author is given."""
        return self.setting.brief(self.mission)

    @cached_property
    def authored(self) -> Authored:
        """What the author made of it."""
        return author(Request(brief=self.brief))

    @cached_property
    def plan(self) -> Plan:
        """What planning came to."""
        return plan_request(Request(brief=self.brief), Control())

    @cached_property
    def verdict(self) -> Verdict:
        """The verdict on the whole."""
        return judge(self.mission, self.authored, self.brief, self.plan)


@dataclass(frozen=True)
class Pair:
    """A possible mission and its impossible twin."""

    possible: Twin
    impossible: Twin

    @cached_property
    def taken(self) -> tuple[Removal, ...]:
        """What differs between them; one thing if they are twins."""
        return removals(self.possible.brief, self.impossible.brief)

    @property
    def is_named(self) -> bool:
        """Whether what was taken is said to be missing."""
        return all(one.is_missing_in(self.impossible.plan.reasons) for one in self.taken)

    @property
    def is_named_first(self) -> bool:
        """Whether the first reason, which people read first, needs what was taken or says that it is blocked."""
        first = self.impossible.plan.reasons[:1]
        return all(one.name in f"{reason.needed} {reason.message}" for one in self.taken for reason in first)


def pairs_of(suite: Suite) -> Iterator[Pair]:
    """
    The pairs of a suite.

    An impossible mission names its twin. Where authoring cannot tell, since ways and budgets are looked at later, the right tree is
    expected with the outcome that it cannot be done; its twin is the mission of the same setting in the same words.
    """
    every = {mission.id: Twin(setting, mission) for setting, mission in suite.missions()}
    for twin in every.values():
        if twin.mission.twin is not None:
            yield Pair(every[twin.mission.twin], twin)
        elif twin.mission.outcome == "cannot_be_done":
            alike = (other for other in twin.setting.missions if other.say == twin.mission.say)
            yield from (Pair(every[other.id], twin) for other in alike if other.outcome is None)


def table(pairs: Sequence[Pair]) -> str:
    """A row for each kind of thing that is taken, and one for all."""
    rows = [_row(kind, [pair for pair in pairs if any(one.kind == kind for one in pair.taken)]) for kind in KINDS]
    return "\n".join([f"| {' | '.join(HEAD)} |", f"|{'---|' * len(HEAD)}", *rows, _row("total", pairs)])


def _row(name: str, pairs: Sequence[Pair]) -> str:
    counted = (
        len(pairs),
        sum(pair.impossible.authored.status == "cannot_be_done" for pair in pairs),
        sum(pair.impossible.plan.outcome == "cannot_be_done" for pair in pairs),
        sum(pair.impossible.plan.outcome == "cannot_be_done" and pair.is_named for pair in pairs),
        sum(pair.impossible.plan.outcome == "cannot_be_done" and pair.is_named_first for pair in pairs),
        sum(pair.possible.plan.outcome != "delivered" for pair in pairs),
        sum(pair.possible.plan.outcome == "delivered" and pair.possible.verdict.kind == "right" for pair in pairs),
    )
    return f"| {name} | {' | '.join(map(str, counted))} |"


def shown(pair: Pair) -> str:
    """A pair as a block of text."""
    taken = "; ".join(f"{one.kind} {one.name} {', '.join(one.types)}".strip() for one in pair.taken)
    first = next((reason.message for reason in pair.impossible.plan.reasons), "no reason")
    return "\n".join(
        (
            f"{pair.impossible.mission.id} beside {pair.possible.mission.id}: {pair.possible.mission.say}",
            f"  taken: {taken}",
            f"  impossible: authored {pair.impossible.authored.status}, planned {pair.impossible.plan.outcome}: {first}",
            f"  possible: authored {pair.possible.authored.status}, planned {pair.possible.plan.outcome}",
        )
    )


def is_right(pair: Pair) -> bool:
    """Whether the one is planned and the other declined for what was taken."""
    return pair.is_named and all(twin.verdict.kind == "right" for twin in (pair.possible, pair.impossible))


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--suite", type=Path, default=SUITE, metavar="FOLDER", help="default: the built-in one for models"
    )
    parser.add_argument("--list", action="store_true", help="print every pair, and not only those that go wrong")
    options = parser.parse_args()
    try:
        suite = load_suite(options.suite)
    except InputError as error:
        print(error, file=sys.stderr)
        raise SystemExit(2) from None
    pairs = list(pairs_of(suite))
    print(f"{machine_line('pydantic')}\nsuite {options.suite.name}, offline author\n\n{table(pairs)}")
    for pair in pairs:
        if options.list or not is_right(pair):
            print(f"\n{shown(pair)}")


if __name__ == "__main__":
    main()
