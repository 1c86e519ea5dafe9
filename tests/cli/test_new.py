"""`new`: what it makes is correct, and it says what it cannot make."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course.authoring.exercise import ExerciseKind
from course.content import open_course, problems
from course.grading.load import load_grader

if TYPE_CHECKING:
    from tests.cli.conftest import Ros2course, Run


@pytest.fixture
def robots(ros2course: Ros2course, tmp_path: Path) -> Path:
    """A course with one chapter, without exercises."""
    assert ros2course("new", "course", "robots", course=None).code == 0
    assert ros2course("new", "chapter", "30-power", course=tmp_path / "robots").code == 0
    return tmp_path / "robots"


def tree(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def flat(run: Run) -> str:
    """The complaints, however they are wrapped."""
    return " ".join(run.err.split())


def test_an_exercise_is_complete_and_every_file_of_it_is_told(ros2course: Ros2course, robots: Path) -> None:
    before = tree(robots)
    run = ros2course("new", "exercise", "30-power/30-battery", course=robots)
    after = tree(robots)
    assert run.code == 0
    told = {line[4:] for line in run.out.splitlines() if line.startswith(("  + ", "  ~ "))}
    assert told == {name for name in after if after[name] != before.get(name)}
    assert f"ros2course validate 30-battery --course {robots}" in run.out
    assert problems(open_course(robots)) == ()
    exercise = open_course(robots).exercise("30-battery")
    checks = set(load_grader(exercise.grader, exercise.id).checks)
    assert {mistake.caught_by for mistake in exercise.mistakes()} == checks
    assert len(exercise.hints) >= 3


def test_more_exercises_and_chapters(ros2course: Ros2course, robots: Path) -> None:
    for words in (("exercise", "power/battery"), ("chapter", "sensors"), ("exercise", "31/31-class")):
        assert ros2course("new", *words, course=robots).code == 0
    lesson = robots / "chapters/30-power/lesson.yaml"
    lesson.write_text(lesson.read_text() + "# mine\n", encoding="utf-8")
    assert ros2course("new", "exercise", "30/fuse", course=robots).code == 0
    assert [e.id for e in open_course(robots).exercises()] == ["30-battery", "30-fuse", "31-class"]
    assert problems(open_course(robots)) == ()
    grader = (robots / "graders/ch30_power.py").read_text()
    imports = [ast.unparse(node) for node in ast.parse(grader).body if isinstance(node, ast.ImportFrom)]
    assert len(imports) == len(set(imports))
    for name in ("30-battery", "30-fuse"):
        assert load_grader(robots / "graders/ch30_power.py", name).exercise == name


def test_what_it_makes_is_tidy(ros2course: Ros2course, robots: Path) -> None:
    for name in ("battery", "a", "two-robots"):
        ros2course("new", "exercise", f"30/{name}", course=robots)
    assert_tidy(robots)


def assert_tidy(folder: Path) -> None:
    rules = ["--isolated", "--line-length", "110", "--select", "E,F,W,I,N,UP,B"]
    done = subprocess.run(
        [sys.executable, "-m", "ruff", "check", *rules, str(folder)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout


def test_in_the_course_s_own_folder_nothing_more_needs_to_be_said(
    ros2course: Ros2course, robots: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(robots)
    assert ros2course("new", "chapter", "sensors", course=None).code == 0
    assert (robots / "chapters/31-sensors/lesson.yaml").is_file()


def test_the_first_lines_name_schemas_that_are_there(ros2course: Ros2course, robots: Path) -> None:
    (robots / ".schema/lesson.schema.json").unlink()
    ros2course("new", "exercise", "30/battery", course=robots)
    for file in (robots / "chapters/30-power").glob("*.yaml"):
        first = file.read_text().splitlines()[0]
        named = first.removeprefix("# yaml-language-server: $schema=")
        assert first != named and (file.parent / named).is_file()


@pytest.mark.parametrize(
    ("words", "said", "step"),
    [
        (("chapter", "30-other"), "There already is a chapter 30: 30-power", "leave it out: other"),
        (("chapter", "Power"), "`Power` is not a name", "`30-battery`"),
        (("chapter", "99-last"), None, None),
        (("exercise", "battery"), "does not say in which chapter", "`30-power/30-battery`"),
        (("exercise", "31/battery"), "There is no chapter `31`", "There are: 30-power"),
        (("exercise", "30-pwer/battery"), "did you mean `30-power`?", "ros2course new chapter NAME"),
        (("exercise", "30/31-battery"), "has that chapter's number, not 31", "Allowed: 30-battery"),
        (("exercise", "30/old"), "There already is a package old_package", "another name"),
        (("exercise", "30/a/b"), "`a/b` is not a name", "`30-battery`"),
    ],
)
def test_what_does_not_fit_is_said_and_changes_nothing(
    ros2course: Ros2course, robots: Path, words: tuple[str, str], said: str | None, step: str | None
) -> None:
    ros2course("new", "exercise", "30/old", course=robots)
    before = tree(robots)
    run = ros2course("new", *words, course=robots)
    if said is None or step is None:
        assert run.code == 0
        run, said, step = ros2course("new", "chapter", "more", course=robots), "no number after 99", "30-name"
        before = {**before, **tree(robots)}
    assert run.code == 2
    assert said in flat(run) and step in flat(run).partition("Next:")[2]
    assert tree(robots) == before


def test_the_same_again(ros2course: Ros2course, robots: Path) -> None:
    ros2course("new", "exercise", "30/battery", course=robots)
    before = tree(robots)
    run = ros2course("new", "exercise", "30/battery", course=robots)
    assert (run.code, tree(robots)) == (2, before)


def test_a_course_where_something_is(ros2course: Ros2course, robots: Path, tmp_path: Path) -> None:
    run = ros2course("new", "course", "robots", course=None)
    assert run.code == 2 and "new chapter NAME" in run.err
    (tmp_path / "full").mkdir()
    (tmp_path / "full/file").write_text("")
    assert "not empty" in ros2course("new", "course", "full", course=None).err
    assert "is a file" in ros2course("new", "course", "full/file", course=None).err
    (tmp_path / "empty").mkdir()
    assert ros2course("new", "course", "empty", course=None).code == 0


def test_without_a_course(ros2course: Ros2course, tmp_path: Path) -> None:
    run = ros2course("new", "chapter", "power", course=None)
    assert run.code == 2 and "--course DIR" in run.err
    run = ros2course("new", "chapter", "power", course=tmp_path / "nowhere/at/all")
    assert run.code == 2 and "there is no such folder" in flat(run) and "new course" in flat(run)
    run = ros2course("new", "exercise", "power/battery", course=tmp_path)
    assert run.code == 2 and "it has no chapters/" in flat(run)


@pytest.mark.parametrize(
    ("file", "text", "said"),
    [
        ("chapters/30-power/lesson.yaml", "chapter: [", "not valid YAML"),
        ("chapters/30-power/mistakes.yaml", "mistakes: none", "a list with a dash"),
        ("graders/ch30_power.py", "def (:", "not valid Python"),
    ],
)
def test_a_file_that_cannot_be_added_to(
    ros2course: Ros2course, robots: Path, file: str, text: str, said: str
) -> None:
    (robots / file).write_text(text)
    before = tree(robots)
    run = ros2course("new", "exercise", "30/battery", course=robots)
    assert run.code == 3 and said in flat(run)
    assert f"{Path(file).name}:1" in flat(run).replace(" ", "")
    assert tree(robots) == before


def test_where_nothing_may_be_written(
    ros2course: Ros2course,
    open_folder: Path,
    read_only: Callable[[Path], AbstractContextManager[None]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    course = open_folder / "robots"
    for words in (("course", str(course)), ("chapter", "30-power")):
        ros2course("new", *words, course=course if words[0] == "chapter" else None)
    ros2course("new", "exercise", "30/battery", course=course)
    before = tree(course)
    monkeypatch.chdir(open_folder)
    with read_only(open_folder):
        run = ros2course("new", "exercise", "30/fuse", course=course)
    assert run.code == 4 and "Permission denied" in run.err and "Next:" in run.err
    assert tree(course) == before


@pytest.mark.parametrize("kind", [kind.value for kind in ExerciseKind])
def test_each_kind_is_complete_and_tidy(ros2course: Ros2course, robots: Path, kind: str) -> None:
    assert ros2course("new", "exercise", "power/my-lamp", "--kind", kind, course=robots).code == 0
    filled_in(robots / "chapters/30-power")
    assert problems(open_course(robots)) == ()
    exercise = open_course(robots).exercise("30-my-lamp")
    questions = {question.id for question in exercise.questions}
    checks = set() if kind == "quiz" else set(load_grader(exercise.grader, exercise.id).checks)
    assert {mistake.caught_by for mistake in exercise.mistakes()} == questions | checks
    run = ros2course("validate", "--static", course=robots)
    assert run.code == 0, run.out
    assert_tidy(robots)


def test_all_kinds_in_one_chapter(ros2course: Ros2course, robots: Path) -> None:
    for kind in ExerciseKind:
        words = ("new", "exercise", f"30/{kind.value}", "--kind", kind.value)
        assert ros2course(*words, course=robots).code == 0
    filled_in(robots / "chapters/30-power")
    run = ros2course("validate", "--static", course=robots)
    assert run.code == 0, run.out


def test_a_kind_is_for_exercises(ros2course: Ros2course, robots: Path) -> None:
    run = ros2course("new", "chapter", "31-more", "--kind", "quiz", course=robots)
    assert run.code == 2 and "--kind is for an exercise" in flat(run)
    run = ros2course("new", "exercise", "30/x", "--kind", "topik", course=robots)
    assert run.code == 2 and "mystery" in flat(run)


def filled_in(chapter: Path) -> None:
    """Replaces what `new chapter` leaves to its author."""
    for name in ("lesson.md", "lesson.yaml"):
        text = (chapter / name).read_text().replace("Say in one line", "Once").replace("Say here", "Soon")
        (chapter / name).write_text(text.replace("A robot,", "A lamp,").replace("The idea,", "A drawing,"))


@pytest.mark.slow
@pytest.mark.parametrize("kind", [kind.value for kind in ExerciseKind])
def test_the_templates_are_proven(ros2course: Ros2course, robots: Path, kind: str) -> None:
    ros2course("new", "exercise", "30/my-lamp", "--kind", kind, course=robots)
    filled_in(robots / "chapters/30-power")
    run = ros2course("validate", course=robots)
    assert run.code == 0, run.out + run.err
