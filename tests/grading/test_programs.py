"""Misbehaving programs get a verdict within a time limit, and leave nothing behind."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from pathlib import Path

import psutil
import pytest

from course.model.result import Outcome

from .conftest import Grade, Graded

pytestmark = pytest.mark.slow


@pytest.fixture(autouse=True)
def nothing_is_left(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """No process of the toy and no temporary folder remains."""
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    monkeypatch.setenv("TMPDIR", str(scratch))
    yield
    alive = [p for p in psutil.process_iter(["cmdline"]) if str(tmp_path) in str(p.info["cmdline"])]
    assert alive == []
    assert list(scratch.iterdir()) == []


def outcomes(judgment: Graded) -> dict[str, Outcome]:
    assert judgment.fault is None, judgment.fault
    print(*judgment.checks, sep="\n")  # shown by pytest where a test fails
    return {check.id: check.outcome for check in judgment.checks}


def said(judgment: Graded, check_id: str) -> str:
    return str(next(check.feedback for check in judgment.checks if check.id == check_id))


GOOD = """
import signal, sys
print("go", flush=True)
signal.sigwait([signal.SIGINT])
"""


def test_a_quiet_program_passes(grade: Grade) -> None:
    found = outcomes(grade("import signal\nsignal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])" + GOOD))
    assert found == {"builds": Outcome.PASSED, "starts": Outcome.PASSED, "interrupt": Outcome.PASSED}


def test_one_that_exits_at_once(grade: Grade) -> None:
    judgment = grade("pass")
    assert outcomes(judgment)["starts"] is Outcome.FAILED
    assert "ended on its own" in said(judgment, "starts")
    assert outcomes(judgment)["interrupt"] is Outcome.SKIPPED


def test_one_that_crashes_at_import(grade: Grade) -> None:
    judgment = grade("import a_module_that_is_not_there")
    assert "No module named 'a_module_that_is_not_there'" in said(judgment, "starts")


def test_one_that_ignores_sigint(grade: Grade) -> None:
    program = "import signal, time\nsignal.signal(2, signal.SIG_IGN)\nprint('go', flush=True)\n"
    judgment = grade(program + "while True: time.sleep(1)")
    assert outcomes(judgment)["interrupt"] is Outcome.FAILED
    assert "Ctrl+C does not end the program" in said(judgment, "interrupt")


def test_one_that_ignores_sigint_and_sigterm_and_spins(grade: Grade) -> None:
    program = (
        "import signal\nfor s in (2, 15, 1): signal.signal(s, signal.SIG_IGN)\nprint('go', flush=True)\n"
    )
    assert outcomes(grade(program + "while True: pass"))["interrupt"] is Outcome.FAILED


def test_one_that_floods_its_terminal(grade: Grade) -> None:
    judgment = grade("print('go', flush=True)\nline = 'x' * 1000\nwhile True: print(line)")
    assert outcomes(judgment)["starts"] is Outcome.PASSED
    assert outcomes(judgment)["interrupt"] is Outcome.FAILED  # KeyboardInterrupt in a traceback


def test_one_that_dies_of_a_signal(grade: Grade) -> None:
    judgment = grade("import os, signal\nos.kill(os.getpid(), signal.SIGSEGV)")
    assert "SIGSEGV" in said(judgment, "starts")


def test_one_whose_children_outlive_it(grade: Grade) -> None:
    """A proper daemon: forked twice, in its own session, deaf to everything but SIGKILL."""
    program = """
import os, signal, time
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        for s in (1, 2, 15): signal.signal(s, signal.SIG_IGN)
        time.sleep(600)
    os._exit(0)
signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
"""
    assert outcomes(grade(program + GOOD))["interrupt"] is Outcome.PASSED


def test_one_that_keeps_forking_children(grade: Grade) -> None:
    program = """
import os, signal, time
signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
for _ in range(40):
    if os.fork() == 0:
        os.setsid()
        time.sleep(600)
"""
    assert outcomes(grade(program + GOOD))["interrupt"] is Outcome.PASSED


def test_no_program_at_all(grade: Grade) -> None:
    grader_text = "from course.api import Grader\nother = Grader('01-other')\n"
    judgment = grade("pass", grader_text)
    assert judgment.fault is not None
    assert "no grader in toy_grader.py judges 01-toy" in judgment.fault.summary


def test_ctrl_c_reaches_it_although_we_ignore_it(grade: Grade) -> None:
    """A program that is started in the background ignores SIGINT, and so do its children."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        program = "import signal\ntry:\n    print('go', flush=True)\n    signal.pause()"
        program += "\nexcept KeyboardInterrupt: pass"
        found = outcomes(grade(program))
    finally:
        signal.signal(signal.SIGINT, before)
    assert found["interrupt"] is Outcome.PASSED


def test_one_that_leaves_folders_too_deep_for_python(grade: Grade) -> None:
    program = "import os\nfor _ in range(1500): os.mkdir('d'); os.chdir('d')\nimport signal\n"
    program += "signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])"
    assert outcomes(grade(program + GOOD))["interrupt"] is Outcome.PASSED
