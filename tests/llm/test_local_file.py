"""A path that is no model is refused before any engine is asked, with the file named."""

from __future__ import annotations

from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.llm.local import LocalModel
from missiontree.llm.local_file import model_files


def gguf(path: Path) -> Path:
    path.write_bytes(b"GGUF and more")
    return path


def test_a_gguf_file_is_taken_whatever_it_is_called(tmp_path: Path) -> None:
    for name in ("model.gguf", "model.bin", "no ending", "ü;'.GGUF", "model-1-of-2.gguf"):
        file = gguf(tmp_path / name)
        assert model_files(file) == (file,)


def test_a_relative_path_is_made_absolute(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The engine takes a lone folder name for a name at a hub."""
    file = gguf(tmp_path / "model.gguf")
    monkeypatch.chdir(tmp_path)
    assert model_files(Path("model.gguf")) == (file,)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (None, "no such file"),
        (b"", "not a GGUF file"),
        (b"GGU", "not a GGUF file"),
        (b"\x80\x02}q\x00", "not a GGUF file"),
        (b'{"model_type": "llama"}', "not a GGUF file"),
    ],
)
def test_what_is_no_model_is_refused_with_its_name(tmp_path: Path, content: bytes | None, says: str) -> None:
    file = tmp_path / "model.gguf"
    if content is not None:
        file.write_bytes(content)
    with pytest.raises(InputError, match=says) as raised:
        LocalModel(file)
    assert raised.value.file == str(file)
    assert "GGUF" in raised.value.accepted
    assert "nothing is downloaded" in raised.value.hint


def test_a_folder_is_no_model(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be read"):
        LocalModel(tmp_path)


def test_a_path_that_cannot_be_one_is_refused() -> None:
    with pytest.raises(InputError, match="no path"):
        LocalModel("a\0b")


def test_all_parts_are_found_by_any_of_them(tmp_path: Path) -> None:
    parts = tuple(gguf(tmp_path / f"big-{number:05d}-of-00003.gguf") for number in (1, 2, 3))
    for part in parts:
        assert model_files(part) == parts


def test_a_part_that_is_missing_is_named(tmp_path: Path) -> None:
    first = gguf(tmp_path / "big-00001-of-00002.gguf")
    with pytest.raises(InputError, match="no such file") as raised:
        model_files(first)
    assert raised.value.file == str(tmp_path / "big-00002-of-00002.gguf")
