"""Several gradings share a machine, or one has it alone."""

from __future__ import annotations

import fcntl
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from course_cluster.worker import turn

PATIENCE = 20.0
A_WHILE = 0.2


class Grading:
    """Takes its turn in a thread, and keeps it until told to release it."""

    def __init__(self, gate: Path, *, alone: bool) -> None:
        self.begun = threading.Event()
        self._go = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(gate, alone), daemon=True)
        self._thread.start()

    def _run(self, gate: Path, alone: bool) -> None:
        with turn(gate, alone=alone):
            self.begun.set()
            self._go.wait(PATIENCE)

    def end(self) -> None:
        self._go.set()
        self._thread.join(PATIENCE)


def await_place(gate: Path) -> None:
    """Wait until somebody is the next one."""
    end = time.monotonic() + PATIENCE
    with gate.with_name(f"{gate.name}.next").open("a") as place:
        while time.monotonic() < end:
            try:
                fcntl.flock(place, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                return
            fcntl.flock(place, fcntl.LOCK_UN)
            time.sleep(0.01)
    pytest.fail("nobody waits")


def test_several_run_together(tmp_path: Path) -> None:
    one, two = (Grading(tmp_path / "gate", alone=False) for _ in range(2))
    assert one.begun.wait(PATIENCE) and two.begun.wait(PATIENCE)
    one.end()
    two.end()


@pytest.mark.slow
def test_who_is_alone_waits_for_the_others_and_they_for_it(tmp_path: Path) -> None:
    gate = tmp_path / "gate"
    first = Grading(gate, alone=False)
    assert first.begun.wait(PATIENCE)
    lonely = Grading(gate, alone=True)
    await_place(gate)
    assert not lonely.begun.wait(A_WHILE)
    late = Grading(gate, alone=False)
    assert not late.begun.wait(A_WHILE)  # nobody gets past it
    first.end()
    assert lonely.begun.wait(PATIENCE)
    assert not late.begun.wait(A_WHILE)
    lonely.end()
    assert late.begun.wait(PATIENCE)
    late.end()


def test_the_turn_of_a_killed_process_is_over(tmp_path: Path) -> None:
    program = (
        "import sys; from pathlib import Path; from course_cluster.worker import turn\n"
        "with turn(Path(sys.argv[1]), alone=True): print('mine', flush=True); sys.stdin.read()"
    )
    with subprocess.Popen(
        [sys.executable, "-c", program, str(tmp_path / "gate")],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        cwd=Path(__file__).parents[3],
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"mine\n"
        waiting = Grading(tmp_path / "gate", alone=False)
        assert not waiting.begun.wait(A_WHILE)
        holder.kill()
        assert waiting.begun.wait(PATIENCE)
        waiting.end()
