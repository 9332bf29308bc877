"""Recorded dialogues on disk, and the missions they were about: a transcript holds the words and a digest, the rest is looked for."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.briefing import Request
    from missiontree.llm.recording import Recording

Source = Callable[[str], "Request"]
"""Where a mission's fleet, scene and routines may come from: makes a request of the mission's words."""
_NO_FILE = " "  # behind words that might look like the name of a file


def files_of(paths: Sequence[Path], but: Path | None) -> list[Path]:
    """
    The files themselves, and of folders the transcripts in them.

    Parameters
    ----------
    paths
        Files and folders.
    but
        A file that is none of them, though it may lie in one of the folders.

    Raises
    ------
    InputError
        If there is no such file, or a folder has no transcripts.
    """
    files: list[Path] = []
    for path in paths:
        found = [file for file in sorted(path.glob("*.jsonl")) if not _same(file, but)] if path.is_dir() else [path]
        if not found:
            raise InputError("there are no transcripts in this folder", file=str(path), accepted="files named *.jsonl")
        if not path.exists():
            raise InputError("there is no such file", file=str(path), accepted="a transcript, a plan, or a folder")
        files += found
    return list(dict.fromkeys(files))


def dialogue_of(file: Path) -> tuple[tuple[str, ...], Request | None]:
    """
    The transcript of a file, and its mission if the file is a plan, which holds it.

    Raises
    ------
    InputError
        If the file cannot be read; with file and line.
    """
    from missiontree.briefing import Request
    from missiontree.formats.document import read_text
    from missiontree.formats.source import load_text

    text = load_text(file)
    if file.suffix != ".json":
        return tuple(text.splitlines()), None
    plan = read_text(text, "plan", str(file))
    return plan.provenance.transcript, Request(brief=plan.brief)


def from_file(mission: Path) -> Source:
    """The fleet, scene and routines of a mission file."""

    def source(words: str) -> Request:
        from missiontree.briefing import request_from

        return request_from(f"{words}{_NO_FILE}", project=mission)

    return source


def paper(words: str) -> Request:
    """The paper's team, no scene, the built-in routines."""
    from missiontree.briefing import request_from

    return request_from(f"{words}{_NO_FILE}")


def request_of(recording: Recording, file: Path, sources: Sequence[Source]) -> Request | None:
    """
    The mission that a transcript was about: the first that has the digest of its header.

    Parameters
    ----------
    recording
        The transcript. It begins with words to a model.
    file
        Where it is.
    sources
        Where fleet, scene and routines are looked for first; then come mission files beside the transcript, then the paper's team.
    """
    from missiontree.authoring.finetuning import mission_said
    from missiontree.formats.digest import digest

    words = mission_said(recording) or ""
    for source in (*sources, *_beside(file), paper):
        request = source(words)
        request = replace(request, brief=replace(request.brief, text=words))
        if digest(request.brief) == recording.mission:
            return request
    return None


def _beside(file: Path) -> Iterator[Source]:
    """
    Mission files beside the transcript: the one with its name, and the folder's.

    What is no mission file is passed over. So is one with routines in Python, which are run: nobody has asked for that.
    """
    from missiontree.formats.document import read_file

    for mission in (file.with_suffix(".yaml"), file.with_name("mission.yaml")):
        source = from_file(mission)
        try:
            if any(name.endswith(".py") for name in read_file(mission, "mission").routines):
                continue
            source("A mission.")
        except InputError:
            continue
        yield source


def _same(file: Path, other: Path | None) -> bool:
    return other is not None and file.resolve() == other.resolve()
