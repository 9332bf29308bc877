"""One change of what a mission is planned from: what would be bought, moved, allowed or given up."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from missiontree.mission.value import NonNegative, Value

ChangeKind = Literal[
    "take_off_without",
    "take_off_require",
    "end_anywhere",
    "lower_min_quality",
    "allow_type",
    "ignore_kinds",
    "drop_link",
    "open_way",
    "clear_cells",
    "lift_keep_out",
    "allow_zone",
    "extend_deadline",
    "move_release",
    "extend_stay",
    "come_earlier",
    "raise_in_use",
    "raise_capacity",
    "raise_total",
    "raise_stock",
    "raise_limit",
    "lower_limit",
    "raise_quality",
    "add_capability",
    "add_robot",
    "drop_part",
]
CHANGE_KINDS: tuple[ChangeKind, ...] = get_args(ChangeKind)


@dataclass(frozen=True, slots=True, kw_only=True)
class Change(Value):
    """
    A change of fleet, scene, terms or tree, see :data:`ChangeKind`.

    Parameters
    ----------
    kind
        ``take_off_without``, ``take_off_require``: a name off a list of the mission. ``end_anywhere``: robots need not return.
        ``lower_min_quality``: the least quality asked for. ``allow_type``: a robot type, or any, for one routine. ``ignore_kinds``: kinds
        of arguments are not enforced. ``drop_link``: a link of the tree. ``open_way``: a road or a lift. ``clear_cells``: closed cells of
        the grid. ``lift_keep_out``: an area that robots do not enter. ``allow_zone``: a zone for a robot type. ``extend_deadline``,
        ``move_release``: times of a node, or of the mission. ``extend_stay``, ``come_earlier``: times of a robot or a robot type.
        ``raise_in_use``: how many robots of a type may take part. ``raise_capacity``: how many robots a shared resource has room for.
        ``raise_total``: what the robots of a type, or all, may use together. ``raise_stock``: what the scene holds. ``raise_limit``,
        ``lower_limit``: a limit of a robot type. ``raise_quality``, ``add_capability``: what a robot type can do. ``add_robot``: one more
        robot of a type. ``drop_part``: a node of the tree is left out.
    target
        What is changed: a robot type, a robot, a node, ``a - b`` for a road, a lift, a keep-out, a shared resource; empty for the
        whole mission. Cells are told by row from the top and column from the left, from 0: ``3,4 3,5``.
    name
        What of it: a limit, a capability, a zone, the second end of a link, the robot type that is let through; empty where nothing is to
        be told apart.
    was, to
        The number before and after, in the unit of what is changed; None where there is none.
    """

    kind: ChangeKind
    target: str = ""
    name: str = ""
    was: NonNegative | None = None
    to: NonNegative | None = None
