"""The gallery shows what the package draws today."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from missiontree.reporting.png import size_of
from missiontree.samples.catalogue import SAMPLES, SETTINGS
from scripts.gallery import DOCS, main, not_current, write
from scripts.gallery_page import DARK, LIGHT, Gallery, gallery_of

PNG = b"\x89PNG\r\n\x1a\n"
PICTURE = re.compile(r"!\[([^\]]*)\]\(([^)]+)\)")


@pytest.fixture(scope="module")
def gallery() -> Gallery:
    return gallery_of()


def test_the_gallery_is_current(gallery: Gallery) -> None:
    """``python -m scripts.gallery`` renews it."""
    assert not_current(gallery.files, DOCS) == []


def test_every_sample_is_shown_with_its_command(gallery: Gallery) -> None:
    assert re.findall(r"^missiontree plan --sample (\w+)$", gallery.page, re.MULTILINE) == [
        "site",
        *sorted(SETTINGS),
        *(name for name in SAMPLES if name != "site" and name not in SETTINGS),
    ]


def test_settings_have_map_chart_and_tree_and_the_paper_has_chart_and_tree(gallery: Gallery) -> None:
    """11 settings with 3 pictures, 4 missions of the paper with 2; the fifth cannot be done and has none."""
    assert len(gallery.pictures) == 11 * 3 + 4 * 2
    assert "**Cannot be done.**" in gallery.page


def test_every_picture_is_embedded_once_and_has_words(gallery: Gallery) -> None:
    embedded = PICTURE.findall(gallery.page)
    assert sorted(path for _, path in embedded) == sorted(gallery.pictures)
    assert all(len(words) > 10 for words, _ in embedded)


def test_every_entry_of_the_table_leads_to_a_heading(gallery: Gallery) -> None:
    """GitHub makes an anchor of a heading: small letters, hyphens for blanks, no other signs."""
    headings = re.findall(r"^#+ (.+)$", gallery.page, re.MULTILINE)
    anchors = {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}
    assert len(targets := re.findall(r"\]\(#([^)]+)\)", gallery.page)) == 12
    assert set(targets) <= anchors


def test_charts_are_as_wide_as_the_page(gallery: Gallery) -> None:
    assert {size_of(svg)[0] for path, svg in gallery.pictures.items() if path.endswith("-gantt.svg")} == {880.0}


def test_a_changed_a_missing_and_a_forgotten_file_are_named(tmp_path: Path) -> None:
    files = {"gallery.md": "page\n", "pictures/gallery/a.svg": "<svg/>\n", "pictures/gallery/b.svg": "<svg/>\n"}
    write(files, tmp_path)
    assert not_current(files, tmp_path) == []
    (tmp_path / "gallery.md").write_bytes(b"page\r\n")
    (tmp_path / "pictures/gallery/a.svg").unlink()
    (tmp_path / "pictures/gallery/c.svg").write_text("<svg/>\n", encoding="utf-8")
    wrong = ["gallery.md", "pictures/gallery/a.svg", "pictures/gallery/c.svg"]
    assert not_current(files, tmp_path) == wrong
    write(files, tmp_path)
    assert not_current(files, tmp_path) == []


def test_the_check_writes_nothing_and_tells(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--check", "--docs", str(tmp_path)]) == 1
    told = capsys.readouterr()
    assert f"not current: {tmp_path.name}/gallery.md\n" in told.out
    assert "renews them" in told.err
    assert list(tmp_path.iterdir()) == []


def test_the_screenshots_are_there_and_small() -> None:
    """What they show depends on the fonts of a machine, so that their bytes are not compared."""
    for name in (LIGHT, DARK):
        taken = (DOCS / name).read_bytes()
        assert taken.startswith(PNG)
        assert len(taken) < 250_000


def test_all_pictures_together_are_small() -> None:
    assert sum(file.stat().st_size for file in (DOCS / "pictures").rglob("*") if file.is_file()) < 3_000_000
