"""What is expected of a program: that it starts, keeps running, and ends on Ctrl+C."""

from __future__ import annotations

import signal

from course.evidence.events import ExecutableMissing
from course.evidence.process_view import ProcessView
from course.evidence.recording import Recording
from course.evidence.topic_view import seconds
from course.feedback import Failure, Feedback, Location
from course.grading.explain.names import listed, nearest
from course.grading.explain.python_code import calls
from course.grading.explain.setup_py import entry_points, joined_entry_points
from course.grading.explain.tracebacks import Crash, crash

INTERRUPT_GRACE = 3.0
_QUIET_EXITS = (0, 1, 128 + signal.SIGINT)
_LAST_LINES = 6


def expect_executable(recording: Recording, process: str) -> None:
    """The executable that the scenario was to run is installed."""
    missing = recording.missing_executable(process)
    if missing:
        raise Failure(_no_executable(recording, missing))


def _no_executable(recording: Recording, missing: ExecutableMissing) -> Feedback:
    package = recording.packages.get(missing.package)
    if package is None:
        return Feedback(summary=f"The package `{missing.package}` was not built, so there is nothing to run.")
    setup = Location(f"{package.source}/setup.py")
    joined = joined_entry_points(recording.sources, package.source)
    if joined and missing.executable in joined.text:
        return Feedback(
            summary="A comma is missing between two entry points: Python joins the two strings into one.",
            where=(joined.where,),
            seen=joined.text,
            advice="End each entry of `console_scripts` with a comma.",
        )
    declared = {entry.name: entry.where for entry in entry_points(recording.sources, package.source)}
    close = nearest(missing.executable, missing.available)
    if close:
        return Feedback(
            summary=f"No executable found: the package has `{close}`, but not `{missing.executable}`.",
            expected=missing.executable,
            seen=close,
            where=(declared.get(close, setup),),
            advice="Correct the name before the `=` of the entry point, letter by letter.",
        )
    return Feedback(
        summary=f"No executable found: `{missing.package}` installs no `{missing.executable}`.",
        expected=f"{missing.executable} among the entry points",
        seen=f"installed: {listed(missing.available)}",
        where=(setup,),
        advice="Add an entry point to `console_scripts` in `setup.py`: "
        f"`'{missing.executable} = {missing.package}.<module>:main',`",
    )


def expect_running(recording: Recording, process: str) -> None:
    """The program started and ran until the scenario ended it."""
    expect_executable(recording, process)
    view = recording.process(process)
    ended = view.ended_by_itself
    if ended is None:
        return
    found = crash(view.traceback(), recording.packages, recording.sources)
    if found:
        raise Failure(_crashed(found))
    if ended.signal is not None:
        name = signal.Signals(ended.signal).name
        raise Failure(Feedback(summary=f"The program was ended by {name} while it ran.", details=view.text[-_LAST_LINES:]))
    raise Failure(_ended_early(recording, view, ended.code))


def _crashed(found: Crash) -> Feedback:
    return Feedback(
        summary=f"The program stopped with an error: {found.error}",
        where=(found.where,) if found.where else (),
        advice=_advice_for(found.error),
        details=found.shown,
    )


def _advice_for(error: str) -> str | None:
    """What usually causes this error in a first node."""
    for words, advice in _KNOWN_ERRORS:
        if all(word in error for word in words):
            return advice
    return "Start it by hand to see the whole message; the last line names the error."


_KNOWN_ERRORS = (
    (
        ("rclpy.init() has not been called",),
        "Call `rclpy.init()` at the beginning of `main()`, before the node is made.",
    ),
    (
        ("NotInitializedException",),
        "Call `rclpy.init()` at the beginning of `main()`, before the node is made.",
    ),
    (
        ("__init__() missing", "node_name"),
        "A node needs a name: `super().__init__('the_name')` in the class's `__init__`.",
    ),
    (
        ("_Node__node", "has no attribute"),
        "Call `super().__init__('the_name')` first in the class's `__init__`.",
    ),
    (
        ("has no attribute '_Node",),
        "Call `super().__init__('the_name')` first in the class's `__init__`.",
    ),
    (
        ("has no attribute 'main'",),
        "The entry point names a function `main` that the module does not have.",
    ),
    (
        ("No module named",),
        "Check the module's name in the import, or after the `=` of the entry point.",
    ),
    (
        ("'NoneType' object is not callable",),
        "Pass the callback itself, without brackets: `self.timer_callback`, not `self.timer_callback()`.",
    ),
)


def _ended_early(recording: Recording, view: ProcessView, code: int | None) -> Feedback:
    spins = [call for name in _SPINS for call in calls(recording.sources, name)]
    advice = (
        "It has to go on until Ctrl+C. Look at what lets the program get past `rclpy.spin`."
        if spins
        else "Nothing keeps it running: call `rclpy.spin(node)` in `main()` after the node is made."
    )
    return Feedback(
        summary=f"The program ended by itself after {seconds(view.lifetime or 0.0)}; `rclpy.spin` should keep it running.",
        expected="it runs until Ctrl+C",
        seen=f"exit code {code}",
        advice=advice,
        details=view.text[-_LAST_LINES:],
    )


_SPINS = ("spin", "spin_once", "spin_until_future_complete")


def expect_clean_interrupt(recording: Recording, process: str) -> None:
    """Ctrl+C ended the program within 3 s, with no traceback."""
    view = recording.process(process)
    asked = view.interrupted_at
    if asked is None:
        raise Failure(Feedback(summary="The program had ended before Ctrl+C could be tried."))
    ended = view.exited
    if ended is None or ended.signal == signal.SIGKILL or ended.t - asked > INTERRUPT_GRACE + 0.5:
        raise Failure(_deaf(recording, process))
    lines = view.traceback(after=asked)
    found = crash(lines, recording.packages, recording.sources)
    if found:
        raise Failure(_unhandled(found))
    if ended.code is not None and ended.code not in _QUIET_EXITS:
        raise Failure(
            Feedback(
                summary=f"After Ctrl+C the program ended with exit code {ended.code}.",
                expected="exit code 0",
                seen=f"exit code {ended.code}",
                details=view.text[-_LAST_LINES:],
            )
        )


def _deaf(recording: Recording, process: str) -> Feedback:
    return Feedback(
        summary=f"Ctrl+C does not end the program: it still ran {seconds(INTERRUPT_GRACE)} later.",
        expected="it ends when it gets SIGINT",
        where=tuple(call.where for call in calls(recording.sources, "signal"))[:2],
        advice="Do not catch KeyboardInterrupt inside a loop that goes on; leave `main()` when it comes.",
    )


def _unhandled(found: Crash) -> Feedback:
    return Feedback(
        summary=f"Ctrl+C ends the program with a traceback: {found.error or 'KeyboardInterrupt'}",
        expected="a quiet end",
        where=(found.where,) if found.where else (),
        advice="Put `rclpy.spin(node)` into `try:` and add `except KeyboardInterrupt: pass`.",
        details=found.shown,
    )
