"""A suite as it is run: each setting with its fleet, scene and routines, read from a folder."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from missiontree.errors import InputError
from missiontree.evaluation.misfit import misfit
from missiontree.evaluation.suite_file import SuiteFile, SuiteMission
from missiontree.formats.blame import culprit
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
    missions
        The missions.
    """

    id: Id
    fleet: Fleet
    routines: RoutineLibrary
    scene: Scene | None = None
    missions: tuple[SuiteMission, ...]

    def _check(self) -> None:
        require_unique("mission", tuple(mission.id for mission in self.missions))
        for mission in self.missions:
            if found := misfit(mission, self.fleet, self.routines, self.scene):
                raise ValueError(found)

    def brief(self, mission: SuiteMission) -> MissionBrief:
        """What an author is given for a mission."""
        return MissionBrief(text=mission.say, fleet=self.fleet, routines=self.routines, scene=self.scene)


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
    for path in files:
        setting = _setting(path)
        for name in (f"setting {setting.id!r}", *(f"mission {mission.id!r}" for mission in setting.missions)):
            if name in origin:
                raise _refusal(f"{name} stands twice", path, hint=f"{origin[name]} has it too.")
            origin[name] = str(path)
        settings.append(setting)
    return Suite(settings=tuple(settings))


def _setting(path: Path) -> Setting:
    file = read_suite_file(load_text(path), str(path))
    fleet: Fleet = read_file(path.parent / file.fleet if file.fleet else FOLDER / "fleet.yaml", "fleet")
    scene: Scene | None = read_file(path.parent / file.scene, "scene") if file.scene else None
    routines = load([path.parent / name for name in file.routines])
    for index, mission in enumerate(file.missions):
        if found := misfit(mission, fleet, routines, scene):
            raise _refusal(found, path, index)
    try:
        setting = Setting(id=file.setting, fleet=fleet, routines=routines, scene=scene, missions=file.missions)
        setting.brief(file.missions[0])
    except ValueError as error:
        raise InputError(str(error), file=str(path), hint="Fleet, scene and routines do not fit together.") from error
    return setting


def _refusal(message: str, file: Path, index: int | None = None, hint: str = "") -> InputError:
    """The error at the line that the message speaks of."""
    parsed = parse(load_text(file), str(file))
    data, path = (parsed.data, ()) if index is None else (parsed.data["missions"][index], ("missions", index))
    return parsed.refusal(message.rstrip("."), culprit(message, data, path), hint=hint)
