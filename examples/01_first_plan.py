"""A sentence becomes a plan: offline, with the paper's team."""

from missiontree import plan, plan_text

mission = plan("Reunite mom with her lost child")
print(mission.outcome)
print(plan_text(mission))
