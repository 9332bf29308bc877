"""
Colours that all pictures share, and a livery for every robot.

Hues are told apart under normal, red-blind, green-blind and blue-blind sight (tests measure it); even so, no picture says
anything by colour alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from missiontree.mission.fleet import Fleet

INK = "#333333"
RED = "#c0392b"
BLUE = "#1f5fbf"
VIOLET = "#7d3c98"
PAPER = "#ffffff"
QUIET = "#8a8f98"
"""Lines and signs that stand back; too pale for words."""
HAIR = "#d8dbe0"
MUTED = "#5f6670"
"""Words that stand back: 5.8 to 1 on paper."""


@dataclass(frozen=True, slots=True)
class Hue:
    """
    A colour in the strengths that pictures need.

    Parameters
    ----------
    name
        What people call it.
    fill
        For surfaces.
    on
        For words on ``fill``: at least 4.5 to 1.
    deep
        For words and thin lines on paper and on ``tint``: at least 4.5 to 1.
    tint
        For soft bands; ``INK`` reads on it.
    """

    name: str
    fill: str
    on: str
    deep: str
    tint: str


DARK = "#111111"
HUES = (
    Hue("blue", "#0072b2", PAPER, "#006ba7", "#d6e8f3"),
    Hue("orange", "#e69f00", DARK, "#906200", "#fbf0d6"),
    Hue("green", "#009e73", DARK, "#007656", "#d6efe9"),
    Hue("pink", "#cc79a7", DARK, "#95577a", "#f7eaf1"),
    Hue("vermilion", "#d55e00", DARK, "#ac4a00", "#f8e5d6"),
    Hue("sky", "#56b4e9", DARK, "#347194", "#e4f3fb"),
    Hue("indigo", "#332288", PAPER, "#332288", "#dedcec"),
    Hue("lime", "#b8de6f", DARK, "#5d7236", "#f4fae8"),
    Hue("wine", "#882255", PAPER, "#882255", "#ecdce4"),
    Hue("brown", "#6b4420", PAPER, "#6b4420", "#e7e1db"),
)
HATCHES = ("", "rising", "falling", "upright", "dotted")
"""Patterns over a hue, from the eleventh robot on; none for the first ten."""

_STROKES = {
    "rising": '<path d="M-2 2 L2 -2 M0 8 L8 0 M6 10 L10 6" stroke-width="1.6" fill="none"',
    "falling": '<path d="M-2 6 L2 10 M0 0 L8 8 M6 -2 L10 2" stroke-width="1.6" fill="none"',
    "upright": '<path d="M4 0 L4 8" stroke-width="1.8" fill="none"',
    "dotted": '<path d="M2 2 L2 2.1 M6 6 L6 6.1" stroke-width="2.6" stroke-linecap="round" fill="none"',
}


@dataclass(frozen=True, slots=True)
class Livery:
    """
    How a robot's surfaces look.

    Parameters
    ----------
    number
        Index of the hue in ``HUES``; the class of its elements is ``mt-hue-<number>``.
    hatch
        One of ``HATCHES``.
    """

    number: int
    hatch: str = ""

    @property
    def hue(self) -> Hue:
        """The colour."""
        return HUES[self.number]

    def paint(self, prefix: str) -> str:
        """Value of ``fill`` for a surface; if there is a hatch, :func:`hatch_lines` of the same prefix must stand in the picture."""
        return f"url(#{self._id(prefix)})" if self.hatch else self.hue.fill

    def _id(self, prefix: str) -> str:
        return f"{prefix}-hue-{self.number}-{self.hatch}"


def livery(place: int) -> Livery:
    """The livery of the robot at a place of the fleet, from 0; after fifty they repeat."""
    return Livery(place % len(HUES), HATCHES[place // len(HUES) % len(HATCHES)])


def liveries(fleet: Fleet) -> dict[str, Livery]:
    """The livery of every robot, by its id, in the order of the fleet. The same robot looks the same in every picture of a plan."""
    return {robot: livery(place) for place, robot in enumerate(fleet.robots)}


def hatch_lines(shown: Iterable[Livery], prefix: str) -> Iterator[str]:
    """
    Patterns for the ``<defs>`` of a picture, one for each hatched livery among those shown, in order.

    Parameters
    ----------
    shown
        Liveries in use, repeated or not.
    prefix
        Start of the patterns' ids. Pictures on one page need different ones: a pattern in a hidden picture is not painted with.
    """
    for one in dict.fromkeys(shown):
        if one.hatch:
            yield (
                f'<pattern id="{one._id(prefix)}" width="8" height="8" patternUnits="userSpaceOnUse">'
                f'<rect class="mt-hue-{one.number} mt-fill" width="8" height="8" fill="{one.hue.fill}"/>'
                f'{_STROKES[one.hatch]} stroke="{PAPER}" stroke-opacity="0.45"/></pattern>'
            )
