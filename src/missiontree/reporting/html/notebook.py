"""A plan inside somebody else's page, such as a notebook: the first sight of the report, without its style."""

from __future__ import annotations

import hashlib

from missiontree.errors import InputError
from missiontree.mission.plan import Plan
from missiontree.reporting.escape import one_line
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.html.crew import crew
from missiontree.reporting.html.facts import headline
from missiontree.reporting.html.inlined import Picture, inlined
from missiontree.reporting.html.page import filled
from missiontree.reporting.html.remarks import remarks
from missiontree.reporting.references import refuse_damaged
from missiontree.reporting.text import best_scheduled
from missiontree.reporting.tree.view import tree_svg

COLOURS = {"good": "#17724a", "bad": "#b3271b", "open": "#855600"}


def plan_html(plan: Plan) -> str:
    """Outcome, who does what, the chart and the tree, or the reasons why there is no plan. No script, no style sheet."""
    try:
        refuse_damaged(plan)
    except InputError as error:
        return filled("damaged.html.j2", message=str(error))
    best = best_scheduled(plan)
    said = headline(plan)
    alternative = plan.ranking.alternatives[best.rank - 1] if best is not None and plan.ranking is not None else None
    return filled(
        "notebook.html.j2",
        mission=one_line(plan.brief.text) or "(no words)",
        headline=said,
        colour=COLOURS[said.tone],
        reasons=remarks(plan.reasons),
        crew=crew(plan, alternative, best) if alternative is not None else None,
        gantt=_own(gantt_svg(plan, best.rank)) if best is not None else None,
        tree=_own(tree_svg(plan.tree, plan=plan, rank=best.rank if best is not None else None))
        if plan.tree is not None
        else None,
    )


def _own(svg: str) -> Picture:
    """The picture with ids of its own, since other plans may be shown on the same page."""
    return inlined(svg, f"mt-{hashlib.sha256(svg.encode()).hexdigest()[:12]}")
