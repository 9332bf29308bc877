"""Options that several commands share, declared once."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

Mission = Annotated[
    str | None,
    typer.Argument(
        help=(
            "A mission in words, a mission file (.yaml, .yml, .json) or a folder with a mission.yaml. "
            "Default: mission.yaml of this folder."
        )
    ),
]
FleetFile = Annotated[
    Path | None,
    typer.Option(
        "--fleet",
        metavar="FILE",
        help="Fleet file. Default: the mission file's, else fleet.yaml of the folder, else the paper's team.",
    ),
]
SceneFile = Annotated[
    Path | None,
    typer.Option(
        "--scene",
        metavar="FILE",
        help="Scene file. Default: the mission file's, else scene.yaml of the folder, else none.",
    ),
]
RoutineFiles = Annotated[
    list[Path] | None,
    typer.Option(
        "--routines", metavar="FILE", help="File of further routines; may be given several times. A .py file is run."
    ),
]
MethodFiles = Annotated[
    list[Path] | None,
    typer.Option("--methods", metavar="FILE", help="File of further mission methods; may be given several times."),
]
WeightsText = Annotated[
    str | None,
    typer.Option(
        "--weights", metavar="A,B,C", help="alpha,beta,gamma of utility = alpha*quality - beta*seconds - gamma*cost."
    ),
]
Without = Annotated[
    list[str] | None,
    typer.Option(
        "--without",
        metavar="NAME",
        help="A robot type or robot that takes no part, beside those that the mission file leaves out; may be given several times.",
    ),
]
Require = Annotated[
    list[str] | None,
    typer.Option(
        "--require",
        metavar="NAME",
        help="A robot type or robot that must take part, beside those that the mission file requires; may be given several times.",
    ),
]
MinQualityText = Annotated[
    list[str] | None,
    typer.Option(
        "--min-quality",
        metavar="Q",
        help=(
            "Least quality of every action: 0.5, or by routine or capability as in Search=0.8,carry=0.5; may be given several "
            "times. Replaces what the mission file says of it."
        ),
    ),
]
EstimatorFile = Annotated[
    Path | None,
    typer.Option(
        "--estimator",
        metavar="FILE.py",
        help="File of an estimator of your own, which is run. Default: the mission file's, else what the fleet states.",
    ),
]
AccumulateText = Annotated[
    str | None,
    typer.Option(
        "--accumulate",
        metavar="HOW",
        help="How the utilities of actions make that of an alternative: sum (default), mean or min.",
    ),
]
DiverseFlag = Annotated[
    bool | None,
    typer.Option(
        "--diverse/--not-diverse",
        help="Alternatives that differ in team: in the set of robot types that take part. Default: as the mission file says, else no.",
    ),
]
PartWeights = Annotated[
    list[str] | None,
    typer.Option(
        "--part",
        metavar="NAME=WEIGHT",
        help=(
            "How much a part of the mission counts where not all of it can be done, as in 'Search(cat)=3'; may be given several times. "
            "Default: as the mission file says, else 1 for every routine."
        ),
    ),
]
ReturnHomeFlag = Annotated[
    bool | None,
    typer.Option(
        "--return-home/--stay-out",
        help="Each robot that takes part goes back to where it started, after its last action. Default: as the mission file says, "
        "else no.",
    ),
]
ObjectiveText = Annotated[
    str | None,
    typer.Option(
        "--objective",
        metavar="WHAT",
        help=(
            "What decides which alternative is chosen: utility (default), makespan, utility-makespan, weighted-team or weighted-sum "
            "(alpha*q - beta*d - gamma*c, d being the makespan, or the time of all robots)."
        ),
    ),
]
FrontPlot = Annotated[
    Path | None,
    typer.Option(
        "--front-plot",
        metavar="FILE",
        help="Draw the front into this .svg or .png file; plan then seeks it, as with --front.",
    ),
]
Alternatives = Annotated[
    int | None, typer.Option("-k", "--alternatives", metavar="K", help="How many alternatives. Default 4.")
]
Sample = Annotated[
    str | None,
    typer.Option(
        "--sample",
        metavar="NAME",
        help=(
            "Plan a sample: the paper's reunite, rescue, luggage, monster, restaurants; site; or airport, clinic, college, "
            "depot, harbour, home, museum, orchard, tunnel, wind_farm."
        ),
    ),
]
Model = Annotated[
    str | None,
    typer.Option(
        "--model",
        metavar="MODEL",
        envvar="MISSIONTREE_MODEL",
        help=(
            "Who reads the mission: offline (default), recorded:FILE, openai:NAME, anthropic:NAME, gemini:NAME, ollama:NAME or "
            "local:FILE.gguf. `missiontree models` tells what can be used here."
        ),
    ),
]
BaseUrl = Annotated[
    str | None,
    typer.Option(
        "--base-url",
        metavar="URL",
        envvar="MISSIONTREE_BASE_URL",
        help="Address of an OpenAI-compatible endpoint, for openai:NAME and ollama:NAME.",
    ),
]
Replay = Annotated[
    Path | None,
    typer.Option(
        "--replay", metavar="FILE", help="Make the calls of a recorded dialogue again, without a model (--record)."
    ),
]
MaxTurns = Annotated[
    int | None, typer.Option("--max-turns", metavar="N", help="Messages that a language model may send. Default 60.")
]
MaxTokens = Annotated[
    int | None,
    typer.Option("--max-tokens", metavar="N", help="Tokens that a language model may take in all. Default 500000."),
]
MaxSeconds = Annotated[
    float | None,
    typer.Option("--max-seconds", metavar="S", help="Seconds that a language model may take in all. Default 1200."),
]
Kinds = Annotated[
    bool | None, typer.Option("--kinds/--no-kinds", help="Enforce kinds of arguments (a message needs a reader).")
]
TimeLimit = Annotated[
    float | None, typer.Option("--time-limit", metavar="SECONDS", help="Seconds that planning may take.")
]
Seed = Annotated[int | None, typer.Option("--seed", metavar="N", help="Seed of everything random. Default 0.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON.")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but the answer.")]
Colour = Annotated[
    bool | None, typer.Option("--colour/--no-colour", "--color/--no-color", help="Default: as the terminal can.")
]
