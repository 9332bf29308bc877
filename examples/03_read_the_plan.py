"""Everything that is shown can be read as values: who, what, when, and what is proven of it."""

from missiontree import check, plan

mission = plan("Rescue cat trapped in a building on fire", k=2)
assert mission.ranking is not None
assert mission.grounding is not None
tree = mission.grounding.tree

for alternative, schedule in zip(mission.ranking.alternatives, mission.schedules, strict=True):
    print(f"{alternative.rank}. utility {alternative.utility:g}, {alternative.certificate.claim}")
    for action in schedule.actions:
        print(f"   {action.start_s:6.1f}-{action.end_s:6.1f} s  {action.robot:22} {tree.action(action.leaf).text}")

print("not offered because of kinds:")
for reason in mission.grounding.not_offered:
    if reason.rule == "kind_refused":
        print(f"   {reason.message}")
print("faults found by the checker:", len(check(mission)))
