from missiontree.mission.spent import Spent
from missiontree.reporting.spent_view import author_in_words


def test_what_a_dialogue_took_in_a_line() -> None:
    spent = Spent(turns=4, calls=7, refused=1, input_tokens=5210, output_tokens=430, seconds=12.34, cost_usd=0.01234)
    assert author_in_words("openai", "gpt-x", spent) == (
        "openai gpt-x: 4 turns, 7 calls (1 refused), 5210 + 430 tokens, 12.3 s, 0.0123 US dollars"
    )


def test_what_is_not_known_is_said_so() -> None:
    spent = Spent(turns=1, calls=1, input_tokens=3, output_tokens=2, estimated=True)
    assert author_in_words("scripted", "", spent) == "scripted: 1 turn, 1 call, about 3 + 2 tokens, cost not known"
