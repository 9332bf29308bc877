"""What follows from who is lost, and from what is brought back: a search that nobody asked for, and an order that nobody said."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.authoring.composing.composition import EVENTS, Composition, leaves
from missiontree.authoring.composing.options import Options
from missiontree.authoring.composing.standing import StandingOrder
from missiontree.authoring.methods.mention import Mention
from missiontree.authoring.methods.outline import Outline, Piece, found_by, leaf_of
from missiontree.authoring.reading.outcomes import Goal
from missiontree.mission.reason import Reason
from missiontree.mission.routine import Routine, RoutineLibrary


def search_once(goals: Sequence[Goal], library: RoutineLibrary, made: Composition) -> None:
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
        if goal.clause.relation in EVENTS and all(leaf.call in finders for leaf in leaves):
            continue  # "when both are found" asks for nothing new
        for leaf in leaves:
            if not _only_finds(leaf, library):
                continue
            earlier = finders.get(leaf.call)
            if earlier is None or len(leaves) == 1 or earlier in leaves:
                finders.setdefault(leaf.call, leaf)
                continue
            gone = _taken_out(goal.outline.pieces, leaf)
            kept = dict.fromkeys(gone, earlier)
            goal.outline.links[:] = [
                (kept.get(first, first), kept.get(second, second), kind) for first, second, kind in goal.outline.links
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


def search_first(goals: Sequence[Goal], library: RoutineLibrary, made: Composition) -> None:
    """A search for everybody who is lost, who is used, and whom nobody searches for."""
    everything = list(leaves(made.outline))
    search = next(
        (r for r in library.routines if len(r.arguments) == 1 and found_by(r, library) and not _lasts(r, library)), None
    )
    lost = dict.fromkeys(mention.name for leaf in everything for mention in leaf.mentions if mention.to_be_found)
    added, options = 0, Options(made.outline)
    for name in lost:
        users = [leaf for leaf in everything if any(m.name == name for m in leaf.mentions)]
        users = [leaf for leaf in users if not _is_found_for(leaf, name, everything, library, options)]
        if search is None or not users:
            continue
        mention = next(m for leaf in everything for m in leaf.mentions if m.name == name and m.to_be_found)
        finder = leaf_of(search, (mention,))
        finder.resources = _standing_for(name, goals)
        if not _found_in_option(made.outline, users, finder):
            made.outline.pieces.insert(added, finder)
            added += 1
        options = Options(made.outline)
        why = "is said to be lost" if mention.lost else "is at an unknown position"
        message = f"{finder.label} was added: {mention.label} {why}."
        made.notices.append(Reason(rule="search_added", message=message, severity="notice", node=mention.name))


def _is_found_for(
    user: Piece, name: str, everything: Sequence[Piece], library: RoutineLibrary, options: Options
) -> bool:
    """Whether somebody is searched for whenever a leaf is done: by it, or by one that no choice takes away alone."""
    finders = [leaf for leaf in everything if leaf.finds(name, library)]
    return any(finder is user or options.done_with(finder, user) for finder in finders)


def _standing_for(name: str, goals: Sequence[Goal]) -> tuple[str, ...]:
    """Robot types that the mission allows in all that is done with somebody; none for no restriction."""
    about = [goal.standing for goal in goals if goal.standing and any(m.name == name for m in _mentioned(goal))]
    both = tuple(kind for kind in about[0] if all(kind in types for types in about)) if about else ()
    return both or (about[0] if about else ())


def _mentioned(goal: Goal) -> list[Mention]:
    return [mention for piece in goal.outline.pieces for leaf in piece.leaves for mention in leaf.mentions]


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


def brought_before_returned(goals: Sequence[Goal], made: Composition) -> None:
    """What is brought back is brought away before, if no order is said."""
    order = StandingOrder(made.outline)
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


def found_before_used(library: RoutineLibrary, made: Composition) -> None:
    """Who is searched for is found before anything else is done with them, if no order is said."""
    everything = list(leaves(made.outline))
    order, options = StandingOrder(made.outline), Options(made.outline)
    for finder in (leaf for leaf in everything if leaf.routine is not None and found_by(leaf.routine, library)):
        for user in everything:
            if not {m.name for m in finder.mentions} & {m.name for m in user.mentions}:
                continue
            if (
                finder is user
                or not _shared(finder, user, library)
                or options.exclude(finder, user)
                or order.between(finder, user)
            ):
                continue
            made.implied.append((finder, user))
            order.add(finder, user)
            message = f"{finder.label} goes before {user.label}, though no order was said."
            made.notices.append(Reason(rule="order_added", message=message, severity="notice", node=user.label))


def _shared(finder: Piece, user: Piece, library: RoutineLibrary) -> bool:
    names = {mention.name for mention in user.mentions if finder.finds(mention.name, library)}
    return any(not user.finds(name, library) for name in names)


def _only_finds(leaf: Piece, library: RoutineLibrary) -> bool:
    assert leaf.routine is not None
    return (
        len(leaf.routine.arguments) == 1 and bool(found_by(leaf.routine, library)) and not _lasts(leaf.routine, library)
    )


def _lasts(routine: Routine, library: RoutineLibrary) -> bool:
    return leaf_of(routine, ()).open_ended(library)
