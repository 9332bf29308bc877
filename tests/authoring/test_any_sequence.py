"""Any sequence of calls, sound or junk, leaves a well-formed tree; a refused one changes nothing; all of it replays."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule

from missiontree.authoring.author import author_tree
from missiontree.authoring.budgets import Budgets
from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.findings import findings
from missiontree.authoring.tools import TOOLS, ToolBox
from missiontree.authoring.transcript import replay
from missiontree.formats.document import write_text
from missiontree.llm.scripted import ScriptedModel
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.scene import Scene
from missiontree.routines.library import built_in
from tests.builders import paper_fleet

TEXT = "Find the cat and bring the child to mom"
SCENE = Scene(entities=(Entity(id="cat", kind="animal"), Entity(id="child", kind="person", aliases=("kid",))))
BRIEFS = [
    MissionBrief(text=TEXT, fleet=paper_fleet(), routines=built_in()),
    MissionBrief(text=TEXT, fleet=paper_fleet(), routines=built_in(), scene=SCENE),
]

NAMES = st.sampled_from(
    ["A", "B", "C", "a", "b", "the A", "Inspect rooms", "Inspect the room", "A 2", "", "\u0410", TEXT, "Search(cat)"]
)
ENTITIES = st.sampled_from(["cat", "Cat", "child", "kid", "mom", "room", "", "\ud800"])
GATES = st.sampled_from(["AND", "AND", "XOR", "or"])
KINDS = st.sampled_from(["Precedence", "SameRobot", "DifferentRobot", "Until", "until", "Before"])
ENDS = (
    NAMES
    | st.integers(min_value=-1, max_value=3)
    | st.sampled_from(["SearchTree(cat)", "Reach(mom)", "search-cat", "b", "c"])
)
PAIR: st.SearchStrategy[list[Any]] = st.lists(ENDS, min_size=2, max_size=2) | st.tuples(ENDS, ENDS, KINDS).map(list)
NONE: st.SearchStrategy[Any] = st.sampled_from([None, {}])
PAIRS: st.SearchStrategy[Any] = st.lists(PAIR, max_size=3) | NONE
JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=6,
)
ARGUMENT_NAMES = sorted({parameter.name for tool in TOOLS for parameter in tool.parameters})
JUNK = st.dictionaries(st.sampled_from(ARGUMENT_NAMES) | st.text(max_size=5), JSON | NAMES, max_size=5)


class AnySequence(RuleBasedStateMachine):
    """Calls as they come."""

    @initialize(brief=st.sampled_from(BRIEFS), begun=st.booleans())
    def begin(self, brief: MissionBrief, begun: bool) -> None:
        self.brief = brief
        self.box = ToolBox(TreeBuilder(brief))
        self.calls: list[tuple[str, str]] = []
        if begun:
            self.call("HierarchicalTree_init", {"objective": TEXT})

    def call(self, name: str, arguments: dict[str, Any] | str) -> None:
        text = arguments if isinstance(arguments, str) else json.dumps(arguments)
        before = self.box.builder.state
        answer = self.box.call(name, text)
        json.loads(answer.text)
        assert answer.ok != bool(answer.reasons)
        if not answer.ok:
            assert self.box.builder.state is before
            assert all(reason.message for reason in answer.reasons)
        if not before.impossible:
            self.calls.append((name, text))

    @rule(parent=NAMES, primitive=st.booleans(), name=NAMES, gate=GATES)
    def subtask(self, parent: str, primitive: bool, name: str, gate: str) -> None:
        arguments = {"parentString": parent, "isPrimitive": primitive, "taskName": name, "LogicalConstraint": gate}
        self.call("CreateAndAddSubtask", arguments)

    @rule(parent=NAMES, names=st.lists(NAMES, max_size=3), gate=GATES, pairs=PAIRS)
    def subtasks(self, parent: str, names: list[str], gate: str, pairs: Any) -> None:
        lists = {"isPrimitiveList": [False] * len(names), "taskNameList": names}
        self.call(
            "addMultiSubtasks", {"parentString": parent, **lists, "LogicalConstraint": gate, "constraintPairs": pairs}
        )

    @rule(
        parent=NAMES,
        trees=st.lists(
            st.tuples(
                st.sampled_from(["SearchTree", "Reach", "Transport", "Fly"]), st.lists(ENTITIES, min_size=1, max_size=2)
            ),
            max_size=3,
        ),
        gate=GATES,
        pairs=PAIRS,
    )
    def subtrees(self, parent: str, trees: list[tuple[str, list[str]]], gate: str, pairs: Any) -> None:
        lists = {"treeNames": [name for name, _ in trees], "treeArguments": [given for _, given in trees]}
        self.call(
            "attachMultiSubTrees",
            {"parentString": parent, **lists, "LogicalConstraint": gate, "contraintsPairs": pairs},
        )

    @rule(name=ENTITIES, kind=st.sampled_from(["person", "place", "robot"]))
    def entity(self, name: str, kind: str) -> None:
        self.call("introduceEntity", {"name": name, "kind": kind})

    @rule(name=NAMES | st.sampled_from(["search-cat", "b", "c"]))
    def removal(self, name: str) -> None:
        self.call("removeSubtask", {"subtask": name})

    @rule(function=st.sampled_from(["setLink", "dropLink"]), first=NAMES, second=NAMES, kind=KINDS)
    def link(self, function: str, first: str, second: str, kind: str) -> None:
        self.call(function, {"first": first, "second": second, "kind": kind})

    @rule(name=NAMES, release=st.sampled_from([0, 1, 5.5, -1, "x"]), deadline=st.sampled_from([None, 0, 3, 9.25, True]))
    def times(self, name: str, release: object, deadline: object) -> None:
        self.call("setTimes", {"subtask": name, "release_s": release, "deadline_s": deadline})

    @rule(function=st.sampled_from(["printTree", "plotTree", "checkTree", "listRoutines"]))
    def look(self, function: str) -> None:
        self.call(function, "")

    @rule(
        function=st.sampled_from([tool.name for tool in TOOLS if tool.name != "declareImpossible"]),
        junk=JUNK | st.text(max_size=20),
    )
    def junk(self, function: str, junk: Any) -> None:
        self.call(function, junk)

    @precondition(lambda self: self.calls)
    @rule(number=st.integers(min_value=0), cut=st.integers(min_value=0, max_value=30))
    def again_or_cut_off(self, number: int, cut: int) -> None:
        name, text = self.calls[number % len(self.calls)]
        self.call(name, text[: len(text) - cut])

    @rule(reason=st.sampled_from(["", "no routine"]))
    def decline(self, reason: str) -> None:
        self.call("declareImpossible", {"missing": "sing", "reason": reason})

    @invariant()
    def the_tree_is_well_formed(self) -> None:
        tree = self.box.builder.tree
        if tree is None:
            return
        assert replace(tree) == tree, "it passes the checks of its birth again"
        for node in tree.nodes:
            assert node.gate != "xor" or len(node.children) > 1
        rules = {finding.rule for finding in findings(tree, self.brief)}
        assert rules <= {"open_leaf", "link_never_binds"}, "calls let in nothing that the gate would refuse"

    def teardown(self) -> None:
        """The same calls in a dialogue, recorded, give the same tree, and so does the recording."""
        if not hasattr(self, "calls"):
            return
        model = ScriptedModel([[call] for call in self.calls])
        budgets = Budgets(turns=1_000, calls=1_000, refusals=1_000)
        made = author_tree(self.brief, model, budgets)
        again = replay(made.transcript, self.brief)
        assert made.tree == again.tree == self.box.builder.tree
        if made.tree is not None:
            assert write_text(made.tree, "tree") == write_text(again.tree, "tree")


AnySequence.TestCase.settings = settings(max_examples=60, stateful_step_count=30, deadline=None)
TestAnySequence = AnySequence.TestCase
