"""``missiontree show --why-so-long``: the chain of a schedule and what would shorten it, in words and as a document."""

from pathlib import Path

import pytest

from missiontree.formats.document import read_text, write_text
from tests.cli.running import Shell


@pytest.fixture
def harbour(shell: Shell) -> Shell:
    """A shell in a folder with the plan of the harbour, in which one more tug would help."""
    shell("plan", "--sample", "harbour", "--out", "plan.json", "--quiet")
    return shell


def test_it_is_told_why_and_what_would_shorten_it(harbour: Shell) -> None:
    shown = harbour("show", "plan.json", "--why-so-long")
    assert shown.code == 0, shown
    assert shown.out.startswith("Why alternative 1 takes 410.9 s: 110 s of work and 300.9 s on the way")
    assert "one more Tug like alba: 368.4 s instead of 410.9 s (proven shortest)" in shown.out


def test_the_same_is_a_document_that_can_be_read_again(harbour: Shell) -> None:
    shown = harbour("show", "plan.json", "--why-so-long", "--json", "--rank", "1")
    why = read_text(shown.out, "why_so_long")
    assert write_text(why, "why_so_long") == shown.out
    assert why.chain.work_s + why.chain.travel_s + why.chain.waiting_s == pytest.approx(why.chain.makespan_s)
    assert [dict(one.robots) for one in why.additions if one.verdict == "shorter"] == [{"tug": 1}]
    assert harbour("show", "plan.json", "--why-so-long", "--json").out == shown.out  # the same every time


def test_it_is_told_of_every_alternative_and_of_what_is_chosen_or_offered(shell: Shell) -> None:
    """Whatever else the plan ranks, offers or chooses, the larger team schedules this one alone."""
    shell("plan", "--sample", "site", "--objective", "makespan", "--front", "--out", "plan.json", "--quiet")
    second = shell("show", "plan.json", "--why-so-long", "--rank", "2")
    assert second.code == 0, second
    assert second.out.startswith("Why alternative 2 takes")
    chosen = shell("show", "plan.json", "--why-so-long")
    assert chosen.code == 0, chosen
    assert chosen.out.startswith("Why the option takes")
    assert chosen.out == shell("show", "plan.json", "--why-so-long", "--option", "chosen").out
    assert shell("show", "plan.json", "--view", "schedule").out.startswith("The option: utility")
    assert shell("show", "plan.json", "--view", "schedule", "--rank", "2").out.startswith("Alternative 2: utility")
    said = shell("show", "plan.json").out
    assert "Why the choice takes" in said
    assert "Why alternative" not in said
    shell("show", "plan.json", "--gantt", "chosen.svg")
    assert "Option · utility" in Path("chosen.svg").read_text(encoding="utf-8")


def test_with_no_time_the_chain_alone_is_told_and_that_nothing_was_tried(harbour: Shell) -> None:
    shown = harbour("show", "plan.json", "--why-so-long", "--time-limit", "0")
    assert shown.out.splitlines()[-1].strip() == "5 further additions were not tried, for want of time."
    assert "alba" in shown.out


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--rank", "9"), "--rank 9"),
        (("--time-limit", "-1"), "--time-limit -1"),
    ],
)
def test_what_cannot_be_told_is_refused(harbour: Shell, options: tuple[str, ...], said: str) -> None:
    shown = harbour("show", "plan.json", "--why-so-long", *options)
    assert shown.code == 2, shown
    assert said in shown.err


def test_a_declined_mission_has_no_length(shell: Shell, tmp_path: Path) -> None:
    shell("plan", "--sample", "restaurants", "--out", "plan.json", "--quiet")
    shown = shell("show", "plan.json", "--why-so-long")
    assert shown.code == 2, shown
    assert "--why-so-long: this plan has no schedule" in shown.err
    assert (tmp_path / "plan.json").exists()
