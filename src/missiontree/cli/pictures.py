"""Pictures of a plan as files: what is asked for, and in which form, by the ending of a file's name."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from missiontree.cli.files import refuse_clashing, refuse_unwritable, save
from missiontree.cli.ranks import as_chosen, best_rank, known_rank, nothing, scheduled_rank
from missiontree.errors import InputError

if TYPE_CHECKING:
    from missiontree.mission.plan import Plan

DRAWN = (".svg", ".png")
WRITTEN = (".html", ".htm")


@dataclass(frozen=True, slots=True)
class Asked:
    """
    What is to be drawn of a plan.

    Parameters
    ----------
    tree, gantt, map, report, front_plot
        Files; None where nothing is asked for.
    rank
        Rank of the alternative to be shown. None: what the objective chooses, else the best that has a schedule; in the tree none.
    unfolded
        Whether the tree is that of all ways to do it, by every robot type.
    """

    tree: Path | None = None
    gantt: Path | None = None
    map: Path | None = None
    report: Path | None = None
    front_plot: Path | None = None
    rank: int | None = None
    unfolded: bool = False

    @property
    def files(self) -> dict[str, Path]:
        """Files by the option that names them."""
        named = {"--tree": self.tree, "--gantt": self.gantt, "--map": self.map, "--report": self.report}
        named["--front-plot"] = self.front_plot
        return {option: file for option, file in named.items() if file is not None}


def refuse_impossible(asked: Asked) -> None:
    """
    Refuse, before any work is done, files that cannot be written or whose names say nothing of a form there is.

    Raises
    ------
    InputError
        With what is accepted instead.
    """
    refuse_clashing(asked.files)
    for option, file in asked.files.items():
        forms = WRITTEN if option == "--report" else DRAWN
        if file.suffix.lower() not in forms:
            found = f"it ends in {file.suffix}" if file.suffix else "its name has no ending"
            raise InputError(
                f"{option}: {found}, which is no form of {'a report' if option == '--report' else 'a picture'}",
                file=str(file),
                accepted=f"a name that ends in {' or '.join(forms)}",
            )
        refuse_unwritable(file)


def write_pictures(plan: Plan, asked: Asked) -> tuple[Path, ...]:
    """
    Draw all that is asked for, then write it; the files, in the order of the options.

    Raises
    ------
    InputError
        If there is no such alternative, the plan lacks what a picture shows, or a file cannot be written. If so, and unless it was the
        disk's fault, nothing is written.
    """
    rank = None if asked.rank is None else known_rank(plan, asked.rank, "--rank")
    makers: dict[str, Callable[[], str]] = {
        "--tree": lambda: _tree(plan, rank, asked.unfolded),
        "--gantt": lambda: _gantt(as_chosen(plan, rank), rank),
        "--map": lambda: _map(as_chosen(plan, rank), rank),
        "--report": lambda: report_of(plan, rank),
        "--front-plot": lambda: _front(plan),
    }
    made = [(file, _in_form(file, makers[option]())) for option, file in asked.files.items()]
    for file, content in made:
        save(file, content)
    return tuple(file for file, _ in made)


def report_of(plan: Plan, rank: int | None = None) -> str:
    """The report of a plan, with what its checker says of it."""
    from missiontree.checking import check, taken_on_trust
    from missiontree.explaining.of_plan import explanation_of
    from missiontree.mission.control import Control
    from missiontree.reporting.html.checked import Checked
    from missiontree.reporting.html.report import report_html

    faults = tuple(check(plan))
    told = None if faults else explanation_of(plan, Control(seed=plan.provenance.seed))
    return report_html(plan, Checked(faults, () if faults else taken_on_trust(plan)), rank, told)


def _tree(plan: Plan, rank: int | None, unfolded: bool) -> str:
    from missiontree.reporting.tree.view import tree_svg

    tree = plan.grounding.tree if unfolded and plan.grounding is not None else plan.tree
    if tree is None or (unfolded and plan.grounding is None):
        raise nothing("--tree", "no tree over the fleet" if unfolded else "no tree")
    return tree_svg(tree, plan=plan, rank=rank)


def _gantt(plan: Plan, rank: int | None) -> str:
    from missiontree.reporting.gantt.view import gantt_svg

    return gantt_svg(plan, scheduled_rank(plan, rank, "--gantt"))


def _map(plan: Plan, rank: int | None) -> str:
    from missiontree.reporting.maps.view import map_svg

    drawn = map_svg(plan, rank if rank is not None else best_rank(plan))
    if drawn is None:
        raise nothing("--map", "nothing with a position")
    return drawn


def _front(plan: Plan) -> str:
    from missiontree.reporting.front.plot import front_svg

    drawn = front_svg(plan)
    if drawn is None:
        raise InputError("--front-plot: this plan has no front", hint="`missiontree plan … --front` seeks one.")
    return drawn


def _in_form(file: Path, drawn: str) -> bytes:
    if file.suffix.lower() == ".png":
        from missiontree.reporting.png import png_of

        return png_of(drawn)
    return drawn.encode("utf-8")
