"""The course's own commands, and the exercises that texts name."""

from __future__ import annotations

import pytest

from course.cli.typed import complaint

from .conftest import Change, Tell

TEXT = "chapters/04-lanterns/04-dim.md"


@pytest.mark.parametrize(
    ("code", "what"),
    [
        ("`check 04-lihgt`", "there is no exercise `04-lihgt`; did you mean `04-light`?"),
        ("`check 4`", "`4` fits several exercises"),
        ("`ros2course check 18`", "there is no exercise `18`"),
        ("`04-moon`", "there is no exercise `04-moon`"),
        ("`ros2course chek`", "`ros2course chek` is nothing that ros2course understands: there is no command "
         "`chek`; did you mean `check`?"),
        ("`ros2course check --quikc`", "`ros2course check --quikc` is nothing that ros2course understands: "
         "No such option: --quikc"),
        ("\n```bash\nros2course grade\n```\n", "`ros2course grade` is nothing that ros2course understands: "
         "`submissions` is missing"),
    ],
)  # fmt: skip
def test_what_is_wrong(code: str, what: str, change: Change, tell: Tell) -> None:
    change(TEXT, "Write", f"Look at\n{code}\nWrite")
    (told,) = tell(own_command=complaint)
    place, _, said = told.partition(": ")
    assert place == f"{TEXT}:{4 if 'bash' in code else 2}" and said.startswith(what)


@pytest.mark.parametrize(
    "code",
    [
        "`check 04-light`", "`check 04-li`", "`04-light`", "`04-lanterns`", "`ros2course check`",
        "`ros2course`", "`ros2course grade`", "`ros2course check <exercise>`", "`ros2course check --help`",
        "`ros2course hint ...`", "\n```bash\nros2course show 04-light | less\n```\n", "`check it`",
    ],
)  # fmt: skip
def test_what_is_right(code: str, change: Change, tell: Tell) -> None:
    change(TEXT, "Write", f"Look at\n{code}\nWrite")
    assert tell(own_command=complaint) == []


def test_without_the_command_line_only_exercises_are_looked_at(change: Change, tell: Tell) -> None:
    change(TEXT, "Write", "Type `ros2course chek --x` or `ros2course check 18-x`. Write")
    assert tell() == [f"{TEXT}:1: there is no exercise `18-x`"]
