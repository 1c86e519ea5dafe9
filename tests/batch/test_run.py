"""A class: each unit once, retried after our error, resumed after an earlier run was stopped."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from course.batch import run as running
from course.batch.batch_plan import plan_batch
from course.batch.gradings import Graded, GradingTask
from course.batch.results import Results
from course.batch.run import Batch, BatchProgress, results_folder, run
from course.content import Course
from course.errors import StorageError, UsageError
from course.files import wipe
from course.grading.attempts import ATTEMPTS
from course.model.result import Feedback, Outcome, Result, Verdict
from tests.batch.conftest import Lay
from tests.batch.samples import PASSED, QUIZ, names

Answer = Callable[[GradingTask], Result]


class Told:
    """Keeps the reports of progress; may stop the run."""

    def __init__(self, stop_after: int | None = None) -> None:
        self.progress: list[BatchProgress] = []
        self.graded: list[Graded] = []
        self._stop_after = stop_after

    def __call__(self, progress: BatchProgress, graded: Graded | None) -> None:
        self.progress.append(progress)
        if graded:
            self.graded.append(graded)
            if len(self.graded) == self._stop_after:
                raise KeyboardInterrupt


class Workers:
    """A fake pool: grades in this process, and keeps how many at once were requested."""

    def __init__(self, answer: Answer) -> None:
        self.jobs: list[int] = []
        self.tasks: list[GradingTask] = []
        self._answer = answer

    def __call__(self, jobs: int, next_task: Callable[[], GradingTask | None], say: object) -> Workers:
        self.jobs.append(jobs)
        self._next_task = next_task
        return self

    def results(self) -> Iterator[Graded]:
        while (task := self._next_task()) is not None:
            self.tasks.append(task)
            yield Graded(task.unit, self._answer(task), 0.1)


@pytest.fixture
def batch(lay: Lay, quiz_course: Course, tmp_path: Path) -> Callable[..., Batch]:
    def of(*people: str, jobs: int = 2) -> Batch:
        folder = lay(*people)
        planned = plan_batch(folder, tmp_path / "opened", quiz_course, [QUIZ], single=False)
        return Batch(tmp_path / "out", planned, jobs, quiz_course.root)

    return of


@pytest.fixture
def workers(monkeypatch: pytest.MonkeyPatch) -> Callable[[Answer], Workers]:
    def of(answer: Answer) -> Workers:
        stand_in = Workers(answer)
        monkeypatch.setattr(running, "Pool", lambda work, *given: stand_in(*given))
        return stand_in

    return of


def ran(batch: Batch, told: Told | None = None) -> Told:
    told = told or Told()
    with results_folder(batch.out) as results:
        run(batch, results, told)
    return told


def passes(task: GradingTask) -> Result:
    return Result(task.unit.exercise, Verdict.PASSED, PASSED.checks)


def falls_over(task: GradingTask) -> Result:
    return Result(task.unit.exercise, Verdict.OUR_ERROR, fault=Feedback("It fell over."))


def kept(out: Path) -> dict[str, Verdict]:
    with Results.open(out, create=False) as results:
        everybody = results.submissions()
        return {
            one.person: stored.result.verdict for one in everybody for stored in results.gradings(one.person)
        }


@pytest.mark.slow
def test_a_class_is_graded_for_real(batch: Callable[..., Batch], lay: Lay, tmp_path: Path) -> None:
    lay("eve", mistake="saves-oil")
    told = ran(batch("ada", "bao"))
    assert kept(tmp_path / "out") == {
        "ada": Verdict.PASSED,
        "bao": Verdict.PASSED,
        "eve": Verdict.NOT_PASSED,
    }
    (eve,) = (graded.result for graded in told.graded if graded.unit.person == "eve")
    assert [check.id for check in eve.checks if check.outcome is Outcome.FAILED] == ["why"]
    assert told.progress[0] == BatchProgress(3, 0)
    assert names(tmp_path / "out") == {"answers", "grades.sqlite3", "lock", "work"}
    assert names(tmp_path / "out/work") == set()


def test_what_was_graded_is_not_graded_again(
    batch: Callable[..., Batch], workers: Callable[[Answer], Workers]
) -> None:
    pool = workers(passes)
    ran(batch("ada", "bao"))
    told = ran(batch("ada", "bao", "cleo"))
    assert [task.unit.person for task in pool.tasks] == ["ada", "bao", "cleo"]
    assert told.progress[0] == BatchProgress(3, 2)


def test_a_changed_submission_is_graded_again(
    batch: Callable[..., Batch], workers: Callable[[Answer], Workers], lay: Lay
) -> None:
    pool = workers(passes)
    ran(batch("ada", "bao"))
    (lay("bao") / f"bao/answers/{QUIZ}.yaml").write_text("why: tell-apart\n")
    planned = batch("ada").planned
    assert planned.found[1].person.id == "bao"
    ran(batch("ada"))
    assert [task.unit.person for task in pool.tasks] == ["ada", "bao", "bao"]


def test_stopped_in_the_middle_it_goes_on_from_there(
    batch: Callable[..., Batch], workers: Callable[[Answer], Workers], tmp_path: Path
) -> None:
    pool = workers(passes)
    with pytest.raises(KeyboardInterrupt):
        ran(batch("ada", "bao", "cleo"), Told(stop_after=2))
    assert kept(tmp_path / "out") == {"ada": Verdict.PASSED, "bao": Verdict.PASSED}
    assert names(tmp_path / "out/work") == set()
    ran(batch("ada"))
    assert [task.unit.person for task in pool.tasks] == ["ada", "bao", "cleo"]


def test_our_error_is_looked_at_again_with_nothing_beside_it(
    batch: Callable[..., Batch], workers: Callable[[Answer], Workers], tmp_path: Path
) -> None:
    pool = workers(lambda task: (passes if task.unit.person == "cleo" else falls_over)(task))
    told = ran(batch("ada", "bao", "cleo", jobs=3))
    assert pool.jobs == [3, *[1] * (ATTEMPTS - 1)]
    assert [graded.unit.person for graded in told.graded] == ["cleo", "ada", "bao"]
    assert told.graded[-1].unit.attempt == ATTEMPTS
    assert kept(tmp_path / "out")["bao"] is Verdict.OUR_ERROR


def test_what_succeeds_at_another_attempt_counts(
    batch: Callable[..., Batch], workers: Callable[[Answer], Workers], tmp_path: Path
) -> None:
    workers(lambda task: (falls_over if task.unit.attempt == 1 else passes)(task))
    ran(batch("ada"))
    assert kept(tmp_path / "out") == {"ada": Verdict.PASSED}


def test_our_error_is_graded_again_by_the_same_command(
    batch: Callable[..., Batch], workers: Callable[[Answer], Workers], tmp_path: Path
) -> None:
    workers(falls_over)
    ran(batch("ada"))
    workers(passes)
    ran(batch("ada"))
    assert kept(tmp_path / "out") == {"ada": Verdict.PASSED}


def test_a_submission_that_cannot_be_laid_out_has_a_row_like_any_other(
    batch: Callable[..., Batch],
    workers: Callable[[Answer], Workers],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    workers(passes)
    take = running.Homes.take

    def refuse(self: running.Homes, unit: running.Unit, exercise: object) -> Path:
        if unit.person == "bao":
            raise StorageError("The disk is full.", "Make room.")
        return take(self, unit, exercise)  # type: ignore[arg-type]

    monkeypatch.setattr(running.Homes, "take", refuse)
    told = ran(batch("ada", "bao"))
    assert kept(tmp_path / "out") == {"ada": Verdict.PASSED, "bao": Verdict.OUR_ERROR}
    (bao,) = (graded for graded in told.graded if graded.unit.person == "bao")
    assert bao.result.fault == Feedback("The disk is full.", advice="Make room.")


def test_old_evidence_is_not_taken_for_new(
    batch: Callable[..., Batch], workers: Callable[[Answer], Workers], tmp_path: Path
) -> None:
    evidence = tmp_path / f"out/evidence/ada/{QUIZ}.mcap"
    evidence.parent.mkdir(parents=True)
    evidence.write_text("of another attempt")
    (evidence.parent / f".{QUIZ}.mcap.7").write_text("half-writ")
    workers(passes)
    ran(batch("ada"))
    assert names(evidence.parent) == set()
    with Results.open(tmp_path / "out") as results:
        assert results.gradings("ada")[0].evidence is None


def test_new_evidence_is_noted(
    batch: Callable[..., Batch], workers: Callable[[Answer], Workers], tmp_path: Path
) -> None:
    def records(task: GradingTask) -> Result:
        Path(task.evidence).parent.mkdir(parents=True)
        Path(task.evidence).write_text("recording")
        return passes(task)

    workers(records)
    ran(batch("ada"))
    with Results.open(tmp_path / "out") as results:
        assert results.gradings("ada")[0].evidence == f"evidence/ada/{QUIZ}.mcap"


def test_recordings_and_answers_of_those_who_are_gone_go(
    batch: Callable[..., Batch], workers: Callable[[Answer], Workers], tmp_path: Path
) -> None:
    def records(task: GradingTask) -> Result:
        Path(task.evidence or "").parent.mkdir(parents=True)
        Path(task.evidence or "").touch()
        return passes(task)

    workers(records)
    ran(batch("ada", "bao"))
    wipe(tmp_path / "class/bao")
    ran(batch("ada"))
    for folder in ("evidence", "answers"):
        assert names(tmp_path / "out" / folder) == {"ada"}


def test_two_do_not_grade_into_one_folder(tmp_path: Path) -> None:
    with (
        results_folder(tmp_path / "out"),
        pytest.raises(UsageError, match="Somebody else is grading"),
        results_folder(tmp_path / "out"),
    ):
        pass
    with results_folder(tmp_path / "out"):
        pass


@pytest.mark.parametrize(
    "name",
    [
        f"{name}.99999999-77aa.ros2course-part"
        for name in (".results.csv", "feedback/.ada.md", "evidence/ada/.q.mcap")
    ],
)
def test_what_a_killed_run_left_half_written_goes(tmp_path: Path, name: str) -> None:
    half = tmp_path / "out" / name
    half.parent.mkdir(parents=True)
    half.touch()
    with results_folder(tmp_path / "out"):
        assert not half.exists()


@pytest.fixture
def deep(tmp_path: Path) -> Iterator[Path]:
    """The folder of results, whose `work` contains more nested folders than fit into one path."""
    work = tmp_path / "out/work"
    work.mkdir(parents=True)
    here = os.open(work, os.O_DIRECTORY)
    for _ in range(1500):
        os.mkdir("d", dir_fd=here)
        inner = os.open("d", os.O_DIRECTORY, dir_fd=here)
        os.close(here)
        here = inner
    os.close(here)
    yield work.parent
    wipe(work)  # pytest could not


def test_what_a_killed_run_left_of_a_submission_may_be_deep(deep: Path) -> None:
    with results_folder(deep) as results:
        assert results.submissions() == []


def test_a_folder_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with (
        pytest.raises(StorageError, match="results cannot be saved"),
        results_folder(tmp_path / "file" / "out"),
    ):
        pass
