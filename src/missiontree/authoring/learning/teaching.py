"""A mission tree from anywhere becomes a mission method, and is tried on the mission it was learned from before it is handed out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from missiontree.authoring.findings import gate
from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.learning.habits import habits_of
from missiontree.authoring.learning.lesson import SAYS, Lesson, learned, pattern_of
from missiontree.authoring.learning.likeness import difference
from missiontree.authoring.learning.lists import lists_joined
from missiontree.authoring.learning.spotting import Named, Spotter, slot_name, with_slots
from missiontree.authoring.matching import listed, quoted, words_of
from missiontree.authoring.methods.mention import Mention
from missiontree.authoring.methods.method import Method, MethodLibrary, built_in_methods
from missiontree.authoring.offline import author_offline, clauses_read
from missiontree.authoring.reading.clause import MAX_CLAUSE_WORDS, Clause
from missiontree.errors import InputError
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.pattern import Form, forms_of
from missiontree.mission.times import words_of_times
from missiontree.mission.tree import MissionTree

MAX_ROUTINES = 200


def method_from(
    tree: MissionTree, brief: MissionBrief, methods: MethodLibrary, method_id: str = "", says: str = ""
) -> Method:
    """
    The method that does with others what a tree does.

    Parameters
    ----------
    tree
        The tree, by whatever author.
    brief
        The mission that it is for.
    methods
        The methods there are.
    method_id
        What the method is called; default: ``learned_`` and the verb of the mission.
    says
        Its pattern; default: the words of the mission.

    Raises
    ------
    InputError
        If no method can be made of it, or the method does not give that tree again; or if the id is that of a built-in one.
    """
    _refuse_built_in(method_id)
    _refuse_unfit(tree, brief)
    brief = replace(brief, goals=())
    lessons = _Lessons(tree, brief, methods)
    tried: list[str] = []
    ways = lessons.by_hand(says) if says else lessons.by_words()
    for lesson, pattern, text in ways:
        name = method_id or _name(pattern)
        method = learned(lesson, pattern, name, f"Learned from {_one_line(tree.objective)}")
        if not (why := _fails(method, replace(brief, text=text), tree, methods)):
            return method
        tried.append(why)
    hint = SAYS if not says else "Give another pattern, or change the tree."
    raise InputError(f"the method that was learned does not give the tree again: {tried[0]}", hint=hint)


def _refuse_built_in(method_id: str) -> None:
    """A method of the user's takes the place of a built-in one of its id, which nobody means who learns one."""
    built_in = next((method for method in built_in_methods().methods if method.id == method_id), None)
    if built_in is not None:
        message = (
            f"{method_id!r} is the id of a built-in method ({built_in.purpose.rstrip('.')}), which would be replaced"
        )
        raise InputError(message, hint=f"Give another id (--as ID), such as {f'my_{method_id}'!r}.")


def _refuse_unfit(tree: MissionTree, brief: MissionBrief) -> None:
    leaves = [node for node in tree.nodes if node.routine is not None]
    if not leaves:
        hint = "Give the plan of a mission that was understood, or a finished tree."
        raise InputError("the tree has no routine, so there is nothing to be learned", hint=hint)
    if faults := gate(tree, brief):
        raise InputError(f"the tree is not finished: {faults[0].message}", hint=faults[0].hint)
    if timed := [node for node in tree.nodes if words_of_times(node.release_s, node.deadline_s)]:
        times = ", ".join(words_of_times(timed[0].release_s, timed[0].deadline_s))
        raise InputError(
            f"{timed[0].label!r} has times ({times}), and a method has none",
            hint="Learn from the tree without its times, and state them as goals.",
        )
    if len(leaves) > MAX_ROUTINES:
        hint = "Learn from a tree of one part of the mission."
        raise InputError(f"the tree has {len(leaves)} routines", accepted=f"at most {MAX_ROUTINES}", hint=hint)


@dataclass(frozen=True)
class _Lessons:
    """The ways in which a tree and its mission can be understood as a method."""

    tree: MissionTree
    brief: MissionBrief
    methods: MethodLibrary

    def by_words(self) -> Iterator[tuple[Lesson, str, str]]:
        """The lesson, the pattern and the text to try it on, for each way to read the mission's own words."""
        clause, spotter, lexicon = self._read()
        if several := spotter.several(clause):
            message = f"{quoted(several)} names several at once, and it cannot be seen which of them is meant where"
            hint = f"Learn from a mission that names one: its slot may then hold several. {SAYS}"
            raise InputError(message, hint=hint)
        refused: InputError | None = None
        told = False
        for named in spotter.readings(clause):
            if not any(one.used for one in named):
                continue
            told = True
            try:
                joined = with_slots(lists_joined(named, clause.words, self.tree))
                pattern = pattern_of(clause, joined, lexicon)
                _checked(pattern)
                yield self._lesson(joined, spotter, clause, pattern), pattern, self.brief.text
            except InputError as error:
                refused = refused or error
        if not told:
            entities = ", ".join(entity.label for entity in self._entities())
            message = (
                f"the mission {quoted(self.brief.text)} names nobody and nothing that the tree is about ({entities})"
            )
            raise InputError(message, hint=SAYS)
        if refused is not None:
            raise refused

    def by_hand(self, says: str) -> Iterator[tuple[Lesson, str, str]]:
        """The same for a pattern that is given by hand, whose slots are called as the entities are, or as they would be."""
        slots = _checked(says)
        known = self._slots()
        if unknown := [slot for slot in slots if slot not in known]:
            names = listed(f"{{{slot}}} for {one.mention.label}" for slot, one in known.items())
            raise InputError(f"--says has a slot {{{unknown[0]}}} that stands for nobody in the tree", accepted=names)
        if not slots:
            raise InputError("--says has no slot, so the method would be about nobody else", accepted="{a_slot}")
        _, spotter, lexicon = self._read(any_clauses=True)
        lost = self._lost(spotter)
        named = tuple(replace(known[slot], slot=slot, mention=_lost_if(known[slot].mention, lost)) for slot in slots)
        lesson = self._lesson(named, spotter, None, says)
        yield lesson, says, self.brief.text
        yield lesson, says, _spoken(forms_of(says)[0], named, lexicon)

    def _read(self, *, any_clauses: bool = False) -> tuple[Clause, Spotter, Lexicon]:
        reader, clauses = clauses_read(self.brief, self.methods)
        if not any_clauses and len(clauses) != 1:
            parts = "; ".join(quoted(clause.text) for clause in clauses[:4]) or "none"
            message = f"the mission has {len(clauses)} parts ({parts}); a method is learned from one"
            raise InputError(message, hint=f"Learn from a mission of one part. {SAYS}")
        if not any_clauses and len(clauses[0].words) > MAX_CLAUSE_WORDS:
            message = f"the mission has {len(clauses[0].words)} words without an end"
            raise InputError(message, accepted=f"at most {MAX_CLAUSE_WORDS}", hint=SAYS)
        used = frozenset(entity.id for entity in self._entities())
        spotter = Spotter(
            scene=reader.hearing.brief.world,
            complete=self.brief.scene is not None,
            used=used,
            names=tuple(words_of(entity.label) for entity in self._entities()),
            introduced=self.tree.entities,
            phrases=reader.hearing.phrases,
            lexicon=reader.hearing.lexicon,
        )
        return (clauses[0] if clauses else Clause(words=())), spotter, reader.hearing.lexicon

    def _lost(self, spotter: Spotter) -> frozenset[str]:
        """Names of those whom the mission calls lost, or states to be."""
        reader, clauses = clauses_read(self.brief, self.methods)
        for clause in clauses:
            reader.read(clause)
        return spotter.lost(clauses) | reader.hearing.speakers.lost

    def _lesson(self, named: tuple[Named, ...], spotter: Spotter, clause: Clause | None, pattern: str) -> Lesson:
        words = self.brief.text.split() if clause is None else [word.low for word in clause.words]
        hazards = spotter.hazards(words)
        called = (str(spotter.lexicon.hazards[hazard]["responder"]) for hazard in hazards)
        habits = habits_of(pattern, self.methods, spotter.lexicon)
        search = self.brief.routines.find("Search")
        asked = frozenset[str]()
        if clause is not None and (clause.robots or clause.without):
            types = [kind.id for kind in self.brief.fleet.types if not clause.robots or kind.id in clause.robots]
            asked = frozenset(kind for kind in types if kind not in clause.without)
        return Lesson(
            tree=self.tree,
            scene=self.brief.world.extended(self.tree.entities),
            routines=self.brief.routines,
            named=named,
            called=frozenset(name.lower() for name in called),
            asked=asked,
            able={
                capability: frozenset(kind.id for kind in self.brief.fleet.types if capability in kind.capabilities)
                for capability in habits.capabilities
            },
            calls=habits.calls and not hazards and search is not None and len(search.arguments) == 1,
        )

    def _entities(self) -> list[Entity]:
        """Those whom the tree is about, each once, in its order."""
        world = self.brief.world.extended(self.tree.entities)
        ids = dict.fromkeys(entity for node in self.tree.nodes for entity in node.arguments.values())
        return [world.by_id[entity] for entity in ids]

    def _slots(self) -> dict[str, Named]:
        """What a slot of a pattern by hand may be called: as an entity is, by id or label, or by its kind."""
        world = self.brief.world.extended(self.tree.entities)
        found: dict[str, Named] = {}
        by_kind: dict[str, list[Named]] = {}
        for entity in self._entities():
            base = world.base_kind(entity.kind)
            common = kind_of(entity.label) is not None
            mention = Mention(entity.id, entity.label, entity.label, base, determined=common)
            one = Named(0, 0, mention, base, used=True, slot=slot_name(entity.label, found))
            found[one.slot] = one
            by_kind.setdefault(base, []).append(one)
        for entity_named in list(found.values()):
            found.setdefault(slot_name(entity_named.mention.name), entity_named)
        for kind, alike in by_kind.items():
            if len(alike) == 1:
                found.setdefault(kind, alike[0])
        return found


def _lost_if(mention: Mention, lost: frozenset[str]) -> Mention:
    """Somebody who is lost if one of their names is among those."""
    return (
        replace(mention, lost=True, full=f"Lost {mention.label}") if lost & {mention.name, mention.label} else mention
    )


def _checked(pattern: str) -> tuple[str, ...]:
    """The slots of a pattern."""
    try:
        forms = forms_of(pattern)
    except ValueError as error:
        raise InputError(str(error).rstrip("."), hint=SAYS) from error
    return tuple(dict.fromkeys(element.text for form in forms for element in form if element.kind == "slot"))


def _fails(method: Method, brief: MissionBrief, tree: MissionTree, methods: MethodLibrary) -> str:
    """Why the method does not give the tree again when the mission is planned with it; empty if it does."""
    others = tuple(other for other in methods.methods if other.id != method.id)
    made = author_offline(brief, MethodLibrary(methods=(method, *others)))
    if made.status != "complete" or made.tree is None:
        return made.reasons[0].message.rstrip(".") if made.reasons else "the mission is not understood"
    if not any(f": method {method.id}," in line for line in made.reading):
        return f"{quoted(brief.text)} is not understood by its pattern {quoted(method.says[0])}, but by another method"
    return difference(tree, made.tree, brief.world)


def _spoken(form: Form, named: Sequence[Named], lexicon: Lexicon) -> str:
    """A pattern as somebody would say it."""
    about = {one.slot: one.mention for one in named}
    words: list[str] = []
    for element in form:
        if element.kind == "slot":
            mention = about[element.text]
            lost = "the lost " if mention.lost else "the " if mention.determined else ""
            words.append(f"{lost}{mention.label.lower() if mention.determined else mention.label}")
        elif element.kind == "goal":
            words.append(next(iter(lexicon.phrases_of.get(element.text, ())), element.text))
        else:
            words.append(element.text.split("|")[0])
    return " ".join(words)


def _name(pattern: str) -> str:
    first = forms_of(pattern)[0][0].text.split("|")[0]
    return f"learned_{slot_name(first)}"


def _one_line(text: str) -> str:
    return f"{quoted(' '.join(text.split()))}."
