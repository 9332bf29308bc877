"""The page's style: the common sheet, and what only this page needs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from missiontree.reporting.html.dark import dark_rules
from missiontree.reporting.html.inlined import Picture, size_rules
from missiontree.reporting.html.page import resource
from missiontree.reporting.palette import HUES


def style_of(pictures: Sequence[Picture], ranks: Sequence[int]) -> str:
    """
    The style of a page.

    Parameters
    ----------
    pictures
        All pictures on it.
    ranks
        Ranks that can be chosen. Choosing one shows what is of its class, without any script; a browser that cannot tell which one is
        chosen shows them all, one below the other.
    """
    return "\n".join((resource("report.css"), *_hues(), *map(size_rules, pictures), *_switch(ranks), _dark(pictures)))


def _hues() -> Iterator[str]:
    for place, hue in enumerate(HUES):
        yield f".hue-{place}{{--hue:{hue.fill};--on:{hue.on}}}"


def _switch(ranks: Sequence[int]) -> Iterator[str]:
    if len(ranks) < 2:
        return
    chosen = ",".join(f"body:has(#way-{rank}:checked) .way-{rank}" for rank in ranks)
    columns = ",".join(f"body:has(#way-{rank}:checked) thead .column-{rank}" for rank in ranks)
    yield f"@supports selector(:has(a)){{.way{{display:none}}{chosen}{{display:block}}}}"
    yield f"{columns}{{color:var(--link);font-weight:600;box-shadow:inset 0 -2px var(--link)}}"


def _dark(pictures: Sequence[Picture]) -> str:
    rules = dark_rules(str(picture.svg) for picture in pictures)
    return f"@media screen and (prefers-color-scheme:dark){{{rules}}}"
