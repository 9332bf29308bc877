"""
The problem as a CP-SAT model.

Two forms, both safe: actions that may take each other's place share one start and never one end (intervals of several robots that
share both can give a wrong answer called optimal). *shared*: the leaves of an XOR share a start, each is an optional interval of
fixed size on it, and ``end == start + d`` holds where the leaf is taken. *own*: every leaf has a start of its own, and what is not
taken has none.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Literal

from missiontree.mission.columns import AND, LEAF, XOR
from missiontree.scheduling.joint.listing import Listed
from missiontree.scheduling.joint.paths import Paths
from missiontree.scheduling.joint.problem import JointProblem

Form = Literal["shared", "own"]


class JointModel:
    """
    Variables and constraints. Durations are whole numbers, and so are all times.

    Parameters
    ----------
    problem, paths
        The tree and its least times.
    lower, upper
        Between which the makespan lies.
    form
        Which variables there are.
    """

    def __init__(self, problem: JointProblem, paths: Paths, lower: int, upper: int, form: Form = "shared") -> None:
        from ortools.sat.python import cp_model  # noqa: PLC0415 - heavy, and needed only when something is solved

        self.problem, self.paths, self.lower, self.upper, self.form = problem, paths, lower, upper, form
        self.model: Any = cp_model.CpModel()
        self.makespan = self.model.new_int_var(lower, upper, "makespan")
        self.taken: list[Any] = [None] * len(
            problem.kind
        )  # a literal; True where a node is always selected; False where never
        self.start: list[Any] = [None] * len(problem.kind)
        self.end: list[Any] = [None] * len(problem.kind)
        self._needs_span = self._named()
        for add in (
            self.add_selection,
            self.add_times,
            self.add_spans,
            self.add_precedence,
            self.add_robots,
            self.add_loads,
        ):
            add()
        self.model.minimize(self.makespan)

    def _named(self) -> list[bool]:
        """Inner nodes that a precedence names; leaves, and XORs over leaves, have a start and an end in any case."""
        problem = self.problem
        return [
            bool(problem.before[node] or problem.after[node]) and not self._is_unit(node)
            for node in range(len(problem.kind))
        ]

    def _is_unit(self, node: int) -> bool:
        problem = self.problem
        if problem.kind[node] == LEAF:
            return True
        return (
            self.form == "shared"
            and problem.kind[node] == XOR
            and bool(problem.children[node])
            and all(problem.kind[child] == LEAF for child in problem.children[node])
        )

    def add_selection(self) -> None:
        """The root is selected; an AND selects all children, an XOR exactly one. What would end too late is not taken."""
        problem, paths = self.problem, self.paths
        self.taken[0] = True
        for node in range(len(problem.kind)):
            mine, children = self.taken[node], problem.children[node]
            if problem.kind[node] == AND:
                for child in children:
                    self.taken[child] = mine
            elif problem.kind[node] == XOR:
                open_ = [child for child in children if paths.head[child] + paths.rest[child] <= self.upper]
                for child in children:
                    self.taken[child] = False
                if mine is False:
                    continue
                if len(open_) == 1:
                    self.taken[open_[0]] = mine
                    continue
                for child in open_:
                    self.taken[child] = self.model.new_bool_var(f"t{child}")
                literals = [self.taken[child] for child in open_]
                if mine is True:
                    self.model.add_exactly_one(literals)
                else:
                    self.model.add(sum(literals) == mine)

    def _span_of_start(self, node: int) -> tuple[int, int]:
        """From when to when a node can start if the makespan is at most the upper bound."""
        return self.paths.head[node], max(self.paths.head[node], self.upper - self.paths.rest[node])

    def add_times(self) -> None:
        """Start and end of every leaf, and of every XOR over leaves in the shared form."""
        problem = self.problem
        for node, kind in enumerate(problem.kind):
            if self.taken[node] is False or self.start[node] is not None:
                continue
            if kind == LEAF:
                self.start[node] = self.model.new_int_var(*self._span_of_start(node), f"s{node}")
                self.end[node] = self.start[node] + problem.duration[node]
            elif self._is_unit(node):
                self._add_unit(node)

    def _add_unit(self, xor: int) -> None:
        problem, paths = self.problem, self.paths
        children = [child for child in problem.children[xor] if self.taken[child] is not False]
        low = min([paths.head[child] for child in children], default=0)
        high = max([self._span_of_start(child)[1] for child in children], default=low)
        start = self.model.new_int_var(low, high, f"s{xor}")
        lengths = {problem.duration[child] for child in children}
        self.start[xor] = start
        if len(lengths) == 1:
            self.end[xor] = start + lengths.pop()
        else:
            self.end[xor] = self.model.new_int_var(low, self.upper, f"e{xor}")
        for child in children:
            self.start[child] = start
            self.end[child] = start + problem.duration[child]
            if lengths:
                self._when(self.end[xor] == self.end[child], child)

    def _when(self, constraint: Any, *nodes: int) -> None:
        """The constraint holds where all these nodes are selected."""
        added = self.model.add(constraint)
        literals = {id(self.taken[node]): self.taken[node] for node in nodes if self.taken[node] is not True}
        if literals:
            added.only_enforce_if(list(literals.values()))

    def add_spans(self) -> None:
        """A node starts no later than any selected leaf below it, and ends no earlier; the makespan is the root's end."""
        problem, paths = self.problem, self.paths
        for node, named in enumerate(self._needs_span):
            if named and self.taken[node] is not False:
                self.start[node] = self.model.new_int_var(*self._span_of_start(node), f"S{node}")
                self.end[node] = self.model.new_int_var(paths.head[node], self.upper, f"E{node}")
        for node in range(1, len(problem.kind)):
            if self.start[node] is None or self._inside_unit(node):
                continue
            above = problem.parent[node]
            while above >= 0 and not self._needs_span[above]:
                above = problem.parent[above]
            if above >= 0:
                self._when(self.start[node] >= self.start[above], node)
                self._when(self.end[node] <= self.end[above], node)
            else:
                self._when(self.end[node] <= self.makespan, node)
        if self.start[0] is not None:
            self.model.add(self.end[0] <= self.makespan)

    def _inside_unit(self, node: int) -> bool:
        return node > 0 and self._is_unit(self.problem.parent[node])

    def add_precedence(self) -> None:
        """The first node ends before the second starts, where both are selected."""
        for node, others in enumerate(self.problem.after):
            for other in others:
                if self.taken[node] is not False and self.taken[other] is not False:
                    self._when(self.start[other] >= self.end[node], node, other)

    def add_robots(self) -> None:
        """A robot does one thing at a time; equal robots do as many as there are."""
        for kind, leaves in self._work().items():
            intervals = [self._interval(leaf) for leaf in leaves if self.problem.duration[leaf]]
            if self.problem.count[kind] == 1:
                self.model.add_no_overlap(intervals)
            else:
                self.model.add_cumulative(intervals, [1] * len(intervals), self.problem.count[kind])

    def _work(self) -> dict[int, list[int]]:
        work: dict[int, list[int]] = {}
        for leaf in self.problem.leaves:
            if self.taken[leaf] is not False:
                work.setdefault(self.problem.robot[leaf], []).append(leaf)
        return work

    def _interval(self, leaf: int) -> Any:
        start, duration, taken = self.start[leaf], self.problem.duration[leaf], self.taken[leaf]
        if taken is True:
            return self.model.new_fixed_size_interval_var(start, duration, f"i{leaf}")
        return self.model.new_optional_fixed_size_interval_var(start, duration, taken, f"i{leaf}")

    def add_loads(self) -> None:
        """What the robots of a type do lies between the earliest head and the least tail of it (implied; it helps the bound)."""
        problem, paths = self.problem, self.paths
        for kind, leaves in self._work().items():
            count = problem.count[kind]
            work = sum(problem.duration[leaf] * self.taken[leaf] for leaf in leaves)
            head, tail = min(paths.head[leaf] for leaf in leaves), min(paths.tail[leaf] for leaf in leaves)
            self.model.add(work + count * (head + tail) <= count * self.makespan)

    def hint(self, listed: Listed) -> None:
        """Begin the search at a schedule."""
        problem = self.problem
        hinted: set[int] = set()  # a variable may be hinted once; several nodes may share a literal

        def add(variable: Any, value: int) -> None:
            if hasattr(variable, "index") and variable.index not in hinted:
                hinted.add(variable.index)
                self.model.add_hint(variable, value)

        add(self.makespan, listed.makespan)
        for xor, child in listed.chosen.items():
            for other in problem.children[xor]:
                add(self.taken[other], int(other == child))
        for leaf, start in listed.start.items():
            unit = problem.parent[leaf] if self._inside_unit(leaf) else leaf
            add(self.start[unit], start)
            add(self.end[unit], start + problem.duration[leaf])

    def read(self, value: Callable[[Any], int]) -> tuple[dict[int, int], dict[int, int]]:
        """Child of each reached XOR, and start of each selected leaf, of a solution."""
        problem = self.problem
        chosen: dict[int, int] = {}
        starts: dict[int, int] = {}
        stack: list[int] = [0]
        while stack:
            node = stack.pop()
            children: Sequence[int] = problem.children[node]
            if problem.kind[node] == LEAF:
                starts[node] = value(self.start[node])
            elif problem.kind[node] == XOR:
                chosen[node] = next(child for child in children if self._is_taken(child, value))
                stack.append(chosen[node])
            else:
                stack.extend(children)
        return chosen, starts

    def _is_taken(self, node: int, value: Callable[[Any], int]) -> bool:
        literal = self.taken[node]
        return literal if isinstance(literal, bool) else bool(value(literal))
