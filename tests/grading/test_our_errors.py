"""Whatever goes wrong on our side is our error, said as such, and never the learner's failure."""

from __future__ import annotations

import errno
import os

import pytest

from course.arena.enclosure import enclosure
from course.errors import StorageError
from course.feedback import Feedback
from course.grading.result import Outcome
from course.grading.supervisor import Supervisor
from course.rosenv import find_ros, node_environment

from .conftest import GRADER, Grade

pytestmark = pytest.mark.slow

LOOP = "import time\nprint('go', flush=True)\nwhile True: time.sleep(1)"


def test_a_grader_with_a_syntax_error(grade: Grade) -> None:
    judgement = grade("pass", "def broken(:\n")
    assert judgement.fault is not None
    assert "SyntaxError" in judgement.fault.summary
    assert any("toy_grader.py" in line for line in judgement.fault.details)


def test_a_scenario_that_raises(grade: Grade) -> None:
    judgement = grade(LOOP, GRADER.replace("arena.until(", "arena.unheard_of("))
    assert judgement.fault is not None
    assert "unheard_of" in judgement.fault.summary
    assert judgement.checks == ()


def test_what_this_machine_lacks_is_no_error(grade: Grade) -> None:
    lacking = "\n    from course.errors import MissingHere\n    raise MissingHere('no g++', 'install it')"
    judgement = grade(LOOP, GRADER.replace("def run_it(arena):", f"def run_it(arena):{lacking}"))
    assert judgement.missing and judgement.checks == ()
    assert judgement.fault == Feedback("no g++", advice="install it")


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
    judgement = grade(LOOP, broken)
    assert judgement.fault is not None
    assert "ended without a verdict" in judgement.fault.summary
    assert "does not count" in (judgement.fault.advice or "")


def test_a_grading_process_that_hangs(grade: Grade, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("course.grading.supervisor._START_TIME", 3.0)
    broken = GRADER.replace("def run_it(arena):", "def run_it(arena):\n    import time; time.sleep(600)")
    judgement = grade(LOOP, broken, time_limit=1.0)
    assert judgement.fault is not None
    assert "did not finish within 1 s" in judgement.fault.summary


def test_no_room_for_temporary_files(monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*args: object, **kwargs: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("tempfile.TemporaryFile", full)
    with enclosure() as where, pytest.raises(StorageError, match="No space left on device"):
        Supervisor(where, node_environment(find_ros())).__enter__()


def test_rubbish_in_the_result_pipe(grade: Grade) -> None:
    writes = "\n    import os, sys\n    os.write(int(sys.argv[1]), b'rubbish\\n')"
    broken = GRADER.replace("def run_it(arena):", f"def run_it(arena):{writes}")
    judgement = grade(LOOP, broken)
    assert judgement.fault is not None
    assert "did not speak our language" in judgement.fault.summary


def test_a_recorder_that_stops_in_the_middle(grade: Grade) -> None:
    """A deaf recorder would make every node a silent one."""
    broken = GRADER.replace("def run_it(arena):", "def run_it(arena):\n    arena._recorder._reader = None")
    judgement = grade(LOOP, broken)
    assert judgement.fault is not None
    assert "the recorder stopped in the middle" in judgement.fault.summary
