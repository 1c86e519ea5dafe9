"""Graders of chapter 28: bounds and exceptions, ownership, and forwarding without copies."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    Recording,
    expect_compiled,
    expect_no_warnings,
    expect_sound,
    native_answer,
    replace,
)
from lib.native_answers import wrong

PROBES = Path(__file__).with_name("probes")
CPP = "ros2_tutorials_preamble/cpp"

bounds = Grader("28-bounds", builds=None, ros=False, sanitizers=True)

BOUNDS = f"{CPP}/bounds"
SENSORS = f"{BOUNDS}/sensors.cpp"
MAIN = f"{BOUNDS}/main.cpp"
TILTS = (0.0, 1.047198, 1.570796, 3.141593)


@bounds.scenario
def ask_and_run_bounds(arena: Arena) -> None:
    program = arena.cpp.compile("bounds", f"{BOUNDS}/*.cpp")
    for name, arguments in (("inside", ("2", "0.5")), ("outside", ("9", "1.1")), ("half", ("5", "-3"))):
        run = arena.cpp.run(program, *arguments, name=name)
        if run:
            run.wait(10)
    asked = arena.cpp.compile("functions", f"{BOUNDS}/*.cpp", ours=PROBES / "ch28_bounds.cpp", without=MAIN)
    for question in ("ranges", "behind", "far", "tilts"):
        arena.cpp.ask(asked, question, name=question, timeout=10)


@bounds.check("compiles", "the program compiles")
def bounds_compiles(recording: Recording) -> None:
    expect_compiled(recording, "bounds")
    expect_fitting(recording, "functions", SENSORS)


def expect_fitting(recording: Recording, program: str, file: str) -> None:
    """Expect that our program can call the functions that `file` must define."""
    said = "\n".join(recording.process(f"compile {program}").text)
    lost = re.search(r"undefined reference to `(\w+)\(", said)
    if lost is None:
        expect_compiled(recording, program)
        return
    name = file.rpartition("/")[2]
    raise Failure(
        Feedback(
            summary=f"`{name}` does not define `{lost[1]}`, so no other program can call it.",
            expected=f"`{lost[1]}` in {name}",
            where=(Location(file),),
            advice=f"Move it to {name}, outside any `namespace`. `main.cpp` only calls it.",
        )
    )


@bounds.check("warnings", "there are no compiler warnings", needs="compiles")
def bounds_warnings(recording: Recording) -> None:
    expect_no_warnings(recording, "bounds")


@bounds.check("range", "`range_of` returns the range of a sensor", needs="compiles")
def ranges(recording: Recording) -> None:
    wanted = [0.25, 1.5, 3.0]
    what = "range_of({0.25, 1.5, 3}, ...)"
    seen = native_answer(recording, "ranges", what, "ranges", where=Location(SENSORS))
    if seen.value == wanted:
        return
    raise Failure(
        Feedback(
            summary="`range_of` does not return the ranges of sensors 0, 1, and 2."
            if seen.error is None
            else f"`range_of` throws for a sensor that exists: {seen.error[:60]}",
            expected="0.25, 1.5 and 3",
            seen=numbers(seen.value) if seen.error is None else seen.error,
            where=(Location(SENSORS),),
            advice="Start counting sensors at 0, like the elements of a vector.",
        )
    )


@bounds.check("throws", "`range_of` throws for a sensor that does not exist", points=2, needs="range")
def throws(recording: Recording) -> None:
    for question, sensor in (("behind", "3"), ("far", "18446744073709551615")):
        what = f"range_of({{0.25, 1.5, 3}}, {sensor})"
        expect_thrown(
            recording,
            question,
            what,
            question,
            "out_of_range",
            "Use `ranges.at(sensor)`, which throws this exception. `ranges[sensor]` never does.",
        )


@bounds.check("tilt", "`tilt_of` throws if there is no such angle", points=2, needs="compiles")
def tilt(recording: Recording) -> None:
    where, four = Location(SENSORS), tuple[Any, Any, Any, Any]
    seen = native_answer(recording, "tilts", "tilt_of(0.5)", "tilts", where=where, shape=four)
    near = seen.error is None and all(map(is_near, seen.value, TILTS))
    if not near:
        raise Failure(
            Feedback(
                summary="`tilt_of` does not return the angles for the cosines 1, 0.5, 0, and -1.",
                expected=numbers(TILTS),
                seen=seen.error or numbers(seen.value),
                where=(Location(SENSORS),),
                advice="Return what `std::acos` returns: it is in radians. 1 and -1 are valid cosines, too.",
            )
        )
    advice = (
        'Here `std::acos` returns NaN, "not a number". Check for it with `std::isnan`: `==` is never '
        "true for NaN."
    )
    for question, cosine in (("above", "1.1"), ("below", "-1.1")):
        expect_thrown(recording, question, f"tilt_of({cosine})", "tilts", "domain_error", advice)


def expect_thrown(
    recording: Recording, question: str, what: str, process: str, wanted: str, advice: str
) -> None:
    seen = native_answer(recording, question, what, process, where=Location(SENSORS))
    if seen.value == wanted:
        return
    returned = str(seen.value).removeprefix("returned ")
    raise wrong(
        recording,
        Feedback(
            summary=f"`{what}` throws `{seen.type}`. It should throw `std::{wanted}`."
            if seen.error is not None
            else f"`{what}` does not throw. It returns {returned}.",
            expected=f"std::{wanted}",
            seen=(seen.error or returned)[:120],
            where=(Location(SENSORS),),
            advice=advice
            if seen.error is None
            else "Leave out `new`: C++ throws the object itself."
            if str(seen.type).endswith("*")
            else f"Throw `std::{wanted}` instead.",
        ),
    )


@bounds.check("prints", "the program prints a range and a tilt", needs="compiles")
def bounds_prints(recording: Recording) -> None:
    expect_lines_of(recording, "inside", ("sensor 2: 1", "tilt: 1.0472"), "./bounds 2 0.5")


@bounds.check(
    "catches", "it catches the exceptions and continues", points=2, needs=("prints", "throws", "tilt")
)
def catches(recording: Recording) -> None:
    outside = ("sensor 9: no such sensor", "tilt: not a number")
    expect_lines_of(recording, "outside", outside, "./bounds 9 1.1")
    expect_lines_of(recording, "half", ("sensor 5: 2.5", "tilt: not a number"), "./bounds 5 -3")


def expect_lines_of(recording: Recording, run: str, wanted: tuple[str, ...], command: str) -> None:
    view = expect_sound(recording, run)
    seen = tuple(line.strip() for line in view.text if line.strip())
    if seen == wanted:
        return
    pairs = zip(wanted, (*seen, *("nothing",) * len(wanted)), strict=False)
    line, printed = next(((a, b) for a, b in pairs if a != b), ("no more lines", seen[-1] if seen else ""))
    raise Failure(
        Feedback(
            summary=f"`{command}` prints `{printed[:60]}`, not `{line}`."
            if seen
            else f"`{command}` prints nothing.",
            expected=line,
            seen=printed[:120],
            where=(Location(MAIN),),
            advice=printing_advice(line, printed),
            details=seen[:4],
        )
    )


def printing_advice(wanted: str, printed: str) -> str:
    begun = wanted.partition(":")[0] + ":"
    if printed.count(begun) > 1:
        return (
            "The program had already begun to print the line when the exception was thrown. Call the "
            "function and store its result before you print anything."
        )
    if wanted.endswith(("no such sensor", "not a number")):
        return f"Print `{wanted}` where you catch the exception, then let the program continue."
    return "Compare your text with the task, letter by letter. They must match exactly."


def is_near(seen: object, wanted: float) -> bool:
    return isinstance(seen, int | float) and abs(seen - wanted) < 1e-4


def told_by(recording: Recording, question: str, what: str, process: str, where: Location, shape: Any) -> Any:
    """The answer of a program, in which nothing may throw."""
    answer = native_answer(recording, question, what, process, where=where, shape=shape)
    if answer.error is not None:
        summary = f"`{what}` throws: {answer.error[:80]}"
        raise Failure(
            Feedback(summary=summary, where=(where,), advice="Find out what throws this exception.")
        )
    return answer.value


def numbers(values: object) -> str:
    if not isinstance(values, list | tuple):
        return str(values)
    return ", ".join(f"{value:.4g}" if isinstance(value, int | float) else str(value) for value in values)


# ------------------------------------------------------------------------------------- 28-smart-pointers

pointers = Grader("28-smart-pointers", builds=None, ros=False, sanitizers=True)

ROVER = f"{CPP}/smart_pointers"
HEADER = f"{ROVER}/hardware.hpp"
HARDWARE = f"{ROVER}/hardware.cpp"
ROVER_LINES = ("the sensor is mounted on the mast", "the rover has 3 parts", "mast on a body")


@pointers.scenario
def ask_and_run_rover(arena: Arena) -> None:
    program = arena.cpp.compile("rover", f"{ROVER}/*.cpp", heap=True)
    arena.cpp.ask(program, name="rover", timeout=10)
    parts = PROBES / "ch28_parts.cpp"
    asked = arena.cpp.compile("parts", f"{ROVER}/*.cpp", ours=parts, without=f"{ROVER}/main.cpp")
    for question in ("tree", "kept", "gone"):
        arena.cpp.ask(asked, question, name=question, timeout=10)


@pointers.check("compiles", "the program compiles")
def rover_compiles(recording: Recording) -> None:
    expect_compiled(recording, "rover")


@pointers.check("warnings", "there are no compiler warnings", needs="compiles")
def rover_warnings(recording: Recording) -> None:
    expect_no_warnings(recording, "rover")


@pointers.check("runs", "it prints its three lines and ends without an error", needs="compiles")
def rover_runs(recording: Recording) -> None:
    with own_child_named(recording):
        view = expect_sound(recording, "rover")
    seen = tuple(line.strip() for line in view.text if line.strip())
    if seen == ROVER_LINES:
        return
    missing = [line for line in ROVER_LINES if line not in seen]
    raise wrong(
        recording,
        Feedback(
            summary=f"The program no longer prints `{missing[0]}`."
            if missing
            else "The program prints more than its three lines.",
            expected="the three lines that it printed before",
            seen=seen[0][:120] if seen else "nothing",
            where=(Location(f"{ROVER}/main.cpp"),),
            advice="Change only who owns which part. `main` must print the same lines as before.",
            details=seen[:5],
        ),
    )


@pointers.check("shared", "the functions take and return `std::shared_ptr<Part>`", needs="compiles")
def shared(recording: Recording) -> None:
    errors = [line for line in recording.process("compile parts").text if " error: " in line]
    unfit = errors[0] if "Part*" in "".join(errors[:1]) else None
    if unfit:
        raise Failure(
            Feedback(
                summary="The functions still take or return plain pointers, `Part*`.",
                expected="std::shared_ptr<Part>",
                seen=unfit.partition("error: ")[2][:120],
                where=plain_pointers(recording),
                advice=(
                    "Replace `Part*` with `std::shared_ptr<Part>` in hardware.hpp and hardware.cpp. For "
                    "arguments, use `const std::shared_ptr<Part>&`."
                ),
            )
        )
    expect_fitting(recording, "parts", HARDWARE)


def plain_pointers(recording: Recording) -> tuple[Location, ...]:
    lines = enumerate(recording.home.file(HEADER).lines, 1)
    found = [Location(HEADER, n) for n, line in lines if "Part*" in line.split("//")[0]]
    return tuple(found[:2]) or (Location(HEADER),)


@contextmanager
def own_child_named(recording: Recording) -> Iterator[None]:
    """Explains a failure by a part that is stored among its own children, if the code says so."""
    try:
        yield
    except Failure as failure:
        lines = enumerate(recording.home.file(HARDWARE).lines, 1)
        own = [n for n, line in lines if re.search(r"\b(\w+)->children\.\w+_back\(\1\)", line)]
        if not own:
            raise
        advice = "This line makes the parent its own child. Store the child there instead."
        raise Failure(replace(failure.feedback, where=(Location(HARDWARE, own[0]),), advice=advice)) from None


@pointers.check("tree", "each part has the right parent and children", needs="shared")
def tree(recording: Recording) -> None:
    with own_child_named(recording):
        expect_tree(recording)


def expect_tree(recording: Recording) -> None:
    expect_of_parts(
        recording,
        ("parents", ["body", "body", "axle"], "the parents of mast, axle, and wheel"),
        "In `mount`, store the parent in the child. To get a `shared_ptr` from a `weak_ptr`, call `.lock()`.",
    )
    expect_of_parts(
        recording,
        ("root", "nothing", "the parent of the body"),
        "Return an empty pointer for a part that was never mounted.",
    )
    expect_of_parts(
        recording,
        ("counts", [4, 1, 2, 1], "the numbers of parts from body, mast, axle, and wheel"),
        "In `mount`, store the child in the parent. In `parts_from`, count the part and all parts below it.",
    )


def expect_of_parts(recording: Recording, asked: tuple[str, object, str], advice: str) -> None:
    question, wanted, what = asked
    answer = native_answer(recording, question, what, "tree", where=Location(HARDWARE))
    if answer.error is None and answer.value == wanted:
        return
    raise wrong(
        recording,
        Feedback(
            summary=f"Your functions return the wrong values for {what}.",
            expected=numbers(wanted),
            seen=(answer.error or numbers(answer.value))[:120],
            where=(Location(HARDWARE),),
            advice=advice,
        ),
    )


@pointers.check("kept", "a part owns its children", needs="tree")
def kept(recording: Recording) -> None:
    answer = native_answer(recording, "kept", "parts_from(body)", "kept", where=Location(HARDWARE))
    if answer.value == 3:
        return
    raise Failure(
        Feedback(
            summary="Children are deleted even though their parent still needs them.",
            expected="3 parts",
            seen=f"{answer.value} part" if answer.value == 1 else str(answer.error or answer.value)[:120],
            where=members(recording, "children"),
            advice=(
                "A parent owns its children, so use `std::vector<std::shared_ptr<Part>>`. A weak_ptr "
                "does not own anything."
            ),
        )
    )


@pointers.check("gone", "a child does not own its parent", points=2, needs="tree")
def gone(recording: Recording) -> None:
    answer = native_answer(recording, "gone", "parent_of(child)", "gone", where=Location(HARDWARE))
    if answer.value == "nothing":
        return
    raise Failure(
        Feedback(
            summary="A parent that nobody needs is never deleted, because its child still owns it.",
            expected="an empty pointer",
            seen=str(answer.error or answer.value)[:120],
            where=members(recording, "parent"),
            advice=(
                "Make the parent a `std::weak_ptr<Part>`. Two objects that own each other are never deleted."
            ),
        )
    )


def members(recording: Recording, name: str) -> tuple[Location, ...]:
    lines = enumerate(recording.home.file(HEADER).lines, 1)
    found = [Location(HEADER, n) for n, line in lines if re.search(rf"\b{name}\w*\b[^(]*;", line)]
    return tuple(found[:1]) or (Location(HEADER),)


@pointers.check("leak_free", "the program deletes everything it created", points=3, needs="runs")
def leak_free(recording: Recording) -> None:
    where, shape = Location(f"{ROVER}/main.cpp"), tuple[int, list[tuple[Any, str | None]]]
    count, blocks = told_by(recording, "never freed", "./rover", "rover", where, shape)
    if not count:
        return
    made = dict.fromkeys(place for _, place in blocks if place)
    found = (re.fullmatch(r"(.+):(\d{1,6})", place) for place in made)
    places = [Location(place[1], int(place[2])) for place in found if place]
    part = any(place.file == HARDWARE for place in places)
    raise Failure(
        Feedback(
            summary=f"The program ends, but {plural(count)} that it made {'was' if count == 1 else 'were'} "
            "never deleted.",
            expected="none",
            seen=f"{plural(count)}, {sum(size for size, _ in blocks)} bytes",
            where=tuple(places[:3]),
            advice="Check where it was created. Do two parts own each other? Is there still a `new`?"
            if part
            else (
                "Check where it was created. A local variable does not need `new`. Put an object that "
                "lives longer in a smart pointer."
            ),
        )
    )


def plural(count: int) -> str:
    return "one object" if count == 1 else f"{count} objects"


# ----------------------------------------------------------------------------------------- 28-forwarding

forwarding = Grader("28-forwarding", builds=None, ros=False, sanitizers=True)

LOG_FOLDER = f"{CPP}/forwarding"
LOG = f"{LOG_FOLDER}/trip_log.hpp"


@forwarding.scenario
def count_entries(arena: Arena) -> None:
    program = arena.cpp.compile("trip_log", f"{LOG_FOLDER}/main.cpp")
    run = arena.cpp.run(program, name="trip_log")
    if run:
        run.wait(10)
    asked = arena.cpp.compile("counts", ours=PROBES / "ch28_entries.cpp")
    for question in ("values", "make", "append", "total", "forward"):
        arena.cpp.ask(asked, question, name=question, timeout=10)


@forwarding.check("compiles", "the program compiles and runs")
def entries_compile(recording: Recording) -> None:
    expect_compiled(recording, "trip_log")
    expect_sound(recording, "trip_log")
    lines = enumerate(recording.home.file(LOG).lines, 1)
    bound = [Location(LOG, n) for n, line in lines if re.search(r"\bTracedEntry\b", line.split("//")[0])]
    ended = recording.process("compile counts").exited
    if bound and ended and ended.code:
        raise Failure(
            Feedback(
                summary="`trip_log.hpp` works only for `TracedEntry`, but the check uses a different type.",
                expected="a template for any `Entry`",
                where=tuple(bound[:2]),
                advice="Keep the original `template` line, and write `Entry` instead of `TracedEntry`.",
            )
        )
    expect_compiled(recording, "counts")


@forwarding.check("warnings", "there are no compiler warnings", needs="compiles")
def entries_warnings(recording: Recording) -> None:
    expect_no_warnings(recording, "trip_log")


@forwarding.check("values", "the three functions do what the task asks", needs="compiles")
def values(recording: Recording) -> None:
    for question, wanted, what in (
        ("made value", 20.0, "make<Entry>(20.0)->value()"),
        ("appended values", [1.5, -4.0, 8.0], "append with 1.5, -4, and 8"),
        ("total value", 5.5, "total of 1.5, -4, and 8"),
    ):
        answer = native_answer(recording, question, what, "values", where=Location(LOG))
        if answer.error is None and answer.value == wanted:
            continue
        raise wrong(
            recording,
            Feedback(
                summary=f"`{what}` returns {numbers(answer.value)}."
                if answer.error is None
                else f"`{what}` fails: {answer.error[:60]}",
                expected=numbers(wanted),
                seen=(answer.error or numbers(answer.value))[:120],
                where=(Location(LOG),),
                advice="This is only the last value. Add each one to the sum with `+=`."
                if question == "total value" and answer.value == 8.0
                else "The caller's vector stays unchanged. Take it by reference, with `&`."
                if answer.value == []
                else "Remove the copies, but keep the same values.",
            ),
        )


@forwarding.check("make", "`make` creates one object and copies nothing", points=2, needs="values")
def make_counts(recording: Recording) -> None:
    expect_counts(
        recording,
        "make",
        made=1,
        summary="`make<Entry>(20.0)`",
        advice=(
            "Pass `std::make_shared<Entry>(...)` the values that an Entry is made from, here "
            "20.0, not a finished Entry."
        ),
    )


@forwarding.check("append", "`append` creates each object in place", points=2, needs="values")
def append_counts(recording: Recording) -> None:
    expect_counts(
        recording,
        "append",
        made=3,
        summary="`append`, called three times,",
        advice="Use `emplace_back` instead of `push_back`, and pass the value itself, not a finished Entry.",
    )


@forwarding.check("total", "`total` only reads, and copies nothing", points=2, needs="values")
def total_counts(recording: Recording) -> None:
    expect_counts(
        recording,
        "total",
        made=3,
        summary="`total` of three entries",
        advice=(
            "Use references, which don't copy: `const std::vector<Entry>& entries` for the argument, "
            "and `const auto&` in the loop."
        ),
    )


# How many entries were created, copied, and moved.
COUNTS = tuple[int, int, int]


def expect_counts(recording: Recording, question: str, *, made: int, summary: str, advice: str) -> None:
    count, copied, moved = told_by(recording, question, question, question, Location(LOG), COUNTS)
    if (count, copied, moved) == (made, 0, 0):
        return
    more = [f"creates {count - made} too many"] if count > made else []
    done = [
        *more,
        *([f"copies {times(copied)}"] if copied else []),
        *([f"moves {times(moved)}"] if moved else []),
    ]
    raise Failure(
        Feedback(
            summary=f"{summary} {' and '.join(done) or f'creates only {count}'}.",
            expected=f"{made} created, 0 copied, 0 moved",
            seen=f"{count} created, {copied} copied, {moved} moved",
            where=function_place(recording, question),
            advice=advice,
        )
    )


def times(count: int) -> str:
    return "once" if count == 1 else "twice" if count == 2 else f"{count} times"


def function_place(recording: Recording, name: str) -> tuple[Location, ...]:
    lines = enumerate(recording.home.file(LOG).lines, 1)
    found = [Location(LOG, n) for n, line in lines if re.search(rf"\b{name}\s*\(", line.split("//")[0])]
    return tuple(found[:1]) or (Location(LOG),)


@forwarding.check("forwards", "`make` forwards its arguments unchanged", points=2, needs="values")
def forwards(recording: Recording) -> None:
    what = "make<RangeEntry>(Reading(7.0))"
    _, copied, _ = told_by(recording, "temporary", what, "forward", Location(LOG), COUNTS)
    if copied:
        raise Failure(
            Feedback(
                summary="`make` copies a reading that nothing else needs.",
                expected="0 copies",
                seen=f"{copied} copies" if copied > 1 else "1 copy",
                where=function_place(recording, "make"),
                advice=(
                    "Take `Arguments&&... arguments`, and pass on `std::forward<Arguments>(arguments)...`."
                ),
            )
        )
    ours = native_answer(recording, "ours", "reading.value()", "forward").value
    if ours != 5.0:
        raise Failure(
            Feedback(
                summary="`make<RangeEntry>(reading)` takes the reading away from its caller, "
                "which still needs it.",
                expected="5, as before",
                seen=numbers(ours),
                where=function_place(recording, "make"),
                advice=(
                    "Replace `std::move`, which moves every argument, with "
                    "`std::forward<Arguments>(arguments)...`. It moves only what the caller moved."
                ),
            )
        )
