"""
Selections that give no robot too much to do: where all are busy to the end, who does what matters more than when.

From any selection, every XOR in turn is decided anew, all others as they are: whoever has much to do is dear, by a power of it, and the
cheapest way is taken. That goes on until nothing changes, so the sum of these powers only falls (best response in a potential game,
Rosenthal 1973).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random

from missiontree.mission.columns import AND, LEAF
from missiontree.scheduling.joint.problem import JointProblem

POWERS = ((4, 8, 16, 32, 64), (4, 8, 16), (4,))
"""Higher ones look more at those with most to do; each row is a way of getting there."""
SWEEPS = 6
"""At each power."""


def balanced(
    problem: JointProblem, price: Sequence[float], powers: Sequence[int], luck: Random, ended: Callable[[], bool]
) -> dict[int, int]:
    """
    Child of each reached XOR, so that the robots have about equally much to do.

    Parameters
    ----------
    problem
        The tree.
    price
        Of a unit of time by robot type, for the selection to begin with.
    powers
        One of :data:`POWERS`.
    luck
        Draws the order in which XORs are decided.
    ended
        Whether to stop.
    """
    work = _Balance(problem)
    work.decide([0], lambda kind, duration: price[kind] * duration)
    work.charge([0], 1)
    for power in powers:
        for _ in range(SWEEPS):
            if ended() or not work.sweep(power, luck, ended):
                break
    return work.chosen()


class _Balance:
    def __init__(self, problem: JointProblem) -> None:
        self.problem = problem
        self.taken: dict[int, int] = {}  # also at XORs that are no longer reached
        self.load = [0.0] * len(problem.count)

    def decide(self, tops: Sequence[int], price: Callable[[int, int], float]) -> None:
        """Take the cheapest way below these nodes."""
        problem = self.problem
        below = self._below(tops)
        cost: dict[int, float] = {}
        for node in reversed(below):
            children = problem.children[node]
            if problem.kind[node] == LEAF:
                cost[node] = price(problem.robot[node], problem.duration[node])
            elif problem.kind[node] == AND:
                cost[node] = sum([cost[child] for child in children])
            elif children:
                self.taken[node] = min(children, key=cost.__getitem__)
                cost[node] = cost[self.taken[node]]
            else:
                cost[node] = float("inf")

    def _below(self, tops: Sequence[int]) -> list[int]:
        found = list(tops)
        for node in found:  # grows as it is walked
            found.extend(self.problem.children[node])
        return found

    def charge(self, tops: Sequence[int], sign: int) -> None:
        problem, load = self.problem, self.load
        stack = list(tops)
        while stack:
            node = stack.pop()
            if problem.kind[node] == LEAF:
                kind = problem.robot[node]
                load[kind] += sign * problem.duration[node] / problem.count[kind]
            elif problem.kind[node] == AND:
                stack.extend(problem.children[node])
            else:
                stack.append(self.taken[node])

    def sweep(self, power: int, luck: Random, ended: Callable[[], bool]) -> bool:
        """Decide the XORs anew that no other one stands above; whether any changed."""
        changed, count = False, self.problem.count
        most = max(1.0, *self.load)

        def price(kind: int, duration: int) -> float:
            """How much the sum of powers rises."""
            load = self.load[kind] / most
            return float(((load + duration / most / count[kind]) ** power - load**power) * count[kind])

        tops = self._tops()
        luck.shuffle(tops)
        for number, top in enumerate(tops):
            if number % 256 == 0 and ended():
                return False
            before = self._signature(top)
            self.charge([top], -1)
            self.decide([top], price)
            self.charge([top], 1)
            changed = changed or self._signature(top) != before
        return changed

    def _tops(self) -> list[int]:
        """Reached XORs with only ANDs above them."""
        problem = self.problem
        stack, tops = [0], list[int]()
        while stack:
            node = stack.pop()
            if problem.kind[node] == AND:
                stack.extend(problem.children[node])
            elif problem.kind[node] != LEAF:
                tops.append(node)
        return tops

    def _signature(self, top: int) -> tuple[int, ...]:
        found, stack = list[int](), [top]
        while stack:
            node = stack.pop()
            if self.problem.kind[node] == LEAF:
                found.append(node)
            elif self.problem.kind[node] == AND:
                stack.extend(self.problem.children[node])
            else:
                stack.append(self.taken[node])
        return tuple(found)

    def chosen(self) -> dict[int, int]:
        """The choices that are reached."""
        problem, found, stack = self.problem, dict[int, int](), [0]
        while stack:
            node = stack.pop()
            if problem.kind[node] == AND:
                stack.extend(problem.children[node])
            elif problem.kind[node] != LEAF:
                found[node] = self.taken[node]
                stack.append(self.taken[node])
        return found
