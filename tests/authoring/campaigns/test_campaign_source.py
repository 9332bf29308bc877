"""The state of a campaign belongs to the files that it may come to use, and to no others."""

from __future__ import annotations

from pathlib import Path

import pytest

import benchmarks.campaign_source
from benchmarks.campaign_source import source_digest, source_files

FILES = {
    "start.py": "from benchmarks.near import thing\nimport benchmarks.inner.deep\nimport os\n",
    "near.py": "def thing():\n    from benchmarks import late\n",
    "late.py": "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from benchmarks import typed\n",
    "typed.py": "",
    "far.py": "",
    "inner/__init__.py": "",
    "inner/deep.py": "",
    "inner/words.yaml": "one: two\n",
    "inner/other.py": "",
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A package of a few files that takes the place of the commands."""
    for name, text in FILES.items():
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    monkeypatch.setitem(benchmarks.campaign_source.ROOTS, "benchmarks", tmp_path)
    return tmp_path


def test_what_is_imported_anywhere_counts_and_so_does_data_beside_it(folder: Path) -> None:
    """Imports within functions count, and the packages above a module; imports for types alone do not."""
    found = {path.relative_to(folder).as_posix() for path in source_files(folder / "start.py")}
    assert found == {"start.py", "near.py", "late.py", "inner/__init__.py", "inner/deep.py", "inner/words.yaml"}


@pytest.mark.parametrize("name", FILES)
def test_only_what_counts_changes_the_digest(folder: Path, name: str) -> None:
    before = source_digest(folder / "start.py")
    (folder / name).write_text(FILES[name] + "# more\n", encoding="utf-8")
    assert (source_digest(folder / "start.py") != before) == (folder / name in source_files(folder / "start.py"))


def test_a_campaign_of_schedulers_has_nothing_to_do_with_pages() -> None:
    found = source_files(Path(benchmarks.campaign_source.__file__).with_name("scheduling_agreement.py"))
    folders = {path.parent.name for path in found}
    assert {"scheduling", "enumeration", "cpsat", "checking", "rechecking", "mission"} <= folders
    assert not {"reporting", "cli", "authoring"} & folders
