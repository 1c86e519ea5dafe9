"""Programs that hold on to their terminal or the processor, or refuse to end."""

from __future__ import annotations

import pytest

from course.arena.lateness import Lateness
from course.model.result import Verdict
from tests.hostile.world import NODE, Grade, judged, with_attack

pytestmark = pytest.mark.slow


def test_one_that_ignores_all_signals_and_never_waits(grade: Grade) -> None:
    graded = grade({NODE: with_attack("deaf")}, guarantee="a deaf program is ended all the same")
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert graded.failed == ("interrupt",)
    assert "Ctrl+C does not end the program" in graded.words("interrupt")


def test_a_daemon_that_outlives_its_program(grade: Grade) -> None:
    """Its pid changes all the time: the proof is that nothing of it is left."""
    graded = grade({NODE: with_attack("daemon")}, guarantee="no process survives the grading")
    assert graded.result.verdict is Verdict.PASSED, graded.result


def test_one_that_stops_itself(grade: Grade) -> None:
    graded = grade({NODE: with_attack("stops")}, guarantee="a stopped program is ended, too")
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert graded.failed[-1] == "interrupt"


@pytest.mark.parametrize("stopped", [False, True])
def test_one_that_spoils_its_terminal(grade: Grade, stopped: bool) -> None:
    """Raw, cleared, of a new size all the time, and with its output held back: the node itself is right."""
    text = with_attack("terminal", STOPPED=stopped)
    graded = grade({NODE: text}, guarantee="a spoilt terminal spoils nobody else's")
    assert graded.result.verdict is Verdict.PASSED, graded.result
    assert not [line for line in graded.printed if "\x1b" in line]


@pytest.mark.parametrize("processes", [20, 120])
def test_one_that_leaves_no_processor_to_others(grade: Grade, machine: Lateness, processes: int) -> None:
    """It leaves too little for its own node, too; but there is a verdict, and no error of ours."""
    text, guarantee = with_attack("busy", PROCESSES=processes), "busy programs do not starve the grader"
    graded = grade({NODE: text}, guarantee=guarantee)
    assert judged(graded, machine, guarantee) in (Verdict.PASSED, Verdict.NOT_PASSED), graded.result
    assert "realtime" in graded.held or not graded.printed
