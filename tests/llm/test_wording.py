"""What is said of faults: in a sentence, bounded, on one line, without the key."""

from __future__ import annotations

from typing import get_args

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.llm.chat import FaultKind
from missiontree.llm.wording import LONGEST, Wording

WORDING = Wording("Somebody", "large-1", "the environment variable SOMEBODY_API_KEY", "s3cret-key")


@pytest.mark.parametrize("kind", get_args(FaultKind))
def test_every_kind_has_its_sentence(kind: FaultKind) -> None:
    fault = WORDING.fault(kind, "They say so.", 500, 3.0)
    assert fault.kind == kind
    assert str(fault).endswith(" (status 500): They say so.")
    assert fault.retry_after_s == 3.0
    assert "{" not in str(fault) + fault.hint


def test_silence_and_what_is_no_text_end_the_sentence() -> None:
    assert str(WORDING.fault("no_such_model", None)) == "Somebody has no model 'large-1'."
    assert str(WORDING.fault("no_such_model", {"message": "x"})) == "Somebody has no model 'large-1'."


def test_the_key_does_not_show() -> None:
    fault = WORDING.fault("unauthorised", "s3cret-key, s3cret-key!")
    assert str(fault) == "Somebody does not let this key use 'large-1': [key], [key]!"
    assert "SOMEBODY_API_KEY" in fault.hint
    assert "s3cret" not in repr(WORDING)


def test_a_model_that_bears_the_key_does_not_show_it() -> None:
    assert "s3cret" not in str(Wording("S", "s3cret-key", "", "s3cret-key").fault("no_such_model"))


def test_a_key_on_the_edge_of_what_is_shown_does_not_show_in_part() -> None:
    """Cut first and searched then, its first letters would stay."""
    assert "s3" not in str(WORDING.fault("failed", "x" * (LONGEST - 4) + "s3cret-key"))


@given(st.text(max_size=2 * LONGEST))
def test_whatever_they_say_it_is_one_bounded_line(words: str) -> None:
    shown = WORDING.seen(words)
    assert len(shown) <= LONGEST + 3
    assert shown.isprintable()
    assert WORDING.secret not in WORDING.seen(words + WORDING.secret)
