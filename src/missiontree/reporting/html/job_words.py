"""What roles are called, what they are for, and what must be done before them."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

from missiontree.mission.plan import Plan
from missiontree.mission.tree import IN_ORDER

_FIELD = re.compile(r"\{([^{}]*)\}")
_ASIDE = re.compile(r", with one robot(?=[.,]|$)")  # true of whoever is listed under one robot


@dataclass(frozen=True, slots=True)
class Job:
    """
    A role that somebody fills.

    Parameters
    ----------
    text
        What it is for, in a sentence; what the tree calls it, if nothing says so.
    when
        From when to when; empty if there is no schedule.
    after
        Labels of the tasks that end before it starts.
    """

    text: str
    when: str = ""
    after: tuple[str, ...] = ()


class JobWords:
    """
    Finds the words for the roles of a plan.

    Parameters
    ----------
    plan
        A plan with a grounding.
    """

    def __init__(self, plan: Plan) -> None:
        assert plan.grounding is not None
        self._plan, self._roles = plan, plan.grounding.tree.roles
        self._entities = plan.brief.world.extended(plan.tree.entities if plan.tree is not None else ()).by_id
        self._before: dict[str, list[str]] = defaultdict(list)
        if plan.tree is not None:
            for link in plan.tree.links:
                if link.kind in IN_ORDER:
                    self._before[link.second].append(plan.tree.by_id[link.first].label)

    def job(self, role: int, when: str = "") -> Job:
        """The role in words."""
        part = self._roles[role]
        return Job(self._purpose(part.source) or part.label, when, tuple(self._after(part.source)))

    def _purpose(self, source: str | None) -> str:
        tree = self._plan.tree
        node = tree.by_id.get(source) if tree is not None and source is not None else None
        routine = self._plan.brief.routines.by_id.get(node.routine or "") if node is not None else None
        if node is None or routine is None:
            return ""
        purpose = _FIELD.sub(lambda field: self._called(node.arguments.get(field[1], field[1])), routine.purpose)
        return _ASIDE.sub("", purpose)

    def _called(self, entity: str) -> str:
        return self._entities[entity].label if entity in self._entities else entity

    def _after(self, source: str | None) -> Iterator[str]:
        tree = self._plan.tree
        if tree is not None and source is not None and source in tree.by_id:
            for node in (source, *tree.ancestors(source)):
                yield from self._before.get(node, ())
