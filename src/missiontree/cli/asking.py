"""The questions of ``missiontree explain``: why not otherwise, and what would change without a robot."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from missiontree.cli.exits import Exit
from missiontree.cli.screen import remark, show
from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.briefing import Request
    from missiontree.mission.control import Control
    from missiontree.mission.plan import Plan
    from missiontree.mission.why_not import WhyNot

EXITS = {"impossible": Exit.CANNOT_BE_DONE, "part_only": Exit.CANNOT_BE_DONE, "undecided": Exit.EXHAUSTED}
"""What an exit code says of a question about robots that are missing: whether the mission can then be done."""


@dataclass(frozen=True, slots=True)
class Asked:
    """
    What is asked on the command line; at most one of it.

    Parameters
    ----------
    words
        A question in words.
    robot, node
        A robot or robot type, and what it should do.
    rank
        Rank of an alternative.
    without
        Robots and robot types that fail.
    """

    words: str | None = None
    robot: str | None = None
    node: str | None = None
    rank: int | None = None
    without: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        given = {
            "--why-not": self.words is not None,
            "--why-not-robot": self.robot is not None,
            "--why-not-rank": self.rank is not None,
            "--without": bool(self.without),
        }
        named = [name for name, is_given in given.items() if is_given]
        if len(named) > 1:
            raise InputError(f"{' and '.join(named)} are given", accepted="one question at a time")
        if self.node is not None and self.robot is None:
            raise InputError("--for is given without --why-not-robot", accepted="--why-not-robot TYPE --for PART")

    def __bool__(self) -> bool:
        return bool(self.words is not None or self.robot is not None or self.rank is not None or self.without)


def answer(asked: Asked, plan: Plan, request: Request | None, control: Control) -> WhyNot:
    """
    The answer.

    Raises
    ------
    InputError
        If the plan is not delivered, or what is asked about is not there.
    """
    from missiontree.explaining import asking

    ways: tuple[tuple[bool, Callable[[], WhyNot]], ...] = (
        (bool(asked.without), lambda: asking.without(plan, asked.without, control=control, request=request)),
        (
            asked.robot is not None,
            lambda: asking.why_not_by(plan, asked.robot or "", asked.node or "", control=control, request=request),
        ),
        (
            asked.rank is not None,
            lambda: asking.why_not(plan, f"alternative {asked.rank}", control=control, request=request),
        ),
    )
    for meant, way in ways:
        if meant:
            return way()
    return asking.why_not(plan, asked.words or "", control=control, request=request)


def tell(told: WhyNot, asked: Asked, out: Path | None, as_json: bool, colour: bool | None) -> int:
    """Print the answer, write the plan that is as asked for, and say with the exit code what it came to."""
    from missiontree.cli.files import save
    from missiontree.formats.document import write_text
    from missiontree.reporting.why_not_view import why_not_view

    if as_json:
        typer.echo(write_text(replace(told, plan=None), "why_not"), nl=False)
    else:
        show(why_not_view(told), colour)
    if out is not None and told.plan is not None:
        save(out, write_text(told.plan, "plan"))
        if not as_json:
            remark(f"written to {out}", colour)
    elif out is not None:
        remark("nothing is written: there is no plan as asked for", colour)
    return EXITS.get(told.verdict, Exit.DELIVERED) if asked.without else Exit.DELIVERED
