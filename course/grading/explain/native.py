"""Why the learner's C++ files make no program: the compiler's or the linker's first error, as feedback."""

from __future__ import annotations

from course.arena.native_programs import compiling
from course.build.digest.cpp import CppError, first_error, warnings
from course.build.digest.cpp_advice import advice_on
from course.evidence.recording import Recording
from course.feedback import Feedback, Location
from course.grading.explain.sanitizers import own_place

_LAST_LINES = 4


def not_compiled(recording: Recording, program: str) -> Feedback:
    """Why `program` (its name in `arena.compile`) could not be made."""
    return not_made(recording, compiling(program))


def not_made(recording: Recording, process: str) -> Feedback:
    """The feedback on the first cause; at worst the last lines that the compiler printed.

    process: what ran it, perhaps through `make` or CMake.
    """
    lines = recording.process(process).text
    error = first_error(lines, lambda file: _own(recording, file))
    if error is None:
        return Feedback(
            summary="The compiler makes no program of your files.",
            advice="Compile them yourself, and read the first error.",
            details=lines[-_LAST_LINES:],
        )
    summary, advice = _words(error)
    return Feedback(summary=summary, where=_places(error), advice=advice, details=error.details[:2])


def warned(recording: Recording, program: str) -> Feedback | None:
    """The feedback on the first warning of the compiler; None if there is none."""
    lines = recording.process(compiling(program)).text
    found = warnings(lines, lambda file: _own(recording, file))
    if not found:
        return None
    first = found[0]
    return Feedback(
        summary=f"The compiler warns: {first.text}.",
        expected="no warning",
        seen="1 warning" if len(found) == 1 else f"{len(found)} warnings",
        where=_places(first),
        advice="A warning is most often a mistake that compiles. Change the line until it is gone.",
        details=first.details[:2],
    )


def _own(recording: Recording, file: str) -> str | None:
    place = own_place(file, None, recording.sources)
    return place.file if place else None


def _places(error: CppError) -> tuple[Location, ...]:
    return (Location(error.file, error.line),) if error.file else ()


def _words(error: CppError) -> tuple[str, str]:
    if error.kind == "compiler":
        return f"It does not compile: {error.text}.", advice_on(error)
    if error.kind == "undefined" and error.text == "main":
        return "There is no function `main`, in which a program begins.", advice_on(error)
    if error.kind == "undefined":
        advice = "Does a .cpp file define it, with just this name and these arguments, its class in front?"
        if error.text.startswith(("vtable for", "typeinfo for")):
            advice = advice_on(error)
        return f"`{error.text}` is used, but nothing defines it.", advice
    if error.kind == "twice":
        return f"`{error.text}` is defined twice.", advice_on(error)
    return f"The linker finds no library `{error.text}`.", advice_on(error)
