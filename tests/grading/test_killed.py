"""If someone kills our process, it is never the learner's failure, but leads to another attempt."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import psutil
import pytest

from course.grading.protocol import RecordingTask
from course.isolation import Level
from course.isolation.levels import MachinePlaces, isolated, obstacle_to
from course.isolation.view import view
from course.model import replace
from course.model.result import Doubt, Outcome
from course.rosenv import find_ros, node_environment
from tests.grading.conftest import GRADER, Graded, graded, supervised
from tests.processes import ours_below, words_of

pytestmark = pytest.mark.slow
REPO = Path(__file__).parents[2]
OF_A_GRADING = (
    "outer layer's bubblewrap",
    "outer layer's first process",
    "guard",
    "grading process",
    "launcher",
    "measuring process",
    "sandbox's bubblewrap",
    "sandbox's first process",
)
FORK_SERVER = "fork server"
ENDS = ("was killed from outside", "ended without a recording", "busy this machine is has ended")
# A program of ours, which continues until Ctrl+C if nobody is killed.
OURS = 'ours = arena.start_ours("sleep", "61.5", name="ours", env={})'
RUN = "    program = arena.run("
PROGRAM = """
import time
print("up", flush=True)
try:
    time.sleep(4)
    print("go", flush=True)
    time.sleep(60)
except KeyboardInterrupt:
    pass
"""


def kinds(top: psutil.Process) -> dict[str, psutil.Process]:
    return dict(ours_below(top))


def judged(job: RecordingTask, folder: Path, strike: Callable[[psutil.Process], None]) -> Graded:
    """The judgment of a contained grading; strike: called with this process when the program runs."""
    ros, top = find_ros(), psutil.Process()
    with isolated(MachinePlaces((REPO, folder, Path(sys.prefix), Path(sys.base_prefix)))) as where:
        seen = view(ros, job.environment, [folder / "prefix"])
        job = replace(job, sandbox=where.sandbox(seen))
        with supervised(where, node_environment(ros)) as supervisor, ThreadPoolExecutor(1) as pool:
            judgment = pool.submit(graded, supervisor, job, 60.0)
            wait_until(lambda: judgment.done() or bool(running(top, "toy/program")))
            strike(top)
            return judgment.result()


def running(top: psutil.Process, word: str) -> list[psutil.Process]:
    """Programs with this word among their arguments."""
    below = top.children(recursive=True)
    return [process for process in below if any(word in each for each in words_of(process)[1:])]


def wait_until(condition: Callable[[], bool]) -> None:
    deadline = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.02)


@pytest.fixture
def job(toy_job: Callable[..., RecordingTask]) -> RecordingTask:
    if obstacle := obstacle_to(Level.CONTAINED):
        pytest.skip(f"not exercised here: our own processes can be killed without harm ({obstacle})")
    return toy_job(PROGRAM, GRADER.replace(RUN, f"    {OURS}\n{RUN}"))


def test_undisturbed_it_passes(job: RecordingTask, tmp_path: Path) -> None:
    """Otherwise the others prove little; and all kinds of our processes are there."""
    seen: dict[str, psutil.Process] = {}
    judgment = judged(job, tmp_path, lambda top: seen.update(kinds(top)))
    assert judgment.fault is None
    assert {check.outcome for check in judgment.checks} == {Outcome.PASSED}
    assert {*seen} == {*OF_A_GRADING, FORK_SERVER}


@pytest.mark.parametrize("kind", OF_A_GRADING)
def test_a_killed_process_of_ours_is_no_failure(job: RecordingTask, tmp_path: Path, kind: str) -> None:
    judgment = judged(job, tmp_path, lambda top: kinds(top)[kind].kill())
    assert judgment.checks == () and judgment.fault is not None
    assert judgment.doubt is Doubt.SPOILT
    assert any(words in judgment.fault.summary for words in ENDS)


def test_who_was_forked_needs_the_fork_server_no_more(job: RecordingTask, tmp_path: Path) -> None:
    judgment = judged(job, tmp_path, lambda top: kinds(top)[FORK_SERVER].kill())
    assert judgment.fault is None
    assert {check.outcome for check in judgment.checks} == {Outcome.PASSED}


def test_a_killed_program_of_ours_is_no_failure(job: RecordingTask, tmp_path: Path) -> None:
    judgment = judged(job, tmp_path, lambda top: running(top, "61.5")[-1].kill())
    assert judgment.doubt is Doubt.SPOILT and judgment.fault is not None
    assert "One of the course's own programs (ours) was killed from outside." in judgment.fault.summary


def test_a_killed_program_of_the_learners_gets_another_attempt(job: RecordingTask, tmp_path: Path) -> None:
    """They can do it themselves, so it is their failure if it happens each time: see `test_attempts`."""
    judgment = judged(job, tmp_path, lambda top: running(top, "toy/program")[-1].kill())
    assert (judgment.fault, judgment.doubt) == (None, Doubt.KILLED)
    assert [check.outcome for check in judgment.checks][-2:] == [Outcome.FAILED, Outcome.SKIPPED]
