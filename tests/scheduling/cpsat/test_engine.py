"""The scheduler against numbers derived by hand, and what it says of them."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from math import cos, radians, sin
from pathlib import Path

import pytest

from benchmarks.campaign import luck
from benchmarks.schedule_cases import random_schedule_case
from missiontree.mission.control import Control, Progress
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.shared_resource import SharedResource
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.cpsat import improving
from missiontree.scheduling.cpsat.engine import schedule_within
from missiontree.scheduling.cpsat.formulation import Formulation
from missiontree.scheduling.cpsat.search import search
from missiontree.scheduling.cpsat.settings import Settings
from missiontree.scheduling.cpsat.unsupported import UnsupportedError
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.replay import replay
from missiontree.scheduling.runs import Runs
from tests.scheduling.instances import Instance, Part, at, mission, move, robot_of, robots, scene, times, work
from tests.scheduling.validator import faults

SOLVER_ONLY = Settings(longest_s=60, first_steps=0, last_steps=0)


def scheduled(instance: Instance, *types: RobotType, world: Scene | None = None, name: str = "cpsat") -> Schedule:
    """The schedule that a scheduler makes."""
    result = SCHEDULERS[name](instance.tree, instance.alternative, Fleet(types), world or Scene(), Control())
    assert (
        result.status not in {"optimal", "feasible"} or faults(instance, Fleet(types), world or Scene(), result) == []
    )
    return result


def solved(
    instance: Instance, *types: RobotType, world: Scene | None = None, control: Control | None = None
) -> Schedule:
    """The schedule of the solver, with nothing tried out before or after."""
    fleet, there = Fleet(types), world or Scene()
    made = (instance.tree, instance.alternative, fleet, there, control or Control())
    return schedule_within(*made, NO_TERMS, SOLVER_ONLY)


def five_stops() -> tuple[Instance, RobotType, Scene]:
    """
    A second of work at each of 2, 5, 9 and -3, -8; two robots at 0, 1 m/s.

    One goes right, 9 m and 3 s; one goes left, 8 m and 2 s. At 9 nobody is done before 10 s, and whoever does 9 cannot do less
    than what the other, who must be at -8 for a second, cannot reach: 2 and 5 on the way cost 2 s. So 12 s is least.
    """
    made = mission([Part(f"p{n}", "r", [work(1, at=f"x{n}")]) for n in range(5)])
    return made, robots("r", 2, speed=1, position=at(0)), scene(x0=5, x1=-3, x2=9, x3=-8, x4=2)


def drained() -> tuple[Instance, RobotType, Scene]:
    """See :func:`tests.scheduling.test_greedy.test_no_robot_takes_both_roles_if_travel_drains_it`: 41 s, as far must do q."""
    kind = robots(
        "r",
        speed=1,
        uses_per_m={"energy_j": 1},
        robots=(
            Robot(id="near", position=at(0), remaining={"energy_j": 25}),
            Robot(id="far", position=at(-50), remaining={"energy_j": 100}),
        ),
    )
    made = mission([Part("p", "r", [work(1, at="p")]), Part("q", "r", [work(1, at="q")])])
    return made, kind, scene(p=10, q=-10)


def test_tours_are_as_short_as_they_can_be_and_a_second_formulation_says_so() -> None:
    made, kind, world = five_stops()
    result = solved(made, kind, world=world)
    assert (result.makespan_s, result.status) == (12, "optimal")
    assert (result.certificate.claim, result.certificate.method) == ("proven", "second_formulation")
    assert sum(leg.distance_m for leg in result.legs) == 17  # 9 + 8, and no metre more


def test_the_same_is_proven_by_trying_everything() -> None:
    made, kind, world = five_stops()
    result = scheduled(made, kind, world=world)
    assert (result.makespan_s, result.status, result.certificate.method) == (12, "optimal", "enumeration")
    assert sum(leg.distance_m for leg in result.legs) == 17


def test_how_long_a_tour_is_at_least_is_known_before_much_is_searched() -> None:
    """
    Sixteen places on a circle of 20 m, in eight pairs 2 degrees apart: the shortest way past all of them and back goes round.

    Eight chords of 2 and eight of 43 degrees, 2 r sin(a / 2) each: 8 * (0.699 + 14.661) s at 1 m/s, every way rounded up to a millisecond,
    and a second at each place. What is nearest to each place is 0.7 m away: as single ways that tells of 11 m.
    """
    made = mission([Part(f"p{n}", "r", [work(1, at=f"x{n}")]) for n in range(16)])
    angles = [radians(45 * (n // 2) + 2 * (n % 2)) for n in range(16)]
    spots = [Position(20 * cos(angle), 20 * sin(angle)) for angle in angles]
    world = Scene(entities=tuple(Entity(id=f"x{n}", kind="place", position=spot) for n, spot in enumerate(spots)))
    kind = robots("r", speed=1, position=spots[0])
    given = (made.tree, made.alternative, Fleet((kind,)), world, Control(), Terms(return_home=True))
    result = schedule_within(*given, SOLVER_ONLY)
    assert (result.status, result.certificate.method) == ("optimal", "second_formulation")
    assert result.makespan_s == pytest.approx(8 * (0.699 + 14.661) + 16, abs=0.01)


def test_what_the_model_cannot_say_is_tried_out_longer(monkeypatch: pytest.MonkeyPatch) -> None:
    """With nothing tried before the solver would be asked, and a model that says no: trying everything still comes to 12 s."""

    def unsaid(*_: object) -> Formulation:
        raise UnsupportedError("robots sing")

    monkeypatch.setattr(improving, "Formulation", unsaid)
    made, kind, world = five_stops()
    given = (made.tree, made.alternative, Fleet((kind,)), world, Control(), NO_TERMS)
    result = schedule_within(*given, Settings(longest_s=60, first_steps=0, regrouping=0))
    assert (result.makespan_s, result.certificate.method) == (12, "enumeration")
    assert "Constraint programming was not asked: robots sing" in result.certificate.detail


def test_what_the_solver_finds_and_nobody_can_play_through_is_tried_out() -> None:
    """
    A random mission of four roles of which two last until something ends, one of them beside moves at the same moment: the solver knows the
    least length, 20.334 s, but not in which order those moments come, and the greedy runs lock each other out.
    """
    case = random_schedule_case(luck(47, 69_218))
    result = SCHEDULERS["cpsat"](case.tree, case.alternative, case.fleet, case.scene, Control(), case.terms)
    assert (result.status, result.makespan_s) == ("feasible", 20.334)


def test_what_nothing_confirms_is_the_solver_s_word() -> None:
    """The second formulation knows nothing of energy along tours, so that it cannot agree."""
    made, kind, world = drained()
    result = solved(made, kind, world=world)
    assert (result.makespan_s, result.status) == (41, "feasible")
    assert (result.certificate.claim, result.certificate.method, result.certificate.bound) == (
        "solver_word",
        "cp_sat",
        41,
    )
    assert "nothing confirms" in result.certificate.detail


def test_energy_along_a_tour_is_kept() -> None:
    made, kind, world = drained()
    result = scheduled(made, kind, world=world)
    assert robot_of(made, result) == {"p": "near", "q": "far"}
    assert (result.makespan_s, result.status, result.certificate.method) == (41, "optimal", "enumeration")


def test_heads_are_counted_where_robots_are_equal() -> None:
    """
    3, 3, 2, 2, 2 s for two robots in parallel: 12 s of work, 6 s each, as 3 + 3 and 2 + 2 + 2.

    Longest first gives 3 + 2 + 2 and 3 + 2; the bound of 6 s is met all the same.
    """
    made = mission([Part(f"p{n}", "r", [work(d)]) for n, d in enumerate([3, 3, 2, 2, 2])])
    result = solved(made, robots("r", 2))
    assert (result.makespan_s, result.status) == (6, "optimal")


def test_a_robot_held_in_a_role_does_nothing_else() -> None:
    """a waits inside its role for b till 8 and ends at 9; c, of a's robot, takes 2 s before it: none can be shorter than 9 s."""
    made = mission(
        [Part("a", "r", [work(1), work(1)]), Part("b", "s", [work(8)]), Part("c", "r", [work(2)])], [("b", "a.1")]
    )
    result = scheduled(made, robots("r"), robots("s"))
    assert result.makespan_s == 9
    assert times(made, result)["c.0"][1] <= times(made, result)["a.0"][0]


def test_joint_work_waits_for_the_last_and_things_are_where_they_were_taken() -> None:
    """
    fast and slow lift the box at 4 together from 4 s (slow's way) for 1 s and bring it to 10 by 11 s; then c, at 0, goes 10 m for it.

    c is there at 10, so that it starts when the box is there, at 11, and ends at 12.
    """
    steps = [work(1, at="box", sync=0), move("goal", "box", sync=1)]
    made = mission(
        [Part("a", "fast", steps, team=0), Part("b", "slow", steps, team=0), Part("c", "s", [work(1, at="box")])],
        [("a", "c")],
    )
    result = scheduled(
        made,
        robots("fast", speed=2, position=at(0)),
        robots("slow", speed=1, position=at(0)),
        robots("s", speed=1, position=at(0)),
        world=scene(box=4, goal=10),
    )
    assert times(made, result)["a.1"] == (5, 11)
    assert times(made, result)["c.0"] == (11, 12)


def test_of_two_orders_of_moving_a_thing_the_shorter_is_taken() -> None:
    """
    r brings the box from 0 to 6 (1 m/s); s works a second at the box and stands at 0, 1 m/s. No link says who comes first.

    If s works first (0-1), r starts at 1 and is there at 7. If r moves first (0-6), s works at 6 from 6 to 7. Both come to 7 s, but
    working first costs s no way.
    """
    made = mission([Part("a", "r", [move("goal", "box")]), Part("b", "s", [work(1, at="box")])])
    result = scheduled(
        made, robots("r", speed=1, position=at(0)), robots("s", speed=1, position=at(0)), world=scene(box=0, goal=6)
    )
    assert result.makespan_s == 7
    assert times(made, result)["b.0"] == (0, 1)


def test_that_nothing_works_is_proven_by_trying_everything() -> None:
    """Two roles that must be filled by different robots, each with its own half of what only one robot has enough energy for."""
    pair = (Robot(id="big", remaining={"e": 10}), Robot(id="small", remaining={"e": 1}))
    parts = [Part("p", "r", [work(1, uses={"e": 4})]), Part("q", "r", [work(1, uses={"e": 4})])]
    made = mission(parts, [("p", "q", "different_robot")])
    result = scheduled(made, robots("r", robots=pair))
    assert (result.status, result.certificate.claim, result.certificate.method) == (
        "infeasible",
        "proven",
        "enumeration",
    )
    assert result.reasons[0].rule == "no_schedule"


def test_no_model_is_built_once_somebody_says_stop(monkeypatch: pytest.MonkeyPatch) -> None:
    """For a large mission it takes a while, and nobody waits for what it might say."""
    monkeypatch.setattr(improving, "Formulation", lambda *parts: pytest.fail("a model was built"))
    made, kind, world = drained()
    assert solved(made, kind, world=world, control=Control(stop=lambda: True)).status == "feasible"


def test_nothing_is_solved_where_time_is_up_or_somebody_says_stop() -> None:
    """The greedy schedule is what is left, with its bound."""
    made, kind, world = drained()
    for control in (Control(time_limit_s=0), Control(stop=lambda: True)):
        result = solved(made, kind, world=world, control=control)
        assert (result.status, result.makespan_s) == ("feasible", 41)
        assert result.certificate.method in {"critical_path", "load"}


def test_progress_tells_best_and_bound() -> None:
    made, kind, world = drained()
    heard: list[Progress] = []
    solved(made, kind, world=world, control=Control(report=heard.append))
    told = [news for news in heard if news.best is not None]
    assert told
    assert all(news.bound is not None and news.bound <= news.best for news in told if news.best is not None)


def test_the_best_is_told_of_even_if_the_solver_says_it_only_at_its_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """Which of its last answers the solver tells of before its end is a matter of luck; what is made of them is not."""
    monkeypatch.setattr(
        improving, "search", lambda model, limit, ended, effort, heard, clock: search(model, limit, ended, effort)
    )
    monkeypatch.setattr(Runs, "go", lambda *rest, **more: None)
    made, kind, world = five_stops()
    heard: list[Progress] = []
    result = solved(made, kind, world=world, control=Control(report=heard.append))
    told = [news.best for news in heard if news.best is not None]
    assert told[-1] == result.makespan_s == 12
    assert told == sorted(told, reverse=True)


@pytest.mark.parametrize("name", ["cpsat", "auto"])
def test_the_solver_is_not_loaded_where_a_bound_closes_the_case(name: str) -> None:
    """In a process of its own: 4 and 2 s of work for one robot are 6 s, which is the load bound."""
    program = (
        "import sys\n"
        "from tests.scheduling.instances import Part, mission, robots, work\n"
        "from missiontree.mission.control import Control\n"
        "from missiontree.mission.fleet import Fleet\n"
        "from missiontree.mission.scene import Scene\n"
        "from missiontree.scheduling import SCHEDULERS\n"
        "made = mission([Part('a', 'r', [work(4)]), Part('b', 'r', [work(2)])])\n"
        f"result = SCHEDULERS[{name!r}](made.tree, made.alternative, Fleet((robots('r'),)), Scene(), Control())\n"
        "print(result.status, result.makespan_s, 'ortools' in sys.modules)"
    )
    root = Path(__file__).parents[3]
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=root)
    assert done.stdout.split() == ["optimal", "6.0", "False"]


def test_auto_gives_the_same_every_time() -> None:
    made, kind, world = five_stops()
    assert scheduled(made, kind, world=world, name="auto") == scheduled(made, kind, world=world, name="auto")


@pytest.mark.parametrize("holders", [("give",), ("take",), ("give", "take")])
def test_what_comes_between_the_two_sides_of_a_hand_over_costs_no_schedule(holders: tuple[str, ...]) -> None:
    """
    Giving takes 4 s and taking 2 s; a moment at the door, from 2 s to 5 s, comes before or after what holds the door or has its robot.

    At 4 s, when the one ends and the other starts, times do not speak against it, though it comes after the one and before the other by
    order, and these are one moment. If it is not done then, so that 6 s do, it is done at 2 s, before the giving, and 8 s are found.
    """
    held = {name: ["door"] if name in holders else [] for name in ("give", "take")}
    parts = [
        Part("give", "b", [work(4, at="p", holds=held["give"])]),
        Part("take", "a", [work(2, at="p", holds=held["take"])]),
        Part("pass", "a" if holders == ("give",) else "b", [work(0, holds=["door"])]),
    ]
    links = [("give", "take", "hand_over")]
    if len(holders) < 2:
        links.append(("pass", "take" if holders == ("give",) else "give", "same_robot"))
    made = mission(parts, links).timed(**{"pass": (2, 5)})
    world = replace(scene(p=0), resources=(SharedResource(id="door"),))
    types = (robots("a", 2, speed=1, position=at(0)), robots("b", 2, speed=1, position=at(0)))
    result = solved(made, *types, world=world)
    assert result.makespan_s <= 8
    assert result.certificate.bound is not None
    assert result.certificate.bound <= 6


@pytest.mark.parametrize(("rooms", "verdict"), [(2, "infeasible"), (3, "optimal")])
def test_what_takes_no_time_needs_room_beside_those_who_hold_a_lift_before_and_after(rooms: int, verdict: str) -> None:
    """Two hold the lift from 0 to 3 s and to 5 s at the latest, and cannot otherwise; between 1 s and 2 s a third needs it in no time."""
    parts = [
        Part(name, "r", [work(lasts, holds=("lift",))]) for name, lasts in (("long", 5), ("short", 3), ("brief", 0))
    ]
    made = mission(parts).timed(long=(0, 5), short=(0, 3), brief=(1, 2))
    world = Scene(resources=(SharedResource(id="lift", capacity=rooms),))
    problem = read_problem(made.tree, made.alternative, Fleet((robots("r", 3),)), world, NO_TERMS)
    assert isinstance(problem, Problem)
    assert search(Formulation(problem, 20_000).model, 60, lambda: False).verdict == verdict


def least_by_times_and_by_orders(problem: Problem) -> tuple[int | None, int]:
    """The least makespan of the model, whose answer nobody can carry out; and, keeping to orders, of one that somebody can."""
    formulation = Formulation(problem, 20_000)
    loose = search(formulation.model, 60, lambda: False)
    assert replay(problem, formulation.course(loose.values)) is None
    assert formulation.keep_to_orders()
    found = search(formulation.model, 60, lambda: False)
    draft = replay(problem, formulation.course(found.values))
    assert draft is not None
    assert found.objective == draft.makespan
    return loose.objective, draft.makespan


@pytest.mark.parametrize(
    ("place", "far"), [("p", Robot(id="far", position=at(10))), (None, Robot(id="far", available_from_s=10.0))]
)
def test_who_waits_for_something_does_not_go_on_to_do_it(place: str | None, far: Robot) -> None:
    """
    Near is at p and far 10 s away; or there is no p, and far comes 10 s later. A watch of 3 s comes before a glance, which takes no time,
    and goes on until it.

    By times alone near could watch and then glance, at the moment at which watching ends, a millisecond after it has begun; which is no
    order of events. Else far glances, at 10 s, or near does and far watches, from 10 s to 13 s.
    """
    parts = [
        Part("watch", "r", [work(3, at=place), work(at=place, open_ended=True)]),
        Part("glance", "r", [work(0, at=place)]),
    ]
    made = mission(parts, [("watch.1", "glance", "until"), ("watch.0", "glance")])
    fleet = Fleet((robots("r", speed=1, robots=(Robot(id="near", position=at(0)), far)),))
    problem = read_problem(made.tree, made.alternative, fleet, scene(p=0), NO_TERMS)
    assert isinstance(problem, Problem)
    assert least_by_times_and_by_orders(problem) == (3001, 10_000)


def test_what_is_held_until_something_ends_is_not_passed_on_to_what_comes_before_that() -> None:
    """
    Somebody works 3 s, takes the lift, which takes no time, and then glances; a watch holds the lift until the glance.

    By times alone the lift could be free for the ride at 3 s, when watch and glance are over; but the glance comes after the ride. So
    the ride comes before the watch, at 3 s, and the glance a millisecond after the watch has begun.
    """
    ride = [work(3), work(0, holds=["lift"]), work(0)]
    parts = [Part("watch", "r", [work(open_ended=True, holds=["lift"])]), Part("go", "s", ride)]
    made = mission(parts, [("watch.0", "go.2", "until")])
    world = replace(scene(), resources=(SharedResource(id="lift"),))
    problem = read_problem(made.tree, made.alternative, Fleet((robots("r"), robots("s"))), world, NO_TERMS)
    assert isinstance(problem, Problem)
    assert least_by_times_and_by_orders(problem) == (3000, 3001)
