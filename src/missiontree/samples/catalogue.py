"""Where the sample missions are: the paper's, and those of ten settings and a building site, each a folder that can be copied."""

from __future__ import annotations

from pathlib import Path

from missiontree.errors import InputError

FOLDER = Path(__file__).parent
PROJECT = FOLDER / "project"
PAPER = {
    "reunite": "the paper's first mission: a lost child and a mother",
    "rescue": "the paper's second mission: a cat in a burning building",
    "luggage": "the paper's third mission: a woman with heavy luggage",
    "monster": "the paper's fourth mission: a city and a monster",
    "restaurants": "the paper's fifth mission: nothing a robot of the fleet could do",
}
SETTINGS = {
    "airport": "a choice: two ways to board, the better one is worked out; zones on open ground",
    "clinic": "two floors joined by a lift, and a ward that only some robots may enter",
    "college": "a robot asked for by its name, and one robot that finds and then follows; one-way paths",
    "depot": "several robots at once, loads that are too heavy for some, one-way aisles",
    "harbour": "joint work: two boats tow one ship; areas that are closed to some types only",
    "home": "something is lost: it is searched for where it was seen last; a flat as a grid",
    "museum": "following lasts until somebody is found; walls and show cases as a grid",
    "orchard": "budgets: what a tank holds divides the work; a routine of its own",
    "tunnel": "a robot that is left out, a search in an area, a road that is blocked",
    "wind_farm": "needs and batteries: a tower too high for some; nobody flies over the village",
}
SAMPLES = {
    **PAPER,
    "site": "a building site with roads, four robot types and a routine of its own; what `init` writes",
    **SETTINGS,
}


def sample_file(name: str) -> Path:
    """
    Mission file of a sample.

    Raises
    ------
    InputError
        If there is no sample of that name.
    """
    return sample_files(name)["mission.yaml"]


def sample_files(name: str) -> dict[str, Path]:
    """
    Every file of a sample, by its path in a folder of one's own, with ``/`` between the parts.

    In such a folder ``missiontree plan`` plans the sample.

    Raises
    ------
    InputError
        If there is no sample of that name.
    """
    if name not in SAMPLES:
        raise InputError(f"there is no sample {name!r}", where="--sample", accepted=", ".join(SAMPLES))
    if name in PAPER:
        return {"fleet.yaml": FOLDER / "fleet.yaml", "mission.yaml": FOLDER / f"{name}.yaml"}
    folder = PROJECT if name == "site" else FOLDER / name
    return {file.relative_to(folder).as_posix(): file for file in sorted(folder.rglob("*.yaml"))}
