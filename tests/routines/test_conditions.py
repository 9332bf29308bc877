"""Each condition, with the Reason it gives when it is not met."""

from __future__ import annotations

from typing import Any

import pytest

from missiontree.mission.area import Area, Zone
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.routine import ActionStep, Need
from missiontree.mission.scene import Scene
from missiontree.routines.compose import FlatAction, FlatBranch, FlatRole
from missiontree.routines.conditions import Verdict, judge, kind_refused

SQUARE = Area(corners=((0, 0), (10, 0), (10, 10), (0, 10)))


def verdict(
    *needs: Need, scene: Scene | None = None, step: ActionStep | None = None, crate: Entity | None = None, **kind: Any
) -> Verdict:
    step = step or ActionStep(name="act", text="act")
    role = FlatRole("r", (FlatAction(step, "c", None, {}),), needs)
    entities = {"agent": crate or Entity(id="Crate", mass_kg=12)}
    return judge(role, RobotType(id="t", label="Tug", count=1, **kind), entities, scene or Scene(), "Lift(Crate)")


def only(reasons: tuple[Reason, ...]) -> Reason:
    assert len(reasons) == 1
    return reasons[0]


PAYLOAD = Need(limit="payload_kg", at_least="agent.mass_kg")


def test_capability_missing() -> None:
    reason = only(verdict(Need(capability="carry"), capabilities={"reach": 1}).refused)
    assert (reason.rule, reason.robot, reason.found, reason.needed) == ("capability_missing", "t", "reach", "carry")
    assert verdict(Need(capability="carry"), capabilities={"carry": 0.1}) == Verdict()


@pytest.mark.parametrize(("quality", "able"), [(0.49, False), (0.5, True)])
def test_quality_at_least(quality: float, able: bool) -> None:
    found = verdict(Need(capability="carry", at_least=0.5), capabilities={"carry": quality})
    assert [reason.rule for reason in found.refused] == ([] if able else ["quality_too_low"])


@pytest.mark.parametrize(("payload_kg", "able"), [(4, False), (11.99, False), (12, True), (40, True)])
def test_payload_against_mass(payload_kg: float, able: bool) -> None:
    found = verdict(PAYLOAD, limits={"payload_kg": payload_kg})
    assert (not found.refused) is able
    assert found.assumed == ()


def test_a_refusal_names_both_sides() -> None:
    reason = only(verdict(PAYLOAD, limits={"payload_kg": 4}).refused)
    assert reason.rule == "limit_too_low"
    assert reason.message == "Tug cannot do Lift(Crate): payload_kg 4, needed 12 (Crate mass_kg 12)."
    assert (reason.found, reason.needed) == ("payload_kg 4", "payload_kg 12 (Crate mass_kg 12)")


def test_a_share_of_the_load() -> None:
    need = Need(limit="payload_kg", at_least="agent.mass_kg", share=0.5)
    assert verdict(need, limits={"payload_kg": 6}) == Verdict()  # half of 12
    reason = only(verdict(need, limits={"payload_kg": 5}).refused)
    assert reason.needed == "payload_kg 6 (Crate mass_kg 12, share 0.5)"


def test_limit_too_high() -> None:
    need = Need(limit="width_m", at_most=0.8)
    assert verdict(need, limits={"width_m": 0.8}) == Verdict()
    assert only(verdict(need, limits={"width_m": 0.9}).refused).rule == "limit_too_high"


def test_attributes_of_the_users_own_are_compared() -> None:
    need = Need(limit="reach_m", at_least="agent.shelf_m")
    crate = Entity(id="Crate", attributes={"shelf_m": 2.5})
    assert only(verdict(need, crate=crate, limits={"reach_m": 2}).refused).rule == "limit_too_low"


def test_what_is_unknown_refuses_nobody_and_is_stated() -> None:
    unknown_mass = verdict(PAYLOAD, crate=Entity(id="Crate"), limits={"payload_kg": 4})
    assert unknown_mass.refused == ()
    assert only(unknown_mass.assumed).rule == "attribute_unknown"
    assert "mass_kg of Crate is unknown" in only(unknown_mass.assumed).message
    unknown_payload = verdict(PAYLOAD)
    assert unknown_payload.refused == ()
    assert only(unknown_payload.assumed).rule == "limit_unknown"


@pytest.mark.parametrize("where", ["at", "goes_to"])
@pytest.mark.parametrize(("zones", "able"), [(None, True), (("hall",), True), (("yard",), False), ((), False)])
def test_zones(where: str, zones: tuple[str, ...] | None, able: bool) -> None:
    scene = Scene(zones=(Zone(id="hall", area=SQUARE), Zone(id="yard")))
    step = ActionStep(name="act", text="act", **{where: "agent"})  # type: ignore[arg-type]
    found = verdict(step=step, scene=scene, crate=Entity(id="Crate", position=Position(5, 5)), zones=zones)
    assert [reason.rule for reason in found.refused] == ([] if able else ["zone_forbidden"])


def test_an_entity_without_a_place_in_the_role_does_not_matter() -> None:
    scene = Scene(zones=(Zone(id="hall", area=SQUARE),))
    assert verdict(scene=scene, crate=Entity(id="Crate", position=Position(5, 5)), zones=()) == Verdict()


@pytest.mark.parametrize(
    ("kind", "able"), [("person", True), ("child", True), ("animal", False), ("toddler", True), ("cat", False)]
)
def test_kinds_below_an_accepted_kind_count(kind: str, able: bool) -> None:
    scene = Scene(kinds={"child": "person", "toddler": "child", "cat": "animal"})
    branch = FlatBranch("message", (("agent", ("person",)),), ())
    reason = kind_refused(branch, {"agent": Entity(id="x", label="X", kind=kind)}, scene, "Lead(X)")
    assert (reason is None) is able
    if reason is not None:
        assert (reason.rule, reason.found, reason.needed) == ("kind_refused", f"X: {kind}", "person")
