"""How cost grows: the fitted exponent, the table and the picture."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest

from benchmarks.allocation import Files
from benchmarks.growth import SERIES, Point, Series, fitted, grown, growth_table
from benchmarks.growth_plot import growth_svg, scale

CUBIC = Series("cubic", "cubic, 3 robots", "leaves", (10, 100, 1_000), 3, True, 10)
ROBOTS = Series("flat", "flat, 100 leaves", "robots", (1, 10, 100), 100, False, 1)


def measured(seconds: tuple[float, float, float], sizes: tuple[int, int, int] = (10, 100, 1_000)) -> list[Point]:
    return [Point(size, one, True) for size, one in zip(sizes, seconds, strict=True)]


def test_a_power_is_found_again() -> None:
    """Seconds = 2e-6 * size ** 3."""
    fit = fitted(CUBIC, measured((2e-3, 2.0, 2e3)))
    assert fit == pytest.approx((3.0, 2e-6))


def test_what_ended_at_the_limit_and_what_is_too_small_does_not_count() -> None:
    points = [Point(1, 50.0, True), *measured((2e-3, 2.0, 2e3)), Point(10_000, 60.0, False)]
    assert fitted(CUBIC, points) == pytest.approx((3.0, 2e-6))
    assert fitted(CUBIC, points[:3]) is None
    assert fitted(CUBIC, [*points, Point(100_000, 0.1, True)]) == pytest.approx(
        (3.0, 2e-6)
    )  # quick again: another kind of problem


def test_every_series_grows_from_one_end_of_the_promise_to_the_other() -> None:
    for series in SERIES:
        first, last = series.sizes[0], series.sizes[-1]
        assert (first, last) == ((10, 1_000_000) if series.over == "leaves" else (1, 1_000))
        assert series.tree(7) == ((7, series.other) if series.over == "leaves" else (series.other, 7))


def test_small_trees_are_measured_for_real(tmp_path: Path) -> None:
    few = Series("few", "few", "leaves", (10, 20, 40), 2, False, 10)
    points = grown(Files(None, tmp_path).file, 30.0, 0, (few,))[few]
    assert [(point.size, point.proven) for point in points] == [(10, True), (20, True), (40, True)]
    assert all(point.seconds > 0 for point in points)


def test_the_table_marks_the_limit() -> None:
    told = growth_table({CUBIC: [*measured((2e-3, 2.0, 2e3)), Point(10_000, 60.0, False)]})
    assert "10: 0.002, 100: 2, 1,000: 2000, 10,000: 60 (limit)" in told
    assert told.endswith("| 3.00 (from 10) |")


def test_a_scale_ends_at_powers_of_ten() -> None:
    one = scale((0.02, 30.0), 0.0, 400.0)
    assert (one.low, one.high) == (-2, 2)
    assert one.at(1.0) == 200.0
    assert scale((1.0,), 0.0, 1.0).high == 1


def test_the_picture_is_sound_and_draws_every_point() -> None:
    """Three points each, one of them hollow, and a filled dot per series in the key."""
    points = {
        CUBIC: [*measured((2e-3, 2.0, 2e3))[:2], Point(1_000, 60.0, False)],
        ROBOTS: measured((0.1, 0.1, 0.1), (1, 10, 100)),
    }
    svg = growth_svg(points)
    root = ElementTree.fromstring(svg)  # noqa: S314 - as above
    circles = [part for part in root.iter() if part.tag.endswith("circle")]
    assert len(circles) == 6 + 2
    assert sum(part.get("fill") == "#ffffff" for part in circles) == 1
    words = " ".join(part.text or "" for part in root.iter() if part.tag.endswith("text"))
    assert "flat, 100 leaves: exponent 0.00" in words or "flat, 100 leaves: exponent -0.00" in words
    assert "cubic, 3 robots: no exponent" in words
    assert "Hollow" in words
    assert "Hollow" not in growth_svg({ROBOTS: points[ROBOTS]})
    width, height = (float(size) for size in (root.get("width") or "", root.get("height") or ""))
    assert all(0 <= float(part.get("cx") or -1) <= width for part in circles)
    assert all(0 <= float(part.get("cy") or -1) <= height for part in circles)
