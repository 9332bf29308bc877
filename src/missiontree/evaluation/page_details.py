"""What the page tells of each mission: its words, what was expected, and what each model made of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.in_words import VERDICT_NAMES, count, per_run, share
from missiontree.evaluation.page_marks import anchor, marked
from missiontree.evaluation.run import Run
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.evaluation.verdict import VerdictKind
from missiontree.reporting.escape import xml_safe


def details(evaluation: Evaluation) -> Iterator[str]:
    """An article for each mission."""
    known = {mission.id for _, mission in evaluation.missions}
    for setting, mission in evaluation.missions:
        yield f'<article id="{anchor(mission.id)}">\n<h3>{mission.id}</h3>'
        yield f'<p class="faint">{setting.id} · <a href="#missions">all missions</a></p>'
        yield f'<blockquote dir="auto">{xml_safe(mission.say)}</blockquote>'
        yield '<dl class="told">'
        yield from _expected(mission, known)
        yield "</dl>"
        for place, model in enumerate(evaluation.models):
            if runs := evaluation.of(model, mission.id):
                yield f'<div class="outcome" id="{anchor(mission.id, place)}">'
                yield f'<p><strong dir="auto">{xml_safe(model)}</strong></p>'
                for alike in _alike(runs):
                    yield from _outcome(alike)
                yield "</div>"
        yield "</article>"


def worst_of(runs: Sequence[Run]) -> VerdictKind:
    """The worst verdict on some runs: a wrong plan before a wrong refusal before a right plan."""
    order = [kind for kind in VERDICT_NAMES if kind != "right"] + ["right"]
    return min((run.kind for run in runs), key=order.index)


def _expected(mission: SuiteMission, known: set[str]) -> Iterator[str]:
    for number, text in enumerate(mission.wanted):
        yield _told("or" if number else "expected", f"<code>{xml_safe(text)}</code>")
    for name, own in (("fleet", mission.fleet), ("scene", mission.scene), ("planned, it is", mission.outcome)):
        if own:
            yield _told(name, f"<code>{xml_safe(own)}</code>")
    if mission.twin is not None:
        twin = f'<a href="#{anchor(mission.twin)}">{mission.twin}</a>' if mission.twin in known else mission.twin
        yield _told("possible twin", twin)
        yield _told("removed", xml_safe(mission.removed))
    if mission.note:
        yield _told("note", xml_safe(mission.note))


def _alike(runs: Sequence[Run]) -> list[list[Run]]:
    """Runs that came to the same, together."""
    groups: dict[object, list[Run]] = {}
    for run in runs:
        same = (run.kind, run.status, run.score, run.got, run.differences, run.reasons)
        groups.setdefault(same, []).append(run)
    return list(groups.values())


def _outcome(runs: Sequence[Run]) -> Iterator[str]:
    first = runs[0]
    which = ", ".join(str(run.number) for run in runs)
    what = f"run{'s' if len(runs) > 1 else ''} {which} · score {share(first.score)}"
    yield f'<p>{marked(first.kind)} <span class="faint">{what} · {_took(runs)}</span></p>\n<dl class="told">'
    yield _told("got", f"<code>{xml_safe(first.got)}</code>" if first.got else first.status.replace("_", " "))
    if first.got and first.status != "complete":
        yield _told("came to", first.status.replace("_", " "))
    for label, lines in (("differences", first.differences), ("reasons", first.reasons)):
        for number, line in enumerate(lines):
            yield _told("" if number else label, f'<span dir="auto">{xml_safe(line)}</span>')
    yield "</dl>"


def _took(runs: Sequence[Run]) -> str:
    spent = [run.spent for run in runs if run.spent is not None]
    parts = [f"{per_run(sum(run.seconds for run in runs), len(runs), 2)} s"]
    if spent:
        calls = sum(one.calls for one in spent)
        tokens = sum(one.input_tokens + one.output_tokens for one in spent)
        parts += [
            count(calls, "call") if len(spent) == 1 else f"{per_run(calls, len(spent))} calls",
            f"{per_run(tokens, len(spent), 0)} tokens",
        ]
    return ", ".join(parts)


def _told(name: str, markup: str) -> str:
    return f"<dt>{name}</dt><dd>{markup}</dd>"
