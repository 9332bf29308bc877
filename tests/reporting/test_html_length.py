"""The report tells why a schedule takes so long, in the parts of its critical chain."""

from itertools import pairwise

from missiontree.mission.fleet import Fleet
from missiontree.reporting.html.length import MOST_PARTS, length
from missiontree.reporting.html.report import report_html
from tests.reporting.charts import planned
from tests.scheduling.instances import Part, mission, robots, work


def test_the_parts_stand_in_the_report() -> None:
    """3 s of A, then 4 s of B by another robot."""
    instance = mission([Part("A", "a", [work(3)]), Part("B", "b", [work(4)])], [("A", "B")])
    plan = planned(instance, Fleet((robots("a"), robots("b"))))
    found = length(plan, plan.schedules[0])
    assert found is not None
    assert found.title == "Why alternative 1 takes 7 s: 7 s of work, one after the other"
    assert found.parts == (("0.0 – 3.0 s", "a-1", "A", ""), ("3.0 – 7.0 s", "b-1", "B", "; after a-1: A.0"))
    page = report_html(plan)
    assert f"<h3>{found.title}</h3>" in page
    assert '<td dir="auto">B; after a-1: A.0</td>' in page


def test_of_a_long_chain_both_ends_are_told() -> None:
    names = [f"P{number}" for number in range(30)]
    plan = planned(
        mission([Part(name, "a", [work(1)]) for name in names], list(pairwise(names))), Fleet((robots("a"),))
    )
    found = length(plan, plan.schedules[0])
    assert found is not None
    assert (len(found.parts), found.more) == (MOST_PARTS, 30 - MOST_PARTS)
    assert f"and {30 - MOST_PARTS} more parts between them" in report_html(plan)


def test_where_nothing_takes_time_nothing_is_told() -> None:
    plan = planned(mission([Part("A", "a", [work(0)])]), Fleet((robots("a"),)))
    assert length(plan, plan.schedules[0]) is None
