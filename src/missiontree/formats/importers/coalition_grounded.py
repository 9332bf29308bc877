"""
A mission of coalitions as the values that every stage takes: a grounded tree, a fleet and a scene.

A task is an XOR over its coalitions, a coalition an AND over one joint action per robot: they share a label, hence start and end, and the
robots differ. That every robot gets to the end is an action of its own at the end of the tree, a move, which waits for all else that the
same robot does: a precedence from each of its joint actions, binding where that action is selected. So the way home counts in the
makespan, and nobody waits for others before going.
"""

from __future__ import annotations

from missiontree.mission.coalitions import CoalitionMission
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, GroundedTree, Role
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene

START, END = "start", "end"


def coalition_fleet(mission: CoalitionMission) -> Fleet:
    """A type of one robot for every robot, with its skills as capabilities and a speed of one metre a second."""
    return Fleet(
        tuple(
            RobotType(
                id=f"robot-{robot}",
                capabilities={"get": 1.0, **{f"skill-{skill}": 1.0 for skill in skills}},
                limits={"max_speed_mps": 1.0},
                count=1,
                place=START,
            )
            for robot, skills in enumerate(mission.skills)
        )
    )


def coalition_scene(mission: CoalitionMission) -> Scene:
    """A place per task, and start and end."""
    spots = {START: mission.start, END: mission.end}
    spots |= {f"task-{number}": (task.x_m, task.y_m) for number, task in enumerate(mission.tasks, start=1)}
    return Scene(places=tuple(Entity(id=name, kind="place", position=Position(*spot)) for name, spot in spots.items()))


def coalition_tree(mission: CoalitionMission) -> GroundedTree:
    """The tasks, then the ways to the end."""
    growing = _Growing()
    root = growing.gate(-1, "and", "All tasks, and everybody at the end")
    joint: list[list[int]] = [[] for _ in mission.skills]
    of_task: list[int] = []
    for number, task in enumerate(mission.tasks, start=1):
        xor = growing.gate(root, "xor", f"Task {number}")
        of_task.append(xor)
        for members in mission.coalitions[number - 1]:
            named = " and ".join(f"robot-{robot}" for robot in members)
            coalition = growing.gate(xor, "and", f"Task {number} by {named}")
            growing.sync += 1
            for robot in members:
                own = [skill for skill in mission.skills[robot] if skill in task.needs]
                capability = f"skill-{own[0]}" if own else "get"
                joint[robot].append(growing.work(coalition, number, robot, capability, task.duration_s, len(members)))
    links = [GroundedLink(of_task[before], of_task[after]) for before, after in mission.precedence]
    for robot, leaves in enumerate(joint):
        home = growing.home(root, robot)
        links += [GroundedLink(leaf, home) for leaf in leaves]
    return GroundedTree(
        objective="Tasks for coalitions", nodes=tuple(growing.nodes), roles=tuple(growing.roles), links=tuple(links)
    )


class _Growing:
    def __init__(self) -> None:
        self.nodes: list[GroundedNode] = []
        self.roles: list[Role] = []
        self.sync = -1

    def gate(self, parent: int, kind: str, label: str) -> int:
        assert kind in {"and", "xor"}
        self.nodes.append(GroundedNode(parent=parent, kind="and" if kind == "and" else "xor", label=label))
        return len(self.nodes) - 1

    def work(self, parent: int, task: int, robot: int, capability: str, duration_s: float, size: int) -> int:
        """A robot's part of a task."""
        text = f"Do task {task}"
        action = Action(
            name="do",
            text=text,
            role=len(self.roles),
            robot_type=f"robot-{robot}",
            capability=capability,
            estimate=Estimate(1.0, duration_s),
            duration_s=duration_s,
            at=f"task-{task}",
            sync=self.sync if size > 1 else None,
        )
        self.roles.append(Role(label=text, team=self.sync if size > 1 else None))
        return self._leaf(parent, text, action)

    def home(self, parent: int, robot: int) -> int:
        """A robot's way to the end."""
        text = "Get to the end"
        action = Action(
            name="get_to_end",
            text=text,
            role=len(self.roles),
            robot_type=f"robot-{robot}",
            capability="get",
            estimate=Estimate(1.0),
            at=END,
            moves=True,
        )
        self.roles.append(Role(label=text))
        return self._leaf(parent, text, action)

    def _leaf(self, parent: int, label: str, action: Action) -> int:
        self.nodes.append(GroundedNode(parent=parent, kind="action", label=label, action=action))
        return len(self.nodes) - 1
