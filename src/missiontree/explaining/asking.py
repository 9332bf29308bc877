"""
Questions about a plan that can be carried out, each answered by planning again.

A question is a few words: ``Tele-Robot for Search(cat)``, ``Search(cat) by Tele-Robot``, ``Tele-Robot``, ``3``, ``alternative 3``;
"why not", "use" and a question mark around them are left aside.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from missiontree.briefing import Request
from missiontree.errors import InputError
from missiontree.explaining.answering import best_of
from missiontree.explaining.explain import request_of
from missiontree.explaining.naming import nodes_named, team_member
from missiontree.explaining.rank_asked import why_not_rank
from missiontree.explaining.robot_asked import why_not_robot
from missiontree.explaining.without_asked import what_without
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.mission.tree import MissionNode
from missiontree.mission.why_not import WhyNot

ACCEPTED = "'Tele-Robot for Search(cat)', 'Search(cat) by Tele-Robot', 'Tele-Robot', or 'alternative 3'"
_AROUND = re.compile(
    r"^\s*(?:why\s+not\s+)?(?:use\s+|take\s+)?(?:a\s+|an\s+|the\s+)?(.*?)\s*\??\s*$", re.IGNORECASE | re.DOTALL
)
_RANK = re.compile(r"(?:alternative|rank|number|no\.?|#)?\s*([0-9]{1,6})", re.IGNORECASE)
_NOT_DOING = re.compile(
    r"^\s*why\s+(?:is|are|does|do|did|was)\s+(.*?)\s+not\s+(?:doing|do|used\s+for|used|taken\s+for|for)\s+(.*?)\s*\??\s*$",
    re.IGNORECASE | re.DOTALL,
)
_JOINS = (" instead of ", " for ", " on ", " at ", " in ", " to do ", " do ")


def why_not(plan: Plan, question: str, *, control: Control | None = None, request: Request | None = None) -> WhyNot:
    """
    Answer why a plan is not otherwise.

    Parameters
    ----------
    plan
        A plan that is delivered, whole or in part.
    question
        A robot type (or robot) and what it should do; a robot type alone; or the rank of an alternative.
    control
        Time limit and stop token. Default: no limit.
    request
        How the plan was made. Default: as the plan says; needed where its estimates are those of an estimator of the user's own.

    Returns
    -------
    WhyNot
        With a plan that is as asked for, checked, if there is one.

    Raises
    ------
    InputError
        If the plan is not delivered, or the question names what there is not, with what is accepted.
    """
    request, control = _ready(plan, request), control or Control()
    if (doing := _NOT_DOING.match(question)) is not None:
        question = f"{doing[1]} for {doing[2]}"
    found = _AROUND.match(question)
    asked = found[1] if found is not None else question
    if (ranked := _RANK.fullmatch(asked.strip())) is not None:
        return why_not_rank(plan, request, int(ranked[1]), control)
    robot, node = _parts(asked, plan)
    return why_not_by(plan, robot, node, control=control, request=request)


def why_not_by(
    plan: Plan, robot: str, node: str = "", *, control: Control | None = None, request: Request | None = None
) -> WhyNot:
    """Answer why a robot type, or that of a robot, does not do a node of the mission tree; see :func:`why_not`. Default: any node."""
    request, control = _ready(plan, request), control or Control()
    assert plan.tree is not None
    type_id, _ = team_member(robot, plan.brief.fleet, "--why-not")
    nodes = _nodes(node, plan)
    return why_not_robot(plan, request, type_id, nodes, control)


def without(
    plan: Plan, names: Sequence[str], *, control: Control | None = None, request: Request | None = None
) -> WhyNot:
    """
    Answer what would change without some robots or robot types; parameters as :func:`why_not` takes them.

    Raises
    ------
    InputError
        If the plan is not delivered, or a name is neither a robot type nor a robot.
    """
    request, control = _ready(plan, request), control or Control()
    found = [team_member(name, plan.brief.fleet, "--without") for name in names]
    return what_without(plan, request, [robot or type_id for type_id, robot in found], control)


def _ready(plan: Plan, request: Request | None) -> Request:
    """The request behind a plan that can be asked about."""
    if plan.outcome not in {"delivered", "partial"} or plan.tree is None or plan.grounding is None:
        raise InputError(
            f"the plan has no schedule that could be otherwise: its outcome is {plan.outcome.replace('_', ' ')}",
            accepted="a plan that is delivered",
            hint="`missiontree explain plan.json` says why it cannot be done.",
        )
    return request or request_of(plan)


def _nodes(name: str, plan: Plan) -> tuple[MissionNode, ...]:
    """Parts of the mission that a name means: by their own name, what they are about, or who does them; without a name all of it."""
    assert plan.tree is not None
    if not name:
        return (plan.tree.root,)
    labels = {one.id: one.label or one.id for one in plan.brief.world.extended(plan.tree.entities).all_entities}
    try:
        return nodes_named(name, plan.tree, "--why-not", labels)
    except InputError:
        done = _done_by(name, plan)
        if not done:
            raise
        return done


def _done_by(name: str, plan: Plan) -> tuple[MissionNode, ...]:
    """Tasks of the best alternative that a robot or robot type does; none if the name is nobody's."""
    try:
        type_id, robot = team_member(name, plan.brief.fleet, "--why-not")
    except InputError:
        return ()
    best = best_of(plan)
    assert best is not None
    assert plan.grounding is not None
    assert plan.tree is not None
    tree = plan.grounding.tree
    types = {filled.role: filled.robot_type for filled in best[0].roles}
    robots = {assigned.role: assigned.robot for assigned in best[1].assignments}
    roles = [role for role in types if types[role] == type_id and robot in {"", robots.get(role)}]
    sources = {tree.roles[role].source for role in roles}
    return tuple(node for node in plan.tree.nodes if node.id in sources)


def _parts(asked: str, plan: Plan) -> tuple[str, str]:
    """Robot and node of a question, whichever way round they stand."""
    splits = [(asked, "")]
    for join in _JOINS:
        head, found, tail = asked.partition(join)
        splits += [(head, tail)] if found else []
    head, found, tail = asked.rpartition(" by ")
    splits += [(tail, head)] if found else []
    for robot, node in splits:
        try:
            team_member(_bare(robot), plan.brief.fleet, "--why-not")
        except InputError:
            continue
        return _bare(robot), _bare(node)
    robot = splits[1][0] if len(splits) > 1 else asked
    try:
        team_member(_bare(robot), plan.brief.fleet, "--why-not")
    except InputError as error:
        _refuse_part_alone(_bare(asked), plan)
        raise InputError(
            error.message, where="--why-not", accepted=f"{ACCEPTED}; robots are {error.accepted}", hint=error.hint
        ) from error
    return robot, ""


def _refuse_part_alone(asked: str, plan: Plan) -> None:
    """Say so if a part of the mission is named and nobody who should do it."""
    if not asked:
        return
    try:
        node = _nodes(asked, plan)[0]
    except InputError:
        return
    types = ", ".join(kind.label or kind.id for kind in plan.brief.fleet.types)
    raise InputError(
        f"{node.label} is a part of the mission; who should do it is not said",
        where="--why-not",
        accepted=f"'TYPE for {node.label}', with one of {types}",
    )


def _bare(name: str) -> str:
    return re.sub(r"^(?:the|a|an)\s+", "", name.strip(), flags=re.IGNORECASE)
