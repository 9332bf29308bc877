"""Rounds of branch and bound: the k best within the purses and in order, at both speeds, and honest when they are stopped."""

from __future__ import annotations

import pytest
from hypothesis import given, settings

from benchmarks.random_trees import Case
from benchmarks.tied_budget import tied_mission
from benchmarks.trees import instance, text_of
from missiontree.allocation import crew
from missiontree.allocation import rounds as module
from missiontree.allocation.columns import flat_of_columns
from missiontree.allocation.compiled import PLAIN, Engine, fast_engine
from missiontree.allocation.core import core_of
from missiontree.allocation.feasibility import Feasibility
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.pool import Pool
from missiontree.allocation.possible import possible_nodes
from missiontree.allocation.preorder import preorder
from missiontree.allocation.purses import purses_of
from missiontree.allocation.rounds import Rounds, least_utility
from missiontree.formats.importers.tree_json import columns_of
from missiontree.formats.reader import parse
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from tests.allocation.test_searched import Boiled, boiled, ways_within
from tests.builders import trivial_fleet
from tests.strategies import cases

MANY = (10**6, 10**6)


def rounds_of(problem: Boiled, k: int, control: Control | None = None, nodes: tuple[int, int] = MANY) -> Rounds:
    pool = Pool(problem.flat, problem.possible, Feasibility(problem.flat), k)
    return Rounds(problem.core, problem.purses, preorder(problem.flat), pool, control or Control(), nodes)


def mission(leaves: int, robots: int, seed: int) -> Boiled:
    """An instance of the family that allocation is measured on."""
    flat = flat_of_columns(columns_of(parse(text_of(instance("mission", leaves, robots, seed)), "tree.json")))
    possible = tuple(possible_nodes(flat).possible)
    purses = purses_of(flat, possible)
    return Boiled(flat, possible, core_of(flat, possible, purses), purses)


@settings(max_examples=150)
@given(cases())
def test_the_pool_ends_up_with_all_ways_that_are_as_good_as_the_kth(case: Case) -> None:
    problem = boiled(case.tree, case.fleet, case.weights)
    if problem is None or not problem.purses.names:
        return
    referee = Feasibility(problem.flat)
    pool = Pool(problem.flat, problem.possible, referee, 10**6)
    for _, places in ways_within(problem):
        pool.offer(places)
    truth = [(entry.utility, entry.selection.choices) for entry in pool.listed()]
    rounds = rounds_of(problem, case.k)
    assert rounds.run()
    found = [(entry.utility, entry.selection.choices) for entry in rounds.pool.listed()]
    assert found[: case.k] == truth[: case.k]
    assert rounds.bound == (truth[case.k - 1][0] if len(truth) >= case.k else None)


def test_least_utility_by_hand() -> None:
    problem = boiled(*tied_mission(4, {"a": 1}))
    assert problem is not None
    assert least_utility(problem.core) == 3_600_000


def test_compiled_and_plain_take_the_same_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """Same nodes, same prices, same ways in the same order: the engines differ in nothing but speed."""
    problems = [mission(60, 4, seed) for seed in range(6)]
    tied = boiled(*tied_mission(20, {"a": 6, "b": 8}))
    assert tied is not None
    monkeypatch.setattr(module, "SLICES", {True: 10, False: 10})
    told = {}
    for engine in (PLAIN, fast_engine()):
        monkeypatch.setattr(module.Rounds, "_engine", lambda self, parts, engine=engine: engine)
        monkeypatch.setattr(module, "can_compile", lambda engine=engine: engine.fast)
        steps = []
        for problem in (*problems, tied):
            rounds = rounds_of(problem, 5)
            proven = rounds.run()
            listed = [(entry.utility, entry.selection.choices) for entry in rounds.pool.listed()]
            steps.append((proven, rounds.nodes, rounds.prices, rounds.bound, listed))
        told[engine.fast] = steps
    assert told[False] == told[True]
    assert all(proven for proven, *_ in told[True])
    assert sum(nodes for _, nodes, *_ in told[True]) > 500


@pytest.mark.parametrize("engine", [PLAIN, fast_engine()], ids=["plain", "compiled"])
def test_several_searchers_find_what_one_finds(monkeypatch: pytest.MonkeyPatch, engine: Engine) -> None:
    monkeypatch.setattr(module.Rounds, "_engine", lambda self, parts: engine)
    monkeypatch.setattr(module, "can_compile", lambda: engine.fast)
    monkeypatch.setattr(module, "SLICES", {True: 5, False: 5})
    monkeypatch.setattr(crew, "SHARED_FROM", 10)
    busy = 0
    share = crew.Crew._share

    def watched(self: crew.Crew, target: int) -> None:
        nonlocal busy
        share(self, target)
        busy = max(busy, len(self._busy))

    monkeypatch.setattr(crew.Crew, "_share", watched)
    for seed in range(4):
        told = []
        for hands in (1, 3):
            rounds = rounds_of(mission(90, 4, seed), 5)
            rounds.hands = hands
            assert rounds.run()
            told.append([(entry.utility, entry.selection.choices) for entry in rounds.pool.listed()][:5])
        assert told[0] == told[1]
    assert busy == (3 if engine.fast else 1)  # in plain Python they would only take turns


def test_a_stopped_crew_bounds_what_it_did_not_reach(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "SLICES", {True: 5, False: 5})
    monkeypatch.setattr(crew, "SHARED_FROM", 10)
    problem = mission(120, 4, 1)
    done = rounds_of(problem, 1)
    assert done.run()
    best = done.pool.listed()[0].utility
    ends = 0
    for nodes in range(20, 120, 20):
        stopped = rounds_of(problem, 3, nodes=(nodes, nodes))
        stopped.hands = 3
        monkeypatch.setattr(stopped, "_engine", lambda parts: fast_engine())
        if stopped.run():
            continue
        ends += 1
        assert stopped.bound is not None
        assert stopped.bound >= best or any(entry.utility == best for entry in stopped.pool.listed())
    assert ends >= 3


def test_a_search_of_some_length_goes_on_at_the_fast_speed(monkeypatch: pytest.MonkeyPatch) -> None:
    problem, used = mission(120, 4, 1), list[Engine]()
    search = module.Rounds._search

    def watched(self: Rounds, core: object, engine: Engine, wanted: int, to_the_end: bool) -> object:
        used.append(engine)
        return search(self, core, engine, wanted, to_the_end)  # type: ignore[arg-type]

    monkeypatch.setattr(module.Rounds, "_search", watched)
    monkeypatch.setattr(module, "is_warm", lambda: False)
    monkeypatch.setattr(module, "TRIED_PLAIN", 20)
    assert rounds_of(problem, 5).run()
    assert [engine.fast for engine in used].count(True) >= 1
    assert used[0] is PLAIN


@pytest.mark.parametrize("nodes", [0, 7, 40])
def test_stopped_rounds_know_a_bound(nodes: int) -> None:
    problem = mission(120, 4, 1)
    done = rounds_of(problem, 3)
    assert done.run()
    best = done.pool.listed()[0].utility
    stopped = rounds_of(problem, 3, nodes=(nodes, nodes))
    assert not stopped.run()
    assert stopped.bound is not None
    assert stopped.bound >= best or any(entry.utility == best for entry in stopped.pool.listed())


def test_a_clock_that_has_run_out_stops_them() -> None:
    rounds = rounds_of(mission(120, 4, 1), 3, Control(time_limit_s=0))
    assert not rounds.run()
    assert rounds.bound is not None


def test_once_time_is_up_exchanges_alone_are_tried_only_if_nothing_else_finds_a_way(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The advice of the prices, repaired, costs less; but a way is found in either case."""
    stopped, asked = Control(stop=lambda: True), list[str]()
    alone = Rounds._mended_at_first

    def watched(self: Rounds) -> object:
        asked.append("exchanges")
        return alone(self)

    monkeypatch.setattr(Rounds, "_mended_at_first", watched)
    repaired = rounds_of(mission(120, 4, 1), 3, stopped)
    assert repaired.start()
    assert asked == []
    monkeypatch.setattr("missiontree.allocation.rounds.start", lambda *given: [])
    mended = rounds_of(mission(120, 4, 1), 3, stopped)
    assert len(mended.start()) == 1
    assert (asked, mended.pool.highest is not None) == (["exchanges"], True)


def test_one_way_is_found_before_the_compiled_functions_are_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """Somebody stops while they are loaded: that way is kept, with a bound; the next step would not have begun."""
    said, waited = list[bool](), list[bool]()

    def loading(ended: object) -> None:
        waited.append(True)
        said.append(True)

    for name, value in {"can_compile": lambda: True, "is_warm": lambda: False, "engine_unless": loading}.items():
        monkeypatch.setattr(module, name, value)
    problem = mission(120, 4, 1)
    least, most = 1, len(problem.core)
    assert not module.takes_long_to_begin(problem.core)
    monkeypatch.setattr(module, "LARGE", least)
    assert module.takes_long_to_begin(problem.core)
    monkeypatch.setattr(module, "GIANT", most)
    assert not module.takes_long_to_begin(problem.core)
    monkeypatch.setattr(module, "GIANT", most + 1)
    ranking = ExactKBest()(problem.flat, trivial_fleet(), Weights(), 1, Control(stop=lambda: bool(said)))
    assert waited == [True]
    assert (ranking.status, ranking.certificate.claim, len(ranking.alternatives)) == ("partial", "bounded", 1)
    done = rounds_of(problem, 1)
    assert done.run()
    best = done.pool.listed()[0].utility / 1_000_000
    assert ranking.certificate.bound is not None
    assert ranking.alternatives[0].utility <= best <= ranking.certificate.bound


def test_ways_beyond_number_are_settled_by_the_order_of_choices() -> None:
    """30 choose 3 ways are best; the first three in order give a to the tasks 0, 1 and 2, 3 or 4."""
    problem = boiled(*tied_mission(30, {"a": 3}))
    assert problem is not None
    rounds = rounds_of(problem, 3)
    assert rounds.run()
    firsts = [
        [place for place, (xor, child) in enumerate(entry.selection.choices) if child == xor + 1]
        for entry in rounds.pool.listed()
    ]
    assert firsts[:3] == [[0, 1, 2], [0, 1, 3], [0, 1, 4]]
