"""What is told about a clause that was understood: how it was read, and which of its words the plan makes no use of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.methods.mention import Mention
from missiontree.authoring.methods.method import Method
from missiontree.authoring.methods.outline import Outline, fill
from missiontree.authoring.reading.candidates import Candidate
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.phrase import Phrase
from missiontree.authoring.reading.places import place_said, stands_at
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene

Read = Mapping[str, tuple[Phrase, ...]]
Said = Mapping[str, tuple[Mention, ...]]


def reading_line(candidate: Candidate, clause: Clause, read: Read, said: Said) -> str:
    """How a clause was read, in one line."""
    slots = ", ".join(
        f"{slot} = {' and '.join(phrase.text for phrase in phrases)} ({', '.join(m.label for m in said[slot])})"
        for slot, phrases in read.items()
    )
    by = f"; only by {', '.join(clause.robots)}" if clause.robots else ""
    by += f"; not by {', '.join(clause.without)}" if clause.without else ""
    over = f"; passed over: {', '.join(clause.passed_over)}" if clause.passed_over else ""
    return f"{clause.text!r}: {candidate.source}, {candidate.shown}; {slots}{by}{over}"


def assumed(method: Method | None, said: Said) -> Iterator[Reason]:
    """What a method takes for granted, in its own words."""
    if method is not None and method.assumes:
        about = next((mention.label for group in said.values() for mention in group), "")
        yield Reason(rule="method_assumes", message=fill(method.assumes, said), severity="assumption", node=about)


def unused_words(outline: Outline, read: Read, said: Said, lexicon: Lexicon, scene: Scene) -> Iterator[Reason]:
    """Assumptions about descriptions and people that do not change the plan, and about groups."""
    used = {mention.name for piece in outline.pieces for leaf in piece.leaves for mention in leaf.mentions}
    for slot, phrases in read.items():
        for phrase in phrases:
            if phrase.description and not (phrase.lost or _is_used(phrase.description, said[slot], lexicon, scene)):
                message = f"{phrase.description!r} is taken to describe {phrase.name}; the plan makes no use of it."
                yield Reason(rule="description_unused", message=message, severity="assumption", node=phrase.name)
            for choice in (state for state in phrase.states if state in lexicon.words["choosing"]):
                message = f"{choice!r} does not choose among several {phrase.name}s; the plan makes no use of it."
                yield Reason(rule="description_unused", message=message, severity="assumption", node=phrase.name)
        for mention in said[slot]:
            shown = any(mention.label in piece.label for piece in outline.pieces)
            if (
                mention.name not in used
                and not shown
                and not lexicon.hazards_in(mention.label.lower().split())  # it called for somebody
                and not any(name.endswith(f" of {mention.label}") for name in used)
            ):
                message = f"{mention.label} does not change what is planned."
                yield Reason(rule="words_unused", message=message, severity="assumption", node=mention.label)
            elif mention.plural and mention.new:
                yield _as_one(mention)


def _as_one(mention: Mention) -> Reason:
    return Reason(
        rule="planned_as_one",
        message=f"{mention.label} are planned for as one group.",
        severity="assumption",
        node=mention.label,
        hint="Declare each of them in the scene if they are to be planned for one by one.",
    )


def _is_used(description: str, mentions: tuple[Mention, ...], lexicon: Lexicon, scene: Scene) -> bool:
    """Whether the description says that somebody is lost, names a hazard, or says where the scene has them."""
    lows = description.lower().split()
    if lows[0] in lexicon.words["lost"] or lexicon.hazard_words.within(lows):
        return True
    place = place_said(description, scene)
    known = [scene.by_id.get(mention.name) for mention in mentions]
    return place is not None and all(entity is not None and stands_at(entity, place, scene) is True for entity in known)
