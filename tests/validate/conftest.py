"""`validate` as it is typed, on copies of the quiz course: its quiz is graded in milliseconds."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from course.cli.main import main
from tests.conftest import FIXTURES

QUIZ = "05-quiz"


class Ended:
    """The result of one command."""

    def __init__(self, code: int, out: str, err: str) -> None:
        self.code, self.out, self.err = code, out, err

    @property
    def words(self) -> str:
        """The output without its line breaks, which the width decides about."""
        return " ".join(self.out.split())


Validate = Callable[..., Ended]


@pytest.fixture
def quiz_course(tmp_path: Path) -> Path:
    """A copy, for a test to break."""
    return shutil.copytree(FIXTURES / "quiz_course", tmp_path / "quiz_course")


@pytest.fixture
def validate(
    quiz_course: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Validate:
    """`validate("--static")`: on the quiz of the quiz course, unless others are named; one job."""
    monkeypatch.setenv("COLUMNS", "80")
    for name in ("GITHUB_ACTIONS", "GITHUB_WORKSPACE", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.chdir(quiz_course)

    def run(*words: str, exercise: str = QUIZ) -> Ended:
        code = main(["--course", str(quiz_course), "validate", exercise, "--jobs", "1", *words])
        return Ended(code, *capsys.readouterr())

    return run


def edit(file: Path, old: str, new: str) -> int:
    """Replace a text that occurs once; its line, from 1."""
    text = file.read_text(encoding="utf-8")
    assert text.count(old) == 1
    file.write_text(text.replace(old, new), encoding="utf-8")
    return text[: text.index(old)].count("\n") + 1
