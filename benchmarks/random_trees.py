"""
Random grounded trees with fleets: small enough to be enumerated, rich enough to hold every rule that allocation keeps.

Same generator, same case: :func:`random_case` draws from the generator it is given and from nothing else.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from random import Random

from benchmarks.random_rules import RULES, TREE_RULES
from missiontree.allocation.flat import Flat, flatten
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, GroundedTree, NodeKind, Role
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.mission.tree import LinkKind

MAX_WORK = 200_000
SELDOM = 0.15
BUDGETS = ("energy_j", "water_l")


@dataclass(frozen=True, slots=True)
class Case:
    """
    A problem for allocators.

    Parameters
    ----------
    tree, fleet, weights, k
        As an allocator takes them.
    coupled
        Whether budgets, teams, links or rules for the whole mission were drawn at all.
    terms
        What is asked of the mission as a whole.
    """

    tree: GroundedTree
    fleet: Fleet
    weights: Weights
    k: int
    coupled: bool
    terms: Terms = NO_TERMS

    @property
    def flat(self) -> Flat:
        """All of it in the form that allocators work on."""
        return flatten(self.tree, self.fleet, self.weights, self.terms)


def random_case(rng: Random, rules: Sequence[str] | None = None) -> Case:
    """
    Draw a case; one that is too large for the oracle is drawn again, smaller.

    Parameters
    ----------
    rng
        Source of all luck.
    rules
        Rules that hold, see :data:`benchmarks.random_rules.RULES` and ``TREE_RULES``. Default: each of them seldom.
    """
    size = rng.randint(1, 20)
    while True:
        coupled = bool(rules) or rng.random() < 0.7
        fleet = random_fleet(rng, coupled)
        tree = random_tree(rng, fleet, size, coupled)
        if work(tree, fleet) <= MAX_WORK:
            weights = rng.choice((Weights(), Weights(), Weights(1, 0.5, 0.25), Weights(0, 1, 0)))
            k = rng.choice((1, 2, 3, 4, 10, 1000))
            drawn = [name for name in RULES if coupled and rng.random() < SELDOM] if rules is None else rules
            terms = NO_TERMS
            for name in (name for name in drawn if name in RULES):
                fleet, terms = RULES[name](rng, tree, fleet, terms)
            in_tree = [name for name in TREE_RULES if coupled and rng.random() < SELDOM] if rules is None else drawn
            for name in (name for name in in_tree if name in TREE_RULES):
                tree = TREE_RULES[name](rng, tree)
            return Case(tree, fleet, weights, k, coupled, terms)
        size = max(1, size - 1)


def random_fleet(rng: Random, coupled: bool) -> Fleet:
    """One to three types of one to three robots each; budgets only if coupled."""
    types = []
    for number in range(rng.randint(1, 3)):
        limits = {name: _amount(rng, 12) for name in BUDGETS if coupled and rng.random() < 0.4}
        totals = {name: _amount(rng, 20) for name in BUDGETS if coupled and rng.random() < 0.25}
        if rng.random() < 0.5:
            types.append(RobotType(id=f"t{number}", limits=limits, total_limits=totals, count=rng.randint(1, 3)))
        else:
            robots = tuple(
                Robot(
                    id=f"t{number}_{name}",
                    remaining={b: _amount(rng, 12) for b in BUDGETS if coupled and rng.random() < 0.5},
                )
                for name in "abc"[: rng.randint(1, 3)]
            )
            types.append(RobotType(id=f"t{number}", limits=limits, total_limits=totals, robots=robots))
    return Fleet(tuple(types))


def _amount(rng: Random, most: int) -> float:
    return rng.choice((rng.randint(0, most), rng.randint(0, 10 * most) / 10))


@dataclass
class _Growth:
    rng: Random
    types: tuple[str, ...]
    coupled: bool
    nodes: list[GroundedNode] = field(default_factory=list)
    roles: list[Role] = field(default_factory=list)
    teams: int = 0

    def add(self, parent: int, kind: NodeKind) -> int:
        self.nodes.append(GroundedNode(parent=parent, kind=kind, label=f"n{len(self.nodes)}"))
        return len(self.nodes) - 1

    def leaf(self, parent: int, role: int, robot_type: str) -> None:
        rng = self.rng
        uses = {name: _amount(rng, 4) for name in BUDGETS if self.coupled and rng.random() < 0.5}
        action = Action(
            name="act",
            text="Act",
            role=role,
            robot_type=robot_type,
            capability="act",
            estimate=Estimate(rng.randint(0, 2) / 2, rng.randint(0, 2), rng.randint(0, 1)),
            uses=uses,
            uses_at_least=uses,
        )
        label = f"n{len(self.nodes)}"
        self.nodes.append(GroundedNode(parent=parent, kind="action", label=label, action=action))

    def role(self, team: int | None = None) -> int:
        self.roles.append(Role(label=f"r{len(self.roles)}", team=team))
        return len(self.roles) - 1

    def single(self, parent: int) -> None:
        """A role that can be filled in up to three ways, with one to three actions each."""
        role = self.role()
        choice = self.add(parent, "xor")
        for robot_type in self.rng.choices(self.types, k=self.rng.randint(1, 3)):  # several branches of one type, too
            way = self.add(choice, "and")
            for _ in range(self.rng.randint(1, 3)):
                self.leaf(way, role, robot_type)

    def team(self, parent: int) -> None:
        """Two or three joint roles."""
        self.teams += 1
        both = self.add(parent, "and")
        for _ in range(self.rng.randint(2, 3)):
            role = self.role(self.teams)
            choice = self.add(both, "xor")
            for robot_type in self.rng.sample(self.types, self.rng.randint(1, min(2, len(self.types)))):
                self.leaf(choice, role, robot_type)

    def bare(self, parent: int) -> None:
        """A leaf with a role of its own, or, seldom, one more action of a role that stands elsewhere."""
        shared = self.coupled and self.roles and self.rng.random() < 0.15
        role = self.rng.randrange(len(self.roles)) if shared else self.role()
        self.leaf(parent, role, self.rng.choice(self.types))


def random_tree(rng: Random, fleet: Fleet, size: int, coupled: bool = True) -> GroundedTree:
    """
    Draw a grounded tree.

    Parameters
    ----------
    rng
        Source of all luck.
    fleet
        Its types fill the roles.
    size
        About how many roles there are.
    coupled
        Whether uses, teams, links and roles spread over the tree are drawn.
    """
    growth = _Growth(rng, tuple(kind.id for kind in fleet.types), coupled)
    if size == 1 and rng.random() < 0.5:
        growth.bare(-1)
        return GroundedTree(objective="random", nodes=tuple(growth.nodes), roles=tuple(growth.roles))
    growing = [growth.add(-1, rng.choice(("and", "xor")))]
    while growing:
        parent = growing.pop(rng.randrange(len(growing)))  # any order, so that numbers are seldom in preorder
        for _ in range(rng.choice((1, 2, 2, 3, 3))):
            luck = rng.random()
            if luck < 0.45:
                if len(growth.roles) + 2 * len(growing) >= size:
                    growth.bare(parent)
                    continue
                growing.append(growth.add(parent, rng.choice(("and", "xor"))))
            elif luck < 0.465:
                growth.add(parent, "xor")  # nobody can
            elif luck < 0.475:
                growth.add(parent, "and")  # nothing to do
            elif luck < 0.53 and coupled:
                growth.team(parent)
            elif luck < 0.80:
                growth.single(parent)
            else:
                growth.bare(parent)
    links = _links(rng, growth.nodes) if coupled else ()
    return GroundedTree(objective="random", nodes=tuple(growth.nodes), roles=tuple(growth.roles), links=links)


def _links(rng: Random, nodes: list[GroundedNode]) -> tuple[GroundedLink, ...]:
    links = []
    kinds: tuple[LinkKind, ...] = ("same_robot", "different_robot", "precedence")
    for _ in range(rng.choice((0, 0, 1, 2))):
        first, second = rng.randrange(len(nodes)), rng.randrange(len(nodes))
        if not (_contains(nodes, first, second) or _contains(nodes, second, first)):
            links.append(GroundedLink(first, second, rng.choice(kinds)))
    return tuple(links)


def _contains(nodes: list[GroundedNode], outer: int, inner: int) -> bool:
    while inner > outer:
        inner = nodes[inner].parent
    return inner == outer


def work(tree: GroundedTree, fleet: Fleet) -> int:
    """No oracle tries more assignments than this: ways through the tree times assignments of the most roles."""
    ways, roles = [1] * len(tree.nodes), [0] * len(tree.nodes)
    for node in range(len(tree.nodes) - 1, -1, -1):
        below = tree.children[node]
        if tree.nodes[node].kind == "action":
            roles[node] = 1
        elif tree.nodes[node].kind == "xor":
            ways[node] = max(1, sum(ways[child] for child in below))  # running into a dead end counts as a way
            roles[node] = max((roles[child] for child in below), default=0)
        else:
            for child in below:
                ways[node] *= ways[child]
            of_one = {tree.action(child).role for child in below if tree.nodes[child].kind == "action"}
            others = sum(roles[child] for child in below if tree.nodes[child].kind != "action")
            roles[node] = len(of_one) + others
    most = max(len(kind.members) for kind in fleet.types)
    return int(ways[0] * most ** min(roles[0], 40))
