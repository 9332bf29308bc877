"""Visits to chargers in words: how much of what, and the levels before and after."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Recharge, Schedule
from missiontree.reporting.escape import one_line
from missiontree.reporting.html.quantity import number


@dataclass(frozen=True, slots=True)
class Visit:
    """
    A visit.

    Parameters
    ----------
    recharge
        The visit.
    label
        Name of the charger.
    gain
        How much is taken in, as in ``24 J``.
    levels
        From which level to which, of how much, as in ``38 to 62 of 100 J``.
    """

    recharge: Recharge
    label: str
    gain: str
    levels: str

    @property
    def text(self) -> str:
        """What is done."""
        return f"refill {self.gain} at {self.label}"


def visits_of(plan: Plan, schedule: Schedule) -> dict[str, list[Visit]]:
    """Visits of every robot that has some, in order of time."""
    chargers = {charger.id: charger for charger in plan.brief.world.chargers}
    found: dict[str, list[Visit]] = {}
    for recharge in sorted(schedule.recharges, key=lambda one: (one.start_s, one.robot)):
        charger = chargers.get(recharge.charger)
        stock = charger.stock if charger is not None else ""
        name, unit = _named(stock)
        gain = f"{number(round(recharge.amount, 2))} {unit or name}".rstrip()
        levels = _levels(plan, schedule, recharge, stock)
        label = one_line(charger.label if charger is not None else recharge.charger)
        found.setdefault(recharge.robot, []).append(Visit(recharge, label, gain, f"{name}: {levels} {unit}".rstrip()))
    return found


def _named(stock: str) -> tuple[str, str]:
    """The name of a stock without its unit, and the unit: ``energy_j`` is energy in J."""
    name, _, unit = stock.rpartition("_")
    shown = {"j": "J", "wh": "Wh", "kwh": "kWh", "l": "l", "kg": "kg"}.get(unit)
    return (one_line(name.replace("_", " ")), shown) if name and shown else (one_line(stock), "")


def _levels(plan: Plan, schedule: Schedule, recharge: Recharge, stock: str) -> str:
    """From which level to which a visit takes a robot, and what full is."""
    fleet = plan.brief.fleet
    kind, own = fleet.type_of.get(recharge.robot), fleet.robots.get(recharge.robot)
    if kind is None or own is None or plan.grounding is None:
        return "unknown"
    level = own.remaining.get(stock, kind.limits.get(stock, 0.0))
    level -= sum(
        plan.grounding.tree.action(one.leaf).uses.get(stock, 0.0)
        for one in schedule.actions
        if one.robot == recharge.robot and one.start_s < recharge.start_s
    )
    per_m = kind.uses_per_m.get(stock, 0.0)
    level -= per_m * sum(
        leg.distance_m for leg in schedule.ways if leg.robot == recharge.robot and leg.start_s < recharge.start_s
    )
    stocks = {charger.id: charger.stock for charger in plan.brief.world.chargers}
    level += sum(
        one.amount
        for one in schedule.recharges
        if one.robot == recharge.robot and one.start_s < recharge.start_s and stocks.get(one.charger) == stock
    )
    low, high, full = (
        number(round(amount, 2)) for amount in (level, level + recharge.amount, kind.limits.get(stock, 0.0))
    )
    return f"{low} to {high} of {full}"
