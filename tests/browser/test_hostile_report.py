"""
Reports, pictures and pages with hostile names in a real browser, with and without the page's own policy.

Whatever a browser would make of a name, it must stay words: no dialog, no script of theirs, no request, no navigation, nothing on the
console, nothing that the policy had to forbid, and the same elements with the same attributes as with harmless names.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Dialog, Page, Request

from missiontree import check
from missiontree.mission.plan import Plan
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.html.checked import Checked
from missiontree.reporting.html.notebook import plan_html
from missiontree.reporting.html.report import report_html
from missiontree.reporting.maps.view import map_svg
from missiontree.reporting.tree.view import tree_svg
from tests.reporting.hostile import MARKED, hostile_names
from tests.reporting.hostile_plans import DECLINED, DELIVERED, as_a_file_may_hold_it
from tests.reporting.strict import WORDS

NAMES = hostile_names(500)
HAND = 50
HANDS = [NAMES[start : start + HAND] for start in range(0, len(NAMES), HAND)]
HARMLESS = ("A", "Anna Berg", "six words " * 6, "six words " * 20, "W" * 3000, "\u4e2d" * 800, "x " * 900)
LISTEN = """
window.refused = [];
document.addEventListener("securitypolicyviolation", (event) => window.refused.push(event.violatedDirective + " " + event.blockedURI));
"""
# Every element with the names of its attributes, once; then the attributes that would be run, or that hold a name.
ELEMENTS = """
[...new Set([...document.querySelectorAll("*")].map((element) =>
  [element.namespaceURI, element.tagName, ...[...element.attributes].map((one) => one.name).sort()].join(" ")))]
"""
VALUES = """
(mark) => [...document.querySelectorAll("*")].flatMap((element) => [...element.attributes]
  .map((one) => [one.name, one.value]).filter(([name, value]) => name.startsWith("on") || new RegExp(mark).test(value)))
"""
# What a reader does: unfolds everything, chooses every alternative, moves the time, plays.
READ = """
for (const fold of document.querySelectorAll("details")) fold.open = true;
for (const radio of document.querySelectorAll("input[type=radio]")) {
  radio.click();
  const time = document.getElementById("time");
  if (time) for (const share of [0, 0.5, 1]) {
    time.value = share * time.max;
    time.dispatchEvent(new Event("input", { bubbles: true }));
  }
}
for (const element of document.querySelectorAll("*"))
  for (const kind of ["mouseover", "focus", "click", "toggle", "beforeinput", "load", "error"])
    if (!["A", "BUTTON", "INPUT", "LABEL", "SUMMARY"].includes(element.tagName)) element.dispatchEvent(new Event(kind));
"""


class Watched:
    """A page that everything it does is written down of."""

    def __init__(self, browser: Browser, bypass_csp: bool) -> None:
        self.context = browser.new_context(bypass_csp=bypass_csp, viewport={"width": 1200, "height": 900})
        self.page = self.context.new_page()
        self.did: list[str] = []
        self.address = ""
        self.page.add_init_script(LISTEN)
        self.page.on("dialog", self._spoken_to)
        self.page.on("console", lambda message: self.did.append(f"console {message.text}"))
        self.page.on("pageerror", lambda error: self.did.append(f"error {error}"))
        self.page.on("request", self._asked)
        self.page.on("popup", lambda popup: self.did.append(f"popup {popup.url}"))
        self.page.on("download", lambda download: self.did.append(f"download {download.url}"))
        self.page.on("framenavigated", lambda frame: self._moved(frame.url))

    def _spoken_to(self, dialog: Dialog) -> None:
        self.did.append(f"dialog {dialog.message}")
        dialog.dismiss()

    def _asked(self, request: Request) -> None:
        if request.url != self.address:
            self.did.append(f"request {request.url}")

    def _moved(self, url: str) -> None:
        if url not in {self.address, "about:blank"}:
            self.did.append(f"went to {url}")

    def open(self, file: Path) -> Page:
        self.address = file.as_uri()
        self.page.goto(self.address)
        return self.page

    def close(self) -> list[str]:
        self.context.close()
        return self.did


def check_page(page: Page) -> set[str]:
    """Nothing of theirs has run or come in; returns the elements that there are."""
    page.evaluate(READ)
    assert page.evaluate("window.refused") == []
    assert page.evaluate("globalThis.broken === undefined")
    for name, value in page.evaluate(VALUES, MARKED.pattern):
        assert not name.startswith("on"), (name, value)
        assert name in WORDS, (name, value)
    return set(page.evaluate(ELEMENTS))


def documents(plan: Plan) -> Iterator[tuple[str, str]]:
    """The report, the notebook's view in a bare page, and each picture as a document of its own."""
    yield "report.html", report_html(plan)
    yield "checked.html", report_html(plan, Checked(check(plan), ()))
    yield "notebook.html", f"<!doctype html><meta charset='utf-8'><title>x</title>{plan_html(plan)}"
    if plan.tree is not None and plan.grounding is not None:
        yield "tree.svg", tree_svg(plan.tree, plan=plan, rank=1)
        yield "ways.svg", tree_svg(plan.grounding.tree)
        yield "gantt.svg", gantt_svg(plan, 1)
        yield "map.svg", map_svg(plan, 1) or ""


def opened(watchers: list[Watched], folder: Path, plan: Plan) -> Iterator[tuple[str, set[str]]]:
    for name, text in documents(plan):
        file = folder / name
        file.write_text(text, encoding="utf-8")
        for watched in watchers:
            yield name, check_page(watched.open(file))


def harmless_elements(browser: Browser, folder: Path, world: str) -> dict[str, set[str]]:
    """The elements of each document of a world in which nobody has a hostile name."""
    known: dict[str, set[str]] = {}
    watched = Watched(browser, bypass_csp=False)
    for names in (HARMLESS[:1], HARMLESS[1:4], HARMLESS):
        for name, elements in opened([watched], folder, as_a_file_may_hold_it(world, names)):
            known.setdefault(name, set()).update(elements)
    assert watched.close() == []
    return known


@pytest.mark.parametrize("first", range(len(DELIVERED)), ids=DELIVERED)
def test_five_hundred_names_do_nothing_in_a_browser(browser: Browser, tmp_path: Path, first: int) -> None:
    """Once with the policy of the page, and once without, when nothing but the escaping stands between a name and a browser."""
    watchers = [Watched(browser, bypass_csp) for bypass_csp in (False, True)]
    for world, ours in ((DELIVERED[first], watchers), (DECLINED[first % len(DECLINED)], watchers[first % 2 :][:1])):
        known = harmless_elements(browser, tmp_path, world)
        for hand in HANDS[first :: len(DELIVERED)]:
            for name, elements in opened(ours, tmp_path, as_a_file_may_hold_it(world, hand)):
                assert elements <= known[name], (world, name, elements - known[name])
    for watched in watchers:
        assert watched.close() == []


def test_the_listeners_hear_what_a_careless_page_would_do(browser: Browser, tmp_path: Path) -> None:
    """Names put into a page as they are, so that silence above means something."""
    careless = {
        "dialog": "<img src='' onerror=alert('Zq0001')>",
        "console": "<script>console.log('Zq0001')</script>",
        "error": "<script>nonsense()</script>",
        "request": "<link rel=stylesheet href=//evil.test/Zq0001.css>",
    }
    for deed, name in careless.items():
        watched = Watched(browser, bypass_csp=False)
        file = tmp_path / f"{deed}.html"
        file.write_text(f"<!doctype html><meta charset='utf-8'><title>x</title><p>{name}</p>", encoding="utf-8")
        with pytest.raises(AssertionError):
            assert check_page(watched.open(file)) <= set()
        assert deed in {said.split()[0] for said in watched.close()}
    watched = Watched(browser, bypass_csp=False)
    file = tmp_path / "attribute.html"
    file.write_text(
        "<!doctype html><meta charset='utf-8'><title>x</title><p title=Zq0001 href=Zq0001>x</p>", encoding="utf-8"
    )
    with pytest.raises(AssertionError, match="href"):
        check_page(watched.open(file))
    watched.close()
    policy = "<meta http-equiv='Content-Security-Policy' content=\"default-src 'none'\">"
    watched = Watched(browser, bypass_csp=False)
    file = tmp_path / "policy.html"
    file.write_text(f"<!doctype html>{policy}<script>globalThis.broken='Zq0001'</script>", encoding="utf-8")
    with pytest.raises(AssertionError, match="script-src"):
        check_page(watched.open(file))
    watched.close()
