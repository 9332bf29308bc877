"""
What may be called what, by the words of the design, and without a line of the product's own matching.

Robots, routines, entities, nodes and kinds: the exact name, letter case aside. A parent: also another spelling of exactly one node
(case, articles, punctuation), or the clear nearest match; never with letters that only look alike. Without a scene, an entity also if
the mission says its name.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Sequence
from functools import cached_property

from benchmarks.campaign_worlds import World
from missiontree.mission.tree import MissionTree

_ARTICLES = {"the", "a", "an"}
_FURTHEST = 0.5


class Oracle:
    """
    Knows the names of a world.

    Parameters
    ----------
    world
        The world.
    tree
        Its tree.
    """

    def __init__(self, world: World, tree: MissionTree) -> None:
        self.world, self.tree = world, tree
        brief = world.brief
        self.routines = [name for routine in world.takes for name in (routine, f"{routine}Tree")]
        self.robots = [name for kind in brief.fleet.types for name in (kind.id, kind.label)]
        people = (*brief.world.places, *brief.world.entities, *tree.entities)
        self.entities = [name for entity in people for name in (entity.id, entity.label, *entity.aliases)]
        self.nodes = [name for node in tree.nodes for name in (node.id, node.label)]
        self.kinds = ["person", "animal", "object", "place", *(brief.scene.kinds if brief.scene is not None else ())]

    @cached_property
    def alphabet(self) -> set[str]:
        """Every letter that the world's names and words are written with; any other can at best look like one of them."""
        texts = [*self.routines, *self.robots, *self.entities, *self.nodes, *self.kinds, self.world.brief.text]
        letters = {letter for text in texts for letter in text}
        plain = {chr(code) for code in range(0x20, 0x7F)} | {"\t", "\n"}
        return plain | letters | {case for letter in letters for case in (letter.upper(), letter.lower())}

    def same(self, name: str, known: Iterable[str]) -> bool:
        """Whether the name is one of these, letter case and outer blanks aside."""
        return self._is_written_here(name) and _case_aside(name) in {_case_aside(one) for one in known}

    def may_be_entity(self, name: str) -> bool:
        """Whether somebody may be called that: of the scene, or, without one, of the mission's words."""
        if self.same(name, self.entities):
            return True
        if self.world.scenic or not self._is_written_here(name):
            return False
        said, words = _words(self.world.brief.text), _words(name)
        return bool(words) and any(said[at : at + len(words)] == words for at in range(len(said)))

    def may_be_node(self, name: str) -> bool:
        """Whether it is an id or a label of the tree, or a routine with its entities in brackets."""
        head, bracket, rest = name.strip().partition("(")
        if bracket and rest.rstrip().endswith(")") and self.same(head, self.routines):
            entities = rest.rstrip()[:-1].split(",")
            return all(self.same(entity, self.entities) for entity in entities)
        return self.same(name, self.nodes)

    def may_mean(self, name: str) -> set[str]:
        """Ids of the nodes that the name of a parent may stand for."""
        exact = [node.id for node in self.tree.nodes if name in {node.id, node.label}]
        if exact or name == self.tree.objective:
            return set(exact) or {self.tree.nodes[0].id}
        if not self._is_written_here(_bare(name)):
            return set()
        same = [node.id for node in self.tree.nodes if _plain(name) == _plain(node.label)]
        return set(same) if len(same) == 1 else set() if same else self._nearest(name)

    def _nearest(self, name: str) -> set[str]:
        """The one node whose name needs fewest changes of letters, if it is near and says the same numbers."""
        wanted = " ".join(_plain(name))
        away = sorted(
            (_distance(wanted, " ".join(_plain(node.label))), node.id, node.label) for node in self.tree.nodes
        )
        (least, nearest, label), second = away[0], away[1][0]
        near = least < second and least <= _FURTHEST * max(1, len(wanted))
        return {nearest} if near and _numbers(wanted) == _numbers(" ".join(_plain(label))) else set()

    def _is_written_here(self, name: str) -> bool:
        return set(unicodedata.normalize("NFC", name)) <= self.alphabet and set(name) <= self.alphabet | _joining(name)


def _joining(name: str) -> set[str]:
    """Marks that make one letter with the one before them, as some keyboards send it."""
    return {letter for letter in name if unicodedata.combining(letter)}


def _case_aside(name: str) -> str:
    return " ".join(unicodedata.normalize("NFC", name).lower().split())


def _bare(name: str) -> str:
    """Without accents: a slip of the pen in the name of a parent, where it is no other letter."""
    return "".join(letter for letter in unicodedata.normalize("NFD", name) if not _is_accent(letter))


def _is_accent(letter: str) -> bool:
    return "\u0300" <= letter <= "\u0327"


def _words(text: str) -> list[str]:
    return "".join(letter if letter.isalnum() else " " for letter in unicodedata.normalize("NFC", text).lower()).split()


def _plain(name: str) -> Sequence[str]:
    """The words without articles. A capital A within a name, or a last word, is a name for itself: Gate A."""
    words = "".join(letter if letter.isalnum() else " " for letter in unicodedata.normalize("NFC", name)).split()
    last = len(words) - 1
    articles = [word.lower() in _ARTICLES and at < last and (at == 0 or word != "A") for at, word in enumerate(words)]
    return [word.lower() for word, article in zip(words, articles, strict=True) if not article]


def _numbers(text: str) -> list[str]:
    return [word for word in text.split() if any(letter.isdigit() for letter in word)]


def _distance(one: str, two: str) -> int:
    """Letters to put in, leave out, change, or swap with their neighbour."""
    one = one[:300]
    rows = [list(range(len(two) + 1))]
    for place, letter in enumerate(one, start=1):
        row = [place]
        for column, other in enumerate(two, start=1):
            least = min(rows[-1][column] + 1, row[-1] + 1, rows[-1][column - 1] + (letter != other))
            if place > 1 < column and letter == two[column - 2] and other == one[place - 2]:
                least = min(least, rows[-2][column - 2] + 1)
            row.append(least)
        rows.append(row)
    return rows[-1][-1]
