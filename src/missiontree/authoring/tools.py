"""
The tree-building functions: one registry, from which come the tools offered to models, the validation of arguments and the docs.

The first six names and their arguments are the paper's (Gupta et al., section III-B).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from missiontree.authoring.answer import Answer, RefusalError, refuse
from missiontree.authoring.builder import Draw, State, TreeBuilder
from missiontree.authoring.matching import did_you_mean, listed, quoted
from missiontree.authoring.shapes import CALLS, FLAG, FLAGS, GATE, KIND, PAIRS, SECONDS, TEXT, TEXTS, Shape
from missiontree.authoring.wire import RULE, parse_arguments
from missiontree.formats.digest import canonical
from missiontree.mission.reason import Reason


@dataclass(frozen=True, slots=True)
class Parameter:
    """
    An argument of a tree-building function.

    Parameters
    ----------
    name
        Its name on the wire.
    shape
        What it may be.
    says
        What it means, for models and people.
    optional
        Whether it may be left out. Default false.
    also
        Other spellings accepted.
    """

    name: str
    shape: Shape
    says: str
    optional: bool = False
    also: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class TreeFunction:
    """
    A tree-building function.

    Parameters
    ----------
    name
        Its name on the wire.
    description
        What it does, for models and people.
    parameters
        Its arguments, in order.
    function
        Does it: takes the builder and the arguments, read.
    """

    name: str
    description: str
    parameters: tuple[Parameter, ...]
    function: Callable[[TreeBuilder, dict[str, Any]], Answer]


_PARENT = Parameter("parentString", TEXT, "Id or name of the task above.")
_GATE = Parameter("LogicalConstraint", GATE, "Over all children of the parent: AND does all of them, XOR exactly one.")
_PAIRS = Parameter(
    "constraintPairs",
    PAIRS,
    "Links [a, b] or [a, b, kind]: Precedence (default: a ends before b starts), SameRobot, DifferentRobot, Until (a lasts until b "
    "ends), HandOver (another robot takes over where a ends, just then). a, b: ids, names, places in this call's list from 0, or "
    "SearchTree(cat).",
    optional=True,
    also=("contraintsPairs", "constraintsPairs"),
)
_FIRST = Parameter("first", TEXT, "Id or name of the first node.")
_SECOND = Parameter("second", TEXT, "Id or name of the second node.")

TOOLS: tuple[TreeFunction, ...] = (
    TreeFunction(
        "HierarchicalTree_init",
        "Begin the mission tree. The objective is its root.",
        (Parameter("objective", TEXT, "The mission in words."),),
        lambda builder, given: builder.init(given["objective"]),
    ),
    TreeFunction(
        "CreateAndAddSubtask",
        "Add one task below a task.",
        (
            _PARENT,
            Parameter("isPrimitive", FLAG, "False: routines below do it."),
            Parameter("taskName", TEXT, "What the task is called."),
            _GATE,
        ),
        lambda builder, given: builder.add_subtasks(
            given["parentString"], [given["isPrimitive"]], [given["taskName"]], given["LogicalConstraint"]
        ),
    ),
    TreeFunction(
        "addMultiSubtasks",
        "Add several tasks below a task, with links among them.",
        (
            _PARENT,
            Parameter("isPrimitiveList", FLAGS, "False for each task: routines below do it."),
            Parameter("taskNameList", TEXTS, "What the tasks are called."),
            _GATE,
            _PAIRS,
        ),
        lambda builder, given: builder.add_subtasks(
            given["parentString"],
            given["isPrimitiveList"],
            given["taskNameList"],
            given["LogicalConstraint"],
            given.get("constraintPairs", ()),
        ),
    ),
    TreeFunction(
        "attachMultiSubTrees",
        "Put routines below a task. Every branch of the tree ends in them.",
        (
            _PARENT,
            Parameter("treeNames", TEXTS, "Names of routines, such as SearchTree."),
            Parameter(
                "treeArguments",
                CALLS,
                "Per routine a list: its arguments in order, entities by name, then, if only some may do it, a list of robot types: "
                '["gravel", "road", ["dumper"]].',
            ),
            _GATE,
            _PAIRS,
        ),
        lambda builder, given: builder.attach_subtrees(
            given["parentString"],
            given["treeNames"],
            given["treeArguments"],
            given["LogicalConstraint"],
            given.get("constraintPairs", ()),
        ),
    ),
    TreeFunction("printTree", "Show the tree as text.", (), lambda builder, given: builder.print_tree()),
    TreeFunction(
        "plotTree", "Draw the tree for the operator.", (), lambda builder, given: builder.plot_tree(given.get("draw"))
    ),
    TreeFunction(
        "introduceEntity",
        "Make known somebody or something that the scene does not have. Where it is stays open.",
        (
            Parameter("name", TEXT, "What it is called."),
            Parameter("kind", TEXT, "person, animal, object, place, or a kind of the scene."),
        ),
        lambda builder, given: builder.introduce_entity(given["name"], given["kind"]),
    ),
    TreeFunction(
        "removeSubtask",
        "Take a node out, with all below it and the links that end there.",
        (Parameter("subtask", TEXT, "Id or name of the node."),),
        lambda builder, given: builder.remove_subtask(given["subtask"]),
    ),
    TreeFunction(
        "setLink",
        "Link two nodes that stand in the tree.",
        (_FIRST, _SECOND, Parameter("kind", KIND, "Kind of the link; default Precedence.", optional=True)),
        lambda builder, given: builder.set_link(given["first"], given["second"], given.get("kind", "precedence")),
    ),
    TreeFunction(
        "dropLink",
        "Take away the links from one node to another.",
        (_FIRST, _SECOND, Parameter("kind", KIND, "Only links of this kind; default all.", optional=True)),
        lambda builder, given: builder.drop_link(given["first"], given["second"], given.get("kind")),
    ),
    TreeFunction(
        "setTimes",
        "Give a node a release time and a deadline, in seconds from the mission's start; what is left out is taken away.",
        (
            Parameter("subtask", TEXT, "Id or name of the node."),
            Parameter("release_s", SECONDS, "Nothing below it starts earlier.", optional=True),
            Parameter("deadline_s", SECONDS, "All below it has ended by then.", optional=True),
        ),
        lambda builder, given: builder.set_times(
            given["subtask"], given.get("release_s") or 0.0, given.get("deadline_s")
        ),
    ),
    TreeFunction(
        "checkTree", "List what is wrong or unfinished in the tree.", (), lambda builder, given: builder.check_tree()
    ),
    TreeFunction(
        "listRoutines",
        "List the routines: what each takes, who can do it, and why others cannot.",
        (),
        lambda builder, given: builder.list_routines(),
    ),
    TreeFunction(
        "declareImpossible",
        "Say that the mission cannot be done: a capability, robot or thing is missing, or a limit or zone forbids it. Ends the dialogue.",
        (
            Parameter("missing", TEXT, "What is missing, by its name: carry, payload_kg, zone vault."),
            Parameter("reason", TEXT, "Why the mission needs it."),
        ),
        lambda builder, given: builder.declare_impossible(given["missing"], given["reason"]),
    ),
    TreeFunction(
        "declareUnclear",
        "Say that the mission may mean several things, or has what no tree holds: a condition, a clock time or deadline, a way not to "
        "take, what only measuring could tell. Ends the dialogue.",
        (
            Parameter("words", TEXT, "The words in question, as the mission has them."),
            Parameter("question", TEXT, "What the operator should say."),
        ),
        lambda builder, given: builder.declare_unclear(given["words"], given["question"]),
    ),
)
BY_NAME = {tool.name: tool for tool in TOOLS}


class ToolBox:
    """
    The tree-building functions over one builder, called by name with arguments as they come over the wire.

    Parameters
    ----------
    builder
        The tree under construction.
    draw
        Makes an SVG of a tree, for ``plotTree``; None if nobody here can draw.
    """

    def __init__(self, builder: TreeBuilder, draw: Draw | None = None) -> None:
        self.builder = builder
        self._draw = draw
        self._state: State = builder.state
        self._answered: dict[str, Answer] = {}

    def call(self, name: str, arguments: str | Mapping[str, Any] = "") -> Answer:
        """
        Call a function. It applies whole, or is refused and changes nothing; it raises nothing, whatever the arguments.

        Parameters
        ----------
        name
            Name on the wire.
        arguments
            JSON text as a model wrote it, or a mapping.
        """
        try:
            tool = _find_tool(name)
            parsed = parse_arguments(arguments)
            call = f"{tool.name} {canonical(parsed)}"
            if self._state is not self.builder.state:
                self._state, self._answered = self.builder.state, {}
            if call in self._answered:
                return _repeated(tool.name, self._answered[call])
            answer = self._run(tool, parsed)
        except RefusalError as refusal:
            return Answer(ok=False, reasons=refusal.reasons)
        if self._state is self.builder.state:
            self._answered[call] = answer
        return answer

    def _run(self, tool: TreeFunction, parsed: dict[str, Any]) -> Answer:
        try:
            given = read_arguments(tool, parsed)
        except RefusalError as refusal:
            return Answer(ok=False, reasons=refusal.reasons)
        if tool.name == "plotTree":
            given["draw"] = self._draw
        return tool.function(self.builder, given)


def read_arguments(tool: TreeFunction, parsed: Mapping[str, Any]) -> dict[str, Any]:
    """
    The arguments of a call, each of the shape its function takes.

    Raises
    ------
    RefusalError
        ``malformed_arguments``: a key that is unknown, missing or given under two spellings, or a value of another shape.
    """
    spelt = {spelling: parameter for parameter in tool.parameters for spelling in (parameter.name, *parameter.also)}
    form = f"{tool.name} takes {listed(parameter.name for parameter in tool.parameters)}."
    given: dict[str, Any] = {}
    for key, value in parsed.items():
        parameter = spelt.get(key)
        if parameter is None:
            hint = f"{did_you_mean(key, (known.name for known in tool.parameters))} {form}".strip()
            raise refuse(RULE, f"{tool.name} has no argument {quoted(key)}.", hint=hint)
        if parameter.name in given:
            raise refuse(RULE, f"{parameter.name} is given twice, under two spellings.", hint="Give it once.")
        given[parameter.name] = parameter.shape.read(value, key)
    if missing := [known.name for known in tool.parameters if not known.optional and known.name not in given]:
        raise refuse(RULE, f"{tool.name} lacks {listed(missing)}.", hint=form)
    return given


def tools_table() -> str:
    """The functions as a Markdown table; the reference holds it, and a test keeps it true."""
    rows = ["| Function | What it does | Arguments |", "| --- | --- | --- |"]
    for tool in TOOLS:
        arguments = "<br>".join(
            f"`{known.name}` ({known.shape.says}{', optional' if known.optional else ''}): {known.says}"
            for known in tool.parameters
        )
        rows.append(f"| `{tool.name}` | {tool.description} | {arguments or 'none'} |")
    return "\n".join(rows) + "\n"


def _find_tool(name: str) -> TreeFunction:
    if name not in BY_NAME:
        hint = f"{did_you_mean(name, BY_NAME)} Functions are: {listed(BY_NAME)}.".strip()
        raise refuse("unknown_function", f"There is no function {quoted(name)}.", hint=hint)
    return BY_NAME[name]


def _repeated(name: str, earlier: Answer) -> Answer:
    message = f"The same call of {name} was answered before, and the tree has not changed since."
    hint = (
        "Go on with what that answer says."
        if earlier.ok
        else "Put right what it was refused for; see the reasons below."
    )
    return Answer(ok=False, reasons=(Reason(rule="repeated_call", message=message, hint=hint), *earlier.reasons))
