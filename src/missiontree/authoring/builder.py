"""
TreeBuilder: each call leaves a well-formed tree, or is refused with a reason and changes nothing.

The calls are those of the paper (section III-B), under names of Python's style, and a few that a model needs to recover or to
decline. The whole state is one frozen value that a call replaces at its very end; that is what makes every call atomic.
"""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, wraps
from typing import Any, Concatenate, ParamSpec

from missiontree.authoring.answer import Answer, RefusalError, refuse
from missiontree.authoring.edits import with_children, with_entities, with_links, with_times, without
from missiontree.authoring.endings import impossible, unclear
from missiontree.authoring.entities import Cast
from missiontree.authoring.findings import findings
from missiontree.authoring.growing import check_size, routine_nodes, task_nodes
from missiontree.authoring.introducing import introduced
from missiontree.authoring.links import Pair, check_links, name_of_kind
from missiontree.authoring.matching import listed
from missiontree.authoring.naming import make_id
from missiontree.authoring.nodes import find_node, find_parent
from missiontree.authoring.routine_calls import able_types, form_of, read_routine_call
from missiontree.authoring.texts import MAX_NAME, MAX_OBJECTIVE, check_text
from missiontree.authoring.views import MOST_SHOWN, named, outline, state_of, told
from missiontree.authoring.wire import RULE
from missiontree.mission.brief import MissionBrief
from missiontree.mission.frozen_map import FrozenMap
from missiontree.mission.reason import Reason
from missiontree.mission.tree import Gate, Link, LinkKind, MissionNode, MissionTree
from missiontree.routines.offers import Offers

Draw = Callable[[MissionTree], str]
P = ParamSpec("P")


@dataclass(frozen=True, slots=True)
class State:
    """
    All that calls change.

    Parameters
    ----------
    tree
        The tree; None before it is begun.
    gates
        The gate each parent was told, which a task with a single child keeps for the next one.
    impossible
        Why the mission was declared impossible; empty if it was not.
    unclear
        Why the mission was declared unclear; empty if it was not.
    """

    tree: MissionTree | None = None
    gates: Mapping[str, Gate] = field(default_factory=lambda: FrozenMap({}))
    impossible: tuple[Reason, ...] = ()
    unclear: tuple[Reason, ...] = ()


def _answering(call: Callable[Concatenate[TreeBuilder, P], Answer]) -> Callable[Concatenate[TreeBuilder, P], Answer]:
    """Make an answer of a refusal. State is set in the last step of a call, so nothing has changed by then."""

    @wraps(call)
    def answered(self: TreeBuilder, /, *args: P.args, **kwargs: P.kwargs) -> Answer:
        try:
            return call(self, *args, **kwargs)
        except RefusalError as refusal:
            return Answer(ok=False, reasons=refusal.reasons)

    return answered


class TreeBuilder:
    """
    Builds one mission tree.

    Parameters
    ----------
    brief
        The mission, with the fleet, the routines and the scene that calls may speak of.
    """

    def __init__(self, brief: MissionBrief) -> None:
        self.brief = brief
        self.state = State()

    @property
    def tree(self) -> MissionTree | None:
        """The tree as far as it is built; None before it is begun."""
        return self.state.tree

    @property
    def cast(self) -> Cast:
        """The entities that calls may name."""
        return Cast(self.brief, self.tree.entities if self.tree is not None else ())

    @cached_property
    def offers(self) -> dict[str, Offers]:
        """What the fleet offers for each routine, whoever it is about."""
        return able_types(self.brief)

    @_answering
    def init(self, objective: str) -> Answer:
        """Begin the tree with its root (the paper's HierarchicalTree_init)."""
        self._check_not_ended()
        if self.tree is not None:
            hint = f"Go on with it: its root is {self.tree.root.id}. removeSubtask takes back what was added."
            raise refuse("duplicate", "There is a tree already.", node=self.tree.root.id, hint=hint)
        label = " ".join(objective.split())
        check_text(label, "objective", MAX_OBJECTIVE)
        label = textwrap.shorten(label, MAX_NAME, placeholder=" ...") if len(label) > MAX_NAME else label
        root = MissionNode(id=make_id(label, (), "mission"), label=label)
        tree = MissionTree(objective=objective, nodes=(root,))
        return self._done(replace(self.state, tree=tree), {"root": root.id, "routines": self._on_offer})

    @_answering
    def add_subtasks(
        self, parent: str, primitive: Sequence[bool], names: Sequence[str], gate: Gate, pairs: Sequence[Pair] = ()
    ) -> Answer:
        """
        Add tasks below a task (the paper's CreateAndAddSubtask and addMultiSubtasks).

        Parameters
        ----------
        parent
            Id or name of the task above.
        primitive
            Per task, whether the caller takes it for primitive; it never is, since leaves end in routines.
        names
            What the tasks are called.
        gate
            How the parent's children combine.
        pairs
            Links among nodes, the new ones included.
        """
        tree = self._begun()
        above, notices = find_parent(tree, parent)
        if len(primitive) != len(names):
            message = f"isPrimitiveList has {len(primitive)} entries and taskNameList {len(names)}."
            raise refuse(RULE, message, hint="Give one entry per task in each.")
        nodes = task_nodes(tree, above, names)
        if any(primitive):
            notices += (_PRIMITIVE,)
        return self._grown(tree, above, nodes, names, gate, pairs, self.cast, notices)

    @_answering
    def attach_subtrees(
        self, parent: str, routines: Sequence[str], arguments: Sequence[Any], gate: Gate, pairs: Sequence[Pair] = ()
    ) -> Answer:
        """
        Put routines below a task (the paper's attachMultiSubTrees).

        Parameters
        ----------
        parent
            Id or name of the task above.
        routines
            Names of routines, with or without ``Tree``.
        arguments
            Per routine, its arguments as a list or an object; both may end in *resources*, the robot types allowed.
        gate
            How the parent's children combine.
        pairs
            Links among nodes, the new ones included.
        """
        tree = self._begun()
        above, notices = find_parent(tree, parent)
        if len(routines) != len(arguments):
            message = f"treeNames has {len(routines)} entries and treeArguments {len(arguments)}."
            raise refuse(RULE, message, hint="Give the arguments of each tree as one entry.")
        cast = self.cast
        calls = [
            read_routine_call(name, given, f"treeArguments[{number}]", cast)
            for number, (name, given) in enumerate(zip(routines, arguments, strict=True))
        ]
        nodes = routine_nodes(tree, above, calls)
        answer = self._grown(tree, above, nodes, routines, gate, pairs, cast, notices + tuple(cast.assumptions))
        able = [
            {"id": node.id, "can_be_done_by": list(call.offers.able_types)}
            for node, call in zip(nodes, calls, strict=True)
        ]
        return replace(answer, data=dict(answer.data) | {"offers": able})

    @_answering
    def introduce_entity(self, name: str, kind: str) -> Answer:
        """Make known somebody or something that the scene does not have; the position is unknown."""
        made, entity, assumptions = introduced(self._begun(), self.brief, name, kind)
        everyone = Cast(self.brief, made.entities).everyone
        data = {"entity": entity.id, "entities": [known.id for known in everyone]}
        return self._done(replace(self.state, tree=made), data, assumptions)

    @_answering
    def remove_subtask(self, node: str) -> Answer:
        """Take a node out with all below it, and the links that end there."""
        tree = self._begun()
        found = self._node(tree, node)
        if found is tree.root:
            raise refuse(
                "root_stays", "The root cannot be removed.", node=found.id, hint="Remove what stands below it."
            )
        smaller, dropped = without(tree, found.id)
        gone = [known.id for known in tree.nodes if known.id not in smaller.by_id]
        gates = FrozenMap(
            {known: told_gate for known, told_gate in self.state.gates.items() if self._still(smaller, known)}
        )
        data = {
            "removed": gone,
            "links_dropped": [[link.first, link.second, name_of_kind(link.kind)] for link in dropped],
        }
        return self._done(replace(self.state, tree=smaller, gates=gates), data)

    @_answering
    def set_link(self, first: str, second: str, kind: LinkKind = "precedence") -> Answer:
        """Add a link between two nodes that there are."""
        tree = self._begun()
        link = Link(self._node(tree, first).id, self._node(tree, second).id, kind)
        check_links(tree, [link], self.brief.routines)
        state = replace(self.state, tree=with_links(tree, [link]))
        return self._done(state, {"link": [link.first, link.second, name_of_kind(kind)]})

    @_answering
    def drop_link(self, first: str, second: str, kind: LinkKind | None = None) -> Answer:
        """Take away the links from one node to another, or those of one kind."""
        tree = self._begun()
        ends = (self._node(tree, first).id, self._node(tree, second).id)
        gone = [link for link in tree.links if (link.first, link.second) == ends and kind in {None, link.kind}]
        if not gone:
            there = listed(f"{link.first} -> {link.second} ({name_of_kind(link.kind)})" for link in tree.links)
            raise refuse(
                "unknown_link", f"There is no such link from {ends[0]!r} to {ends[1]!r}.", hint=f"Links are: {there}."
            )
        state = replace(self.state, tree=replace(tree, links=tuple(link for link in tree.links if link not in gone)))
        return self._done(
            state, {"links_dropped": [[link.first, link.second, name_of_kind(link.kind)] for link in gone]}
        )

    @_answering
    def set_times(self, node: str, release_s: float = 0.0, deadline_s: float | None = None) -> Answer:
        """Give a node these times in place of those it has."""
        tree = self._begun()
        found = self._node(tree, node)
        state = replace(self.state, tree=with_times(tree, found.id, release_s, deadline_s))
        return self._done(state, {"node": found.id, "release_s": release_s, "deadline_s": deadline_s})

    @_answering
    def print_tree(self) -> Answer:
        """The tree as text."""
        return self._done(self.state, {"tree": outline(self._begun())})

    @_answering
    def plot_tree(self, draw: Draw | None = None) -> Answer:
        """The tree as a picture, if somebody who can draw was handed in."""
        tree = self._begun()
        if draw is None:
            where = "Nobody here can draw; the operator's program makes pictures. printTree gives the tree as text."
            return self._done(self.state, {"picture": where})
        return replace(self._done(self.state, {"picture": "The tree was drawn for the operator."}), picture=draw(tree))

    @_answering
    def check_tree(self) -> Answer:
        """What is wrong or unfinished."""
        found = findings(self._begun(), self.brief)
        complete = not any(finding.severity == "error" for finding in found)
        return self._done(self.state, {"complete": complete, "findings": told(found)})

    @_answering
    def list_routines(self) -> Answer:
        """Routines, what they take, who can do them, and why others cannot."""
        rows = [
            {
                "name": routine.wire_name,
                "purpose": routine.purpose,
                "arguments": {argument.name: list(argument.kinds) for argument in routine.arguments},
                "can_be_done_by": list(self.offers[routine.id].able_types),
                "not_by": [reason.message for reason in self.offers[routine.id].refused],
            }
            for routine in self.brief.routines.routines
        ]
        return self._done(self.state, {"routines": rows, "entities": [entity.id for entity in self.cast.everyone]})

    @_answering
    def declare_impossible(self, missing: str, reason: str) -> Answer:
        """
        Say that the mission cannot be done.

        Parameters
        ----------
        missing
            The capability or limit that is missing.
        reason
            Why it is needed.
        """
        self._check_not_ended()
        check_text(missing, "missing", MAX_NAME)
        check_text(" ".join(reason.split()), "reason", MAX_OBJECTIVE)
        declared, doubts = impossible(missing, reason, self.brief)
        return self._done(replace(self.state, impossible=(declared,)), {"declared": "impossible"}, doubts)

    @_answering
    def declare_unclear(self, words: str, question: str) -> Answer:
        """
        Say that the mission cannot be planned as it stands.

        Parameters
        ----------
        words
            The words of the mission in question.
        question
            What the operator should say.
        """
        self._check_not_ended()
        check_text(" ".join(words.split()), "words", MAX_NAME)
        check_text(" ".join(question.split()), "question", MAX_OBJECTIVE)
        declared = unclear(words, " ".join(question.split()), self.brief)
        return self._done(replace(self.state, unclear=(declared,)), {"declared": "unclear"})

    def _grown(
        self,
        tree: MissionTree,
        above: MissionNode,
        nodes: Sequence[MissionNode],
        names: Sequence[str],
        gate: Gate,
        pairs: Sequence[Pair],
        cast: Cast,
        notices: tuple[Reason, ...],
    ) -> Answer:
        """The last step of every call that adds nodes: gate, size, links; then, and only then, the new state."""
        if not nodes:
            raise refuse(RULE, "The list of names is empty.", hint="Name at least one.")
        self._check_gate(above, gate)
        check_size(tree, above, len(nodes))
        grown = with_children(with_entities(tree, cast.added), above.id, nodes, gate)
        links = []
        for first, second, kind in pairs:
            ends = [find_node(grown, end, nodes, names, self.brief.routines, cast) for end in (first, second)]
            links.append(Link(ends[0].id, ends[1].id, kind))
        check_links(grown, links, self.brief.routines)
        gates = FrozenMap({**self.state.gates, above.id: gate})
        state = replace(self.state, tree=with_links(grown, links), gates=gates)
        data: dict[str, Any] = {"parent": above.id, "added": named(nodes)}
        if links:
            data["links"] = [[link.first, link.second, name_of_kind(link.kind)] for link in links[:MOST_SHOWN]]
        return self._done(state, data, notices)

    def _done(self, state: State, data: Mapping[str, Any], notices: tuple[Reason, ...] = ()) -> Answer:
        self.state = state
        following = state_of(state.tree) if state.tree is not None else {}
        return Answer(ok=True, data={**data, **following}, notices=notices)

    @property
    def _on_offer(self) -> list[str]:
        """Routines that some robot can do, as a model would call them."""
        return [form_of(known) for known in self.brief.routines.routines if self.offers[known.id].able]

    def _check_not_ended(self) -> None:
        if self.state.impossible or self.state.unclear:
            raise refuse("ended", "The mission has been declined; that was the last word.", hint="Say no more.")

    def _begun(self) -> MissionTree:
        self._check_not_ended()
        if self.tree is None:
            raise refuse("no_tree", "There is no tree yet.", hint="Begin with HierarchicalTree_init(objective).")
        return self.tree

    def _node(self, tree: MissionTree, name: str) -> MissionNode:
        return find_node(tree, name, (), (), self.brief.routines, self.cast)

    def _check_gate(self, above: MissionNode, gate: Gate) -> None:
        told_gate = self.state.gates.get(above.id, above.gate)
        if above.children and told_gate is not None and told_gate != gate:
            raise refuse(
                "gate_conflict",
                f"The children of {above.label!r} combine by {told_gate.upper()}, not by {gate.upper()}.",
                node=above.id,
                found=gate,
                needed=told_gate,
                hint=f"Use {told_gate.upper()}, or insert a task below it for the others and give that {gate.upper()}.",
            )

    @staticmethod
    def _still(tree: MissionTree, node: str) -> bool:
        return node in tree.by_id and bool(tree.by_id[node].children)


_PRIMITIVE = Reason(
    rule="not_primitive",
    message="isPrimitive was taken as false: a task is done by routines below it, which end in the primitive actions.",
    severity="notice",
    hint="Put routines below the task with attachMultiSubTrees.",
)
