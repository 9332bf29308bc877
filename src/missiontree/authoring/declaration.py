"""
A model's declaration that a mission cannot be done, or is not clear, held against the fleet and a second reader.

Models decline what they could do about as readily as they try what nobody can. What a declaration names as missing is looked up: a
capability that a robot type has, a routine that somebody can do and an entity of the scene are not missing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.matching import listed, words_of
from missiontree.authoring.outcome import Authored
from missiontree.authoring.views import outline
from missiontree.mission.reason import Reason

Opinion = Callable[[], Authored]
"""What an author without a model makes of the mission; asked only if there is a doubt."""

DECLARATIONS = frozenset({"declareImpossible", "declareUnclear"})
SENT_BACK = "declaration_contradicted"
_EMPTY_WORDS = frozenset({"a", "an", "the", "capability", "ability", "to", "of", "routine", "robot", "skill", "no"})


class Declaration:
    """
    Looks a declaration over.

    Parameters
    ----------
    builder
        The tree under construction, with its fleet, routines and entities.
    opinion
        The second opinion; None if there is none to be had.
    """

    def __init__(self, builder: TreeBuilder, opinion: Opinion | None) -> None:
        self._builder, self._ask = builder, opinion
        self._opinion: Authored | None = None

    @property
    def opinion(self) -> Authored | None:
        """The second opinion, asked for once."""
        if self._opinion is None and self._ask is not None:
            self._opinion = self._ask()
        return self._opinion

    def refuted(self, missing: str) -> tuple[Reason, ...]:
        """Evidence that decides against the declaration: the fleet or the scene has what is called missing."""
        wanted = _form(missing)
        if not wanted:
            return ()
        evidence = (*self._capability(wanted), *self._routine(wanted), *self._entity(missing))
        if evidence and self.opinion is not None and self.opinion.status == "cannot_be_done":
            return ()  # it is there, and yet another reader finds that it does not suffice
        return evidence

    def doubted(self) -> tuple[Reason, ...]:
        """Evidence that does not decide: another reader finds a tree for the mission."""
        found = self.opinion
        if found is None or found.status != "complete" or found.tree is None:
            return ()
        return (
            Reason(
                rule=SENT_BACK,
                message="An author without a model reads this mission as one that can be done, by this tree: "
                + outline(found.tree),
                hint="If that is what the mission asks for, build it. If it is not, declare again, and say why.",
            ),
        )

    def against(self) -> tuple[Reason, ...]:
        """What speaks against a tree that passes the gate: another reader finds that the mission cannot be done."""
        return self.opinion.reasons if self.opinion is not None and self.opinion.status == "cannot_be_done" else ()

    def warnings(self) -> tuple[Reason, ...]:
        """
        Warnings for a tree that passes the gate all the same, where it is the fleet that cannot do what was read.

        Such a tree may be beside the point. Where another reader merely knows no routine for a word, the model knows more words.
        """
        against = self.against()
        if not any(reason.rule == "no_robot_able" for reason in against):
            return ()
        return tuple(
            Reason(
                rule="perhaps_impossible",
                message=f"An author without a model finds that this mission cannot be done: {reason.message}",
                severity="warning",
                needed=reason.needed,
                hint="Look whether the tree does what the mission asks for.",
            )
            for reason in against
        )

    def _capability(self, wanted: tuple[str, ...]) -> tuple[Reason, ...]:
        having = {
            kind.id: name
            for kind in self._builder.brief.fleet.types
            for name in kind.capabilities
            if _form(name) == wanted
        }
        if not having:
            return ()
        name = next(iter(having.values()))
        return (_there(f"The capability {name} is not missing: {listed(having)} of this fleet has it.", name),)

    def _routine(self, wanted: tuple[str, ...]) -> tuple[Reason, ...]:
        for routine in self._builder.brief.routines.routines:
            able = self._builder.offers[routine.id].able_types
            if able and wanted in {_form(routine.id), _form(routine.wire_name)}:
                message = f"The routine {routine.wire_name} is not missing: {listed(able)} of this fleet can do it."
                return (_there(message, routine.id),)
        return ()

    def _entity(self, missing: str) -> tuple[Reason, ...]:
        same = [
            e
            for e in self._builder.brief.world.all_entities
            if words_of(missing) in {words_of(e.id), words_of(e.label)}
        ]
        return (
            (_there(f"{same[0].label!r} is not missing: the scene has it, as {same[0].id}.", same[0].id),)
            if same
            else ()
        )


def missing_of(arguments: Mapping[str, Any]) -> str:
    """What a declaration names as missing; empty if that is no text, and if it names nothing."""
    missing = arguments.get("missing")
    return missing if isinstance(missing, str) else ""


def _form(name: str) -> tuple[str, ...]:
    spaced = "".join(f" {letter}" if letter.isupper() else letter for letter in name) if name.isidentifier() else name
    return tuple(word for word in words_of(spaced.replace("_", " ")) if word not in _EMPTY_WORDS and word != "tree")


def _there(message: str, found: str) -> Reason:
    hint = "Go on with the mission. If it fails for another reason, declare again and name that."
    return Reason(rule=SENT_BACK, message=message, found=found, hint=hint)
