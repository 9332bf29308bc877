"""Sound plans that the checker's tests start from, made by the real road: ground, rank exactly, schedule greedily."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

from missiontree.allocation.aimed import allocator_for
from missiontree.allocation.flat import flatten
from missiontree.authoring.author import authored_from_tree
from missiontree.briefing import Request
from missiontree.choosing.choose import NOTHING as NO_CHOICE
from missiontree.choosing.choose import choose
from missiontree.estimation.estimator import Estimator
from missiontree.estimation.own import own_estimator
from missiontree.explaining.nearest import nearest_part
from missiontree.formats.inputs import input_digests
from missiontree.mission.area import Area, KeepOut, Zone
from missiontree.mission.brief import MissionBrief
from missiontree.mission.charger import Charger
from missiontree.mission.control import Control
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Capability, Fleet, Robot, RobotType
from missiontree.mission.plan import Outcome, Plan, Provenance
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.routine import ActionStep, Argument, Branch, Need, RoleSpec, Routine, RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph, RoadNode
from missiontree.planner import plan, plan_authored
from missiontree.routines.ground import ground
from missiontree.routines.library import built_in
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.scheduler import Scheduler
from tests.builders import brief_of, flat_tree, rescue_tree, reunite_tree, routine_node

NOTHING_FOUND = Reason(rule="nothing_found", message="Nothing was found in the time given.")
THINGS = ("object", "person", "animal")


def made(
    tree: MissionTree,
    brief: MissionBrief,
    k: int = 4,
    allocator: str = "exact",
    estimator: Estimator | None = None,
    scheduler: str | Scheduler = "greedy",
    front: bool = False,
) -> Plan:
    """The plan that missiontree makes of a tree."""
    schedule = SCHEDULERS[scheduler] if isinstance(scheduler, str) else scheduler
    grounding = ground(tree, brief, estimator)
    flat = flatten(grounding.tree, brief.fleet, brief.weights, brief.terms)
    ranking = allocator_for(allocator, brief.aim)(flat, brief.fleet, brief.weights, k, Control())
    scene = brief.world.extended(tree.entities)
    schedules = tuple(
        schedule(grounding.tree, alternative, brief.fleet, scene, Control(), brief.terms)
        for alternative in ranking.alternatives
    )
    works = any(schedule.status in {"optimal", "feasible"} for schedule in schedules)
    choice = NO_CHOICE
    if works and (front or brief.objective != "utility"):
        choice = choose(grounding.tree, brief, scene, schedule, Control(), ranking, schedules, front, most=8)
    complete = ranking.status == "exact" and ranking.certificate.bound is None and not brief.diverse
    impossible = complete and all(schedule.status == "infeasible" for schedule in schedules)
    undelivered: Outcome = "cannot_be_done" if impossible or ranking.status == "infeasible" else "exhausted"
    options = (*(choice.front.options if choice.front else ()), *([choice.chosen.option] if choice.chosen else ()))
    assumed = [
        one for schedule in (*schedules, *(option.schedule for option in options)) for one in schedule.assumptions
    ]
    reasons = tuple(reason for schedule in schedules for reason in schedule.reasons) + ranking.reasons
    return Plan(
        outcome="delivered" if works else undelivered,
        brief=brief,
        tree=tree,
        grounding=grounding,
        ranking=ranking,
        schedules=schedules,
        chosen=choice.chosen,
        front=choice.front,
        reasons=() if works else reasons + grounding.not_offered or (NOTHING_FOUND,),
        notices=grounding.notices,
        assumptions=tuple(dict.fromkeys([*grounding.assumptions, *assumed])),
        findings=grounding.findings,
        digests=input_digests(brief, tree),
        provenance=Provenance(author="given"),
    )


@cache
def reunite() -> Plan:
    """The paper's first mission: no scene, four alternatives."""
    tree = reunite_tree()
    return made(tree, brief_of(tree))


@cache
def rescue() -> Plan:
    """The paper's second mission: two searches in parallel by interchangeable robots."""
    tree = rescue_tree()
    return made(tree, brief_of(tree))


def yard_routines() -> RoutineLibrary:
    """The built-in routines, an inspection, and a load that two robots carry together."""
    inspect = Routine(
        id="Inspect",
        purpose="Inspect {agent}.",
        arguments=(Argument(name="agent", kinds=THINGS),),
        branches=(
            Branch(
                name="look",
                roles=(
                    RoleSpec(
                        name="inspector",
                        rating="reach",
                        actions=(
                            ActionStep(
                                name="inspect", text="Inspect {agent}", duration_s=30, at="agent", uses={"energy_j": 50}
                            ),
                        ),
                    ),
                ),
            ),
        ),
    )
    together = Routine(
        id="CarryTogether",
        purpose="Carry {agent} to {location} with two robots.",
        arguments=(Argument(name="agent", kinds=THINGS), Argument(name="location", kinds=("place",))),
        branches=(
            Branch(
                name="pair",
                roles=(
                    RoleSpec(
                        name="carrier",
                        rating="carry",
                        robots=2,
                        needs=(Need(limit="payload_kg", at_least="agent.mass_kg", share=0.5),),
                        actions=(
                            ActionStep(name="grip", text="Grip {agent}", duration_s=10, at="agent", sync="grip"),
                            ActionStep(
                                name="haul",
                                text="Haul {agent} to {location}",
                                duration_s=60,
                                goes_to="location",
                                brings=("agent",),
                                sync="haul",
                            ),
                            ActionStep(name="release", text="Release {agent}", duration_s=5.5, uses={"energy_j": 10}),
                        ),
                    ),
                ),
            ),
        ),
    )
    return RoutineLibrary(routines=(*built_in().routines, inspect, together))


def yard_scene() -> Scene:
    """Depot (0, 0), hall (100, 0), yard (100, 50) and dock (200, 0) on a cross of roads; the depot's floor has a way round."""
    places = tuple(
        Entity(id=name, kind="place", position=Position(x_m, y_m))
        for name, x_m, y_m in (("depot", 0, 0), ("hall", 100, 0), ("yard", 100, 50), ("dock", 200, 0))
    )
    return Scene(
        zones=(Zone(id="inside"), Zone(id="pier")),
        places=places,
        entities=(
            Entity(id="crate", place="yard", mass_kg=40),
            Entity(id="beam", position=Position(100, 60), mass_kg=90, max_speed_mps=1.0),
            Entity(id="guest", kind="person", position=Position(95, 5), zone="inside"),
        ),
        roads=RoadGraph(
            nodes=(RoadNode(id="bend", position=Position(50, 80)),),
            roads=(
                Road(ends=("depot", "hall")),
                Road(ends=("hall", "yard")),
                Road(ends=("hall", "dock"), length_m=110),
                Road(ends=("depot", "bend"), length_m=300, one_way=True),
                Road(ends=("bend", "yard"), blocked=True),
            ),
        ),
    )


def yard_fleet() -> Fleet:
    """Two interchangeable carts, a mule of its own type, and a watcher off the road."""
    return Fleet(
        (
            RobotType(
                id="cart",
                capabilities={"carry": 0.9, "reach": 0.8},
                limits={"max_speed_mps": 2.0, "payload_kg": 50, "energy_j": 2000},
                total_limits={"energy_j": 3500},
                uses_per_m={"energy_j": 1.0},
                count=2,
                place="depot",
            ),
            RobotType(
                id="mule",
                capabilities={"carry": 0.5, "reach": 0.5},
                limits={"max_speed_mps": 1.5, "payload_kg": 60},
                uses_per_m={"energy_j": 2.0},
                robots=(Robot(id="molly", place="dock", remaining={"energy_j": 1800}),),
            ),
            RobotType(
                id="watcher",
                capabilities={"follow": 1.0, "search": 1.0},
                limits={"max_speed_mps": 1.0},
                zones=("inside",),
                count=1,
                position=Position(110, 5),
            ),
        )
    )


@cache
def yard() -> Plan:
    """Roads, a moved crate, interchangeable carts, joint work, budgets, an until link, a same-robot and a different-robot link."""
    tree = flat_tree(
        routine_node("bring", "ReachAndTransport", agent="crate", location="dock"),
        routine_node("inspect", "Inspect", agent="crate"),
        routine_node("haul", "CarryTogether", agent="beam", location="dock"),
        routine_node("watch", "Follow", agent="guest"),
        routine_node("look", "Inspect", agent="beam"),
        links=(
            Link("bring", "inspect"),
            Link("bring", "inspect", "same_robot"),
            Link("watch", "haul", "until"),
            Link("haul", "look"),
            Link("inspect", "look", "different_robot"),
        ),
    )
    return made(tree, brief_of(tree, yard_fleet(), yard_routines(), scene=yard_scene()))


@cache
def choices() -> Plan:
    """A task with a choice over open ground with a keep-out between: an XOR above routines, a person led at her own pace."""
    tree = MissionTree(
        objective="See to the visitor",
        nodes=(
            MissionNode(id="root", label="See to the visitor", gate="and", children=("either", "after")),
            MissionNode(id="either", label="Fetch or watch", gate="xor", children=("fetch", "watch")),
            routine_node("fetch", "Transport", agent="visitor", location="door"),
            routine_node("watch", "SearchAndFollow", agent="visitor"),
            routine_node("after", "Reach", agent="visitor"),
        ),
        links=(Link("either", "after"),),
    )
    scene = Scene(
        places=(Entity(id="door", kind="place", position=Position(30, 0)),),
        entities=(Entity(id="visitor", kind="person", position=Position(10, 0), max_speed_mps=0.5),),
        keep_outs=(KeepOut(id="pool", area=Area(corners=((15, -5), (25, -5), (25, 5), (15, 5)))),),
    )
    fleet = Fleet(
        (
            RobotType(
                id="host",
                capabilities={"message_display": 1.0, "reach": 0.5, "search": 0.4, "follow": 0.4},
                limits={"max_speed_mps": 1.0},
                count=1,
                position=Position(0, 0),
            ),
            RobotType(
                id="scout",
                capabilities={"search": 0.6, "follow": 0.6, "reach": 0.6},
                limits={"max_speed_mps": 2.0},
                count=1,
                position=Position(40, 0),
            ),
        )
    )
    return made(tree, brief_of(tree, fleet, scene=scene), k=6)


@cache
def floors() -> Plan:
    """A lift between two floors with room for one, and a slow way round by a ramp; upstairs one robot hands over to another."""
    tree = flat_tree(
        routine_node("bring", "Transport", agent="parcel", location="office"),
        routine_node("store", "Transport", agent="parcel", location="shelf"),
        routine_node("meet", "Reach", agent="parcel"),
        links=(Link("bring", "store", "hand_over"), Link("store", "meet")),
    )
    scene = Scene(
        places=(
            Entity(id="office", kind="place", position=Position(10, 3, "upper")),
            Entity(id="shelf", kind="place", position=Position(10, 7, "upper")),
        ),
        entities=(Entity(id="parcel", position=Position(4, 1), mass_kg=2),),
        roads=RoadGraph(
            nodes=(
                RoadNode(id="lobby", position=Position(0, 0)),
                RoadNode(id="shaft", position=Position(10, 0)),
                RoadNode(id="landing", position=Position(10, 0, "upper")),
                RoadNode(id="ramp_foot", position=Position(0, 10)),
                RoadNode(id="ramp_head", position=Position(0, 10, "upper")),
            ),
            roads=(
                Road(ends=("lobby", "shaft")),
                Road(ends=("lobby", "ramp_foot")),
                Road(ends=("ramp_foot", "ramp_head"), length_m=40),
                Road(ends=("ramp_head", "landing")),
            ),
            lifts=(Lift(id="lift", stops=("shaft", "landing"), ride_s=20, resource="cabin"),),
        ),
        resources=(SharedResource(id="cabin"),),
    )
    fleet = Fleet(
        (
            RobotType(
                id="porter",
                capabilities={"carry": 1.0, "reach": 1.0},
                limits={"max_speed_mps": 1.0},
                count=2,
                position=Position(0, 0),
            ),
        )
    )
    return made(tree, brief_of(tree, fleet, scene=scene), k=1)


@cache
def maze() -> Plan:
    """A grid with a wall to go round."""
    tree = flat_tree(routine_node("find", "Search", agent="cat"), routine_node("meet", "Reach", agent="door"))
    scene = Scene(
        places=(Entity(id="door", kind="place", position=Position(4.5, 0.5)),),
        entities=(Entity(id="cat", kind="animal", last_seen=Position(4.2, 2.5)),),
        grid=OccupancyGrid(rows=(".....", "..#..", "..#.."), cell_m=1.0),
    )
    fleet = Fleet(
        (
            RobotType(
                id="rover",
                capabilities={"search": 1.0, "reach": 1.0},
                limits={"max_speed_mps": 0.5},
                count=1,
                position=Position(0.5, 0.5),
            ),
        )
    )
    return made(tree, brief_of(tree, fleet, scene=scene))


@cache
def strays() -> Plan:
    """Robots that nobody knows the start or the speed of, in a hall where everything else is known but for a lost key."""
    tree = flat_tree(
        routine_node("meet", "Reach", agent="guest"),
        routine_node("bring", "Transport", agent="parcel", location="door"),
        routine_node("find", "Search", agent="key"),
        links=(Link("meet", "bring"),),
    )
    scene = Scene(
        places=(Entity(id="door", kind="place", position=Position(30, 0)),),
        entities=(
            Entity(id="guest", kind="person", position=Position(10, 0)),
            Entity(id="parcel", position=Position(20, 0)),
            Entity(id="key"),
        ),
    )
    fleet = Fleet(
        (
            RobotType(id="stray", capabilities={"reach": 1.0}, limits={"max_speed_mps": 1.0}, count=1),
            RobotType(id="slow", capabilities={"carry": 1.0, "search": 1.0}, count=1, position=Position(0, 0)),
        )
    )
    return made(tree, brief_of(tree, fleet, scene=scene), k=1)


@cache
def told() -> Plan:
    """A mission in words, understood by the offline author: the plan holds the dialogue."""
    return plan("Reunite mom with her lost child", k=2)


@cache
def bounded() -> Plan:
    """
    A mission under every rule for the whole of it.

    Four are treated, each with a kit from a stock of three, or comforted without one. Two of three medics at most are in use; the
    nurse must take part; the trainee stays out, and so does the porter, who would do it at a quality below what is asked.
    """
    treat = Routine(
        id="Treat",
        purpose="Treat {agent}",
        arguments=(Argument(name="agent", kinds=("person",)),),
        branches=(
            Branch(name="kit", roles=(_healer("treat", {"kits": 1.0, "energy_j": 10.0}),)),
            Branch(name="comfort", roles=(_healer("comfort", {"energy_j": 4.0}),)),
        ),
    )
    fleet = Fleet(
        (
            RobotType(id="medic", count=3, max_in_use=2, capabilities={"treat": 1.0, "comfort": 0.7}),
            RobotType(
                id="helper",
                robots=(Robot(id="nurse"), Robot(id="trainee")),
                capabilities={"treat": 0.8, "comfort": 0.9},
            ),
            RobotType(id="porter", count=1, capabilities={"treat": 0.2, "comfort": 0.6}),
            RobotType(id="clown", count=1, capabilities={"comfort": 2.0}),
        ),
        total_limits={"energy_j": 35.0},
    )
    names = ("Ann", "Bea", "Cem", "Dag")
    tree = flat_tree(*(routine_node(f"treat-{name}", "Treat", agent=name) for name in names))
    scene = Scene(stock={"kits": 3.0}, entities=tuple(Entity(id=name, kind="person") for name in names))
    brief = brief_of(
        tree,
        fleet=fleet,
        routines=RoutineLibrary(routines=(treat,)),
        scene=scene,
        without=("trainee", "clown"),
        require=("nurse",),
        min_quality={"Treat": 0.5, "comfort": 0.65},
    )
    return made(tree, brief)


@cache
def hurried() -> Plan:
    """The paper's first mission by the clock: found by 80 s, reunited from 90 s to 300 s, all over by 400 s."""
    tree = reunite_tree()
    found, united = (node.id for node in tree.nodes if node.routine)
    times = {found: (0.0, 80.0), united: (90.0, 300.0)}
    nodes = (
        replace(node, release_s=times[node.id][0], deadline_s=times[node.id][1]) if node.id in times else node
        for node in tree.nodes
    )
    tree = replace(tree, nodes=tuple(nodes))
    return made(tree, brief_of(tree, deadline_s=400.0))


def _healer(ability: str, uses: dict[str, float]) -> RoleSpec:
    step = ActionStep(name=ability, text="See to {agent}", duration_s=20.0, at="agent", uses=uses)
    return RoleSpec(name=ability, rating=ability, actions=(step,))


@cache
def learned() -> Plan:
    """
    The yard, by an estimator of one's own: actions take twice their nominal time, and mules do half as well as the fleet states.

    The mule reaches and carries at 0.5, so by that word at 0.25, and 0.3 is asked for: the carts are left. For the carts the
    estimator adds 0.125.
    """

    def estimate(
        capability: Capability, nominal_s: float | None, cost: float, metres: float, seconds: float, **about: str
    ) -> Estimate:
        quality = capability.quality / 2 if about["robot_type"] == "mule" else capability.quality + 0.125
        return Estimate(quality, 2 * (nominal_s or 0.0) + 1.5 * seconds, cost + 1 + metres / 8)

    own = own_estimator(estimate)
    assert own is not None
    tree = flat_tree(
        routine_node("bring", "ReachAndTransport", agent="crate", location="dock"),
        routine_node("inspect", "Inspect", agent="crate"),
        routine_node("watch", "Follow", agent="guest"),
        links=(Link("bring", "inspect"),),
    )
    brief = brief_of(
        tree,
        yard_fleet(),
        yard_routines(),
        scene=yard_scene(),
        weights=Weights(1.0, 0.001, 0.001),
        min_quality=0.3,
        estimator=own.source,
    )
    return made(tree, brief, estimator=own)


@cache
def measured() -> Plan:
    """
    Two doors, each opened by radio in one action of quality 1.0, or by hand in two of 0.6 or 0.9: by mean, different teams, with one key.

    By radio twice 1.0; by radio and by the better hand (1.0 + 0.9 + 0.9) / 3; by that hand twice 0.9, which has the best sum, 3.6.
    """
    steps = tuple(
        ActionStep(name=name, text=f"{name} {{agent}}", duration_s=5.0, at="agent", holds=("key",))
        for name in ("unlock", "pull")
    )
    open_ = Routine(
        id="Open",
        purpose="Open {agent}",
        arguments=(Argument(name="agent", kinds=THINGS),),
        branches=(
            Branch(name="hand", roles=(RoleSpec(name="opener", rating="hands", actions=steps),)),
            Branch(name="remote", roles=(RoleSpec(name="opener", rating="radio", actions=steps[:1]),)),
        ),
    )
    fleet = Fleet(
        (
            RobotType(id="arm", count=2, capabilities={"hands": 0.6, "radio": 1.0}),
            RobotType(id="claw", count=1, capabilities={"hands": 0.9}),
        )
    )
    tree = flat_tree(*(routine_node(f"open-{name}", "Open", agent=name) for name in ("door", "gate")))
    scene = Scene(
        entities=tuple(Entity(id=name) for name in ("door", "gate")), resources=(SharedResource(id="key", capacity=1),)
    )
    return made(
        tree,
        brief_of(
            tree,
            fleet=fleet,
            routines=RoutineLibrary(routines=(open_,)),
            scene=scene,
            accumulate="mean",
            diverse=True,
        ),
    )


def part_made(tree: MissionTree, brief: MissionBrief) -> Plan | None:
    """The plan for the largest part of a mission, the whole of which cannot be done."""
    authored = authored_from_tree(tree, brief)
    request = Request(brief=brief)
    return nearest_part(plan_authored(request, authored, Control()), request, authored, Control())


@cache
def partial() -> Plan:
    """The largest part of the rescue without the robot that carries: both searches, one of them for more than the rest."""
    tree = rescue_tree()
    brief = brief_of(tree, without=("transportation_robot",), parts={"firefighter": 2.5})
    found = part_made(tree, brief)
    assert found is not None
    return found


@cache
def homeward() -> Plan:
    """
    Two carts and the mule see to the yard and go home, by 1,000 s.

    From the depot to the crate it is 150 m, to the dock 160 m more; home from there 210 m.
    """
    tree = flat_tree(
        routine_node("bring", "ReachAndTransport", agent="crate", location="dock"),
        routine_node("inspect", "Inspect", agent="guest"),
    )
    brief = brief_of(tree, yard_fleet(), yard_routines(), scene=yard_scene(), return_home=True, deadline_s=1000.0)
    return made(tree, brief)


def supplies() -> tuple[MissionTree, Fleet, Scene]:
    """Medicine and blankets for a clinic, a mule that does it well, and a runner that does it fast."""
    fleet = Fleet(
        types=tuple(
            RobotType(
                id=name,
                capabilities={"reach": Capability(quality), "carry": Capability(quality)},
                limits={"max_speed_mps": speed, "payload_kg": 50.0},
                count=1,
                place="depot",
            )
            for name, quality, speed in (("mule", 1.0, 1.0), ("runner", 0.8, 4.0))
        )
    )
    where = {"depot": (0.0, 0.0), "clinic": (120.0, 0.0), "medicine": (20.0, 0.0), "blankets": (0.0, 10.0)}
    scene = Scene(
        entities=tuple(
            Entity(
                id=name, kind="place" if name in {"depot", "clinic"} else "object", mass_kg=2.0, position=Position(*at)
            )
            for name, at in where.items()
        )
    )
    tree = flat_tree(
        routine_node("first", "ReachAndTransport", agent="medicine", location="clinic"),
        routine_node("second", "ReachAndTransport", agent="blankets", location="clinic"),
    )
    return tree, fleet, scene


@cache
def trade() -> Plan:
    """A front of three plans, the fastest of which is chosen and not listed."""
    tree, fleet, scene = supplies()
    brief = brief_of(tree, fleet, scene=scene, objective="makespan")
    return made(tree, brief, k=2, scheduler="auto", front=True)


@cache
def weighed() -> Plan:
    """A choice by weighted worth, of which a bound is known."""
    tree, fleet, scene = supplies()
    brief = brief_of(tree, fleet, scene=scene, objective="weighted-sum", weights=Weights(1.0, 0.01))
    return made(tree, brief, scheduler="auto")


def looking(energy_j: float) -> RoutineLibrary:
    """A look that takes 20 s and so much energy."""
    look = ActionStep(name="look", text="Look at {agent}", duration_s=20.0, at="agent", uses={"energy_j": energy_j})
    inspect = Routine(
        id="Look",
        purpose="Look at {agent}",
        arguments=(Argument(name="agent", kinds=THINGS),),
        branches=(Branch(name="look", roles=(RoleSpec(name="looker", rating="look", actions=(look,)),)),),
    )
    return RoutineLibrary(routines=(inspect,))


@cache
def refilling() -> Plan:
    """
    Two rovers of 100 J see to a pump, a valve and a tank, 50 J each, and go home; there is one charger between them, with room for one.

    One rover does two of them. Both refill, and one of them waits for the other.
    """
    spots = {"pump": (20, 0), "valve": (20, 20), "tank": (0, 20)}
    scene = Scene(
        places=(Entity(id="dock", kind="place", position=Position(10, 10)),),
        entities=tuple(Entity(id=name, position=Position(*spot)) for name, spot in spots.items()),
        chargers=(Charger(id="plug", place="dock", rate_per_s=5.0),),
    )
    fleet = Fleet(
        (
            RobotType(
                id="rover",
                count=2,
                capabilities={"look": 1.0},
                limits={"max_speed_mps": 1.0, "energy_j": 100.0},
                uses_per_m={"energy_j": 1.0},
                position=Position(0, 0),
            ),
            RobotType(id="hauler", count=1, limits={"energy_j": 10.0}),
        )
    )
    tree = flat_tree(*(routine_node(f"see-{name}", "Look", agent=name) for name in spots))
    return made(
        tree,
        brief_of(tree, fleet, looking(50.0), scene=scene, return_home=True, deadline_s=300.0),
    )


@cache
def upstairs() -> Plan:
    """
    A rover with 40 J of 100 J, a scout with 200 J, and a lift that has room for one; a look upstairs takes 50 J, and then they go home.

    The charger for rovers is upstairs, so both go up by the lift at first, and down at last.
    """
    scene = Scene(
        places=(Entity(id="landing", kind="place", position=Position(10, 0, "upper")),),
        entities=tuple(
            Entity(id=name, position=Position(x_m, 0, "upper")) for name, x_m in (("pump", 20), ("valve", 25))
        ),
        roads=RoadGraph(
            nodes=(
                RoadNode(id="shaft", position=Position(5, 0)),
                RoadNode(id="top", position=Position(5, 0, "upper")),
                RoadNode(id="end", position=Position(20, 0, "upper")),
            ),
            roads=(Road(ends=("top", "end")),),
            lifts=(Lift(id="lift", stops=("shaft", "top"), ride_s=10, resource="cabin"),),
        ),
        resources=(SharedResource(id="cabin"),),
        chargers=(Charger(id="plug", place="landing", rate_per_s=5.0, types=("rover",)),),
    )
    common: dict[str, Any] = {"capabilities": {"look": 1.0}, "uses_per_m": {"energy_j": 0.5}}
    fleet = Fleet(
        (
            RobotType(
                id="rover",
                robots=(Robot(id="roy", position=Position(0, 0), remaining={"energy_j": 40.0}),),
                limits={"max_speed_mps": 1.0, "energy_j": 100.0},
                **common,
            ),
            RobotType(
                id="scout",
                count=1,
                position=Position(0, 0),
                limits={"max_speed_mps": 1.0, "energy_j": 200.0},
                **common,
            ),
        )
    )
    tree = flat_tree(
        routine_node("see-pump", "Look", ("rover",), agent="pump"),
        routine_node("see-valve", "Look", ("scout",), agent="valve"),
    )
    return made(tree, brief_of(tree, fleet, looking(50.0), scene=scene, return_home=True))


PLANS = {
    "upstairs": upstairs,
    "refilling": refilling,
    "partial": partial,
    "homeward": homeward,
    "measured": measured,
    "reunite": reunite,
    "rescue": rescue,
    "yard": yard,
    "choices": choices,
    "floors": floors,
    "maze": maze,
    "strays": strays,
    "told": told,
    "bounded": bounded,
    "learned": learned,
    "hurried": hurried,
    "trade": trade,
    "weighed": weighed,
}
