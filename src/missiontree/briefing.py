"""What the operator hands in, words and files, becomes one request that planning can start from."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, get_args

from missiontree.authoring.budgets import Budgets
from missiontree.errors import InputError
from missiontree.estimation.estimator import Estimator
from missiontree.estimation.own import OwnEstimator, own_estimator
from missiontree.formats.document import read_file
from missiontree.formats.misfit import misfit
from missiontree.formats.mission_file import MissionFile
from missiontree.formats.parsed import Parsed
from missiontree.formats.plain import to_plain
from missiontree.formats.reach import refuse_far
from missiontree.formats.source import clean
from missiontree.llm.chat import ChatModel
from missiontree.mission.aim import Accumulate
from missiontree.mission.brief import MissionBrief
from missiontree.mission.costs import DEFAULT_COSTS, Costs
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.goal import in_words
from missiontree.mission.magnitude import refuse_huge
from missiontree.mission.objective import OBJECTIVES, Objective
from missiontree.mission.reach import refuse_endless
from missiontree.mission.routine import Routine
from missiontree.mission.scene import Scene
from missiontree.mission.terms import MinQuality
from missiontree.mission.tree import MissionTree
from missiontree.routines.library import load, with_routines
from missiontree.samples.catalogue import FOLDER

MAX_WORDS = 5_000
MISSION_FILES = (".yaml", ".yml", ".json")
ARGUMENTS: dict[str, tuple[tuple[type, ...], str]] = {
    "mission": ((str, Path), "the mission in words, or the path of a mission file"),
    "fleet": ((Fleet, str, Path), "a Fleet, or the path of a fleet file"),
    "scene": ((Scene, str, Path), "a Scene, or the path of a scene file"),
    "routines": ((list, tuple), "a list of routines, or of files of routines"),
    "methods": ((list, tuple), "a list of files of methods"),
    "k": ((int,), "a whole number of at least 1"),
    "allocator": ((str,), "the name of an allocator"),
    "scheduler": ((str,), "the name of a scheduler"),
    "front": ((bool,), "true or false"),
    "model": ((str, Callable), "offline, recorded:<file>, PROVIDER:NAME, or a chat model"),  # type: ignore[dict-item]
    "base_url": ((str,), "the address of an endpoint, such as http://localhost:8000/v1"),
    "budgets": ((Budgets,), "Budgets"),
    "seed": ((int,), "a whole number"),
    "without": ((list, tuple), "a list of robot types and robots, by name"),
    "require": ((list, tuple), "a list of robot types and robots, by name"),
    "min_quality": ((int, float, Mapping), "a number of at least 0, or numbers by routine or capability"),
}
DEFAULT_K = 4


@dataclass(frozen=True, slots=True, kw_only=True)
class Request:
    """
    A mission ready to be planned.

    Parameters
    ----------
    brief
        The mission and its inputs.
    tree
        A mission tree that was handed in; None if an author is to build it.
    methods
        Files of mission methods beside the built-in ones.
    k
        How many alternatives are asked for.
    allocator
        Name of the method of allocation.
    scheduler
        Name of the method of scheduling.
    front
        Whether the utility-makespan front is sought, beside the alternatives.
    model
        Name of the author, or a chat model of the caller's own.
    base_url
        Address of the endpoint that a language model is asked at; empty for the usual one. No mission file can set it.
    budgets
        How long a dialogue with a language model may go on.
    seed
        Seed of everything random.
    sources
        What was taken from where, for the screen.
    tree_file
        File of the tree that was handed in.
    estimator
        What says how well, how long and how dear every action is; None for the fleet's table. The brief says whose it is.
    costs
        What changes cost that would make the mission possible.
    """

    brief: MissionBrief
    tree: MissionTree | None = None
    methods: tuple[Path, ...] = ()
    k: int = DEFAULT_K
    allocator: str = "exact"
    scheduler: str = "greedy"
    front: bool = False
    model: str | ChatModel = "offline"
    base_url: str = ""
    budgets: Budgets = Budgets()
    seed: int = 0
    sources: tuple[str, ...] = ()
    tree_file: str = ""
    estimator: OwnEstimator | None = None
    costs: Costs = DEFAULT_COSTS


def request_from(
    mission: str | Path,
    *,
    fleet: Fleet | Path | str | None = None,
    scene: Scene | Path | str | None = None,
    routines: Sequence[Routine | Path | str] = (),
    methods: Sequence[Path | str] = (),
    weights: Weights | Sequence[float] | None = None,
    check_kinds: bool | None = None,
    without: Sequence[str] = (),
    require: Sequence[str] = (),
    min_quality: MinQuality | None = None,
    estimator: Estimator | Callable[..., Estimate] | Path | str | None = None,
    accumulate: Accumulate | None = None,
    diverse: bool | None = None,
    parts: Mapping[str, float] | None = None,
    return_home: bool | None = None,
    objective: Objective | None = None,
    project: Path | None = None,
    **options: Any,
) -> Request:
    """
    Gather a request; what is given here goes before what a mission file says.

    Parameters
    ----------
    mission
        The mission in words, or the path of a mission file; text that ends in ``.yaml``, ``.yml`` or ``.json`` is such a path.
    fleet, scene
        Values, or files. Default: the mission file's, else ``fleet.yaml`` and ``scene.yaml`` beside it, else the paper's
        sample fleet and no scene.
    routines
        Routines, or files of them, beside the built-in ones.
    methods
        Files of the user's own, beside the built-in ones.
    weights, check_kinds, accumulate, diverse, return_home, objective
        See :class:`MissionBrief`.
    without, require
        Robot types and robots that take no part, or must; added to those of the mission file.
    min_quality
        Quality that every action must have; takes the place of all that the mission file says of it.
    estimator
        A user's own estimator, or its file, which is run. Default: the mission file's, else the fleet's table.
    parts
        How much parts of the mission count; takes the place of all that the mission file says of it.
    project
        A mission file whose fleet, scene, routines and methods are taken up when the mission is given in words.
    options
        ``k``, ``allocator``, ``scheduler``, ``front``, ``model``, ``base_url``, ``budgets``, ``seed``; None stands for "not given".

    Raises
    ------
    InputError
        If an argument is not what it should be, a file cannot be read, or its contents do not fit together.
    """
    _refuse_others(mission=mission, fleet=fleet, scene=scene, routines=routines, methods=methods, **options)
    _refuse_others(mission=mission, without=without, require=require, min_quality=min_quality)
    _refuse_other_aims(accumulate, diverse, objective)
    if return_home is not None and not isinstance(return_home, bool):
        raise InputError(f"return_home is {return_home!r:.60}", accepted="true or false")
    if isinstance(mission, str) and mission.endswith(MISSION_FILES):
        mission = Path(mission)
    path = mission if isinstance(mission, Path) else project
    file = _mission_file(path) if path is not None else MissionFile(mission="-")
    goals = file.goals if isinstance(mission, Path) else ()
    words = (
        (file.mission if file.mission.strip() or not goals else in_words(goals))
        if isinstance(mission, Path)
        else clean(mission, "mission")
    )
    base = path.parent if path is not None else Path()
    if len(words.split()) > MAX_WORDS:
        raise InputError(f"the mission has {len(words.split())} words", accepted=f"at most {MAX_WORDS} words")
    library_files = [base / name for name in file.routines]
    library_files += [Path(name) for name in routines if not isinstance(name, Routine)]
    own_routines = [_value(routine, "routines") for routine in routines if isinstance(routine, Routine)]
    method_files = [base / name for name in file.methods] + [Path(name) for name in methods]
    estimator_from = base / file.estimator if estimator is None and file.estimator else estimator
    own = None if estimator_from is None else own_estimator(estimator_from)
    fleet_from, scene_from = _fleet_source(fleet, file, path), _scene_source(scene, file, path)
    team = _value(fleet_from, "fleet")
    world = None if scene_from is None else _value(scene_from, "scene")
    try:
        brief = MissionBrief(
            text=words,
            fleet=team,
            scene=world,
            routines=with_routines(load(library_files), own_routines),
            entities=file.entities,
            weights=file.weights if weights is None else _weights(weights),
            check_kinds=file.check_kinds if check_kinds is None else check_kinds,
            goals=goals,
            without=tuple(dict.fromkeys((*file.without, *without))),
            require=tuple(dict.fromkeys((*file.require, *require))),
            min_quality=file.min_quality if min_quality is None else min_quality,
            estimator=None if own is None else own.source,
            deadline_s=file.deadline_s,
            accumulate=file.accumulate if accumulate is None else accumulate,
            diverse=file.diverse if diverse is None else diverse,
            parts=parts if parts is not None else file.parts if isinstance(mission, Path) else {},
            return_home=file.return_home if return_home is None else return_home,
            objective=file.objective if objective is None else objective,
        )
        refuse_huge(brief.fleet, brief.routines, brief.weights)
        refuse_endless(brief.fleet, brief.world, brief.routines)
    except ValueError as error:
        terms = {"without": without, "require": require, "min_quality": min_quality}
        files = [Path(one) for one in (path, fleet_from, scene_from, *library_files) if isinstance(one, str | Path)]
        misfits = [source.split(" ", 1)[1] for source in _sources(path, fleet_from, scene_from, library_files, ())]
        misfits += [name for name, given in terms.items() if given not in (None, (), [])]
        hint = f"{', '.join(misfits) or 'The inputs'}: these do not fit together; mend one of them."
        raise misfit(str(error), files, _names(team, world), hint) from error
    tree = _value(base / file.tree, "tree") if file.tree else None
    sources = _sources(path, fleet_from, scene_from, library_files, method_files, estimator_from)
    tree_file = str(base / file.tree) if file.tree else ""
    if tree is not None and not words:
        brief = replace(brief, text=tree.objective)
    request = Request(
        brief=brief,
        tree=tree,
        methods=tuple(method_files),
        sources=sources,
        tree_file=tree_file,
        estimator=own,
        costs=Costs(file.costs),
    )
    named: dict[str, Any] = {
        "k": file.k,
        "allocator": file.allocator,
        "scheduler": file.scheduler,
        "model": file.model or "offline",
        "seed": file.seed,
    }
    asked = named | {name: value for name, value in options.items() if value is not None}
    if asked["scheduler"] is None:
        asked["scheduler"] = "auto" if asked.get("front") or brief.objective != "utility" else "greedy"
    return replace(request, **asked)


def _names(fleet: Fleet, scene: Scene | None) -> dict[str, tuple[str, ...]]:
    """What fleet and scene have, by what refusals call it."""
    world = scene if scene is not None else Scene()
    return {
        "robot type": tuple(fleet.by_id),
        "place": tuple(one.id for one in world.places),
        "zone": tuple(zone.id for zone in world.zones),
    }


def _refuse_others(**given: Any) -> None:
    """Refuse an argument of another type than its own, in words."""
    for name, value in given.items():
        types, accepted = ARGUMENTS[name]
        wrong = not isinstance(value, types) or (isinstance(value, bool) and bool not in types)
        if (value is not None or name == "mission") and wrong:
            raise InputError(f"{name} is {value!r:.60}", accepted=accepted)
    if given.get("k") is not None and given["k"] < 1:
        raise InputError(f"k is {given['k']}", accepted=ARGUMENTS["k"][1])


def _refuse_other_aims(accumulate: object, diverse: object, objective: object) -> None:
    if objective is not None and objective not in OBJECTIVES:
        raise InputError(f"objective is {objective!r:.60}", accepted=", ".join(OBJECTIVES))
    if accumulate is not None and accumulate not in get_args(Accumulate):
        raise InputError(f"accumulate is {accumulate!r:.60}", accepted="sum, mean or min")
    if diverse is not None and not isinstance(diverse, bool):
        raise InputError(f"diverse is {diverse!r:.60}", accepted="true or false")


def _weights(weights: Weights | Sequence[float]) -> Weights:
    if isinstance(weights, Weights):
        return weights
    try:
        return Weights(*weights)
    except (TypeError, ValueError) as error:
        raise InputError(f"weights is {weights!r:.60}: {error}", accepted="Weights, or up to three numbers") from error


def _fleet_source(fleet: Fleet | Path | str | None, file: MissionFile, path: Path | None) -> Fleet | Path | str:
    """The fleet that is handed in, else the mission file's, else the one beside it, else the paper's."""
    if fleet is not None:
        return fleet
    return _beside(file.fleet, "fleet.yaml", path) or FOLDER / "fleet.yaml"


def _scene_source(scene: Scene | Path | str | None, file: MissionFile, path: Path | None) -> Scene | Path | str | None:
    return scene if scene is not None else _beside(file.scene, "scene.yaml", path)


def _beside(named: str | None, usual: str, path: Path | None) -> Path | None:
    """A file that the mission file names, else that of the usual name in its folder; None if there is neither."""
    if path is None:
        return None
    if named:
        return path.parent / named
    return path.with_name(usual) if path.with_name(usual).exists() else None


def _mission_file(path: Path) -> MissionFile:
    file = read_file(path, "mission")
    assert isinstance(file, MissionFile)
    return file


def _value(source: Any, kind: str) -> Any:
    """A value that is handed in, or read."""
    if isinstance(source, str | Path):
        return read_file(Path(source), kind)
    refuse_far(Parsed(to_plain(source), kind, lambda _: 0))
    return source


def _sources(
    path: Path | None,
    fleet: Any,
    scene: Any,
    routines: Sequence[Path],
    methods: Sequence[Path],
    estimator: Any = None,
) -> tuple[str, ...]:
    named: list[tuple[str, Any]] = [("mission", path), ("fleet", fleet), ("scene", scene)]
    named += [("routines", file) for file in routines] + [("methods", file) for file in methods]
    named.append(("estimator", estimator))
    return tuple(f"{what} {_shown(where)}" for what, where in named if isinstance(where, str | Path))


def _shown(path: str | Path) -> str:
    return "the paper's team" if Path(path) == FOLDER / "fleet.yaml" else str(path)
