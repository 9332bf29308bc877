"""Goals that are stated formally to outlines: names to entities, methods to their steps, and what is wrong with either in words."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from itertools import product

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.matching import did_you_mean, listed, quoted
from missiontree.authoring.methods.mention import Mention, UnclearError, title, topic
from missiontree.authoring.methods.method import RESPONDER, Method, MethodLibrary
from missiontree.authoring.methods.outline import Outline, Piece, StepError, fill, leaf_of, outline_of, restrict
from missiontree.authoring.reading import outcomes
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.entities import Speakers
from missiontree.authoring.reading.remarks import assumed, unused_words
from missiontree.authoring.reading.words import Word
from missiontree.authoring.stated_names import StatedNames, UnknownNameError
from missiontree.mission.brief import MissionBrief
from missiontree.mission.goal import Bond, Goal
from missiontree.mission.pattern import Form
from missiontree.mission.reason import Reason
from missiontree.mission.times import words_of_times
from missiontree.mission.tree import MUTUAL, LinkKind

LINKED: Mapping[Bond, tuple[LinkKind, bool]] = {
    "after": ("precedence", False),
    "until": ("until", True),
    "same_robot": ("same_robot", False),
    "different_robot": ("different_robot", False),
    "takes_over_from": ("hand_over", False),
}
"""The link of each field of a goal that names another goal, and whether it goes from the goal to the other."""
Bindings = dict[str, tuple[Mention, ...]]
Placed = tuple[Goal, list[Piece], Outline]


class _RefusedError(Exception):
    """A goal cannot be built; never leaves this file."""

    def __init__(self, reason: Reason) -> None:
        super().__init__(reason.message)
        self.reason = reason


@dataclass
class Statements:
    """
    Understands the goals of one mission.

    Parameters
    ----------
    brief
        The mission.
    library
        The mission methods.
    reading
        A line for each goal.
    troubles
        Why goals cannot be built.
    """

    brief: MissionBrief
    library: MethodLibrary
    reading: list[str] = field(default_factory=list)
    troubles: list[Reason] = field(default_factory=list)
    _placed: list[Placed] = field(default_factory=list)
    _assumptions: list[Reason] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._speakers = Speakers(self.brief.world, complete=self.brief.scene is not None)
        self._lexicon = Lexicon()
        self._names = StatedNames(self.brief, self._speakers, self._lexicon)
        self._methods = {method.id: method for method in self.library.methods}

    def understood(self, goal: Goal, place: str) -> outcomes.Goal:
        """
        What a goal of the mission asks for, as a clause in words would.

        Raises
        ------
        NobodyError
            If a method asks for a capability that no robot type has.
        """
        outline, first, line = Outline(), len(self._assumptions), len(self.reading)
        outline.pieces = self._pieces(goal, place, outline, alone=len(self.brief.goals) == 1)
        clause = Clause(words=(Word(goal.shown, goal.shown.lower()),))
        return outcomes.Goal(clause, outline, self.reading[line], tuple(self._assumptions[first:]))

    def linked(self) -> list[tuple[Piece, Piece, LinkKind]]:
        """Put the links among goals into their outlines; answers with them."""
        named = {goal.name: pieces for goal, pieces, _ in self._placed if goal.name}
        links: dict[tuple[Piece, Piece, LinkKind], None] = {}
        for goal, pieces, outline in self._placed:
            for bond, name in goal.bonds:
                kind, first = LINKED[bond]
                for other, own in product(named[name], pieces):
                    pair = (own, other, kind) if first else (other, own, kind)
                    if kind in MUTUAL and (pair[1], pair[0], kind) in links:
                        continue  # the other goal says the same
                    outline.link(*pair)
                    links[pair] = None
        return [*links]

    def timed(self) -> list[tuple[Goal, list[Piece]]]:
        """Goals with times, and their pieces."""
        return [(goal, pieces) for goal, pieces, _ in self._placed if words_of_times(goal.release_s, goal.deadline_s)]

    def _pieces(self, goal: Goal, place: str, outline: Outline, *, alone: bool) -> list[Piece]:
        """The pieces of a goal: a single one, unless it stands alone."""
        line = len(self.reading)
        self.reading.append("")
        label = goal.task
        try:
            if goal.task:
                shown = f"task {goal.task!r}, {goal.gate}"
                below = [
                    piece
                    for number, inner in enumerate(goal.goals, 1)
                    for piece in self._pieces(inner, f"{place}.{number}", outline, alone=len(goal.goals) == 1)
                ]
                pieces = [Piece(title(goal.task), pieces=_told_apart(below), gate=goal.gate)] if below else []
            elif goal.method:
                pieces, label, shown = self._by_method(goal, place, outline)
            else:
                pieces, shown = self._by_routine(goal, place)
            by = self._restricted(goal, place, pieces)
        except _RefusedError as refused:
            self.troubles.append(refused.reason)
            pieces, shown, by = [], f"not understood: {refused.reason.message}", ""
        times = "".join(f"; {words}" for words in words_of_times(goal.release_s, goal.deadline_s))
        self.reading[line] = shown if shown.startswith("not understood") else f"goal {place}: {shown}{by}{times}"
        if len(pieces) > 1 and not alone:
            pieces = [Piece(label, pieces=pieces)]
        self._placed.append((goal, pieces, outline))
        return pieces

    def _restricted(self, goal: Goal, place: str, pieces: list[Piece]) -> str:
        """Keep to the robot types that the goal allows; answers with how that reads."""
        if not (goal.by or goal.not_by):
            return ""
        asked = [kind.id for kind in self.brief.fleet.types if not goal.by or kind.id in goal.by]
        allowed = tuple(kind for kind in asked if kind not in goal.not_by)
        try:
            if not allowed:
                raise StepError("no robot type is left that may do it")
            restrict(pieces, allowed)
        except StepError as error:
            raise _refused("nobody_allowed", goal, place, str(error), "Allow more in by, or less in not_by.") from error
        return f"; only by {', '.join(goal.by)}" if goal.by else f"; not by {', '.join(goal.not_by)}"

    def _by_routine(self, goal: Goal, place: str) -> tuple[list[Piece], str]:
        routine = self.brief.routines.find(goal.routine)
        if routine is None:
            names = [known.id for known in self.brief.routines.routines]
            hint = f"{did_you_mean(goal.routine, names)} Routines are: {listed(names)}.".strip()
            raise _refused("unknown_routine", goal, place, f"there is no routine {quoted(goal.routine)}", hint)
        takes = [argument.name for argument in routine.arguments]
        if len(takes) != len(goal.arguments):
            detail = (
                f"routine {routine.id} takes {len(takes)} ({', '.join(takes)}), and {len(goal.arguments)} are named"
            )
            raise _refused("wrong_arguments", goal, place, detail, f"Write {routine.id}({', '.join(takes)}).")
        mentions = tuple(self._mention(name, goal, place) for name in goal.arguments)
        about = ", ".join(f"{name} = {mention.label}" for name, mention in zip(takes, mentions, strict=True))
        leaf = leaf_of(routine, mentions)
        self._refuse_itself([leaf], goal, place)
        return [leaf], f"routine {routine.id}; {about}"

    def _by_method(self, goal: Goal, place: str, outline: Outline) -> tuple[list[Piece], str, str]:
        method = self._methods.get(goal.method or "")
        if method is None:
            hint = f"{did_you_mean(goal.method or '', self._methods)} Methods are: {listed(self._methods)}.".strip()
            raise _refused("unknown_method", goal, place, f"there is no method {quoted(goal.method or '')}", hint)
        form = self._form(method, goal, place)
        order = [element.text for element in form if element.kind == "slot"]
        order += [slot for slot in goal.slots if slot not in order]
        topics = {slot for slot, conditions in method.where.items() if "topic" in conditions}
        said = {
            slot: tuple(
                topic(name) if slot in topics else self._mention(name, goal, place) for name in goal.filling(slot)
            )
            for slot in order
        }
        for slot, conditions in method.where.items():
            if slot in said and slot not in topics:
                self._check_condition(slot, conditions, said, goal, place)
        hazards = [hazard for name in goal.entities for hazard in self._names.hazards(name)]
        try:
            made = outline_of(method, self._completed(method, said, hazards), self.brief.routines, self.brief.fleet)
        except (StepError, UnclearError) as error:
            hint = "Mend the method, or use another."
            raise _refused("method_unfit", goal, place, str(error), hint) from error
        if not made.pieces:
            raise _refused(
                "method_unfit", goal, place, f"method {method.id} has nothing to do for them", "Leave it out."
            )
        self._refuse_itself(made.pieces, goal, place)
        outline.links += made.links
        told = dict.fromkeys(said, ())
        remarks = unused_words(made, told, said, self._lexicon, self.brief.world)
        dangers = {
            mention.label for group in said.values() for mention in group if self._names.is_hazard(mention.label)
        }
        self._assumptions += [remark for remark in remarks if remark.node not in dangers]
        self._assumptions += assumed(method, said)
        about = ", ".join(f"{slot} = {' and '.join(m.label for m in said[slot])}" for slot in said)
        return made.pieces, _worded(form, said), f"method {method.id}; {about}"

    def _form(self, method: Method, goal: Goal, place: str) -> Form:
        """The form of the method that has just the slots that are filled."""
        forms = [form for forms in method.forms for form in forms]
        slots = [[element.text for element in form if element.kind == "slot"] for form in forms]
        spoken = {name for step in method.all_steps for name in step.mentions}
        extra = {*method.implies, *({RESPONDER} & spoken)}
        known = list(dict.fromkeys(slot for each in slots for slot in each))
        given = set(goal.slots) - (extra - set(known))
        for slot in given:
            if slot not in known:
                hint = f"{did_you_mean(slot, (*known, *extra))} Slots are: {listed((*known, *sorted(extra)))}.".strip()
                raise _refused("unknown_slot", goal, place, f"method {method.id} has no slot {quoted(slot)}", hint)
        fitting = next((form for form, each in zip(forms, slots, strict=True) if set(each) == given), None)
        if fitting is not None:
            return fitting
        ways = ", or ".join(dict.fromkeys(" and ".join(each) for each in slots))
        detail = f"method {method.id} needs {ways}; filled is {' and '.join(sorted(given)) or 'nothing'}"
        raise _refused(
            "missing_slot", goal, place, detail, "Fill the slots of one of its patterns, no more and no less."
        )

    def _check_condition(self, slot: str, conditions: Iterable[str], said: Bindings, goal: Goal, place: str) -> None:
        """What a method asks of a slot, as the words of a mission are asked."""
        holds = (
            {"hazard"}
            if any(map(self._names.is_hazard, goal.filling(slot)))
            else {mention.kind for mention in said[slot]}
        )
        if any(mention.to_be_found for mention in said[slot]):
            holds.add("lost")
        if holds & set(conditions):
            return
        names = " and ".join(mention.label for mention in said[slot])
        detail = f"slot {slot} takes what is {' or '.join(conditions)}; {names} is {' and '.join(sorted(holds))}"
        hint = "Use another method, or declare the kind under entities: in the mission file or in the scene."
        raise _refused("condition_not_met", goal, place, detail, hint)

    def _completed(self, method: Method, said: Bindings, hazards: Iterable[str]) -> Bindings:
        """The slots with what the method implies, and those who are called for the hazards that are named."""
        complete = dict(said)
        for name, implied in method.implies.items():
            if name not in said:
                complete[name] = (self._speakers.implied(fill(implied.name, said), implied.kind, implied.known_as),)
        called = dict.fromkeys(str(self._lexicon.hazards[hazard]["responder"]) for hazard in hazards)
        complete.setdefault(RESPONDER, tuple(self._speakers.implied(name, "person") for name in called))
        return complete

    def _mention(self, written: str, goal: Goal, place: str) -> Mention:
        try:
            return self._names.mention(written)
        except UnknownNameError as unknown:
            raise _refused(unknown.rule, goal, place, unknown.detail, unknown.hint) from unknown

    def _refuse_itself(self, pieces: list[Piece], goal: Goal, place: str) -> None:
        """Nothing is brought to itself."""
        for leaf in (leaf for piece in pieces for leaf in piece.leaves):
            names = [mention.name for mention in leaf.mentions]
            if twice := next((m.label for m in leaf.mentions if names.count(m.name) > 1), ""):
                detail = f"{leaf.label} is about {twice} twice"
                raise _refused(
                    "same_entity_twice", goal, place, detail, "Name somebody or something else for one of them."
                )


def _refused(rule: str, goal: Goal, place: str, detail: str, hint: str) -> _RefusedError:
    called = f" ({goal.name})" if goal.name else ""
    message = f"Goal {place}{called}, {goal.shown[:200]!r}: {detail}."
    return _RefusedError(Reason(rule=rule, message=message, found=goal.shown[:200], hint=hint))


def _worded(form: Form, said: Bindings) -> str:
    """A method's goal as a label: ``Rescue Anna from Barn``."""
    words = (
        " and ".join(mention.label for mention in said[element.text])
        if element.kind == "slot"
        else element.text.split("|")[0]
        for element in form
        if element.kind != "doing"
    )
    return title(" ".join(words))


def _told_apart(pieces: list[Piece]) -> list[Piece]:
    """Tasks of one level, numbered where they are called the same."""
    seen: dict[str, int] = {}
    for piece in (piece for piece in pieces if piece.routine is None):
        label = piece.label
        seen[label] = seen.get(label, 0) + 1
        if seen[label] > 1:
            piece.label = f"{label} ({seen[label]})"
    return pieces
