"""Field meanings come out of NumPy docstrings as flowing Markdown."""

from missiontree.formats.docstring import described


class _Example:
    """
    The summary
    goes on.

    A second paragraph with :class:`missiontree.mission.fleet.Capability`.

    Parameters
    ----------
    first
        One ``code``
        in two lines.

        And a paragraph.
    second, third
        Shared.

    Raises
    ------
    ValueError
        Never.
    """


class _Bare:
    """Only a sentence."""


def test_sections_are_told_apart() -> None:
    about = described(_Example)
    assert about.summary == "The summary goes on.\n\nA second paragraph with Capability."
    assert about.fields == {
        "first": "One `code` in two lines.\n\nAnd a paragraph.",
        "second": "Shared.",
        "third": "Shared.",
    }


def test_a_docstring_without_sections() -> None:
    assert described(_Bare).summary == "Only a sentence."
    assert described(_Bare).fields == {}
