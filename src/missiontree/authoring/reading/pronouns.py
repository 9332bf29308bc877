"""Whom a pronoun means: somebody of the clause under way or of those before, the nearest first."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from missiontree.authoring.language.lexicon import phrases_of
from missiontree.authoring.methods.mention import Mention, UnclearError
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.plurals import SAME

_INFANTS = frozenset({"child", "baby", "infant", "toddler"})  # may be "it"
Groups = Sequence[tuple[Mention, ...]]
"""Those named together in one clause, slot by slot."""


def antecedent(
    phrase: Phrase, said: Sequence[Groups], beside: Collection[str] = (), start: int = 0
) -> tuple[Mention, ...]:
    """
    Whom a pronoun means.

    Parameters
    ----------
    phrase
        The pronoun.
    said
        Groups of mentions, clause by clause.
    beside
        Names that stand in the same clause, and so are meant by no pronoun in it.
    start
        Index of the first clause of the sentence under way.

    Raises
    ------
    UnclearError
        If it may be several, or nobody.
    """
    said = [[tuple(m for m in group if m.name not in beside) for group in groups] for groups in said]
    if phrase.pronoun == "several":
        return _antecedents(phrase, said)
    if phrase.pronoun == "person":
        return (_person(phrase, said, start),)
    for groups in reversed(said):
        fitting = {m.name: m for group in groups for m in group if fits(m, phrase)}
        if phrase.pronoun == "place" and fitting:
            return (list(fitting.values())[-1],)  # where the way went
        if len(fitting) == 1:
            return tuple(fitting.values())
        if fitting:
            raise _which(phrase, fitting.values())
    if phrase.pronoun == "thing":  # "evacuate it", after a clause that names a place alone
        groups = next((groups for groups in reversed(said) if groups), ())
        places = {mention.name: mention for group in groups for mention in group}
        if len(places) == 1 and all(mention.kind == "place" for mention in places.values()):
            return tuple(places.values())
    raise UnclearError(f"it is not clear what {phrase.text!r} means")


def _person(phrase: Phrase, said: Sequence[Groups], start: int) -> Mention:
    """Whom "him" or "her" means; "Anna's dog" leaves open whether "her" is Anna."""
    found = _nearest_person(phrase, said, start)
    owners = [word.removesuffix("'s") for word in found.label.split() if word.endswith("'s")]
    said_of = gender_of(phrase.name)
    if gender_of(found.label) is None and said_of and said_of in {gender_of(owner) for owner in owners}:
        raise UnclearError(f"{phrase.text!r} may mean {owners[-1]} or {found.label}; say which one")
    return found


def _nearest_person(phrase: Phrase, said: Sequence[Groups], start: int) -> Mention:
    """The one whose gender is known to be that, or the only one of the nearest clause."""
    nearest = next((found for groups in reversed(said) if (found := _fitting(groups, phrase))), {})
    everyone = {name: mention for groups in said for name, mention in _fitting(groups, phrase).items()}
    certain = {name: m for name, m in everyone.items() if gender_of(m.label) is not None}
    if len(certain) == 1 and phrase.name in _GENDERED:
        return next(iter(certain.values()))
    if not nearest:
        raise UnclearError(f"it is not clear what {phrase.text!r} means")
    here = any(_fitting(groups, phrase) for groups in said[start:])
    if not here and len(everyone) > 1 and not (len(certain) == 1 and set(nearest) == set(certain)):
        raise _which(phrase, everyone.values())
    if len(nearest) > 1 or (certain and phrase.name in _GENDERED and not set(nearest) & set(certain)):
        raise _which(phrase, (certain or nearest).values())
    return next(iter(nearest.values()))


def _fitting(groups: Groups, phrase: Phrase) -> dict[str, Mention]:
    return {mention.name: mention for group in groups for mention in group if fits(mention, phrase)}


_GENDERED = frozenset({"he", "him", "she", "her"})


def _antecedents(phrase: Phrase, said: Sequence[Groups]) -> tuple[Mention, ...]:
    """Whom "them" means: those named together in the nearest clause, or else the two that were named one by one."""
    single: dict[str, Mention] = {}
    for groups in reversed(said):
        fitting = [[m for m in group if fits(m, phrase)] for group in groups]
        together = [group for group in fitting if len(group) > 1 or any(m.plural for m in group)]
        if len(together) > 1:
            raise _which(phrase, (mention for group in together for mention in group))
        if together and not single:
            return tuple({m.name: m for m in together[0]}.values())
        single |= {m.name: m for group in fitting for m in group if m.name not in single}
        if together:
            raise _which(phrase, single.values())
    if len(single) == 2 if not phrase.count else len(single) == phrase.count:
        order = [mention.name for groups in said for group in groups for mention in group]
        return tuple(single[name] for name in sorted(single, key=order.index))
    if single:
        raise _which(phrase, single.values())
    raise UnclearError(f"it is not clear what {phrase.text!r} means")


def fits(mention: Mention, phrase: Phrase) -> bool:
    """Whether a pronoun may stand for somebody."""
    if phrase.pronoun == "place":
        return mention.kind == "place"
    if phrase.pronoun == "person":
        said = gender_of(phrase.name)
        other = said is not None and gender_of(mention.label) not in {None, said}
        return mention.kind in {"person", "animal"} and not mention.plural and not other
    if phrase.pronoun == "several":
        return mention.kind != "place"
    infant = mention.name.lower().split()[-1] in _INFANTS
    one = not mention.plural or mention.name.lower().split()[-1] in SAME
    return (mention.kind in {"object", "animal"} or infant) and one


_FEMALE = frozenset(word for (word,) in phrases_of("statements", "female"))
_WOMEN = frozenset(word for (word,) in phrases_of("statements", "women"))
_MEN = frozenset(word for (word,) in phrases_of("statements", "men"))
_MALE = frozenset(word for (word,) in phrases_of("statements", "male"))


def gender_of(name: str) -> str | None:
    """What the words of a name say: ``female``, ``male``, or nothing."""
    own = [word for word in name.split() if not word.endswith("'s")]
    words = {word.lower() for word in own}
    names = {word.lower() for word in own if word[:1].isupper()}
    female, male = bool(words & _FEMALE or names & _WOMEN), bool(words & _MALE or names & _MEN)
    return None if female == male else "female" if female else "male"


def _which(phrase: Phrase, mentions: Iterable[Mention]) -> UnclearError:
    options = " or ".join(dict.fromkeys(mention.label for mention in mentions))
    return UnclearError(f"{phrase.text!r} may mean {options}; say which one")
