"""Summaries and tables for the terminal: the same in colour, without colour, and as a plain string."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from io import StringIO

from rich.console import Console, Group, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from missiontree.mission.aim import Aim
from missiontree.mission.alternative import Alternative, Ranking
from missiontree.mission.as_ranking import as_ranking
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Outcome, Plan
from missiontree.mission.reason import Reason, Severity
from missiontree.mission.schedule import Schedule
from missiontree.reporting.critical.view import BRIEF, title_and_view
from missiontree.reporting.escape import one_line
from missiontree.reporting.front.rows import choice_in_words, front_in_words, listed_rank
from missiontree.reporting.front.view import front_table
from missiontree.reporting.known import FURTHER, by_word, known_of, may_look_further
from missiontree.reporting.left_out import known_of_larger, parts_left_out
from missiontree.reporting.limit_lines import limit_lines
from missiontree.reporting.references import refuse_dangling
from missiontree.reporting.spent_view import author_in_words
from missiontree.reporting.team.limits import limits_of
from missiontree.reporting.team.lines import team_lines
from missiontree.reporting.timeline.view import timeline
from missiontree.reporting.tree.view import tree_text

HEADLINES: dict[Outcome, tuple[str, str]] = {
    "delivered": ("Plan", "bold green"),
    "partial": ("Cannot be done as a whole; this is a plan for a part of it", "bold yellow"),
    "cannot_be_done": ("Cannot be done", "bold red"),
    "incomplete": ("Incomplete: not every part of the mission is understood or built", "bold yellow"),
    "exhausted": ("Nothing was found with the time and effort given; nothing is excluded", "bold yellow"),
    "provider_failed": ("The language model could not be used", "bold red"),
}
MARKS: dict[Severity, tuple[str, str]] = {
    "error": ("✗", "red"),
    "warning": ("!", "yellow"),
    "notice": ("+", "cyan"),
    "assumption": ("?", "magenta"),
}
MAX_LINES = 12


def words(text: str, style: str = "") -> Text:
    """Text of a user's on one line, harmless: never markup, never terminal control."""
    return Text(one_line(text), style=style)


def plan_text(plan: Plan, width: int = 100) -> str:
    """The plan as plain text, without colour."""
    return render(plan_view(plan), width)


def render(view: RenderableType, width: int = 100) -> str:
    """A view as plain text, without colour or trailing blanks."""
    page = StringIO()
    Console(file=page, width=width, color_system=None, force_terminal=False, highlight=False).print(view)
    return "\n".join(line.rstrip() for line in page.getvalue().splitlines()) + "\n"


def plan_view(plan: Plan) -> Group:
    """
    Everything a person wants to see first: outcome, tree, alternatives, the best one's timeline, remarks.

    Raises
    ------
    InputError
        If the plan points at nodes or roles that it does not hold.
    """
    refuse_dangling(plan)
    return Group(*_sections(plan))


def _sections(plan: Plan) -> Iterator[RenderableType]:
    headline, style = HEADLINES[plan.outcome]
    yield Text.assemble((headline, style), ": ", words(plan.brief.text.strip() or "(no words)", "bold"))
    if (spent := plan.provenance.spent) is not None:
        yield words(author_in_words(plan.provenance.author, plan.provenance.model, spent), "dim")
    yield from _titled("How the words were read", [words(line) for line in plan.provenance.reading])
    if plan.partial is not None:
        left_out = [reason_line(reason) for reason in parts_left_out(plan.partial)]
        yield from _titled("Left out", [*left_out, words(known_of_larger(plan.partial))])
    yield from _titled("Why", _refusals(said_once(plan.reasons), plan))
    if plan.tree is not None and len(plan.tree.nodes) > 1:
        yield from _titled("Mission tree", [Text(tree_text(plan.tree).rstrip())])
    if plan.ranking is not None and plan.grounding is not None and plan.ranking.alternatives:
        yield from _titled(_ranking_title(plan.ranking, plan.brief.aim), [alternatives_table(plan)])
        yield from _titled("Without a schedule", list(_unscheduled(plan)))
        yield from _front(plan)
        yield from _choice(plan) if plan.chosen is not None else _best(plan)
    not_offered = plan.grounding.not_offered if plan.grounding else ()
    told = frozenset(plan.reasons)
    yield from _titled("Not offered", _refusals([reason for reason in not_offered if reason not in told], plan))
    yield from _remarks("Look at", plan.findings)
    yield from _remarks("Done on your behalf", plan.notices)
    yield from _remarks("Assumed", plan.assumptions)


def _best(plan: Plan) -> Iterator[RenderableType]:
    """The best alternative that has a schedule: its limits and its schedule."""
    best = best_scheduled(plan)
    yield from _titled(*_limits_of(plan, best))
    if best is not None:
        yield from _schedule(plan, best, f"alternative {best.rank}")


def _schedule(plan: Plan, schedule: Schedule, whose: str) -> Iterator[RenderableType]:
    assert plan.grounding is not None
    deadline_s = plan.grounding.tree.nodes[0].deadline_s
    due = "" if deadline_s is None else f" (due by {deadline_s:g} s)"
    title = f"Schedule of {whose}: {_length(schedule.makespan_s)}{due}, {known_of(schedule)}"
    further = [words(FURTHER, "dim")] if may_look_further(schedule, plan.provenance.scheduler) else []
    yield from _titled(title, [timeline(schedule, plan), *further])
    yield from _titled(*title_and_view(plan, schedule, whose, BRIEF))


def _front(plan: Plan) -> Iterator[RenderableType]:
    """Plans from the best staffed to the fastest."""
    if plan.front is not None:
        yield from _titled(f"From the best staffed to the fastest: {front_in_words(plan.front)}", [front_table(plan)])


def _choice(plan: Plan) -> Iterator[RenderableType]:
    """What the objective chooses, and its schedule."""
    assert plan.chosen is not None
    assert plan.grounding is not None
    option = plan.chosen.option
    alone = as_ranking(plan, [option])
    rank = listed_rank(plan, option.alternative)
    team = team_lines(plan.grounding.tree, option.alternative, plan) if rank is None else ()
    lines = [words(line) for line in (*team, option.certificate.detail) if line]
    yield from _titled(f"Chosen by {choice_in_words(plan, plan.chosen)}", lines)
    limits = limits_of(alone, option.alternative, option.schedule)
    yield from _titled("What the choice uses of its limits", [words(line) for line in limit_lines(limits)])
    yield from _schedule(alone, option.schedule, "the choice")


def _limits_of(plan: Plan, schedule: Schedule | None) -> tuple[str, list[RenderableType]]:
    """What the scheduled alternative, or else the first, uses of limits."""
    assert plan.ranking is not None
    rank = schedule.rank if schedule is not None else 1
    limits = limits_of(plan, plan.ranking.alternatives[rank - 1], schedule)
    return f"What alternative {rank} uses of its limits", [words(line) for line in limit_lines(limits)]


def _titled(title: str, body: Sequence[RenderableType]) -> Iterator[RenderableType]:
    if body:
        yield Text("")
        yield Text(title, style="bold")
        yield Padding(Group(*body), (0, 0, 0, 2), expand=False)


def _remarks(title: str, reasons: Sequence[Reason]) -> Iterator[RenderableType]:
    lines = [reason_line(reason) for reason in reasons[:MAX_LINES]]
    if len(reasons) > MAX_LINES:
        lines.append(Text(f"… and {len(reasons) - MAX_LINES} more; --json lists them all", style="dim"))
    yield from _titled(title, lines)


def _refusals(reasons: Sequence[Reason], plan: Plan) -> list[RenderableType]:
    """Refusals that need a thought one by one, then plain lack of a capability, a line per routine and capability; none twice."""
    told: list[Text] = []
    lacking: dict[tuple[str, str], list[str]] = {}
    for reason in reasons:
        if reason.rule == "capability_missing" and reason.node and reason.robot:
            lacking.setdefault((reason.node, reason.needed), []).append(reason.robot)
        else:
            told.append(reason_line(reason))
    whole = plan.partial.whole if plan.partial is not None else plan.tree
    nodes = whole.by_id if whole else {}
    types = plan.brief.fleet.by_id
    for (node, needed), robots in lacking.items():
        who = ", ".join(types[robot].label if robot in types else robot for robot in dict.fromkeys(robots))
        task = nodes[node].label if node in nodes else node
        told.append(Text.assemble(("✗", "red"), " ", words(f"{task}: no {needed} in {who}", "dim")))
    lines: list[RenderableType] = [*{line.plain: line for line in told}.values()]
    if len(lines) > MAX_LINES:
        lines = [*lines[:MAX_LINES], Text(f"… and {len(lines) - MAX_LINES} more; --json lists them all", style="dim")]
    return lines


def said_once(reasons: Sequence[Reason]) -> list[Reason]:
    """The reasons; the first, which may sum up the others, without what stands below it as a reason of its own."""
    if not reasons:
        return []
    first, *others = reasons
    message = first.message
    for other in others:
        if other.message and len(other.message) < len(message):
            message = message.replace(other.message, " ")
    return [replace(first, message=" ".join(message.split()) or first.message), *others]


def reason_line(reason: Reason) -> Text:
    """A reason as one line: mark, sentence, what to do."""
    mark, style = MARKS[reason.severity]
    line = Text.assemble((mark, style), " ", words(reason.message))
    if reason.hint:
        line.append(" ").append_text(words(_sentence(reason.hint), "dim"))
    return line


def _sentence(text: str) -> str:
    """The text with a capital at its beginning, unless a name stands there, and a full stop at its end."""
    first = text.split(maxsplit=1)[0] if text.split() else ""
    start = text[:1].upper() if first.isalpha() else text[:1]
    return start + text[1:] + ("" if text.endswith((".", "?", "!", ":", ")", "…")) else ".")


def seconds(time_s: float) -> str:
    """A time for people: ``95.5 s``, ``1:02:03`` from ten minutes on."""
    if time_s < 600:
        return f"{time_s:.1f} s"
    whole = round(time_s)
    return f"{whole // 3600}:{whole // 60 % 60:02d}:{whole % 60:02d}"


def _length(time_s: float) -> str:
    """A time as :func:`seconds` writes it, and in seconds as well, since lists of actions count in seconds."""
    return seconds(time_s) if time_s < 600 else f"{seconds(time_s)} ({time_s:.1f} s)"


def best_scheduled(plan: Plan) -> Schedule | None:
    """The first schedule in rank order that has actions."""
    return next((schedule for schedule in plan.schedules if schedule.status in {"optimal", "feasible"}), None)


def _unscheduled(plan: Plan) -> Iterator[RenderableType]:
    """Alternatives that no schedule was found for, with the first reason of each."""
    for schedule in plan.schedules:
        if schedule.status in {"infeasible", "unknown"} and schedule.reasons:
            proof = schedule.certificate.method.replace("_", " ")
            none = "no schedule was found"
            why = f"cannot be scheduled, proven by {proof}" if schedule.status == "infeasible" else none
            yield Text(f"{schedule.rank}. {why}: ").append_text(reason_line(schedule.reasons[0]))


def _ranking_title(ranking: Ranking, aim: Aim) -> str:
    count = len(ranking.alternatives)
    known = {
        "exact": "every rank proven",
        "partial": "not all ranks proven",
        "infeasible": "none exists",
        "unknown": "none found",
    }[ranking.status]
    limit = ranking.certificate.limit
    ended = "" if limit is None else f", ended by {limit.in_words}"
    teams = " of different teams" if aim.diverse else ""
    return f"{count} alternative{'s' if count != 1 else ''}{teams}, best first ({known}{ended})"


def alternatives_table(plan: Plan) -> Table:
    """Rank, utility, team, makespan and what is known, a row per alternative."""
    assert plan.ranking is not None
    assert plan.grounding is not None
    table = Table(box=None, padding=(0, 2, 0, 0), header_style="dim")
    for name, justify in (
        ("#", "right"),
        (plan.brief.aim.worth, "right"),
        ("team", "left"),
        ("makespan", "right"),
        ("known", "left"),
    ):
        table.add_column(name, justify="right" if justify == "right" else "left", no_wrap=name != "team")
    schedules = {schedule.rank: schedule for schedule in plan.schedules}
    best = plan.ranking.alternatives[0] if plan.ranking.alternatives else None
    for alternative in plan.ranking.alternatives:
        schedule = schedules.get(alternative.rank)
        table.add_row(
            str(alternative.rank),
            f"{alternative.utility:g}",
            Text("\n").join(words(line) for line in team_lines(plan.grounding.tree, alternative, plan, best)),
            seconds(schedule.makespan_s) if schedule and schedule.actions else "-",
            _verdict(alternative, schedule),
        )
    return table


def _verdict(alternative: Alternative, schedule: Schedule | None) -> str:
    rank = "rank proven" if alternative.certificate.claim == "proven" else "rank unproven"
    if schedule is None:
        return rank
    return {
        "optimal": f"{rank}\nshortest, proven",
        "feasible": f"{rank}\n{'shortest by solver' if by_word(schedule) else 'feasible'}",
        "infeasible": f"{rank}\ncannot be scheduled",
        "unknown": f"{rank}\nno schedule found",
    }[schedule.status]


def orders_view(tree: GroundedTree, orders: Mapping[str, Sequence[int]]) -> Group:
    """Each robot with its actions in order, a line per action."""
    lines: list[Text] = []
    for robot, leaves in orders.items():
        lines.append(words(robot, "cyan"))
        lines += [words(f"{number:>4}. {tree.action(leaf).text}") for number, leaf in enumerate(leaves, start=1)]
    return Group(*lines)


def findings_view(findings: Iterable[Reason]) -> Group:
    """What the checker found, a line each."""
    return Group(*(reason_line(reason) for reason in findings))
