"""A real browser without a window, and reports for it to open from disk."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, sync_playwright

from missiontree import plan
from missiontree.reporting.html.report import report_html
from missiontree.samples.catalogue import sample_file
from tests.browser.chromium import chromium

LISTEN = """
window.refused = [];
document.addEventListener("securitypolicyviolation", (event) => window.refused.push(event.violatedDirective));
"""


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Chromium, as the machine has it; these tests are nothing without one."""
    found = chromium()
    assert found is not None, "no Chromium on the path; install one (Debian: apt-get install chromium)"
    with sync_playwright() as driver:
        opened = driver.chromium.launch(executable_path=found, args=["--no-sandbox"])
        yield opened
        opened.close()


@pytest.fixture(scope="session")
def reports(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Reports of sample missions, as files."""
    folder = tmp_path_factory.mktemp("reports")
    files = {name: folder / f"{name}.html" for name in ("site", "reunite", "restaurants", "wind_farm")}
    for name, file in files.items():
        file.write_text(report_html(plan(sample_file(name))), encoding="utf-8")
    return files


Opener = Callable[..., Page]


@pytest.fixture
def opened(browser: Browser, reports: dict[str, Path]) -> Iterator[Opener]:
    """
    Opens the report of a sample in a browser of its own.

    When the test is over, the page must have complained of nothing, asked for nothing but itself, and tried nothing that its policy
    forbids.
    """
    complaints: list[str] = []
    contexts = []

    def open_report(
        sample: str = "site", *, width: int = 1400, height: int = 900, script: bool = True, dark: bool = False
    ) -> Page:
        context = browser.new_context(
            viewport={"width": width, "height": height},
            java_script_enabled=script,
            color_scheme="dark" if dark else "light",
        )
        contexts.append(context)
        page = context.new_page()
        page.add_init_script(LISTEN)
        page.on("console", lambda message: complaints.append(message.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on("dialog", lambda dialog: complaints.append(dialog.message))
        address = reports[sample].as_uri()
        page.on("request", lambda request: complaints.append(request.url) if request.url != address else None)
        page.goto(address)
        return page

    yield open_report
    for context in contexts:
        for page in context.pages:
            complaints.extend(page.evaluate("window.refused || []"))
        context.close()
    assert complaints == []
