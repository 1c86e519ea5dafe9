"""How late this machine lets programs continue, measured where no submission can interfere."""

from __future__ import annotations

import ctypes
import json
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.arena import lateness_program
from course.arena.lateness import Lateness, measured_lateness
from course.arena.lateness_program import LITTLE, NOTED, OWN_DOING, STARVED, Usage, Watch, longest
from course.evidence.timeline import Timeline
from course.model.events import Late, Watched
from course.model.feedback import Spoilt

from .conftest import WAIT

SPIN = (sys.executable, "-c", "while True: pass")


class Clock:
    """Replaces the machine's clock."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 100.0
        monkeypatch.setattr(lateness_program.time, "monotonic", lambda: self.now)


class Used(Usage):
    """A constant number of busy CPUs."""

    def __init__(self, clock: Clock, cpus: float, *, stopped: bool = False) -> None:
        self.period = 0.1
        self.little = LITTLE
        self.stopped = stopped
        self.cpus = cpus
        self.waiting = 0.0
        self.seconds = 0.0
        self._clock, self._before = clock, clock.now

    def read(self) -> None:
        passed, self._before = self._clock.now - self._before, self._clock.now
        self.seconds += passed * self.cpus

    def waits(self) -> dict[int, float]:
        return {1: 0.0, 2: self.waiting}


def told(watch: Watch) -> tuple[list[float], float]:
    found = json.loads(watch.tell())
    return [seconds for _, seconds in found["late"]], found["used"]


@pytest.mark.parametrize(
    ("cpus", "late", "noted"),
    [
        (0.0, NOTED / 2, []),
        (0.0, 2 * NOTED, [2 * NOTED]),
        (0.0, 0.3, [0.3]),
        (0.9 * OWN_DOING, 0.3, [0.3]),
        (1.1 * OWN_DOING, 0.3, []),  # a program that keeps the machine busy has to wait for itself
    ],
)
def test_only_what_others_caused_is_late(
    monkeypatch: pytest.MonkeyPatch, cpus: float, late: float, noted: list[float]
) -> None:
    clock = Clock(monkeypatch)
    watch = Watch(Used(clock, cpus))
    wanted = clock.now + 1.0
    clock.now = wanted + late
    watch.look(wanted)
    assert told(watch) == (pytest.approx(noted), pytest.approx(cpus))
    clock.now += 1.0
    assert told(watch) == ([], pytest.approx(cpus))


def test_a_burst_explains_no_other_moment(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock(monkeypatch)
    usage = Used(clock, 2.0)
    watch = Watch(usage)
    clock.now += 0.2
    watch.look(clock.now)
    usage.cpus = 0.0
    clock.now += 0.5
    watch.look(clock.now - 0.4)
    assert told(watch)[0] == pytest.approx([0.4])


def test_a_stopped_grading_process_is_late_whatever_else_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock(monkeypatch)
    watch = Watch(Used(clock, 2.0, stopped=True))
    for _ in range(4):
        clock.now += 0.5
        watch.look(clock.now)
    assert max(told(watch)[0]) == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("cpus", "waited", "noted"),
    [(0.1, 1.01 * STARVED, True), (0.1, 0.99 * STARVED, False), (1.1 * LITTLE, 1.0, False)],
)
def test_a_thread_that_hardly_runs_is_starved(
    monkeypatch: pytest.MonkeyPatch, cpus: float, waited: float, noted: bool
) -> None:
    """A sleeping thread continues at once, so no look is late."""
    clock = Clock(monkeypatch)
    usage = Used(clock, cpus)
    watch = Watch(usage)
    for _ in range(30):
        clock.now += 0.1
        usage.waiting += 0.1 * waited
        watch.look(clock.now)
    assert [seconds > 1.5 for seconds in told(watch)[0]] == [True] * noted


@pytest.fixture
def child() -> Iterator[subprocess.Popen[bytes]]:
    """A child process that wants a whole processor."""
    with subprocess.Popen(SPIN) as process:
        yield process
        process.kill()


def test_what_runs_below_the_grading_process_counts(child: subprocess.Popen[bytes]) -> None:
    usage = Usage(os.getpid(), [])
    begun, own = usage.seconds, sum(os.times()[:2])

    def used() -> bool:
        usage.read()
        return usage.seconds - begun > sum(os.times()[:2]) - own + 0.2  # more than this process used itself

    assert any(used() for _ in ticks())
    child.kill()
    child.wait()
    usage = Usage(os.getpid(), [])
    assert usage.seconds >= begun + 0.2  # even after it has ended


def test_threads_that_want_to_run_have_waited(child: subprocess.Popen[bytes]) -> None:
    """More programs than processors, and each wants one."""
    usage = Usage(os.getpid(), [])
    others = [subprocess.Popen(SPIN) for _ in os.sched_getaffinity(0)]
    try:
        before = usage.waits()
        assert any(longest(before, usage.waits()) > 0.1 for _ in ticks())
        assert {child.pid, *(other.pid for other in others)} <= usage.waits().keys()
    finally:
        for other in others:
            other.kill()
            other.wait()


def ticks() -> Iterator[None]:
    """Wait until something must have happened."""
    for _ in range(int(WAIT / 0.05)):
        threading.Event().wait(0.05)
        yield


def test_of_control_groups_both_versions_are_read(tmp_path: Path) -> None:
    (tmp_path / "one").mkdir()
    (tmp_path / "one" / "cpuacct.usage").write_text("3500000000\n")
    (tmp_path / "two").mkdir()
    (tmp_path / "two" / "cpu.stat").write_text("usage_usec 1250000\nuser_usec 7\n")
    (tmp_path / "memory").mkdir()
    groups = [str(tmp_path / name) for name in ("one", "two", "memory")]
    assert (Usage(os.getpid(), groups).little, Usage(os.getpid(), []).little) == (LITTLE, OWN_DOING)
    own = sum(os.times()[:2])
    assert 4.7 <= Usage(os.getpid(), groups).seconds <= 4.8 + own + 1.0


def test_a_process_that_somebody_stops_is_seen_from_outside(child: subprocess.Popen[bytes]) -> None:
    child.send_signal(signal.SIGSTOP)
    program = (sys.executable, "-I", "-S", lateness_program.__file__, str(child.pid))
    with subprocess.Popen(program, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0) as process:
        assert process.stdin is not None and process.stdout is not None
        measured = Lateness(process.stdin, process.stdout, Timeline())
        assert any(measured.update() > 0.5 for _ in ticks())
        process.stdin.close()
        assert process.wait(WAIT) == 0


def test_a_lock_in_this_process_makes_nothing_late() -> None:
    """One long call that lets no other thread run would look like a busy machine to our thread."""
    with measured_lateness(Timeline()) as measured:
        measured.update()
        ctypes.PyDLL(None).usleep(2_000_000)
        assert measured.update() < 1.0


def test_a_machine_that_lets_nobody_go_on_is_late() -> None:
    """The measuring process itself is delayed, like everything else."""
    with measured_lateness(Timeline()) as measured:
        measured.update()
        (number,) = _children()
        for _ in ticks():  # it may have been in the middle of an answer
            os.kill(number, signal.SIGSTOP)
            threading.Event().wait(0.5)
            os.kill(number, signal.SIGCONT)
            if measured.update() > 0.3:
                break
        assert measured.worst > 0.3
    assert _children() == []


def test_one_that_has_ended_is_not_believed_to_be_quiet() -> None:
    with measured_lateness(Timeline()) as measured:
        measured.update()
        os.kill(_children()[0], signal.SIGKILL)
        with pytest.raises(Spoilt, match="has ended"):
            measured.update()


def _children() -> list[int]:
    found = (Path(task, "children").read_text().split() for task in Path("/proc/self/task").iterdir())
    return [int(pid) for pids in found for pid in pids]


class Told(Lateness):
    """Gives answers without a process."""

    def __init__(self, timeline: Timeline, *answers: dict[str, object]) -> None:
        self.worst = 0.0
        self._timeline = timeline
        self._waiting = iter(answers)

    def _ask(self) -> dict[str, object]:
        return next(self._waiting)


@pytest.mark.parametrize(("used", "waited"), [(0.9 * OWN_DOING, 0.25), (1.1 * OWN_DOING, 0.0)])
def test_what_happens_within_is_noted(used: float, waited: float) -> None:
    timeline = Timeline()
    late = [(lateness_program.time.monotonic(), 0.003)]
    before: dict[str, object] = {"late": [(1.0, 9.0)], "used": 0.0, "waited": 7.0}
    measured = Told(timeline, before, {"late": late, "used": used, "waited": 0.25})
    with measured.noted():
        pass
    assert [event.seconds for event in timeline.of(Late)] == [0.003]
    assert all(0.0 <= event.t <= timeline.now() for event in timeline.of(Late))
    assert [(event.on, event.waited) for event in timeline.of(Watched)] == [(True, 0.0), (False, waited)]


def test_threads_that_have_ended_or_begun() -> None:
    assert longest({1: 2.0}, {}) == 0.0
    assert longest({}, {1: 2.0}) == 2.0
    assert longest({1: 0.5, 2: 7.0}, {1: 0.75, 2: 7.125, 3: 0.0625}) == 0.25
