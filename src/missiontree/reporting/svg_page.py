"""What every picture of ours begins with, and how it writes words."""

from __future__ import annotations

from missiontree.reporting.escape import xml_safe
from missiontree.reporting.palette import INK
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.text_box import ELLIPSIS, NARROWEST, text_width

FONT = "Helvetica, Arial, &quot;DejaVu Sans&quot;, sans-serif"


def opening(width: float, height: float, title: str, description: str, prefix: str) -> str:
    """
    The start of a picture, up to its background: size, name and description for whoever cannot see it.

    Parameters
    ----------
    width, height
        Size in pixels.
    title, description
        In words; made harmless here.
    prefix
        Start of the ids in the picture, different for all pictures of one page.
    """
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="mt-picture" width="{n(width)}" height="{n(height)}" '
        f'viewBox="0 0 {n(width)} {n(height)}" role="img" aria-labelledby="{prefix}-title {prefix}-desc" '
        f'font-family="{FONT}" fill="{INK}">\n'
        f'<title id="{prefix}-title">{xml_safe(title)}</title>\n'
        f'<desc id="{prefix}-desc">{xml_safe(description)}</desc>\n'
        f'<rect class="mt-paper" width="{n(width)}" height="{n(height)}" fill="#ffffff"/>'
    )


def text(
    x: float,
    y: float,
    words: str,
    *,
    size: float,
    fill: str = INK,
    kind: str = "mt-ink",
    anchor: str = "start",
    bold: bool = False,
    halo: str = "",
) -> str:
    """
    A line of words.

    Parameters
    ----------
    x, y
        Anchor and baseline.
    words
        What is written; made harmless here.
    size
        Font size in pixels.
    fill, kind
        Colour, and the class by which a page may recolour it.
    anchor
        ``start``, ``middle`` or ``end``.
    bold
        Default false.
    halo
        Colour that keeps lines off the letters; empty (default) for none.
    """
    where = "" if anchor == "start" else f' text-anchor="{anchor}"'
    weight = ' font-weight="bold"' if bold else ""
    ring = f' stroke="{halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke"' if halo else ""
    return (
        f'<text class="{kind}" x="{n(x)}" y="{n(y)}" font-size="{n(size)}" fill="{fill}"{where}{weight}{ring}>'
        f"{xml_safe(words)}</text>"
    )


def middle_cut(words: str, size: float, room: float) -> str:
    """A name that fits: cut in its middle if it is too long, since names of robots differ at their ends."""
    if text_width(words, size) <= room:
        return words
    kept = max(1, min(len(words) - 1, int(room / (NARROWEST * size)) + 1))  # more never fit
    while kept > 1 and text_width(_without_middle(words, kept), size) > room:
        kept -= 1
    return _without_middle(words, kept)


def _without_middle(words: str, kept: int) -> str:
    back = kept // 2
    return words[: kept - back] + ELLIPSIS + words[len(words) - back :]
