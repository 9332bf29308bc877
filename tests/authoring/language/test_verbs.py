"""English verbs that are known to be verbs."""

from __future__ import annotations

from missiontree.authoring.language.verbs import english_verbs


def test_verbs_of_one_word() -> None:
    verbs = english_verbs()
    assert {"wax", "paint", "pump", "sample", "weld", "find"} <= verbs
    assert not {"skis", "please", "the", "want"} & verbs  # "wants the keys" is a need, and "please" is polite
    assert all(verb.isascii() and verb.isalpha() and verb.islower() for verb in verbs)
