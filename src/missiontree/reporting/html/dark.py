"""The pictures' colours on dark paper: same hues, light and dark changed places."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator

from missiontree.reporting.palette import DARK, HUES, PAPER

_PAINTED = re.compile(r'(?:fill|stroke)="(#[0-9a-fA-F]{6})"')
_LEAST_SURFACE = 0.55
_TINT = 0.29
"""Lightness of a robot's tint, so deep that its own colour and muted words can be read on it."""


def dark_rules(pictures: Iterable[str]) -> str:
    """Style that repaints every colour that occurs in the pictures, for a page on dark paper."""
    found = sorted({colour.lower() for svg in pictures for colour in _PAINTED.findall(svg)})
    kept = (f'.picture .mt-on[fill="{colour}"]{{fill:{colour}}}' for colour in _ON_SURFACES)
    return "\n".join((*(rule for colour in found for rule in _rules(colour)), *kept))


def _rules(colour: str) -> Iterator[str]:
    line = on_dark(colour)
    surface, stroke = _SURFACES.get(colour, line), _ROBOTS.get(colour, line)
    yield f'.picture [fill="{colour}"]{{fill:{surface}}}'
    yield f'.picture [stroke="{colour}"]{{stroke:{stroke}}}'
    if line != surface:
        yield f'.picture text[fill="{colour}"],.picture g[fill="{colour}"]>text:not([fill]){{fill:{line}}}'


def on_dark(colour: str) -> str:
    """The counterpart of a colour: paper becomes nearly black, ink nearly white, and what lies between changes places."""
    lightness, a, b = _lab(colour)
    return _hex(_TINT, a, b) if colour in _TINTS else _hex(0.2 + 0.78 * max(0.0, 1 - lightness) ** 0.6, a, b)


def _surface(colour: str) -> str:
    """A robot's colour, never so deep that it sinks into dark paper."""
    lightness, a, b = _lab(colour)
    return _hex(max(lightness, _LEAST_SURFACE), a, b)


def _lab(colour: str) -> tuple[float, float, float]:
    """Lightness (0 to 1) and the two axes of hue of a colour, in the space OKLab (Ottosson 2020)."""
    red, green, blue = (_linear(int(colour[at : at + 2], 16) / 255) for at in (1, 3, 5))
    long = (0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue) ** (1 / 3)
    middle = (0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue) ** (1 / 3)
    short = (0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue) ** (1 / 3)
    return (
        0.2104542553 * long + 0.7936177850 * middle - 0.0040720468 * short,
        1.9779984951 * long - 2.4285922050 * middle + 0.4505937099 * short,
        0.0259040371 * long + 0.7827717662 * middle - 0.8086757660 * short,
    )


def _hex(lightness: float, a: float, b: float) -> str:
    """The colour, paler if there is none so strong."""
    for step in range(20, -1, -1):
        channels = _channels(lightness, a * step / 20, b * step / 20)
        if all(-1e-4 <= channel <= 1 + 1e-4 for channel in channels):
            break
    return "#" + "".join(f"{round(255 * _gamma(min(1.0, max(0.0, channel)))):02x}" for channel in channels)


def _channels(lightness: float, a: float, b: float) -> tuple[float, float, float]:
    long = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3
    middle = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3
    short = (lightness - 0.0894841775 * a - 1.2914855480 * b) ** 3
    return (
        4.0767416621 * long - 3.3077115913 * middle + 0.2309699292 * short,
        -1.2684380046 * long + 2.6097574011 * middle - 0.3413193965 * short,
        -0.0041960863 * long - 0.7034186147 * middle + 1.7076147010 * short,
    )


def _linear(channel: float) -> float:
    return channel / 12.92 if channel <= 0.04045 else math.pow((channel + 0.055) / 1.055, 2.4)


def _gamma(channel: float) -> float:
    return 12.92 * channel if channel <= 0.0031308 else 1.055 * math.pow(channel, 1 / 2.4) - 0.055


_TINTS = frozenset(hue.tint for hue in HUES)
_ROBOTS = {hue.fill: _surface(hue.fill) for hue in HUES}
_SURFACES = _ROBOTS | {DARK: DARK}
_ON_SURFACES = (PAPER, DARK)
