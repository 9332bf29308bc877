"""Flexible job shops: what they become, and how whatever is wrong with one is said."""

from __future__ import annotations

from pathlib import Path

import pytest

from missiontree.errors import InputError
from missiontree.formats.importers.fjsp import looks_like_shop, read_shop, shop_of
from missiontree.formats.importers.tree_grounded import fleet_of, grounded_of
from missiontree.mission.columns import AND, LEAF, XOR

TWO_JOBS = "2 2\n2  2 0 3 1 4  1 1 2\n1  1 0 5\n"


def test_a_job_is_a_chain_of_choices_over_machines() -> None:
    tree = shop_of(TWO_JOBS)
    assert tree.kind == [AND, AND, XOR, LEAF, LEAF, XOR, LEAF, AND, XOR, LEAF]
    assert tree.parent == [-1, 0, 1, 2, 2, 1, 5, 0, 7, 8]
    assert [tree.robot[leaf] for leaf in (3, 4, 6, 9)] == [0, 1, 1, 0]
    assert [tree.duration[leaf] for leaf in (3, 4, 6, 9)] == [3, 4, 2, 5]
    assert tree.precedence == [(2, 5)]
    assert (tree.label(4), tree.label(2), tree.robot_id(1)) == (
        "Operation 1 of job 1 on machine 1",
        "Operation 1 of job 1",
        "machine-1",
    )


def test_machines_from_one_and_an_average_and_empty_lines_are_understood() -> None:
    one = shop_of("2 2 1.5\n\n2 2 1 3 2 4 1 2 2\r\n1 1 1 5\n\n")
    assert (one.robot, one.duration) == (shop_of(TWO_JOBS).robot, shop_of(TWO_JOBS).duration)
    assert one.robot_id(0) == "machine-1"


def test_as_a_grounded_tree_a_machine_is_a_type_of_one_and_an_operation_a_role_of_its_own() -> None:
    tree = shop_of(TWO_JOBS)
    assert [(kind.id, kind.count) for kind in fleet_of(tree).types] == [("machine-0", 1), ("machine-1", 1)]
    grounded = grounded_of(tree)
    assert len(grounded.roles) == 4
    assert (grounded.action(4).robot_type, grounded.action(4).duration_s) == ("machine-1", 4.0)


def test_a_file_is_known_by_its_first_line() -> None:
    assert looks_like_shop(TWO_JOBS)
    assert looks_like_shop("10 6 2.0\n")
    assert not looks_like_shop('{"kind": [0]}')
    assert not looks_like_shop("mission: 3 4\n")
    assert not looks_like_shop("- 1\n- 2\n")


@pytest.mark.parametrize(
    "text",
    [
        TWO_JOBS.replace("\n", "\r\n"),
        TWO_JOBS.replace("\n", "\r"),
        "\ufeff" + TWO_JOBS,
        "\ufeff# a comment\r\n\r\n" + TWO_JOBS,
        TWO_JOBS.replace("\n", "  # what follows is no number\n"),
    ],
)
def test_line_ends_marks_and_comments_of_every_kind_are_read(text: str) -> None:
    assert looks_like_shop(text)
    assert shop_of(text) == shop_of(TWO_JOBS)


@pytest.mark.parametrize("head", ["1", "1 1 1 1", "-1 2", "3, 2", "3 2 1,5", "2 two"])
def test_a_file_that_begins_with_a_number_is_refused_as_a_job_shop(head: str) -> None:
    text = f"# a comment\n{head}\n1 1 0 5\n"
    assert looks_like_shop(text)
    with pytest.raises(InputError) as refused:
        shop_of(text, "shop.txt")
    assert (refused.value.line, f"the first line reads {head!r}" in str(refused.value)) == (2, True)
    assert "the numbers of jobs and of machines" in str(refused.value)


CLASSIC = "2 3\n0 3 1 4 2 5\n2 1 0 2 1 6\n"


@pytest.mark.parametrize(
    "text",
    [CLASSIC, "# two jobs\n#\n" + CLASSIC, "2 3\n1 3 2 4 3 5\n# the second\n3 1 1 2 2 6"],
)
def test_a_classic_job_shop_has_one_machine_for_each_operation(text: str) -> None:
    assert looks_like_shop(text)
    tree = shop_of(text)
    leaves = [node for node, kind in enumerate(tree.kind) if kind == LEAF]
    assert [(tree.robot[leaf], tree.duration[leaf]) for leaf in leaves] == [
        (0, 3),
        (1, 4),
        (2, 5),
        (2, 1),
        (0, 2),
        (1, 6),
    ]
    assert tree.precedence == [(2, 4), (4, 6), (9, 11), (11, 13)]


def test_what_can_be_read_as_flexible_is() -> None:
    """One job, six numbers: one operation on machine 0 or 2, or machine 1 for 2 s, 0 for 5 s, and 2 for 6 s? The first."""
    tree = shop_of("1 3\n1 2 0 5 2 6\n")
    assert [tree.duration[leaf] for leaf, kind in enumerate(tree.kind) if kind == LEAF] == [5, 6]


@pytest.mark.parametrize(
    ("text", "line", "said"),
    [
        ("2 3\n0 3 1 4 1 5\n2 1 0 2 1 6\n", 2, "machine 1 is named twice in the line of job 1"),
        ("2 3\n0 3 1 4 2 5\n2 1 0 2 3 6\n", 3, "machine 3, and there are 3 in the line of job 2"),
        ("2 3\n0 3 1 4 2 5\n2 1 0 2 1\n", 3, "5 numbers for 3 machines in the line of job 2"),
        ("2 3\n0 3 1 4 2 5\n2 1 0 x 1 6\n", 3, "'x' is not a whole number in the line of job 2"),
        ("2 3\n0 3 1 4 2 5\n2 1 0 2000000000 1 6\n", 3, "time 2000000000 for operation 2 of job 2"),
        ("2 3\n0 3 1 4 2 5\n", 2, "the file ends after 1 of 2 jobs"),
        ("1 1\n1 1 0 99999999999999999999\n", 2, "'99999999999999999999' is too large"),
    ],
)
def test_what_is_wrong_with_a_classic_line_is_said(text: str, line: int, said: str) -> None:
    with pytest.raises(InputError) as caught:
        shop_of(text, "shop.txt")
    assert said in caught.value.message
    assert caught.value.line == line


@pytest.mark.parametrize(
    ("text", "line", "said"),
    [
        ("", 0, "the file is empty"),
        ("2\n", 1, "the first line reads '2'"),
        ("2 x\n", 1, "the first line reads '2 x'"),
        ("0 2\n", 1, "0 jobs"),
        ("2 0\n", 1, "0 machines"),
        ("2 100001\n", 1, "100001 machines"),
        ("2 2\n1 1 0 5\n", 2, "the file ends after 1 of 2 jobs"),
        ("1 2\n1 1 0 5\n1 1 0 5\n", 3, "a line follows the last of 1 jobs"),
        ("1 2\n0\n", 2, "job 1 has no operation"),
        ("1 2\n2 1 0 5\n", 2, "the line ends before operation 2 of job 1"),
        ("1 2\n1 2 0 5 1\n", 2, "the line ends within operation 1 of job 1, for which it announces 2 machines"),
        ("1 2\n1 1 0 5 7\n", 2, "1 number follows the last of 1 operations of job 1"),
        ("1 2\n1 1 0 5 7 8\n", 2, "2 numbers follow the last of 1 operations of job 1"),
        ("1 2\n1 0\n", 2, "no machine is able to do operation 1 of job 1"),
        ("1 2\n1 1 0 -5\n", 2, "'-5' is below 0"),
        ("1 2\n1 1 0 2.5\n", 2, "'2.5' is not a whole number"),
        ("1 2\n\n1 1 3 5\n", 3, "machine 3 for operation 1 of job 1, and there are 2"),
        ("1 2\n1 2 0 5 0 6\n", 2, "machine 0 is named twice for operation 1 of job 1"),
        ("2 2\n1 1 0 5\n1 1 2 5\n", 3, "both machine 0 (line 2) and machine 2 (line 3) are named"),
        ("1 2\n1 1 0 1000000001\n", 2, "time 1000000001 for operation 1 of job 1"),
        ("1 2\n1 1 0 5\0\n", 2, "the text holds a NUL character"),
    ],
)
def test_what_is_wrong_is_said_with_its_line(text: str, line: int, said: str) -> None:
    with pytest.raises(InputError) as caught:
        shop_of(text, "shop.txt")
    assert said in caught.value.message
    assert (caught.value.file, caught.value.line) == ("shop.txt", line)


def test_a_file_that_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no such file"):
        read_shop(tmp_path / "none.txt")
