"""What is known while a mission is heard, clause by clause: its words, those who were named, and what was said to be wrong."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.methods.method import MethodLibrary
from missiontree.authoring.reading.advice import RobotAdvice
from missiontree.authoring.reading.doers import Doers
from missiontree.authoring.reading.entities import Speakers
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.refusals import Refusals
from missiontree.mission.brief import MissionBrief
from missiontree.mission.pattern import first_words


@dataclass
class Hearing:
    """
    The state of reading one mission.

    Parameters
    ----------
    brief, library
        The mission, and the methods it may be read by.
    lexicon
        The verbs and small words, those of routines and methods among them.
    phrases
        Reads noun phrases; knows the names of the scene.
    advice
        Knows the robots by name.
    doers
        Asks who does it, where the words may mean either.
    refusals
        Refuses readings that nobody can have meant.
    speakers
        Who was mentioned so far. A way of reading that leads nowhere is undone by setting it back to what it was.
    hazards
        Hazards of places and people that were stated.
    called_for
        Hazards for which somebody was called.
    """

    brief: MissionBrief
    library: MethodLibrary
    lexicon: Lexicon
    phrases: PhraseReader
    advice: RobotAdvice
    doers: Doers
    refusals: Refusals
    speakers: Speakers
    hazards: list[str] = field(default_factory=list)
    called_for: set[str] = field(default_factory=set)


def hearing_of(brief: MissionBrief, library: MethodLibrary) -> Hearing:
    """The state before the first clause is read."""
    lexicon = Lexicon(_verbs(brief, library))
    world = brief.world
    names = {
        form: world.base_kind(entity.kind)
        for entity in world.all_entities
        for name in (entity.id, entity.label, *entity.aliases)
        for form in _forms(name)
    }
    phrases = PhraseReader(lexicon, names)
    advice = RobotAdvice(brief.fleet, frozenset(names), lexicon)
    doers, refusals = Doers(lexicon, phrases, advice), Refusals(world, lexicon, phrases)
    speakers = Speakers(world, complete=brief.scene is not None)
    return Hearing(brief, library, lexicon, phrases, advice, doers, refusals, speakers)


def _forms(name: str) -> tuple[str, ...]:
    """A name as the words of a mission may hold it; "the head gardener" is a head gardener behind any article."""
    low = name.lower()
    return low, low.replace("_", " ").replace("-", " "), low.removeprefix("the ")


def _verbs(brief: MissionBrief, library: MethodLibrary) -> Iterable[str]:
    """Verbs that routines and methods bring along."""
    for routine in brief.routines.routines:
        yield from (verb.lower() for verb in routine.verbs if verb.strip())
    patterns = [forms for method in library.methods for forms in method.forms]
    patterns += [forms for routine in brief.routines.routines for forms in routine.forms]
    yield from (words for forms in patterns for form in forms if (words := first_words(form)))
