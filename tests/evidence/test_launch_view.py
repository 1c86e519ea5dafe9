"""What `ros2 launch` printed, told apart."""

from __future__ import annotations

from course.evidence.process_view import LaunchView
from course.model.events import Event, OutputLine, ProcessExited, ProcessLeft, ProcessStarted, SignalSent

LINES = """\
[INFO] [launch]: All log files can be found below /log
[INFO] [launch]: Default logging verbosity is set to INFO
[INFO] [talker-1]: process started with pid [12]
[INFO] [listener-2]: process started with pid [13]
[talker-1] [INFO] [1.5] [talker]: hello [world-1] there
[listener-2] Traceback (most recent call last):
[listener-2]   File "x.py", line 3, in <module>
[talker-1]
[listener-2] ValueError: no
[ERROR] [listener-2]: process has died [pid 13, exit code 1, cmd 'listener --ros-args'].
^C[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)
[ERROR] [talker-1]: process has died [pid 12, exit code -2, cmd 'talker'].
"""


def view(text: str = LINES, *events: Event) -> LaunchView:
    lines = (OutputLine(float(n), "it", line) for n, line in enumerate(text.splitlines()))
    return LaunchView.of("it", (ProcessStarted(0.0, "it", ("ros2",)), *lines, *events))


def test_each_process_has_its_own_lines() -> None:
    processes = view().processes
    assert list(processes) == ["talker-1", "listener-2"]
    assert processes["talker-1"].text == ("[INFO] [1.5] [talker]: hello [world-1] there", "")
    assert processes["listener-2"].text[0] == "Traceback (most recent call last):"


def test_how_each_ended() -> None:
    processes = view().processes
    assert processes["listener-2"].exited == ProcessExited(9.0, "listener-2", 1, None)
    assert processes["talker-1"].exited == ProcessExited(11.0, "talker-1", None, 2)
    clean = view(
        "[INFO] [a-1]: process started with pid [1]\n[INFO] [a-1]: process has finished cleanly [pid 1]"
    )
    assert clean.processes["a-1"].exited == ProcessExited(1.0, "a-1", 0, None)
    running = view("[INFO] [a-1]: process started with pid [1]")
    assert running.processes["a-1"].exited is None


def test_tracebacks_of_what_was_launched() -> None:
    traces = {name: process.traceback() for name, process in view().processes.items()}
    assert [name for name, trace in traces.items() if trace] == ["listener-2"]
    assert traces["listener-2"][-1] == "ValueError: no"


def test_signals_of_the_launch_are_those_of_its_processes() -> None:
    sent = SignalSent(9.5, "it", 2)
    talker = view(LINES, sent).processes["talker-1"]
    assert talker.interrupted_at == 9.5
    assert talker.ended_by_itself is None


def test_what_was_left() -> None:
    left, other = ProcessLeft(12.0, "it", 12, ("talker",)), ProcessLeft(12.0, "other", 14, ("x",))
    assert view(LINES, left, other).left == (left,)
    assert view().left == ()


def test_what_launch_itself_complains_of() -> None:
    said = "Caught exception in launch (see debug for traceback): executable 'x' not found"
    assert view(f"[ERROR] [launch]: {said}").error == said
    crash = view("Traceback (most recent call last):\n  File\nImportError: no")
    assert crash.error == "ImportError: no"
    assert view().error is None


def test_why_a_launch_file_cannot_be_read() -> None:
    said = (
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): Caught multiple "
        "exceptions when trying to load file of format [py]:\n"
        " - SyntaxError: invalid syntax (talk_launch.py, line 17)\n"
        " - InvalidFrontendLaunchFileError: The launch file may have a syntax error\n"
    )
    assert view(said).error == "SyntaxError: invalid syntax (talk_launch.py, line 17)"
    assert str(view(said.splitlines()[0]).error).endswith("[py]:")
