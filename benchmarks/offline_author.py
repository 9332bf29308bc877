"""
How many missions in plain English the offline author gets right. Authoring only: nothing is allocated or scheduled.

A third of each setting is set aside by a seed, so that the author can be worked on with the open part alone.

usage: python -m benchmarks.offline_author [--part open|aside|all] [--seed 20250127] [--suite FOLDER] [--json FILE] [--list]
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import missiontree
from benchmarks.machine import machine_line
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.errors import InputError
from missiontree.evaluation.draw import set_aside
from missiontree.evaluation.suite import Setting, Suite, load_suite
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.evaluation.tally import Tally, tally
from missiontree.evaluation.told import told
from missiontree.evaluation.verdict import Verdict, judge
from missiontree.formats.json_text import json_text
from missiontree.formats.plain import to_plain
from missiontree.mission.brief import MissionBrief
from missiontree.planner import author

SUITE = Path(missiontree.__file__).parent / "evaluation" / "suites" / "english"
SEED = 20250127
HEAD = ("missions", "right", "declined though possible", "wrong decline", "wrong and silent")


@dataclass(frozen=True)
class Judged:
    """A mission, what the author made of it, and the verdict."""

    setting: Setting
    mission: SuiteMission
    brief: MissionBrief
    authored: Authored
    verdict: Verdict


def missions_of(suite: Suite, part: str, seed: int) -> Iterator[tuple[Setting, SuiteMission]]:
    """The missions of a part of the suite."""
    aside = set_aside(suite.ids, seed)
    for setting, mission in suite.missions():
        if part == "all" or (mission.id in aside) == (part == "aside"):
            yield setting, mission


def judged(setting: Setting, mission: SuiteMission) -> Judged:
    """Have the offline author read a mission, and judge what it made."""
    brief = setting.brief(mission)
    try:
        authored = author(Request(brief=brief))
    except Exception as error:
        error.add_note(f"while reading mission {mission.id}: {mission.say}")
        raise
    return Judged(setting, mission, brief, authored, judge(mission, authored, brief))


def table(all_judged: list[Judged], by_setting: bool) -> str:
    """Rows of settings, if asked for, and of the total."""
    names = list(dict.fromkeys(one.setting.id for one in all_judged)) if by_setting else []
    rows = [_row(name, tally(one.verdict for one in all_judged if one.setting.id == name)) for name in names]
    head = f"| setting | {' | '.join(HEAD)} |\n|---|{'---|' * len(HEAD)}"
    return "\n".join([head, *rows, _row("total", tally(one.verdict for one in all_judged))])


def _row(name: str, numbers: Tally) -> str:
    counted = (numbers.right, numbers.declined_though_possible, numbers.wrong_decline, numbers.wrong)
    return f"| {name} | {' | '.join(map(str, (numbers.missions, *counted)))} |"


def miss(one: Judged) -> str:
    """A miss as a block of text."""
    lines = [f"{one.mission.id}: {one.verdict.kind.replace('_', ' ')}", f"  words: {one.mission.say}"]
    lines += [f"  expected: {text}" for text in one.mission.wanted]
    lines.append(f"  got: {got(one)}")
    lines += [f"  difference: {text}" for text in one.verdict.differences]
    lines += [f"  reason: {reason.rule}: {reason.message}" for reason in one.authored.reasons]
    return "\n".join(lines)


def got(one: Judged) -> str:
    """What the author made, in the notation of suites."""
    if one.authored.status != "complete" or one.authored.tree is None:
        return one.authored.status
    return told(one.authored.tree, one.brief)


def record(one: Judged) -> dict[str, object]:
    """A mission and its verdict as plain data."""
    reasons = [to_plain(reason) for reason in one.authored.reasons]
    told = {"setting": one.setting.id, "words": one.mission.say, "expected": list(one.mission.wanted), "got": got(one)}
    return {**to_plain(one.verdict), **told, "reasons": reasons}


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--part", choices=("open", "aside", "all"), default="open", help="default: open")
    parser.add_argument("--seed", type=int, default=SEED, help=f"seed of the draw (default {SEED})")
    parser.add_argument("--suite", type=Path, default=SUITE, metavar="FOLDER", help="default: the built-in English one")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write every verdict to this file, too")
    parser.add_argument("--list", action="store_true", help="print the ids of the part, and run nothing")
    options = parser.parse_args()
    try:
        suite = load_suite(options.suite)
    except InputError as error:
        print(error, file=sys.stderr)
        raise SystemExit(2) from None
    chosen = list(missions_of(suite, options.part, options.seed))
    if options.list:
        print("\n".join(mission.id for _, mission in chosen))
        return
    done = [judged(setting, mission) for setting, mission in chosen]
    line = machine_line("pydantic")
    print(f"{line}\nsuite {options.suite.name}, part {options.part}, seed {options.seed}, offline author\n")
    print(table(done, by_setting=options.part != "aside"))
    for one in done:
        if one.verdict.kind != "right":
            print(f"\n{miss(one)}")
    if options.json is not None:
        head = {"machine": line, "suite": options.suite.name, "part": options.part, "seed": options.seed}
        total = to_plain(tally(one.verdict for one in done))
        options.json.write_text(json_text({**head, "total": total, "missions": [record(one) for one in done]}), "utf-8")


if __name__ == "__main__":
    main()
