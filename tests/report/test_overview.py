"""The list of exercises at 80 columns."""

from __future__ import annotations

from typing import TYPE_CHECKING

from course.report.exercise_text import ExerciseRow, render_list

if TYPE_CHECKING:
    from tests.report.conftest import Page

ROWS = [
    ExerciseRow("12 A node", "12-print-forever", "Print forever", "passed", best=5, most=5),
    ExerciseRow("18 Publishers", "18-publisher", "A publisher", "tried", current=True, best=1.5, most=8),
    ExerciseRow("18 Publishers", "18-subscriber", "A title that is much too long " * 4, "begun"),
    ExerciseRow("20 Services", "20-server", "A server [bold]\x1b[31m", "new"),
]


def test_states_points_and_the_current_one(page: Page) -> None:
    render_list(page.console, ROWS)
    assert page.lines[0] == "12 A node"
    assert page.lines[1].split() == ["ok", "12-print-forever", "Print", "forever", "5", "of", "5"]
    assert page.lines[3].startswith("> no  18-publisher ")
    assert page.lines[3].endswith("  1.5 of 8")
    assert page.lines[4].startswith("  ..  18-subscriber ")
    assert page.lines[6].split() == ["20-server", "A", "server", "[bold]"]


def test_chapters_head_their_exercises_once(page: Page) -> None:
    render_list(page.console, ROWS)
    assert page.text.count("18 Publishers") == 1


def test_it_fits_and_counts(page: Page) -> None:
    render_list(page.console, ROWS)
    assert max(map(len, page.lines)) <= 80
    assert page.lines[-2] == "1 of 4 passed."


def test_an_empty_course_is_no_crash(page: Page) -> None:
    render_list(page.console, [])
    assert "0 of 0 passed." in page.text


def test_a_chapter_without_exercises_has_its_place(page: Page) -> None:
    render_list(page.console, ROWS, ["12 A node", "15 Why", "18 Publishers", "20 Services", "36 The end"])
    heads = [line for line in page.lines if line[:1].isdigit()]
    assert heads[:-1] == ["12 A node", "15 Why", "18 Publishers", "20 Services", "36 The end"]
    assert page.lines[3].strip().startswith("only to read")
    assert page.text.count("only to read") == 2
