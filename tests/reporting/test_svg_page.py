"""What pictures share: short numbers, names cut in their middle, words that are only words."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.reporting.svg_numbers import n
from missiontree.reporting.svg_page import middle_cut, opening, text
from missiontree.reporting.text_box import text_width
from tests.reporting.charts import SVG, parsed


@pytest.mark.parametrize(
    ("number", "written"), [(12, "12"), (12.04, "12"), (12.06, "12.1"), (-0.04, "0"), (-3.25, "-3.2"), (1e6, "1000000")]
)
def test_numbers_have_at_most_one_decimal(number: float, written: str) -> None:
    assert n(number) == written


def test_a_name_that_fits_stays_and_one_that_does_not_keeps_its_end() -> None:
    """Widths per em: r 0.52, o 0.62, b 0.62, t 0.4, - 0.4, digits 0.62."""
    assert middle_cut("robot-17", 10, 100) == "robot-17"
    cut = middle_cut("transportation_robot-17", 10, 80)
    assert cut.startswith("tran")
    assert cut.endswith("t-17")


@given(st.text(min_size=1, max_size=60), st.floats(30, 300))
def test_a_cut_name_fits(name: str, room: float) -> None:
    cut = middle_cut(name, 10, room)
    assert text_width(cut, 10) <= room
    assert cut == name or "…" in cut


def test_words_and_titles_are_never_markup() -> None:
    svg = "\n".join((opening(10, 20, "<b>", "&\x1b[31m", "p"), text(1, 2, "<i>'\"", size=9, halo="#ffffff"), "</svg>"))
    root = parsed(svg)
    assert root.get("viewBox") == "0 0 10 20"
    assert root.get("aria-labelledby") == "p-title p-desc"
    assert [element.text for element in root if element.tag != f"{SVG}rect"] == ["<b>", "&", "<i>'\""]
