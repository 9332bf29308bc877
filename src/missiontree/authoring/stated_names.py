"""Whom a formal goal names: somebody of the world, or, without a scene, somebody new who is called by a plain name."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from missiontree.authoring.language.kinds import is_abstract, kind_of
from missiontree.authoring.language.lexicon import Lexicon
from missiontree.authoring.matching import did_you_mean, listed, quoted, words_of
from missiontree.authoring.methods.mention import Mention, UnclearError, title
from missiontree.authoring.reading.advice import RobotAdvice
from missiontree.authoring.reading.entities import Speakers
from missiontree.authoring.reading.phrase import Phrase, kind_of_phrase
from missiontree.authoring.reading.phrases import MAX_NAME_WORDS
from missiontree.mission.brief import MissionBrief

DECLARE = "Or declare it under entities: in the mission file or in the scene."
_ARTICLES = frozenset({"the", "a", "an"})
_ROBOTS = frozenset({"robot", "robots"})
_JOINING = frozenset({"and", "or", "nor", "but", "except", "without", "not", "&"})
_SIGNS = ",;()[]{}"


class UnknownNameError(Exception):
    """A name stands for nobody; carries the rule, what is wrong, and what to do. Never leaves the understanding of a goal."""

    def __init__(self, rule: str, detail: str, hint: str) -> None:
        super().__init__(detail)
        self.rule, self.detail, self.hint = rule, detail, hint


@dataclass
class StatedNames:
    """
    Finds who is meant by the names of one mission's goals.

    Parameters
    ----------
    brief
        The mission.
    speakers
        Whom the world has.
    lexicon
        Knows small words and hazards.
    """

    brief: MissionBrief
    speakers: Speakers
    lexicon: Lexicon
    _robots: RobotAdvice = field(init=False)

    def __post_init__(self) -> None:
        self._robots = RobotAdvice(self.brief.fleet, frozenset(), self.lexicon)

    def mention(self, written: str) -> Mention:
        """
        Who is meant by an id or a label; without a scene, somebody of the kind that the noun says.

        Raises
        ------
        UnknownNameError
            If it is nobody, may be several, or is no name by which somebody can be introduced.
        """
        words = written.split()
        article = len(words) > 1 and words[0].lower() in _ARTICLES
        name = " ".join(words[article:])
        kind = kind_of_phrase(Phrase(name=name, text=name, determined=article)) or "object"
        try:
            mention = self.speakers.implied(name, kind, (written,))
        except UnclearError as error:
            raise UnknownNameError("ambiguous_name", str(error), "Use the id.") from error
        if mention.new:
            self._refuse_robot(name)
            if self.brief.scene is None:
                self._refuse_unfit(name)
            elif not self.is_hazard(name):
                self._refuse_unknown(name)
            mention = replace(mention, name=title(name), label=title(name), full=title(name))
        return replace(mention, determined=article or (kind_of(name) is not None and name.islower()))

    def hazards(self, name: str) -> Iterator[str]:
        """The hazards that a name holds."""
        return (hazard for hazard, _, _ in self.lexicon.hazard_words.within(words_of(name)))

    def is_hazard(self, name: str) -> bool:
        """Whether a name is that of a hazard: a gas leak is one, a fire station is not."""
        words = words_of(name)
        return any(start + length == len(words) for _, start, length in self.lexicon.hazard_words.within(words))

    def _refuse_unknown(self, name: str) -> None:
        """A scene says who there is."""
        world = self.brief.world
        near = did_you_mean(name, [spelling for e in world.all_entities for spelling in (e.id, e.label, *e.aliases)])
        known = f"Known are: {listed(entity.label for entity in world.all_entities)}."
        raise UnknownNameError(
            "unknown_entity", f"the scene has no {quoted(name)}", f"{near} {known} {DECLARE}".strip()
        )

    def _refuse_robot(self, name: str) -> None:
        """Who does it is not whom it is done to."""
        hint = f"Say who does it by 'by: [type]'. {DECLARE}"
        if robots := self._robots.named_in(name):
            raise UnknownNameError("names_a_robot", self._robots.on(robots[0]).partition(";")[0], hint)
        if words_of(name)[-1:] and words_of(name)[-1] in _ROBOTS:
            detail = f"{quoted(name)} does things; it is not clear what is to be done with it"
            raise UnknownNameError("names_a_robot", detail, hint)

    def _refuse_unfit(self, name: str) -> None:
        """Only a plain name introduces somebody, since nobody else says that they are there."""
        lows = name.lower().split()
        small = self.lexicon.words
        if joined := next((low for low in lows if low in _JOINING), next((s for s in _SIGNS if s in name), "")):
            detail = f"{quoted(name)} holds {joined!r}, so it is more than one name"
        elif name.lower() in small["pronouns"] | small["everybody"]:
            detail = f"{quoted(name)} is a pronoun, and there are no words before it that say whom it means"
        elif lows[0] in small["determiners"] | small["quantities"]:
            detail = f"{quoted(name)} begins with {lows[0]!r}, which is no part of a name"
        elif len(lows) > MAX_NAME_WORDS:
            detail = f"{quoted(name)} has {len(lows)} words; a name has at most {MAX_NAME_WORDS}"
        elif is_abstract(name) and not self.is_hazard(name):
            detail = f"{quoted(name)} is nothing that a robot can find, reach or carry"
        else:
            return
        hint = f"Name one person, animal, thing or place, as in 'dog'; state a goal for each of several. {DECLARE}"
        raise UnknownNameError("no_plain_name", detail, hint)
