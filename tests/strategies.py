"""Hypothesis strategies that draw whole families of inputs. The shapes themselves come from ``benchmarks/random_trees.py``."""

from __future__ import annotations

from hypothesis import strategies as st

from benchmarks.random_trees import Case, random_case, random_fleet, random_tree
from missiontree.allocation.flat import Stock
from missiontree.allocation.packing import Load
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree


def cases() -> st.SearchStrategy[Case]:
    """Grounded trees with fleet, weights and k, small enough for the oracle."""
    return st.randoms(use_true_random=False).map(random_case)


def fleets(coupled: bool = True) -> st.SearchStrategy[Fleet]:
    """Fleets of one to three types, with budgets per robot and per type if coupled."""
    return st.randoms(use_true_random=False).map(lambda rng: random_fleet(rng, coupled))


@st.composite
def grounded_trees(draw: st.DrawFn, size: int = 8, coupled: bool = True) -> tuple[GroundedTree, Fleet]:
    """A grounded tree of about that many roles, and the fleet that it names."""
    rng = draw(st.randoms(use_true_random=False))
    fleet = random_fleet(rng, coupled)
    return random_tree(rng, fleet, size, coupled), fleet


@st.composite
def packings(draw: st.DrawFn) -> tuple[Stock, list[Load]]:
    """Robots of one type with budgets, of which so many may and some must be in use, and loads, some of which must stay apart."""
    names = draw(st.sampled_from([("e",), ("e", "w")]))
    limits = st.dictionaries(st.sampled_from(names), st.integers(0, 9))
    budgets = draw(st.lists(limits, min_size=1, max_size=3))
    count = draw(st.integers(0, 5))
    uses = [draw(st.dictionaries(st.sampled_from(names), st.integers(0, 6))) for _ in range(count)]
    pairs = draw(st.sets(st.tuples(st.integers(0, 4), st.integers(0, 4))))
    apart = [
        frozenset(b for b in range(count) if a != b and ((a, b) in pairs or (b, a) in pairs)) for a in range(count)
    ]
    most = draw(st.sampled_from([None, None, 1, 2]))
    required = draw(st.sets(st.integers(0, len(budgets) - 1))) if draw(st.booleans()) else set()
    names_of = tuple(f"r{index}" for index in range(len(budgets)))
    stock = Stock(names_of, tuple(budgets), {}, max_in_use=most, required=tuple(sorted(required)))
    return stock, [Load(group, uses[group], apart[group]) for group in range(count)]
