"""On a terminal, where Ctrl+C reaches the processes as well, and where windows are closed."""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Iterator

import pexpect
import psutil
import pytest

from tests.underlay.launch.machine import TIMEOUT, Launcher, gone

MULE = "trap '' INT TERM; echo ready; while :; do sleep 0.05; done"
POLITE = "trap 'echo bye; exit 0' INT; echo ready; while :; do sleep 0.05; done"
# Ends at the second Ctrl+C.
PATIENT = "end() { exit 0; }; again() { trap end INT; echo once; }; trap again INT; echo ready; "
PATIENT += "while :; do sleep 0.05; done"
NEVER = "sigterm_timeout='100'"
TWICE = "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT) again, ignoring..."


@contextlib.contextmanager
def _on_terminal(launcher: Launcher, entities: str) -> Iterator[pexpect.spawn]:
    line = launcher.line(str(launcher.description(entities)))
    child = pexpect.spawn(
        line[0],
        line[1:],
        env=dict(launcher.environment),
        cwd=str(launcher.cwd),
        encoding="utf-8",
        echo=False,
        timeout=TIMEOUT,
    )
    try:
        yield child
    finally:
        child.close(force=True)


def _expect_all(child: pexpect.spawn, *texts: str) -> str:
    """In whatever order they come; all up to there, line by line."""
    missing, said = {*texts}, ""
    while missing:
        line = child.readline()
        assert line, f"{missing} never came: {said}"
        said += line.rstrip("\r\n") + "\n"
        missing = {text for text in missing if text not in said}
    return said


def _rest(child: pexpect.spawn) -> list[str]:
    child.expect(pexpect.EOF)
    child.close()
    assert child.before is not None
    return [line.rstrip("\r") for line in child.before.splitlines()]


def _process(name: str, script: str, more: str = "") -> str:
    return f'ExecuteProcess(cmd=["sh", "-c", "{script}"], name="{name}", output="screen", {more}),'


def test_ctrl_c_is_not_sent_twice(launcher: Launcher) -> None:
    with _on_terminal(launcher, _process("polite", POLITE, NEVER)) as child:
        child.expect_exact("[polite-1] ready")
        child.sendintr()
        said = _rest(child)
    assert "[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)" in said
    assert said.count("[polite-1] bye") == 1
    assert not [line for line in said if "sending signal" in line]
    assert child.exitstatus == 0


@pytest.mark.slow
def test_ctrl_c_twice_ends_no_sooner_and_leaves_nothing(launcher: Launcher) -> None:
    stubborn = _process("mule", MULE, "sigterm_timeout='0.4', sigkill_timeout='0.2'")
    with _on_terminal(launcher, stubborn + _process("patient", PATIENT, NEVER)) as child:
        _expect_all(child, "[mule-1] ready", "[patient-2] ready")
        there = psutil.Process(child.pid).children(recursive=True)
        child.sendintr()
        early = _expect_all(child, "user interrupted with ctrl-c (SIGINT)", "[patient-2] once")
        child.sendintr()
        said = [*early.splitlines(), *_rest(child)]
    assert TWICE in said
    head = "[ERROR] [mule-1]: process[mule-1] failed to terminate"
    assert f"{head} '0.4' seconds after receiving 'SIGINT', escalating to 'SIGTERM'" in said
    assert "[INFO] [mule-1]: sending signal 'SIGKILL' to process[mule-1]" in said
    assert child.exitstatus == 0
    assert all(gone(process.pid) for process in there)


@pytest.mark.slow
def test_a_closed_window_leaves_nothing(launcher: Launcher) -> None:
    deaf = MULE.replace("INT TERM", "INT TERM HUP")
    stubborn = _process("mule", deaf, "sigterm_timeout='0.1', sigkill_timeout='0.1'")
    with _on_terminal(launcher, stubborn) as child:
        child.expect_exact("[mule-1] ready")
        there = psutil.Process(child.pid).children(recursive=True)
        child.kill(signal.SIGHUP)
        child.expect(pexpect.EOF)
        assert there and all(gone(process.pid) for process in there)


def test_noninteractive_sends_the_signal_itself(launcher: Launcher) -> None:
    """`-n` says that no terminal does it."""
    path = launcher.description(_process("polite", POLITE, NEVER))
    with launcher.started("-n", path) as running:
        running.wait_for("ready")
        running.signal(signal.SIGINT)
        answer = running.finish()
    assert "[INFO] [polite-1]: sending signal 'SIGINT' to process[polite-1]" in answer.said
    assert answer.of("polite-1") == ["ready", "bye"]
