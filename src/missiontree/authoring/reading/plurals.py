"""One and several of a noun."""

from __future__ import annotations

from missiontree.authoring.language.kinds import is_abstract, kind_of

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


_ENDINGS = (
    ("men", "man"),
    ("ies", "ie"),
    ("ies", "y"),
    ("ves", "ve"),
    ("ves", "f"),
    ("ves", "fe"),
    ("es", "e"),
    ("es", ""),
    ("s", ""),
)


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


def noun_of(name: str) -> str:
    """The noun of a name, without the number or the letter that tells one from another: "Bus 2" is a bus, "Block B" a block."""
    *before, last = name.lower().split()
    return before[-1] if before and (last.isdecimal() or len(last) == 1) else last


def singular(noun: str) -> str:
    """The noun for one of several: crates, crate; boxes, box; children, child."""
    before, blank, last = noun.rpartition(" ")
    if blank:
        return f"{before} {singular(last)}"
    if noun.lower() in _IRREGULAR:
        one = _IRREGULAR[noun.lower()]
        return one.capitalize() if noun[:1].isupper() else one
    if not is_plural(noun) or noun.lower() in SAME:
        return noun
    forms = [noun[: -len(many)] + one for many, one in _ENDINGS if noun.lower().endswith(many)]
    return next(
        (form for form in forms if kind_of(form.lower()) is not None or is_abstract(form.lower())),
        (forms or [noun])[-1],
    )


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
