"""The solution as a diff: the learner's own text is in it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from course.report.exercise_text import render_diff

if TYPE_CHECKING:
    from tests.report.conftest import Page

DIFF = "--- your a.py\n+++ reference a.py\n@@ -1 +1 @@\n-x = 1\n+\tx = 2\n"


def test_a_diff_is_shown_line_by_line(page: Page) -> None:
    assert render_diff(page.console, [("a.py", DIFF)])
    assert page.lines[:3] == ["--- your a.py", "+++ reference a.py", "@@ -1 +1 @@"]
    assert "-x = 1" in page.lines and "+   x = 2" in page.lines


def test_the_same_files_are_named(page: Page) -> None:
    assert not render_diff(page.console, [("a.py", "")])
    assert page.lines == ["a.py: the same as the reference"]


def test_lines_are_coloured_by_their_sign(colour_page: Page) -> None:
    render_diff(colour_page.console, [("a.py", DIFF)])
    assert "\x1b[31m-x = 1" in colour_page.text
    assert "\x1b[32m+   x = 2" in colour_page.text


def test_hostile_files_do_nothing(page: Page) -> None:
    hostile = "-\x1b]0;t\x07x\x0cy\u2028z\r" + "w" * 10_000 + "\n"
    render_diff(page.console, [("a.py", hostile), ("a\nb\x1b[2J.py", "")])
    assert page.lines[0].startswith("-x\\x0cy\\u2028z\\r")
    assert len(page.lines[0]) < 3000
    assert "a\\nb.py: the same as the reference" in page.lines
