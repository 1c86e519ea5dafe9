"""What learners type, line by line, and all that they read: it is in `golden/sessions.txt`.

A line that begins with @ is done to the session. `@answer failed` decides the next checks. `@write TEXT`
saves the learner's file, and `@read` shows it. `@chapter N` adds one without exercises, and `@files` lists
the home. `@next` and `@init` are commands whose words do not count.
"""

from __future__ import annotations

import shlex
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course.grading.check import Request
from course.grading.supervisor import ForkServer
from course.model import replace
from course.model.result import Result
from tests.cli import conftest
from tests.golden import golden

if TYPE_CHECKING:
    from tests.cli.conftest import Ros2course

LIGHT = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"
ANSWERS = {"passed": conftest.PASSED, "failed": conftest.FAILED}
SESSIONS = {
    "on a bare machine": "next / @files / next / next --lesson",
    "nothing of the learner is overwritten": "@next / @write mine / next / @read",
    "it stays until passed, and goes on to the end": "@next / next / check / next / check / next / list",
    "skipped exercises come back": "next dim / @next / check / next",
    "chapters without exercises": "@chapter 2 / @chapter 3 / @chapter 5 / next / next / show --lesson",
    "one that is read later": "@next / @chapter 3 / next / next --lesson",
    "the last chapters": "@chapter 5 / @next / check / @next / check / next / next",
    "hints go one further, and the last one stays": "@next / hint / hint / hint / hint / hint 04-dim",
    "hints again, and all": "@next / hint --again / hint --again / hint / hint --all / hint --again",
    "show changes nothing": "@next / show / show dim --lesson / show / show --pager",
    "list": "@next / list / check / list",
    "solution": "@next / solution / solution --anyway / check / solution",
    "check": "@next / @answer failed / check / hint --all / check / @answer passed / check",
    "check again": "@next / check / @answer failed / check",
    "checking one that is passed": "@next / check / @next / @answer failed / check light / show",
    "misspelled": "@next / show 04-ligth",
    "before the first exercise": "@init / hint",
    "how it was called": "@launcher ./ros2course / list / next",
}


@pytest.fixture
def home(monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Always the same, because line breaks depend on the length of its name."""
    with tempfile.TemporaryDirectory(dir="/tmp") as folder:
        monkeypatch.setenv("ROS2COURSE_HOME", f"{folder}/home")
        yield Path(folder, "home")


@pytest.fixture
def do(
    ros2course: Ros2course, home: Path, small_course: Path, monkeypatch: pytest.MonkeyPatch
) -> Callable[[str], str]:
    """Run one line; return its output."""
    answer = conftest.PASSED

    def check(request: Request, fork_server: ForkServer) -> Result:
        for text in ("building lanterns", "building lanterns", "watching"):
            request.on_progress(text)
        return replace(answer, exercise=request.exercise.id)

    def prepare(what: str, *rest: str) -> str:
        nonlocal answer
        if what == "answer":
            answer = ANSWERS[rest[0]]
        elif what == "write":
            (home / LIGHT).write_text(rest[0])
        elif what == "read":
            return (home / LIGHT).read_text()
        elif what == "files":
            return "\n".join(
                sorted(str(path.relative_to(home)) for path in home.rglob("*") if path.is_file())
            )
        elif what == "chapter":
            folder = small_course / f"chapters/{int(rest[0]):02d}-read"
            folder.mkdir()
            (folder / "lesson.md").write_text(f"Text of chapter {rest[0]}.")
            head = f"chapter: {rest[0]}\ntitle: Reading\nsummary: Nothing to do.\n"
            (folder / "lesson.yaml").write_text(f"{head}exercises: []\n")
        elif what == "launcher":
            monkeypatch.setenv("ROS2COURSE_LAUNCHER", rest[0])
        else:
            ros2course(what)
        return ""

    def do(line: str) -> str:
        words = shlex.split(line)
        if line.startswith("@"):
            return prepare(words[0][1:], *words[1:])
        run = ros2course(*words)
        errors = "".join(f"! {text}\n" for text in run.err.splitlines())
        return f"{errors}{run.out}({run.code})".replace(str(home), "HOME").replace(
            str(small_course), "COURSE"
        )

    monkeypatch.setattr("course.cli.check.check_exercise", check)
    monkeypatch.setattr(ForkServer, "start_early", lambda self: None)
    monkeypatch.setattr("course.cli.check.find_ros", lambda: None)
    return do


@pytest.mark.parametrize("name", SESSIONS)
def test_a_session(do: Callable[[str], str], name: str) -> None:
    golden(*(f"$ {line}\n{do(line)}" for line in SESSIONS[name].split(" / ")))
