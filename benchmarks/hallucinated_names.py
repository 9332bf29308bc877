"""
Does a name pass that nobody has? Names near the real ones and wrong kinds, in calls that are sound but for them.

::

    python -m benchmarks.hallucinated_names --count 53000 --seed 1 --state names.json

Each call is judged by an oracle that was written from the design and shares no code with the product's matching. Beside each call
stands the same with the true name, which must be accepted: so it is the name that was refused, and nothing else.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from benchmarks.campaign import Campaign, Verdict, luck, run
from benchmarks.campaign_dialogues import trees
from benchmarks.campaign_near import OTHER_NAME, WAYS, near
from benchmarks.campaign_slots import SLOTS, Desk, Slot, desks, routine_name
from benchmarks.campaign_worlds import SPARE
from missiontree.authoring.answer import Answer
from missiontree.authoring.builder import State
from missiontree.authoring.tools import BY_NAME

ACCEPTED = "names accepted that nobody has"
UNTOLD = "near parents taken without a notice"
REASON = "refused for another reason"
CONTROL = "true names refused"
TRACES = "refused calls that left a trace"
COUNT = 53_000  # of which more than 50,000 are names that nobody has; the others the design lets pass

WRONG_KIND = "wrong kind"
_OFTEN = ("routine", "robot", "entity", "parent", WRONG_KIND)
_DRAWN = (*_OFTEN, *_OFTEN, *_OFTEN, "node", "node", "function", "argument", "entity kind", "gate")
_ANYWHERE = frozenset({"malformed_arguments"})
"""Half a letter, a control character, an empty text: refused wherever it stands."""


def judge(seed: int, index: int) -> Verdict:
    """Make the call of that number, and the same with the true name."""
    rng = luck(seed, index)
    desk = rng.choice(desks())
    place = _DRAWN[index % len(_DRAWN)]
    if place == WRONG_KIND:
        return _wrong_kind(rng, desk)
    slot = SLOTS[place]
    name = rng.choice(list(slot.names(desk)))
    way = rng.choice((*WAYS, OTHER_NAME))
    said = near(rng, way, name, _others(desk))
    if said == name:
        said, way = f"{name}'", "dressed up"
    state = rng.getstate()
    function, arguments = slot.call(rng, desk, said)
    rng.setstate(state)
    sound = slot.call(rng, desk, name)
    if place == "function":
        arguments = sound[1]
    answer, after = desk.answer(function, arguments)
    violations = list(_faults(desk, slot, said, answer, after, f"{desk.world.name}: {place} {name!r} as {said!r}"))
    control, _ = desk.answer(*sound)
    if not control.ok:
        violations.append((CONTROL, f"{desk.world.name}: {place} {name!r}: {control.reasons[0].message}"))
    counts = {"refused": int(not answer.ok), f"{place} taken": int(answer.ok)}
    return Verdict(way, counts, tuple(violations))


def _others(desk: Desk) -> list[str]:
    oracle = desk.oracle
    return [*oracle.routines, *oracle.robots, *oracle.entities, *oracle.nodes, *oracle.kinds, *BY_NAME]


def _faults(desk: Desk, slot: Slot, said: str, answer: Answer, after: State, what: str) -> Iterator[tuple[str, str]]:
    if answer.ok:
        if not slot.may_be(desk, said, answer):
            yield ACCEPTED, what
        exact = (
            any(said in {node.id, node.label} for node in desk.oracle.tree.nodes) or said == desk.oracle.tree.objective
        )
        told = any(notice.rule == "parent_matched" for notice in answer.notices)
        if slot is SLOTS["parent"] and not exact and not told:
            yield UNTOLD, what
        return
    if after is not desk.state:
        yield TRACES, what
    if answer.reasons[0].rule not in slot.rules | _ANYWHERE:
        yield REASON, f"{what}: {answer.reasons[0].rule}: {answer.reasons[0].message}"


def _wrong_kind(rng: Random, desk: Desk) -> Verdict:
    """A real routine and a real entity that it does not take."""
    picky = [
        (routine, place)
        for routine, takes in desk.world.takes.items()
        for place, kinds in enumerate(takes)
        if set(desk.world.base_kinds.values()) - kinds
    ]
    routine, place = rng.choice(picky)
    wrong: list[str] = []
    while not wrong:  # not one that stands in another place of the call already: that is refused for another reason
        given = desk.sound(rng, routine)
        others = {*given[:place], *given[place + 1 :]}
        unfit = frozenset(desk.world.base_kinds.values()) - desk.world.takes[routine][place]
        wrong = [name for name, kind in desk.world.base_kinds.items() if kind in unfit and name not in others]
    bent = [*given[:place], rng.choice(wrong), *given[place + 1 :]]
    answer, after = desk.answer(*trees(SPARE, [(routine_name(rng, routine), bent)]))
    what = f"{desk.world.name}: {routine}({', '.join(bent)})"
    violations: list[tuple[str, str]] = []
    if answer.ok:
        violations.append((ACCEPTED, what))
    elif answer.reasons[0].rule != "wrong_kind":
        violations.append((REASON, f"{what}: {answer.reasons[0].message}"))
    if not answer.ok and after is not desk.state:
        violations.append((TRACES, what))
    return Verdict(WRONG_KIND, {"refused": int(not answer.ok)}, tuple(violations))


CAMPAIGN = Campaign("hallucinated names", __doc__, COUNT, judge, (ACCEPTED, UNTOLD, REASON, CONTROL, TRACES), "names")

if __name__ == "__main__":
    run(CAMPAIGN)
