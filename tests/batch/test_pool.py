"""Workers: whatever happens to one, each task gets its grading, and none outlives the pool."""

from __future__ import annotations

import threading
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

from course import child
from course.batch import pool
from course.batch.gradings import GRADINGS, Graded, GradingTask, Unit
from course.batch.pool import Pool
from course.model import replace
from course.model.result import Verdict
from tests.batch.samples import people
from tests.processes import none_stays

ODD = replace(GRADINGS, worker="tests.batch.odd_worker")


@pytest.fixture(autouse=True)
def odd_worker(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(pool, "_DEATH_TIME", 0.5)
    with none_stays():
        yield


def tasks(*exercises: str, evidence: Path = Path("none")) -> Iterator[GradingTask]:
    for number, exercise in enumerate(exercises):
        yield GradingTask(Unit(f"p{number}", exercise), "home", str(evidence))


def graded(each: Iterable[GradingTask], jobs: int = 1) -> list[Graded]:
    waiting = iter(each)
    return list(Pool(ODD, jobs, lambda: next(waiting, None)).results())


def test_each_task_is_answered_once() -> None:
    found = graded(tasks(*["fine"] * 9), jobs=3)
    assert people(found) == [f"p{n}" for n in range(9)]
    assert {each.result.verdict for each in found} == {Verdict.PASSED}


def test_a_worker_grades_one_after_another() -> None:
    assert len({each.result.containment for each in graded(tasks("fine", "fine", "fine"))}) == 1


def test_what_a_worker_says_is_no_answer() -> None:
    said: list[str] = []
    waiting = iter(tasks("talks", "fine"))
    found = list(Pool(ODD, 1, lambda: next(waiting, None), said.append).results())
    assert [each.result.verdict for each in found] == [Verdict.PASSED, Verdict.PASSED]
    assert said == ["Building a", "Building b"]


def test_without_work_no_process_is_started(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(child.subprocess, "Popen", None)
    assert graded([], jobs=2) == []


@pytest.mark.slow
@pytest.mark.parametrize(
    ("way", "words"),
    [
        ("killed", "ended with -9"),
        ("leaves", "ended with 7"),
        ("rubbish", "make no sense"),
        ("bytes", "make no sense"),
        ("half", "ended with -9"),
        ("other", "answered for something else"),
    ],
)
def test_a_worker_that_fails_is_our_error_and_the_next_task_gets_a_new_one(
    way: str, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    if words.startswith("ended"):
        monkeypatch.setattr(pool, "_DEATH_TIME", 30.0)
    first, broken, last = graded(tasks("fine", way, "fine"))
    assert broken.unit == Unit("p1", way)
    assert broken.result.verdict is Verdict.OUR_ERROR
    assert broken.result.fault and words in broken.result.fault.summary
    assert first.result.verdict is last.result.verdict is Verdict.PASSED
    assert first.result.containment != last.result.containment


@pytest.mark.slow
@pytest.mark.parametrize("way", ["hangs", "stops"])
def test_a_worker_that_hangs_is_ended(way: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def each_with_its_limit() -> Iterator[GradingTask]:
        hangs, fine = tasks(way, "fine", evidence=tmp_path / "begun")
        monkeypatch.setattr(pool, "TIME_LIMIT", 2.0)
        yield hangs
        monkeypatch.setattr(pool, "TIME_LIMIT", 60.0)
        yield fine

    hung, fine = graded(each_with_its_limit())
    assert hung.result.fault and "did not finish within 2 s" in hung.result.fault.summary
    assert fine.result.verdict is Verdict.PASSED


@pytest.mark.slow
@pytest.mark.parametrize("way", ["hangs", "deaf"])
def test_whoever_stops_listening_ends_the_workers(
    way: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(pool, "_END_TIME", 1.0)
    begun = tmp_path / "begun"
    waiting = tasks("fine", way, "fine", evidence=begun)
    results = Pool(ODD, 1, lambda: next(waiting, None)).results()
    next(results)
    while not begun.exists():
        threading.Event().wait(0.02)
    results.close()
    assert [task.unit.person for task in waiting] == ["p2"]


def test_an_error_of_who_hands_out_tasks_comes_through() -> None:
    def next_task() -> GradingTask | None:
        raise LookupError("no more")

    with pytest.raises(LookupError, match="no more"):
        list(Pool(ODD, 2, next_task).results())
