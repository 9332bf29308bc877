"""
missiontree: a sentence becomes a checked, ranked, scheduled plan for a mixed team of robots.

The layout is the table of contents, and the data travels through it::

    brief ─ authoring ─► MissionTree ─ routines ─► GroundedTree ─ allocation ─► Ranking ─ scheduling ─► Schedule
          ─ checking ─► findings ─ reporting ─► something to look at

``planner.py`` is that road on one page. Names below are loaded when they are first used, so that the command line starts quickly.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any

from missiontree.mission.shown import draw_with

if TYPE_CHECKING:
    from missiontree.authoring.budgets import Budgets
    from missiontree.checking import check
    from missiontree.errors import InputError, MissiontreeError
    from missiontree.explaining.explain import explain
    from missiontree.llm.recorded import RecordedModel
    from missiontree.llm.scripted import ScriptedModel
    from missiontree.mission.control import Control
    from missiontree.mission.entity import Entity
    from missiontree.mission.estimate import Weights
    from missiontree.mission.explanation import Explanation
    from missiontree.mission.fleet import Capability, Fleet, Robot, RobotType
    from missiontree.mission.plan import Plan
    from missiontree.mission.position import Position
    from missiontree.mission.scene import Scene
    from missiontree.planner import plan
    from missiontree.reporting.text import plan_text
    from missiontree.routines.python import routine

__version__ = "0.1.0"

_HOMES = {
    "Budgets": "authoring.budgets",
    "Capability": "mission.fleet",
    "Control": "mission.control",
    "Entity": "mission.entity",
    "Explanation": "mission.explanation",
    "Fleet": "mission.fleet",
    "InputError": "errors",
    "MissiontreeError": "errors",
    "Plan": "mission.plan",
    "Position": "mission.position",
    "RecordedModel": "llm.recorded",
    "Robot": "mission.fleet",
    "RobotType": "mission.fleet",
    "Scene": "mission.scene",
    "ScriptedModel": "llm.scripted",
    "Weights": "mission.estimate",
    "check": "checking",
    "explain": "explaining.explain",
    "plan": "planner",
    "plan_text": "reporting.text",
    "routine": "routines.python",
}

__all__ = [
    "Budgets",
    "Capability",
    "Control",
    "Entity",
    "Explanation",
    "Fleet",
    "InputError",
    "MissiontreeError",
    "Plan",
    "Position",
    "RecordedModel",
    "Robot",
    "RobotType",
    "Scene",
    "ScriptedModel",
    "Weights",
    "check",
    "explain",
    "plan",
    "plan_text",
    "routine",
]


_DRAWERS = {"Plan": ("reporting.html.notebook", "plan_html")}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'missiontree' has no attribute {name!r}")
    return getattr(import_module(f"missiontree.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return [*__all__, "__version__"]


def _drawn_by(home: str, function: str) -> Callable[[Any], str]:
    """A function that is loaded when it is first called."""

    def draw(value: Any) -> str:
        drawn: str = getattr(import_module(f"missiontree.{home}"), function)(value)
        return drawn

    return draw


for _kind, _home in _DRAWERS.items():
    draw_with(_kind, _drawn_by(*_home))
