"""The course's own commands, and the exercises that texts name."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.cli.validate import complaint
from course.validate.static.commands import ros2_findings
from course.validate.static.subject import Prose

from .conftest import Change, Tell

TEXT = "chapters/04-lanterns/04-dim.md"


@pytest.mark.parametrize(
    ("code", "what"),
    [
        ("`check 04-lihgt`", "there is no exercise `04-lihgt`; did you mean `04-light`?"),
        ("`check 4`", "`4` matches several exercises"),
        ("`ros2course check 18`", "there is no exercise `18`"),
        ("`04-moon`", "there is no exercise `04-moon`"),
        ("`ros2course xcheck`", "`ros2course xcheck` is not a command of ros2course: there is no "
         "command `xcheck`; did you mean `check`?"),
        ("`ros2course check --quikc`", "`ros2course check --quikc` is not a command of ros2course: "
         "No such option: --quikc"),
        ("\n```bash\nros2course grade\n```\n", "`ros2course grade` is not a command of ros2course: "
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
    change(TEXT, "Write", "Type `ros2course xcheck --x` or `ros2course check 18-x`. Write")
    assert tell() == [f"{TEXT}:1: there is no exercise `18-x`"]


LESSON_MD = Path("/course/chapters/04-lanterns/lesson.md")

RIGHT = """
`ros2`, `ros2 topic`, `ros2 topic echo`, `ros2 run ... --ros-args -p x:=1`, `ros2 interface show NAME`,
`ros2 pkg create --dependencies rclpy garden` and `ros2 topic --help`.

| `ros2 topic find TYPE` | `ros2 bag record -a` |
| --- | --- |
| `ros2 topic pub --rate` | x |

```bash
ros2 topic echo /x --once
ros2 run <package> <program> --anything
ros2 topic pub --once /x std_msgs/msg/String \\
    "{data: hello}"
ros2 launch lights harbour_launch.py color:=blue | grep -v "ros2 nothing"
```

```
 +---+   ros2 topic info      who is here?
 |   |   ros2 launch
```
"""

WRONG = """
`ros2 topic ecoh`

`ros2 topic echo --onec /x`, and
`ros2 topics list`.

```bash
ls
ros2 topic echo /x --onec
ros2 topic echo
ros2 topic hz -w 0 /x
ros2 topic pub /x "
```

```
   ros2 node lisst    shows them
```
"""


def told(text: str) -> list[tuple[int | None, str]]:
    found = list(ros2_findings(LESSON_MD.parents[2], [Prose(LESSON_MD, 1, text, "04-dim")]))
    assert {(one.file, one.exercise) for one in found} <= {(LESSON_MD, "04-dim")}
    return sorted((one.line or 0, one.what) for one in found)


def test_what_is_right_for_ros2() -> None:
    assert told(RIGHT) == []


def test_what_is_wrong_for_ros2() -> None:
    wrong = "is not a command of `ros2`:"
    assert told(WRONG) == [
        (2, f"`ros2 topic ecoh` {wrong} there is no `ecoh`; did you mean `echo`?"),
        (4, f"`ros2 topic echo --onec /x` {wrong} unrecognized arguments: --onec"),
        (5, f"`ros2 topics list` {wrong} there is no `topics`; did you mean `topic`?"),
        (9, f"`ros2 topic echo /x --onec` {wrong} unrecognized arguments: --onec"),
        (10, f"`ros2 topic echo` {wrong} the following arguments are required: topic_name"),
        (11, f"`ros2 topic hz -w 0 /x` {wrong} argument -w/--window: value must be a positive integer"),
        (12, 'no shell can read `ros2 topic pub /x "`: a quotation mark is not closed'),
        (16, f"`ros2 node lisst` {wrong} there is no `lisst`; did you mean `list`?"),
    ]


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("      - Half of it is left.", "      - |\n        Half of it:\n\n        `ros2 topic ecoh`", 32),
        ("      - Half of it is left.", "      - Half. `ros2 topic ecoh`", 29),
        ("    after: It shines.", "    after: |\n      It shines.\n      `ros2 topic ecoh`", 19),
    ],
)
def test_texts_of_lesson_yaml(old: str, new: str, line: int, change: Change, tell: Tell) -> None:
    lesson = "chapters/04-lanterns/lesson.yaml"
    change(lesson, old, new)
    (only,) = tell()
    assert only.startswith(f"{lesson}:{line}: `ros2 topic ecoh` is not a command of `ros2`:")


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ("ros2 interface show lanterns/msg/Glow", None),
        ("ros2 interface show lanterns/msg/Gloow", "lanterns has no msg `Gloow`; did you mean `Glow`?"),
        ("ros2 topic pub --once /x lanterns/msg/Dark '{}'", "lanterns has no msg `Dark`"),
        ("ros2 service call /x example_interfaces/srv/AddTwo", "example_interfaces has no srv `AddTwo`; "
         "did you mean `AddTwoInts`?"),
        ("ros2 interface show ships/msg/Ship", None),
    ],
)  # fmt: skip
def test_types(line: str, what: str | None, change: Change, tell: Tell) -> None:
    package = "solutions/04-lanterns/ros2_tutorial_workspace/src/lanterns"
    change(f"{package}/package.xml", "", "<package/>")
    change(f"{package}/msg/Glow.msg", "", "bool on\n")
    text = "chapters/04-lanterns/04-dim.md"
    change(text, "Write", f"See:\n```bash\n{line}\n```\nWrite")
    words = " ".join(line.replace("'", "").split())
    assert tell() == ([f"{text}:3: in `{words}`: {what}"] if what else [])
