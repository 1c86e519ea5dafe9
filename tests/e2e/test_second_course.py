"""The engine knows no chapter: another course, with other packages and topics, is graded like its own."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.content import Course, open_course, problems
from course.grading import trial

ROOT = Path(__file__).parents[2]
SECOND = ROOT / "tests/fixtures/second_course"
BUILDS = ("61-thermometer", "61-alarm")


def said(*words: str, course: str | None = str(SECOND), cwd: Path = ROOT) -> tuple[int, str]:
    """The exit code and output of a command as typed."""
    about = ["--course", course] if course else []
    done = subprocess.run(
        [sys.executable, "-m", "course", *about, *words], cwd=cwd, capture_output=True, text=True, check=False
    )
    return done.returncode, done.stdout + done.stderr


@pytest.fixture(scope="module")
def second() -> Course:
    return open_course(SECOND)


@pytest.fixture
def home(tmp_path: Path) -> Iterator[Path]:
    code, text = said("init", str(tmp_path / "home"))
    assert code == 0, text
    yield tmp_path / "home"


def checked(home: Path, exercise: str) -> tuple[int, str]:
    return said("--home", str(home), "check", exercise)


def test_nothing_is_wrong_with_it(second: Course) -> None:
    assert problems(second) == ()
    assert [exercise.id for exercise in second.exercises()] == [*BUILDS, "72-units"]


@pytest.mark.slow
def test_a_learner_s_way_through_it(home: Path) -> None:
    """The home was made for it, so nothing else has to name it."""
    for words, code, shown in (
        (("list",), 0, "61 The greenhouse"),
        (("next",), 0, "greenhouse/thermometer.py"),
        (("hint",), 0, "four times per second"),
        (("show", "alarm"), 0, "more than 30 degrees"),
        (("next", "alarm"), 0, "61-thermometer"),
        (("show", "18-publisher"), 2, "there is no exercise"),
    ):
        got, text = said("--home", str(home), *words, course=None)
        assert got == code, text
        assert shown.casefold() in " ".join(text.split()).casefold()


@pytest.mark.slow
@pytest.mark.parametrize("name", [*BUILDS, "72-units"])
def test_a_solution_passes(second: Course, home: Path, name: str) -> None:
    trial.lay_solution(second, second.exercise(name), home)
    code, text = checked(home, name)
    assert code == 0 and "Passed:" in text, text


@pytest.mark.slow
@pytest.mark.parametrize("name", BUILDS)
def test_a_starter_does_not(second: Course, home: Path, name: str) -> None:
    trial.lay_starter(second, second.exercise(name), home)
    code, text = checked(home, name)
    assert code == 1 and "Not passed yet" in text and "ok  the packages build" in text, text


@pytest.mark.slow
@pytest.mark.parametrize("name", ["outdoors", "always", "a-physicist"])
def test_a_mistake_is_caught_in_its_words(second: Course, home: Path, name: str) -> None:
    pairs = [(e, mistake) for e in second.exercises() for mistake in e.mistakes()]
    exercise, mistake = next(pair for pair in pairs if pair[1].id == name)
    trial.lay_mistake(second, exercise, mistake, home)
    code, text = checked(home, exercise.id)
    assert code == 1, text
    assert all(word in text for word in mistake.says), text


@pytest.mark.slow
def test_all_of_it_is_proven() -> None:
    code, text = said("validate")
    assert code == 0 and "13/13" in text, text


@pytest.mark.slow
def test_as_an_installed_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`--course NAME`: the package is looked at and not imported."""
    package = shutil.copytree(SECOND, tmp_path / "site/heat_course")
    (package / "__init__.py").write_text("raise RuntimeError('nobody asked for this')\n")
    monkeypatch.setenv("PYTHONPATH", f"{ROOT}:{tmp_path / 'site'}")
    home = tmp_path / "home"
    code, text = said("--home", str(home), "next", course="heat_course", cwd=tmp_path)
    assert code == 0 and "A thermometer" in text, text
    assert (home / "ros2_tutorial_workspace/src/greenhouse/setup.py").is_file()
