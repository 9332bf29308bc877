"""The front and the choice as the page shows them."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.as_ranking import as_ranking
from missiontree.mission.plan import Plan
from missiontree.reporting.front.plot import front_svg
from missiontree.reporting.front.rows import Row, choice_in_words, front_in_words, listed_rank, rows_of
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.html.inlined import Picture, inlined
from missiontree.reporting.html.times import lasts
from missiontree.reporting.team.lines import team_lines

FILLING = 1.6


@dataclass(frozen=True, slots=True)
class ShownFront:
    """
    The front.

    Parameters
    ----------
    words
        How many options there are, and what is known of others.
    rows
        The options, each with how long it takes.
    plot
        Its picture.
    """

    words: str
    rows: tuple[tuple[Row, str], ...]
    plot: Picture


@dataclass(frozen=True, slots=True)
class ShownChoice:
    """
    What the objective chooses.

    Parameters
    ----------
    words
        Which it is, by what, and what is known of it.
    detail
        The claim in a sentence.
    team
        Who does what, if its alternative is not among those that can be chosen on the page.
    gantt
        Its schedule, likewise.
    """

    words: str
    detail: str
    team: tuple[str, ...] = ()
    gantt: Picture | None = None


def shown_front(plan: Plan) -> ShownFront | None:
    """The front of a plan; None if there is none."""
    drawn = front_svg(plan)
    if plan.front is None or drawn is None:
        return None
    rows = tuple((row, lasts(row.makespan_s)) for row in rows_of(plan))
    return ShownFront(front_in_words(plan.front), rows, inlined(drawn, "front-plot", FILLING))


def shown_choice(plan: Plan) -> ShownChoice | None:
    """What is chosen in a plan; None if nothing is."""
    if plan.chosen is None or plan.grounding is None:
        return None
    option = plan.chosen.option
    words, detail = choice_in_words(plan, plan.chosen), option.certificate.detail
    if listed_rank(plan, option.alternative) is not None:
        return ShownChoice(words, detail)
    chart = gantt_svg(as_ranking(plan, [option]), option.alternative.rank)
    team = tuple(team_lines(plan.grounding.tree, option.alternative, plan))
    return ShownChoice(words, detail, team, inlined(chart, "gantt-chosen", FILLING))


def pictures_of_options(plan: Plan) -> list[Picture]:
    """All pictures of the front and the choice."""
    front, choice = shown_front(plan), shown_choice(plan)
    found = [front.plot] if front is not None else []
    return found if choice is None or choice.gantt is None else [*found, choice.gantt]
