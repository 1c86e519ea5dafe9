"""Commands of ours are judged without being run."""

from __future__ import annotations

import pytest

from course.cli.typed import complaint


@pytest.mark.parametrize(
    "words",
    ["", "check", "check 18", "check --help", "check -h", "--help", "--version", "--home x next", "grade -h",
     "--install-completion", "init DIR", "evidence show 18", "evidence export 18 --to x", "evidence --help"],
)  # fmt: skip
def test_what_could_be_typed(words: str) -> None:
    assert complaint(words.split()) is None


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("chek", "there is no command `chek`; did you mean `check`?"),
        ("check --foo", "No such option: --foo"),
        ("--home", "Option '--home' requires an argument."),
        ("grade", "`submissions` is missing"),
        ("list a", "unexpected argument `a`"),
        ("evidence shw", "there is no command `shw`; did you mean `show`?"),
        ("evidence export", "`to` is missing"),
        ("evidence show a b", "unexpected argument `b`"),
    ],
)
def test_what_could_not(words: str, said: str) -> None:
    assert complaint(words.split()) == said
