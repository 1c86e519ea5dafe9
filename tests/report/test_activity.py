"""What is shown while a check runs."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

import pytest

from course.report.activity import Tally, activity, progress
from course.report.console import open_console

if TYPE_CHECKING:
    from tests.report.conftest import Page


def test_off_a_terminal_each_message_is_a_line_once(page: Page) -> None:
    with activity(page.console, "checking") as say:
        say("building \x1b[31mfoo\nbar")
        say("building \x1b[31mfoo\nbar")
        say("watching")
    assert page.lines == ["checking", "building foo\\nbar", "watching"]


def test_quiet_says_nothing(page: Page) -> None:
    with activity(page.console, "checking", quiet=True) as say:
        say("building")
    assert page.text == ""


def test_a_terminal_gets_one_line_that_goes_away(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("FORCE_COLOR", "1")
    stream = io.StringIO()
    with activity(open_console(stream, width=80), "checking") as say:
        say("building " + "x" * 200)
    assert "\x1b[?25l" in stream.getvalue(), "the cursor is hidden meanwhile"
    assert stream.getvalue().rindex("\x1b[?25h") > stream.getvalue().rindex("building"), "and shown again"
    assert "\x1b[2K" in stream.getvalue().split("building")[-1], "the line is erased at the end"


def test_the_cursor_comes_back_after_an_interrupt(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("FORCE_COLOR", "1")
    stream = io.StringIO()
    with pytest.raises(KeyboardInterrupt), activity(open_console(stream, width=80), "checking"):
        raise KeyboardInterrupt
    assert stream.getvalue().rstrip().endswith("\x1b[?25h") or "\x1b[?25h" in stream.getvalue()[-20:]


def test_a_tally_says_what_goes_on_until_the_next_is_done(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("FORCE_COLOR", "1")
    stream = io.StringIO()
    with progress(open_console(stream, width=80)) as show:
        tally = Tally(3)
        show(tally, None, "building \x1b[31mfoo")
    assert "0 of 3, building foo" in stream.getvalue()
    with progress(open_console(stream, width=80)) as show:
        tally.count("passed")
        show(tally, "ada")
    assert "1 passed" in stream.getvalue().split("building")[-1]
