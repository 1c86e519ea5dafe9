"""What is said about unreadable or malicious YAML files."""

from __future__ import annotations

import pytest

from course.evidence.home_files import HomeEntry
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from lib.yaml_files import MOST_NODES, expect_yaml
from tests.grading.expect.conftest import told, where

FILE = "folder/some.yml"
ADVICE = "Make it."


def home(text: str) -> Recording:
    entries = (HomeEntry("folder", "folder"), HomeEntry(FILE, "file", 0o644, len(text)))
    return Recording("x", sources=Sources({FILE: text}), looked_at=entries)


def test_data_and_lines_of_a_file_with_aliases_and_merge_keys() -> None:
    document = expect_yaml(home("a: &one\n  b: 1\nc:\n  <<: *one\n  d: *one\n"), FILE, advice=ADVICE)
    assert document.data == {"a": {"b": 1}, "c": {"b": 1, "d": {"b": 1}}}
    assert document.line(("c", "d")) == 5


BOMB = "a0: &a0 x\n" + "".join(f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]\n" for n in range(1, 12))


@pytest.mark.parametrize(
    ("text", "words", "place"),
    [
        ("", ("is empty", ADVICE), FILE),
        (" \n", ("is empty", ADVICE), FILE),
        ("a:\n\tb: 1\n", ("Line 2 begins with a tab", "spaces"), f"{FILE}:2"),
        ("a:\n  b: 1\n c: 2\n", ("cannot be read as YAML", "Count the spaces"), f"{FILE}:3"),
        ("a:\n  b:1\n  c: 2\n", ("cannot be read as YAML", "a space after the `:`"), f"{FILE}:2"),
        ("a: 1\nb: 2\na: 3\n", ("`a` appears twice", "Keep only one"), f"{FILE}:3"),
        ("a: 1\n7: 2\n", ("`7` is not a name",), f"{FILE}:2"),
        ("yes: 2\n", ("`yes` is not a name", "quotation marks"), f"{FILE}:1"),
        ("? [a, b]\n: 2\n", ("before a `:`", "is not a name"), f"{FILE}:1"),
        ("a: &a\n  b: *a\n", ("line 1 contains itself", "without `*`"), f"{FILE}:1"),
        (BOMB, ("expands to far more",), f"{FILE}:5"),
        ("a: 2026-13-40\n", ("not YAML",), FILE),
        ("[" * 5000, ("not YAML",), FILE),
        ("a: !!python/name:os.system\n", ("not YAML",), f"{FILE}:1"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named_with_its_line(text: str, words: tuple[str, ...], place: str) -> None:
    feedback = told(expect_yaml, home(text), FILE, advice=ADVICE)
    said = f"{feedback.summary} {feedback.advice}"
    assert [word for word in words if word not in said] == []
    assert where(feedback) == [place]


def test_a_long_file_is_no_bomb() -> None:
    text = "".join(f"- {number}\n" for number in range(MOST_NODES - 1))
    assert len(expect_yaml(home(text), FILE, advice=ADVICE).data) == MOST_NODES - 1
