"""When two names mean the same: the suite's name of a thing, and the name that an author gave it."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence

from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene

_DROPPED = frozenset({"the", "a", "an", "my", "your", "his", "her", "its", "our", "their"})
_AFTER_HEAD = frozenset({"of", "in", "at", "on", "from", "for", "with", "to", "near", "by"})
_POSSESSIVE = re.compile(r"['’]s?(?=\s|$)")

Words = tuple[str, ...]


def words_of(name: str) -> Words:
    """Words of a name; case, articles, possessives and punctuation aside."""
    plain = _POSSESSIVE.sub("", unicodedata.normalize("NFC", name).casefold())
    words = "".join(letter if letter.isalnum() else " " for letter in plain).split()
    return tuple(word for word in words if word not in _DROPPED) or tuple(words)


def scene_id(name: str, scene: Scene) -> str | None:
    """The entity of the scene that is called so, by id before label before alias; None if there is none, or several."""
    called = _called(name, scene)
    return called[0] if len(called) == 1 else None


def ambiguous_in(name: str, scene: Scene) -> tuple[str, ...]:
    """The entities that a name may mean, if they are several."""
    called = _called(name, scene)
    return called if len(called) > 1 else ()


def may_mean(one: Words, other: Words) -> bool:
    """Whether one name is the other with words left out, both being of the same head noun and number."""
    apart = set(one) <= set(other) or set(other) <= set(one)
    return apart and _head(one) == _head(other) and _numbers(one) == _numbers(other)


def pairings(expected: Sequence[Words], got: Mapping[str, Words]) -> Iterator[dict[str, Words]]:
    """
    Ways to take the author's names for the suite's, one for one: entity id to expected name.

    Equal names are taken first and are not reconsidered. The rest may be matched with words left out. What cannot be matched is
    left out; ways that match more come first.
    """
    fixed: dict[str, Words] = {}
    for name in dict.fromkeys(expected):
        equal = next((key for key, words in got.items() if words == name and key not in fixed), None)
        if equal is not None:
            fixed[equal] = name
    left = [name for name in dict.fromkeys(expected) if name not in fixed.values()]
    free = {key: words for key, words in got.items() if key not in fixed}
    for pairs in _ways(left, free):
        yield fixed | pairs


def _ways(names: Sequence[Words], free: Mapping[str, Words]) -> Iterator[dict[str, Words]]:
    if not names:
        yield {}
        return
    name, rest = names[0], names[1:]
    for key in [key for key, words in free.items() if may_mean(name, words)]:
        for pairs in _ways(rest, {other: words for other, words in free.items() if other != key}):
            yield {key: name, **pairs}
    yield from _ways(rest, free)


def _called(name: str, scene: Scene) -> tuple[str, ...]:
    wanted = words_of(name)
    for spellings in (_id, _label, _aliases):
        called = tuple(entity.id for entity in scene.all_entities if wanted in map(words_of, spellings(entity)))
        if called:
            return called
    return ()


def _id(entity: Entity) -> tuple[str, ...]:
    return (entity.id,)


def _label(entity: Entity) -> tuple[str, ...]:
    return (entity.label,)


def _aliases(entity: Entity) -> tuple[str, ...]:
    return entity.aliases


def _is_number(word: str) -> bool:
    return len(word) == 1 or any(letter.isdigit() for letter in word)


def _head(words: Words) -> str:
    """The noun that the name is about: "People of Ward 3" are people."""
    front = words[: next((place for place, word in enumerate(words) if word in _AFTER_HEAD and place), len(words))]
    return next((word for word in reversed(front) if not _is_number(word)), "")


def _numbers(words: Words) -> frozenset[str]:
    return frozenset(word for word in words if _is_number(word))
