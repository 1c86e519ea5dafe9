"""`grade`: what it accepts, refuses, and shows, and how it ends."""

from __future__ import annotations

import json
import signal
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course.batch import run as running
from course.batch.gradings import Graded, GradingTask
from course.batch.results import Results
from course.batch.run import default_jobs
from course.cli import grade as grade_command
from course.content import open_course
from course.grading import trial
from course.grading.attempts import ATTEMPTS
from course.model.result import CheckResult, Feedback, Outcome, Result, Verdict
from tests.conftest import FIXTURES

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from tests.cli.conftest import Run

    Grade = Callable[..., Run]

QUIZ_COURSE = FIXTURES / "quiz_course"
QUIZ = "05-quiz"


class Pool:
    """Replaces the pool of workers."""

    def __init__(self) -> None:
        self.jobs: list[int] = []
        self.tasks: list[GradingTask] = []
        self.answer: Result | BaseException = Result(
            QUIZ, Verdict.PASSED, (CheckResult("why", "Why", 2, Outcome.PASSED),)
        )

    def __call__(self, jobs: int, next_task: Callable[[], GradingTask | None], say: object) -> Pool:
        self.jobs.append(jobs)
        self._next_task = next_task
        return self

    def results(self) -> Iterator[Graded]:
        while (task := self._next_task()) is not None:
            self.tasks.append(task)
            if isinstance(self.answer, BaseException):
                raise self.answer
            yield Graded(task.unit, self.answer, 0.1)


@pytest.fixture
def pool(monkeypatch: pytest.MonkeyPatch) -> Pool:
    stand_in = Pool()
    monkeypatch.setattr(running, "Pool", lambda work, *given: stand_in(*given))
    monkeypatch.setattr("course.cli.grade.obstacle_to", lambda level: None)
    return stand_in


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    """Submissions of Ada and Bao."""
    course = open_course(QUIZ_COURSE)
    for person in ("ada", "bao"):
        (tmp_path / "class" / person).mkdir(parents=True)
        trial.lay_solution(course, course.exercise(QUIZ), tmp_path / "class" / person)
    return tmp_path / "class"


@pytest.fixture
def grade(ros2course: Callable[..., Run], submissions: Path, pool: Pool) -> Grade:
    def run(*words: str, path: Path = submissions) -> Run:
        return ros2course("grade", str(path), *words, course=QUIZ_COURSE)

    return run


def test_a_class_is_graded_and_reported(grade: Grade, tmp_path: Path) -> None:
    run = grade()
    assert run.code == 0
    assert "ada  ada   course home  05-quiz" in run.out
    assert "2 submissions, 2 of them with something to grade" in run.out
    assert "2 passed" in run.out and "grades/results.csv" in run.out
    assert "ada  05-quiz  passed  2 of 2  (1 of 2" in run.err
    out = tmp_path / "grades"
    rows = (out / "results.csv").read_text(encoding="utf-8-sig").splitlines()
    assert [row.split(",")[0] for row in rows[1:]] == ["ada", "bao"]
    assert len(json.loads((out / "results.json").read_text())["graded"]) == 2
    assert {path.stem for path in (out / "feedback").iterdir()} == {"ada", "bao"}


def test_the_same_command_again_grades_nothing_anew(grade: Grade, pool: Pool) -> None:
    grade()
    run = grade()
    assert run.code == 0 and len(pool.tasks) == 2
    assert "2 passed" in run.out


def test_a_dry_run_only_shows(grade: Grade, pool: Pool, tmp_path: Path) -> None:
    run = grade("--dry-run")
    assert run.code == 0 and "ada" in run.out and pool.tasks == []
    assert not (tmp_path / "grades").exists()


def test_files_that_are_no_submission_are_named(grade: Grade, submissions: Path, pool: Pool) -> None:
    (submissions / "notes.txt").touch()
    (submissions / "marks.xlsx").touch()
    out = " ".join(grade("--dry-run").out.split())
    assert "Files that are not a submission were ignored. (marks.xlsx, notes.txt)" in out


def test_a_line_of_the_roster_without_an_id_is_named(grade: Grade, submissions: Path, pool: Pool) -> None:
    roster = submissions.with_name("roster.csv")
    roster.write_text("id,path\nada,class/ada\n,class/bao\n")
    assert "A line of the roster has no id. (line 3)" in grade("--dry-run", path=roster).out


def test_options_arrive(grade: Grade, pool: Pool, tmp_path: Path) -> None:
    grade("--jobs", "1", "--out", "week3", "--exercises", "05-keepers, quiz")
    assert pool.jobs == [1]
    assert {task.unit.exercise for task in pool.tasks} == {"05-keepers", QUIZ}
    assert all(task.contained and Path(task.course or "") == QUIZ_COURSE for task in pool.tasks)
    assert (tmp_path / "week3/results.csv").is_file()


def test_by_default_so_many_at_once_as_the_machine_takes(
    grade: Grade, pool: Pool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(running, "default_jobs", lambda: 2)
    grade()
    assert pool.jobs == [2] and default_jobs() >= 1


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("--gradescope", "results.json"), "--single"),
        (("--exercises", "99-none"), "99-none"),
        (("--jobs", "0"), "--jobs"),
        (("--jobs", "many"), "--jobs"),
    ],
)
def test_wrong_use_is_told(grade: Grade, pool: Pool, words: tuple[str, ...], says: str) -> None:
    run = grade(*words)
    assert run.code == 2 and says in run.err and pool.tasks == []


def test_submissions_that_are_not_there_are_told(grade: Grade, tmp_path: Path) -> None:
    run = grade(path=tmp_path / "none")
    assert run.code == 2 and "none" in run.err


def test_without_containment_nothing_is_run(
    grade: Grade, pool: Pool, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("course.cli.grade.obstacle_to", lambda level: "bubblewrap is not installed")
    run = grade()
    assert run.code == 4 and pool.tasks == []
    assert "bubblewrap is not installed" in run.err.replace("\n", " ")
    assert "doctor" in run.err and "--no-sandbox" in run.err
    assert not (tmp_path / "grades").exists()
    assert grade("--dry-run").code == 0


def test_without_a_sandbox_the_results_say_so(
    grade: Grade, pool: Pool, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("course.cli.grade.obstacle_to", lambda level: "bubblewrap is not installed")
    pool.answer = Result(QUIZ, Verdict.PASSED, containment="domain")
    assert grade("--no-sandbox").code == 0
    assert not any(task.contained for task in pool.tasks)
    with Results.open(tmp_path / "grades") as results:
        assert results.containments() == ("domain",)
    assert "domain" in (tmp_path / "grades/results.json").read_text()


def test_one_submission_for_gradescope(grade: Grade, submissions: Path, tmp_path: Path) -> None:
    run = grade("--single", "--gradescope", "answer/results.json", path=submissions / "ada")
    assert run.code == 0
    written = json.loads((tmp_path / "answer/results.json").read_text())
    assert written["tests"]


def test_our_error_is_told_by_the_exit_code(grade: Grade, pool: Pool) -> None:
    pool.answer = Result(QUIZ, Verdict.OUR_ERROR, fault=Feedback("It fell over."))
    run = grade()
    assert run.code == 3 and "2 our error" in run.out
    assert len(pool.tasks) == 2 * ATTEMPTS


def test_not_passed_is_no_failure_of_the_command(grade: Grade, pool: Pool) -> None:
    pool.answer = Result(QUIZ, Verdict.NOT_PASSED, (CheckResult("why", "Why", 2, Outcome.FAILED),))
    assert grade().code == 0


def test_ctrl_c_says_that_it_goes_on(grade: Grade, pool: Pool, tmp_path: Path) -> None:
    pool.answer = KeyboardInterrupt()
    run = grade()
    assert run.code == 130 and "continues from here" in run.err
    assert not (tmp_path / "grades/work").exists()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_kill_ends_it_in_order(
    grade: Grade, pool: Pool, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, number: signal.Signals
) -> None:
    def killed(*_: object) -> None:
        signal.raise_signal(number)

    monkeypatch.setattr(grade_command._Teller, "__call__", killed)
    assert grade().code == 128 + number
    assert not (tmp_path / "grades/work").exists()
    assert signal.getsignal(number) in (signal.SIG_DFL, signal.default_int_handler)


def test_a_full_disk_is_told(grade: Grade, submissions: Path) -> None:
    if not sys.platform.startswith("linux"):
        pytest.skip("needs /dev/full")
    run = grade("--out", "/dev/full/out")
    assert run.code == 4 and "cannot be saved" in run.err


def test_hostile_names_do_not_reach_the_terminal(grade: Grade, submissions: Path) -> None:
    (submissions / "ada").rename(submissions / "eve\x1b[31m\n\u202egpj")
    run = grade()
    assert run.code == 0
    assert not {"\x1b", "\u202e"} & set(run.out + run.err)


def test_help_names_every_option(grade: Grade) -> None:
    run = grade("--help")
    assert run.code == 0
    assert all(f"--{name}" in run.out for name in ("exercises", "jobs", "out", "dry-run", "no-sandbox"))
