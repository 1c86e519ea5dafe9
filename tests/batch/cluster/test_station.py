"""What a worker does with a submission, and that nothing of it stays."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from course.batch.cluster import station
from course.batch.cluster.parcel import pack
from course.batch.cluster.station import Answer, Station
from course.batch.model import Graded, Task, Unit, graded_from_line
from course.grading.result import Result, Verdict
from tests.batch.samples import PASSED, names

PATIENCE = 20.0
TASK = Task(Unit("ann", "04-light"), "/theirs/home", "/theirs/04-light.mcap")


class Process:
    """Stands in for a grading process."""

    def __init__(self, does: Callable[[Task], Result]) -> None:
        self._does = does
        self.interrupted = threading.Event()
        self.closed = False

    def grade(self, task: Task) -> Graded:
        return Graded(task.unit, self._does(task), 1.0)

    def interrupt(self) -> None:
        self.interrupted.set()

    def close(self) -> None:
        self.closed = True


class Desk:
    """A station on a machine of its own: `scratch` is where its submissions lie."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self._home = folder / "home"
        (self._home / "src").mkdir(parents=True)
        (self._home / "src" / "a.py").write_text("print(1)\n")
        self.scratch = folder / "scratch"
        self.scratch.mkdir()
        self.processes: list[Process] = []
        self.does: Callable[[Task], Result] = lambda task: PASSED
        monkeypatch.setattr(station, "GradingProcess", self._process)
        self.station = Station()

    def _process(self) -> Process:
        self.processes.append(Process(lambda task: self.does(task)))
        return self.processes[-1]

    def grade(self, home: bytes | None = None, alone: bool = False, key: str = "grade-1") -> Answer:
        return self.station.grade(key, TASK, pack(self._home) if home is None else home, alone, self.scratch)


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Desk:
    return Desk(tmp_path, monkeypatch)


def test_it_is_graded_in_a_folder_that_is_gone_afterwards(desk: Desk) -> None:
    def look(task: Task) -> Result:
        assert Path(task.home, "src", "a.py").read_text() == "print(1)\n"
        assert Path(task.home).is_relative_to(desk.scratch)
        Path(task.evidence).parent.mkdir()
        Path(task.evidence).write_bytes(b"mcap")
        return PASSED

    desk.does = look
    line, evidence = desk.grade()
    assert graded_from_line(line).result == PASSED
    assert evidence == b"mcap"
    assert names(desk.scratch) == set()


def test_a_thread_keeps_its_process(desk: Desk) -> None:
    for _ in range(3):
        desk.grade()
    assert len(desk.processes) == 1


def test_whatever_goes_wrong_nothing_stays(desk: Desk) -> None:
    def fall(task: Task) -> Result:
        raise RuntimeError("bug")

    desk.does = fall
    with pytest.raises(RuntimeError):
        desk.grade()
    assert names(desk.scratch) == set()


@pytest.mark.parametrize("home", [b"", b"no archive"])
def test_bytes_that_cannot_be_opened_are_our_error(desk: Desk, home: bytes) -> None:
    line, evidence = desk.grade(home)
    assert (graded_from_line(line).result.verdict, evidence) == (Verdict.OUR_ERROR, None)
    assert names(desk.scratch) == set()


def test_a_full_disk_is_our_error(desk: Desk) -> None:
    desk.scratch.rmdir()
    result = graded_from_line(desk.grade()[0]).result
    assert result.verdict is Verdict.OUR_ERROR and result.fault and "no room" in result.fault.summary


def test_what_nobody_waits_for_any_more_is_interrupted(desk: Desk) -> None:
    begun = threading.Event()

    def wait(task: Task) -> Result:
        begun.set()
        assert desk.processes[0].interrupted.wait(PATIENCE)
        return PASSED

    desk.does = wait
    thread = threading.Thread(target=desk.grade)
    thread.start()
    assert begun.wait(PATIENCE)
    desk.station.transition("grade-2", "executing", "cancelled")
    desk.station.transition("grade-1", "executing", "memory")
    assert not desk.processes[0].interrupted.is_set()
    desk.station.transition("grade-1", "executing", "cancelled")
    thread.join(PATIENCE)
    assert desk.processes[0].interrupted.is_set()
    assert desk.processes[0].closed  # a signal that came late must not hit the next grading
    assert names(desk.scratch) == set()


def test_called_off_before_its_turn_it_is_not_graded(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    real = station.unpack

    def slow(packed: bytes, folder: Path) -> Path:
        desk.station.transition("grade-1", "executing", "cancelled")
        return real(packed, folder)

    monkeypatch.setattr(station, "unpack", slow)
    desk.does = lambda task: pytest.fail("graded")
    assert graded_from_line(desk.grade()[0]).result.verdict is Verdict.OUR_ERROR


def test_no_more_at_once_than_suits_the_processors(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(station, "default_jobs", lambda: 2)
    desk.station = Station()
    pair, most, now, lock = threading.Barrier(2), 0, 0, threading.Lock()

    def count(task: Task) -> Result:
        nonlocal most, now
        with lock:
            now += 1
            most = max(most, now)
        pair.wait(PATIENCE)
        with lock:
            now -= 1
        return PASSED

    desk.does = count
    threads = [threading.Thread(target=desk.grade, kwargs={"key": f"grade-{n}"}) for n in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(PATIENCE)
    assert most == 2


def test_at_its_end_all_processes_are_told(desk: Desk) -> None:
    desk.grade()
    desk.station.teardown(None)  # type: ignore[arg-type]
    assert desk.processes[0].interrupted.is_set()
