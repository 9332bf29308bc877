"""Rules of the mission itself: who is left out or required, how good actions must be, who is allowed, which kinds are enforced."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from missiontree.explaining.case import Case
from missiontree.explaining.changes.editing import put, shown, with_brief, with_node
from missiontree.explaining.changes.needs import Needs
from missiontree.mission.change import Change


def candidates(case: Case, needs: Needs) -> Iterator[Change]:
    """Every rule that the mission states."""
    brief = case.brief
    for name in brief.without:
        yield Change(kind="take_off_without", target=name)
    for name in brief.require:
        yield Change(kind="take_off_require", target=name)
    if brief.return_home:
        yield Change(kind="end_anywhere")
    if isinstance(brief.min_quality, Mapping):
        for name, least in brief.min_quality.items():
            yield Change(kind="lower_min_quality", name=name, was=least)
    elif brief.min_quality:
        yield Change(kind="lower_min_quality", was=brief.min_quality)
    for node in case.tree.nodes:
        allowed = node.resources
        out = [kind.id for kind in brief.fleet.types if allowed is not None and kind.id not in allowed]
        for type_id in out:
            yield Change(kind="allow_type", target=node.id, name=type_id)
        if len(out) > 1:  # joint work may need several of them
            yield Change(kind="allow_type", target=node.id)
    if brief.check_kinds:
        yield Change(kind="ignore_kinds")
    for link in dict.fromkeys(case.tree.links):
        if link.kind in {"same_robot", "different_robot"}:
            yield Change(kind="drop_link", target=link.first, name=link.second)


def take_off_without(case: Case, change: Change) -> Case:
    """A type or a robot takes part again."""
    return with_brief(case, without=tuple(name for name in case.brief.without if name != change.target))


def take_off_without_words(case: Case, change: Change) -> str:
    """As an order."""
    return f"let {_label(case, change.target)} take part (take it off 'without')"


def take_off_require(case: Case, change: Change) -> Case:
    """A type or a robot need not take part."""
    return with_brief(case, require=tuple(name for name in case.brief.require if name != change.target))


def take_off_require_words(case: Case, change: Change) -> str:
    """As an order."""
    return f"do not insist on {_label(case, change.target)} (take it off 'require')"


def end_anywhere(case: Case, change: Change) -> Case:
    """Robots need not return to where they started."""
    return with_brief(case, return_home=False)


def end_anywhere_words(case: Case, change: Change) -> str:
    """As an order."""
    return "let robots end where they are (return_home: false)"


def lower_min_quality(case: Case, change: Change) -> Case:
    """Actions need not be so good."""
    asked = case.brief.min_quality
    if isinstance(asked, Mapping):
        return with_brief(case, min_quality=put(asked, change.name, change.to))
    return with_brief(case, min_quality=change.to or 0.0)


def lower_min_quality_words(case: Case, change: Change) -> str:
    """As an order."""
    of = f" of {change.name}" if change.name else ""
    return f"ask for a quality{of} of {shown(change.to or 0.0)} instead of {shown(change.was)} (min_quality)"


def allow_type(case: Case, change: Change) -> Case:
    """A type may do a routine, or any."""
    allowed = case.tree.by_id[change.target].resources or ()
    return with_node(case, change.target, resources=(*allowed, change.name) if change.name else None)


def allow_type_words(case: Case, change: Change) -> str:
    """As an order."""
    whom = _label(case, change.name) if change.name else "any robot type"
    return f'allow {whom} for "{case.tree.by_id[change.target].label}"'


def ignore_kinds(case: Case, change: Change) -> Case:
    """Kinds of arguments are not enforced."""
    return with_brief(case, check_kinds=False)


def ignore_kinds_words(case: Case, change: Change) -> str:
    """As an order."""
    return "do not enforce kinds of arguments (check_kinds: false)"


def drop_link(case: Case, change: Change) -> Case:
    """Two parts need not have the same robot, or different ones."""
    links = tuple(
        link
        for link in case.tree.links
        if link.kind not in {"same_robot", "different_robot"}
        or (link.first, link.second) != (change.target, change.name)
    )
    return replace(case, tree=replace(case.tree, links=links))


def drop_link_words(case: Case, change: Change) -> str:
    """As an order."""
    first, second = case.tree.by_id[change.target].label, case.tree.by_id[change.name].label
    kinds = {link.kind for link in case.tree.links if (link.first, link.second) == (change.target, change.name)}
    what = "one robot does both" if "same_robot" in kinds else "different robots do"
    return f'give up that {what} "{first}" and "{second}"'


def _label(case: Case, name: str) -> str:
    kind = case.brief.fleet.by_id.get(name)
    return name if kind is None else kind.label
