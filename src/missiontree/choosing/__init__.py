"""
Alternatives and schedules weighed against each other: the utility-makespan front, and what an objective chooses.

Allocation ranks without schedules, and a ranking never hangs on them. Here both are asked in turn: the best alternatives that could end
by some time, then their schedules, until a proof that nothing better is left or a limit.
"""
