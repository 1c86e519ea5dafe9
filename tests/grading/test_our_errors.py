"""Anything that goes wrong on our side is reported as our error, and never as the learner's failure."""

from __future__ import annotations

import contextlib
import errno
import os
import tempfile
from pathlib import Path
from typing import IO, Any

import pytest

from course.errors import StorageError
from course.grading.supervisor import ForkServer, Supervisor
from course.isolation.levels import isolated
from course.model.feedback import Feedback
from course.model.result import Doubt, Outcome
from course.rosenv import find_ros, node_environment

from .conftest import GRADER, Grade

pytestmark = pytest.mark.slow

LOOP = "import time\nprint('go', flush=True)\nwhile True: time.sleep(1)"


def test_a_grader_with_a_syntax_error(grade: Grade) -> None:
    judgment = grade("pass", "def broken(:\n")
    assert judgment.fault is not None
    assert "SyntaxError" in judgment.fault.summary
    assert any("toy_grader.py" in line for line in judgment.fault.details)


def test_a_scenario_that_raises(grade: Grade) -> None:
    judgment = grade(LOOP, GRADER.replace("arena.until(", "arena.unheard_of("))
    assert judgment.fault is not None
    assert "unheard_of" in judgment.fault.summary
    assert judgment.doubt is None
    assert judgment.checks == ()


def test_what_this_machine_lacks_is_no_error(grade: Grade) -> None:
    lacking = "\n    from course.errors import MissingHere\n    raise MissingHere('no g++', 'install it')"
    judgment = grade(LOOP, GRADER.replace("def run_it(arena):", f"def run_it(arena):{lacking}"))
    assert judgment.missing and judgment.checks == ()
    assert judgment.fault == Feedback("no g++", advice="install it")


def test_a_check_that_raises(grade: Grade) -> None:
    broken = GRADER.replace('expect_running(recording, "program")', "raise KeyError('ours')")
    outcomes = {check.id: check.outcome for check in grade(LOOP, broken).checks}
    assert outcomes["starts"] is Outcome.ERROR
    assert outcomes["interrupt"] is Outcome.SKIPPED


def test_a_plain_assertion_blames_nobody(grade: Grade) -> None:
    broken = GRADER.replace('expect_running(recording, "program")', "assert False")
    assert next(c.outcome for c in grade(LOOP, broken).checks if c.id == "starts") is Outcome.ERROR


def test_a_grading_process_that_crashes(grade: Grade) -> None:
    broken = GRADER.replace("def run_it(arena):", "def run_it(arena):\n    import os; os.abort()")
    judgment = grade(LOOP, broken)
    assert judgment.fault is not None
    assert "ended without a recording" in judgment.fault.summary
    assert "does not count" in (judgment.fault.advice or "")
    assert judgment.doubt is Doubt.SPOILT


def test_a_grading_process_that_hangs(grade: Grade, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("course.grading.supervisor._START_TIME", 3.0)
    broken = GRADER.replace("def run_it(arena):", "def run_it(arena):\n    import time; time.sleep(600)")
    judgment = grade(LOOP, broken, time_limit=1.0)
    assert judgment.fault is not None
    assert "did not finish within 1 s" in judgment.fault.summary
    assert judgment.doubt is Doubt.SPOILT


def test_a_grading_process_that_crashes_before_anything_of_the_submission_runs(grade: Grade) -> None:
    judgment = grade("pass", f"import os; os.abort()\n{GRADER}")
    assert judgment.fault is not None and judgment.doubt is None


def test_no_room_for_temporary_files(monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*args: object, **kwargs: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with (
        contextlib.closing(ForkServer()) as fork_server,
        isolated() as where,
        pytest.raises(StorageError, match="No space left on device"),
    ):
        monkeypatch.setattr("tempfile.TemporaryFile", full)
        Supervisor(where, node_environment(find_ros()), fork_server).__enter__()


def test_no_room_for_the_recording(grade: Grade, monkeypatch: pytest.MonkeyPatch) -> None:
    def temporary(*mode: str, **more: str) -> IO[Any]:
        return real(*mode, **more) if mode else Path("/dev/full").open("r+b", buffering=0)

    real: Any = tempfile.TemporaryFile
    monkeypatch.setattr("tempfile.TemporaryFile", temporary)
    judgment = grade(LOOP)
    assert judgment.missing and judgment.fault is not None
    assert judgment.fault.summary == "The recording could not be written: No space left on device."


def test_rubbish_in_the_result_pipe(grade: Grade) -> None:
    writes = "\n    import os, sys\n    os.write(int(sys.argv[1]), b'rubbish\\n')"
    broken = GRADER.replace("def run_it(arena):", f"def run_it(arena):{writes}")
    judgment = grade(LOOP, broken)
    assert judgment.fault is not None
    assert "sent something other than our protocol" in judgment.fault.summary


def test_a_recorder_that_stops_in_the_middle(grade: Grade) -> None:
    """A deaf recorder would make every node look silent."""
    deaf = "def run_it(arena):\n    arena.ros._recorder._reader = None"
    broken = GRADER.replace("def run_it(arena):", deaf)
    judgment = grade(LOOP, broken)
    assert judgment.fault is not None
    assert "the recorder stopped in the middle" in judgment.fault.summary
    assert judgment.doubt is Doubt.SPOILT
