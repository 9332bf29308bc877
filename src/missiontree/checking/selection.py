"""Is the alternative a selection of the tree: one child at every reached XOR, all children of every AND?"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault, named


def choice_dangling(case: Case) -> Iterator[Fault]:
    """A choice names a node that is no XOR of the tree, or a child that is not that node's."""
    for staffing in case.staffings:
        tree, rank = staffing.tree, staffing.alternative.rank
        for choice in staffing.alternative.choices:
            if choice.xor >= len(tree.nodes) or tree.nodes[choice.xor].kind != "xor":
                yield Fault(
                    f"alternative {rank} chooses at node {choice.xor}, which is no XOR of the tree.",
                    node=named(tree, choice.xor),
                    needed="an XOR node",
                )
            elif choice.child not in tree.children[choice.xor]:
                yield Fault(
                    f"alternative {rank} takes node {choice.child}, which is not a child of node {choice.xor}.",
                    node=named(tree, choice.xor),
                    found=str(choice.child),
                    needed=f"one of {list(tree.children[choice.xor])}",
                )


def choice_missing(case: Case) -> Iterator[Fault]:
    """An XOR is reached and nothing is chosen at it."""
    for staffing in case.staffings:
        chosen = {choice.xor for choice in staffing.alternative.choices}
        for node in staffing.reached:
            if staffing.tree.nodes[node].kind == "xor" and node not in chosen:
                yield Fault(
                    f"alternative {staffing.alternative.rank} reaches the XOR {named(staffing.tree, node)} and chooses no child.",
                    node=named(staffing.tree, node),
                    needed="exactly one child",
                )


def choice_double(case: Case) -> Iterator[Fault]:
    """Two choices are made at one XOR."""
    for staffing in case.staffings:
        counts = Counter(choice.xor for choice in staffing.alternative.choices)
        for node, count in sorted(counts.items()):
            if count > 1:
                yield Fault(
                    f"alternative {staffing.alternative.rank} chooses {count} times at {named(staffing.tree, node)}.",
                    node=named(staffing.tree, node),
                    found=str(count),
                    needed="1",
                )


def choice_unreached(case: Case) -> Iterator[Fault]:
    """A choice is made at an XOR that the other choices do not reach."""
    for staffing in case.staffings:
        reached = set(staffing.reached)
        for choice in staffing.alternative.choices:
            if choice.xor < len(staffing.tree.nodes) and choice.xor not in reached:
                yield Fault(
                    f"alternative {staffing.alternative.rank} chooses at {named(staffing.tree, choice.xor)}, which is not reached.",
                    node=named(staffing.tree, choice.xor),
                )


def choice_order(case: Case) -> Iterator[Fault]:
    """The choices do not stand in preorder, so that their order of ties means nothing."""
    for staffing in case.staffings:
        place = {node: position for position, node in enumerate(staffing.reached)}
        places = [place[choice.xor] for choice in staffing.alternative.choices if choice.xor in place]
        if places != sorted(places):
            yield Fault(f"the choices of alternative {staffing.alternative.rank} are not listed in preorder.")


def action_missing(case: Case) -> Iterator[Fault]:
    """A selected action is not scheduled."""
    for timetable in case.timetables:
        for leaf in timetable.staffing.actions:
            if leaf not in timetable.deeds:
                yield Fault(
                    f"schedule {timetable.schedule.rank} leaves out {named(timetable.tree, leaf)}.",
                    node=named(timetable.tree, leaf),
                    found="0 times",
                    needed="once",
                )


def action_extra(case: Case) -> Iterator[Fault]:
    """Something is scheduled that the alternative does not select."""
    for timetable in case.timetables:
        for done in timetable.schedule.actions:
            if done.leaf not in timetable.staffing.actions:
                yield Fault(
                    f"schedule {timetable.schedule.rank} does {named(timetable.tree, done.leaf)}, which is not selected.",
                    node=named(timetable.tree, done.leaf),
                    robot=done.robot,
                )


def action_double(case: Case) -> Iterator[Fault]:
    """An action is scheduled more than once."""
    for timetable in case.timetables:
        counts = Counter(done.leaf for done in timetable.schedule.actions)
        for leaf, count in sorted(counts.items()):
            if count > 1:
                yield Fault(
                    f"schedule {timetable.schedule.rank} does {named(timetable.tree, leaf)} {count} times.",
                    node=named(timetable.tree, leaf),
                    found=f"{count} times",
                    needed="once",
                )
