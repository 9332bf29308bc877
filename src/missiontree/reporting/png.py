"""A picture as a PNG file, drawn by a library: the same picture, the same fonts, the same bytes."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path

from missiontree.errors import InputError

MOST_PIXELS = 60_000_000
LEAST_ZOOM = 0.5
PACKAGED = "Source Sans Pro"
_PROBE = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20"><text x="2" y="15" font-size="13" '
    'font-family="Helvetica, Arial, &quot;DejaVu Sans&quot;, sans-serif">{}</text></svg>'
)


def png_of(svg: str, zoom: float = 2.0, font_dirs: Sequence[str] | None = None) -> bytes:
    """
    Draw a picture of ours as PNG.

    Parameters
    ----------
    svg
        The picture, with its width and height.
    zoom
        Pixels per unit of the picture, above 0; default 2, sharp on a dense screen. A picture that would have more than 60 million
        pixels is drawn at what is left of the zoom, down to a half.
    font_dirs
        Folders with fonts, for the same bytes on every machine. Default: the fonts of the machine, and where it has none, the one that is
        installed with this package.

    Raises
    ------
    InputError
        If there is no font to write with, or the picture is too large.
    """
    if not 0 < zoom < math.inf:
        raise InputError(f"zoom {zoom:g}", accepted="a number above 0")
    fonts = _fonts_of_the_machine() if font_dirs is None else tuple(font_dirs)
    if not _can_write(fonts):
        raise InputError(
            "there is no font to write the words of a PNG picture with",
            accepted="a sans-serif font, such as DejaVu Sans (Debian: apt-get install fonts-dejavu-core)",
            hint="Install one, or write an SVG file: it is shown with the fonts of whoever opens it.",
        )
    return _drawn(svg, _fitting(svg, zoom), fonts)


def _fitting(svg: str, zoom: float) -> float:
    """The zoom, or as much of it as the pixels allow."""
    width, height = size_of(svg)
    fits = math.sqrt(MOST_PIXELS / (width * height))
    if fits >= zoom:
        return zoom
    if fits < LEAST_ZOOM:
        raise InputError(
            f"the picture is {width:,.0f} by {height:,.0f} units, too large for a PNG file that could be read",
            accepted=f"up to {MOST_PIXELS / LEAST_ZOOM**2 / 1e6:,.0f} million square units",
            hint="Write an SVG file; it stays sharp at any size.",
        )
    return fits


def size_of(svg: str) -> tuple[float, float]:
    """Width and height that a picture of ours declares, in its own units."""
    head = svg[: svg.index(">", svg.index("<svg"))]
    found = {side: re.search(rf'\s{side}="([0-9.]+)"', head) for side in ("width", "height")}
    width, height = (float(match[1]) if match else 0.0 for match in found.values())
    if not width or not height:
        raise InputError("the picture does not say its size", accepted="an SVG document with width and height above 0")
    return width, height


@lru_cache(maxsize=1)
def _fonts_of_the_machine() -> tuple[str, ...] | None:
    """None for the machine's own, as long as a word can be written with them."""
    return None if _can_write(None) else packaged_fonts()


def packaged_fonts() -> tuple[str, ...]:
    """Folders of the fonts that are installed as packages: Source Sans Pro, narrower than what the pictures leave room for."""
    found = find_spec("font_source_sans_pro")
    homes = found.submodule_search_locations if found is not None else None
    return tuple(str(Path(home) / "files") for home in homes or ())


@lru_cache(maxsize=8)
def _can_write(fonts: tuple[str, ...] | None) -> bool:
    """Whether a letter leaves a mark; a library without fonts leaves words out and says nothing."""
    return _drawn(_PROBE.format("M"), 1.0, fonts) != _drawn(_PROBE.format(""), 1.0, fonts)


def _drawn(svg: str, zoom: float, fonts: tuple[str, ...] | None) -> bytes:
    from resvg_py import svg_to_bytes  # noqa: PLC0415 - a compiled library that few calls need

    return bytes(
        svg_to_bytes(
            svg_string=svg,
            zoom=zoom,
            skip_system_fonts=fonts is not None,
            font_dirs=None if fonts is None else list(fonts),
            sans_serif_family=None if fonts is None else PACKAGED,
        )
    )
