"""Run the command line in this process, as a person would from a shell."""

from __future__ import annotations

import sys
from typing import NamedTuple

import pytest

from missiontree.cli.main import command_line


class Ran(NamedTuple):
    """What a command left."""

    code: int
    out: str
    err: str


class Shell:
    """Types commands."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
        self._monkeypatch, self._capsys = monkeypatch, capsys

    def __call__(self, *arguments: str) -> Ran:
        self._monkeypatch.setattr(sys, "argv", ["missiontree", *arguments])
        self._capsys.readouterr()
        code = command_line()
        captured = self._capsys.readouterr()
        return Ran(code, captured.out, captured.err)
