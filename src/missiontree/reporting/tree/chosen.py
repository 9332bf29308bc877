"""Who does what in a drawn tree: the chosen alternative lit, robots on the branches they go."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from missiontree.errors import InputError
from missiontree.mission.alternative import Alternative, selected_nodes
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.tree import MissionTree
from missiontree.reporting.escape import one_line
from missiontree.reporting.palette import Livery, liveries, livery
from missiontree.reporting.references import refuse_dangling
from missiontree.reporting.tree.shape import Badge, Shape, ShapeNode, folded_name


@dataclass(frozen=True, slots=True)
class Team:
    """
    Names and liveries of robots and of their types.

    Parameters
    ----------
    labels
        What people call a type, by its id; of a type that is missing, its id.
    of_types, of_robots
        Liveries, by id. A type looks like its first robot.
    several
        Types of more than one robot.
    """

    labels: Mapping[str, str]
    of_types: Mapping[str, Livery]
    of_robots: Mapping[str, Livery] = field(default_factory=dict)
    several: frozenset[str] = frozenset()

    def called(self, robot_type: str) -> str:
        """What people call a type."""
        return one_line(self.labels.get(robot_type, robot_type))

    def badge(self, robot_type: str, robot: str | None = None) -> Badge:
        """The badge of a type, or of one of its robots."""
        text = self.called(robot_type)
        if robot is None or robot not in self.of_robots:
            return Badge(text, self.of_types[robot_type])
        if robot_type in self.several:
            text = f"{text} · {one_line(robot.removeprefix(f'{robot_type}-'))}"
        return Badge(text, self.of_robots[robot])


def team_of(tree: GroundedTree, plan: Plan | None) -> Team:
    """The team of a plan; without one, what the tree itself says, types in the order in which they come up."""
    named = list(dict.fromkeys(node.action.robot_type for node in tree.nodes if node.action is not None))
    if plan is None:
        return Team({}, {name: livery(place) for place, name in enumerate(named)})
    fleet, own = plan.brief.fleet, liveries(plan.brief.fleet)
    types = {kind.id: own[kind.members[0].id] for kind in fleet.types}
    foreign = [name for name in named if name not in types]
    return Team(
        labels={kind.id: kind.label for kind in fleet.types},
        of_types=types | {name: livery(len(own) + place) for place, name in enumerate(foreign)},
        of_robots=own,
        several=frozenset(kind.id for kind in fleet.types if len(kind.members) > 1),
    )


def alternative_of(plan: Plan, rank: int) -> Alternative:
    """
    The alternative of that rank.

    Raises
    ------
    InputError
        If there is none, or it does not fit the plan's own tree.
    """
    refuse_dangling(plan)
    alternatives = plan.ranking.alternatives if plan.ranking and plan.grounding else ()
    found = next((alternative for alternative in alternatives if alternative.rank == rank), None)
    if found is None:
        ranks = f"1 to {len(alternatives)}" if alternatives else "no rank at all: the plan has no alternatives"
        raise InputError(f"there is no alternative of rank {rank}", where="rank", accepted=ranks)
    assert plan.grounding is not None
    tree = plan.grounding.tree
    for choice in found.choices:
        if choice.xor >= len(tree.nodes) or choice.child not in tree.children[choice.xor]:
            raise _damaged(f"node {choice.child} is not below node {choice.xor}", rank)
    try:
        list(selected_nodes(tree, found.choices))
    except KeyError as error:
        raise _damaged(f"no child is chosen at node {error.args[0]}", rank) from error
    return found


def _damaged(found: str, rank: int) -> InputError:
    hint = "The plan is damaged; `missiontree check` lists its faults."
    return InputError(f"in alternative {rank}, {found}", where="ranking.alternatives", hint=hint)


def chosen_tasks(shape: Shape, tree: MissionTree, plan: Plan, rank: int) -> Shape:
    """The mission tree with an alternative lit, its robots on the routines."""
    alternative = alternative_of(plan, rank)
    assert plan.grounding is not None
    grounded = plan.grounding.tree
    team, robots = team_of(grounded, plan), _robots(plan, rank)
    badges: dict[str, dict[Badge, int]] = defaultdict(dict)
    for filled in alternative.roles:
        source = grounded.roles[filled.role].source
        badge = team.badge(filled.robot_type, robots.get(filled.role))
        if source is not None:
            badges[source][badge] = badges[source].get(badge, 0) + 1
    lit = {grounded.nodes[node].source for node in selected_nodes(grounded, alternative.choices)}
    nodes = [
        replace(drawn, state="lit" if node.id in lit else "quiet", team=tuple(_counted(badges.get(node.id, {}))))
        for drawn, node in zip(shape.nodes, tree.nodes, strict=True)
    ]
    return replace(shape, nodes=tuple(nodes))


def _robots(plan: Plan, rank: int) -> dict[int, str]:
    """Robot by role, if the alternative is scheduled."""
    schedule = next((one for one in plan.schedules if one.rank == rank), None)
    return {one.role: one.robot for one in schedule.assignments} if schedule is not None else {}


def _counted(badges: Mapping[Badge, int]) -> Iterator[Badge]:
    for badge, count in badges.items():
        yield badge if count == 1 else replace(badge, text=f"{count} × {badge.text}")


def chosen_actions(shape: Shape, tree: GroundedTree, plan: Plan | None, rank: int | None) -> Shape:
    """
    The grounded tree with the robots on their branches, an alternative lit if a rank is given.

    A branch that ends in "by" and the robot's name does without these words: its badge says them.
    """
    alternative = None if plan is None or rank is None else alternative_of(plan, rank)
    lit = frozenset(selected_nodes(tree, alternative.choices)) if alternative is not None else frozenset()
    robots = _robots(plan, rank) if plan is not None and rank is not None else {}
    team, nodes = team_of(tree, plan), []
    for index, (drawn, part) in enumerate(zip(shape.nodes, _parts(tree), strict=True)):
        node = drawn if alternative is None else replace(drawn, state="lit" if index in lit else "quiet")
        if part is not None:
            robot = robots.get(part.role) if index in lit else None
            node = _badged(node, team, part.robot_type, robot)
        nodes.append(node)
    return replace(shape, nodes=tuple(nodes))


class _Part(NamedTuple):
    role: int
    robot_type: str


def _parts(tree: GroundedTree) -> list[_Part | None]:
    """Role and robot type of branches all of whose children are actions of one role, and of actions below no such branch."""
    own = [None if node.action is None else _Part(node.action.role, node.action.robot_type) for node in tree.nodes]
    parts = list(own)
    for index, node in enumerate(tree.nodes):
        below = {own[child] for child in tree.children[index]}
        if node.kind == "and" and len(below) == 1 and None not in below:
            parts[index] = own[tree.children[index][0]]
            for child in tree.children[index]:
                parts[child] = None
    return parts


def _badged(node: ShapeNode, team: Team, robot_type: str, robot: str | None) -> ShapeNode:
    badge = team.badge(robot_type, robot)
    label, by, name = node.label.rpartition(" by ")
    if by and label and folded_name(name) in {folded_name(team.called(robot_type)), folded_name(robot_type)}:
        known = badge if robot_type in team.labels else replace(badge, text=name)
        return replace(node, label=label, team=(known,))
    return replace(node, team=(badge,))
