"""Composed routines flatten into branches: products, one held role for same_robot, precedence between other parts."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.errors import InputError
from missiontree.mission.routine import ActionStep, Argument, Branch, Need, Part, RoleSpec, Routine, RoutineLibrary
from missiontree.routines.compose import FlatBranch, Order, flatten
from missiontree.routines.library import built_in

A = (Argument(name="a", kinds=("object",)),)


def role(name: str, steps: int = 1, robots: int = 1, sync: str | None = None) -> RoleSpec:
    actions = tuple(ActionStep(name=f"{name}{i}", text=f"{name}{i}", sync=sync) for i in range(steps))
    return RoleSpec(name=name, rating=name, actions=actions, robots=robots)


def simple(name: str, *branches: tuple[RoleSpec, ...]) -> Routine:
    ways = tuple(Branch(name=f"{name}{i}", roles=roles) for i, roles in enumerate(branches))
    return Routine(id=name, purpose=name, arguments=A, branches=ways)


def composed(name: str, *parts: str, same_robot: tuple[int, ...] = ()) -> Routine:
    return Routine(
        id=name, purpose=name, arguments=A, parts=tuple(Part(routine=part) for part in parts), same_robot=same_robot
    )


def flat(*routines: Routine) -> tuple[FlatBranch, ...]:
    return flatten(routines[-1], RoutineLibrary(routines=routines))


def names(branch: FlatBranch) -> list[list[str]]:
    return [[action.step.name for action in each.actions] for each in branch.roles]


def test_reach_and_transport_is_one_held_role_per_branch_and_each_action_keeps_its_rating() -> None:
    library = built_in()
    carry, message = flatten(library.by_id["ReachAndTransport"], library)
    assert (carry.name, message.name) == ("carry", "message_display")
    (held,) = carry.roles
    assert [action.rating for action in held.actions] == ["reach", "reach", "carry", "carry"]
    assert [need.capability or need.limit for need in held.needs] == ["reach", "carry", "payload_kg"]
    assert carry.order == ()
    assert ("agent", ("person",)) in message.accepts
    assert ("agent", ("person",)) not in carry.accepts


def test_arguments_are_renamed_everywhere() -> None:
    inner = Routine(
        id="In",
        purpose="{a} to {b}",
        arguments=(Argument(name="a", kinds=("object",)), Argument(name="b", kinds=("place",))),
        branches=(
            Branch(
                name="go",
                accepts={"a": ("crate",)},
                roles=(
                    RoleSpec(
                        name="r",
                        rating="r",
                        needs=(Need(limit="payload_kg", at_least="a.mass_kg", share=0.5),),
                        actions=(
                            ActionStep(name="find", text="{a}", at="a", finds="a"),
                            ActionStep(name="go", text="{a} {b} {robot}", goes_to="b", brings=("a",)),
                        ),
                    ),
                ),
            ),
        ),
    )
    outer = Routine(
        id="Out",
        purpose="Out",
        arguments=(Argument(name="b", kinds=("object",)), Argument(name="c", kinds=("place",))),
        parts=(Part(routine="In", arguments={"a": "b", "b": "c"}),),
    )
    # The outer b is the inner a: a renaming one name after the other would turn it into c.
    (branch,) = flat(inner, outer)
    find, go = branch.roles[0].actions
    assert (find.step.at, find.step.finds) == ("b", "b")
    assert (go.step.goes_to, go.step.brings) == ("c", ("b",))
    assert dict(go.fields) == {"a": "b", "b": "c"}
    assert branch.roles[0].needs[1] == Need(limit="payload_kg", at_least="b.mass_kg", share=0.5)
    assert ("b", ("crate",)) in branch.accepts


def test_parts_without_same_robot_keep_their_roles_in_order() -> None:
    (branch,) = flat(simple("p", (role("p", 2),)), simple("q", (role("q", 2),)), composed("both", "p", "q"))
    assert names(branch) == [["p0", "p1"], ["q0", "q1"]]
    # The last action of p (index 1) ends before the first of q starts.
    assert branch.order == (Order(0, 1, 1, 0),)
    assert [each.team for each in branch.roles] == [None, None]


def test_a_held_role_waits_inside_for_a_part_between() -> None:
    parts = [simple(name, (role(name, 2),)) for name in "pqr"]
    (branch,) = flat(*parts, composed("all", "p", "q", "r", same_robot=(0, 2)))
    assert names(branch) == [["p0", "p1", "r0", "r1"], ["q0", "q1"]]
    # p1 is action 1 of the held role, r0 its action 2.
    assert branch.order == (Order(0, 1, 1, 0), Order(1, 1, 0, 2))


def test_roles_of_one_branch_share_a_team_and_other_parts_have_their_own() -> None:
    pair = simple("pair", (role("x", sync="lift"), role("y", sync="lift")))
    (branch,) = flat(pair, composed("twice", "pair", "pair"))
    assert [each.team for each in branch.roles] == [0, 0, 1, 1]
    syncs = [each.actions[0].sync for each in branch.roles]
    assert syncs[0] == syncs[1] != syncs[2] == syncs[3]
    # Both roles of the first part come before both of the second.
    assert set(branch.order) == {Order(r, 0, s, 0) for r in (0, 1) for s in (2, 3)}


def test_composed_of_composed() -> None:
    parts = [simple(name, (role(name),)) for name in "pqr"]
    inner = composed("inner", "p", "q", same_robot=(0, 1))
    (branch,) = flat(*parts, inner, composed("outer", "inner", "r", same_robot=(0, 1)))
    assert names(branch) == [["p0", "q0", "r0"]]


def test_order_inside_a_composed_part_moves_with_it() -> None:
    parts = [simple(name, (role(name),)) for name in "pqr"]
    inner = composed("inner", "p", "q")
    (branch,) = flat(*parts, inner, composed("outer", "r", "inner"))
    assert names(branch) == [["r0"], ["p0"], ["q0"]]
    assert set(branch.order) == {Order(1, 0, 2, 0), Order(0, 0, 1, 0), Order(0, 0, 2, 0)}


def test_one_robot_cannot_be_a_team() -> None:
    pair = simple("pair", (role("x"), role("y")))
    with pytest.raises(InputError, match=r"part 1 .* needs 2"):
        flat(simple("p", (role("p"),)), pair, composed("both", "p", "pair", same_robot=(0, 1)))


def test_too_many_combinations_are_refused() -> None:
    many = simple("m", *[(role(f"m{i}"),) for i in range(17)])
    with pytest.raises(InputError, match="289 ways"):  # 17 * 17, above 256
        flat(many, composed("square", "m", "m"))


@given(st.lists(st.integers(1, 3), min_size=1, max_size=4), st.data())
def test_composition_is_the_product_in_order_and_keeps_every_action(ways: list[int], data: st.DataObject) -> None:
    """Branches come with the last part varying fastest; every action of every part is there once, in part order per role."""
    parts = [simple(f"p{i}", *[(role(f"p{i}w{j}", 2),) for j in range(count)]) for i, count in enumerate(ways)]
    same = tuple(index for index in range(len(ways)) if data.draw(st.booleans()))
    branches = flat(*parts, composed("all", *(part.id for part in parts), same_robot=same))
    expected: list[tuple[int, ...]] = [()]
    for count in ways:
        expected = [(*taken, way) for taken in expected for way in range(count)]
    assert len(branches) == len(expected)
    for branch, taken in zip(branches, expected, strict=True):
        wanted = [f"p{i}w{way}{step}" for i, way in enumerate(taken) for step in (0, 1)]
        assert sorted(name for each in names(branch) for name in each) == sorted(wanted)
        for each in names(branch):
            assert each == [name for name in wanted if name in each]
        # One order between consecutive parts, except where both are in the held role.
        assert len(branch.order) == sum(not {i, i + 1} <= set(same) for i in range(len(ways) - 1))
