"""One and several of a noun."""

from __future__ import annotations

from missiontree.authoring.language.kinds import kind_of

_SINGULAR = frozenset({"gas", "lens", "canvas", "atlas", "news"})
SAME = frozenset({"sheep", "deer", "fish", "cattle", "livestock", "staff", "personnel", "poultry", "ones"})
_IRREGULAR = {
    "people": "person",
    "men": "man",
    "women": "woman",
    "children": "child",
    "mice": "mouse",
    "geese": "goose",
    "oxen": "ox",
    "calves": "calf",
    "wolves": "wolf",
    "knives": "knife",
    "shelves": "shelf",
    "loaves": "loaf",
}


def is_plural(name: str) -> bool:
    """Whether the noun looks like more than one."""
    last = name.lower().split()[-1]
    men = last.endswith("men") and len(last) > 5
    return (
        last in _IRREGULAR
        or last in SAME
        or men
        or (last.endswith("s") and not last.endswith(("ss", "us", "is", "'s")) and last not in _SINGULAR)
    )


def singular(noun: str) -> str:
    """The noun for one of several: crates, crate; boxes, box; children, child."""
    if noun in _IRREGULAR:
        return _IRREGULAR[noun]
    if noun.endswith("men") and len(noun) > 5:
        return noun[:-3] + "man"
    if noun.endswith("ies") and len(noun) > 4:
        return noun[:-3] + "y"
    if noun.endswith(("ses", "xes", "ches", "shes", "zes")) and kind_of(noun[:-1]) is None:
        return noun[:-2]
    return noun[:-1] if is_plural(noun) and noun.endswith("s") else noun


def plural(noun: str) -> str:
    """The noun for several of one: crate, crates; box, boxes; child, children."""
    back = {one: many for many, one in _IRREGULAR.items()}
    if noun in back or is_plural(noun):
        return back.get(noun, noun)
    if noun.endswith("man") and len(noun) > 5:
        return noun[:-3] + "men"
    if noun.endswith("y") and noun[-2:-1] not in "aeiou":
        return noun[:-1] + "ies"
    return noun + ("es" if noun.endswith(("s", "x", "ch", "sh", "z")) else "s")
