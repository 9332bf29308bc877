"""What "one", "the other crate" and "the second" stand for, going by what was named before."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.methods.mention import Mention, UnclearError
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.phrases import ONES
from missiontree.authoring.reading.plurals import is_plural, plural, singular
from missiontree.authoring.reading.pronouns import Groups


def with_noun(phrase: Phrase, said: Sequence[Groups], slot: int = 0, beside: Sequence[Mention] = ()) -> Phrase:
    """
    "The blue one" as "the blue crate", if crates were spoken of; other phrases as they are.

    Parameters
    ----------
    phrase
        The phrase.
    said
        Groups of mentions, clause by clause.
    slot
        Where the phrase stands in its clause; what stood there in a clause before is preferred.
    beside
        What stands before it in the same slot.

    Raises
    ------
    UnclearError
        If several nouns may be meant, or none was said.
    """
    *before, last = phrase.name.split() or [""]
    if last.lower() not in ONES or phrase.pronoun:
        return phrase
    alike = [groups[slot] for groups in reversed(said) if slot < len(groups)]
    for mentions in (*([beside] if beside else []), *alike):
        here = dict.fromkeys(_noun(m) for m in mentions if _is_common(m))
        if len(here) == 1 and not any(m.plural and m.new for m in mentions):
            return _called(phrase, before, next(iter(here)), last)
    for groups in reversed(said):
        common = [m for group in groups for m in group if _is_common(m)]
        nouns = dict.fromkeys(_noun(m) for m in common)
        if len(nouns) > 1:
            nouns = dict.fromkeys(_noun(m) for m in common if len(m.label.split()) > 1) or nouns
        if len(nouns) == 1 and not phrase.other and not is_plural(last) and any(m.plural and m.new for m in common):
            raise UnclearError(f"it is not clear which of {common[0].label} {phrase.text!r} is")
        if len(nouns) == 1:
            return _called(phrase, before, next(iter(nouns)), last)
        if nouns:
            raise UnclearError(f"{phrase.text!r} may mean {' or '.join(nouns)}; say which")
    raise UnclearError(f"it is not clear what {phrase.text!r} means")


def other_of_two(phrase: Phrase, said: Sequence[Groups]) -> tuple[Mention, ...]:
    """The one of two that were named together, one of whom was named alone since; nobody if there are no such two."""
    if phrase.several:
        return ()
    alone: set[str] = set()
    for groups in reversed(said):
        for group in groups:
            left = tuple(mention for mention in group if mention.name not in alone)
            if len(group) == 2 and len(left) == 1:
                return left
        alone |= {mention.name for group in groups if len(group) == 1 for mention in group}
    return ()


def _called(phrase: Phrase, before: Sequence[str], noun: str, one: str) -> Phrase:
    """The phrase with a noun for "one", or with its plural for "ones"."""
    return replace(phrase, name=" ".join((*before, plural(noun) if one.lower() == "ones" else noun)))


def picked(phrase: Phrase, group: Sequence[Mention], said: Sequence[Groups]) -> tuple[Mention, ...]:
    """
    Those of a group that "the other", "the others" or "the second" picks out.

    Raises
    ------
    UnclearError
        If that is nobody, or more than the words say.
    """
    if phrase.ordinal:
        if phrase.ordinal > len(group):
            raise UnclearError(f"it is not clear what {phrase.text!r} means: there are {len(group)}")
        return (group[phrase.ordinal - 1],)
    named = {mention.name for groups in said for together in groups if len(together) == 1 for mention in together}
    left = tuple(mention for mention in group if mention.name not in named)
    if len(left) == len(group) or not left:
        raise UnclearError(f"it is not clear what {phrase.text!r} means, other than which")
    if phrase.count is not None and len(left) != phrase.count:
        raise UnclearError(
            f"{phrase.text!r} are {phrase.count}, and {len(left)} are left: {', '.join(m.label for m in left)}"
        )
    if len(left) > 1 and not phrase.several:
        raise UnclearError(f"{phrase.text!r} may be any of {', '.join(m.label for m in left)}; say which one")
    return left


def _is_common(mention: Mention) -> bool:
    """Whether it is called by a noun, and not by a name of its own."""
    return mention.determined or kind_of(mention.label) is not None or mention.label.split()[-1][-1].isdigit()


def _noun(mention: Mention) -> str:
    words = mention.label.split()
    noun = words[-2] if len(words) > 1 and words[-1][-1].isdigit() else words[-1]
    return singular(noun.lower()) if mention.plural else noun.lower()
