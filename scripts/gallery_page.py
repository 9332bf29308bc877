"""The gallery as text and pictures: what the page says of each sample mission, and what is drawn for it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from missiontree import plan
from missiontree.mission.plan import Plan
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.html.facts import facts, headline
from missiontree.reporting.maps.view import map_svg
from missiontree.reporting.text import best_scheduled, said_once
from missiontree.reporting.tree.view import tree_svg
from missiontree.samples.catalogue import PAPER, SAMPLES, sample_file

WIDTH = 880.0  # what GitHub has room for, so that the words of a chart are not drawn smaller than those around it
FOLDER = "pictures/gallery"
LIGHT, DARK = "pictures/report-light.png", "pictures/report-phone-dark.png"
SEEN_LIGHT = "The report of a plan in a wide window: mission, outcome, key figures, who does what, and the schedule"
SEEN_DARK = "The map of the same report on a telephone, dark, with the robots where the clock says they are"
SETTINGS = tuple(name for name in ("site", *sorted(set(SAMPLES) - {"site"})) if name not in PAPER)
HEAD = f"""\
<!-- `python -m scripts.gallery` writes this page and its pictures. -->
# Gallery

Sample missions of eleven settings and the five missions of the paper, planned. All of them are in the package:
`missiontree plan --sample NAME` plans one, and `missiontree init FOLDER --sample NAME` writes its files into a folder of your own,
where you can change them and plan again.

The pictures are those of [`missiontree show`](how-to/show-a-plan.md), of the best alternative that has a schedule, the charts
a little narrower to fit this page. In a chart, robots are rows; in a map, a robot has the colour of its row. Open a picture by itself,
and its bars and signs tell their words as tooltips. A [glossary](glossary.md) has the words of the field. `--report report.html` puts
all of it on one page, with every alternative and a clock that moves the robots:

<table><tr>
<td><img src="{LIGHT}" alt="{SEEN_LIGHT}" width="600"></td>
<td><img src="{DARK}" alt="{SEEN_DARK}" width="200"></td>
</tr></table>
"""
THE_PAPER = """\
## The paper's missions

The five missions of [Gupta et al.](https://arxiv.org/abs/2501.16539), for the team of the paper. They have no map: nothing in them
has a position.
"""


@dataclass(frozen=True, slots=True)
class Gallery:
    """
    Everything that is written.

    Parameters
    ----------
    page
        The page, as Markdown.
    pictures
        SVG documents by their path from the folder of the page.
    """

    page: str
    pictures: Mapping[str, str] = field(default_factory=dict)

    @property
    def files(self) -> dict[str, str]:
        """Page and pictures by their path from the folder ``docs``."""
        return {"gallery.md": self.page, **self.pictures}


def gallery_of(settings: Sequence[str] = SETTINGS, paper: Sequence[str] = tuple(PAPER)) -> Gallery:
    """
    Plan samples and draw them.

    Parameters
    ----------
    settings
        Names of samples that have a map. Default: the building site, then the ten settings by name.
    paper
        Names of the paper's missions. Default: all five.
    """
    pictures: dict[str, str] = {}
    parts = [HEAD, "\n".join(_contents(settings))]
    for name in settings:
        parts.append("\n".join(_setting(name, plan(sample_file(name)), pictures)))
    parts.append(THE_PAPER)
    for name in paper:
        parts.append("\n".join(_of_the_paper(name, plan(sample_file(name)), pictures)))
    return Gallery("\n".join(parts), pictures)


def _contents(settings: Sequence[str]) -> Iterator[str]:
    yield "| sample | what it shows |"
    yield "|---|---|"
    for name in settings:
        yield f"| [{_title(name)}](#{name.replace('_', '-')}) | {SAMPLES[name]} |"
    yield "| [The paper's missions](#the-papers-missions) | the five missions of the paper and their trees |"
    yield ""


def _setting(name: str, made: Plan, pictures: dict[str, str]) -> Iterator[str]:
    rank = _best_rank(name, made)
    drawn_map = map_svg(made, rank)
    if made.tree is None or drawn_map is None:
        raise ValueError(f"sample {name} has no tree or no map")
    yield f"## {_title(name)}"
    yield ""
    yield from _beginning(name, made)
    yield _embedded(f"{name}-map", drawn_map, pictures)
    yield ""
    yield _embedded(f"{name}-gantt", gantt_svg(made, rank, width=WIDTH), pictures)
    yield ""
    yield f"<details><summary>The mission tree, with alternative {rank} lit</summary>"
    yield ""
    yield _embedded(f"{name}-tree", tree_svg(made.tree, plan=made, rank=rank), pictures, "Mission tree: ")
    yield ""
    yield "</details>"
    yield ""


def _of_the_paper(name: str, made: Plan, pictures: dict[str, str]) -> Iterator[str]:
    yield f"### {_title(name)}"
    yield ""
    yield from _beginning(name, made)
    if made.outcome != "delivered" or made.tree is None:
        return
    rank = _best_rank(name, made)
    yield _embedded(f"{name}-tree", tree_svg(made.tree, plan=made, rank=rank), pictures, "Mission tree: ")
    yield ""
    yield f"<details><summary>The schedule of alternative {rank}</summary>"
    yield ""
    yield _embedded(f"{name}-gantt", gantt_svg(made, rank, width=WIDTH), pictures)
    yield ""
    yield "</details>"
    yield ""


def _beginning(name: str, made: Plan) -> Iterator[str]:
    """The mission, what it shows, how to have it, and what it comes to."""
    yield f"> {made.brief.text.strip()}"
    yield ""
    yield _sentence(SAMPLES[name])
    yield ""
    yield "```sh"
    yield f"missiontree plan --sample {name}"
    yield f"missiontree init my-{name.replace('_', '-')} --sample {name}"
    yield "```"
    yield ""
    yield _result(made)
    yield ""


def _result(made: Plan) -> str:
    """What the plan comes to, in the words that its report begins with."""
    head = headline(made)
    if made.outcome != "delivered":
        why = " ".join(reason.message for reason in said_once(made.reasons))
        return f"**{head.word}.** {why}"
    best = best_scheduled(made)
    figures = facts(made, best.rank) if best is not None else ()
    said = (f"{one.name} {one.value}{f' ({one.note})' if one.note else ''}" for one in figures)
    return f"**{head.sentence}** {_sentence(', '.join(said))}"


def _best_rank(name: str, made: Plan) -> int:
    best = best_scheduled(made)
    if best is None:
        raise ValueError(f"sample {name} has no schedule: {made.outcome}")
    return best.rank


def _embedded(name: str, svg: str, pictures: dict[str, str], kind: str = "") -> str:
    """Keep a picture, and refer to it by its own title; ``kind`` tells what it is where the title does not."""
    path = f"{FOLDER}/{name}.svg"
    pictures[path] = svg
    title = re.search(r"<title[^>]*>(.*?)</title>", svg, re.DOTALL)
    said = " ".join(title[1].split()) if title else name
    return f"![{kind}{said}]({path})"


def _title(name: str) -> str:
    return name.replace("_", " ").capitalize()


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}{'' if text.endswith('.') else '.'}"
