"""Pictures set into a page: many on one page, each with names and a size of its own."""

from __future__ import annotations

import re
from dataclasses import dataclass

from markupsafe import Markup

from missiontree.reporting.png import size_of

# In a picture of ours a double quote stands at attributes only: in words it is written &quot;.
_NAMED = re.compile(r'(\s(?:id|aria-labelledby|aria-describedby)=")([^"]+)"')
_MEANT = re.compile(r'(="url\(#|\bhref="#)')


@dataclass(frozen=True, slots=True)
class Picture:
    """
    A picture on a page.

    Parameters
    ----------
    key
        Its name, unique on the page.
    svg
        The picture.
    width, height
        Its full size, in units of 1/16 of the root's font size.
    grows
        By how much it may be enlarged to fill its box.
    """

    key: str
    svg: Markup
    width: float
    height: float
    grows: float


def inlined(svg: str, key: str, grows: float = 1.0) -> Picture:
    """
    A picture ready to stand among others.

    Parameters
    ----------
    svg
        A picture of ours: its words are escaped by whoever drew it.
    key
        Name that no other picture of the page has; put before every id, since a marker or a pattern whose first namesake stands in a
        hidden picture is not painted.
    grows
        By how much it may be enlarged, at least 1; default: not at all.
    """
    drawn = svg[svg.index("<svg") :].strip()
    drawn = _NAMED.sub(lambda found: f'{found[1]}{" ".join(f"{key}-{name}" for name in found[2].split())}"', drawn)
    drawn = _MEANT.sub(rf"\g<1>{key}-", drawn)
    return Picture(key, Markup(drawn), *size_of(drawn), grows)  # noqa: S704 - drawn here, words escaped there


def size_rules(picture: Picture) -> str:
    """
    Style of one picture: it fills its box, within bounds in which its words can be read; what is wider is scrolled.

    Enlarged, it is no higher than the window. What is out of sight is not drawn, and takes about its own height. Sizes are in units of
    the root's font size, so that pictures grow with the text.
    """
    width, height = picture.width / 16, picture.height / 16
    return (
        f"#{picture.key}{{contain-intrinsic-block-size:auto {height:.1f}rem}}"
        f"#{picture.key}>svg{{min-width:{0.72 * width:.1f}rem;max-width:{picture.grows * width:.1f}rem;"
        f"max-height:max(94vh,{height:.1f}rem)}}"
    )
