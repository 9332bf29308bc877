"""An evaluation in the terminal: how often models are right, in what they err, what they take."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rich.console import Console, ConsoleOptions, Group, RenderableType, RenderResult
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.in_words import VERDICT_NAMES, count, share, size_in_words, took, twins_in_words
from missiontree.evaluation.run import Run
from missiontree.evaluation.summary import Summary, summaries
from missiontree.reporting.escape import one_line
from missiontree.reporting.text import words

MOST_MISSES = 12
LEAST_MISSES = 4
MOST_PASSES = 8
_ANY_WIDTH, _NAME_WIDTH = 10_000, 28
_COLOURS = {"right": "green", "wrong plan": "red", "wrong refusal": "yellow", "wrong decline": "yellow"}


def evaluation_view(evaluation: Evaluation) -> Group:
    """Everything a person wants to see first: tables of the models, then what was not right."""
    return Group(*_sections(evaluation))


def _sections(evaluation: Evaluation) -> Iterator[RenderableType]:
    line = Text.assemble(("Suite ", "bold"), words(evaluation.suite, "bold"), f": {size_in_words(evaluation)}")
    if len(evaluation.runs) < evaluation.size:
        line.append(f"; {len(evaluation.runs)} of {count(evaluation.size, 'run')} done")
    yield line
    all_of_them = summaries(evaluation)
    known = [summary for summary in all_of_them if summary.runs]
    if known:
        yield from _titled("How often right", _Rows({summary.model: _verdicts(summary) for summary in known}))
        if any(len(summary.pass_k) > 1 for summary in known):
            title = "pass^k: the chance that k runs of a mission are all right"
            yield from _titled(title, _Rows({summary.model: _passes(summary) for summary in known}))
        yield from _titled("What a run takes", _Rows({summary.model: took(summary) for summary in known}))
    for model, why in evaluation.stopped.items():
        yield Text("")
        yield Text.assemble(("✗ ", "red"), words(model, "bold"), " was given up: ", words(why))
    for model in evaluation.models:
        if misses := _misses(evaluation, model):
            title = f"Not right by {model}" if len(evaluation.models) > 1 else "Not right"
            yield from _titled(one_line(title), Group(*misses))


def _titled(title: str, body: RenderableType) -> Iterator[RenderableType]:
    yield Text("")
    yield Text(title, style="bold")
    yield Padding(body, (0, 0, 0, 2), expand=False)


def _verdicts(summary: Summary) -> dict[str, str]:
    counts = {name: str(getattr(summary.verdicts, kind)) for kind, name in VERDICT_NAMES.items()}
    twins = twins_in_words(summary)
    return {"runs": str(summary.runs), **counts, "score": share(summary.score)} | ({"twins": twins} if twins else {})


def _passes(summary: Summary) -> dict[str, str]:
    shown = summary.pass_k
    numbers = list(range(1, len(shown) + 1))
    if len(shown) > MOST_PASSES:
        del numbers[MOST_PASSES - 1 : -1]
    return {f"pass^{k}": share(shown[k - 1]) for k in numbers}


class _Rows:
    """A row per model; where the terminal is too narrow for that, a block per model with a line per column."""

    def __init__(self, rows: Mapping[str, Mapping[str, str]]) -> None:
        self._rows = rows

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        table = self._table()
        if console.measure(table, options=options.update(max_width=_ANY_WIDTH)).maximum <= options.max_width:
            yield table
            return
        for model, row in self._rows.items():
            yield words(model, "cyan")
            yield Padding(self._block(row), (0, 0, 0, 2), expand=False)

    def _table(self) -> Table:
        columns = list(dict.fromkeys(column for row in self._rows.values() for column in row))
        table = Table(box=None, padding=(0, 2, 0, 0), header_style="dim")
        table.add_column("model", max_width=_NAME_WIDTH, overflow="fold", vertical="bottom")
        for column in columns:
            table.add_column(column.replace(" ", "\n", 1), justify="right", no_wrap=True, vertical="bottom")
        for model, row in self._rows.items():
            table.add_row(words(model, "cyan"), *(_cell(column, row.get(column, "")) for column in columns))
        return table

    @staticmethod
    def _block(row: Mapping[str, str]) -> Table:
        block = Table(box=None, padding=(0, 2, 0, 0), show_header=False)
        block.add_column(style="dim", no_wrap=True)
        block.add_column(justify="right", no_wrap=True)
        for column, value in row.items():
            block.add_row(column, _cell(column, value))
        return block


def _cell(column: str, value: str) -> Text:
    return Text(value, style=_COLOURS.get(column, "") if value != "0" else "dim")


def _misses(evaluation: Evaluation, model: str) -> list[Text]:
    """A line for each mission that a model did not get right every time, the worst verdicts first; the first few of them."""
    order = list(VERDICT_NAMES)
    found: list[tuple[int, Text]] = []
    for _, mission in evaluation.missions:
        runs = evaluation.of(model, mission.id)
        missed = sorted((run for run in runs if run.kind != "right"), key=lambda run: order.index(run.kind))
        if missed:
            found.append((order.index(missed[0].kind), _miss(missed[0], len(missed), len(runs))))
    lines = [line for _, line in sorted(found, key=lambda pair: pair[0])]
    most = max(MOST_MISSES // len(evaluation.models), LEAST_MISSES)
    if len(lines) > most:
        lines = [*lines[:most], Text(f"… and {len(lines) - most} more; --html and --json list them all", style="dim")]
    return lines


def _miss(run: Run, missed: int, runs: int) -> Text:
    kind = VERDICT_NAMES[run.kind]
    line = Text.assemble((kind, _COLOURS.get(kind, "dim")), " ", words(run.mission, "bold"))
    if runs > 1:
        line.append(f" ({missed} of {runs} runs)")
    unanswered = run.kind in {"no_answer", "declined_though_possible"}
    why = run.reasons[0] if unanswered and run.reasons else run.differences[0]
    return line.append(": ").append_text(words(why, "dim"))
