"""What a plan for a part leaves out, in few words."""

from __future__ import annotations

from dataclasses import replace

from missiontree.mission.partial import LeftOut, Partial
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.left_out import left_out_in_short
from tests.builders import flat_tree, routine_node
from tests.checking.plans import partial


def without(*names: str, weight: float = 1) -> Partial:
    whole = flat_tree(*(routine_node(name, "Search", agent=name) for name in ("a", "b", "c", "d")))
    gone = tuple(LeftOut(name, weight) for name in names)
    return Partial(whole=whole, left_out=gone, total=4, kept=4 - len(gone) * weight, claim="found")


def test_one_or_two_parts_are_named_and_of_more_the_rest_is_counted() -> None:
    label = {node.id: node.label for node in without("a").whole.nodes}
    assert left_out_in_short(without("b")) == f"without {label['b']}"
    assert left_out_in_short(without("b", "d")) == f"without {label['b']} and {label['d']}"
    assert left_out_in_short(without("a", "b", "d")) == "only 1 of 4 routines"
    assert left_out_in_short(without("a", "b", "d", weight=0.5)) == "only 2.5 of 4 by weight"


def test_a_chart_of_a_part_says_so() -> None:
    plan = partial()
    assert plan.partial is not None
    told = left_out_in_short(plan.partial)
    assert f" · {told} · utility" in gantt_svg(plan, plan.schedules[0].rank)
    assert told not in gantt_svg(replace(plan, partial=None, outcome="delivered", reasons=()), plan.schedules[0].rank)
