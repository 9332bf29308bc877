"""Where the sample missions are."""

from __future__ import annotations

from pathlib import Path

from missiontree.errors import InputError

FOLDER = Path(__file__).parent
PROJECT = FOLDER / "project"
SAMPLES = {
    "reunite": "the paper's first mission: a lost child and a mother",
    "rescue": "the paper's second mission: a cat in a burning building",
    "luggage": "the paper's third mission: a woman with heavy luggage",
    "monster": "the paper's fourth mission: a city and a monster",
    "restaurants": "the paper's fifth mission: nothing a robot of the fleet could do",
    "site": "a building site with roads, four robot types and a routine of its own; what `init` writes",
}


def sample_file(name: str) -> Path:
    """
    Mission file of a sample.

    Raises
    ------
    InputError
        If there is no sample of that name.
    """
    if name not in SAMPLES:
        raise InputError(f"there is no sample {name!r}", where="--sample", accepted=", ".join(SAMPLES))
    return PROJECT / "mission.yaml" if name == "site" else FOLDER / f"{name}.yaml"
