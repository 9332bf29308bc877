"""Room for words."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.reporting.text_box import ELLIPSIS, balanced, text_width, wrapped


def test_width_grows_with_the_letters_and_the_size() -> None:
    # three letters of 0.62 at size 10
    assert text_width("abe", 10) == pytest.approx(18.6)
    assert text_width("ill", 10) < text_width("abe", 10) < text_width("MWM", 10)
    # a full-width character is as wide as it is high, a combining one adds nothing
    assert text_width("母", 10) == 10
    assert text_width("e\u0301", 10) == text_width("e", 10)


def test_words_are_broken_at_blanks() -> None:
    # "aaa bbb" is 6 * 0.62 + 0.4 = 4.12 wide at size 1, too much for 4
    assert wrapped("aaa bbb aaa", 1, 4, 9) == ["aaa", "bbb", "aaa"]
    assert wrapped("aaa bbb aaa", 1, 4.2, 9) == ["aaa bbb", "aaa"]


def test_long_words_are_cut_after_a_bracket_or_anywhere() -> None:
    assert wrapped("aaa(bbb)", 1, 3, 9) == ["aaa(", "bbb)"]
    assert wrapped("aaabbb", 1, 1.9, 9) == ["aaa", "bbb"]
    assert wrapped("_aaWW", 1, 3, 9) == ["_", "aaW", "W"]  # after the first cut, "aaWW" of 3.2 is still too wide


def test_what_is_left_out_is_marked() -> None:
    assert wrapped("aaa bbb aaa", 1, 2.5, 2) == ["aaa", "bbb" + ELLIPSIS]
    assert wrapped("aaa bbb aaa", 1, 1.9, 2) == ["aaa", "bb" + ELLIPSIS]


def test_no_words_are_one_empty_line() -> None:
    assert wrapped("  ", 1, 5, 3) == [""]


@given(st.text(alphabet="abW(, _母"), st.integers(3, 12), st.integers(1, 5))
def test_lines_fit_and_lose_nothing_unless_they_say_so(text: str, width: int, most: int) -> None:
    lines = wrapped(text, 1, width, most)
    assert 1 <= len(lines) <= most
    assert all(text_width(line, 1) <= width + 1e-9 for line in lines)
    if not lines[-1].endswith(ELLIPSIS):
        assert "".join(lines).replace(" ", "") == text.replace(" ", "")


def test_no_word_is_left_alone_if_the_lines_before_can_spare_one() -> None:
    # 8 letters of 0.62 and two blanks are 5.8 wide at size 1: all but the last word would fit into one line of 6
    assert wrapped("aaa aaa aa b", 1, 6, 9) == ["aaa aaa aa", "b"]
    assert balanced("aaa aaa aa b", 1, 6, 9) == ["aaa aaa", "aa b"]


def test_lines_rather_end_with_a_comma_and_keep_numbers_with_their_words() -> None:
    assert balanced("mooring lines, berth 3", 13, 150, 9) == ["mooring lines,", "berth 3"]
    # "to berth" and "3 and bring it" would be nearer to each other
    assert balanced("Go to berth 3 and bring it", 13, 150, 9) == ["Go to berth 3", "and bring it"]


@given(st.text(alphabet="abW(, _3母"), st.integers(3, 12), st.integers(1, 5))
def test_balanced_lines_are_as_many_and_say_the_same(text: str, width: int, most: int) -> None:
    lines, even = wrapped(text, 1, width, most), balanced(text, 1, width, most)
    assert len(even) == len(lines)
    assert "".join(even).replace(" ", "") == "".join(lines).replace(" ", "")
    assert all(text_width(line, 1) <= width + 1e-9 for line in even)
