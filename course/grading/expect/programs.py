"""What is expected of a program: that it starts, keeps running, and ends on Ctrl+C."""

from __future__ import annotations

import re
import signal
from math import inf

from course.errors import OurFault
from course.evidence.events import ProcessExited
from course.evidence.process_view import ProcessView
from course.evidence.recording import Recording
from course.evidence.topic_view import seconds
from course.feedback import Failure, Feedback, Spoilt
from course.grading.expect.files import expect_file
from course.grading.explain.crashes import crash_feedback
from course.grading.explain.executables import no_executable
from course.grading.explain.python_code import calls
from course.grading.explain.spinning import SPINS
from course.grading.explain.tracebacks import Crash, crash

INTERRUPT_GRACE = 3.0
_QUIET_EXITS = (0, 1, 128 + signal.SIGINT)
_LAST_LINES = 6
_WITH_CODE_0 = (
    "What `main` returns becomes the exit code, and a text counts as 1: let it return nothing. "
    "Give `sys.exit()` no number, or 0."
)
_WITH_AN_END = "Let `main` come to its end: look for a loop that never ends, or for an `input()` that waits."
_WITH_SPIN = "Put `rclpy.spin(node)` into a `try:` and add `except KeyboardInterrupt:` with `pass`."
_WITH_LOOP = (
    "Ctrl+C raises KeyboardInterrupt in Python. Put the loop into a `try:`, and add "
    "`except KeyboardInterrupt:` after it."
)


def expect_executable(recording: Recording, process: str) -> None:
    """The executable that the scenario was to run is installed (a script: is there), and was started.

    Raises OurFault when the scenario never came to it: then nothing can be said of the program.
    """
    missing = recording.missing_executable(process)
    if missing:
        raise Failure(no_executable(missing, recording.packages, recording.sources))
    lost = recording.missing_program(process)
    if lost:
        expect_file(recording, lost.file)
    if recording.process(process).started is None:
        raise OurFault(f"the scenario did not run {process}")


def expect_running(recording: Recording, process: str, *, until: float = inf) -> None:
    """The program started and ran until the scenario ended it, or at least to the time `until` (s)."""
    expect_executable(recording, process)
    view = recording.process(process)
    ended = view.ended_by_itself
    if ended is None or ended.t >= until:
        return
    found = crash(view.traceback(), recording.packages, recording.sources)
    if found:
        raise Failure(crash_feedback(found, recording.packages, recording.sources))
    early = _ended_early if recording.packages.built else _script_ended
    raise Failure(early(recording, view, ended))


def _script_ended(recording: Recording, view: ProcessView, ended: ProcessExited) -> Feedback:
    return Feedback(
        summary=f"The program ended by itself after {seconds(view.lifetime or 0.0)}; "
        "it should go on forever.",
        expected="it runs until Ctrl+C",
        seen=_how(ended),
        advice="A loop that never ends keeps it running: `while True:`. Is `main()` called at all?",
        details=view.text[-_LAST_LINES:],
    )


def _ended_early(recording: Recording, view: ProcessView, ended: ProcessExited) -> Feedback:
    return Feedback(
        summary=f"The program ended by itself after {seconds(view.lifetime or 0.0)}; "
        "`rclpy.spin` should keep it running.",
        expected="it runs until Ctrl+C",
        seen=_how(ended),
        where=tuple(call.where for name in SPINS for call in calls(recording.sources, name))[:2],
        advice=_advice_to_keep_running(recording),
        details=view.text[-_LAST_LINES:],
    )


def _how(ended: ProcessExited) -> str:
    if ended.signal is None:
        return f"exit code {ended.code}"
    names = {number.value: number.name for number in signal.Signals}  # signals from 35 to 63 have none
    return f"ended by the signal {names.get(ended.signal, ended.signal)}"


def _advice_to_keep_running(recording: Recording) -> str:
    if not calls(recording.sources, "init"):
        return "`main()` has to call `rclpy.init()`, make the node, and hand it to `rclpy.spin(node)`."
    if calls(recording.sources, "spin"):
        return "Something ends `rclpy.spin`: an error that an `except` hides, or `rclpy.shutdown()`?"
    if calls(recording.sources, "spin_once"):
        return "`spin_once` handles one event and returns. `rclpy.spin(node)` goes on until Ctrl+C."
    return "Nothing keeps it running: call `rclpy.spin(node)` in `main()` after the node is made."


def expect_clean_end(recording: Recording, process: str) -> None:
    """The program ran and ended by itself with exit code 0."""
    expect_executable(recording, process)
    view = recording.process(process)
    ended = view.ended_by_itself
    if ended and ended.code == 0:
        return
    found = crash(view.traceback(), recording.packages, recording.sources) if ended else None
    if found:
        raise Failure(crash_feedback(found, recording.packages, recording.sources))
    asked = view.interrupted_at or inf
    raise Failure(
        Feedback(
            summary=f"`{process}` should end by itself with exit code 0.",
            expected="exit code 0",
            seen=_how(ended) if ended else "it still ran",
            advice=_WITH_CODE_0 if ended else _WITH_AN_END,
            details=tuple(line.text for line in view.lines if line.t < asked)[-_LAST_LINES:],
        )
    )


# rclpy looks whether it is still to spin, and then makes what it waits with. A SIGINT in between shuts it
# down, and what it raises then is none of the exceptions that a program is to expect.
_SHUT_DOWN_IN_BETWEEN = re.compile(r"RCLError: failed to initialize wait set: the given context is not valid")


def expect_clean_interrupt(recording: Recording, process: str) -> None:
    """Ctrl+C ended the program within 3 s, with no traceback."""
    expect_executable(recording, process)
    view = recording.process(process)
    asked = view.interrupted_at
    if asked is None:
        raise Failure(
            Feedback(
                summary="The program ended before Ctrl+C could be tried.",
                expected="it runs until Ctrl+C",
                advice="Start it yourself, and read what it says at its end.",
            )
        )
    ended = view.exited
    if ended is None or ended.signal == signal.SIGKILL:
        raise Failure(_deaf(recording))
    found = crash(view.traceback(after=asked), recording.packages, recording.sources)
    if found and _SHUT_DOWN_IN_BETWEEN.search(found.error):
        raise Spoilt("rclpy stumbled over its own shutdown when Ctrl+C was pressed.")
    if found:
        raise Failure(_unhandled(found, _WITH_SPIN if recording.packages.built else _WITH_LOOP))
    if ended.code is not None and ended.code not in _QUIET_EXITS:
        raise Failure(
            Feedback(
                summary=f"After Ctrl+C the program ended with exit code {ended.code}.",
                expected="exit code 0",
                seen=f"exit code {ended.code}",
                advice="Let `main` come to its end after `except KeyboardInterrupt:`, with no number in "
                "`sys.exit()`.",
                details=view.text[-_LAST_LINES:],
            )
        )


def _deaf(recording: Recording) -> Feedback:
    return Feedback(
        summary=f"Ctrl+C does not end the program: it still ran {INTERRUPT_GRACE:.0f} s later.",
        expected="it ends soon after Ctrl+C",
        where=tuple(call.where for call in calls(recording.sources, "signal"))[:2],
        advice="Let `main()` end after `except KeyboardInterrupt:`. A loop around the `try:`, or a "
        "`signal.signal(...)` that ignores Ctrl+C, keeps the program running.",
    )


def _unhandled(found: Crash, advice: str) -> Feedback:
    return Feedback(
        summary=f"Ctrl+C ends the program with a traceback: {found.error}",
        expected="a quiet end",
        seen="a traceback",
        where=(found.where,) if found.where else (),
        advice=advice,
        details=found.shown,
    )
