"""The places in calls where names stand, each with the true names, the rule by which false ones are refused, and the oracle's word."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from random import Random
from typing import Any

from benchmarks.campaign_dialogues import Arguments, Call, task, trees
from benchmarks.campaign_oracle import Oracle
from benchmarks.campaign_worlds import SPARE, World, worlds
from missiontree.authoring.answer import Answer
from missiontree.authoring.builder import State, TreeBuilder
from missiontree.authoring.tools import BY_NAME, ToolBox

Make = Callable[[Random, "Desk", str], Call]


@dataclass(frozen=True, slots=True)
class Slot:
    """
    A place in a call where a name stands.

    Parameters
    ----------
    names
        The true names.
    call
        The call with a name in that place.
    may_be
        Whether the design lets the name pass, of this call's answer.
    rules
        Rules by which a false name is refused.
    """

    names: Callable[[Desk], Sequence[str]]
    call: Make
    may_be: Callable[[Desk, str, Answer], bool]
    rules: frozenset[str]


class Desk:
    """A world with its tree built, ready for one call more; the same state is there again for the next one."""

    def __init__(self, world: World) -> None:
        self.world = world
        box = ToolBox(TreeBuilder(world.brief))
        for call in world.calls:
            assert box.call(*call).ok, call
        assert box.builder.tree is not None
        self.builder, self.state = box.builder, box.builder.state
        self.oracle = Oracle(world, box.builder.tree)

    def answer(self, name: str, arguments: Arguments) -> tuple[Answer, State]:
        """The answer to a call, and the state after it."""
        self.builder.state = self.state
        return ToolBox(self.builder).call(name, arguments), self.builder.state

    def of_kind(self, rng: Random, kinds: frozenset[str]) -> str:
        """An entity whose base kind is among these."""
        return rng.choice([name for name, kind in self.world.base_kinds.items() if kind in kinds])

    def sound(self, rng: Random, routine: str) -> list[Any]:
        """Arguments that a routine takes, of different entities."""
        while True:
            given = [self.of_kind(rng, kinds) for kinds in self.world.takes[routine]]
            answer, _ = self.answer(*trees(SPARE, [(routine, given)]))
            if answer.ok:
                return given


@cache
def desks() -> tuple[Desk, ...]:
    """A desk for each world."""
    return tuple(Desk(world) for world in worlds())


def routine_name(rng: Random, routine: str) -> str:
    """The routine by its id, or as models see it."""
    return routine if rng.random() < 0.4 else f"{routine}Tree"


def _routine_call(rng: Random, desk: Desk, name: str) -> Call:
    known = name.removesuffix("Tree")
    routine = known if known in desk.world.takes else rng.choice(list(desk.world.takes))
    return trees(SPARE, [(name, desk.sound(rng, routine))])


def _robot_call(rng: Random, desk: Desk, name: str) -> Call:
    others = [kind.id for kind in desk.world.brief.fleet.types] if rng.random() < 0.3 else []
    return trees(SPARE, [("ReachTree", [desk.of_kind(rng, frozenset({"person", "object"})), [*others, name]])])


def _entity_call(rng: Random, desk: Desk, name: str) -> Call:
    given = [name] if rng.random() < 0.5 else {"agent": name}
    return trees(SPARE, [(routine_name(rng, "Reach"), given)])


def _node_call(rng: Random, desk: Desk, name: str) -> Call:
    other = desk.oracle.tree.nodes[-1].id
    if rng.random() < 0.4:
        return "removeSubtask", {"subtask": name}
    return trees(
        SPARE, [("ReachTree", [desk.of_kind(rng, frozenset({"person"}))])], [[name if name != other else 0, 0]]
    )


def _function_call(rng: Random, desk: Desk, name: str) -> Call:
    sound = {
        "CreateAndAddSubtask": task(SPARE, "Further")[1],
        "attachMultiSubTrees": _entity_call(rng, desk, desk.of_kind(rng, frozenset({"person"})))[1],
        "introduceEntity": {"name": "Zebedee", "kind": "person"},
        "removeSubtask": {"subtask": SPARE},
    }
    return name, sound.get(name, {})


def _argument_call(rng: Random, desk: Desk, name: str) -> Call:
    """A key of the function's own arguments."""
    function, arguments = task(SPARE, "Further")
    return function, {name if key == "taskName" else key: value for key, value in arguments.items()}


def _kind_call(rng: Random, desk: Desk, name: str) -> Call:
    return "introduceEntity", {"name": "Zebedee", "kind": name}


def _gate_call(rng: Random, desk: Desk, name: str) -> Call:
    return task(SPARE, "Further", name)


FUNCTIONS = ("CreateAndAddSubtask", "attachMultiSubTrees", "introduceEntity", "removeSubtask", "printTree", "checkTree")
SLOTS: Mapping[str, Slot] = {
    "routine": Slot(
        lambda desk: desk.oracle.routines,
        _routine_call,
        lambda desk, name, answer: desk.oracle.same(name, desk.oracle.routines),
        frozenset({"unknown_routine"}),
    ),
    "robot": Slot(
        lambda desk: desk.oracle.robots,
        _robot_call,
        lambda desk, name, answer: desk.oracle.same(name, desk.oracle.robots),
        frozenset({"unknown_robot"}),
    ),
    "entity": Slot(
        lambda desk: desk.oracle.entities if desk.world.scenic else list(desk.world.base_kinds),
        _entity_call,
        lambda desk, name, answer: desk.oracle.may_be_entity(name),
        frozenset({"unknown_entity", "ambiguous_name"}),
    ),
    "parent": Slot(
        lambda desk: [name for node in desk.oracle.tree.nodes if node.routine is None for name in (node.id, node.label)],
        lambda rng, desk, name: task(name, "Further"),
        lambda desk, name, answer: answer.data["parent"] in desk.oracle.may_mean(name),
        frozenset({"unknown_parent", "ambiguous_name", "parent_is_routine"}),
    ),
    "node": Slot(
        lambda desk: [name for node in desk.oracle.tree.nodes[1:-1] for name in (node.id, node.label)],
        _node_call,
        lambda desk, name, answer: desk.oracle.may_be_node(name),
        frozenset({"unknown_node", "ambiguous_name", "root_stays", "contained"}),
    ),
    "function": Slot(
        lambda desk: FUNCTIONS,
        _function_call,
        lambda desk, name, answer: name in BY_NAME,
        frozenset({"unknown_function", "malformed_arguments", "duplicate"}),
    ),
    "argument": Slot(
        lambda desk: ("taskName",), _argument_call, lambda desk, name, answer: name == "taskName", frozenset({"malformed_arguments"})
    ),
    "entity kind": Slot(
        lambda desk: desk.oracle.kinds,
        _kind_call,
        lambda desk, name, answer: desk.oracle.same(name, desk.oracle.kinds),
        frozenset({"unknown_kind"}),
    ),
    "gate": Slot(
        lambda desk: ("AND", "XOR"),
        _gate_call,
        lambda desk, name, answer: desk.oracle.same(name, ("and", "xor")),
        frozenset({"malformed_arguments"}),
    ),
}  # fmt: skip
