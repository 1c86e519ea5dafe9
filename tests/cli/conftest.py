"""Runs commands on the small course, with a check that answers at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from course.cli.main import main
from course.grading.check import Request
from course.grading.supervisor import ForkServer
from course.model.result import CheckResult, Feedback, Outcome, Result, Verdict

REPO = Path(__file__).parents[2]


@dataclass(frozen=True)
class Run:
    """The result of one command."""

    code: int
    out: str
    err: str


Ros2course = Callable[..., Run]


@pytest.fixture
def ros2course(
    small_course: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Ros2course:
    """`ros2course("hint", "04-light")` as typed, at 80 columns, on a copy of the small course."""
    for name in (
        "NO_COLOR",
        "FORCE_COLOR",
        "ROS2COURSE_LAUNCHER",
        "ROS2COURSE_CALLED_AS",
        "ROS2COURSE_DEBUG",
    ):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.chdir(small_course.parent)

    def run(*words: str, course: Path | None = small_course) -> Run:
        code = main([*(("--course", str(course)) if course else ()), *words])
        out, err = capsys.readouterr()
        return Run(code, out, err)

    return run


@pytest.fixture
def home(monkeypatch: pytest.MonkeyPatch, guarded_home: Path) -> Path:
    """Where the course home is, or will be: nothing overrides the default."""
    monkeypatch.delenv("ROS2COURSE_HOME", raising=False)
    return guarded_home / "ros2course"


PASSED = Result("04-light", Verdict.PASSED, (CheckResult("shines", "It shines", 2, Outcome.PASSED),))
FAILED = Result(
    "04-light",
    Verdict.NOT_PASSED,
    (
        CheckResult(
            "shines", "It shines", 2, Outcome.FAILED, feedback=Feedback("It is dark.", advice="Light it.")
        ),
    ),
)
OURS = Result("04-light", Verdict.OUR_ERROR, fault=Feedback("The grader fell over."))
MISSING = Result("04-light", Verdict.NOT_AVAILABLE, fault=Feedback("There is no compiler."))


@dataclass
class Checker:
    """A fake grading: returns `answer`, or raises it; keeps its arguments."""

    answer: Result | BaseException = PASSED
    requests: list[Request] = field(default_factory=list)
    says: tuple[str, ...] = ()
    so_far: Result | None = None

    @property
    def calls(self) -> list[tuple[str, Path]]:
        return [(request.exercise.id, request.home) for request in self.requests]

    def check_exercise(self, request: Request, fork_server: ForkServer) -> Result:
        self.requests.append(request)
        for text in self.says:
            request.on_progress(text)
        if self.so_far:
            request.so_far(self.so_far)
        if isinstance(self.answer, BaseException):
            raise self.answer
        return self.answer


@pytest.fixture
def checker(monkeypatch: pytest.MonkeyPatch) -> Checker:
    stand_in = Checker()
    monkeypatch.setattr("course.cli.check.check_exercise", stand_in.check_exercise)
    monkeypatch.setattr(ForkServer, "start_early", lambda self: None)
    monkeypatch.setattr("course.cli.check.find_ros", lambda: None)
    return stand_in
