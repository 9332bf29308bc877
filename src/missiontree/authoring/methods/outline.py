"""What is going to be built, before it is built: tasks and routines in order, and what links them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from missiontree.authoring.methods.mention import Mention, title
from missiontree.authoring.methods.method import Method, Step
from missiontree.mission.fleet import Fleet
from missiontree.mission.routine import Routine, RoutineLibrary
from missiontree.mission.tree import Gate, LinkKind

Bindings = Mapping[str, tuple[Mention, ...]]


@dataclass(eq=False)
class Piece:
    """A task with pieces below it, or a routine with its arguments; with its times."""

    label: str
    routine: Routine | None = None
    mentions: tuple[Mention, ...] = ()
    pieces: list[Piece] = field(default_factory=list)
    gate: Gate = "and"
    resources: tuple[str, ...] = ()
    release_s: float = 0.0
    deadline_s: float | None = None

    @property
    def leaves(self) -> Iterator[Piece]:
        """The routines of the piece, in order."""
        waiting = [self]
        while waiting:
            piece = waiting.pop()
            if piece.routine is not None:
                yield piece
            waiting.extend(reversed(piece.pieces))

    @property
    def call(self) -> tuple[str, tuple[str, ...], tuple[str, ...]]:
        """Routine, names and robots, for comparing."""
        assert self.routine is not None
        return self.routine.id, tuple(mention.name for mention in self.mentions), self.resources

    def finds(self, name: str, library: RoutineLibrary) -> bool:
        """Whether the routine searches for somebody."""
        assert self.routine is not None
        arguments = [argument.name for argument in self.routine.arguments]
        found = found_by(self.routine, library)
        return any(
            mention.name == name
            for argument, mention in zip(arguments, self.mentions, strict=False)
            if argument in found
        )

    def open_ended(self, library: RoutineLibrary) -> bool:
        """Whether a routine of the piece has no end of its own."""
        return any(_open_ended(leaf.routine, library) for leaf in self.leaves if leaf.routine is not None)


@dataclass
class Outline:
    """Pieces below the objective, and links among all pieces."""

    pieces: list[Piece] = field(default_factory=list)
    links: list[tuple[Piece, Piece, LinkKind]] = field(default_factory=list)

    @property
    def all_pieces(self) -> Iterator[Piece]:
        """All pieces, tasks before what they consist of."""
        waiting = list(reversed(self.pieces))
        while waiting:
            piece = waiting.pop()
            yield piece
            waiting.extend(reversed(piece.pieces))

    def link(self, first: Piece, second: Piece, kind: LinkKind = "precedence") -> None:
        """Link two pieces once."""
        if first is not second and (first, second, kind) not in self.links:
            self.links.append((first, second, kind))


class StepError(Exception):
    """A method's step cannot be built with these routines and robots; carries the sentence."""


class NobodyError(Exception):
    """No robot type has the capability that a method's step asks for."""

    def __init__(self, capability: str) -> None:
        super().__init__(f"no robot type has the capability {capability}")
        self.capability = capability


def outline_of(method: Method, bindings: Bindings, library: RoutineLibrary, fleet: Fleet) -> Outline:
    """
    The steps of a method with its slots filled. A step whose slot holds several is built for each of them; for none, it is left out.

    Raises
    ------
    StepError
        If a step names a routine that is not on offer, gives it the wrong number of arguments, or allows no robot type of the fleet.
    NobodyError
        If no robot type has the capability that a step asks for.
    """
    built = Outline()
    made: dict[int, list[Piece]] = {}  # by the step's identity: two steps may look alike
    steps = [step for step in method.all_steps if not _needless(step, bindings)]
    for step in reversed(steps):  # what a task consists of stands behind it, so it is made before the task
        made[id(step)] = _pieces(
            step, [piece for below in step.steps for piece in made.get(id(below), [])], bindings, library
        )
        if (allowed := _allowed(step, fleet)) is not None:
            restrict(made[id(step)], allowed)
    built.pieces = [piece for step in method.steps for piece in made.get(id(step), [])]
    standing = set(built.all_pieces)
    for pieces in made.values():  # what hangs below a step that is left out goes with it
        pieces[:] = [piece for piece in pieces if piece in standing]
    named = {step.name: _about(made[id(step)]) for step in steps if step.name}
    for step in steps:
        for piece in made[id(step)]:
            for earlier in step.after:
                for _, other in _alike(named.get(earlier, []), piece):
                    built.link(other, piece)
            for _, other in named.get(step.until, []):
                built.link(piece, other, "until")
    return built


def _needless(step: Step, bindings: Bindings) -> bool:
    """Whether a step only finds out what the scene knows."""
    spared = bindings[step.unless_known] if step.unless_known else ()
    return bool(step.unless_known) and all(mention.known and not mention.lost for mention in spared)


def _pieces(step: Step, below: list[Piece], bindings: Bindings, library: RoutineLibrary) -> list[Piece]:
    if step.do:
        return [_leaf(step, mentions, library) for mentions in _rows(step.arguments, bindings)]
    return [Piece(title(fill(step.task, bindings)), pieces=below, gate=step.gate)] if below else []


def _allowed(step: Step, fleet: Fleet) -> tuple[str, ...] | None:
    """The robot types that may do a step, in the order of the fleet; None if it allows all."""
    if not step.by and not step.capability:
        return None
    able = [kind.id for kind in fleet.types if not step.capability or step.capability in kind.capabilities]
    if not able:
        raise NobodyError(step.capability)
    allowed = tuple(kind for kind in able if not step.by or kind in step.by)
    if not allowed:
        needed = f", of which none has the capability {step.capability}" if step.capability else ""
        has = f"the fleet has {', '.join(kind.id for kind in fleet.types)}"
        raise StepError(f"the method allows only robot type {' or '.join(step.by)}{needed}; {has}")
    return allowed


def restrict(pieces: Iterable[Piece], allowed: tuple[str, ...]) -> None:
    """
    Let only these robot types do what the pieces ask for, of those that may do it so far.

    Raises
    ------
    StepError
        If that leaves none.
    """
    for leaf in (leaf for piece in pieces for leaf in piece.leaves):
        both = tuple(kind for kind in leaf.resources if kind in allowed) if leaf.resources else allowed
        if not both:
            sides = f"{' or '.join(leaf.resources)} on the one hand, {' or '.join(allowed)} on the other"
            raise StepError(f"no robot type may do {leaf.label}: allowed are {sides}")
        leaf.resources = both


def _about(pieces: list[Piece]) -> list[tuple[frozenset[str], Piece]]:
    """Each piece with the names of those it is about."""
    return [(frozenset(mention.name for leaf in piece.leaves for mention in leaf.mentions), piece) for piece in pieces]


def _leaf(step: Step, mentions: tuple[Mention, ...], library: RoutineLibrary) -> Piece:
    routine = library.find(step.routine)
    if routine is None:
        raise StepError(f"the method uses routine {step.routine}, which is not on offer")
    if len(routine.arguments) != len(mentions):
        raise StepError(
            f"the method gives routine {routine.id} {len(mentions)} arguments; it takes {len(routine.arguments)}"
        )
    return leaf_of(routine, mentions)


def leaf_of(routine: Routine, mentions: tuple[Mention, ...]) -> Piece:
    """A routine about somebody."""
    return Piece(f"{routine.id}({', '.join(mention.label for mention in mentions)})", routine, mentions)


def _rows(slots: tuple[str, ...], bindings: Bindings) -> Iterable[tuple[Mention, ...]]:
    """The arguments, once for each of several in a slot."""
    rows: list[tuple[Mention, ...]] = [()]
    for slot in slots:
        rows = [(*row, mention) for row in rows for mention in bindings[slot]]
    return rows


def _alike(named: list[tuple[frozenset[str], Piece]], piece: Piece) -> list[tuple[frozenset[str], Piece]]:
    """Of an earlier step built several times, the pieces that are about the same as this one; all if none is."""
    about = {mention.name for leaf in piece.leaves for mention in leaf.mentions}
    same = [entry for entry in named if entry[0] & about]
    return same or named


def fill(template: str, bindings: Bindings) -> str:
    """The template with its slots filled: ``{lost}``, ``{the lost}``, ``{full lost}``, ``{the full lost}``."""
    for slot, mentions in bindings.items():
        for form in ("", "the ", "full ", "the full "):
            if f"{{{form}{slot}}}" in template:
                words = [m.full if "full" in form else m.label for m in mentions]
                texts = [
                    f"the {word}" if "the" in form and m.determined else word
                    for word, m in zip(words, mentions, strict=True)
                ]
                template = template.replace(f"{{{form}{slot}}}", " and ".join(texts))
    return template


def found_by(routine: Routine, library: RoutineLibrary) -> frozenset[str]:
    """Arguments whose position is known once the routine is done, its parts included."""
    found: set[str] = set()
    waiting = [(routine, {argument.name: argument.name for argument in routine.arguments})]
    while waiting:
        inner, outer_name = waiting.pop()
        steps = (step for branch in inner.branches for role in branch.roles for step in role.actions)
        found |= {outer_name[step.finds] for step in steps if step.finds is not None}
        for part in inner.parts:
            below = library.by_id[part.routine]
            renamed = {a.name: outer_name[part.arguments.get(a.name, a.name)] for a in below.arguments}
            waiting.append((below, renamed))
    return frozenset(found)


def _open_ended(routine: Routine, library: RoutineLibrary) -> bool:
    waiting = [routine]
    seen: set[str] = set()
    while waiting:
        inner = waiting.pop()
        if inner.id in seen:
            continue
        seen.add(inner.id)
        if any(step.open_ended for branch in inner.branches for role in branch.roles for step in role.actions):
            return True
        waiting += [library.by_id[part.routine] for part in inner.parts]
    return False
