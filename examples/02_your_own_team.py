"""A team and a world of your own, written in Python."""

from missiontree import Entity, Fleet, Position, RobotType, Scene, plan

fleet = Fleet(
    (
        RobotType(
            id="mule",
            count=2,
            position=Position(0, 0),
            capabilities={"reach": 1.0, "carry": 1.0},
            limits={"max_speed_mps": 1.5, "payload_kg": 30},
        ),
        RobotType(
            id="eye", count=1, position=Position(0, 0), capabilities={"search": 1.0}, limits={"max_speed_mps": 4}
        ),
    )
)
scene = Scene(
    places=(Entity(id="barn", position=Position(0, 30)),),
    entities=(
        Entity(id="hay_bale", label="hay bale", position=Position(40, 0), mass_kg=20),
        Entity(id="trough", label="feed trough", position=Position(40, 30), mass_kg=50),
    ),
)

for words in ("Bring the hay bale to the barn", "Bring the feed trough to the barn"):
    mission = plan(words, fleet=fleet, scene=scene)
    print(f"{words}: {mission.outcome}")
    for schedule in mission.schedules:
        print(f"  alternative {schedule.rank}: {schedule.makespan_s:.1f} s, {schedule.status}")
    for reason in mission.reasons:
        print(f"  {reason.message}")
