"""What it means for a beginner when an exception, a signal or a sanitizer ends a compiled program."""

from __future__ import annotations

import re
import signal
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

from course.evidence.sources import Sources
from course.explain.cmake import LISTS, commands
from course.explain.cpp_code import cpp_calls, cpp_files, only_code, places_of
from course.explain.engine import Cause
from course.explain.python_code import text_places
from course.model.events import Observed, ProcessExited
from course.model.feedback import Feedback, Location

_ADDRESS = re.compile(r"ERROR: AddressSanitizer:? (?P<kind>attempting [\w-]+|[\w-]+)")
_UNDEFINED = re.compile(r"^(?P<file>[^:\s][^:]*):(?P<line>\d+):\d+: runtime error: (?P<text>.+)$")
_FRAME = re.compile(r"^\s+#\d+ .* (?P<file>\S+?):(?P<line>\d+)(?::\d+)?$")
_UNCAUGHT = re.compile(r"terminate called after throwing an instance of '(?P<type>[^']+)'")
_WHAT = re.compile(r"^\s+what\(\):\s+(?P<text>.*)$")
_LIBRARY = re.compile(r"error while loading shared libraries: (?P<name>[^:]+):")

# Begins advice that names no line. Such advice triggers a second run, with a sanitizer.
NO_LINE = "The line is not known."
# Parts of the name that the sanitizer gives the error, what it means, and what to do.
_KINDS = (
    (("overflow-on", "stack-overflow"), "A function calls itself forever.",
     "Find the function that calls itself. Nothing stops it, or what it follows leads back to itself."),
    (("heap-buffer", "stack-buffer", "global-buffer", "container-overflow", "dynamic-stack-buffer"),
     "The program reads or writes outside the bounds of an array or a vector.",
     "`[...]` does not check that the element exists. `.at(...)` does, and throws an exception if it does "
     "not."),
    (("use-after-free",), "The program uses an object that was already deleted.",
     "Keep a copy of the `std::shared_ptr` that owns the object, not a plain pointer to it."),
    (("use-after-scope", "use-after-return"), "The program uses a variable that no longer exists.",
     "A function's local variables are gone once it returns. Do not keep a reference or a pointer to one."),
    (("double-free",), "The program deletes the same object twice.",
     "Create the object with `std::make_shared` and copy that pointer. Do not create a second one."),
    (("attempting free", "bad-free"), "The program deletes something that was not created with `new`.",
     "Only delete what you created with `new`. With smart pointers, do not write `delete` at all."),
    (("alloc-dealloc", "new-delete"), "The program deletes something with the wrong kind of `delete`.",
     "`new[]` needs `delete[]`, and `new` needs `delete`. Smart pointers choose the right one for you."),
    (("SEGV",), "The program uses a pointer that does not point to an object.",
     "Is the pointer empty (`nullptr`)? Check it before you use `->` or `*`: `if (pointer)`."),
)  # fmt: skip
_MOST_CALLS = 4
_OTHERWISE = ("The program uses memory that it must not use.", "Check the line shown here.")


@dataclass(frozen=True)
class Trouble:
    """summary, advice: for the learner. where: their line that caused it. details: the shortened report.

    thrown: the type of an uncaught exception.
    """

    summary: str
    advice: str
    where: Location | None
    details: tuple[str, ...]
    thrown: str = ""


def trouble(lines: Sequence[str], sources: Sources) -> Trouble | None:
    """What these lines of a program's output say about how it ended; None if they say nothing."""
    for number, line in enumerate(lines):
        if found := _ADDRESS.search(line):
            return _address(found["kind"], lines[number:], sources)
        if found := _UNDEFINED.match(line):
            place = own_place(found["file"], found["line"], sources)
            return _undefined(found["text"], place, lines[number:], sources)
        if found := _UNCAUGHT.search(line):
            return _uncaught(found["type"], lines[number : number + 2], sources)
        if found := _LIBRARY.search(line):
            return _no_library(found["name"], line)
    return None


def own_place(file: str, line: str | None, sources: Sources) -> Location | None:
    """The location for a place as a tool prints it; None if it is not in one of the learner's files."""
    name = file.removeprefix("~/").removeprefix("./")
    return Location(name, int(line) if line else None) if name in sources.names else None


def _address(kind: str, report: Sequence[str], sources: Sources) -> Trouble:
    known = (words for parts, *words in _KINDS if any(part in kind for part in parts))
    summary, advice = next(known, _OTHERWISE)
    return Trouble(summary, advice, next(_own_frames(report, sources), None), _shortened(report, sources))


def _undefined(text: str, place: Location | None, report: Sequence[str], sources: Sources) -> Trouble:
    place = place or next(_own_frames(report, sources), None)
    summary = f"The program does something that is undefined in C++: {text[:80]}."
    advice = "The result can be different each time. Check the values that this line uses."
    if "null pointer" in text:
        advice = "Is the pointer empty (`nullptr`)? Check it before you use `->` or `*`: `if (pointer)`."
    return Trouble(summary, advice, place, tuple(report[:1]))


def _uncaught(thrown: str, lines: Sequence[str], sources: Sources) -> Trouble:
    said = _WHAT.match(lines[1]) if len(lines) > 1 else None
    words = f" ({said['text'][:60]})" if said and said["text"] != thrown else ""
    summary = f"The program ends with an uncaught exception of type `{thrown}`{words}."
    advice = (
        f"Put the call that throws in `try {{ ... }}`, followed by `catch (const {thrown}& error) {{ ... }}`."
    )
    throws = places_of(sources, rf"\bthrow\s+(?:std::)?{re.escape(thrown.removeprefix('std::'))}\b")
    return Trouble(summary, advice, throws[0] if len(throws) == 1 else None, tuple(lines), thrown)


def _no_library(name: str, line: str) -> Trouble:
    summary = f"The program cannot start because the shared library `{name}` was not found."
    advice = "Add its folder to `LD_LIBRARY_PATH`, or to the program's `rpath` when you link it."
    return Trouble(summary, advice, None, (line,))


def _own_frames(report: Sequence[str], sources: Sources) -> Iterator[Location]:
    for line in report:
        found = _FRAME.match(line)
        place = own_place(found["file"], found["line"], sources) if found else None
        if place:
            yield place


def _shortened(report: Sequence[str], sources: Sources) -> tuple[str, ...]:
    """The report's first line, and the calls in the learner's files."""
    own = (line.strip() for line in report if next(_own_frames((line,), sources), None))
    return (report[0].partition("ERROR: ")[2][:160], *islice(own, _MOST_CALLS))


def crash_notes(report: Sequence[str]) -> Iterator[Observed]:
    """Where the program was, according to a sanitizer's report: the innermost place first."""
    found = next(filter(None, map(_ADDRESS.search, report)), None)
    for frame in filter(None, map(_FRAME.match, report)) if found else ():
        # The learner's files have paths relative to their home; most of the system's files do not.
        if found and not frame["file"].startswith("/"):
            yield Observed(0.0, "crashed", found["kind"], raised=Location(frame["file"], int(frame["line"])))


def _located(advice: str, notes: Iterable[Observed] | None, sources: Sources) -> Cause:
    """The advice with the line where it happened. notes: from a second run; None if there can be none."""
    for note in notes or ():
        place = note.raised if note.what == "crashed" else None
        if place and 0 < (place.line or 0) <= len(sources.files.get(place.file, "").splitlines()):
            words = next((words for parts, *words in _KINDS if any(part in note.error for part in parts)), ())
            # The summary has already said what SEGV means, so only the advice is needed.
            said = words[-1:] if "SEGV" in note.error else words
            file = place.file.rpartition("/")[2]
            text = f"It happens on line {place.line} of `{file}`. {' '.join(said) or advice}"
            return Cause(text, (place,))
    return Cause(advice if notes is None else f"{NO_LINE} {advice}")


# What the exception's text contains, what to do, and for some, the code to look at. The first match counts.
_KNOWN = (
    (r"InvalidNodeName",
     "A node's name may contain only letters, digits and `_`, and must not begin with a digit."),
    (r"InvalidTopicName|InvalidServiceName",
     "The name may contain only letters, digits, `_` and `/`. No part of it may begin with a digit."),
    (r"already.{0,30}initialized|ContextAlreadyInitialized",
     "Call `rclcpp::init(argc, argv)` only once, in `main`."),
    (r"init\(\) has not been called|rcl_init|not initialized|context.{1,14}(?:null|not valid|invalid)",
     "Call `rclcpp::init(argc, argv);` first in `main`, before the node is created.", r"\bmain\s*\("),
    (r"bad_weak_ptr",
     "`shared_from_this()` works only after the constructor has returned, on a node created with "
     "`std::make_shared`.", r"\bshared_from_this\s*\("),
    (r"already been added to an executor", "Spin each node in one place only."),
    (r"ParameterAlreadyDeclared", "Declare each parameter once, where the node is created."),
    (r"ParameterNotDeclared", "Declare the parameter first: `declare_parameter(\"name\", 0.5);`"),
    (r"ParameterType|ParameterUninitialized",
     "A parameter has the type of its default value: `0.5` is a double, `1` an integer, `\"0.5\"` a string."),
)  # fmt: skip
# The same for errors that depend on a value: here the advice also names the line, if it is known.
_WRONG_VALUES = (
    (r"_M_range_check|array::at",
     "There is no such element. The first index is 0, and the last one is `size() - 1`."),
    (r"map::at", "The map has no such key. Check for it with `find(...)` first."),
    (r"invalid_argument.*what\(\): +sto[a-z]+$", "The string does not start with a number."),
    (r"out_of_range.*what\(\): +sto[a-z]+$", "The number in the string is too large for this type."),
    (r"bad_function_call", "The `std::function` is empty: assign a function to it first."),
    (r"bad_optional_access", "The `std::optional` is empty: check it with `has_value()` first."),
    (r"bad_variant_access|bad_any_cast", "The value does not have the type that the code asks for."),
)  # fmt: skip
_QUOTED = re.compile(r"^\s+'(?P<name>[^']+)'\s*$")
_HEAP = re.compile(r"^(?:free|munmap_chunk|realloc)\(\):|^(?:malloc|double free|corrupted|tcache)")
_NO_LIBRARY = re.compile(r"error while loading shared libraries: lib(?P<name>\S+?)\.so")
_SHOWN, _MOST_FUNCTIONS = 4, 200
_ENDINGS = {
    signal.SIGSEGV: ("it uses a pointer that does not point to an object",
                     "Is the pointer empty (`nullptr`)? Create the object before you use it: "
                     "`std::make_shared`."),
    signal.SIGABRT: ("it stopped itself after an error", "Read the last lines of its output."),
    signal.SIGFPE: ("it divides an integer by zero", "Check for zero before you divide."),
    signal.SIGILL: ("it ran an unknown instruction",
                    "Does every function with a return type return a value?"),
}  # fmt: skip
_TWICE = (
    "it frees memory that it must not free",
    "Create the node with `std::make_shared` and pass that pointer on. Do not create a second one from it.",
)
C_TEXTS = "`%s` takes a C string: use `.c_str()`. `%d` takes an `int`, and `%f` a `double`."


def cpp_crash(
    ended: ProcessExited | None,
    lines: Sequence[str],
    sources: Sources,
    what: str,
    notes: Iterable[Observed] | None = None,
) -> Feedback | None:
    """What the program's last lines and the way it ended say; None if it ended without an error.

    what: how the summary begins if a signal ended it. notes: from a second run; None if there can be none.
    """
    if lost := _own_library(lines, sources):
        return lost
    found = trouble(lines, sources)
    if found:
        return _thrown(found, lines, sources, notes) if found.thrown else _as_told(found)
    if ended is None or ended.signal not in _ENDINGS:
        return None
    heap = [line for line in lines if _HEAP.search(line)]
    cause, advice = _TWICE if heap else _ENDINGS[signal.Signals(ended.signal)]
    where: tuple[Location, ...] = ()
    if ended.signal == signal.SIGSEGV and (texts := texts_without_a_text(sources)):
        where, advice = texts, C_TEXTS
    if ended.signal == signal.SIGSEGV and (endless := calls_itself(sources)):
        cause, advice, where = "a function calls itself endlessly", endless.text, endless.where
    if not where:
        located = _located(advice, notes, sources)
        advice, where = located.text, located.where
    return Feedback(
        summary=f"{what}: {cause}.",
        seen=f"ended by the signal {signal.Signals(ended.signal).name}",
        where=where,
        advice=advice,
        details=(tuple(heap) or tuple(lines))[-_SHOWN:],
    )


def _own_library(lines: Sequence[str], sources: Sources) -> Feedback | None:
    """The program does not start because a library from its own package is missing."""
    names = {match["name"] for line in lines if (match := _NO_LIBRARY.search(line))}
    folders = [file.removesuffix(f"/{LISTS}") for file in sources.files if file.endswith(f"/{LISTS}")]
    for command in (one for folder in folders for one in commands(sources, folder)):
        if command.name == "add_library" and command.words[:1] and command.words[0] in names:
            name = command.words[0]
            return Feedback(
                summary=f"The program cannot start because it does not find the library `lib{name}.so`.",
                where=(command.where,),
                advice=f"The package builds it but does not install it. Add `install(TARGETS {name} EXPORT "
                f"... LIBRARY DESTINATION lib)`.",
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


def _thrown(
    found: Trouble, lines: Sequence[str], sources: Sources, notes: Iterable[Observed] | None
) -> Feedback:
    cause = _why_thrown(found, " ".join(lines), sources, notes)
    return Feedback(
        summary=found.summary,
        where=cause.where or _named(lines, sources),
        advice=cause.text,
        details=found.details,
    )


def _why_thrown(found: Trouble, said: str, sources: Sources, notes: Iterable[Observed] | None) -> Cause:
    if "rcl_shutdown() was called" in said and (early := _shut_down_early(sources)):
        return Cause("`rclcpp::shutdown()` comes before `rclcpp::spin`: move it to the end of `main`.", early)
    for words, advice, *code in _KNOWN:
        if re.search(words, said):
            places = [place for pattern in code for place in places_of(sources, pattern)]
            return Cause(advice, tuple(places[:1]))
    told = " ".join(found.details)
    advice = next((advice for words, advice in _WRONG_VALUES if re.search(words, told)), found.advice)
    if found.where:
        return Cause(advice, (found.where,))
    return _located(advice, notes, sources)


def _shut_down_early(sources: Sources) -> tuple[Location, ...]:
    """Where a file shuts ROS down before the first line that spins."""
    ends, spins = (places_of(sources, rf"\brclcpp::{name}\s*\(") for name in ("shutdown", "spin"))
    first = [spin for end in ends[:1] for spin in spins if spin.file == end.file][:1]
    return ends[:1] if first and (ends[0].line or 0) < (first[0].line or 0) else ()


def _named(lines: Sequence[str], sources: Sources) -> tuple[Location, ...]:
    """Where the code contains the name that a ROS exception complains about."""
    names = (match["name"] for line in lines if (match := _QUOTED.match(line)))
    return tuple(place for name in names for place in text_places(sources, f'"{name}"'))[:2]


_FUNCTION = re.compile(
    r"(?<![\w.>])(?P<name>operator\s*<<|\w+)\s*\((?P<given>[^(){};]*)\)\s*(?:const\s*)?\{(?P<body>[^{}]*)\}"
)
_LEAVES = re.compile(r"\b(?:if|while|for|switch|catch)\b|[?]|&&|\|\|")


def calls_itself(sources: Sources) -> Cause | None:
    """A function that always calls itself again, such as an `operator<<` that writes its own object."""
    for file, text in cpp_files(sources).items():
        code = only_code(text)
        for found in islice(_FUNCTION.finditer(code), _MOST_FUNCTIONS):
            again = None if _LEAVES.search(found["body"]) else re.search(_itself(found), found["body"])
            if again:
                start = found.start("body") + again.start()
                text = "" if "<<" in found["name"] else "()"
                return Cause(
                    f"`{' '.join(found['name'].split())}{text}` calls itself endlessly here. Use the member "
                    f"or function that has the value.",
                    (Location(file, code.count("\n", 0, start) + 1),),
                )
    return None


def _itself(function: re.Match[str]) -> str:
    """A pattern for a call of the function with the same number of arguments."""
    parameters = [part.split()[-1].lstrip("&*") for part in function["given"].split(",") if part.strip()]
    if "<<" in function["name"]:
        last = re.escape(parameters[-1]) if parameters else "this"
        return rf"<<\s*{last}\s*(?:;|<<)"
    arguments = r"[^(),]+" + r",[^(),]+" * (len(parameters) - 1) if parameters else r"\s*"
    return rf"(?<![\w.>:]){re.escape(function['name'])}\s*\({arguments}\)"


def texts_without_a_text(sources: Sources) -> tuple[Location, ...]:
    """Lines that log with `%s` but do not pass a C string."""
    logged = (call for call in cpp_calls(sources, "RCLCPP_INFO") if "%s" in call.arguments)
    return tuple(call.where for call in logged if "c_str" not in call.arguments)
