"""A submission's text must neither control the terminal nor flood the reader."""

import pytest

from course.report import sanitize


@pytest.mark.parametrize(
    ("hostile", "shown"),
    [
        ("\x1b[31mred\x1b[0m", "red"),
        ("\x1b]0;new title\x07after", "after"),
        ("\x1b]8;;http://evil\x1b\\link\x1b]8;;\x1b\\", "link"),
        ("\x1b]52;c;ZXZpbA==\x07x", "x"),
        ("\x1bPq#0\x1b\\x", "x"),
        ("\x1b[2J\x1b[Hgone", "gone"),
        ("\x9b31mred", "red"),
        ("\x1b[?1049h", ""),
        ("\x1bc", ""),
        ("a\x1b", "a"),
        ("bell\x07", "bell\\x07"),
        ("back\x08space", "back\\x08space"),
        ("over\rwritten", "over\\rwritten"),
        ("\u202egnp.exe", "\\u202egnp.exe"),
        ("a\u2028b", "a\\u2028b"),
        ("half \ud800", "half \\ud800"),
        ("nul\x00", "nul\\x00"),
        ("del\x7f", "del\\x7f"),
        ("tab\tend", "tab end"),
        ("[bold]plain[/bold] :smile:", "[bold]plain[/bold] :smile:"),
        ("Ἕν οἶδα 你好", "Ἕν οἶδα 你好"),
    ],
)
def test_controls_are_removed_or_shown(hostile: str, shown: str) -> None:
    assert sanitize.clean(hostile) == shown


def test_an_unfinished_sequence_swallows_only_its_line() -> None:
    assert sanitize.clean("\x1b]0;never ended\nnext line").endswith("\nnext line")


def test_newlines_of_two_kinds_stay() -> None:
    assert sanitize.clean("a\r\nb\nc") == "a\nb\nc"


def test_one_line_shows_newlines() -> None:
    assert sanitize.one_line("a\nb.py") == "a\\nb.py"


def test_overlong_lines_are_cut_and_counted() -> None:
    shown = sanitize.one_line("x" * 1_000_000, limit=100)
    assert shown == "x" * 100 + "... (999900 more characters)"


def test_a_paragraph_is_one_flow_of_words() -> None:
    assert sanitize.paragraph("  one\n\n  two\tthree ") == "one two three"


def test_long_evidence_keeps_both_ends() -> None:
    shown = sanitize.details((str(number) for number in range(1000)), most=10)
    assert shown[:5] == ["0", "1", "2", "3", "4"]
    assert shown[5] == "... 990 more lines ..."
    assert shown[-1] == "999"
    assert len(shown) == 11


def test_evidence_with_newlines_inside_is_split() -> None:
    assert sanitize.details(["a\nb", "", "c"]) == ["a", "b", "", "c"]
