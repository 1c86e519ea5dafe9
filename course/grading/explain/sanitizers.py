"""How a compiled program failed while it ran: what the sanitizers, or C++ itself, said of it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

from course.evidence.sources import Sources
from course.feedback import Location

_ADDRESS = re.compile(r"ERROR: AddressSanitizer:? (?P<kind>attempting [\w-]+|[\w-]+)")
_UNDEFINED = re.compile(r"^(?P<file>[^:\s][^:]*):(?P<line>\d+):\d+: runtime error: (?P<text>.+)$")
_FRAME = re.compile(r"^\s+#\d+ .* (?P<file>\S+?):(?P<line>\d+)(?::\d+)?$")
_UNCAUGHT = re.compile(r"terminate called after throwing an instance of '(?P<type>[^']+)'")
_WHAT = re.compile(r"^\s+what\(\):\s+(?P<text>.*)$")
_LIBRARY = re.compile(r"error while loading shared libraries: (?P<name>[^:]+):")

# Parts of the sanitizer's own word, what it means, and what to do.
_KINDS = (
    (("overflow-on", "stack-overflow"), "A function calls itself without end.",
     "Look for a function that calls itself, and for what should stop it."),
    (("heap-buffer", "stack-buffer", "global-buffer", "container-overflow", "dynamic-stack-buffer"),
     "The program reads or writes outside of an array or a vector.",
     "`[...]` does not look whether there is such an element; `.at(...)` does, and throws."),
    (("use-after-free",), "The program uses an object that has been deleted already.",
     "Who needs it holds the `std::shared_ptr` it was made with: no plain pointer, and no second one of it."),
    (("use-after-scope", "use-after-return"), "The program uses a variable that does not exist any more.",
     "A reference or pointer to a variable of a function is worth nothing when that has returned."),
    (("double-free",), "The same object is deleted twice.",
     "Give each object to one smart pointer only, when it is made: `std::make_shared`. Copy that one then."),
    (("attempting free", "bad-free"), "Something is deleted that `new` has not made.",
     "Only what `new` made may be deleted, and with smart pointers nothing by hand."),
    (("alloc-dealloc", "new-delete"), "Something is deleted in another way than it was made.",
     "What `new[]` made is for `delete[]`, what `new` made for `delete`. Smart pointers know which."),
    (("SEGV",), "The program follows a pointer that leads nowhere.",
     "Is it empty (`nullptr`)? Ask before you use `->` or `*`: `if (pointer)`."),
)  # fmt: skip
_MOST_CALLS = 4
_OTHERWISE = ("The program does something with memory that it must not do.", "Look at the line named here.")


@dataclass(frozen=True)
class Trouble:
    """summary, advice: for the learner. where: their line that led to it. details: the report, shortened.

    thrown: the type of an exception that nothing caught.
    """

    summary: str
    advice: str
    where: Location | None
    details: tuple[str, ...]
    thrown: str = ""


def trouble(lines: Sequence[str], sources: Sources) -> Trouble | None:
    """What these lines of a program's output tell of its end; None if they tell nothing."""
    for number, line in enumerate(lines):
        if found := _ADDRESS.search(line):
            return _address(found["kind"], lines[number:], sources)
        if found := _UNDEFINED.match(line):
            place = own_place(found["file"], found["line"], sources)
            return _undefined(found["text"], place, lines[number:], sources)
        if found := _UNCAUGHT.search(line):
            return _uncaught(found["type"], lines[number : number + 2])
        if found := _LIBRARY.search(line):
            return _no_library(found["name"], line)
    return None


def own_place(file: str, line: str | None, sources: Sources) -> Location | None:
    """A place as a tool prints it, when it is in a file of the learner's."""
    name = file.removeprefix("~/").removeprefix("./")
    return Location(name, int(line) if line else None) if name in sources.names else None


def _address(kind: str, report: Sequence[str], sources: Sources) -> Trouble:
    known = (words for parts, *words in _KINDS if any(part in kind for part in parts))
    summary, advice = next(known, _OTHERWISE)
    return Trouble(summary, advice, next(_own_frames(report, sources), None), _shortened(report, sources))


def _undefined(text: str, place: Location | None, report: Sequence[str], sources: Sources) -> Trouble:
    place = place or next(_own_frames(report, sources), None)
    summary = f"The program does what C++ does not define: {text[:80]}."
    advice = "It may do anything then, another thing each time. Look at the numbers in this line."
    if "null pointer" in text:
        advice = "Is it empty (`nullptr`)? Ask before you use `->` or `*`: `if (pointer)`."
    return Trouble(summary, advice, place, tuple(report[:1]))


def _uncaught(thrown: str, lines: Sequence[str]) -> Trouble:
    said = _WHAT.match(lines[1]) if len(lines) > 1 else None
    words = f" ({said['text'][:60]})" if said and said["text"] != thrown else ""
    summary = f"An exception of type `{thrown}` ends the program{words}: nothing catches it."
    advice = f"Put what may throw into `try {{ ... }}`, and `catch (const {thrown}& error) {{ ... }}` behind."
    return Trouble(summary, advice, None, tuple(lines), thrown)


def _no_library(name: str, line: str) -> Trouble:
    summary = f"The program does not start: the shared library `{name}` is not found."
    advice = "Its folder belongs into `LD_LIBRARY_PATH`, or into the program itself when that is linked."
    return Trouble(summary, advice, None, (line,))


def _own_frames(report: Sequence[str], sources: Sources) -> Iterator[Location]:
    for line in report:
        found = _FRAME.match(line)
        place = own_place(found["file"], found["line"], sources) if found else None
        if place:
            yield place


def _shortened(report: Sequence[str], sources: Sources) -> tuple[str, ...]:
    """Its first line, and the calls in files of the learner's."""
    own = (line.strip() for line in report if next(_own_frames((line,), sources), None))
    return (report[0].partition("ERROR: ")[2][:160], *islice(own, _MOST_CALLS))
