"""The watchdog, both ways: by the counters of control groups, and by looking at the processes."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from course.isolation.isolation_plan import ResourceLimits
from course.isolation.watchdog import (
    CPU,
    DISK,
    MEMORY,
    PROCESSES,
    Watchdog,
    filesystem,
    most_of,
    watching,
)

WAIT = 20.0
MB = 1024 * 1024
LARGE_CHILD = """
import os
reading, writing = os.pipe()
if os.fork() == 0:
    large = 'y' * 10**8
    os.close(reading)
    os.write(writing, b'!')
    os.read(0, 1)
    os._exit(0)
os.close(writing)
os.read(reading, 1)
"""


def room() -> tuple[int, int]:
    return 0, 1


def full() -> tuple[int, int]:
    return 1, 1


@contextmanager
def program(code: str) -> Iterator[int]:
    """A Python that runs this code, says "ready", and waits."""
    code = f"{code}\nprint('ready', flush=True)\ninput()"
    command = [sys.executable, "-S", "-c", code]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        yield process.pid
        process.kill()


class TestByGroups:
    @pytest.fixture
    def group(self, tmp_path: Path) -> Path:
        (tmp_path / "memory.events").write_text("oom_kill 0\n")
        (tmp_path / "pids.events").write_text("max 0\n")
        (tmp_path / "cpu.stat").write_text("usage_usec 9000000\n")
        return tmp_path

    def look(self, group: Path, scratch: object = room) -> str | None:
        assert callable(scratch)
        return Watchdog(ResourceLimits(cpu=10.0), [group], os.getpid(), scratch).look()

    def test_nothing_to_tell(self, group: Path) -> None:
        assert self.look(group) is None

    @pytest.mark.parametrize(
        ("file", "text", "limit"),
        [
            ("memory.events", "oom_kill 1\n", MEMORY),
            ("pids.events", "max 1\n", PROCESSES),
            ("cpu.stat", "usage_usec 11000000\n", CPU),
        ],
    )
    def test_what_was_noted(self, group: Path, file: str, text: str, limit: str) -> None:
        (group / file).write_text(text)
        assert self.look(group) == limit

    def test_a_full_disk(self, group: Path) -> None:
        assert self.look(group, full) == DISK

    def test_too_many_processes_take_all_the_memory_too(self, group: Path) -> None:
        (group / "memory.events").write_text("oom_kill 1\n")
        (group / "pids.events").write_text("max 1\n")
        assert self.look(group) == PROCESSES


class TestByLooking:
    def look(self, root: int, **limits: float) -> str | None:
        return Watchdog(ResourceLimits(**limits), [], root, room).look()  # type: ignore[arg-type]

    def test_nothing_to_tell(self) -> None:
        with program("") as pid:
            assert self.look(pid) is None

    def test_memory_of_a_child_counts(self) -> None:
        with program(LARGE_CHILD) as pid:
            assert self.look(pid, memory=80 * MB) == MEMORY
            assert self.look(pid, memory=800 * MB) is None

    def test_threads_count(self) -> None:
        wait = "threading.Thread(target=threading.Event().wait, daemon=True).start()"
        with program(f"import threading\nfor _ in range(30): {wait}") as pid:
            assert self.look(pid, processes=25) == PROCESSES
            assert self.look(pid, processes=50) is None

    def test_many_small_processes_are_too_many_and_not_too_large(self) -> None:
        code = "import os, signal\nfor _ in range(9):\n    if os.fork() == 0:\n        signal.pause()"
        with program(code) as pid:
            assert self.look(pid, processes=20, memory=20 * MB) == PROCESSES
            for child in children(pid):
                os.kill(child, 9)

    def test_computing_time(self) -> None:
        with program("import time\nwhile time.process_time() < 0.3: pass") as pid:
            assert self.look(pid, cpu=0.1) == CPU
            assert self.look(pid, cpu=100.0) is None

    def test_one_that_has_ended(self) -> None:
        with program("") as pid:
            pass
        assert self.look(pid) is None


def children(pid: int) -> list[int]:
    return [int(word) for word in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


class TestWatching:
    def test_the_breach_is_told_once(self) -> None:
        told: list[str] = []
        heard = threading.Event()

        def tell(limit: str) -> None:
            told.append(limit)
            heard.set()

        with watching(Watchdog(ResourceLimits(), [], os.getpid(), full), tell):
            assert heard.wait(WAIT)
        assert told == [DISK]

    def test_it_looks_a_last_time_at_the_end(self) -> None:
        """Whatever ended a program just now may be the limit."""
        told: list[str] = []
        with watching(Watchdog(ResourceLimits(), [], os.getpid(), full), told.append):
            pass
        assert told == [DISK]

    def test_nothing_is_told_when_all_is_well(self) -> None:
        told: list[str] = []
        with watching(Watchdog(ResourceLimits(memory=2**50, cpu=1e9), [], os.getpid(), room), told.append):
            pass
        assert told == []


class TestRoom:
    def test_a_file_system_that_has_some(self) -> None:
        used, most = filesystem(Path("/"))()
        status = os.statvfs("/")
        assert most == status.f_blocks * status.f_frsize
        assert used > 0

    def test_each_file_takes_a_page(self, monkeypatch: pytest.MonkeyPatch) -> None:
        empty = (4096, 4096, 1000, 1000, 1000, 5000, 4000, 4000, 0, 255)
        monkeypatch.setattr(os, "statvfs", lambda folder: os.statvfs_result(empty))
        assert filesystem(Path("/one"))() == (1000 * 4096, 1000 * 4096)
        assert filesystem(Path("/one"), [Path("/two")])()[0] == 2000 * 4096

    def test_a_further_one_that_cannot_be_seen(self) -> None:
        assert filesystem(Path("/"), [Path("/nowhere")])() == filesystem(Path("/"))()


def test_what_a_submission_may_have() -> None:
    limits = ResourceLimits(memory=1, processes=2, cpu=3.0, scratch=4)
    assert [most_of(limits, limit) for limit in (MEMORY, PROCESSES, CPU, DISK)] == [1, 2, 3.0, 4]
