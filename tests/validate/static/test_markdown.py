"""Code in a text as a shell would read it."""

from __future__ import annotations

import pytest

from course.validate.static.markdown_parts import Code, ShellCommand, UnreadableLine, commands, contents


def found(text: str, language: str | None = "bash") -> list[tuple[str, int]]:
    each = commands(Code(text, 5, language), "ros2")
    return [
        (" ".join(one.words[1:]), one.line) if isinstance(one, ShellCommand) else (one.text, -one.line)
        for one in each
    ]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("ros2 topic list", "topic list"),
        ("ros2 run <package> <program>", "run placeholder placeholder"),
        ("ros2 topic echo /x  # what is said", "topic echo /x"),
        ("P=x ros2 run $P node", "run $P node"),
        ("time ros2 topic hz /x", "topic hz /x"),
        ("ros2 topic list > topics.txt 2>&1", "topic list"),
        ("ros2 topic list 2> errors.txt", "topic list"),
        ("ros2 topic list | grep a", "topic list"),
        ("cd x && ros2 topic list; ls", "topic list"),
        ("ls $(ros2 pkg prefix x)", "pkg prefix x"),
        ("ros2 run … --ros-args", "run ... --ros-args"),
        ("ros2 topic echo /x [--once]", "topic echo /x"),
        ("ros2 topic pub /x t '{a: [1, 2]}'", "topic pub /x t {a: [1, 2]}"),
    ],
)
def test_one_command(text: str, words: str) -> None:
    assert found(text) == [(words, 5)]


def test_lines_that_go_on() -> None:
    text = "ls\nros2 topic pub \\\n  /x t\n\nros2 topic pub /x t '{\n  a: 1}'\nros2 node list\n"
    assert found(text) == [("topic pub /x t", 6), ("topic pub /x t {\n  a: 1}", 9), ("node list", 11)]


def test_what_was_printed_is_no_command() -> None:
    text = "$ ros2 topic list\nros2 is great\n$ ros2 node \\\n    list\nros2 nothing"
    for language in ("bash", "", "console"):
        assert found(text, language) == [("topic list", 5), ("node list", 7)]


def test_drawings_name_commands() -> None:
    text = "  a --> ros2 topic info       |  who is here?\n  /opt/ros2 x   ros2 launch"
    assert found(text, "") == [("topic info", 5), ("launch", 6)]
    assert found(text, "python") == []


def test_a_quotation_mark_that_is_left_open() -> None:
    assert found("ls\nros2 topic pub /x t '{a: 1}\nls") == [("ros2 topic pub /x t '{a: 1}", -6)]
    (one,) = commands(Code("ros2 'x", 1, "bash"), "ros2")
    assert isinstance(one, UnreadableLine)


def test_another_program() -> None:
    assert found("ros2course check\necho ros2 topic list\n./ros2 x") == []


def test_code_of_a_text_and_its_lines() -> None:
    text = "# One\n\nA `b`\nand `c`.\n\n```bash\nd\n```\n\n| x |\n| --- |\n| `e` |\n| `f` |\n\n"
    text += "1. `g`\n\n   ```\n   h\n   ```\n"
    codes = [(one.text.strip(), one.line, one.language) for one in contents(text).codes]
    assert sorted(codes) == [
        ("b", 3, None), ("c", 4, None), ("d", 7, "bash"), ("e", 12, None), ("f", 13, None), ("g", 15, None),
        ("h", 18, ""),
    ]  # fmt: skip
