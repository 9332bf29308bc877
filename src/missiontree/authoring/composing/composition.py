"""Several understood clauses to one outline: the order that was said, and the order that follows from what is lost."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from missiontree.authoring.methods.mention import Mention, title
from missiontree.authoring.methods.outline import Outline, Piece, found_by, leaf_of
from missiontree.authoring.methods.reduction import without_implied
from missiontree.authoring.reading.clauses import Relation
from missiontree.authoring.reading.outcomes import Goal
from missiontree.authoring.reading.units import Unit, units_of
from missiontree.mission.reason import Reason
from missiontree.mission.routine import Routine, RoutineLibrary

_EVENTS = frozenset({"before", "after", "until", "while"})


@dataclass
class Composition:
    """
    What all clauses come to.

    Parameters
    ----------
    outline
        Everything below the objective.
    implied
        Precedence that nobody said; left out should it contradict what was said.
    notices
        What was added on the operator's behalf.
    doubts
        What was said and cannot be kept.
    """

    outline: Outline = field(default_factory=Outline)
    implied: list[tuple[Piece, Piece]] = field(default_factory=list)
    notices: list[Reason] = field(default_factory=list)
    doubts: list[Reason] = field(default_factory=list)


def composed(goals: Sequence[Goal], library: RoutineLibrary) -> Composition:
    """Put the clauses together below one objective."""
    made = Composition()
    goals = _asked_in_full(goals)
    _search_once(goals, library, made)
    building = sum(bool(goal.outline.pieces) for goal in goals)
    tops: list[list[Piece]] = []
    for goal in goals:
        event = _named_again(goal, made.outline)
        tops.append(event or (_top(goal, made.outline) if building > 1 else goal.outline.pieces))
        made.outline.pieces += [] if event else tops[-1]
        made.outline.links += goal.outline.links
    units = units_of(goals, made.doubts)
    for unit in units:
        _chosen(unit, goals, tops, library, made)
    _order_as_said(goals, tops, units, library, made)
    _search_first(library, made)
    _found_before_used(library, made)
    _brought_before_returned(goals, made)
    made.implied = without_implied(made.outline, made.implied)
    return made


def _asked_in_full(goals: Sequence[Goal]) -> list[Goal]:
    """The goals; of what somebody needs, nothing is left to be built if a later clause asks for the same."""
    kept: list[Goal] = []
    for number, goal in enumerate(goals):
        later = {leaf.call for other in goals[number + 1 :] for piece in other.outline.pieces for leaf in piece.leaves}
        calls = {leaf.call for piece in goal.outline.pieces for leaf in piece.leaves}
        kept.append(replace(goal, outline=Outline()) if goal.wished and calls <= later else goal)
    return kept


def _chosen(
    unit: Unit, goals: Sequence[Goal], tops: list[list[Piece]], library: RoutineLibrary, made: Composition
) -> None:
    """Hang the options of a choice below one task, which from then on stands for all of their clauses."""
    if len(unit.options) < 2:
        return
    options: list[Piece] = []
    where = min(made.outline.pieces.index(piece) for index in unit.indexes for piece in tops[index])
    for option in unit.options:
        inner = [Unit(((index,),)) for index in option]
        _order_as_said(goals, tops, inner, library, made)
        pieces = [piece for index in option for piece in tops[index]]
        text = ", ".join(goals[index].clause.text for index in option)
        options.append(pieces[0] if len(pieces) == 1 else Piece(title(text), pieces=pieces))
    for index in unit.indexes:
        made.outline.pieces = [piece for piece in made.outline.pieces if piece not in tops[index]]
    label = " or ".join(goals[option[0]].clause.text for option in unit.options)
    choice = Piece(title(label), pieces=options, gate="xor")
    made.outline.pieces.insert(where, choice)
    for index in unit.indexes:
        tops[index] = [choice]


def _named_again(goal: Goal, outline: Outline) -> list[Piece]:
    """What an earlier clause asks for, if this one only names that as an event: "when it is found"."""
    if goal.clause.relation not in _EVENTS or not goal.outline.pieces:
        return []
    standing = [leaf for piece in outline.pieces for leaf in piece.leaves]
    found = [next((leaf for leaf in standing if _stands(piece, [leaf])), None) for piece in goal.outline.pieces]
    return [leaf for leaf in found if leaf is not None] if None not in found else []


def _top(goal: Goal, outline: Outline) -> list[Piece]:
    """One piece for a clause: its own, or a task named by its words; none for a statement."""
    if not goal.outline.pieces:
        return []
    if len(goal.outline.pieces) == 1 and not _stands(goal.outline.pieces[0], outline.pieces):
        return goal.outline.pieces
    label, number = title(goal.clause.text), 1
    while any(piece.routine is None and piece.label == label for piece in outline.pieces):
        number += 1
        label = f"{title(goal.clause.text)} ({number})"
    return [Piece(label, pieces=goal.outline.pieces)]


def _stands(piece: Piece, pieces: Sequence[Piece]) -> bool:
    if piece.routine is None:
        return any(other.routine is None and other.label == piece.label for other in pieces)
    return any(other.routine is not None and other.call == piece.call for other in pieces)


def _order_as_said(
    goals: Sequence[Goal],
    tops: Sequence[list[Piece]],
    units: Sequence[Unit],
    library: RoutineLibrary,
    made: Composition,
) -> None:
    """Then, before, after, while, until, among units; the first of them has nothing before it."""
    stage: list[Piece] = []
    earlier: list[Piece] = []
    relations = _relations(goals)
    beside = _beside(tops, relations)
    for unit in units:
        index = unit.indexes[0]
        goal, pieces, (relation, anchor) = goals[index], tops[index], relations[index]
        others = _anchored(goals, tops, index, anchor)
        if relation in {"before", "after"}:
            first, second = (others, pieces) if relation == "before" else (pieces, others)
            _all_before(first, second, made)
        elif relation == "earlier":
            _all_before(pieces, others, made)
        elif relation in {"while", "until"}:
            _alongside(goal, relation, pieces, others, library, made)
        else:
            if relation == "then":
                stage, earlier = [], stage
            elif relation == "start":
                stage, earlier = [], []
            together = [*pieces, *beside.get(index, [])]
            _all_before(earlier, together, made)
            stage = [*stage, *together]


def _anchored(goals: Sequence[Goal], tops: Sequence[list[Piece]], index: int, anchor: int | None) -> list[Piece]:
    """What a clause is joined to; one that leads a sentence is said of all that *and* joins behind it."""
    if anchor is None or anchor >= len(tops):
        return []
    others = list(tops[anchor])
    if anchor > index and goals[index].clause.relation in {"before", "after", "while"}:
        for number in range(anchor + 1, len(goals)):
            clause = goals[number].clause
            if clause.relation != "and" or clause.sentence != goals[anchor].clause.sentence:
                break
            others += [piece for piece in tops[number] if piece not in others]
    return others


def _beside(tops: Sequence[list[Piece]], relations: Sequence[tuple[Relation, int | None]]) -> dict[int, list[Piece]]:
    """What goes on while each clause does: a "then" before or behind that clause is said of both."""
    beside: dict[int, list[Piece]] = {}
    for index, pieces in enumerate(tops):
        main: int | None = index
        for _ in relations:  # "while this, while that, do it": both go on beside the last
            if main is None or main >= len(tops) or relations[main][0] != "while":
                break
            main = relations[main][1]
        if main is not None and main != index and main < len(tops):
            beside.setdefault(main, []).extend(piece for piece in pieces if piece not in tops[main])
    return beside


def _relations(goals: Sequence[Goal]) -> list[tuple[Relation, int | None]]:
    """How each clause is joined; one that shares the object of the next stands where that one stands."""
    relations: list[tuple[Relation, int | None]] = [(goal.clause.relation, goal.clause.anchor) for goal in goals]
    for index in range(len(goals) - 2, -1, -1):
        if relations[index][0] == "shares":
            relations[index] = relations[index + 1]
            if relations[index][0] not in {"before", "after", "while", "until"}:
                relations[index + 1] = ("and", index)
    return relations


def _all_before(first: Sequence[Piece], second: Sequence[Piece], made: Composition) -> None:
    for one in first:
        for other in second:
            made.outline.link(one, other)


def _alongside(
    goal: Goal, relation: Relation, own: list[Piece], main: list[Piece], library: RoutineLibrary, made: Composition
) -> None:
    """While and until: what is open-ended lasts until the other has ended."""
    own_open, main_open = (any(piece.open_ended(library) for piece in pieces) for pieces in (own, main))
    pairs = [(one, other) for one in main for other in own]
    if main_open and not (own_open and relation == "while"):
        for one, other in pairs:
            if one.open_ended(library):
                made.outline.link(one, other, "until")
    elif own_open and not main_open and relation == "while":
        for one, other in pairs:
            if other.open_ended(library):
                made.outline.link(other, one, "until")
    elif relation == "until":
        message = f"'until {goal.clause.text}': what comes before it ends by itself, so nothing can last until then."
        made.doubts.append(
            Reason(
                rule="until_without_open_end",
                message=message,
                found=goal.clause.text,
                hint="Only following lasts; say 'before' or 'then' for an order.",
            )
        )


def _search_once(goals: Sequence[Goal], library: RoutineLibrary, made: Composition) -> None:
    """Whom an earlier clause searches for is not searched for again by a method of a later one."""
    finders: dict[tuple[str, tuple[str, ...], tuple[str, ...]], Piece] = {}
    for goal in goals:
        leaves = [leaf for piece in goal.outline.pieces for leaf in piece.leaves]
        if (
            any(piece.gate == "xor" for piece in goal.outline.all_pieces)
            or goal.clause.relation == "or"
            or goal.clause.either
        ):
            continue  # who is searched for in one option is not found in the other
        if goal.clause.relation in _EVENTS and all(leaf.call in finders for leaf in leaves):
            continue  # "when both are found" asks for nothing new
        for leaf in leaves:
            if not _only_finds(leaf, library):
                continue
            earlier = finders.get(leaf.call)
            if earlier is None or len(leaves) == 1 or earlier in leaves:
                finders.setdefault(leaf.call, leaf)
                continue
            gone = _taken_out(goal.outline.pieces, leaf)
            goal.outline.links[:] = [
                tuple(earlier if end in gone else end for end in link)  # type: ignore[misc]  # the kind is no piece
                for link in goal.outline.links
            ]
            message = f"{leaf.label} is done once, though several parts of the mission ask for it."
            made.notices.append(Reason(rule="searched_once", message=message, severity="notice", node=leaf.label))


def _taken_out(pieces: list[Piece], leaf: Piece) -> list[Piece]:
    """Take a leaf out of pieces, and the tasks that are empty then; answers with all that went."""
    line: list[tuple[list[Piece], Piece]] = []
    level = pieces
    while (holder := next((piece for piece in level if leaf in piece.leaves), None)) is not None:
        line.append((level, holder))
        level = holder.pieces
    gone: list[Piece] = []
    for level, piece in reversed(line):
        if not piece.pieces:
            level.remove(piece)
            gone.append(piece)
    return gone


def _search_first(library: RoutineLibrary, made: Composition) -> None:
    """A search for everybody who is lost, who is used, and whom nobody searches for."""
    leaves = list(_leaves(made.outline))
    search = next(
        (r for r in library.routines if len(r.arguments) == 1 and found_by(r, library) and not _lasts(r, library)), None
    )
    lost = dict.fromkeys(mention.name for leaf in leaves for mention in leaf.mentions if mention.to_be_found)
    added = 0
    for name in lost:
        if search is None or any(leaf.finds(name, library) for leaf in leaves):
            continue
        mention = next(m for leaf in leaves for m in leaf.mentions if m.name == name and m.to_be_found)
        finder = leaf_of(search, (mention,))
        users = [leaf for leaf in leaves if any(m.name == name for m in leaf.mentions)]
        if not _found_in_option(made.outline, users, finder):
            made.outline.pieces.insert(added, finder)
            added += 1
        why = "is said to be lost" if mention.lost else "is at an unknown position"
        message = f"{finder.label} was added: {mention.label} {why}."
        made.notices.append(Reason(rule="search_added", message=message, severity="notice", node=mention.name))


def _found_in_option(outline: Outline, users: Sequence[Piece], finder: Piece) -> bool:
    """Put the search into the one option of a choice that needs it, if only one does."""
    for choice in (piece for piece in outline.all_pieces if piece.gate == "xor" and piece.routine is None):
        for number, option in enumerate(choice.pieces):
            if set(users) <= set(option.leaves):
                if option.routine is None and option.gate == "and":
                    option.pieces.insert(0, finder)
                else:
                    choice.pieces[number] = Piece(
                        f"Find {finder.mentions[0].label} for {option.label}", pieces=[finder, option]
                    )
                return True
    return False


def _brought_before_returned(goals: Sequence[Goal], made: Composition) -> None:
    """What is brought back is brought away before, if no order is said."""
    order = _Order(made.outline)
    for number, goal in enumerate(goals):
        for leaf in (leaf for piece in goal.outline.pieces if goal.returns for leaf in piece.leaves):
            for other in (
                leaf for before in goals[:number] for piece in before.outline.pieces for leaf in piece.leaves
            ):
                moved = len(leaf.mentions) > 1 < len(other.mentions) and leaf.mentions[0].name == other.mentions[0].name
                if moved and not order.between(other, leaf):
                    made.implied.append((other, leaf))
                    message = f"{other.label} goes before {leaf.label}, though no order was said."
                    made.notices.append(Reason(rule="order_added", message=message, severity="notice", node=leaf.label))


def _found_before_used(library: RoutineLibrary, made: Composition) -> None:
    """Who is searched for is found before anything else is done with them, if no order is said."""
    leaves = list(_leaves(made.outline))
    order = _Order(made.outline)
    for finder in (leaf for leaf in leaves if leaf.routine is not None and found_by(leaf.routine, library)):
        for user in leaves:
            if not {m.name for m in finder.mentions} & {m.name for m in user.mentions}:
                continue
            if (
                finder is user
                or _exclude_each_other(made.outline, finder, user)
                or not _shared(finder, user, library)
                or order.between(finder, user)
            ):
                continue
            made.implied.append((finder, user))
            order.add(finder, user)
            message = f"{finder.label} goes before {user.label}, though no order was said."
            made.notices.append(Reason(rule="order_added", message=message, severity="notice", node=user.label))


def _exclude_each_other(outline: Outline, one: Piece, other: Piece) -> bool:
    """Whether two leaves hang below different options of a choice."""
    for choice in (piece for piece in outline.all_pieces if piece.gate == "xor" and piece.routine is None):
        sides = [
            number for leaf in (one, other) for number, option in enumerate(choice.pieces) if leaf in option.leaves
        ]
        if len(sides) == 2 and sides[0] != sides[1]:
            return True
    return False


def _shared(finder: Piece, user: Piece, library: RoutineLibrary) -> bool:
    names = {mention.name for mention in user.mentions if finder.finds(mention.name, library)}
    return any(not user.finds(name, library) for name in names)


class _Order:
    """What stands before what, as far as links say so."""

    def __init__(self, outline: Outline) -> None:
        self._above: dict[Piece, Piece] = {}
        waiting = list(outline.pieces)
        while waiting:
            piece = waiting.pop()
            self._above.update(dict.fromkeys(piece.pieces, piece))
            waiting += piece.pieces
        self._after: dict[Piece, list[Piece]] = {}
        for first, second, kind in outline.links:
            if kind == "precedence":
                self.add(first, second)

    def add(self, first: Piece, second: Piece) -> None:
        self._after.setdefault(first, []).append(second)

    def between(self, one: Piece, other: Piece) -> bool:
        """Whether either stands before the other already."""
        return self._reaches(one, other) or self._reaches(other, one)

    def _reaches(self, start: Piece, goal: Piece) -> bool:
        goals = set(self._line(goal))
        waiting, seen = [start], set()
        while waiting:
            piece = waiting.pop()
            if piece in seen:
                continue
            seen.add(piece)
            for above in self._line(piece):
                for following in self._after.get(above, []):
                    if following in goals:
                        return True
                    waiting += [following, *following.leaves]
        return False

    def _line(self, piece: Piece) -> Iterator[Piece]:
        while piece is not None:
            yield piece
            piece = self._above.get(piece)  # type: ignore[assignment]


def _leaves(outline: Outline) -> Iterator[Piece]:
    for piece in outline.pieces:
        yield from piece.leaves


def _only_finds(leaf: Piece, library: RoutineLibrary) -> bool:
    assert leaf.routine is not None
    return (
        len(leaf.routine.arguments) == 1 and bool(found_by(leaf.routine, library)) and not _lasts(leaf.routine, library)
    )


def _lasts(routine: Routine, library: RoutineLibrary) -> bool:
    return leaf_of(routine, ()).open_ended(library)


def mentions_of(outline: Outline) -> tuple[Mention, ...]:
    """Everybody that the routines of an outline are about, each once, in order."""
    by_name: dict[str, Mention] = {}
    for leaf in _leaves(outline):
        for mention in leaf.mentions:
            by_name.setdefault(mention.name, mention)
    return tuple(by_name.values())
