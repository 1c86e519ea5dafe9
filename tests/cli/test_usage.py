"""Words of the command line."""

from __future__ import annotations

import pytest

from course.cli.usage import examples, global_options_first, spoken, typed
from course.cli.validate import complaint


@pytest.mark.parametrize(
    ("words", "moved"),
    [
        (["next", "--home", "x"], ["--home", "x", "next"]),
        (["next", "--home=x", "a"], ["--home=x", "next", "a"]),
        (["--course", "c", "list", "--home", "x"], ["--course", "c", "--home", "x", "list"]),
        (["list", "--home"], ["list", "--home"]),
        (["shell", "--", "--home", "x"], ["shell", "--", "--home", "x"]),
        ([], []),
    ],
)
def test_global_options_move_to_the_front(words: list[str], moved: list[str]) -> None:
    assert global_options_first(words) == moved


def test_advice_names_the_launcher_as_it_was_typed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS2COURSE_LAUNCHER", "../x/ros2course")
    said = spoken("`ros2course init` makes it in ~/ros2course; see /a/ros2course next. ./ros2course next")
    assert (
        said == "`../x/ros2course init` makes it in ~/ros2course; see /a/ros2course next. ./ros2course next"
    )


def test_in_the_learner_s_shell_the_name_alone_is_typed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS2COURSE_LAUNCHER", "/clone/ros2course")
    monkeypatch.setenv("ROS2COURSE_CALLED_AS", "ros2course")
    assert typed("next") == "ros2course next"


def test_examples_line_up() -> None:
    assert examples(("a", "one"), ("bcd", "two")).splitlines()[2:] == [
        "  ros2course a    one",
        "  ros2course bcd  two",
    ]


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
