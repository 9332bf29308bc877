"""Limits that clash, in words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.allocation.clashing import MOST_NODES, Clash, clash_of, only, too_large
from missiontree.allocation.flat import EVERYBODY, Flat
from missiontree.allocation.limit_wording import phrase, remedy
from missiontree.allocation.limits import Limit, limits_of
from missiontree.allocation.possible import Excess, Possibility, possible_nodes, reasons_of, structurally_possible
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.reason import Reason

MOST_TOLD = 12


def with_clash(ranking: Ranking, flat: Flat, control: Control) -> Ranking:
    """The ranking; if there is no alternative, with the limits that clash before all other reasons."""
    if ranking.status != "infeasible" or not (limits_of(flat) and structurally_possible(flat)[0]):
        return ranking
    if too_large(flat):
        return replace(ranking, reasons=(*ranking.reasons, _not_sought(flat)))
    clash = clash_of(flat, control)
    if clash is None:
        return replace(ranking, reasons=(*ranking.reasons, _not_found())) if control.ended() else ranking
    told = reason_of(flat, clash)
    others = (reason for reason in ranking.reasons if reason.message != told.message)
    return replace(ranking, reasons=(told, *others))


def reason_of(flat: Flat, clash: Clash) -> Reason:
    """The whole clash as one reason."""
    told = [phrase(flat, limit) for limit in clash.limits[:MOST_TOLD]]
    if len(clash.limits) > MOST_TOLD:
        told.append(f"{len(clash.limits) - MOST_TOLD} more limits")
    if len(clash.limits) == 1:
        exceeded = _exceeded(only(flat, *clash.limits))
        if exceeded is not None:
            return replace(exceeded, rule="limits_clash", hint=exceeded.hint if clash.enough else _hint(flat, clash))
        so = "Whatever is chosen, this cannot be kept:"
    else:
        so = "Together these cannot be kept:" if clash.irreducible else "These limits clash; it may be that fewer do:"
    return Reason(
        rule="limits_clash",
        message=f"{so} {_listed(told, 'and')}.",
        robot=_robot(clash.limits),
        found="; ".join(told),
        hint=_hint(flat, clash),
    )


def _not_sought(flat: Flat) -> Reason:
    return Reason(
        rule="clash_not_sought",
        severity="notice",
        message=f"Which limits clash was not looked for: the tree has {len(flat.kind):,} nodes, more than {MOST_NODES:,}.",
    )


def _not_found() -> Reason:
    return Reason(
        rule="clash_not_sought",
        severity="notice",
        message="Which limits clash was not found out in the time given.",
        hint="Give more time (--time-limit).",
    )


def _exceeded(alone: Flat) -> Reason | None:
    """In a problem of one limit: what cannot be avoided and needs more than there is, if one sweep shows it."""
    known = possible_nodes(alone)
    if known.possible[0]:
        return None
    if known.idle:
        return reasons_of(alone, known, "error", 1)[0]
    blamed = _unavoidable(alone, known)
    return None if blamed is None else reasons_of(alone, Possibility(known.possible, [blamed]), "error", 1)[0]


def _unavoidable(flat: Flat, known: Possibility) -> Excess | None:
    """The lowest node that cannot be avoided, with the least that it needs; None if its ways need different things."""
    own = {excess.node: excess for excess in known.excesses}
    told: dict[int, Excess] = {}
    for node in range(len(flat.kind) - 1, -1, -1):
        if node in own:
            told[node] = own[node]
        elif not known.possible[node]:
            below = [told[child] for child in flat.children[node] if child in told]
            if flat.kind[node] == "and" and below:
                told[node] = below[0]
            elif len(below) == len(flat.children[node]) and len({_kept(excess) for excess in below}) == 1:
                least = min(below, key=lambda excess: excess.needed)
                told[node] = replace(least, node=node)
    return told.get(0)


def _kept(excess: Excess) -> tuple[str, bool, str, int]:
    """What was exceeded, whichever role one robot fills."""
    type_id, role, name = excess.purse
    return type_id, role < 0, name, excess.found


def _hint(flat: Flat, clash: Clash) -> str:
    """What would be enough, as far as that is known."""
    if clash.enough is None:
        return "Loosen one of them; it is not known whether that is enough."
    if not clash.enough:
        return "Other limits clash as well, so that to loosen one is not enough."
    remedies = [remedy(flat, limit) for limit in clash.enough[:MOST_TOLD]]
    if len(remedies) == 1:
        return f"It would be enough to {remedies[0]}."
    return f"Each of these would be enough: {_listed(remedies, 'or')}."


def _robot(limits: Sequence[Limit]) -> str:
    """The type that all of them are about; empty if they are about several."""
    types = {limit.who for limit in limits}
    return types.pop() if len(types) == 1 else EVERYBODY


def _listed(told: Sequence[str], word: str) -> str:
    if len(told) < 3:
        return f", {word} ".join(told)
    return f"{'; '.join(told[:-1])}; {word} {told[-1]}"
