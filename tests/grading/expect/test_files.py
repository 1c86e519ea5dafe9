"""What is said about files that are missing, misplaced, misspelled, or wrong."""

from __future__ import annotations

import stat

import pytest

from course.evidence.home_files import HomeEntry
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.grading.expect.text_files import expect_file, expect_lines, expect_mode, expect_text
from tests.golden import golden

from .conftest import said, told, where

FILE = "a_folder/x.txt"


def home(*entries: HomeEntry | str, **texts: str) -> Recording:
    """A home with files (by path, all holding `text`) and other entries."""
    found = tuple(HomeEntry(item, "file", 0o644, 5) if isinstance(item, str) else item for item in entries)
    files = {entry.path: "text\n" for entry in found if entry.kind == "file"}
    return Recording("x", sources=Sources({**files, **texts}), looked_at=found)


FOLDER = HomeEntry("a_folder", "folder", 0o755)


def test_a_file_that_is_there() -> None:
    assert said(expect_file, home(FOLDER, FILE), FILE) is None


@pytest.mark.parametrize(
    ("recording", "words", "places"),
    [
        (
            home(FOLDER, "x.txt"),
            ("is in `~`, not in `~/a_folder`", "mv ~/x.txt ~/a_folder/x.txt"),
            ["x.txt"],
        ),
        (
            home("x.txt"),
            ("is in `~`, not in `~/a_folder`", "`mkdir -p ~/a_folder`, then `mv ~/x.txt ~/a_folder/x.txt`"),
            ["x.txt"],
        ),
        (home(FOLDER, "a_folder/X.txt"), ("has no `x.txt`; it has `X.txt`", "mv"), ["a_folder/X.txt"]),
        (home(FOLDER, "a_folder/x.txt.txt"), ("has `x.txt.txt`",), ["a_folder/x.txt.txt"]),
        (home(FOLDER, "b/X.txt"), ("no `~/a_folder/x.txt`, but there is `~/b/X.txt`",), ["b/X.txt"]),
        (home(FOLDER), ("no file `~/a_folder/x.txt`", "contains nothing"), []),
        (home(FOLDER, "a_folder/other.md"), ("contains `other.md`",), []),
        (home(), ("no folder `~/a_folder`", "mkdir ~/a_folder"), []),
        (home(HomeEntry("A_folder", "folder")), ("there is `~/A_folder`", "renames"), ["A_folder"]),
        (home(FOLDER, HomeEntry(FILE, "folder")), ("is a folder", "rm -r", "touch"), [FILE]),
        (home(FOLDER, HomeEntry(FILE, "link", target="/etc/x")), ("is a link to `/etc/x`",), [FILE]),
        (home(FOLDER, HomeEntry(FILE, "other")), ("cannot be read",), [FILE]),
    ],
)
def test_what_is_there_instead_is_named(
    recording: Recording, words: tuple[str, ...], places: list[str]
) -> None:
    feedback = told(expect_file, recording, FILE)
    everything = f"{feedback.summary} {feedback.seen} {feedback.advice}"
    assert [word for word in words if word not in everything] == [], everything
    assert where(feedback) == places


def test_the_author_s_advice_is_given_when_nothing_is_near() -> None:
    assert told(expect_file, home(FOLDER), FILE, advice="Use `touch`.").advice == "Use `touch`."


def test_text_is_text() -> None:
    picture = Recording("x", looked_at=(FOLDER, HomeEntry(FILE, "file", 0o644, 99)))
    assert "not a text file" in told(expect_text, picture, FILE).summary
    assert said(expect_text, home(FOLDER, FILE), FILE) is None


@pytest.mark.parametrize("end", ["", "\n"])
def test_lines_with_and_without_a_final_line_end(end: str) -> None:
    assert said(expect_lines, home("x", x=f"a\n\nb{end}"), "x", ["a", "", "b"], advice="") is None


@pytest.mark.parametrize("text", ["", "a\n", "a\nB\n", "a\nb\n\n"])
def test_the_first_difference_is_named(text: str) -> None:
    golden(told(expect_lines, home("x", x=text), "x", ["a", "b"], advice="do this"))


@pytest.mark.parametrize(("mode", "right"), [(0o755, True), (0o644, False), (0o777, False), (0o744, True)])
def test_modes(mode: int, right: bool) -> None:
    recording = home(HomeEntry("run.sh", "file", mode))
    bits = {"has": stat.S_IXUSR, "lacks": stat.S_IWOTH}
    feedback = said(expect_mode, recording, "run.sh", **bits, summary="not so", advice="chmod")
    assert (feedback is None) is right
    if feedback and mode == 0o777:
        assert (feedback.expected, feedback.seen) == ("-rwxrwxr-x (775)", "-rwxrwxrwx (777)")
