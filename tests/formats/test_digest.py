"""Digests: equal values, equal digests, whatever the order of keys or the spelling of numbers."""

import hashlib

from missiontree.formats.digest import canonical, digest
from missiontree.mission.fleet import Capability, Fleet, RobotType
from missiontree.mission.position import Position


def test_canonical_text_is_compact_sorted_and_without_defaults() -> None:
    cart = RobotType(id="cart", count=1, limits={"payload_kg": 2.0, "energy_j": 0.5}, position=Position(1, -0.0))
    # the label is the id, floor and frame are at their default; 2.0 is written 2 and -0.0 is 0
    expected = (
        '{"types":[{"count":1,"id":"cart","limits":{"energy_j":0.5,"payload_kg":2},"position":{"x_m":1,"y_m":0}}]}'
    )
    assert canonical(Fleet((cart,))) == expected
    assert digest(Fleet((cart,))) == hashlib.sha256(expected.encode()).hexdigest()


def test_order_of_keys_and_spelling_of_numbers_do_not_matter() -> None:
    one = Fleet((RobotType(id="a", count=1, limits={"x": 1, "y": 2}, capabilities={"c": 1}),))
    two = Fleet((RobotType(id="a", count=1, limits={"y": 2.0, "x": 1.0}, capabilities={"c": Capability(1.0)}),))
    assert one == two
    assert digest(one) == digest(two)


def test_order_of_lists_matters() -> None:
    a, b = RobotType(id="a", count=1), RobotType(id="b", count=1)
    assert digest(Fleet((a, b))) != digest(Fleet((b, a)))


def test_text_large_numbers_and_lone_surrogates_have_digests() -> None:
    assert digest("Find Tom") == hashlib.sha256(b'"Find Tom"').hexdigest()
    assert canonical((1e300, 2**53, None, True)) == "[1e+300,9007199254740992,null,true]"
    assert len(digest("\ud800")) == 64
