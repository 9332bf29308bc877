"""Photographs of a report for the README, taken in a real browser without a window."""

from __future__ import annotations

import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from playwright.sync_api import Browser, sync_playwright

from missiontree import plan
from missiontree.cli.pictures import report_of
from missiontree.samples.catalogue import sample_file
from scripts.gallery_page import DARK, LIGHT
from tests.browser.chromium import chromium

SAMPLE = "clinic"
SET = """(slider, share) => {
  slider.value = share * slider.max;
  slider.dispatchEvent(new Event("input", { bubbles: true }));
}"""


@dataclass(frozen=True, slots=True)
class Shot:
    """
    A window that a report is seen through.

    Parameters
    ----------
    file
        Where the picture goes, from the folder ``docs``.
    width, height
        Size of the window in pixels of the page.
    scheme
        Light or dark.
    density
        Pixels of the picture per pixel of the page. Default 1.
    section
        Id of the section that is scrolled to; empty (default) stays at the top.
    share
        Where the clock of the mission stands, from 0 (default), its beginning, to 1, its end.
    """

    file: str
    width: int
    height: int
    scheme: Literal["light", "dark"]
    density: float = 1.0
    section: str = ""
    share: float = 0.0


SHOTS = (Shot(LIGHT, 1280, 960, "light"), Shot(DARK, 390, 844, "dark", 2.0, "map", 0.4))


def photograph(docs: Path) -> None:
    """
    Open the report of a sample in Chromium and keep what is seen of it.

    Raises
    ------
    SystemExit
        If the machine has no Chromium.
    """
    found = chromium()
    if found is None:
        sys.exit("There is no Chromium on the path. Install one (Debian: apt-get install chromium).")
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        report = Path(folder) / "report.html"
        report.write_text(report_of(plan(sample_file(SAMPLE))), encoding="utf-8")
        browser = driver.chromium.launch(executable_path=found, args=["--no-sandbox"])
        for shot in SHOTS:
            (docs / shot.file).write_bytes(_seen(browser, report, shot))
        browser.close()


def _seen(browser: Browser, report: Path, shot: Shot) -> bytes:
    context = browser.new_context(
        viewport={"width": shot.width, "height": shot.height},
        color_scheme=shot.scheme,
        device_scale_factor=shot.density,
        reduced_motion="reduce",
    )
    page = context.new_page()
    page.goto(report.as_uri())
    if shot.share:
        page.locator("#time").evaluate(SET, shot.share)
    if shot.section:
        page.locator(f"#{shot.section}").evaluate("(section) => section.scrollIntoView()")
    taken = page.screenshot()
    context.close()
    return taken
