"""Why a schedule is as long as it is, for the terminal: the parts of its critical chain, which follow each other without a gap."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from missiontree.mission.chain import CriticalChain, WhySoLong
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.called import called
from missiontree.reporting.critical.additions import addition_lines
from missiontree.reporting.critical.chain import chain_of
from missiontree.reporting.critical.parts import Part, parts_of
from missiontree.reporting.gantt.time import in_words, span

BRIEF = 8
"""Parts that are told of a chain beside other things; of a longer one, those at both ends."""
ALL_BY = "missiontree show --why-so-long"


def title_of(chain: CriticalChain, what: str) -> str:
    """
    What the time goes into: ``Why alternative 1 takes 325 s: 257.8 s of work and 67.2 s on the way, one after the other``.

    Parameters
    ----------
    chain
        The chain.
    what
        What takes the time, such as ``alternative 1``.
    """
    idle = "of refilling and waiting" if any(step.kind == "refill" for step in chain.steps) else "of waiting"
    spent = [
        f"{in_words(time_s)} {words}"
        for time_s, words in ((chain.work_s, "of work"), (chain.travel_s, "on the way"), (chain.waiting_s, idle))
        if time_s
    ]
    listed = " and ".join([", ".join(spent[:-1]), spent[-1]]) if len(spent) > 1 else "".join(spent)
    follow = ", one after the other" if len(chain.steps) > 1 else ""
    return f"Why {what} takes {in_words(chain.makespan_s)}: {listed}{follow}"


def chain_view(plan: Plan, schedule: Schedule, most: int | None = None, all_by: str = ALL_BY) -> Group:
    """
    The parts of the chain, a line each.

    Parameters
    ----------
    plan, schedule
        A schedule of the plan that has actions.
    most
        Parts that are told at most; of a longer chain those at both ends are. Default: all.
    all_by
        What tells all of them. Default: the command that shows plans.
    """
    parts = parts_of(plan, schedule)
    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_column(no_wrap=True, justify="right")
    table.add_column(no_wrap=True)
    table.add_column()
    for part in both_ends(parts, most):
        if part is None:
            table.add_row("", "", Text(f"… {len(parts) - (most or 0)} more; {all_by} tells all of them", style="dim"))
        else:
            table.add_row(
                Text(span(part.start_s, part.end_s, schedule.makespan_s)), Text(part.robot, style="cyan"), _what(part)
            )
    return Group(table)


def title_and_view(plan: Plan, schedule: Schedule, what: str, most: int | None = None) -> tuple[str, list[Group]]:
    """Title and parts of the chain of what is called so; no parts if nothing takes time."""
    chain = chain_of(plan, schedule)
    return title_of(chain, what), [chain_view(plan, schedule, most)] if chain.steps else []


def why_view(why: WhySoLong, plan: Plan, schedule: Schedule, what: str | None = None) -> Group:
    """
    The whole answer: what the time goes into, the parts of the chain, and what more robots would bring.

    Parameters
    ----------
    why
        The answer.
    plan, schedule
        What it is about.
    what
        What the schedule is called. Default: as the plan calls its alternative.
    """
    title = title_of(why.chain, called(plan, schedule.rank) if what is None else what)
    lines: list[RenderableType] = [Text(title, style="bold")]
    lines.append(Padding(chain_view(plan, schedule), (0, 0, 0, 2), expand=False))
    told = list(addition_lines(why, schedule, plan.brief.fleet))
    if told:
        by = plan.provenance.scheduler
        lines += [Text(""), Text(f"What more would bring (scheduled anew{f' by {by}' if by else ''})", style="bold")]
        lines += [Padding(Text(one), (0, 0, 0, 2), expand=False) for one in told]
    return Group(*lines)


def both_ends(parts: Sequence[Part], most: int | None) -> Iterator[Part | None]:
    """The parts to be told, None where some are left out."""
    if most is None or len(parts) <= most + 1:
        yield from parts
        return
    yield from parts[: most // 2]
    yield None
    yield from parts[len(parts) - (most - most // 2) :]


def _what(part: Part) -> Text:
    return Text(part.what, style="dim" if part.waits else "").append(more_of(part), style="dim")


def more_of(part: Part) -> str:
    """What is added to what a part is: how much of it is on the way, and what it waits for."""
    travel = ""
    if part.travel_s:
        whole = part.travel_s >= part.end_s - part.start_s - 5e-4
        travel = ", all of it on the way" if whole else f", {in_words(part.travel_s)} of it on the way"
    return travel + (f"; {part.after}" if part.after else "")
