"""The legend explains what is drawn, and nothing else."""

from __future__ import annotations

from missiontree.reporting.tree.legend import BETWEEN, LEAST_WIDTH, Entry, in_lines, legend_lines, legend_of, width_of
from tests.reporting.tree_builders import routine, shape, step, task


def signs(*args: object, **kwargs: object) -> list[str]:
    return [entry.sign for entry in legend_of(*args, **kwargs)]  # type: ignore[arg-type]


def test_a_single_node_needs_no_legend() -> None:
    assert signs(shape(routine("x")), has_order=False) == []


def test_gates_links_frames_and_columns_that_are_drawn_are_explained() -> None:
    assert signs(shape(task("a", routine("b"), routine("c"))), has_order=False) == ["and"]
    assert signs(shape(task("a", routine("b"), gate="xor")), has_order=False) == ["xor"]
    assert signs(shape(task("a", routine("b"))), has_order=False) == []
    linked = shape(
        task("a", routine("b"), routine("c")), [("b", "c", "until"), ("c", "b", "same_robot")], frames=("b",)
    )
    assert signs(linked, has_order=False) == ["and", "same_robot", "until", "frame"]
    assert signs(shape(task("a", step("b"), step("c"))), has_order=True) == ["and", "precedence"]


def test_what_is_lit_and_what_is_not_are_explained() -> None:
    lit = shape(task("a", routine("b", state="lit"), state="lit"))
    assert signs(lit, has_order=False, chosen="alternative 1 of 4") == ["lit"]
    both = shape(task("a", routine("b", state="lit"), routine("c", state="quiet"), gate="xor", state="lit"))
    assert signs(both, has_order=False, chosen="alternative 1 of 4")[:2] == ["lit", "quiet"]


def test_folding_is_told() -> None:
    [entry] = legend_of(shape(task("a", hidden=9)), has_order=False, folded="9 of 10 nodes are folded")
    assert entry == Entry("pile", "9 of 10 nodes are folded")


def test_entries_fill_lines_no_wider_than_the_tree() -> None:
    entries = [Entry("and", "x" * 30) for _ in range(7)]
    for width in (0.0, 700.0, 5000.0):
        lines = in_lines(entries, width)
        assert [entry for line in lines for entry in line] == entries
        assert width_of(lines) <= min(max(width, LEAST_WIDTH), 1100)
    # each is 48 + 30 · 0.62 · 11 = 252.6 wide, so two of them and what is between fit into 560, not three
    assert 2 * entries[0].width + BETWEEN < 560 < 3 * entries[0].width + 2 * BETWEEN
    assert list(map(len, in_lines(entries, 0))) == [2, 2, 2, 1]


def test_an_entry_wider_than_a_line_has_a_line_of_its_own() -> None:
    lines = in_lines([Entry("and", "short"), Entry("pile", "x" * 200), Entry("xor", "short")], 0)
    assert list(map(len, lines)) == [1, 1, 1]
    assert in_lines([], 100) == []
    assert width_of([]) == 0


def test_every_entry_is_written_with_its_sign() -> None:
    kinds = ("lit", "quiet", "and", "xor", "precedence", "same_robot", "different_robot", "until", "frame", "pile")
    for kind in kinds:
        with_sign = list(legend_lines([[Entry(kind, "meaning")]], 0, 0))
        assert with_sign[-1].endswith(">meaning</text>")
        assert len(with_sign) >= 2
