"""Pictures on the page: each with names of its own, each readable on dark paper."""

from __future__ import annotations

import re

import pytest

from missiontree.reporting.html.dark import dark_rules, on_dark
from missiontree.reporting.html.inlined import inlined, size_rules
from missiontree.reporting.palette import BLUE, HAIR, HUES, INK, MUTED, PAPER, QUIET, RED, VIOLET
from tests.reporting.html_page import parsed, report_of

DRAWN = (
    '<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg" width="160" height="80" aria-labelledby="t d">'
    '<title id="t">a</title><desc id="d">b</desc><defs><marker id="head"/></defs>'
    '<path marker-end="url(#head)"/><use href="#head"/><text>id=&quot;x&quot; url(#head) fill="</text></svg>'
).replace('fill="<', "fill=&quot;<")


def test_ids_are_told_apart_and_so_is_what_points_at_them() -> None:
    svg = inlined(DRAWN, "k").svg
    assert svg.startswith("<svg ")
    assert 'aria-labelledby="k-t k-d"' in svg
    assert '<title id="k-t">' in svg
    assert 'marker-end="url(#k-head)"' in svg
    assert '<use href="#k-head"/>' in svg


def test_words_that_look_like_names_stay_as_they_are() -> None:
    assert "<text>id=&quot;x&quot; url(#head) fill=&quot;</text>" in inlined(DRAWN, "k").svg


def test_colours_are_not_taken_for_names() -> None:
    svg = '<svg xmlns="http://www.w3.org/2000/svg" width="1" height="1"><rect fill="#ffffff" stroke="#333333"/></svg>'
    assert '<rect fill="#ffffff" stroke="#333333"/>' in inlined(svg, "k").svg


def test_a_picture_may_shrink_and_grow_within_bounds() -> None:
    """160 units are 10 rem at full size: from 7.2 to 16 rem wide; and no higher than the window, unless it is so at full size."""
    rules = size_rules(inlined(DRAWN, "k", 1.6))
    assert "#k>svg{min-width:7.2rem;max-width:16.0rem;max-height:max(94vh,5.0rem)}" in rules


@pytest.mark.parametrize("colour", [INK, RED, BLUE, VIOLET, MUTED, *(hue.deep for hue in HUES)])
def test_words_read_on_dark_paper(colour: str) -> None:
    assert contrast(on_dark(colour), on_dark(PAPER)) >= 4.5


@pytest.mark.parametrize("colour", [QUIET, *(hue.deep for hue in HUES)])
def test_lines_and_signs_are_seen_on_dark_paper(colour: str) -> None:
    assert contrast(on_dark(colour), on_dark(PAPER)) >= 3


def test_words_read_on_soft_bands_on_dark_paper() -> None:
    for hue in HUES:
        assert contrast(on_dark(INK), on_dark(hue.tint)) >= 4.5
        assert contrast(on_dark(hue.deep), on_dark(hue.tint)) >= 4.5
        assert contrast(on_dark(MUTED), on_dark(hue.tint)) >= 4.5
        assert contrast(on_dark(hue.tint), on_dark(PAPER)) >= 1.2


def test_surfaces_of_robots_keep_their_words_and_stand_out_from_dark_paper() -> None:
    for hue in HUES:
        (fill,) = re.findall(rf'\[fill="{hue.fill}"\]{{fill:(#......)}}', dark_rules([f'<rect fill="{hue.fill}"/>']))[
            :1
        ]
        assert contrast(hue.on, fill) >= 4
        assert contrast(fill, on_dark(PAPER)) >= 3


def test_hairlines_stay_quiet() -> None:
    assert 1.3 <= contrast(on_dark(HAIR), on_dark(PAPER)) <= 3


@pytest.mark.parametrize("sample", ["reunite", "site", "restaurants"])
def test_every_colour_of_every_picture_has_a_counterpart(sample: str) -> None:
    page = parsed(report_of(sample))
    style = page.find("style")[0].raw
    for element in (inner for box in page.by_class("picture") for svg in box.find("svg") for inner in svg.all()):
        for name in ("fill", "stroke"):
            value = element.attributes.get(name, "none")
            assert value == "none" or value.startswith("url(#") or f'[{name}="{value}"]{{{name}:' in style


def contrast(one: str, other: str) -> float:
    """Contrast by WCAG 2: (L1 + 0.05) / (L2 + 0.05)."""
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


def luminance(colour: str) -> float:
    channels = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
