"""
The author that needs no model: mission methods turn what is said into the tree-building calls that a language model would make.

Same functions, same checks, same transcript. It never guesses: words that may matter and are not understood make the outcome
*incomplete*, and a goal that no routine serves makes it *cannot be done*.
"""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.authoring.building import built
from missiontree.authoring.composing.composing import composed
from missiontree.authoring.desk import Desk
from missiontree.authoring.methods.method import MethodLibrary, built_in_methods
from missiontree.authoring.outcome import Authored
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.clauses import clauses_of
from missiontree.authoring.reading.exclusions import robots_restricted, standing_orders
from missiontree.authoring.reading.goals import GoalReader
from missiontree.authoring.reading.hearing import hearing_of
from missiontree.authoring.reading.outcomes import Goal, Trouble, Unserved
from missiontree.authoring.reading.robots import robots_carried, robots_marked
from missiontree.authoring.reading.taking import errands_joined
from missiontree.authoring.reading.wording import not_until, verbs_repeated
from missiontree.authoring.reading.words import MAX_WORDS, Word, words_of_text
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason

WAY_OUT = "Say what is to be done, such as 'Find the keys, then bring them to Anna', set a model, or add a method."


def author_offline(brief: MissionBrief, methods: MethodLibrary | None = None) -> Authored:
    """
    Have a mission tree built without a model.

    Parameters
    ----------
    brief
        The mission.
    methods
        The mission methods; default: those that ship with missiontree.

    Returns
    -------
    Authored
        ``complete``, ``cannot_be_done`` or ``incomplete``; ``reading`` says, clause by clause, what was understood by which method.
    """
    return _authored(brief, methods, served_only=False)[0]


def author_served(brief: MissionBrief, methods: MethodLibrary | None = None) -> tuple[Authored, tuple[str, ...]]:
    """
    Build the tree of what is served, where a mission asks for something beside it that no method and no routine serves.

    Returns
    -------
    Authored, tuple of str
        As :func:`author_offline` gives it for the rest, and the clauses that were left aside.
    """
    return _authored(brief, methods, served_only=True)


def _authored(
    brief: MissionBrief, methods: MethodLibrary | None, served_only: bool
) -> tuple[Authored, tuple[str, ...]]:
    library = methods or built_in_methods()
    words = words_of_text(brief.text[: MAX_WORDS * 60])
    desk = Desk(brief)
    if not words:
        empty = Reason(rule="empty_mission", message="The mission is empty: there is nothing to be done.", hint=WAY_OUT)
        return desk.ended("incomplete", (empty,)), ()
    if len(words) > MAX_WORDS or len(brief.text) > MAX_WORDS * 60:
        message = f"The mission is too long for the offline author: it reads {MAX_WORDS} words and signs."
        too_long = Reason(rule="mission_too_long", message=message, hint="Shorten it, or set a model.")
        return desk.ended("incomplete", (too_long,)), ()
    reader = GoalReader(hearing_of(brief, library))
    clauses = _clauses(words, reader)
    results = [reader.read(clause, following) for clause, following in zip(clauses, (*clauses[1:], None), strict=False)]
    desk.reading = tuple(_line(clause.text, result) for clause, result in zip(clauses, results, strict=True))
    troubles = tuple(result.reason for result in results if isinstance(result, Trouble))
    unserved = [result for result in results if isinstance(result, Unserved)]
    goals = [result for result in results if isinstance(result, Goal)]
    if troubles or not (unserved or any(goal.outline.pieces for goal in goals)):
        nothing = Reason(rule="nothing_asked", message="The mission asks for nothing.", hint=WAY_OUT)
        return desk.ended("incomplete", (*(troubles or (nothing,)), *(_missing(brief, one) for one in unserved))), ()
    if unserved and not (served_only and any(goal.outline.pieces for goal in goals)):
        return _declined(desk, unserved), ()
    aside = tuple(clause.text for clause, result in zip(clauses, results, strict=True) if isinstance(result, Unserved))
    desk.remarks += reader.unused_statements(goals)
    assumptions = [assumption for goal in goals for assumption in goal.assumptions]
    return built(desk, composed(goals, brief.routines), assumptions), aside


def _clauses(words: tuple[Word, ...], reader: GoalReader) -> tuple[Clause, ...]:
    """The clauses of the text, with what they leave out."""
    heard = reader.hearing
    fleet, lexicon, known = heard.brief.fleet, heard.lexicon, frozenset(heard.phrases.known)
    standing = standing_orders(words, fleet, lexicon, known)
    marked = robots_marked(standing.words, fleet, lexicon, known)
    clauses = not_until(verbs_repeated(clauses_of(marked, lexicon), lexicon), lexicon)
    return robots_restricted(robots_carried(errands_joined(clauses, lexicon)), standing)


def clauses_read(brief: MissionBrief, methods: MethodLibrary) -> tuple[GoalReader, tuple[Clause, ...]]:
    """The clauses of a mission as this author sees them, and its reader, which knows their words."""
    reader = GoalReader(hearing_of(brief, methods))
    return reader, _clauses(words_of_text(brief.text[: MAX_WORDS * 60]), reader)


def _line(text: str, result: Goal | Unserved | Trouble) -> str:
    if isinstance(result, Goal):
        return result.reading
    if isinstance(result, Unserved):
        return f"{text!r}: understood as a goal ({result.goal}) that no method and no routine serves"
    return f"not understood: {result.reason.message}"


def _missing(brief: MissionBrief, unserved: Unserved) -> Reason:
    if unserved.robots_lack:
        types = ", ".join(kind.label for kind in brief.fleet.types)
        return Reason(
            rule="capability_missing",
            message=f"'{unserved.verb}' needs the capability {unserved.goal}, which no robot type of the fleet has ({types}).",
            needed=unserved.goal,
            hint=f"Give {unserved.goal} to a robot type, or write a routine with '{unserved.verb}' among its verbs.",
        )
    served = ", ".join(routine.id for routine in brief.routines.routines)
    asked = f"{unserved.goal} ('{unserved.verb}')" if unserved.verb != unserved.goal else unserved.goal
    return Reason(
        rule="capability_missing",
        message=f"The mission needs the capability {asked}, which no routine has; there are {served}.",
        needed=unserved.goal,
        hint=f"Write a routine with '{unserved.verb}' among its verbs and give the capability to a robot type, or reword the mission.",
    )


def _declined(desk: Desk, unserved: Sequence[Unserved]) -> Authored:
    """Declare that the mission cannot be done, since a goal is served by nobody."""
    reasons = tuple(dict.fromkeys(_missing(desk.brief, one) for one in unserved))
    return desk.declared_impossible(reasons, ", ".join(dict.fromkeys(one.goal for one in unserved)))
