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


def antecedent(phrase: Phrase, said: Sequence[Groups], beside: Collection[str] = ()) -> tuple[Mention, ...]:
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

    Raises
    ------
    UnclearError
        If it may be several, or nobody.
    """
    said = [[tuple(m for m in group if m.name not in beside) for group in groups] for groups in said]
    if phrase.pronoun == "several":
        return _antecedents(phrase, said)
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
_MALE = frozenset(word for (word,) in phrases_of("statements", "male"))


def gender_of(name: str) -> str | None:
    """What the words of a name say: ``female``, ``male``, or nothing."""
    words = set(name.lower().replace("'s", "").split())
    female, male = bool(words & _FEMALE), bool(words & _MALE)
    return None if female == male else "female" if female else "male"


def _which(phrase: Phrase, mentions: Iterable[Mention]) -> UnclearError:
    options = " or ".join(dict.fromkeys(mention.label for mention in mentions))
    return UnclearError(f"{phrase.text!r} may mean {options}; say which one")
