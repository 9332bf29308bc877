"""What to say instead, for words about robots that no tree can hold: a robot by its own name, one that is left out, one that nobody has."""

from __future__ import annotations

from missiontree.authoring.language.lexicon import Lexicon, PhraseTable
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.robots import by_last_word, named_robots
from missiontree.mission.fleet import Fleet

_LEAVES_OUT = frozenset(
    {"without", "except", "excluding", "avoid", "but", "not", "never", "instead", "don't", "do not"}
)
_BEGINS_WITH_ROBOT = frozenset({"use", "have", "let", "send", "with", "using", "by", "command"})
_MOST_TYPES = 5


class RobotAdvice:
    """
    Looks for robots in the words of clauses.

    Parameters
    ----------
    fleet
        Whose robots they are.
    known
        Names of the scene, which are never taken for a robot.
    lexicon
        Knows what things are rather instruments than descriptions.
    """

    def __init__(self, fleet: Fleet, known: frozenset[str], lexicon: Lexicon) -> None:
        self._fleet = fleet
        self._names: PhraseTable = named_robots(fleet, known)
        self.short_names = frozenset(" ".join(form) for form in by_last_word(fleet)) - known
        self._instruments = lexicon.words["instruments"]
        self.types = ", ".join(kind.label for kind in fleet.types[:_MOST_TYPES]) + (
            " ..." if len(fleet.types) > _MOST_TYPES else ""
        )

    def named_in(self, text: str) -> list[str]:
        """Every robot and robot type that the words name, each once."""
        lows = [low.strip(",").removesuffix("'s") for low in text.lower().split()]
        return list(dict.fromkeys(name for name, _, _ in self._names.within(lows)))

    def single(self, clause: Clause) -> str:
        """Why a robot cannot be asked for by its own name; empty if the clause names none."""
        return next((self.on(name) for name in self.named_in(clause.text) if name in self._fleet.type_of), "")

    def on(self, name: str) -> str:
        """How to ask for a robot or a robot type."""
        kind = self._fleet.type_of.get(name)
        if kind is None:
            return (
                f"{name!r} is a robot of the fleet; say who does it as in 'with the {name}' or 'use the {name} to ...'"
            )
        return (
            f"{name!r} is one robot of the type {kind.label}, and a tree asks for types, not for single robots; "
            f"say 'with the {kind.label}'"
        )

    def on_leaving_out(self, clause: Clause) -> str:
        """Who may be named instead, if the clause leaves robots out; empty if it leaves out something else."""
        named = [*self.named_in(clause.text), *clause.robots]
        things = self._instruments & {word.low for word in clause.words}
        if not set(clause.decisive) & _LEAVES_OUT or not (named or things):
            return ""
        gone = {self._fleet.type_of[name].id if name in self._fleet.type_of else name for name in named}
        may = [kind.label for kind in self._fleet.types if not gone & {kind.id, kind.label}][:_MOST_TYPES]
        if not may:
            return f"Robots cannot be left out in words, and there are no others than {self.types}."
        ways = " or ".join(f"'with the {label}'" for label in may)
        return f"Robots cannot be left out in words; name the type that shall do it: {ways}."

    def on_order(self, clause: Clause) -> tuple[str, str]:
        """What is wrong with "use the drone", and what to say instead; empty if the clause is none such."""
        if clause.words[0].low not in _BEGINS_WITH_ROBOT:
            return "", ""
        named = self.named_in(clause.text)
        example = named[0] if named else self._fleet.types[0].label
        hint = f"Name a robot type and what it does in one sentence: 'Use the {example} to find ...'."
        if named:
            return f"it does not say in one sentence what the {example} is to do", hint
        return f"it names no robot type of the fleet ({self.types})", hint
