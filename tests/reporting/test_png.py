"""Pictures as PNG files."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.reporting.png import MOST_PIXELS, packaged_fonts, png_of, size_of
from missiontree.reporting.tree.view import tree_svg
from tests.builders import reunite_tree


def svg(width: float, height: float, inside: str = "") -> str:
    return f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}">{inside}</svg>'


def sides(png: bytes) -> tuple[int, int]:
    """Width and height, as the header of a PNG file has them."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = struct.unpack(">II", png[16:24])
    return width, height


def test_a_unit_becomes_two_pixels_or_as_many_as_asked_for() -> None:
    assert sides(png_of(svg(30, 20))) == (60, 40)
    assert sides(png_of(svg(30, 20), zoom=3)) == (90, 60)


def test_the_same_picture_gives_the_same_bytes() -> None:
    picture = tree_svg(reunite_tree())
    assert png_of(picture) == png_of(picture)


def test_words_leave_a_mark() -> None:
    assert png_of(svg(60, 20, '<text x="2" y="15">Mom</text>')) != png_of(svg(60, 20))


def test_a_machine_without_fonts_writes_with_the_one_that_was_installed() -> None:
    (folder,) = packaged_fonts()
    named = '<text x="2" y="15" font-family="Helvetica, sans-serif">Mom</text>'
    assert png_of(svg(60, 20, named), font_dirs=[folder]) != png_of(svg(60, 20))


def test_where_there_is_no_font_that_is_said(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no font") as refused:
        png_of(svg(30, 20), font_dirs=[str(tmp_path)])
    assert "SVG" in refused.value.hint


def test_a_picture_that_is_too_large_is_drawn_smaller() -> None:
    """20,000 by 1,000 units at zoom 2 would be 80 million pixels; 60 million are left, so sqrt(60e6 / 20e6) = 1.73 of each unit."""
    width, height = sides(png_of(svg(20_000, 1_000)))
    assert width * height <= MOST_PIXELS * 1.001
    assert width == pytest.approx(20_000 * 3**0.5, rel=1e-3)


def test_a_picture_beyond_reading_is_refused() -> None:
    with pytest.raises(InputError, match="20,000 by 20,000 units") as refused:
        png_of(svg(20_000, 20_000))
    assert "SVG" in refused.value.hint


@pytest.mark.parametrize("zoom", [0, -1, float("inf"), float("nan")])
def test_a_zoom_that_is_none_is_refused(zoom: float) -> None:
    with pytest.raises(InputError, match="zoom"):
        png_of(svg(30, 20), zoom=zoom)


def test_the_size_is_the_pictures_own() -> None:
    assert size_of(svg(30.5, 20, '<rect width="1" height="2"/>')) == (30.5, 20.0)
    with pytest.raises(InputError, match="does not say its size"):
        size_of('<svg xmlns="http://www.w3.org/2000/svg"><rect width="1" height="2"/></svg>')
