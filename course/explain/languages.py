"""Describes problems of a program in terms of the language that it is written in.

All languages share the expectations for a node. Each language knows what is likely to be wrong, where, and
what to write instead.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Sequence

from course.evidence.process_view import ProcessView
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.explain.callbacks import never_spun
from course.explain.cpp_code import cpp_calls, cpp_files, never_called, places_of, without_effect
from course.explain.cpp_crashes import C_TEXTS, cpp_crash, texts_without_a_text
from course.explain.cpp_timers import MAKERS, cpp_timer_cause
from course.explain.cpp_timers import SPINS as CPP_SPINS
from course.explain.engine import Cause, Evidence, Symptom, explain
from course.explain.python_code import called_name, calls, nodes
from course.explain.python_errors import EXCEPTIONS, SHUT_DOWN_TWICE, Crash, crash, crash_feedback
from course.explain.python_slips import (
    defined_twice,
    destroyed_first,
    first,
    named_only,
    python_timer_cause,
    shut_down_inside,
    spin_in_a_thread,
    uncalled,
)
from course.model import replace
from course.model.events import Observed
from course.model.feedback import Feedback, Location, Spoilt

_WITH_SPIN = "Put `rclpy.spin(node)` in a `try:` block, and add `except KeyboardInterrupt:` with `pass`."
_WITH_LOOP = (
    "Ctrl+C raises KeyboardInterrupt in Python. Put the loop in a `try:` block, and add "
    "`except KeyboardInterrupt:` after it."
)
_BRACES = "The braces were logged as is. Put an `f` before the string, `f'...'`: then Python fills them in."
_DEAF = (
    "Let `main()` end after `except KeyboardInterrupt:`. A loop around the `try:`, or a "
    "`signal.signal(...)` that ignores Ctrl+C, keeps the program running."
)
# rclpy checks whether to keep spinning, then creates its wait objects. A SIGINT in between shuts it
# down, and it raises an exception that no program should have to expect. The same is true of a
# SIGINT while rclpy converts a received message to Python, or while it makes a task.
_SHUT_DOWN_IN_BETWEEN = re.compile(
    r"RCLError: failed to initialize wait set: the given context is not valid"
    r"|RuntimeError: Unable to convert call argument"
    r"|SystemError: <built-in method \w+ of .*> returned a result with an exception set"
    r"|AttributeError: '(?:Task|Future)' object has no attribute '_exception'"
)
# `try_shutdown` looks and then acts, and the thread that handles Ctrl+C may come in between.
_SHUT_DOWN_MEANWHILE = re.compile(r"RCLError: failed to shutdown: rcl_shutdown already called")


class Python:
    """Python, and what `Cpp` has for C++. All texts are shown to a learner; `Cause.text` is advice."""

    spin = "rclpy.spin"  # what keeps a node running
    log_info = "self.get_logger().info(...)"  # how a line is logged
    # how a program ends with exit code 0
    at_the_end = (
        "The value that `main` returns becomes the exit code, and a string counts as 1: return nothing. "
        "Call `sys.exit()` with no number, or with 0."
    )
    # how a program ends by itself
    comes_to_an_end = "`main` must end: look for an endless loop, or for an `input()` that waits."
    # how a program ends with exit code 0 after Ctrl+C
    after_ctrl_c = "Let `main` end after `except KeyboardInterrupt:`, with no number in `sys.exit()`."

    def places(self, sources: Sources, name: str) -> tuple[Location, ...]:
        """Where a function or method of this name is called."""
        return tuple(call.where for call in calls(sources, name))

    def entry(self, sources: Sources) -> tuple[Location, ...]:
        """Where `main` is defined; at most one place."""
        found = ((file, node) for file, node in nodes(sources) if isinstance(node, ast.FunctionDef))
        return tuple(Location(file, node.lineno) for file, node in found if node.name == "main")[:1]

    def constructor(self, sources: Sources) -> tuple[Location, ...]:
        """Where the node is created, and where publishers and the like belong; at most one place."""
        return (*self.places(sources, "__init__"), *self.places(sources, "Node"))[:1]

    def stopped(self, recording: Recording, view: ProcessView) -> Feedback | None:
        """The error that ended the program, if one did, when it ended by itself."""
        found = crash(view.traceback(), recording.packages, recording.sources)
        return crash_feedback(found, recording.packages, recording.sources) if found else None

    def unhandled(self, recording: Recording, view: ProcessView, asked: float) -> Feedback | None:
        """The error after Ctrl+C, pressed at the time `asked`. Raises Spoilt for an error in ROS itself."""
        traceback = view.traceback(after=asked)
        found = crash(traceback, recording.packages, recording.sources)
        if found and _raised_by_rclpy(found.error, traceback):
            # A program can print such words itself, so they only lead to another attempt.
            raise Spoilt("rclpy failed while it shut down after Ctrl+C.")
        return _unhandled(found, _at_the_end(found, recording)) if found else None

    def to_keep_running(self, recording: Recording) -> Cause | None:
        """Why a node's program ended by itself, without an error that reached Python or the C++ runtime."""
        sources = recording.sources
        return first(sources, uncalled, shut_down_inside, spin_in_a_thread) or self._not_spun(sources)

    def _not_spun(self, sources: Sources) -> Cause | None:
        if not calls(sources, "init"):
            text = "`main()` must call `rclpy.init()`, create the node, and pass it to `rclpy.spin(node)`."
            return Cause(text, self.entry(sources))
        once = tuple(call.where for call in calls(sources, "spin_once"))
        if any(calls(sources, name) for name in ("spin", "rclcpp_spin_some")) or (
            once and _loop_around(sources, once[0])
        ):
            return None
        if once:
            return Cause(
                "`spin_once` handles one event. Use `rclpy.spin(node)`, which runs until Ctrl+C.", once
            )
        ends = calls(sources, "spin_until_future_complete") or calls(sources, "init")
        return Cause(
            "Nothing keeps the program running: call `rclpy.spin(node)` in `main()` after creating the node.",
            tuple(call.where for call in ends),
        )

    def deaf(self, sources: Sources) -> Cause:
        """Why Ctrl+C does not end the program."""
        known = spin_in_a_thread(sources) or _sleeps_at_the_end(sources)
        return known or Cause(_DEAF, (*self.places(sources, "signal"), *_loops_around_try(sources))[:2])

    def to_name_a_node(self, name: str) -> str:
        """Advice: how to give a node its name (no slash)."""
        return f"Give the node its name in `__init__` of its class: `super().__init__('{name}')`."

    def to_use_a_type(self, maker: str, package: str, name: str) -> str:
        """Advice: how to give `maker` (`create_publisher`) the message type package/msg/name."""
        return f"Import it with `from {package}.msg import {name}`, and pass it first to `{maker}`."

    def logged_at(self, sources: Sources, level: str) -> tuple[Location, ...]:
        """Where something is logged at this level (`WARN`)."""
        names = ("warn", "warning") if level == "WARN" else (level.lower(),)
        return tuple(place for name in names for place in self.places(sources, name))

    def printed(self, sources: Sources) -> tuple[str, tuple[Location, ...]]:
        """What the code calls to print only to the terminal, and where."""
        return "print", self.places(sources, "print")

    def other_words(self, text: str, sources: Sources) -> Cause | None:
        """Why a logged line has unexpected words, if they show what went wrong."""
        return named_only(text, sources) or (Cause(_BRACES) if "{" in text else None)

    def silent(self, sources: Sources) -> Cause | None:
        """Why a node logs nothing although it is running, if known."""
        listens = calls(sources, "create_subscription") and not calls(sources, "create_timer")
        timers = () if listens else (python_timer_cause,)
        return first(sources, defined_twice, destroyed_first, *timers, never_spun)


def _raised_by_rclpy(error: str, traceback: tuple[str, ...]) -> bool:
    """Whether rclpy failed at something that it should have been able to do during shutdown."""
    frames = [line for line in traceback if line.lstrip().startswith('File "')]
    if not frames or "/rclpy/" not in frames[-1]:
        return False
    if _SHUT_DOWN_MEANWHILE.search(error):
        return any(frame.endswith("in try_shutdown") for frame in frames)
    return bool(_SHUT_DOWN_IN_BETWEEN.search(error))


def _sleeps_at_the_end(sources: Sources) -> Cause | None:
    """A `sleep` in an `except` or a `finally`."""
    for file, node in nodes(sources):
        for part in (*node.handlers, *node.finalbody) if isinstance(node, ast.Try) else ():
            for call in ast.walk(part):
                if isinstance(call, ast.Call) and called_name(call) == "sleep":
                    text = "After Ctrl+C, the program sleeps here, so it can't end yet. Remove the `sleep`."
                    return Cause(text, (Location(file, call.lineno),))
    return None


def _loops_around_try(sources: Sources) -> Iterator[Location]:
    for file, node in nodes(sources):
        if isinstance(node, ast.While | ast.For) and any(isinstance(one, ast.Try) for one in ast.walk(node)):
            yield Location(file, node.lineno)


def _loop_around(sources: Sources, place: Location) -> Location | None:
    loops = (
        node for file, node in nodes(sources) if file == place.file and isinstance(node, ast.While | ast.For)
    )
    found = (loop for loop in loops if loop.lineno <= (place.line or 0) <= (loop.end_lineno or 0))
    return next((Location(place.file, loop.lineno) for loop in found), None)


def _at_the_end(found: Crash, recording: Recording) -> Cause:
    """What to do about this exception, which came after Ctrl+C."""
    evidence = Evidence(sources=recording.sources, packages=recording.packages)
    of_ros = _OF_CTRL_C.search(found.error)
    entries = (SHUT_DOWN_TWICE,) if of_ros else (SHUT_DOWN_TWICE, *EXCEPTIONS[:-1])  # the last matches any
    known = explain(entries, [Symptom(found.error, found.where)], evidence)
    if known:
        return Cause(known.remedy, known.where)
    own_loop = not calls(recording.sources, "spin") and any(
        calls(recording.sources, name) for name in ("rclcpp_spin_some", "spin_once")
    )
    in_loop = own_loop or not recording.packages.built
    where = found.where
    if where:  # Ctrl+C may come at any line
        spins = (call.where for call in calls(recording.sources, "spin") if call.where.file == where.file)
        where = (_loop_around(recording.sources, where) if in_loop else next(spins, None)) or where
    advice = _WITH_LOOP if in_loop else _WITH_SPIN
    slip = first(recording.sources, spin_in_a_thread, _only_one_caught)
    return slip or Cause(advice, (where,) if where else ())


def _only_one_caught(sources: Sources) -> Cause | None:
    """`except KeyboardInterrupt and ExternalShutdownException:`."""
    for file, node in nodes(sources):
        if isinstance(node, ast.ExceptHandler) and isinstance(node.type, ast.BoolOp):
            right = f"except ({', '.join(map(ast.unparse, node.type.values))}):"
            return Cause(
                f"This catches only one of the exceptions. Write `{right}`.", (Location(file, node.lineno),)
            )
    return None


def _unhandled(found: Crash, cause: Cause) -> Feedback:
    return Feedback(
        summary=f"Ctrl+C ends the program with a traceback: {found.error}",
        expected="it ends without a traceback",
        seen="a traceback",
        where=cause.where,
        advice=cause.text,
        details=found.shown,
    )


# Errors that Ctrl+C causes; any other error has a cause of its own.
_OF_CTRL_C = re.compile(
    r"^(?!NameError|ImportError).*(?:KeyboardInterrupt|ExternalShutdown|RCLError|CancelledError|rclpy|context)",
    re.I | re.S,
)
# Ways to print, as learners write them, and the patterns that find them.
_PRINTING = (("std::cout", r"\b(?:cout|cerr|clog)\s*<<"), ("printf", r"\b(?:f?printf|f?puts)\s*\("))
_CPP_DEAF = (
    "`rclcpp::spin` ends at Ctrl+C. A loop of your own must check for it: `while (rclcpp::ok())`. "
    "A signal handler of your own must call `rclcpp::shutdown()`."
)
_CPP_ENDLESS = r"\bwhile\s*\(\s*(?:true|1)\s*\)|\bfor\s*\(\s*;\s*;\s*\)|\bsig(?:nal|action)\s*\("
# What rclcpp throws if it is used after Ctrl+C.
_WENT_ON = re.compile(r"context is not valid|rcl_shutdown\(\) was called|context is already shut")
_IN_THE_TEXT = (
    ("<<", "`<<` is inside the quotes: close the string before it, and open it again after it."),
    ("%", "`RCLCPP_INFO_STREAM` joins values with `<<`. `%d` is for `RCLCPP_INFO`, with the number after "
          "the string."),
    ("{", "C++ does not fill in braces. Join text and numbers with `<<` in "
          "`RCLCPP_INFO_STREAM(get_logger(), ...)`."),
)  # fmt: skip


class Cpp:
    spin = "rclcpp::spin"
    log_info = "RCLCPP_INFO_STREAM(get_logger(), ...)"
    at_the_end = "The value that `main` returns is the exit code: `return 0;` means success."
    comes_to_an_end = "`main` must end: look for an endless loop, or for a `std::cin` that waits for input."
    after_ctrl_c = (
        "The value that `main` returns is the exit code. Let it reach `return 0;` after `rclcpp::spin`."
    )

    def places(self, sources: Sources, name: str) -> tuple[Location, ...]:
        return tuple(call.where for call in cpp_calls(sources, name))

    def entry(self, sources: Sources) -> tuple[Location, ...]:
        return places_of(sources, r"\bmain\s*\(")[:1]

    def constructor(self, sources: Sources) -> tuple[Location, ...]:
        return self.places(sources, "Node")[:1]

    def stopped(self, recording: Recording, view: ProcessView) -> Feedback | None:
        return self._crashed(recording, view, view.text, "The program stopped")

    def unhandled(self, recording: Recording, view: ProcessView, asked: float) -> Feedback | None:
        lines = tuple(line.text for line in view.lines if line.t >= asked)
        found = self._crashed(recording, view, lines, "Ctrl+C makes the program crash")
        if found and _WENT_ON.search(" ".join(lines)):
            return replace(found, advice=_CPP_DEAF, where=places_of(recording.sources, _CPP_ENDLESS)[:2])
        return found

    def _crashed(
        self, recording: Recording, view: ProcessView, lines: Sequence[str], what: str
    ) -> Feedback | None:
        notes = [event for event in recording.events if isinstance(event, Observed)]
        return cpp_crash(view.exited, lines, recording.sources, what, notes)

    def to_keep_running(self, recording: Recording) -> Cause | None:
        sources = recording.sources
        if not self.places(sources, "init"):
            text = "`main` must call `rclcpp::init(argc, argv)`, make a node, and pass it to `rclcpp::spin`."
            return Cause(text, self.entry(sources))
        if self.places(sources, "spin"):
            return None
        where = tuple(place for name in CPP_SPINS for place in self.places(sources, name))[:2]
        if self.places(sources, "spin_some"):
            return Cause(
                "`spin_some` runs what is ready. Use `rclcpp::spin(node)`, which runs until Ctrl+C.", where
            )
        return Cause(
            "Nothing keeps the program running: call `rclcpp::spin(...)` with the node, after `init`.",
            where or self.entry(sources),
        )

    def deaf(self, sources: Sources) -> Cause:
        return without_effect(sources) or Cause(_CPP_DEAF, places_of(sources, _CPP_ENDLESS)[:2])

    def to_name_a_node(self, name: str) -> str:
        return f'Pass the name on before the braces of the constructor: `: rclcpp::Node("{name}")`.'

    def to_use_a_type(self, maker: str, package: str, name: str) -> str:
        return f"Include its header, and write `{maker}<{package}::msg::{name}>`."

    def logged_at(self, sources: Sources, level: str) -> tuple[Location, ...]:
        return places_of(sources, rf"\bRCLCPP_{level}\w*\s*\(")

    def printed(self, sources: Sources) -> tuple[str, tuple[Location, ...]]:
        found = ((name, places_of(sources, pattern)) for name, pattern in _PRINTING)
        return next(((name, places) for name, places in found if places), (_PRINTING[0][0], ()))

    def other_words(self, text: str, sources: Sources) -> Cause | None:
        advice = next((advice for sign, advice in _IN_THE_TEXT if sign in text), None)
        where = () if advice else texts_without_a_text(sources)
        return Cause(advice or C_TEXTS, where) if advice or where else None

    def silent(self, sources: Sources) -> Cause | None:
        cause = first(sources, without_effect, _without_node, cpp_timer_cause, never_called)
        if cause or any(self.places(sources, name) for name in CPP_SPINS):
            return cause
        return Cause(
            "Nothing runs the timer's callback: `main` must pass the node to `rclcpp::spin(...)`, which "
            "waits and calls it. A loop of your own does not."
        )


def _without_node(sources: Sources) -> Cause | None:
    """An executor that spins, but was given no node."""
    made = places_of(sources, r"ThreadedExecutor\s+\w+\s*[;({]")
    if not made or cpp_calls(sources, "add_node"):
        return None
    return Cause("The executor has no node: call `executor.add_node(node);` before it spins.", made[:1])


Language = Python | Cpp
_PYTHON, _CPP = Python(), Cpp()


def language_of(sources: Sources) -> Language:
    """C++ if there are C++ files, else Python. `expect.one_program.about` separates several programs."""
    return _CPP if cpp_files(sources) else _PYTHON


def timer_places(sources: Sources) -> tuple[Location, ...]:
    """Return where the code creates timers."""
    return tuple(place for maker in MAKERS for place in language_of(sources).places(sources, maker))
