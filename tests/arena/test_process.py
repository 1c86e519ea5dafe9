"""A program on its pseudo-terminal: its output, how it ends, and that it does end."""

from __future__ import annotations

import os
import signal
import threading
import time
from pathlib import Path

import pytest

from course.arena.process import CUT, MAX_LINE, MAX_TOTAL, Process
from course.evidence.timeline import Timeline
from course.model.events import Event, OutputCut, OutputLine, ProcessExited, ProcessStarted, SignalSent

from .conftest import WAIT, Stage, ended

MEGABYTE = 1_000_000
SLACK = 200_000
FLOOD_TIME = 60.0
CLOSE_TIME = 10.0


def open_files() -> int:
    return len(list(Path("/proc/self/fd").iterdir()))


# what it writes


def test_lines_are_recorded_as_they_come(stage: Stage) -> None:
    program = stage.python("print('one'); print('two', flush=True); input()")
    stage.await_line("two")
    assert stage.lines == ["one", "two"]
    assert program.running
    assert [event.command[-1][:5] for event in stage.events(ProcessStarted)] == ["print"]


def test_the_last_line_needs_no_end(stage: Stage) -> None:
    assert stage.python("print('one'); print('two', end='')").wait(WAIT)
    assert stage.lines == ["one", "two"]


def test_both_streams_are_heard(stage: Stage) -> None:
    assert stage.start("sh", "-c", "echo out; echo err >&2").wait(WAIT)
    assert stage.lines == ["out", "err"]


def test_a_very_long_line_is_cut(stage: Stage) -> None:
    assert stage.python(f"print('x' * {5 * MAX_LINE}); print('after')").wait(WAIT)
    assert stage.lines == ["x" * MAX_LINE + CUT, "after"]
    assert [cut.dropped for cut in stage.events(OutputCut)] == [4 * MAX_LINE]


def test_what_is_not_utf8_does_no_harm(stage: Stage) -> None:
    assert stage.start("printf", r"\377\376 ok\n\303").wait(WAIT)
    assert stage.lines == ["�� ok", "�"]


def test_colours_and_titles_are_removed(stage: Stage) -> None:
    assert stage.start("printf", r"\033]0;title\007\033[1;31mred\033[0m\033(B.\r\n").wait(WAIT)
    assert stage.lines == ["red."]


def test_it_has_a_terminal_of_its_own(stage: Stage) -> None:
    code = (
        "import os, sys\n"
        "print([os.isatty(f) for f in (0, 1, 2)], os.ttyname(0) == os.ttyname(1))\n"
        "own = os.open('/dev/tty', os.O_RDWR)\n"
        "print(os.tcgetpgrp(own) == os.getpgrp() == os.getsid(0) == os.getpid())\n"
        "print(tuple(os.get_terminal_size(1)))\n"
    )
    assert stage.python(code).wait(WAIT)
    assert stage.lines == ["[True, True, True] True", "True", "(200, 24)"]


def test_what_is_typed_is_read_and_not_echoed(stage: Stage) -> None:
    program = stage.python("print('ready'); print(input().upper())")
    stage.await_line("ready")
    program.type("hello\n")
    assert program.wait(WAIT)
    assert stage.lines == ["ready", "HELLO"]


def test_typing_after_its_end_does_nothing(stage: Stage) -> None:
    program = stage.start("true")
    assert program.wait(WAIT)
    program.type("hello\n")


def test_environment_and_folder_are_those_given(stage: Stage) -> None:
    program = stage.start("sh", "-c", "pwd; env", env={"ONLY": "this"})
    assert program.wait(WAIT)
    assert stage.lines[0] == str(stage.folder)
    assert "ONLY=this" in stage.lines
    assert not [line for line in stage.lines if line.startswith(("HOME=", "PATH=", "XDG_"))]


# floods


def test_a_flood_is_bounded_and_its_end_is_kept(stage: Stage) -> None:
    began = time.monotonic()
    code = "import os\nfor i in range(1000): os.write(1, (b'x' * 99 + b'\\n') * 100)\nprint('the end')"
    assert stage.python(code).wait(FLOOD_TIME)
    kept = sum(len(line) + 1 for line in stage.lines)
    (cut,) = stage.events(OutputCut)
    assert kept < MAX_TOTAL + SLACK
    assert kept + cut.dropped == 10 * MEGABYTE + len("the end\n")
    assert stage.lines[-1] == "the end"
    assert stage.end.code == 0
    assert time.monotonic() - began < FLOOD_TIME


def test_a_flood_of_empty_lines_is_bounded_too(stage: Stage) -> None:
    assert stage.python("import os\nfor i in range(100): os.write(1, b'\\n' * 100_000)").wait(FLOOD_TIME)
    (cut,) = stage.events(OutputCut)
    assert len(stage.lines) < 100_000
    assert len(stage.lines) + cut.dropped == 10 * MEGABYTE


def test_a_flood_without_any_line_is_bounded_too(stage: Stage) -> None:
    assert stage.python("import os\nfor i in range(100): os.write(1, b'x' * 100_000)").wait(FLOOD_TIME)
    kept = sum(len(line.removesuffix(CUT)) for line in stage.lines)
    assert kept < 4 * MAX_LINE
    assert stage.events(OutputCut)[0].dropped + kept == 10 * MEGABYTE


def test_a_flood_without_end_can_be_interrupted(stage: Stage) -> None:
    program = stage.start("yes")
    stage.await_line("y")
    program.interrupt()
    assert program.wait(WAIT)
    assert stage.end.signal == signal.SIGINT


# how it ends


@pytest.mark.parametrize("code", [0, 1, 3, 255])
def test_exit_codes(stage: Stage, code: int) -> None:
    assert stage.start("sh", "-c", f"exit {code}").wait(WAIT)
    assert (stage.end.code, stage.end.signal) == (code, None)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL, signal.SIGABRT])
def test_death_by_signal(stage: Stage, number: signal.Signals) -> None:
    assert stage.start("sh", "-c", f"ulimit -c 0; kill -{int(number)} $$").wait(WAIT)
    assert (stage.end.code, stage.end.signal) == (None, number)


def test_a_command_that_does_not_exist_says_so(stage: Stage) -> None:
    assert stage.start("no-such-program", "1").wait(WAIT)
    assert stage.end.code == 127
    assert "no-such-program: No such file" in stage.lines[0]


@pytest.mark.parametrize("missing", ["setsid", "folder"])
def test_what_cannot_be_started_at_all_leaves_nothing_open(stage: Stage, missing: str) -> None:
    environment = {"PATH": "/nowhere"} if missing == "setsid" else {"PATH": os.environ["PATH"]}
    folder = stage.folder if missing == "setsid" else stage.folder / "nowhere"
    before = open_files()
    with pytest.raises(FileNotFoundError):
        Process("program", ["true"], env=environment, cwd=folder, timeline=stage.timeline)
    assert open_files() == before


class Gated(Timeline):
    """Delays the event of the end until the gate is open."""

    def __init__(self) -> None:
        super().__init__()
        self.reached, self.gate = threading.Event(), threading.Event()

    def add(self, event: Event) -> None:
        if isinstance(event, ProcessExited):
            self.reached.set()
            assert self.gate.wait(WAIT)
        super().add(event)


def test_it_has_not_ended_before_its_end_is_on_the_time_line(tmp_path: Path) -> None:
    timeline = Gated()
    program = Stage(tmp_path, timeline).start("true")
    assert timeline.reached.wait(WAIT)
    assert not program.wait(0.1)
    timeline.gate.set()
    assert program.wait(WAIT)
    assert [type(event) for event in timeline.events()] == [ProcessStarted, ProcessExited]


def test_no_longer_running_is_known_when_its_end_is_announced(stage: Stage) -> None:
    program = stage.start("true")
    began = time.monotonic()
    assert stage.timeline.wait_until(lambda: not program.running, WAIT)
    assert time.monotonic() - began < WAIT / 2  # by the event, not by the time-out


# signals

GROUP = """
import os, signal, sys
reader, writer = os.pipe()
child = os.fork()
name = "parent" if child else "child"
def hear(number, frame):
    os.write(1, f"{name} heard\\n".encode())  # print may have been interrupted itself
    if child:
        os.waitpid(child, 0)
    os._exit(0)
signal.signal(signal.SIGINT, hear)
if child:
    os.read(reader, 1)
    print("ready")
else:
    os.write(writer, b".")
while True:
    signal.pause()
"""


def test_ctrl_c_reaches_the_whole_group(stage: Stage) -> None:
    program = stage.python(GROUP)
    stage.await_line("ready")
    program.interrupt()
    assert program.wait(WAIT)
    assert sorted(stage.lines) == ["child heard", "parent heard", "ready"]
    assert [sent.signal for sent in stage.events(SignalSent)] == [signal.SIGINT]


def test_signals_after_its_end_are_not_sent(stage: Stage) -> None:
    program = stage.start("true")
    assert program.wait(WAIT)
    program.interrupt()
    assert stage.events(SignalSent) == []


def test_a_signal_that_comes_just_after_its_end_is_not_sent(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its end counts from the moment it happens, although nobody has noticed it yet."""
    program = stage.python("import sys; sys.stdin.readline()")
    reached, gate = threading.Event(), threading.Event()

    def held_up(process: Process) -> None:
        reached.set()
        assert gate.wait(WAIT)

    monkeypatch.setattr(Process, "_read_rest", held_up)
    program.type("\n")
    assert reached.wait(WAIT)
    assert program.running
    program.interrupt()
    gate.set()
    assert program.wait(WAIT)
    assert (stage.events(SignalSent), stage.end.code) == ([], 0)


def test_a_signal_that_comes_while_its_end_is_taken_note_of_is_not_sent(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = stage.python("import sys; sys.stdin.readline()")
    reached, gate = threading.Event(), threading.Event()

    def held_up() -> None:
        reached.set()
        assert gate.wait(WAIT)

    monkeypatch.setattr(program._ended, "set", held_up)
    program.type("\n")
    assert reached.wait(WAIT)
    program.interrupt()
    monkeypatch.undo()
    gate.set()
    assert program.wait(WAIT)
    assert stage.events(SignalSent) == []


def test_a_program_that_ignores_ctrl_c_is_killed_when_closed(stage: Stage) -> None:
    program = stage.python("import signal; signal.signal(2, signal.SIG_IGN); print('deaf'); signal.pause()")
    stage.await_line("deaf")
    program.interrupt()
    assert not program.wait(0.2)
    program.close()
    assert stage.end.signal == signal.SIGKILL
    assert [sent.signal for sent in stage.events(SignalSent)] == [signal.SIGINT, signal.SIGKILL]


def test_a_program_can_be_signalled_before_it_leads_a_group(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    def no_group(pid: int, number: int) -> None:
        raise ProcessLookupError

    program = stage.start("sleep", "100")
    monkeypatch.setattr(os, "killpg", no_group)
    program.interrupt()
    assert program.wait(WAIT)
    assert stage.end.signal == signal.SIGINT


def test_a_program_can_be_closed_at_once(tmp_path: Path) -> None:
    for _ in range(20):
        stage = Stage(tmp_path)
        stage.start("sleep", "100").close()
        assert stage.end.signal == signal.SIGKILL


# what it leaves behind

CHILD = """
import fcntl, os, signal, termios
signal.signal(signal.SIGHUP, signal.SIG_IGN)
reader, writer = os.pipe()
child = os.fork()
if child:
    os.read(reader, 1)
    print("child", child, flush=True)
    {parent}
    os._exit(5)
{child}
os.write(writer, b".")
while True:
    try:
        os.write(1, b"more\\n")
    except OSError:  # the terminal hung up on it
        signal.pause()
"""


@pytest.mark.parametrize(
    ("parent", "child"),
    [("", ""), ("", "os.setsid()"), ("fcntl.ioctl(0, termios.TIOCNOTTY)", "")],
    ids=["in its group", "in a session of its own", "on a terminal that does not hang up"],
)
def test_a_child_that_goes_on_writing_does_not_keep_it_running(stage: Stage, parent: str, child: str) -> None:
    program = stage.python(CHILD.format(parent=parent or "pass", child=child))
    assert program.wait(WAIT)
    assert stage.end.code == 5
    left = next(int(line.split()[1]) for line in stage.lines if line.startswith("child"))
    program.close()
    if child:
        os.kill(left, signal.SIGKILL)  # what `leftovers` is for
    assert ended(left)


def test_what_is_left_in_the_terminal_is_not_read_for_ever(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As if somebody wrote as fast as we read."""
    monkeypatch.setattr(Process, "_read_once", lambda self: True)
    assert stage.start("echo", "hello").wait(WAIT)


def silent(stage: Stage, rest: str) -> Process:
    """A program that has closed its terminal, and reports that through a named pipe."""
    pipe = stage.folder / "pipe"
    os.mkfifo(pipe)
    code = f"import os, signal\nfor f in (0, 1, 2): os.close(f)\nopen({str(pipe)!r}, 'w').close()\n{rest}"
    program = stage.python(code)
    pipe.open().close()  # waits until the other side opens it too
    return program


def test_closing_its_terminal_is_not_its_end(stage: Stage) -> None:
    program = silent(stage, "signal.pause()")
    assert not program.wait(0.2)
    assert program.running
    began = time.monotonic()
    program.close()
    assert time.monotonic() - began < CLOSE_TIME
    assert stage.end.signal == signal.SIGKILL


def test_its_end_is_still_seen_when_it_closed_its_terminal(stage: Stage) -> None:
    pipe = stage.folder / "pipe"
    program = silent(stage, f"open({str(pipe)!r}).close()\nraise SystemExit(7)")
    before = stage.timeline.now()
    pipe.open("w").close()
    assert program.wait(WAIT)
    assert stage.end.code == 7
    assert stage.end.t >= before


def test_ctrl_c_reaches_a_program_that_closed_its_terminal(stage: Stage) -> None:
    program = silent(stage, "signal.signal(2, signal.SIG_DFL)\nsignal.pause()")
    program.interrupt()
    assert program.wait(WAIT)
    assert stage.end.signal == signal.SIGINT


@pytest.mark.slow
def test_nothing_is_left_open(tmp_path: Path) -> None:
    Stage(tmp_path).start("true").wait(WAIT)
    before, threads = open_files(), threading.active_count()
    for _ in range(200):
        assert Stage(tmp_path).start("true").wait(WAIT)
    assert open_files() == before
    assert threading.active_count() == threads


def test_output_is_stamped_between_start_and_end(stage: Stage) -> None:
    assert stage.start("echo", "hello").wait(WAIT)
    kinds = [type(event) for event in stage.timeline.events()]
    assert kinds == [ProcessStarted, OutputLine, ProcessExited]
