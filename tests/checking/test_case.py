"""What rules share of a plan is worked out once."""

from __future__ import annotations

from missiontree import plan
from missiontree.checking.case import Case


def test_what_several_rules_ask_for_is_worked_out_once_for_each_thing_it_is_about() -> None:
    case, asked = Case(plan("Find the cat")), list[str]()

    def work(about_case: Case, about: str) -> str:
        assert about_case is case
        asked.append(about)
        return about.upper()

    assert [case.once(work, name) for name in ("a", "b", "a", "b")] == ["A", "B", "A", "B"]
    assert asked == ["a", "b"]
