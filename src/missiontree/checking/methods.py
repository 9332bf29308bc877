"""The methods of proof that missiontree documents. A claim by any other is no claim that anybody can judge."""

BY_AIM = frozenset({"dinkelbach", "bottleneck", "team_partition"})
"""How alternatives are ranked by mean, by least utility, and by different teams."""

RANKING_PROOFS = BY_AIM | {"lazy_k_best", "branch_and_bound", "pool", "enumeration", "algorithm_1", "least_use"}
"""How alternatives are ranked, and shown to be none."""

CHOICE_PROOFS = frozenset({"epsilon_constraint", "best_first"})
"""How fronts and choices by an objective are made."""

BOUND_PROOFS = frozenset(
    {"critical_path", "load", "resource_load", "refill_load", "spanning_tree", "second_formulation", "enumeration"}
)
"""Why no schedule is shorter."""

COMPLETE_SEARCHES = frozenset({"labels"})
"""Why no schedule of an instance is shorter, beside the bounds."""

IMPOSSIBILITY_PROOFS = frozenset(
    {
        "precedence",
        "staffing",
        "overlap",
        "holding",
        "sharing",
        "hand_over",
        "reachability",
        "budget_bound",
        "deadline_bound",
        "second_formulation",
        "enumeration",
    }
)
"""Why there is no schedule."""

SEARCHES = frozenset({"serial_generation", "cp_sat"})
"""How schedules are looked for; such a method proves nothing."""

SOLVERS = frozenset({"cp_sat"})
"""Whose word may stand behind a bound that is claimed as a solver's word, and behind no other claim."""
