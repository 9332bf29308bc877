"""What is used of limits, in lines."""

from __future__ import annotations

from missiontree.reporting.limit_lines import limit_lines
from missiontree.reporting.team.limits import LimitUse


def test_a_line_for_each_budget_with_its_holders_in_order() -> None:
    limits = (
        LimitUse("rover-1", "energy_j", 3000, 4000, at_least=False),
        LimitUse("rover-2", "energy_j", 1500.5, 4000, at_least=True),
        LimitUse("stock of the scene", "medkits", 2, 2, at_least=False),
    )
    assert list(limit_lines(limits)) == [
        "energy_j: rover-1 3,000 of 4,000, rover-2 at least 1,500.5 of 4,000",
        "medkits: stock of the scene 2 of 2",
    ]


def test_of_many_the_tightest_are_told_and_the_others_counted() -> None:
    """Nine robots have used 1 to 9 of 10: those with 4 to 9 are told, in order."""
    limits = [LimitUse(f"r-{used}", "energy_j", used, 10, at_least=False) for used in range(1, 10)]
    told = ", ".join(f"r-{used} {used} of 10" for used in range(4, 10))
    assert list(limit_lines(limits)) == [f"energy_j: {told}, and 3 that have used less"]
    many = [LimitUse("r-1", f"b{number}", 1, 10, at_least=False) for number in range(8)]
    assert list(limit_lines(many))[-1] == "… and 2 more; --json lists them all"


def test_nothing_is_said_of_nothing() -> None:
    assert list(limit_lines(())) == []
