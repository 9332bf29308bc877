"""A ranking as people read it, and as JSON."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import NamedTuple

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from missiontree.allocation.flat import Flat
from missiontree.formats.plain import to_plain
from missiontree.mission.aim import PLAIN_AIM, Aim
from missiontree.mission.alternative import Alternative, Ranking
from missiontree.mission.certificate import Certificate
from missiontree.mission.limit_use import LimitUse, Whose
from missiontree.reporting.text import MAX_LINES, reason_line, words

MOST_ROWS = 20
MOST_LIMITS = 12
STATUS = {
    "exact": "every rank proven",
    "partial": "not all ranks proven",
    "infeasible": "proven that there is none",
    "unknown": "none found, none excluded",
}
WHOSE: dict[Whose, str] = {
    "robot": "{}",
    "robots": "all of {}",
    "type": "all of {}",
    "mission": "the whole mission",
    "stock": "stock of the scene",
}
CLAIMS = {
    "proven": "proven",
    "bounded": "feasible, rank not proven",
    "solver_word": "by the solver's word",
    "unproven": "not proven",
}


class Told(NamedTuple):
    """
    What there is to tell.

    Parameters
    ----------
    flat
        The tree.
    ranking
        What was found.
    allocator, k, seed, time_limit_s
        What was asked for.
    elapsed_s
        Seconds that ranking took.
    not_kept
        What the file asks for and this ranking does not keep; empty if nothing.
    aim
        What the best are.
    """

    flat: Flat
    ranking: Ranking
    allocator: str
    k: int
    seed: int
    time_limit_s: float | None
    elapsed_s: float
    not_kept: str
    aim: Aim = PLAIN_AIM


def gap_of(alternative: Alternative) -> float | None:
    """How much better than this one what is not listed may be, as a share of its utility; None if nothing is known."""
    bound = alternative.certificate.bound
    return None if bound is None else abs(bound - alternative.utility) / max(1.0, abs(alternative.utility))


def view_of(told: Told) -> Group:
    """The ranking for a terminal."""
    return Group(*_sections(told))


def _counted(noun: str, count: int) -> str:
    several = "leaves" if noun == "leaf" else f"{noun}s"
    return f"{count:,} {noun if count == 1 else several}"


def _sections(told: Told) -> Iterator[RenderableType]:
    flat, ranking = told.flat, told.ranking
    found = ranking.alternatives
    leaves = len(flat.role) - flat.role.count(-1)
    counts = (("node", len(flat.kind)), ("leaf", leaves), ("robot", _robots(flat)), ("limit", _limits(flat)))
    yield Text(", ".join(_counted(*count) for count in counts), style="dim")
    several = f"alternative{'s' if len(found) != 1 else ''}{' of different teams' if told.aim.diverse else ''}"
    count = f"{len(found)} {several}, best first" if found else "No alternative"
    yield Text(f"{count} ({STATUS[ranking.status]})", style="bold")
    if found:
        yield Padding(_alternatives(found, told.aim.worth), (0, 0, 0, 2), expand=False)
        if found[0].uses:
            yield Text("What alternative 1 uses of its limits", style="bold")
            yield Padding(_uses(found[0].uses), (0, 0, 0, 2), expand=False)
    yield Text(_of_the_rest(ranking, "Other teams" if told.aim.diverse and found else "What is not listed"))
    yield from (reason_line(reason) for reason in ranking.reasons[:MAX_LINES])
    if len(ranking.reasons) > MAX_LINES:
        yield Text(f"… and {len(ranking.reasons) - MAX_LINES} more; --json lists them all", style="dim")
    limit = "no time limit" if told.time_limit_s is None else f"time limit {told.time_limit_s:g} s"
    spent = f"{ranking.examined:,} candidates in {told.elapsed_s:.3f} s"
    yield Text(f"{told.allocator}, seed {told.seed}, {limit}: {spent}", style="dim")


def _robots(flat: Flat) -> int:
    return sum(len(stock.robots) for stock in flat.stocks.values())


def _limits(flat: Flat) -> int:
    of_types = sum(len(stock.totals) + sum(map(len, stock.budgets)) for stock in flat.stocks.values())
    return of_types + len(flat.shared)


def _table(*columns: str, left: tuple[str, ...]) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0), header_style="dim")
    for name in columns:
        table.add_column(name, justify="left" if name in left else "right", no_wrap=name not in left)
    return table


def _alternatives(found: tuple[Alternative, ...], worth: str) -> Table:
    table = _table("#", worth, "bound", "gap", "known", left=("known",))
    for alternative in found[:MOST_ROWS]:
        bound, gap = alternative.certificate.bound, gap_of(alternative)
        table.add_row(
            str(alternative.rank),
            number(alternative.utility),
            "-" if bound is None else number(bound),
            "-" if gap is None else percent(gap),
            _known(alternative.certificate),
        )
    if len(found) > MOST_ROWS:
        last = found[-1]
        table.add_row(
            "…", number(last.utility), "", "", f"{len(found) - MOST_ROWS} more, down to this utility; --json lists all"
        )
    return table


def _known(certificate: Certificate) -> str:
    return f"{CLAIMS[certificate.claim]}, by {_method(certificate)}"


def _method(certificate: Certificate) -> str:
    return certificate.method.replace("_", " ")


def _uses(uses: tuple[LimitUse, ...]) -> RenderableType:
    """The limits, the tightest first."""
    table = _table("who", "limit", "used", "allowed", "share", left=("who", "limit"))
    for use in sorted(uses, key=lambda use: -use.share)[:MOST_LIMITS]:
        who = words(WHOSE[use.whose].format(use.who))
        table.add_row(who, words(use.name), number(use.used), number(use.limit), percent(use.share))
    if len(uses) <= MOST_LIMITS:
        return table
    return Group(table, Text(f"… and {len(uses) - MOST_LIMITS} more, none tighter; --json lists them all", style="dim"))


def _of_the_rest(ranking: Ranking, rest: str) -> str:
    """What is known of everything that is not listed."""
    certificate = ranking.certificate
    if certificate.bound is not None:
        known = f"{rest}: nothing above {number(certificate.bound)}, {certificate.claim} by {_method(certificate)}."
    else:
        detail = certificate.detail or "Nothing is known."
        known = f"{rest}: {detail} ({certificate.claim}, by {_method(certificate)})"
    return known if certificate.limit is None else f"{known} The search was ended by {certificate.limit.in_words}."


def number(value: float) -> str:
    """A number with all its digits, in steps of a millionth: ``105513098``, ``5.6``."""
    return f"{value:.6f}".rstrip("0").rstrip(".")


def percent(share: float) -> str:
    """A share for people: ``0``, ``0.38 %``, ``104 %``; never 0 for what is above it."""
    if share == 0:
        return "0"
    return "< 0.001 %" if share < 1e-5 else f"{100 * share:.3g} %"


def json_of(told: Told) -> str:
    """The ranking as JSON, an alternative per line; ``chosen`` is the child taken at every reached XOR, in preorder."""
    flat, ranking = told.flat, told.ranking
    head = {
        "status": ranking.status,
        "allocator": told.allocator,
        "accumulate": told.aim.accumulate,
        "diverse": told.aim.diverse,
        "k": told.k,
        "seed": told.seed,
        "time_limit_s": told.time_limit_s,
        "time_s": round(told.elapsed_s, 6),
        "examined": ranking.examined,
        "nodes": len(flat.kind),
        "leaves": len(flat.role) - flat.role.count(-1),
        "robots": _robots(flat),
        "limits": _limits(flat),
        "not_kept": told.not_kept,
        "certificate": to_plain(ranking.certificate),
        "reasons": [to_plain(reason) for reason in ranking.reasons],
    }
    lines = ",\n".join("    " + json.dumps(_plain(alternative)) for alternative in ranking.alternatives)
    listed = f"[\n{lines}\n  ]" if lines else "[]"
    return json.dumps(head, indent=2).removesuffix("\n}") + f',\n  "alternatives": {listed}\n}}\n'


def _plain(alternative: Alternative) -> dict[str, object]:
    return {
        "rank": alternative.rank,
        "utility": alternative.utility,
        "gap": gap_of(alternative),
        "certificate": to_plain(alternative.certificate),
        "uses": [to_plain(use) for use in alternative.uses],
        "chosen": [choice.child for choice in alternative.choices],
    }
