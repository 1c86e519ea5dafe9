"""What a worker does with a submission, and that nothing of it remains."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from course.batch.gradings import Graded, GradingTask, Unit
from course.model import codec
from course.model.result import Result, Verdict
from course_cluster import worker
from course_cluster.parcel import pack
from course_cluster.worker import Answer, GradingPlugin
from tests.batch.samples import PASSED, names

PATIENCE = 20.0
TASK = GradingTask(Unit("ann", "04-light"), "/theirs/home", "/theirs/04-light.mcap")


class Process:
    """A fake grading process."""

    def __init__(self, does: Callable[[GradingTask], Result]) -> None:
        self._does = does
        self.interrupted = threading.Event()
        self.closed = False

    def do(self, task: GradingTask) -> Graded:
        return Graded(task.unit, self._does(task), 1.0)

    def interrupt(self) -> None:
        self.interrupted.set()

    def close(self) -> None:
        self.closed = True


class Machine:
    """A worker's plugin on its own machine: `scratch` contains its submissions."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self._home = folder / "home"
        (self._home / "src").mkdir(parents=True)
        (self._home / "src" / "a.py").write_text("print(1)\n")
        self.scratch = folder / "scratch"
        self.scratch.mkdir()
        self.processes: list[Process] = []
        self.does: Callable[[GradingTask], Result] = lambda task: PASSED
        monkeypatch.setattr(worker, "Process", lambda gradings: self._process())
        self.plugin = GradingPlugin()

    def _process(self) -> Process:
        self.processes.append(Process(lambda task: self.does(task)))
        return self.processes[-1]

    def grade(self, home: bytes | None = None, alone: bool = False, key: str = "grade-1") -> Answer:
        return self.plugin.grade(key, TASK, pack(self._home) if home is None else home, alone, self.scratch)


@pytest.fixture
def machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Machine:
    return Machine(tmp_path, monkeypatch)


def test_it_is_graded_in_a_folder_that_is_gone_afterwards(machine: Machine) -> None:
    def look(task: GradingTask) -> Result:
        assert Path(task.home, "src", "a.py").read_text() == "print(1)\n"
        assert Path(task.home).is_relative_to(machine.scratch)
        Path(task.evidence).parent.mkdir()
        Path(task.evidence).write_bytes(b"mcap")
        return PASSED

    machine.does = look
    line, evidence = machine.grade()
    assert codec.from_json(line, Graded, "it").result == PASSED
    assert evidence == b"mcap"
    assert names(machine.scratch) == set()


def test_a_thread_keeps_its_process(machine: Machine) -> None:
    for _ in range(3):
        machine.grade()
    assert len(machine.processes) == 1


def test_whatever_goes_wrong_nothing_stays(machine: Machine) -> None:
    def fall(task: GradingTask) -> Result:
        raise RuntimeError("bug")

    machine.does = fall
    with pytest.raises(RuntimeError):
        machine.grade()
    assert names(machine.scratch) == set()


@pytest.mark.parametrize("home", [b"", b"no archive"])
def test_bytes_that_cannot_be_opened_are_our_error(machine: Machine, home: bytes) -> None:
    line, evidence = machine.grade(home)
    assert (codec.from_json(line, Graded, "it").result.verdict, evidence) == (Verdict.OUR_ERROR, None)
    assert names(machine.scratch) == set()


def test_a_full_disk_is_our_error(machine: Machine) -> None:
    machine.scratch.rmdir()
    result = codec.from_json(machine.grade()[0], Graded, "it").result
    assert result.verdict is Verdict.OUR_ERROR and result.fault and "no space" in result.fault.summary


def test_what_nobody_waits_for_any_more_is_interrupted(machine: Machine) -> None:
    begun = threading.Event()

    def wait(task: GradingTask) -> Result:
        begun.set()
        assert machine.processes[0].interrupted.wait(PATIENCE)
        return PASSED

    machine.does = wait
    thread = threading.Thread(target=machine.grade)
    thread.start()
    assert begun.wait(PATIENCE)
    machine.plugin.transition("grade-2", "executing", "cancelled")
    machine.plugin.transition("grade-1", "executing", "memory")
    assert not machine.processes[0].interrupted.is_set()
    machine.plugin.transition("grade-1", "executing", "cancelled")
    thread.join(PATIENCE)
    assert machine.processes[0].interrupted.is_set()
    assert machine.processes[0].closed  # a signal that came late must not hit the next grading
    assert names(machine.scratch) == set()


def test_called_off_before_its_turn_it_is_not_graded(
    machine: Machine, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = worker.unpack

    def slow(packed: bytes, folder: Path) -> Path:
        machine.plugin.transition("grade-1", "executing", "cancelled")
        return real(packed, folder)

    monkeypatch.setattr(worker, "unpack", slow)
    machine.does = lambda task: pytest.fail("graded")
    assert codec.from_json(machine.grade()[0], Graded, "it").result.verdict is Verdict.OUR_ERROR


def test_at_its_end_all_processes_are_told(machine: Machine) -> None:
    machine.grade()
    machine.plugin.teardown(None)  # type: ignore[arg-type]
    assert machine.processes[0].interrupted.is_set()
