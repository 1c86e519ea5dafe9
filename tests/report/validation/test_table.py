"""The table of proofs and the list of findings, as plain text."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from course.report.validation import Count, Note, ProofRow, render_end, render_notes, render_table

ONE = Count(1, 1, 1)
SOUND = ProofRow("04-light", ONE, Count(2, 2, 2), ONE, Count(9, 9, 9), 4, 4, 12, 83.25)
BROKEN = ProofRow("04-dim", Count(0, 1, 1), Count(), Count(0, 0, 1), Count(7, 8, 9), 3, 4, 2.5, 10)
LACKING = ProofRow(
    "04-far", Count(0, 0, 1), Count(), Count(0, 0, 1), Count(), 0, 0, None, 0, "There is no ROS."
)
HOSTILE = "a\x1b[2J\nb\u202ec"


@pytest.fixture
def console() -> Console:
    return Console(file=io.StringIO(), width=80, force_terminal=False, highlight=False)


def lines(console: Console) -> list[str]:
    assert isinstance(console.file, io.StringIO)
    return console.file.getvalue().splitlines()


def test_a_row_for_each_exercise_and_their_sum(console: Console) -> None:
    render_table(console, [SOUND, BROKEN, LACKING])
    head, sound, broken, lacking, whole = (line.split() for line in lines(console))
    assert head[0] == "exercise" and head[-1] == "seconds"
    assert sound == ["04-light", "ok", "2/2", "ok", "9/9", "4/4", "12", "83.2"]
    assert broken == ["04-dim", "no", "-", "..", "7/9", "3/4", "2.5", "10.0"]
    assert lacking == ["04-far", "not", "here"]
    assert whole == ["in", "all", "1/3", "2/2", "1/3", "16/18", "7/8", "14.5", "93.2"]


def test_nothing_is_cut_at_80_columns(console: Console) -> None:
    long = ProofRow("24-inspect-parameters", ONE, ONE, ONE, Count(40, 40, 40), 12, 12, 12, 1234.5)
    render_table(console, [long, long])
    assert lines(console)[0].split()[-1] == "seconds" and "1234.5" in lines(console)[1]
    assert lines(console)[1].startswith("24-inspect-parameters ")


def test_one_exercise_needs_no_sum(console: Console) -> None:
    render_table(console, [SOUND], again=2)
    assert "in all" not in " ".join(lines(console))
    assert lines(console)[-2].startswith("2 gradings were done again")


def test_findings_stand_below_their_file_in_the_order_of_lines(console: Console) -> None:
    notes = [
        Note("b.yaml", 9, "It is late.", "come earlier"),
        Note("a.yaml", None, "It is all wrong.", None),
        Note("b.yaml", 3, "It is early.", None),
    ]
    render_notes(console, notes)
    assert lines(console) == [
        "",
        "a.yaml",
        "        It is all wrong.",
        "",
        "b.yaml",
        "     3  It is early.",
        "     9  It is late.",
        "        try  come earlier",
    ]


def test_texts_of_a_course_are_harmless(console: Console) -> None:
    render_notes(console, [Note(HOSTILE, 1, HOSTILE, HOSTILE)])
    render_end(console, 1, [ProofRow(HOSTILE, *[ONE] * 4, 1, 1, 1, 1, HOSTILE)])
    assert not {"\x1b", "\u202e"} & set("".join(lines(console)))


@pytest.mark.parametrize(
    ("found", "rows", "stopped", "words"),
    [
        (0, [SOUND], False, "All proofs hold."),
        (2, [BROKEN], False, "2 problems were found."),
        (1, [], False, "1 problem was found."),
        (0, [], False, "No problems were found."),
        (0, [SOUND, LACKING], False, "13 of 15 proofs are done, and hold."),
        (0, [LACKING], False, "Not available here: 04-far. There is no ROS."),
        (1, [BROKEN], True, "Stopped: 9 of 11 proofs were known."),
    ],
)
def test_the_end_says_how_it_ended(
    console: Console, found: int, rows: list[ProofRow], stopped: bool, words: str
) -> None:
    render_end(console, found, rows, stopped=stopped)
    assert words in lines(console)
