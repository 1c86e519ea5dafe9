"""What it means for a beginner when a node in C++ ends by an uncaught exception, or by a signal."""

from __future__ import annotations

import re
import signal
from collections.abc import Sequence

from course.evidence.events import ProcessExited
from course.evidence.sources import Sources
from course.feedback import Feedback, Location
from course.grading.explain.cmake_lists import LISTS, commands
from course.grading.explain.cpp_code import cpp_calls
from course.grading.explain.python_code import text_places
from course.grading.explain.sanitizers import Trouble, trouble

# Words of the exception, and what to do. The first that fits is taken.
_KNOWN = (
    (r"InvalidNodeName",
     "A node's name may hold letters, digits and `_`, and does not begin with a digit."),
    (r"InvalidTopicName|InvalidServiceName",
     "Its name may hold letters, digits, `_` and `/`; no part of it begins with a digit."),
    (r"already.{0,30}initialized|ContextAlreadyInitialized",
     "Call `rclcpp::init(argc, argv)` once only, in `main`."),
    (r"init\(\) has not been called|rcl_init|not initialized|context.{1,14}(?:null|not valid|invalid)",
     "Call `rclcpp::init(argc, argv);` first in `main`, before the node is made."),
    (r"bad_weak_ptr",
     "`shared_from_this()` works only when the node is ready, and made with `std::make_shared`."),
    (r"already been added to an executor", "Spin each node in one place only."),
    (r"ParameterAlreadyDeclared", "Declare each parameter once, where the node is made."),
    (r"ParameterNotDeclared", "Declare the parameter first: `declare_parameter(\"name\", 0.5);`"),
    (r"ParameterType|ParameterUninitialized",
     "A parameter has the type of its default value: `0.5` is a double, `1` an integer, `\"0.5\"` a string."),
)  # fmt: skip
_QUOTED = re.compile(r"^\s+'(?P<name>[^']+)'\s*$")
_HEAP = re.compile(r"^(?:free|munmap_chunk|realloc)\(\):|^(?:malloc|double free|corrupted|tcache)")
_NO_LIBRARY = re.compile(r"error while loading shared libraries: lib(?P<name>\S+?)\.so")
_SHOWN = 4
_ENDINGS = {
    signal.SIGSEGV: ("it follows a pointer that leads nowhere",
                     "Is it empty (`nullptr`)? Make what it leads to before it is used: `std::make_shared`."),
    signal.SIGABRT: ("it ended itself after an error", "Read the last lines that it wrote."),
    signal.SIGFPE: ("it divides a whole number by zero", "Ask for zero before you divide."),
    signal.SIGILL: ("it came to a place that has no code",
                    "Does each function that is to return something return it?"),
}  # fmt: skip
_TWICE = (
    "it gives memory back that is not its own to give",
    "Make the node with `std::make_shared`, and hand on that pointer: no second one of the same node.",
)


def cpp_crash(
    ended: ProcessExited | None, lines: Sequence[str], sources: Sources, what: str
) -> Feedback | None:
    """What these last lines of a program and its end tell; None for an end without an error.

    what: how the summary begins, for an end by a signal.
    """
    if lost := _own_library(lines, sources):
        return lost
    found = trouble(lines, sources)
    if found:
        return _thrown(found, lines, sources) if found.thrown else _as_told(found)
    if ended is None or ended.signal not in _ENDINGS:
        return None
    heap = [line for line in lines if _HEAP.search(line)]
    cause, advice = _TWICE if heap else _ENDINGS[signal.Signals(ended.signal)]
    where: tuple[Location, ...] = ()
    if ended.signal == signal.SIGSEGV and (texts := _texts_without_a_text(sources)):
        where = texts
        advice = "`%s` stands for a text. A whole number is written `%d`, a `double` `%f`."
    return Feedback(
        summary=f"{what}: {cause}.",
        seen=f"ended by the signal {signal.Signals(ended.signal).name}",
        where=where,
        advice=advice,
        details=(tuple(heap) or tuple(lines))[-_SHOWN:],
    )


def _own_library(lines: Sequence[str], sources: Sources) -> Feedback | None:
    """The program does not start, for want of a library that its own package makes."""
    names = {match["name"] for line in lines if (match := _NO_LIBRARY.search(line))}
    folders = [file.removesuffix(f"/{LISTS}") for file in sources.files if file.endswith(f"/{LISTS}")]
    for command in (one for folder in folders for one in commands(sources, folder)):
        if command.name == "add_library" and command.words[:1] and command.words[0] in names:
            name = command.words[0]
            return Feedback(
                summary=f"The program does not start: it does not find the library `lib{name}.so`.",
                where=(command.where,),
                advice=f"The package builds it, but it is to be installed, too: "
                f"`install(TARGETS {name} EXPORT ... LIBRARY DESTINATION lib)`.",
                details=tuple(re.sub(r"^/\S*/", "", line) for line in lines if _NO_LIBRARY.search(line))[:1],
            )
    return None


def _as_told(found: Trouble) -> Feedback:
    return Feedback(
        summary=found.summary,
        where=(found.where,) if found.where else (),
        advice=found.advice,
        details=found.details,
    )


def _thrown(found: Trouble, lines: Sequence[str], sources: Sources) -> Feedback:
    said = " ".join(lines)
    advice = next((advice for words, advice in _KNOWN if re.search(words, said)), found.advice)
    return Feedback(
        summary=found.summary,
        where=_named(lines, sources),
        advice=advice,
        details=found.details,
    )


def _named(lines: Sequence[str], sources: Sources) -> tuple[Location, ...]:
    """Where the name stands that an exception of ROS complains of."""
    names = (match["name"] for line in lines if (match := _QUOTED.match(line)))
    return tuple(place for name in names for place in text_places(sources, f'"{name}"'))[:2]


def _texts_without_a_text(sources: Sources) -> tuple[Location, ...]:
    """Lines that are logged with `%s`, and give no text for it as C would have it."""
    logged = (call for call in cpp_calls(sources, "RCLCPP_INFO") if "%s" in call.arguments)
    return tuple(call.where for call in logged if "c_str" not in call.arguments)
