"""Small builders that tests of the reading share: words, clauses, those who were mentioned, and a mission that is about to be heard."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.methods.mention import Mention, title
from missiontree.authoring.methods.method import MethodLibrary, built_in_methods, read_methods
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.clauses import clauses_of
from missiontree.authoring.reading.hearing import Hearing, hearing_of
from missiontree.authoring.reading.words import Word, words_of_text
from missiontree.mission.routine import ActionStep, Argument, Branch, RoleSpec, Routine, RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.routines.library import built_in, with_routines
from tests.builders import brief_of

LEXICON = Lexicon()


def shown(words: Iterable[Word]) -> str:
    """Words as a text; signs stand apart."""
    return " ".join(word.text for word in words)


def clause_of(text: str) -> Clause:
    """The one clause of a text."""
    (clause,) = clauses_of(words_of_text(text), LEXICON)
    return clause


def mention(label: str, kind: str = "object", **fields: bool) -> Mention:
    """Somebody or something of that label, which is its name too."""
    return Mention(label, label, label, kind, **fields)


def own_methods(steps: str, says: str = "<bring> {x} to {y}", where: str = "{}") -> MethodLibrary:
    """A library of one method."""
    text = f"""format: methods/1
methods:
  - id: own
    purpose: For a test.
    says: ["{says}"]
    where: {where}
    steps:
      - {steps}
"""
    return MethodLibrary(methods=read_methods(text, "own.yaml").methods)


def own_routine(verb: str, *kinds: str) -> RoutineLibrary:
    """The built-in routines and one that is done to something of these kinds."""
    role = RoleSpec(name="one", rating="reach", actions=(ActionStep(name="act", text="Do it to {thing}"),))
    routine = Routine(
        id="Own",
        purpose="For a test.",
        arguments=(Argument(name="thing", kinds=kinds),),
        verbs=(verb,),
        branches=(Branch(name="only", roles=(role,)),),
    )
    return with_routines(built_in(), [routine])


def hearing(
    scene: Scene | None = None, methods: MethodLibrary | None = None, routines: RoutineLibrary | None = None
) -> Hearing:
    """A mission of the paper's team, before its first clause is read."""
    heard = hearing_of(brief_of(scene=scene, routines=routines), methods or built_in_methods())
    heard.speakers.next_clause()
    return heard


def before(heard: Hearing, *labels: str, kind: str = "object", together: bool = False) -> None:
    """Let somebody have been named in a clause before: each in a group of its own, or all in one."""
    mentions = tuple(mention(title(label), kind) for label in labels)
    groups: Sequence[tuple[Mention, ...]] = [mentions] if together else [(one,) for one in mentions]
    heard.speakers.remember(tuple(groups))
    heard.speakers.next_clause()


def only_by(clause: Clause, *types: str, without: tuple[str, ...] = ()) -> Clause:
    """The clause with robot types that are asked for, and others that are left out."""
    return replace(clause, asked=(types,) if types else (), without=without)
