"""Templates, the page's policy and its data: words stay words."""

from __future__ import annotations

import json

import pytest
from jinja2 import UndefinedError
from markupsafe import Markup

from missiontree.reporting.html.data_island import island
from missiontree.reporting.html.page import filled
from missiontree.reporting.html.policy import policy


def test_words_in_a_template_are_escaped_and_harmless() -> None:
    shown = filled("damaged.html.j2", message="<b>\x1b[31m\u202ered</b> & 'so'")
    assert shown == '<p style="white-space:pre-line" dir="auto">&lt;b&gt;red&lt;/b&gt; &amp; &#39;so&#39;</p>'


def test_markup_of_our_own_is_not_escaped_again() -> None:
    assert "<i>so</i>" in filled("damaged.html.j2", message=Markup("<i>so</i>"))


def test_what_is_not_given_is_not_passed_over() -> None:
    with pytest.raises(UndefinedError, match="message"):
        filled("damaged.html.j2")


@pytest.mark.parametrize("value", [None, 0.1, True, ["list"]])
def test_what_is_no_text_is_refused(value: object) -> None:
    with pytest.raises(TypeError, match="give it text"):
        filled("damaged.html.j2", message=value)


def test_data_for_the_script_cannot_end_its_element() -> None:
    data = {"name": "</script><!-- & \u2028 \ud800"}
    text = island(data)
    assert not {"<", ">", "&", "\u2028"} & set(text)
    assert text.isascii()
    assert json.loads(text) == data


def test_the_policy_is_that_of_known_content() -> None:
    """The digests of the empty text and of 'a', as every other implementation of SHA-256 has them."""
    empty = "47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU="
    letter = "ypeBEsobvcr6wjGzmiPcTaeG7/gUfE5yuYB3ha/uSLs="
    assert policy("", "a") == (
        f"default-src 'none'; style-src 'sha256-{empty}'; script-src 'sha256-{letter}'; base-uri 'none'; form-action 'none'"
    )
