"""Where the sample transcripts are: dialogues written by hand, marked as scripted, to replay, to read and to learn from."""

from __future__ import annotations

from pathlib import Path

from missiontree.errors import InputError
from missiontree.samples.catalogue import SAMPLES, sample_file

FOLDER = Path(__file__).parent / "transcripts"
DIALOGUES = {
    "reunite": "the paper's first mission, in the fewest turns",
    "rescue": "the paper's second mission: entities that no scene has are introduced",
    "luggage": "the paper's third mission: where to is not said, so the place is introduced",
    "monster": "the paper's fourth mission: one thing goes on until another ends",
    "restaurants": "the paper's fifth mission: declared impossible, with what is missing",
    "campus": "a routine is misspelt; the model stops too early and is told what is open",
    "construction": "declared impossible, sent back since the fleet has what is called missing, then built",
    "farm": "a choice whose one side has two parts: another gate is refused, and a list that came as a text",
    "hospital": "a place where a person is needed is refused",
    "mine": "declared impossible, since a load is beyond every robot",
    "shipyard": "an answer is cut at its length, and said again in fewer words",
    "station": "an until link the wrong way round is refused",
    "theatre": "a parent is called by another name than it was given",
    "warehouse": "the review finds what is lost and not searched for, and mends the order",
    "zoo": "a robot's name where a robot type is needed is refused",
}


def transcript_file(name: str) -> Path:
    """
    The transcript of that name.

    Raises
    ------
    InputError
        If there is none.
    """
    return _known(name, FOLDER / f"{name}.jsonl")


def mission_file(name: str) -> Path:
    """
    The mission file that the transcript of that name is about.

    Raises
    ------
    InputError
        If there is none.
    """
    return sample_file(name) if name in SAMPLES else _known(name, FOLDER / f"{name}.yaml")


def _known(name: str, file: Path) -> Path:
    if name not in DIALOGUES:
        raise InputError(f"there is no sample transcript {name!r}", accepted=", ".join(DIALOGUES))
    return file
