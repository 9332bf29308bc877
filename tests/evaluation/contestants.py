"""A small suite in a folder, and models that play their part in it by hand."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from missiontree.evaluation.contestant import Contestant
from missiontree.evaluation.run import Run
from missiontree.evaluation.suite import Setting, load_suite
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.llm.chat import ChatModel, Message, ProviderError, Tool, ToolCall, Usage
from missiontree.mission.spent import Spent

FIND, VISIT, PAINT = "Find Anna.", "Go to Anna.", "Paint the wall."
SUITE = f"""\
format: suite/1
setting: home
missions:
  - id: home-find
    say: {FIND}
    plan: [Search(Anna)]
  - id: home-visit
    say: {VISIT}
    must: [Reach(Anna)]
    must_not: [Follow(*)]
  - id: home-paint
    say: {PAINT}
    declined: impossible
    because: paint
"""
ROUTINES = """\
format: routines/1
routines:
  - id: Inspect
    purpose: Inspect {thing}.
    verbs: [inspect]
    arguments: [{name: thing, kinds: [object, place]}]
    branches:
      - name: look
        roles:
          - {name: eye, rating: look, actions: [{name: look, text: "Look at {thing}", duration_s: 1, uses: {energy_j: 8}}]}
"""
Missions = tuple[tuple[Setting, SuiteMission], ...]
Answers = Mapping[str, Sequence[tuple[str, Mapping[str, object]]] | ProviderError]


def suite_folder(folder: Path, text: str = SUITE) -> Path:
    """A folder with one setting."""
    path = folder / "suite" / "home" / "missions.yaml"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return folder / "suite"


def missions_in(folder: Path, text: str = SUITE) -> Missions:
    """The missions of that suite."""
    return tuple(load_suite(suite_folder(folder, text)).missions())


def attach(mission: str, *calls: str) -> list[tuple[str, Mapping[str, object]]]:
    """The calls that build a tree of routines, all of which are done in any order: ``Search(Anna)``."""
    parts = [call.removesuffix(")").partition("(") for call in calls]
    return [
        ("HierarchicalTree_init", {"objective": mission}),
        (
            "attachMultiSubTrees",
            {
                "parentString": mission,
                "treeNames": [f"{name}Tree" for name, _, _ in parts],
                "treeArguments": [[argument.strip() for argument in inner.split(",")] for _, _, inner in parts],
                "LogicalConstraint": "AND",
            },
        ),
    ]


def declare(missing: str) -> list[tuple[str, Mapping[str, object]]]:
    """The call that declares a mission impossible."""
    return [("declareImpossible", {"missing": missing, "reason": "Nobody can."})]


RIGHT: Answers = {
    FIND: attach(FIND, "Search(Anna)"),
    VISIT: attach(VISIT, "Reach(Anna)"),
    PAINT: declare("paint"),
}


class Player:
    """A model that makes the calls of the mission it is told in its first turn, and has nothing to add afterwards."""

    def __init__(self, answers: Answers, cost_usd: float | None = None) -> None:
        self._answers, self._cost = answers, cost_usd

    def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
        """Ten tokens are heard and five said in each turn."""
        usage = Usage(10, 5, self._cost)
        if any(message.speaker == "assistant" for message in messages):
            return Message("assistant", "Done.", usage=usage)
        told = next(message.text for message in messages if message.speaker == "user")
        answer = next(answer for words, answer in self._answers.items() if words in told)
        if isinstance(answer, ProviderError):
            raise answer
        calls = tuple(ToolCall(str(n), name, json.dumps(given)) for n, (name, given) in enumerate(answer))
        return Message("assistant", calls=calls, usage=usage)


def player(name: str, answers: Answers = RIGHT, cost_usd: float | None = None) -> Contestant:
    """A contestant that plays so in every run."""
    return Contestant(name, lambda: Player(answers, cost_usd))


def failing(name: str, fault: Callable[[], ProviderError]) -> Contestant:
    """A contestant that fails in every run."""

    class Failing:
        def __call__(self, messages: Sequence[Message], tools: Sequence[Tool]) -> Message:
            raise fault()

    def make() -> ChatModel:
        return Failing()

    return Contestant(name, make)


def run(mission: str = "home-find", number: int = 1, model: str = "m", *, right: bool = True, **given: object) -> Run:
    """A run as it might have been."""
    made: dict[str, object] = {
        "model": model,
        "mission": mission,
        "number": number,
        "digest": "d",
        "kind": "right" if right else "wrong",
        "status": "complete",
        "score": 1.0 if right else 0.5,
        "differences": () if right else ("missing: Search(Anna)",),
        "got": "Search(Anna)",
        "seconds": 2.0,
        "spent": Spent(turns=2, calls=3, refused=1, input_tokens=100, output_tokens=10, cost_usd=0.25),
    }
    return Run(**{**made, **given})  # type: ignore[arg-type]
