"""Two clauses that are one errand: "pick up the parcel and deliver it to Anna"."""

from __future__ import annotations

from dataclasses import replace

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.reading.clause import Clause

_JOINED = frozenset({"and", "then"})
_GOING_ON = frozenset({"bring", "transport", "guide", "evacuate"})


def errands_joined(clauses: tuple[Clause, ...], lexicon: Lexicon) -> tuple[Clause, ...]:
    """The clauses, with every taking that is followed by a bringing of the same thing made one clause with it."""
    kept: list[Clause] = []
    place_of: dict[int, int] = {}
    place = 0
    while place < len(clauses):
        clause, width = clauses[place], 1
        if place + 1 < len(clauses) and _is_errand(clause, clauses[place + 1], lexicon):
            clause, width = _joined(clause, clauses[place + 1], lexicon), 2
        place_of.update(dict.fromkeys(range(place, place + width), len(kept)))
        kept.append(clause)
        place += width
    return tuple(
        clause if clause.anchor is None else replace(clause, anchor=place_of.get(clause.anchor)) for clause in kept
    )


def _is_errand(taking: Clause, bringing: Clause, lexicon: Lexicon) -> bool:
    """Whether the first says only what is taken, and the second where it goes."""
    if (
        taking.verb is None
        or bringing.verb is None
        or bringing.relation not in _JOINED
        or taking.decisive
        or bringing.decisive
    ):
        return False
    rescued = {"rescue", "evacuate"} & set(lexicon.goals_of[taking.verb.phrase])
    goes_on = _GOING_ON & set(lexicon.goals_of[bringing.verb.phrase])
    taken = [word.low for word in taking.words[taking.verb.length :]]
    behind = [word.low for word in bringing.words[bringing.verb.length :]]
    errand = taking.verb.phrase in lexicon.words["taking"] or (rescued and behind[1:2] == ["to"])
    if not errand or not goes_on or not taken or len(behind) < 2:
        return False
    return behind[0] in {"it", "them", *(("him", "her") if rescued else ())} and not {"to", "into", "onto"} & set(taken)


def _joined(taking: Clause, bringing: Clause, lexicon: Lexicon) -> Clause:
    assert taking.verb is not None
    assert bringing.verb is not None
    own = taking.verb.phrase not in lexicon.words["taking"]  # to rescue is more than to pick up
    verb = taking.words[: taking.verb.length] if own else bringing.words[: bringing.verb.length]
    words = (*verb, *taking.words[taking.verb.length :], *bringing.words[bringing.verb.length + 1 :])
    passed = (*taking.passed_over, *bringing.passed_over)
    asked = tuple(dict.fromkeys((*taking.asked, *bringing.asked)))
    joined = replace(
        bringing,
        words=words,
        verb=taking.verb if own else bringing.verb,
        passed_over=passed,
        asked=asked,
        leads=taking.leads,
    )
    return replace(joined, relation=taking.relation, anchor=taking.anchor, sentence=taking.sentence)
