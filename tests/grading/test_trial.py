"""Trial homes of exercises without packages: loose files, modes, and additions to a `.bashrc`."""

from __future__ import annotations

import stat
from pathlib import Path

import pytest

from course.content import Alternative, Course, Edit, Exercise, Mistake, open_course
from course.grading import trial
from course.model import replace

INIT = "# as init wrote it\n"


@pytest.fixture
def course(small_course: Path) -> Course:
    return open_course(small_course)


@pytest.fixture
def exercise(course: Course, tmp_path: Path) -> Exercise:
    solution = tmp_path / "solution"
    (solution / "folder").mkdir(parents=True)
    (solution / "folder/x.txt").write_text("x")
    (solution / "run.sh").write_text("echo hi")
    (solution / "run.sh").chmod(0o755)
    (solution / ".bashrc").write_text("alias a=b\n")
    return replace(course.exercise("04-light"), solution=solution, requires=())


@pytest.fixture
def home(tmp_path: Path) -> Path:
    home = tmp_path / "home"
    home.mkdir()
    (home / ".bashrc").write_text(INIT)
    return home


def test_loose_files_are_laid_with_their_modes(course: Course, exercise: Exercise, home: Path) -> None:
    trial.lay_solution(course, exercise, home)
    assert (home / "folder/x.txt").read_text() == "x"
    assert stat.S_IMODE((home / "run.sh").stat().st_mode) == 0o755


def test_the_bashrc_is_added_to_once(course: Course, exercise: Exercise, home: Path) -> None:
    for _ in range(2):
        trial.lay_solution(course, exercise, home)
    assert (home / ".bashrc").read_text() == f"{INIT}\nalias a=b\n"


def test_an_alternative_leaves_its_description_behind(
    course: Course, exercise: Exercise, home: Path, tmp_path: Path
) -> None:
    tree = tmp_path / "other"
    tree.mkdir()
    (tree / "alternative.yaml").write_text("x")
    (tree / ".bashrc").write_text("alias c=d\n")
    other = Alternative("other", (exercise.id,), "another", (".bashrc",), tree)
    trial.lay_alternative(course, exercise, other, home)
    assert not (home / "alternative.yaml").exists()
    assert (home / ".bashrc").read_text() == "alias c=d\n"


def test_mistakes_change_modes_and_the_bashrc(course: Course, exercise: Exercise, home: Path) -> None:
    edits = (Edit("run.sh", mode="777"), Edit(".bashrc", replace="a=b", with_="a = b"))
    trial.lay_mistake(course, exercise, Mistake("m", exercise.id, "m", edits, "c", ("w",)), home)
    assert stat.S_IMODE((home / "run.sh").stat().st_mode) == 0o777
    assert (home / ".bashrc").read_text() == f"{INIT}\nalias a = b\n"


def test_mistakes_take_and_rename_whole_folders(course: Course, exercise: Exercise, home: Path) -> None:
    for edit, left in ((Edit("folder", delete=True), False), (Edit("folder", rename="a/other"), True)):
        trial.lay_mistake(course, exercise, Mistake("m", exercise.id, "m", (edit,), "c", ("w",)), home)
        assert not (home / "folder").exists()
        assert (home / "a/other/x.txt").exists() is left
