"""Grounding loses nothing silently: every way and type is in the tree, or there is a Reason why not."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from missiontree.mission.area import Area, Zone
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.tree import MissionTree
from missiontree.routines.compose import flatten
from missiontree.routines.ground import ground
from missiontree.routines.library import built_in
from tests.builders import brief_of, flat_tree, routine_node

CAPABILITIES = ("search", "follow", "reach", "carry", "message_display")
HALF = Area(corners=((0, -50), (50, -50), (50, 50), (0, 50)))
coordinates = st.integers(-40, 40)
maybe_position = st.none() | st.builds(Position, coordinates, coordinates)


@st.composite
def fleets(draw: st.DrawFn) -> Fleet:
    return Fleet(
        tuple(
            RobotType(
                id=f"t{number}",
                count=draw(st.integers(1, 3)),
                capabilities=dict.fromkeys(draw(st.sets(st.sampled_from(CAPABILITIES))), 0.5),
                limits=draw(st.sampled_from([{}, {"payload_kg": 5}, {"payload_kg": 50, "max_speed_mps": 1}])),
                zones=draw(st.sampled_from([None, (), ("east",)])),
                position=draw(maybe_position),
            )
            for number in range(draw(st.integers(1, 4)))
        )
    )


@st.composite
def worlds(draw: st.DrawFn) -> Scene:
    entities = tuple(
        Entity(id=f"e{i}", kind=kind, position=draw(maybe_position), mass_kg=draw(st.sampled_from([None, 3, 20])))
        for i, kind in enumerate(("person", "animal", "object", "place"))
    )
    return Scene(entities=entities, zones=(Zone(id="east", area=HALF),))


@st.composite
def trees(draw: st.DrawFn, fleet: Fleet) -> MissionTree:
    leaves = []
    for number in range(draw(st.integers(1, 3))):
        routine = draw(st.sampled_from(built_in().routines))
        arguments = {name: draw(st.sampled_from(["e0", "e1", "e2", "e3"])) for name in routine.argument_kinds}
        resources = draw(st.none() | st.sets(st.sampled_from([kind.id for kind in fleet.types])).map(sorted))
        leaves.append(routine_node(f"n{number}", routine.id, resources, **arguments))  # type: ignore[arg-type]
    return flat_tree(*leaves)


def offered(tree: GroundedTree, node_id: str) -> set[tuple[str, str]]:
    """Branch and type of each way below a routine's XOR, told by its capability in the last action."""
    return {
        (action.capability, action.robot_type)
        for node in tree.nodes
        if node.source == node_id and (action := node.action) is not None
    }


@given(st.data(), fleets(), worlds())
def test_every_branch_and_type_is_offered_or_has_its_reason(data: st.DataObject, fleet: Fleet, scene: Scene) -> None:
    tree = data.draw(trees(fleet))
    brief = brief_of(tree, fleet=fleet, scene=scene, check_kinds=data.draw(st.booleans()))
    grounding = ground(tree, brief)
    for node in tree.nodes[1:]:
        assert node.routine is not None
        routine = built_in().by_id[node.routine]
        reasons = [reason for reason in grounding.not_offered if reason.node == node.id]
        branches = flatten(routine, built_in())
        for branch in branches:
            # With several branches a Reason says of which it speaks.
            own = [each for each in reasons if len(branches) == 1 or f"by {branch.name}" in each.message]
            whole = any(reason.rule == "kind_refused" and not reason.robot for reason in own)
            excluded = {each.robot for each in reasons if each.rule == "resource_excluded"}
            refused = {kind.id for kind in fleet.types if whole} | excluded | {each.robot for each in own if each.robot}
            rating = branch.roles[0].actions[-1].rating
            able = {type_id for capability, type_id in offered(grounding.tree, node.id) if capability == rating}
            # In the tree or refused, and never both.
            assert able == {kind.id for kind in fleet.types} - refused
    assert ground(tree, brief) == grounding


@given(st.data(), fleets(), worlds())
def test_what_is_offered_can_do_it(data: st.DataObject, fleet: Fleet, scene: Scene) -> None:
    """A second reading of the conditions, straight from the values: capability, payload, zone, kind, resources."""
    tree = data.draw(trees(fleet))
    for node in ground(tree, brief_of(tree, fleet=fleet, scene=scene)).tree.nodes:
        if node.action is None:
            continue
        kind, call = fleet.by_id[node.action.robot_type], tree.by_id[node.source or ""]
        agent = scene.by_id[call.arguments["agent"]]
        assert node.action.capability in kind.capabilities
        assert call.resources is None or kind.id in call.resources
        if node.action.name == "carry" and agent.mass_kg is not None:
            assert kind.limits.get("payload_kg", agent.mass_kg) >= agent.mass_kg
        if node.action.name == "display_message":
            assert agent.kind == "person"
        if node.action.at is not None and kind.zones == ():
            position = scene.by_id[node.action.at].position
            assert position is None or position.x_m < 0
