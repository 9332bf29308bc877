"""A suite as it is run: each setting with its fleet, scene and routines, read from a folder."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from missiontree.errors import InputError
from missiontree.evaluation.misfit import misfit
from missiontree.evaluation.suite_file import SuiteFile, SuiteMission
from missiontree.formats.blame import culprit
from missiontree.formats.digest import digest
from missiontree.formats.document import read_as, read_file
from missiontree.formats.reader import parse
from missiontree.formats.source import load_text
from missiontree.mission.brief import MissionBrief
from missiontree.mission.fleet import Fleet
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.value import Id, Value, require_unique
from missiontree.routines.library import load
from missiontree.samples.catalogue import FOLDER

MISSIONS = "missions.yaml"


@dataclass(frozen=True, kw_only=True)
class Setting(Value):
    """
    Missions of one setting, and the world they are said in.

    Parameters
    ----------
    id
        Name.
    fleet
        The team.
    routines
        Routines on offer, the built-in ones included.
    scene
        The world; None if the missions are planned without one.
    fleets, scenes
        Teams and worlds of single missions, by the path that the mission names.
    missions
        The missions.
    """

    id: Id
    fleet: Fleet
    routines: RoutineLibrary
    scene: Scene | None = None
    fleets: Mapping[str, Fleet] = field(default_factory=dict)
    scenes: Mapping[str, Scene] = field(default_factory=dict)
    missions: tuple[SuiteMission, ...]

    def _check(self) -> None:
        require_unique("mission", tuple(mission.id for mission in self.missions))
        for mission in self.missions:
            for path, known in ((mission.fleet, self.fleets), (mission.scene, self.scenes)):
                if path is not None and path not in known:
                    raise ValueError(f"mission {mission.id!r} names {path!r}, which is not given.")
            fleet, scene = self.world_of(mission)
            if found := misfit(mission, fleet, self.routines, scene):
                raise ValueError(found)

    def world_of(self, mission: SuiteMission) -> tuple[Fleet, Scene | None]:
        """The team and the scene of a mission: its own, else the setting's."""
        fleet = self.fleet if mission.fleet is None else self.fleets[mission.fleet]
        return fleet, self.scene if mission.scene is None else self.scenes[mission.scene]

    def brief(self, mission: SuiteMission) -> MissionBrief:
        """What an author is given for a mission."""
        fleet, scene = self.world_of(mission)
        return MissionBrief(text=mission.say, fleet=fleet, routines=self.routines, scene=scene)

    def digest(self, mission: SuiteMission, whole: bool = False) -> str:
        """
        SHA-256 of all that a verdict on the mission depends on: words, expectations, fleet, scene, routines; not its note.

        Parameters
        ----------
        mission
            The mission.
        whole
            Whether trees are planned to their end before they are judged.
        """
        fleet, scene = self.world_of(mission)
        given = {"mission": replace(mission, note=""), "fleet": fleet, "scene": scene, "routines": self.routines}
        return digest({**given, "whole": whole})


@dataclass(frozen=True, kw_only=True)
class Suite(Value):
    """
    Missions to measure authors by.

    Parameters
    ----------
    settings
        At least one; no mission id stands twice.
    """

    settings: tuple[Setting, ...]

    def _check(self) -> None:
        if not self.settings:
            raise ValueError("a suite needs at least one setting.")
        require_unique("setting", tuple(setting.id for setting in self.settings))
        require_unique("mission", tuple(mission.id for _, mission in self.missions()))
        for _, mission in self.missions():
            if found := self.misses_twin(mission):
                raise ValueError(found)

    def misses_twin(self, mission: SuiteMission) -> str:
        """Why the twin that a mission names is none, in words; empty if it names none, or a right one."""
        if mission.twin is None:
            return ""
        twin = next((other for _, other in self.missions() if other.id == mission.twin), None)
        if twin is None:
            return f"mission {mission.id!r} has no twin {mission.twin!r}; the suite has no such mission."
        return f"mission {mission.id!r} has the twin {twin.id!r}; that is to be declined, too." if twin.declined else ""

    def missions(self) -> Iterator[tuple[Setting, SuiteMission]]:
        """Every mission with its setting, in order."""
        return ((setting, mission) for setting in self.settings for mission in setting.missions)

    @property
    def ids(self) -> dict[str, tuple[str, ...]]:
        """Mission ids by setting."""
        return {setting.id: tuple(mission.id for mission in setting.missions) for setting in self.settings}


def read_suite_file(text: str, source: str) -> SuiteFile:
    """
    The missions of a text in YAML or JSON.

    Raises
    ------
    InputError
        With the line of what is wrong.
    """
    return read_as(text, "suite", SuiteFile, source)


def load_suite(folder: Path) -> Suite:
    """
    The suite of a folder: every folder below it that has a ``missions.yaml`` is a setting, in the order of their names.

    Raises
    ------
    InputError
        If there is none, or a file cannot be read or contradicts another; with file and line.
    """
    if not folder.is_dir():
        raise InputError("there is no such folder", file=str(folder), accepted=f"a folder with a {MISSIONS} below it")
    files = sorted(folder.rglob(MISSIONS))
    if not files:
        raise InputError("there is no setting in this folder", file=str(folder), accepted=f"folders with a {MISSIONS}")
    settings: list[Setting] = []
    origin: dict[str, str] = {}
    places: list[tuple[Path, int]] = []
    for path in files:
        setting = _setting(path)
        for name in (f"setting {setting.id!r}", *(f"mission {mission.id!r}" for mission in setting.missions)):
            if name in origin:
                raise _refusal(f"{name} stands twice", path, hint=f"{origin[name]} has it too.")
            origin[name] = str(path)
        settings.append(setting)
        places += [(path, index) for index in range(len(setting.missions))]
    return _suite(settings, places)


def _suite(settings: Sequence[Setting], places: Sequence[tuple[Path, int]]) -> Suite:
    """The settings as a suite; a twin that is none is refused at the file and place of its mission."""
    try:
        return Suite(settings=tuple(settings))
    except ValueError as error:
        missions = [mission.id for setting in settings for mission in setting.missions]
        place = next(place for place, name in zip(places, missions, strict=True) if f"mission {name!r}" in str(error))
        raise _refusal(str(error), *place) from error


def _setting(path: Path) -> Setting:
    file = read_suite_file(load_text(path), str(path))
    fleet: Fleet = read_file(path.parent / file.fleet if file.fleet else FOLDER / "fleet.yaml", "fleet")
    scene: Scene | None = read_file(path.parent / file.scene, "scene") if file.scene else None
    routines = load([path.parent / name for name in file.routines])
    fleets = _own(path, [mission.fleet for mission in file.missions], "fleet")
    scenes = _own(path, [mission.scene for mission in file.missions], "scene")
    for index, mission in enumerate(file.missions):
        own_fleet = fleet if mission.fleet is None else fleets[mission.fleet]
        own_scene = scene if mission.scene is None else scenes[mission.scene]
        if found := misfit(mission, own_fleet, routines, own_scene):
            raise _refusal(found, path, index)
    setting = Setting(
        id=file.setting,
        fleet=fleet,
        routines=routines,
        scene=scene,
        fleets=fleets,
        scenes=scenes,
        missions=file.missions,
    )
    worlds = {(mission.fleet, mission.scene): mission for mission in file.missions}
    for mission in worlds.values():
        try:
            setting.brief(mission)
        except ValueError as error:
            hint = f"Fleet, scene and routines of {mission.id} do not fit together."
            raise InputError(str(error), file=str(path), hint=hint) from error
    return setting


def _own(path: Path, names: Sequence[str | None], kind: str) -> dict[str, Any]:
    """Fleets or scenes of single missions, by the path that is written."""
    return {name: read_file(path.parent / name, kind) for name in dict.fromkeys(names) if name is not None}


def _refusal(message: str, file: Path, index: int | None = None, hint: str = "") -> InputError:
    """The error at the line that the message speaks of."""
    parsed = parse(load_text(file), str(file))
    data, path = (parsed.data, ()) if index is None else (parsed.data["missions"][index], ("missions", index))
    return parsed.refusal(message.rstrip("."), culprit(message, data, path), hint=hint)
