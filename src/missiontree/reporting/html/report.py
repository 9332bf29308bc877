"""Everything about a plan on one page that needs nothing beside it: no network, no server, no second file."""

from __future__ import annotations

from markupsafe import Markup

from missiontree.formats.digest import digest
from missiontree.mission.explanation import Explanation
from missiontree.mission.plan import Plan
from missiontree.mission.tree import MissionTree
from missiontree.reporting.escape import one_line
from missiontree.reporting.front.rows import listed_rank
from missiontree.reporting.html.checked import Checked
from missiontree.reporting.html.data_island import island
from missiontree.reporting.html.facts import headline
from missiontree.reporting.html.inlined import inlined
from missiontree.reporting.html.moving import moving
from missiontree.reporting.html.options import pictures_of_options
from missiontree.reporting.html.page import filled, resource
from missiontree.reporting.html.policy import policy
from missiontree.reporting.html.remarks import remarks
from missiontree.reporting.html.sections import rows_of, sections_of
from missiontree.reporting.html.style import style_of
from missiontree.reporting.html.ways import ways
from missiontree.reporting.references import refuse_damaged
from missiontree.reporting.text import best_scheduled
from missiontree.reporting.tree.view import tree_svg

LONGEST_TITLE = 80
LONGEST_HEADING = 400


def report_html(
    plan: Plan, checked: Checked | None = None, rank: int | None = None, told: Explanation | None = None
) -> str:
    """
    A plan as one HTML file: who does what, when and why, then all that this rests on.

    The file loads nothing, and its own policy forbids it to. It can be read without its script, which adds a clock and remembers the
    chosen alternative. Whatever users and models said stands in it as words. Equal plans give equal bytes.

    Parameters
    ----------
    plan
        A plan of any outcome.
    checked
        What :func:`missiontree.check` said of it. Default: the page says that it was not checked.
    rank
        Rank of the alternative that is shown at first. Default: the best that has a schedule.

    told
        Why it cannot be done, and what would make it possible (:func:`missiontree.explaining.explain.explain`). Default: the page does
        not say what would.

    Raises
    ------
    InputError
        If the plan points at nodes or roles that it does not hold.
    """
    refuse_damaged(plan)
    best = best_scheduled(plan)
    chosen = None if plan.chosen is None else listed_rank(plan, plan.chosen.option.alternative)
    first = rank or chosen or (best.rank if best is not None else 1)
    listed = plan.ranking.alternatives if plan.ranking is not None and plan.grounding is not None else ()
    shown = ways(plan, first) if listed else ()
    alone = (
        inlined(tree_svg(plan.tree), "tree-0") if plan.tree is not None and _grown(plan.tree) and not shown else None
    )
    sections = sections_of(plan, shown, alone, checked, told)
    pictures = [picture for way in shown for picture in way.pictures.all] + ([alone] if alone is not None else [])
    pictures += pictures_of_options(plan)
    style, script = style_of(pictures, [way.rank for way in shown]), resource("report.js")
    mission = one_line(plan.brief.text) or "(no words)"
    return filled(
        "page.html.j2",
        policy=policy(style, script),
        style=Markup(style),  # noqa: S704 - made of our own rules, numbers and colours
        script=Markup(script),  # noqa: S704 - the file as it is
        title=f"{_cut(mission, LONGEST_TITLE)} – mission plan",
        mission=_cut(mission, LONGEST_HEADING),
        whole=mission if len(mission) > LONGEST_HEADING else "",
        headline=headline(plan),
        faults=remarks(checked.faults if checked is not None else ()),
        ways=shown,
        first=first,
        sections=sections.values(),
        rows=rows_of(sections),
        motion=island(moving(plan, [way.rank for way in shown])),
        key=digest(plan.digests)[:16],
        version=plan.provenance.versions.get("missiontree", ""),
    )


def _grown(tree: MissionTree) -> bool:
    """Whether there is more to a tree than its root."""
    return len(tree.nodes) > 1


def _cut(text: str, most: int) -> str:
    return text if len(text) <= most else f"{text[: most - 1]}…"
