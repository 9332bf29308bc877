"""Colours: words on them can be read, and hues are told apart, also by those who see fewer of them."""

import itertools
import math
from xml.etree import ElementTree

import pytest

from missiontree.mission.fleet import Fleet, RobotType
from missiontree.reporting.palette import (
    BLUE,
    DARK,
    HATCHES,
    HUES,
    INK,
    MUTED,
    PAPER,
    RED,
    VIOLET,
    Hue,
    hatch_lines,
    liveries,
    livery,
)

SIGHTS = {  # Machado, Oliveira and Fernandes (2009), severity 1, in linear RGB
    "all": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "no red": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "no green": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    "no blue": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
}


def linear(colour: str) -> list[float]:
    parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    return [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]


def contrast(first: str, second: str) -> float:
    """WCAG 2: (L1 + 0.05) / (L2 + 0.05)."""
    light = sorted(
        sum(a * b for a, b in zip((0.2126, 0.7152, 0.0722), linear(one), strict=True)) for one in (first, second)
    )
    return (light[1] + 0.05) / (light[0] + 0.05)


def lab(colour: str, sight: str) -> tuple[float, float, float]:
    """CIE L*a*b* of what somebody of that sight sees."""
    seen = [min(1.0, max(0.0, sum(a * b for a, b in zip(row, linear(colour), strict=True)))) for row in SIGHTS[sight]]
    xyz = [
        sum(a * b for a, b in zip(row, seen, strict=True)) / white
        for row, white in zip(
            ((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505)),
            (0.95047, 1, 1.08883),
            strict=True,
        )
    ]
    x, y, z = (part ** (1 / 3) if part > 0.008856 else 7.787 * part + 16 / 116 for part in xyz)
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def test_the_measure_of_contrast_is_the_known_one() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.01)  # a pair often cited


@pytest.mark.parametrize("hue", HUES, ids=lambda hue: hue.name)
def test_words_can_be_read_on_every_strength_of_a_hue(hue: Hue) -> None:
    assert contrast(hue.on, hue.fill) >= 4.5
    assert contrast(hue.deep, PAPER) >= 4.5
    assert contrast(hue.deep, hue.tint) >= 4.5
    assert contrast(INK, hue.tint) >= 7
    assert hue.on in {PAPER, DARK}


@pytest.mark.parametrize("colour", [INK, MUTED, RED, BLUE, VIOLET])
def test_the_common_colours_can_be_read_on_paper(colour: str) -> None:
    assert contrast(colour, PAPER) >= 4.5


@pytest.mark.parametrize("sight", SIGHTS)
def test_no_two_hues_look_alike_to_anybody(sight: str) -> None:
    """A difference of 2.3 is just noticed; six times as much is told apart at a glance, also in small bars."""
    for first, second in itertools.combinations(HUES, 2):
        assert math.dist(lab(first.fill, sight), lab(second.fill, sight)) > 6 * 2.3, (first.name, second.name)


def test_fifty_robots_look_different_and_each_the_same_in_every_picture() -> None:
    fleet = Fleet((RobotType(id="a", count=30), RobotType(id="b", count=30)))
    looks = liveries(fleet)
    assert list(looks) == [*(f"a-{n}" for n in range(1, 31)), *(f"b-{n}" for n in range(1, 31))]
    assert len(set(list(looks.values())[:50])) == 50
    assert looks["b-21"] == looks["a-1"] == livery(50)
    assert liveries(fleet) == looks


def test_the_first_ten_are_plain_and_the_eleventh_is_hatched() -> None:
    assert [livery(place).hatch for place in (0, 9, 10, 49)] == ["", "", HATCHES[1], HATCHES[4]]
    assert livery(3).paint("p") == HUES[3].fill
    assert livery(13).paint("p") == "url(#p-hue-3-rising)"


def test_hatches_stand_once_each_under_the_name_that_surfaces_ask_for() -> None:
    shown = [livery(13), livery(2), livery(13), livery(27)]
    patterns = [ElementTree.fromstring(line) for line in hatch_lines(shown, "p")]  # noqa: S314 - it is our own
    assert [f"url(#{pattern.get('id')})" for pattern in patterns] == [livery(13).paint("p"), livery(27).paint("p")]
    assert [pattern.find("rect").get("fill") for pattern in patterns] == [HUES[3].fill, HUES[7].fill]  # type: ignore[union-attr]
