"""
Which way and when, decided together: of all selections of a tree over single actions, one whose makespan is least.

Scheduling elsewhere is given an alternative. Here the choice at every XOR is part of the problem, as in the flexible job shop, and the
makespan is all that counts: no utility, no budget, no travel. An action is a role of its own, so that a robot is held for it alone.
"""
