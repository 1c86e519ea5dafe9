"""However a check ends (Ctrl+C, SIGTERM, SIGKILL), no process and no folder of it remains."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import psutil
import pytest

from course.grading.protocol import RecordingTask
from course.model import codec
from tests.processes import left_in

pytestmark = pytest.mark.slow

# Runs one toy grading as `check` does, and reports when the program runs.
COORDINATOR = """
import sys
from contextlib import closing
from pathlib import Path
from course.isolation.levels import isolated
from course.grading.protocol import RecordingTask
from course.grading.supervisor import ForkServer, Supervisor
from course.model import codec
from course.rosenv import find_ros, node_environment

job = codec.from_json(Path(sys.argv[1]).read_bytes(), RecordingTask, "the job")
with isolated(namespaces=sys.argv[2] == "namespaces") as where:
    with closing(ForkServer()) as one, Supervisor(where, node_environment(find_ros()), one) as supervisor:
        supervisor.record(job, 60.0, lambda text: print(text, flush=True))
"""
GRADER = """
from course.api import Grader

toy = Grader("01-toy")

@toy.scenario
def wait_for_ever(arena):
    program = arena.run("toy", "program")
    arena.until(lambda: arena.printed("running"), timeout=30)
    import os
    os.write(int(__import__("sys").argv[1]), b'{"kind": "stage", "text": "it runs"}\\n')
    arena.until(lambda: False, timeout=60)

@toy.check("never", "is never judged")
def never(recording):
    raise AssertionError
"""
PROGRAM = """
import os, signal, time
if os.fork() == 0:
    os.setsid()
    for s in (1, 2, 15): signal.signal(s, signal.SIG_IGN)
print("running", flush=True)
while True: time.sleep(600)
"""


@pytest.fixture(params=["namespaces", "domain"])
def coordinator(
    request: pytest.FixtureRequest,
    toy_job: Callable[..., RecordingTask],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> Iterator[subprocess.Popen[str]]:
    """A process that grades, at the moment when the learner's program runs."""
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    monkeypatch.setenv("TMPDIR", str(scratch))
    file = tmp_path / "job.json"
    file.write_bytes(codec.to_json(toy_job(PROGRAM, GRADER)))
    process = subprocess.Popen(
        [sys.executable, "-c", COORDINATOR, str(file), request.param],
        stdout=subprocess.PIPE,
        text=True,
        start_new_session=True,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])},
    )
    assert process.stdout is not None
    assert any("it runs" in line for line in process.stdout)
    yield process
    process.stdout.close()
    process.wait(30)


def left_over(tmp_path: Path) -> list[psutil.Process]:
    """Processes of the toy that still run 10 s after its coordinator has ended.

    Its name is in the command line of the program, and in the environment of the grading process.
    """
    own = [
        process
        for process in psutil.process_iter(["cmdline", "environ"])
        if str(tmp_path) in f"{process.info['cmdline']} {process.info['environ']}"
    ]
    _, alive = psutil.wait_procs(own, timeout=10)
    return alive


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL], ids=lambda s: s.name)
def test_nothing_is_left(coordinator: subprocess.Popen[str], number: signal.Signals, tmp_path: Path) -> None:
    coordinator.send_signal(number)
    coordinator.wait(30)
    assert left_over(tmp_path) == []
    assert left_in(tmp_path / "scratch") == []


def test_the_grading_process_is_killed(coordinator: subprocess.Popen[str], tmp_path: Path) -> None:
    """If only it is killed, it cannot clean up, so its parent does."""
    for child in psutil.Process(coordinator.pid).children(recursive=True):
        with contextlib.suppress(psutil.NoSuchProcess):  # zombies included
            if "course.grading.recording_process" in child.cmdline():
                child.kill()
    coordinator.wait(30)
    assert left_over(tmp_path) == []
    assert left_in(tmp_path / "scratch") == []
