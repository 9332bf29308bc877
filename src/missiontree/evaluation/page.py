"""An evaluation as one page of HTML: no script, no network, nothing beside it; readable on a phone, in light and in dark."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from missiontree import __version__
from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.in_words import (
    MEANINGS,
    VERDICT_NAMES,
    count,
    share,
    size_in_words,
    took,
    twins_in_words,
)
from missiontree.evaluation.page_details import details, worst_of
from missiontree.evaluation.page_marks import MARKS, anchor, marked
from missiontree.evaluation.summary import Summary, summaries
from missiontree.reporting.escape import xml_safe

_NOTHING_FROM_OUTSIDE = "default-src 'none'; style-src 'unsafe-inline'"


def page(evaluation: Evaluation) -> str:
    """The page; equal evaluations give equal bytes. Whatever users and models said stands in it as words, never as markup."""
    return "\n".join(_lines(evaluation)) + "\n"


def _lines(evaluation: Evaluation) -> Iterator[str]:
    title = f"Models compared by the suite {xml_safe(evaluation.suite)}"
    yield '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">'
    yield '<meta name="viewport" content="width=device-width, initial-scale=1">'
    yield f'<meta http-equiv="Content-Security-Policy" content="{_NOTHING_FROM_OUTSIDE}">'
    yield f"<title>{title}</title>"
    yield f"<style>\n{Path(__file__).with_name('page.css').read_text(encoding='utf-8')}</style>\n</head>\n<body>\n<main>"
    yield f"<h1>{title}</h1>"
    yield f'<p class="faint">{size_in_words(evaluation)}. missiontree {__version__}.</p>'
    if len(evaluation.runs) < evaluation.size:
        yield f'<p class="notice">{len(evaluation.runs):,} of {count(evaluation.size, "run")} are done.</p>'
    for model, why in evaluation.stopped.items():
        yield f'<p class="notice"><strong>{xml_safe(model)}</strong> was given up: {xml_safe(why)}</p>'
    yield '<h2 id="models">Models</h2>\n<div class="cards">'
    for summary in summaries(evaluation):
        yield from _card(summary)
    yield "</div>"
    yield from _key()
    yield from _matrix(evaluation)
    yield "<h2>Each mission</h2>"
    yield from details(evaluation)
    yield "</main>\n</body>\n</html>"


def _card(summary: Summary) -> Iterator[str]:
    yield f'<section class="card">\n<h3 dir="auto">{xml_safe(summary.model)}</h3>'
    if not summary.runs:
        yield "<p>No run is done.</p>\n</section>"
        return
    yield f'<div class="big">{share(summary.right)}</div>\n<p class="faint">of its runs are right (pass^1)</p>'
    yield from _bar(summary)
    rows = {f"{MARKS[kind]} {name}": str(getattr(summary.verdicts, kind)) for kind, name in VERDICT_NAMES.items()}
    rows |= {f"pass^{k}": share(value) for k, value in enumerate(summary.pass_k, start=1) if k > 1}
    rows["score"] = share(summary.score)
    if twins := twins_in_words(summary):
        rows["twins told apart"] = twins
    for title, numbers in (("", rows), ('<p class="faint over">A run takes</p>', took(summary))):
        yield f"{title}<dl>"
        yield from (f"<dt>{name}</dt><dd>{value}</dd>" for name, value in numbers.items())
        yield "</dl>"
    yield "</section>"


def _bar(summary: Summary) -> Iterator[str]:
    numbers = {kind: getattr(summary.verdicts, kind) for kind in VERDICT_NAMES}
    told = ", ".join(f"{number} {VERDICT_NAMES[kind]}" for kind, number in numbers.items() if number)
    yield f'<div class="bar" role="img" aria-label="{told}">'
    yield from (f'<span class="{kind}" style="flex: {number}"></span>' for kind, number in numbers.items() if number)
    yield "</div>"


def _key() -> Iterator[str]:
    yield '<ul class="key">'
    yield from (f"<li>{marked(kind)} {meaning}</li>" for kind, meaning in MEANINGS.items())
    yield "<li><strong>pass^k</strong> is the chance that k runs of a mission are all right, averaged over the missions.</li>"
    yield "</ul>"


def _matrix(evaluation: Evaluation) -> Iterator[str]:
    heads = "".join(f'<th scope="col" dir="auto">{xml_safe(model)}</th>' for model in evaluation.models)
    yield '<h2 id="missions">Missions</h2>\n<p class="faint">Right runs of all runs; each leads to what was expected and what was made.</p>'
    yield f'<div class="scroll">\n<table>\n<thead><tr><th scope="col">mission</th>{heads}</tr></thead>\n<tbody>'
    last = ""
    for setting, mission in evaluation.missions:
        if setting.id != last:
            yield f'<tr class="setting"><th scope="rowgroup" colspan="{len(evaluation.models) + 1}">{setting.id}</th></tr>'
            last = setting.id
        cells = "".join(f'<td class="cell">{_cell(evaluation, model, mission.id)}</td>' for model in evaluation.models)
        link = f'<a href="#{anchor(mission.id)}">{mission.id}</a>'
        words = f'<span class="words" dir="auto">{xml_safe(mission.say)}</span>'
        yield f'<tr><th scope="row">{link}{words}</th>{cells}</tr>'
    yield "</tbody>\n</table>\n</div>"


def _cell(evaluation: Evaluation, model: str, mission: str) -> str:
    runs = evaluation.of(model, mission)
    if not runs:
        return "–"
    kind = worst_of(runs)
    right = sum(run.kind == "right" for run in runs)
    place = anchor(mission, evaluation.models.index(model))
    return f'<a class="{kind}" href="#{place}" title="{VERDICT_NAMES[kind]}">{MARKS[kind]} {right}/{len(runs)}</a>'
