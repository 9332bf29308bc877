"""How far a mission tree keeps loose expectations, and which of them it breaks, in words."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

from missiontree.evaluation.choosing import ways_of_choosing
from missiontree.evaluation.loose import Loose
from missiontree.evaluation.names import Words, may_mean, pairings, scene_id, words_of
from missiontree.evaluation.notation import ANYTHING, PlannedCall
from missiontree.evaluation.occurrence import Occurrence, answers, is_meant, occurrences
from missiontree.evaluation.staffed import able_types
from missiontree.evaluation.structure import Named, Pairs, Structure, structure_of_tree
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionTree

_MOST_PAIRINGS = 200
_MOST_STEPS = 5_000


@dataclass(frozen=True, slots=True)
class Held:
    """
    Which expectations hold.

    Parameters
    ----------
    count
        How many there are: entries of must, of must_not, of order and of entities.
    broken
        Those that do not hold, in words.
    """

    count: int
    broken: tuple[str, ...]

    @property
    def share(self) -> float:
        """Share of the expectations that hold, from 0 to 1."""
        return 1 - len(self.broken) / self.count


def held(loose: Loose, tree: MissionTree, brief: MissionBrief) -> Held:
    """
    Which expectations a tree keeps.

    Where the tree leaves a choice, they are to hold whatever is chosen: the way of choosing that breaks most counts. Where names or
    routines can be matched in several ways, the way that breaks least counts. 1,000 ways of choosing, 200 to match names and
    5,000 steps of matching routines are tried at most.

    Parameters
    ----------
    loose
        What is expected.
    tree
        The tree that an author made, finished.
    brief
        What the author was given; its fleet and scene say what robot types and names mean.
    """
    plan = structure_of_tree(tree, brief)
    names = {name.key: name.words for leaf in plan.leaves for name in leaf.arguments if not name.in_scene}
    written = [name for call in loose.calls for name in call.arguments if name != ANYTHING]
    asked = [words_of(name) for name in (*written, *loose.entities) if scene_id(name, brief.world) is None]
    able = able_types(tree, brief) if any(call.types for call in loose.calls) else ()
    best: tuple[str, ...] | None = None
    for pairs in islice(pairings(asked, names), _MOST_PAIRINGS):
        broken = _Matching(loose, plan, pairs, brief, able).broken()
        if best is None or len(broken) < len(best):
            best = broken
        if not best:
            break
    count = len(loose.must) + len(loose.must_not) + len(loose.order) + len(loose.entities)
    return Held(count, best or ())


class _Matching:
    """A tree against expectations, names matched in one way."""

    def __init__(
        self,
        loose: Loose,
        plan: Structure,
        pairs: dict[str, Words],
        brief: MissionBrief,
        able: Sequence[frozenset[str]],
    ) -> None:
        self._loose, self._plan, self._pairs, self._brief, self._able = loose, plan, pairs, brief, able
        self._found = occurrences(plan, brief.routines)

    def broken(self) -> tuple[str, ...]:
        """What does not hold, in the way of choosing that breaks most."""
        ways = ways_of_choosing(self._plan.shape)
        refused = [
            f"must not occur: {text}"
            for text, call in zip(self._loose.must_not, self._loose.refused, strict=True)
            if any(self._is_refused(call, one) for one in self._found if not one.steps)
        ]
        worst = max((self._broken_in(leaves) for leaves in ways), key=len)
        if len(ways) > 1:
            worst = tuple(f"{words}, in a way of choosing that the tree leaves open" for words in worst)
        return (*worst, *refused)

    def _broken_in(self, leaves: frozenset[int]) -> tuple[str, ...]:
        found = [one for one in self._found if one.leaf in leaves]
        before, until = self._plan.within(leaves)
        offered = [[one for one in found if self._answers(call, one)] for call in self._loose.calls]
        order = _Relations(before, until)
        return (
            *_best_matching(self._loose, offered, order),
            *(f"nothing is done with {name}" for name in self._loose.entities if not self._is_used(name, found)),
        )

    def _answers(self, call: PlannedCall, one: Occurrence) -> bool:
        if not answers(call, one, self._pairs, self._brief):
            return False
        if not call.types:
            return True
        types = self._able[one.leaf]
        return types <= set(call.by) if call.by is not None else not types & set(call.not_by)

    def _is_used(self, name: str, found: Sequence[Occurrence]) -> bool:
        return any(is_meant(name, argument, self._pairs, self._brief) for one in found for argument in one.arguments)

    def _is_refused(self, call: PlannedCall, one: Occurrence) -> bool:
        """Whether it is one of a call that must not occur; a name that nothing was matched with may be meant by any like it."""
        matched = set(self._pairs.values())
        taken = dict(self._pairs)
        for name in call.arguments:
            if name != ANYTHING and words_of(name) not in matched:
                taken |= {found.key: words_of(name) for found in one.arguments if self._may_be(found, name)}
        return answers(call, one, taken, self._brief)

    def _may_be(self, found: Named, name: str) -> bool:
        return not found.in_scene and found.key not in self._pairs and may_mean(words_of(name), found.words)


@dataclass(frozen=True, slots=True)
class _Relations:
    """The order of a plan under one way of choosing."""

    before: Pairs
    until: Pairs

    def holds(self, relation: str, first: Occurrence, second: Occurrence) -> bool:
        pair = (first.leaf, second.leaf)
        if relation == "~":
            return pair in self.until and first.open_ended
        return pair in self.before or first.precedes_within(second)


def _best_matching(loose: Loose, offered: Sequence[Sequence[Occurrence]], order: _Relations) -> tuple[str, ...]:
    """Take occurrences for the entries of must so that the least is broken; says what is."""
    best: tuple[str, ...] | None = None
    for taken in islice(_matchings(loose, offered), _MOST_STEPS):
        broken = tuple(_broken(loose, taken, order))
        if best is None or len(broken) < len(best):
            best = broken
        if not best:
            break
    return best or ()


def _matchings(loose: Loose, offered: Sequence[Sequence[Occurrence]]) -> Iterator[tuple[Occurrence | None, ...]]:
    """Ways to take an occurrence for each entry; equal entries take different leaves, and what is left over takes none."""

    def extended(taken: tuple[Occurrence | None, ...]) -> Iterator[tuple[Occurrence | None, ...]]:
        number = len(taken)
        if number == len(offered):
            yield taken
            return
        twins = {one.leaf for one, call in zip(taken, loose.calls, strict=False) if one and call == loose.calls[number]}
        free = [one for one in offered[number] if one.leaf not in twins]
        for one in free or (None,):
            yield from extended((*taken, one))

    return extended(())


def _broken(loose: Loose, taken: Sequence[Occurrence | None], order: _Relations) -> Iterator[str]:
    for text, one in zip(loose.must, taken, strict=True):
        if one is None:
            yield f"missing: {text}"
    words: dict[str, Callable[[str, str], str]] = {"<": "{} before {}".format, "~": "{} until the end of {}".format}
    for relation in loose.relations:
        first, second = taken[relation.first - 1], taken[relation.second - 1]
        if first is None or second is None or not order.holds(relation.relation, first, second):
            texts = loose.must[relation.first - 1], loose.must[relation.second - 1]
            yield f"missing order: {words[relation.relation](*texts)}"
