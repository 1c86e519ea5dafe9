"""What expectations say of programs in Python."""

from __future__ import annotations

import re

from course.evidence.process_view import ProcessView
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.feedback import Feedback, Location, Spoilt
from course.grading.explain.crashes import crash_feedback
from course.grading.explain.language import Language
from course.grading.explain.python_code import calls
from course.grading.explain.spinning import SPINS, never_spun
from course.grading.explain.timers import Cause, timer_cause
from course.grading.explain.tracebacks import Crash, crash

_WITH_SPIN = "Put `rclpy.spin(node)` into a `try:` and add `except KeyboardInterrupt:` with `pass`."
_WITH_LOOP = (
    "Ctrl+C raises KeyboardInterrupt in Python. Put the loop into a `try:`, and add "
    "`except KeyboardInterrupt:` after it."
)
_BRACES = (
    "The braces were logged as they are: put an `f` before the string, `f'...'`, and Python fills them in."
)
_DEAF = (
    "Let `main()` end after `except KeyboardInterrupt:`. A loop around the `try:`, or a "
    "`signal.signal(...)` that ignores Ctrl+C, keeps the program running."
)
# rclpy looks whether it is still to spin, and then makes what it waits with. A SIGINT in between shuts it
# down, and what it raises then is none of the exceptions that a program is to expect. The same goes for a
# SIGINT while rclpy turns what it took into a message of Python.
_SHUT_DOWN_IN_BETWEEN = re.compile(
    r"RCLError: failed to initialize wait set: the given context is not valid"
    r"|RuntimeError: Unable to convert call argument"
)


class Python(Language):
    spin = "rclpy.spin"
    log_info = "self.get_logger().info(...)"
    at_the_end = (
        "What `main` returns becomes the exit code, and a text counts as 1: let it return nothing. "
        "Give `sys.exit()` no number, or 0."
    )
    comes_to_an_end = (
        "Let `main` come to its end: look for a loop that never ends, or for an `input()` that waits."
    )
    after_ctrl_c = (
        "Let `main` come to its end after `except KeyboardInterrupt:`, with no number in `sys.exit()`."
    )

    def places(self, sources: Sources, name: str) -> tuple[Location, ...]:
        return tuple(call.where for call in calls(sources, name))

    def stopped(self, recording: Recording, view: ProcessView) -> Feedback | None:
        found = crash(view.traceback(), recording.packages, recording.sources)
        return crash_feedback(found, recording.packages, recording.sources) if found else None

    def unhandled(self, recording: Recording, view: ProcessView, asked: float) -> Feedback | None:
        found = crash(view.traceback(after=asked), recording.packages, recording.sources)
        if found and _SHUT_DOWN_IN_BETWEEN.search(found.error):
            raise Spoilt("rclpy stumbled over its own shutdown when Ctrl+C was pressed.")
        return _unhandled(found, _WITH_SPIN if recording.packages.built else _WITH_LOOP) if found else None

    def to_keep_running(self, sources: Sources) -> Cause:
        where = tuple(place for name in SPINS for place in self.places(sources, name))[:2]
        return Cause(_to_keep_running(sources), where)

    def deaf(self, sources: Sources) -> Cause:
        return Cause(_DEAF, self.places(sources, "signal")[:2])

    def to_name_a_node(self, name: str) -> str:
        return f"Give the node its name in `__init__` of its class: `super().__init__('{name}')`."

    def to_use_a_type(self, maker: str, package: str, name: str) -> str:
        return f"Import it with `from {package}.msg import {name}` and name it first in `{maker}`."

    def logged_at(self, sources: Sources, level: str) -> tuple[Location, ...]:
        names = ("warn", "warning") if level == "WARN" else (level.lower(),)
        return tuple(place for name in names for place in self.places(sources, name))

    def printed(self, sources: Sources) -> tuple[str, tuple[Location, ...]]:
        return "print", self.places(sources, "print")

    def other_words(self, text: str) -> str | None:
        return _BRACES if "{" in text else None

    def silent(self, sources: Sources) -> Cause | None:
        return timer_cause(sources) or never_spun(sources)


def _to_keep_running(sources: Sources) -> str:
    if not calls(sources, "init"):
        return "`main()` has to call `rclpy.init()`, make the node, and hand it to `rclpy.spin(node)`."
    if calls(sources, "spin"):
        return "Something ends `rclpy.spin`: an error that an `except` hides, or `rclpy.shutdown()`?"
    if calls(sources, "spin_once"):
        return "`spin_once` handles one event and returns. `rclpy.spin(node)` goes on until Ctrl+C."
    return "Nothing keeps it running: call `rclpy.spin(node)` in `main()` after the node is made."


def _unhandled(found: Crash, advice: str) -> Feedback:
    return Feedback(
        summary=f"Ctrl+C ends the program with a traceback: {found.error}",
        expected="a quiet end",
        seen="a traceback",
        where=(found.where,) if found.where else (),
        advice=advice,
        details=found.shown,
    )
