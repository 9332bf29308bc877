"""A mission tree to a mission method: whom the mission names become slots, and what is done with them stays."""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.learning.habits import served_goals
from missiontree.authoring.learning.merging import Merged
from missiontree.authoring.learning.spotting import HAZARD, Named, slot_name
from missiontree.authoring.matching import words_of
from missiontree.authoring.methods.method import RESPONDER, Implied, Method, Step
from missiontree.authoring.methods.outline import found_by, leaf_of
from missiontree.authoring.reading.clause import Clause
from missiontree.errors import InputError
from missiontree.mission.entity import Entity
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.tree import MissionNode, MissionTree

SAYS = "Give a pattern of one clause by --says, such as --says 'rescue {person} from {place}'."
_FIELD = re.compile(r"\{(?:the )?(?:full )?([^{}]*)\}")
_REPEATED = re.compile(r"(\{[^{}]*\})(?:(?:,| and|, and) \1)+")
_NOT_LITERAL = frozenset("<>{}()[]|")


@dataclass(frozen=True, slots=True, kw_only=True)
class Lesson:
    """
    What a method is learned from.

    Parameters
    ----------
    tree
        The mission tree; it passes the finish gate.
    scene
        The world, with the entities that the tree introduces.
    routines
        The routines that the tree names.
    named
        Whom the mission names, with their slots.
    called
        Who is called for the hazards that the mission names, in small letters.
    asked
        Robot types to which the words of the mission keep, which are no part of the method.
    able
        Robot types by each capability that methods with the same goal ask for.
    calls
        Whether somebody shall be called for hazards, though this mission names none.
    """

    tree: MissionTree
    scene: Scene
    routines: RoutineLibrary
    named: tuple[Named, ...]
    called: frozenset[str] = frozenset()
    asked: frozenset[str] = frozenset()
    able: Mapping[str, frozenset[str]] = field(default_factory=dict)
    calls: bool = False


def learned(lesson: Lesson, says: str, method_id: str, purpose: str) -> Method:
    """
    The method of a tree.

    Parameters
    ----------
    lesson
        The tree, and whom the mission names.
    says
        The pattern.
    method_id, purpose
        What the method is called and for.

    Raises
    ------
    InputError
        If the tree holds what no method can say.
    """
    pupil = _Pupil(lesson)
    steps = pupil.steps()
    try:
        return Method(
            id=method_id,
            purpose=purpose,
            says=(says,),
            where={one.slot: one.conditions for one in lesson.named if f"{{{one.slot}}}" in says},
            implies=pupil.implies,
            steps=steps,
        )
    except ValueError as error:
        message = f"no method can be made of it: {str(error).rstrip('.')}"
        raise InputError(message, accepted="a pattern that names everybody in --says once", hint=SAYS) from error


def pattern_of(clause: Clause, named: Sequence[Named], lexicon: Lexicon) -> str:
    """
    The pattern of a clause: its verb, then its words with a slot for everybody who is named.

    The verb becomes ``<goal>`` if the lexicon knows it in that one sense alone, and what is built in serves that: verbs that a routine of
    the user's own brings along may ask for the opposite, as *switch on* and *switch off* do.

    Raises
    ------
    InputError
        If it cannot be written as a pattern.
    """
    for one, two in pairwise(named):
        between = clause.words[one.end : two.start]
        if all(word.low in lexicon.words["determiners"] for word in between):
            names = f"{one.mention.label} and {two.mention.label}"
            message = f"nothing stands between {names} in {clause.text!r}; between two slots of a pattern stands a word"
            raise InputError(message, hint=f"Word the mission otherwise, as in 'bring the keys to Anna'. {SAYS}")
    parts: list[str] = []
    start = 0
    if clause.verb is not None:
        goals = lexicon.goals_of.get(clause.verb.phrase, ())
        parts.append(f"<{goals[0]}>" if len(goals) == 1 and goals[0] in served_goals() else clause.verb.phrase)
        start = clause.verb.length
    by_start = {one.start: one for one in named}
    while start < len(clause.words):
        here = by_start.get(start)
        parts.append(f"{{{here.slot}}}" if here is not None else clause.words[start].low)
        start = here.end if here is not None else start + 1
    strange = [part for part in parts if part[0] not in "<{" and _NOT_LITERAL & set(part)]
    if strange:
        raise InputError(f"the mission has the sign {strange[0]!r}, which means something else in a pattern", hint=SAYS)
    return " ".join(parts)


@dataclass
class _Pupil:
    """Walks over the tree."""

    lesson: Lesson
    implies: dict[str, Implied] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._slot_of = {mention.name: one.slot for one in self.lesson.named for mention in one.mentions}
        self._by_slot = {one.slot: one for one in self.lesson.named}
        self._fields = list(self._fields_of())
        for node in self._leaves():
            for entity_id in node.arguments.values():
                if entity_id not in self._slot_of:
                    self._slot_of[entity_id] = self._implied(self.lesson.scene.by_id[entity_id])
        self._fields += [
            (words_of(self.lesson.scene.by_id[entity_id].label), slot)
            for entity_id, slot in self._slot_of.items()
            if slot in self.implies
        ]
        self._listed = frozenset(slot for slot, one in self._by_slot.items() if one.others)
        listed = [entity for entity, slot in self._slot_of.items() if slot in self._listed or self._is_of_listed(slot)]
        self._merged = Merged(self.lesson.tree, self._sign, frozenset(listed))
        self._names: dict[str, str] = {}
        self._after: dict[str, list[str]] = {}
        self._until: dict[str, str] = {}
        self._read_links()

    def steps(self) -> tuple[Step, ...]:
        """What the method builds below the objective."""
        root = self.lesson.tree.root
        made = self._below(root, certain=root.gate == "and")
        if root.gate == "xor" and len(made) > 1:
            made = (Step(task=self._filled(root.label) or "Do one of these", gate="xor", steps=made),)
        return (Step(do=f"Search({RESPONDER})"), *made) if self.lesson.calls else made

    def _below(self, node: MissionNode, *, certain: bool) -> tuple[Step, ...]:
        """The steps of a task; an option of a choice is a task, so that it stays one option if its slots hold several."""
        tree = self.lesson.tree
        made = [self._step(tree.by_id[child], certain=certain) for child in self._merged.children[node.id]]
        if node.gate != "xor" or len(made) < 2:
            return tuple(made)
        return tuple(self._option(step) if step.do and self._may_be_several(step) else step for step in made)

    def _option(self, step: Step) -> Step:
        """A routine as a task of its own."""
        words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", step.routine).capitalize()
        label = f"{words} {', '.join(f'{{the {slot}}}' for slot in step.arguments)}"
        inner = replace(step, name="", after=(), until="")
        return Step(task=label, name=step.name, after=step.after, until=step.until, steps=(inner,))

    def _may_be_several(self, step: Step) -> bool:
        return any(slot not in self.implies or _FIELD.search(self.implies[slot].name) for slot in step.arguments)

    def _is_of_listed(self, slot: str) -> bool:
        """Whether it is implied once for each of a list: the people of the school, and those of the hospital."""
        return slot in self.implies and bool(self._listed & set(_FIELD.findall(self.implies[slot].name)))

    def _sign(self, node: MissionNode) -> Hashable:
        """What a node comes to, what is below it aside."""
        if node.routine is None:
            return node.gate, self._filled(node.label)
        return node.routine, self._arguments(node), node.resources, self._unless_known(node)

    def _leaves(self) -> Iterator[MissionNode]:
        return (node for node in self.lesson.tree.nodes if node.routine is not None)

    def _implied(self, entity: Entity) -> str:
        """The name that steps use for somebody whom the mission does not name."""
        if entity.label.lower() in self.lesson.called and RESPONDER not in self._slot_of.values():
            return RESPONDER
        label = self._filled(entity.label)
        for name, known in self.implies.items():
            several = (one.slot for one in self.lesson.named if one.others)
            if known.name == label and set(_FIELD.findall(label)) & set(several):
                return name  # a method implies it once for each in the slot
        name = slot_name(_FIELD.sub(r"\1", label), (*self._slot_of.values(), *self.implies))
        base = self.lesson.scene.base_kind(entity.kind)
        self.implies[name] = Implied(name=label, kind=base, known_as=entity.aliases)  # type: ignore[arg-type]
        return name

    def _fields_of(self) -> Iterator[tuple[tuple[str, ...], str]]:
        """What labels may hold of those named, as words, and the slot that stands for it."""
        for one in self.lesson.named:
            for mention in one.mentions:
                full = words_of(mention.full)
                yield full, f"full {one.slot}" if full != words_of(mention.label) else one.slot
                entity = self.lesson.scene.by_id.get(mention.name)
                spellings = (entity.label, *entity.aliases) if entity is not None else ()
                for spelling in (mention.label, *spellings):
                    if words_of(spelling) and words_of(spelling) != full:
                        yield words_of(spelling), one.slot

    def _filled(self, label: str) -> str:
        """A label with slots for those whom it names."""
        words, made = label.split(), []
        place = 0
        while place < len(words):
            hit = self._field_at(words, place)
            if hit is None:
                made.append("".join(sign for sign in words[place] if sign not in "{}"))
                place += 1
                continue
            slot, width = hit
            article = made[-1:] in (["the"], ["The"])
            if article:
                made.pop()
            tail = _sign_behind(words[place + width - 1])
            made.append(f"{{{'the ' if article else ''}{slot}}}{tail}")
            place += width
        return _REPEATED.sub(r"\1", " ".join(made))

    def _field_at(self, words: Sequence[str], place: int) -> tuple[str, int] | None:
        """Who is named at a place, in the most words, and how many those are."""
        fitting = [
            (slot, len(wanted))
            for wanted, slot in self._fields
            if tuple(word for part in words[place : place + len(wanted)] for word in words_of(part)) == wanted
        ]
        return max(fitting, key=lambda hit: hit[1], default=None)

    def _read_links(self) -> None:
        for link in self.lesson.tree.links:
            if link.kind in {"same_robot", "different_robot", "hand_over"}:
                kind = link.kind.replace("_", "-")
                message = f"the tree has a {kind} link, from {link.first!r} to {link.second!r}, and a method has no such links"
                raise InputError(message, hint="Leave that link out of the tree, or compose a routine that has it.")
            first, second = (self._merged.stands_for[end] for end in (link.first, link.second))
            if link.kind == "until":
                name = self._name(second)
                if self._until.setdefault(first, name) != name:
                    message = f"{link.first!r} lasts until two others end; a step of a method lasts until one"
                    raise InputError(message, hint="Put what it lasts for below one task.")
            elif first != second and self._name(first) not in self._after.setdefault(second, []):
                self._after[second].append(self._name(first))

    def _name(self, node_id: str) -> str:
        """What other steps call a node: as it is labelled, with slots for names."""
        if node_id not in self._names:
            node = self.lesson.tree.by_id[node_id]
            shown = f"{node.routine} {' '.join(self._arguments(node))}" if node.routine else self._filled(node.label)
            self._names[node_id] = slot_name(_FIELD.sub(r"\1", shown), tuple(self._names.values()))
        return self._names[node_id]

    def _step(self, node: MissionNode, *, certain: bool) -> Step:
        name, until = self._names.get(node.id, ""), self._until.get(node.id, "")
        after = tuple(self._after.get(node.id, ()))
        if node.routine is not None:
            call = f"{node.routine}({', '.join(self._arguments(node))})"
            by, capability = self._robots(node)
            spare = self._unless_known(node) if certain and not after else ""
            return Step(do=call, name=name, after=after, until=until, by=by, capability=capability, unless_known=spare)
        below = self._below(node, certain=certain and node.gate == "and")
        gate = node.gate or "and"
        return Step(task=self._filled(node.label), gate=gate, steps=below, name=name, after=after, until=until)

    def _robots(self, node: MissionNode) -> tuple[tuple[str, ...], str]:
        """Robot types that a routine keeps to, or the capability for which it does; nothing if the words of the mission say so."""
        allowed, asked = frozenset(node.resources or ()), self.lesson.asked
        for capability, able in self.lesson.able.items():
            if allowed and allowed == (able & asked if asked else able):
                return (), capability
        return () if allowed == asked else node.resources or (), ""

    def _arguments(self, node: MissionNode) -> tuple[str, ...]:
        routine = self.lesson.routines.by_id[node.routine or ""]
        return tuple(self._slot_of[node.arguments[argument.name]] for argument in routine.arguments)

    def _unless_known(self, node: MissionNode) -> str:
        """
        The slot of a search that may be left out where the scene knows more than this one does.

        Only of one that waits for nothing, since an order that leads through it would be lost; and only if there is more to be done.
        """
        routine = self.lesson.routines.by_id[node.routine or ""]
        if len(node.arguments) != 1 or not found_by(routine, self.lesson.routines):
            return ""
        if leaf_of(routine, ()).open_ended(self.lesson.routines):
            return ""
        (who,) = node.arguments.values()
        slot = self._by_slot.get(self._slot_of[who])
        others = any(who in other.arguments.values() for other in self._leaves() if other is not node)
        if slot is None or slot.kind in {HAZARD, "place"} or "lost" in slot.conditions or not others:
            return ""
        known = self.lesson.scene.whereabouts(self.lesson.scene.by_id[who]).source == "known"
        return "" if known else slot.slot


def _sign_behind(word: str) -> str:
    """The comma or the like that a word ends with."""
    return word[-1] if word[-1:] in {",", ";", ":", "."} else ""
