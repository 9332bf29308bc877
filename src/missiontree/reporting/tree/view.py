"""The tree as an outline for the terminal, and as a picture."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.errors import InputError
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.tree import MissionTree
from missiontree.reporting.tree.chosen import chosen_actions, chosen_tasks
from missiontree.reporting.tree.shape import NO_NAMES, Names, Shape, ShapeNode, link_words, shape_of
from missiontree.reporting.tree.svg import MOST_NODES, svg_of


def tree_text(tree: MissionTree | GroundedTree, *, plan: Plan | None = None, rank: int | None = None) -> str:
    """
    A tree as an outline: a line per node with the gate over its children, then a line per link, in words.

    With a plan and a rank, each line also says who does it in that alternative, or that it is not chosen. Names are harmless: on
    one line, without control characters. The text ends in a line feed.

    Raises
    ------
    InputError
        If the plan has no alternative of that rank, or another tree.
    """
    shape = shape_of(tree) if rank is None else _seen(tree, plan, rank)
    return "".join(f"{line}\n" for line in (*_outline(shape), *link_words(shape)))


def tree_svg(
    tree: MissionTree | GroundedTree,
    *,
    plan: Plan | None = None,
    rank: int | None = None,
    unfolded: bool = False,
    most: int = MOST_NODES,
) -> str:
    """
    A tree as a picture, as an SVG document.

    Tasks are round, actions and routines are red boxes, routines expanded over the fleet stand in red frames; edges below an XOR
    are dashed, precedence is a blue arrow, other links are told by their pattern, their ends and a word. What one robot does stands in
    a column, in its order. Levels, order and distances are those of :func:`missiontree.reporting.tree.layout.tidy_layout`. Names
    are shown as words, never as markup. Equal input gives equal bytes.

    Parameters
    ----------
    tree
        The tree.
    plan
        The plan that it belongs to: its fleet gives the robots their names and colours. Default: none.
    rank
        The alternative to be lit, with its robots; everything else is drawn quietly. Needs a plan. Default: none is lit.
    unfolded
        Draw the plan's grounded tree instead of the mission tree: routines in red frames, down to the actions. Needs a plan.
    most
        How many nodes are drawn at most, at least 1, default 500. Of a larger tree, subtrees are folded into a card each, the deepest
        first, those of the alternative that is lit last.

    Raises
    ------
    InputError
        If the plan has no such alternative or no grounded tree, or the tree is not the plan's.
    """
    if most < 1:
        raise InputError(f"a picture of at most {most} nodes", where="most", accepted="1 or more")
    if unfolded and isinstance(tree, MissionTree):
        if plan is None or plan.grounding is None:
            raise InputError("there is no grounded tree to unfold the routines from", where="unfolded")
        tree = _own(tree, plan, plan.grounding.tree)
    shape = _seen(tree, plan, rank)
    ranks = len(plan.ranking.alternatives) if plan is not None and plan.ranking is not None else 0
    prefix = f"mt-tree-{'actions' if isinstance(tree, GroundedTree) else 'tasks'}-{rank or 0}"
    return svg_of(shape, most, rank, ranks, prefix)


def _seen(tree: MissionTree | GroundedTree, plan: Plan | None, rank: int | None) -> Shape:
    """A tree with robots on it, and an alternative lit if there is a rank."""
    if rank is not None and plan is None:
        raise InputError(f"rank {rank} of no plan", where="rank", accepted="a rank together with a plan")
    if plan is not None:
        _own(tree, plan, tree)
    shape = shape_of(tree, NO_NAMES if plan is None else _names(plan))
    if isinstance(tree, GroundedTree):
        return chosen_actions(shape, tree, plan, rank)
    return shape if plan is None or rank is None else chosen_tasks(shape, tree, plan, rank)


def _names(plan: Plan) -> Names:
    """What scene and fleet call what the tree names by id."""
    entities = {entity.id: entity.label for entity in plan.brief.world.all_entities}
    return Names(entities, {kind.id: kind.label for kind in plan.brief.fleet.types})


def _own(tree: MissionTree | GroundedTree, plan: Plan, other: MissionTree | GroundedTree) -> MissionTree | GroundedTree:
    """The other tree, if the first is the plan's own."""
    grounded = plan.grounding.tree if plan.grounding is not None else None
    if tree is not plan.tree and tree is not grounded and tree not in (plan.tree, grounded):
        raise InputError(
            "the tree is not the plan's", where="tree", accepted="the plan's mission tree or grounded tree"
        )
    return other


def _outline(shape: Shape) -> Iterator[str]:
    stack = [(0, "", "")]
    while stack:
        index, lead, below = stack.pop()
        yield lead + _line(shape.nodes[index])
        children = shape.children[index]
        last = children[-1:]
        for child in reversed(children):
            branch, further = ("└── ", "    ") if (child,) == last else ("├── ", "│   ")
            stack.append((child, below + branch, below + further))


def _line(node: ShapeNode) -> str:
    gate = f" [{node.gate.upper()}]" if node.gate else ""
    note = f" ({node.note})" if node.note else ""
    team = f": {', '.join(badge.text for badge in node.team)}" if node.team else ""
    return f"{node.label}{gate}{note}{team}{' (not chosen)' if node.state == 'quiet' else ''}"
