"""Is the tree over the fleet what the mission tree, the fleet and the scene give?"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault
from missiontree.mission.grounded import GroundedNode, Grounding


def grounding_differs(case: Case) -> Iterator[Fault]:
    """The tree over the fleet is not the one that grounding gives; the first node that differs is named."""
    given, made = case.plan.grounding, _grounded(case)
    if given is None or made is None:
        return
    for index, (found, needed) in enumerate(zip(given.tree.nodes, made.tree.nodes, strict=False)):
        if found != needed:
            yield _node_differs(index, found, needed)
            return
    for what in ("nodes", "roles", "links", "objective"):
        found_part, needed_part = getattr(given.tree, what), getattr(made.tree, what)
        if found_part != needed_part:
            count = "" if what == "objective" else f", {len(found_part)} instead of {len(needed_part)}"
            yield Fault(
                f"the {what} of the tree over the fleet are not those that mission, fleet and scene give{count}.",
                found=_short(found_part),
                needed=_short(needed_part),
            )
            return


def grounding_notes_differ(case: Case) -> Iterator[Fault]:
    """What grounding refused, assumed, changed or warned of is not what it says in the plan."""
    given, made = case.plan.grounding, _grounded(case)
    if given is None or made is None:
        return
    for what in ("not_offered", "assumptions", "notices", "findings"):
        found, needed = getattr(given, what), getattr(made, what)
        if found != needed:
            missing = [reason.message for reason in needed if reason not in found]
            yield Fault(
                f"the {what} of grounding are not those that mission, fleet and scene give"
                f"{': missing is ' + repr(missing[0]) if missing else ''}.",
                found=f"{len(found)}",
                needed=f"{len(needed)}",
            )


def grounding_impossible(case: Case) -> Iterator[Fault]:
    """Grounding refuses the mission tree that the plan claims to have grounded."""
    if case.plan.grounding is not None and isinstance(case.regrounded, str):
        yield Fault(f"the mission tree cannot be grounded: {case.regrounded}")


def _grounded(case: Case) -> Grounding | None:
    return case.regrounded if isinstance(case.regrounded, Grounding) else None


def _node_differs(index: int, found: GroundedNode, needed: GroundedNode) -> Fault:
    owners: list[tuple[object, object]] = [(found, needed)]
    if found.action is not None and needed.action is not None and found.action != needed.action:
        owners = [(found.action, needed.action)]
    name, was, should = next(
        (field.name, getattr(first, field.name), getattr(second, field.name))
        for first, second in owners
        for field in fields(first)  # type: ignore[arg-type]
        if getattr(first, field.name) != getattr(second, field.name)
    )
    return Fault(
        f"{found.label} [{index}] is not what mission, fleet and scene give: its {name} is {_short(was)}, not {_short(should)}.",
        node=f"{found.label} [{index}]",
        found=_short(was),
        needed=_short(should),
    )


def _short(value: object) -> str:
    text = str(value)
    return text if len(text) <= 200 else text[:197] + "..."
