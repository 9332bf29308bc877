"""Where the slots of a pattern are in the words of a clause."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from missiontree.authoring.language.lexicon import Verb
from missiontree.mission.pattern import Form

Span = tuple[int, int]
IsPhrase = Callable[[int, int], bool]


def matches(
    form: Form, words: Sequence[str], verb: Verb, phrases_of: Mapping[str, tuple[str, ...]], is_phrase: IsPhrase
) -> dict[str, Span] | None:
    """
    Where the slots of a form are, if the words are wholly of that form; None if they are not.

    Parameters
    ----------
    form
        The form.
    words
        The clause in small letters, the verb in its base form.
    verb
        The verb it begins with.
    phrases_of
        Verbs by goal.
    is_phrase
        Whether the words from one index up to another are somebody or something.
    """
    failed: set[tuple[int, int]] = set()
    spans: dict[str, Span] = {}

    def fits(at: int, start: int) -> bool:
        if at == len(form):
            return start == len(words)
        if (at, start) in failed:
            return False
        for end in _ends(form, at, start, words, verb, phrases_of):
            if form[at].kind == "slot" and not is_phrase(start, end):
                continue
            if fits(at + 1, end):
                if form[at].kind == "slot":
                    spans[form[at].text] = (start, end)
                return True
        failed.add((at, start))
        return False

    return spans if fits(0, 0) else None


def _ends(
    form: Form, at: int, start: int, words: Sequence[str], verb: Verb, phrases_of: Mapping[str, tuple[str, ...]]
) -> Iterator[int]:
    """Where the element may end."""
    element = form[at]
    if element.kind == "goal":
        if start == 0 and verb.phrase in phrases_of.get(element.text, ()):
            yield verb.length
    elif element.kind == "slot":
        last = at + 1 == len(form)
        following = form[at + 1] if not last else None
        for end in (len(words),) if last else range(start + 1, len(words)):
            if following is None or following.kind != "word" or words[end] in following.text.split("|"):
                yield end
    elif start < len(words):
        word = words[start]
        if word.endswith("ing") if element.kind == "doing" else word in element.text.split("|"):
            yield start + 1
