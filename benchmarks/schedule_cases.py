"""
Random missions to be scheduled: small enough to be enumerated, rich enough to hold every rule that schedulers keep.

Everything lies on a line, so that distances need no map. Same generator, same case.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from random import Random
from typing import Any

from missiontree.mission.alternative import Alternative, Choice, RoleType
from missiontree.mission.certificate import Certificate
from missiontree.mission.charger import Charger
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, GroundedTree, Role
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.mission.tree import LinkKind

PLACES = ("p", "q", "r", "lost")
THINGS = ("box", "cat")
SHARED = ("door", "lift")
MOST_HOLDERS = 4
KINDS: tuple[LinkKind, ...] = ("precedence", "precedence", "precedence", "same_robot", "different_robot", "until")


@dataclass(frozen=True, slots=True)
class ScheduleCase:
    """A problem for schedulers, and what was drawn into it."""

    tree: GroundedTree
    alternative: Alternative
    fleet: Fleet
    scene: Scene
    terms: Terms
    features: frozenset[str]


@dataclass
class _Draw:
    rng: Random
    features: set[str] = field(default_factory=set)
    nodes: list[GroundedNode] = field(default_factory=list)
    roles: list[Role] = field(default_factory=list)
    holders: dict[str, int] = field(default_factory=dict)  # by shared resource

    def maybe(self, feature: str, chance: float) -> bool:
        """Whether a feature that the case has at all is drawn here."""
        return feature in self.features and self.rng.random() < chance


FEATURES = (
    "travel",
    "things",
    "budgets",
    "joint",
    "until",
    "links",
    "terms",
    "apart",
    "idle",
    "times",
    "comings",
    "shared",
    "handing",
)


def random_schedule_case(rng: Random) -> ScheduleCase:
    """Draw a case; each feature is in about every second one."""
    draw = _Draw(rng)
    draw.features = {name for name in FEATURES if rng.random() < 0.45}
    if "things" in draw.features:
        draw.features.add("travel")
    if "handing" in draw.features:
        draw.features.discard(
            "until"
        )  # an action may last until one ends with a hand-over to a third that waits for it: all at once
    fleet = _fleet(draw)
    tree = _tree(draw, fleet)
    scene = _scene(draw)
    alternative = _alternative(tree)
    fleet, terms = _terms(draw, tree, alternative, fleet)
    if rng.random() < 0.3:
        draw.features.add("home")
        terms = replace(terms, return_home=True, home_by_s=float(rng.randint(8, 40)) if rng.random() < 0.3 else None)
    if rng.random() < 0.5 and any("energy_j" in kind.limits for kind in fleet.types):
        draw.features.add("chargers")
        chargers = _chargers(rng, fleet)
        fleet = _within_full(rng, fleet)
        terms, scene = replace(terms, chargers=chargers), replace(scene, chargers=chargers)
    return ScheduleCase(tree, alternative, fleet, scene, terms, frozenset(draw.features))


def _position(draw: _Draw) -> Position | None:
    if "travel" not in draw.features or draw.rng.random() < 0.15:
        return None
    return Position(float(draw.rng.randint(-4, 9)), 0.0)


def _fleet(draw: _Draw) -> Fleet:
    rng, types = draw.rng, []
    for name in "ab"[: rng.randint(1, 2)]:
        limits = {} if rng.random() < 0.2 else {"max_speed_mps": rng.choice((1.0, 2.0, 3.0))}
        per_m = {}
        if draw.maybe("budgets", 0.8):
            limits["energy_j"] = float(rng.randint(4, 40))
            per_m = {"energy_j": rng.choice((0.3, 1.0))}
        totals = {"coins": float(rng.randint(3, 9))} if draw.maybe("budgets", 0.4) else {}
        number = rng.randint(1, 3)
        if draw.maybe("apart", 0.7):
            robots = tuple(
                Robot(
                    id=f"{name}{index}",
                    position=_position(draw),
                    remaining={"energy_j": float(rng.randint(4, 40))} if draw.maybe("budgets", 0.5) else {},
                    available_from_s=float(rng.randint(1, 6)) if draw.maybe("comings", 0.4) else None,
                    available_until_s=float(rng.randint(8, 25)) if draw.maybe("comings", 0.4) else None,
                )
                for index in range(number)
            )
            types.append(
                RobotType(
                    id=name,
                    capabilities=_WORK,
                    limits=limits,
                    uses_per_m=per_m,
                    total_limits=totals,
                    robots=robots,
                )
            )
        else:
            types.append(
                RobotType(
                    id=name,
                    capabilities=_WORK,
                    limits=limits,
                    uses_per_m=per_m,
                    total_limits=totals,
                    count=number,
                    position=_position(draw),
                    available_from_s=float(rng.randint(1, 6)) if draw.maybe("comings", 0.4) else None,
                    available_until_s=float(rng.randint(8, 25)) if draw.maybe("comings", 0.4) else None,
                )
            )
    return Fleet(tuple(types))


_WORK = {"work": 1.0}


def _tree(draw: _Draw, fleet: Fleet) -> GroundedTree:
    rng, count = draw.rng, draw.rng.randint(2, 5)
    draw.nodes.append(GroundedNode(parent=-1, kind="and", label="root"))
    tops: list[int] = []
    parent, left = 0, 0
    jointly = rng.sample(range(count), 2) if "joint" in draw.features else []
    for number in range(count):
        if left == 0 and count - number >= 2 and rng.random() < 0.3:
            parent, left = _inner(draw, 0), 2
            tops.append(parent)
        tops.append(_role(draw, parent if left else 0, rng.choice(fleet.types).id, number in jointly))
        left = max(0, left - 1)
    links = (*_links(draw, tops), *_hand_overs(draw))
    return GroundedTree(objective="test", nodes=tuple(draw.nodes), roles=tuple(draw.roles), links=links)


def _inner(draw: _Draw, parent: int) -> int:
    release_s, deadline_s = _window(draw)
    draw.nodes.append(
        GroundedNode(parent=parent, kind="and", label=f"n{len(draw.nodes)}", release_s=release_s, deadline_s=deadline_s)
    )
    return len(draw.nodes) - 1


def _window(draw: _Draw) -> tuple[float, float | None]:
    """When a node may begin, and when it must have ended."""
    release_s = float(draw.rng.randint(1, 8)) if draw.maybe("times", 0.25) else 0.0
    return release_s, float(draw.rng.randint(9, 30)) if draw.maybe("times", 0.25) else None


def _role(draw: _Draw, parent: int, type_id: str, joint: bool) -> int:
    rng, role = draw.rng, len(draw.roles)
    draw.roles.append(Role(label=f"R{role}", team=0 if joint and rng.random() < 0.6 else None))
    top = _inner(draw, parent)
    length = rng.choice((1, 1, 2, 3))
    together = rng.randrange(length) if joint else -1
    for step in range(length):
        last = step == length - 1
        _action(draw, top, role, type_id, 0 if step == together else None, last)
    return top


def _action(draw: _Draw, parent: int, role: int, type_id: str, sync: int | None, last: bool) -> None:
    rng = draw.rng
    places = PLACES + (THINGS if "things" in draw.features else ())
    at = rng.choice(places) if draw.maybe("travel", 0.7) else None
    moves = at in PLACES and rng.random() < 0.4
    brings = (rng.choice(THINGS),) if moves and draw.maybe("things", 0.6) else ()
    uses: dict[str, float] = {}
    if draw.maybe("budgets", 0.5):
        uses = {"energy_j": rng.choice((1.0, 2.5)), "coins": 1.0}
    duration = 0.0 if draw.maybe("idle", 0.15) else rng.choice((1.0, 2.0, 3.0, 5.0))
    holds = tuple(name for name in SHARED if draw.maybe("shared", 0.45) and draw.holders.get(name, 0) < MOST_HOLDERS)
    for name in holds:
        draw.holders[name] = draw.holders.get(name, 0) + 1
    index = len(draw.nodes)
    action = Action(
        name=f"a{index}",
        text=f"a{index}",
        role=role,
        robot_type=type_id,
        capability="work",
        estimate=Estimate(1.0),
        duration_s=duration,
        uses=uses,
        uses_at_least=uses,
        at=at,
        moves=moves,
        brings=brings,
        sync=sync,
        holds=holds,
        open_ended=last and not moves and sync is None and draw.maybe("until", 0.5),
    )
    draw.nodes.append(GroundedNode(parent=parent, kind="action", label=f"a{index}", action=action))


def _links(draw: _Draw, tops: list[int]) -> tuple[GroundedLink, ...]:
    rng, nodes = draw.rng, draw.nodes
    ends = [*tops, *(index for index, node in enumerate(nodes) if node.action is not None)]
    found: list[GroundedLink] = []
    for _ in range(rng.randint(0, 3) + ("until" in draw.features)):
        first, second = rng.choice(ends), rng.choice(ends)
        kind = rng.choice(KINDS if "links" in draw.features else ("precedence",))
        if "until" in draw.features and rng.random() < 0.4:
            kind = "until"
            opened = [i for i in ends if (a := nodes[i].action) is not None and a.open_ended]
            first = rng.choice(opened) if opened else first
        if not _related(nodes, first, second) and (kind != "precedence" or first < second or rng.random() < 0.2):
            found.append(GroundedLink(first, second, kind))
    return tuple(dict.fromkeys(found))


def _hand_overs(draw: _Draw) -> Iterator[GroundedLink]:
    """One role hands over to another, mostly so that they can meet: what the last and the first action are is drawn anew."""
    if "handing" not in draw.features:
        return
    leaves = [index for index, node in enumerate(draw.nodes) if node.action is not None]
    kinds = {_action_of(draw, leaf).role: _action_of(draw, leaf).robot_type for leaf in leaves}
    pairs = [sorted(draw.rng.sample(range(len(draw.roles)), 2)) for _ in range(4)]
    giver, taker = next((pair for pair in pairs if kinds[pair[0]] != kinds[pair[1]]), pairs[0])
    last = max(leaf for leaf in leaves if _action_of(draw, leaf).role == giver)
    first = min(leaf for leaf in leaves if _action_of(draw, leaf).role == taker)
    if draw.rng.random() < 0.9:
        at = _action_of(draw, last).at or draw.rng.choice(PLACES)
        _redo(draw, last, at=at, open_ended=False)
        brought = _action_of(draw, last).brings
        _redo(draw, first, at=draw.rng.choice((at, *brought)), moves=False, brings=())
    yield GroundedLink(draw.nodes[last].parent, draw.nodes[first].parent, "hand_over")


def _action_of(draw: _Draw, leaf: int) -> Action:
    action = draw.nodes[leaf].action
    assert action is not None
    return action


def _redo(draw: _Draw, leaf: int, **changes: Any) -> None:
    node = draw.nodes[leaf]
    assert node.action is not None
    draw.nodes[leaf] = replace(node, action=replace(node.action, **changes))


def _related(nodes: list[GroundedNode], first: int, second: int) -> bool:
    for low, high in ((first, second), (second, first)):
        node = low
        while node != -1:
            if node == high:
                return True
            node = nodes[node].parent
    return False


def _scene(draw: _Draw) -> Scene:
    where: dict[str, float | None] = {"p": 0.0, "q": 3.0, "r": 7.0, "lost": None, "box": 2.0, "cat": 5.0}
    return Scene(
        entities=tuple(
            Entity(
                id=name,
                position=None if x is None else Position(x, 0.0),
                max_speed_mps=0.5 if name == "cat" else None,
            )
            for name, x in where.items()
        ),
        resources=tuple(
            SharedResource(id=name, capacity=draw.rng.choice((1, 1, 2))) for name in SHARED if draw.holders
        ),
    )


def _alternative(tree: GroundedTree) -> Alternative:
    types = {node.action.role: node.action.robot_type for node in tree.nodes if node.action is not None}
    choices: tuple[Choice, ...] = ()
    return Alternative(
        rank=1,
        utility=float(sum(node.action is not None for node in tree.nodes)),
        choices=choices,
        roles=tuple(RoleType(role, kind) for role, kind in sorted(types.items())),
        certificate=Certificate(claim="unproven", method="enumeration"),
    )


def _terms(draw: _Draw, tree: GroundedTree, alternative: Alternative, fleet: Fleet) -> tuple[Fleet, Terms]:
    """Who must take part, how many may, and what all share."""
    rng = draw.rng
    if "terms" not in draw.features:
        return fleet, NO_TERMS
    used = {one.robot_type for one in alternative.roles}
    require: tuple[str, ...] = ()
    if rng.random() < 0.4:
        named = [robot.id for kind in fleet.types if kind.id in used for robot in kind.members]
        require = (rng.choice(named),)
    types = []
    for kind in fleet.types:
        most = rng.randint(1, len(kind.members)) if rng.random() < 0.4 else None
        types.append(_limited(kind, most))
    totals = {"energy_j": float(rng.randint(10, 60))} if rng.random() < 0.3 else {}
    stock = {"coins": float(rng.randint(3, 8))} if rng.random() < 0.3 else {}
    return Fleet(tuple(types), total_limits=totals), Terms(require=require, stock=stock)


def _chargers(rng: Random, fleet: Fleet) -> tuple[Charger, ...]:
    """One or two, for all types or for one."""
    return tuple(
        Charger(
            id=f"plug{number}",
            position=Position(float(rng.randint(-2, 8)), 0.0),
            rate_per_s=rng.choice((0.7, 3.0, 10.0)),
            types=rng.choice((None, None, (fleet.types[0].id,))),
            capacity=rng.choice((1, 1, 2)),
        )
        for number in range(rng.randint(1, 2))
    )


def _within_full(rng: Random, fleet: Fleet) -> Fleet:
    """The fleet with robots that have little left at the start, and never more than their type holds."""
    types = []
    for kind in fleet.types:
        if "energy_j" not in kind.limits:
            types.append(replace(kind, robots=tuple(replace(robot, remaining={}) for robot in kind.robots)))
            continue
        full = rng.randint(10, 30)
        robots = tuple(
            replace(
                robot,
                position=robot.position or kind.position,
                remaining={"energy_j": float(rng.randint(1, full // 2))} if rng.random() < 0.8 else {},
            )
            for robot in kind.members
        )
        limits = {**kind.limits, "energy_j": float(full)}
        types.append(replace(kind, limits=limits, robots=robots, count=None, position=None))
    return replace(fleet, types=tuple(types))


def _limited(kind: RobotType, most: int | None) -> RobotType:
    return RobotType(
        id=kind.id,
        capabilities=kind.capabilities,
        limits=kind.limits,
        uses_per_m=kind.uses_per_m,
        total_limits=kind.total_limits,
        max_in_use=most,
        robots=kind.robots,
        count=None if kind.robots else len(kind.members),
        position=kind.position,
        available_from_s=kind.available_from_s,
        available_until_s=kind.available_until_s,
    )
