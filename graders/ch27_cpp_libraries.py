"""Grader of chapter 27: a C++ library, used by a package of the grader and by the learner's node.

The words around the values are the learner's choice: `to_string` and the log only have to contain the values.
"""

from __future__ import annotations

import re
from math import isclose
from pathlib import Path
from typing import Any

import pytest

from course.api import (
    Arena,
    BuiltPackage,
    Failure,
    Feedback,
    Grader,
    Location,
    LogLine,
    OurFault,
    Process,
    Recording,
    cpp_files,
    expect_clean_interrupt,
    expect_dependency,
    expect_logged,
    expect_period,
    expect_running,
    native_answer,
    places_of,
)
from lib.consumers import not_compiled, not_configured, not_loaded
from lib.native_answers import wrong

PACKAGE = "cpp_package_with_a_library"
LIBRARY = f"lib{PACKAGE}.so"
NODE = "sample_class_local_node"
SOURCE = f"ros2_tutorial_workspace/src/{PACKAGE}"
CODE = Location(f"{SOURCE}/src/sample_class.cpp")
LISTS = Location(f"{SOURCE}/CMakeLists.txt")
PROJECT = Path(__file__).with_name("probes") / "ch27_consumer"
CONSUMER, SOURCED = "consumer", "consumer after sourcing"
VALUES = (-3, 41)  # private members of the objects whose text the consumer asks for
SUM = re.compile(r"(?i)sum\D*\d")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")
ENOUGH = 5

cpp_library = Grader("27-cpp-library")


@cpp_library.scenario
def another_package_and_the_node(arena: Arena) -> None:
    """Run the node first, because a compiler could disturb its timing; then the grader's own package."""
    node = arena.run(PACKAGE, NODE)
    if node:
        arena.until(lambda: arena.ros.graph.nodes, timeout=15, while_running=node)
        # Only its sums count; the log may come later than the terminal's lines.
        arena.until(lambda: sums_shown(arena, node), timeout=6, while_running=node)
        arena.until(lambda: sums_shown(arena, node) > ENOUGH, timeout=6, while_running=node)
    arena.interrupt(node)
    arena.cpp.require_libraries("Eigen3", "Qt5Core")
    consumer = arena.cpp.build_project(CONSUMER, PROJECT)
    arena.cpp.ask(consumer, name=CONSUMER, timeout=10, env=arena.cpp.ros_libraries)
    arena.cpp.ask_sourced(consumer, PACKAGE, name=SOURCED)


def sums_shown(arena: Arena, node: Process) -> int:
    return sum(bool(SUM.search(line)) for line in arena.lines(node))


def package(recording: Recording) -> BuiltPackage:
    built = recording.packages.get(PACKAGE)
    if built is None:
        raise OurFault(f"{PACKAGE} was not built")
    return built


@cpp_library.check("found", "another package finds it")
def found(recording: Recording) -> None:
    view = recording.process(f"configure {CONSUMER}")
    if view.started is None:
        raise OurFault("the scenario did not configure the consumer")
    if view.exited is None or view.exited.code != 0:
        raise Failure(not_configured(view.text, package(recording), recording.sources))


@cpp_library.check("compiles", "another package builds with it", points=2, needs="found")
def compiles(recording: Recording) -> None:
    view = recording.process(f"compile {CONSUMER}")
    if view.exited is None or view.exited.code != 0:
        raise Failure(not_compiled(view.text, package(recording), recording.sources))


def answer(recording: Recording, question: str, what: str, shape: Any) -> Any:
    """The class's answer in the grader's own program; it must not throw."""
    seen = native_answer(recording, question, what, CONSUMER, where=CODE, shape=shape)
    if seen.error is None:
        return seen.value
    raise Failure(
        Feedback(
            summary=f"`{what}` throws: {seen.error[:80]}",
            where=(CODE,),
            advice="None of these functions should throw. Check the functions that it calls.",
        )
    )


def defined(recording: Recording, name: str) -> tuple[Location, ...]:
    """Where a function of the class is defined."""
    found = places_of(recording.sources, rf"\b{name}\s*\([^;{{}}()]*\)[^;{{}}()]*\{{")
    return (*found, CODE)[:1]


@cpp_library.check("shared", "the library is shared and has the package's name", needs="compiles")
def shared(recording: Recording) -> None:
    loaded = [Path(name).name for name in answer(recording, "loaded", "SampleClass", list[str])]
    if any(name.startswith(LIBRARY) for name in loaded):
        return
    prefix = package(recording).prefix
    own = [
        Path(name).name
        for name in answer(recording, "loaded", "SampleClass", list[str])
        if name.startswith(prefix)
    ]
    raise Failure(
        Feedback(
            summary=f"A program that uses your library does not load `{LIBRARY}`.",
            expected=LIBRARY,
            seen=", ".join(own) or "no shared library of this package",
            where=(*places_of_library(recording), LISTS)[:1],
            advice="Add `SHARED` to `add_library`. Otherwise, each program gets a copy of the library.",
        )
    )


def places_of_library(recording: Recording) -> tuple[Location, ...]:
    lines = recording.sources.files.get(LISTS.file, "").splitlines()
    return tuple(Location(LISTS.file, n) for n, line in enumerate(lines, 1) if "add_library" in line)


@cpp_library.check("at_start", "programs find it when they start", needs="shared")
def at_start(recording: Recording) -> None:
    if recording.probe(SOURCED).answer("at first") is None:
        raise Failure(not_loaded(LIBRARY, package(recording), recording.sources))


@cpp_library.check("inside", "it uses Eigen 3 and Qt 5 Core inside", needs="shared")
def inside(recording: Recording) -> None:
    loaded = [Path(name).name for name in answer(recording, "loaded", "SampleClass", list[str])]
    if not any(name.startswith("libQt5Core") for name in loaded):
        raise Failure(
            Feedback(
                summary="The library does not use Qt 5 Core.",
                expected="a `QString` in the class",
                where=(CODE,),
                advice="Include `<QString>`. In CMakeLists.txt, find `Qt5Core` and link `Qt5::Core`.",
            )
        )
    texts = cpp_files(recording.sources).values()
    if not any(re.search(r"^\s*#\s*include\s*[<\"](?:eigen3/)?Eigen/", text, re.MULTILINE) for text in texts):
        raise Failure(
            Feedback(
                summary="The library does not use Eigen 3.",
                expected="an Eigen vector or matrix in the class",
                where=defined(recording, "sum_of_squares"),
                advice="Include `<Eigen/Core>`, and add three numbers with `Eigen::Vector3d::sum()`.",
            )
        )


@cpp_library.check("member", "the private member can be set and read", needs="compiles")
def member(recording: Recording) -> None:
    seen = answer(recording, "members", "get_a_private_member()", list[int])
    if seen != list(VALUES):
        raise wrong(
            recording,
            Feedback(
                summary="`get_a_private_member` does not return the value passed to `set_a_private_member`.",
                expected="-3 and 41",
                seen=" and ".join(map(str, seen)),
                where=defined(recording, "set_a_private_member"),
                advice="Check that one function sets the member and that the other returns the same member.",
            ),
        )


def texts_of(recording: Recording) -> list[str]:
    """What `to_string` returns for each of VALUES."""
    return list(answer(recording, "texts", "to_string()", tuple[str, str]))


@cpp_library.check("to_string", "the text of `to_string` contains the private member", needs="compiles")
def to_string(recording: Recording) -> None:
    for value, text in zip(VALUES, texts_of(recording), strict=True):
        if str(value) not in NUMBER.findall(text):
            raise Failure(
                Feedback(
                    summary=f"`to_string` returns `{shown(text)}` when the private member is {value}.",
                    expected=f"a text with the number {value}, such as `SampleClass({value})`",
                    seen=text[:200],
                    where=defined(recording, "to_string"),
                    advice='For example: `QString("SampleClass(%1)").arg(a_private_member_).toStdString()`.',
                )
            )


def shown(text: str) -> str:
    return " ".join(text.split())[:40]


@cpp_library.check("streams", "`<<` writes the same text", needs="to_string")
def streams(recording: Recording) -> None:
    wanted = [f"{text}|" for text in texts_of(recording)]
    seen = answer(recording, "streamed", "stream << sample", tuple[str, str])
    if seen != wanted:
        raise Failure(
            Feedback(
                summary=f"`stream << sample << '|'` writes `{shown(seen[0])}`, not the text of `to_string`.",
                expected=wanted[0][:120],
                seen=seen[0][:120] or "nothing",
                where=defined(recording, r"operator\s*<<"),
                advice="Write to the function's own argument: `return stream << sample.to_string();`.",
            )
        )


@cpp_library.check("sum", "`sum_of_squares` uses the formula", points=2, needs="compiles")
def sum_of_squares(recording: Recording) -> None:
    wanted = {"2, 3": 25.0, "0.5, -1.25": 0.5625, "-4, 1": 9.0}
    seen = answer(recording, "sums", "SampleClass::sum_of_squares(2, 3)", tuple[float, float, float])
    for (arguments, value), given in zip(wanted.items(), seen, strict=True):
        if not isclose(given, value, abs_tol=1e-9):
            raise Failure(
                Feedback(
                    summary=f"`sum_of_squares({arguments})` is {given:g}, not {value:g}.",
                    expected=f"{value:g}",
                    seen=f"{given:g}",
                    where=defined(recording, "sum_of_squares"),
                    advice="Compute `a*a + 2*a*b + b*b`, with all values of type `double`.",
                )
            )


@cpp_library.check("starts", "the node starts and keeps running")
def starts(recording: Recording) -> None:
    expect_running(recording, NODE)


def holding(recording: Recording, pattern: re.Pattern[str]) -> tuple[LogLine, ...]:
    return tuple(line for line in recording.log if pattern.search(line.text))


@cpp_library.check("logs_sum", "it logs the sum at level INFO", needs="starts")
def logs_sum(recording: Recording) -> None:
    lines = holding(recording, SUM)
    expect_logged(recording, NODE, lines, "Sum of squares: 25", "25")
    numbers = [float(number) for line in lines for number in NUMBER.findall(line.text)]
    if not any(isclose(number, 25.0, abs_tol=1e-3) for number in numbers):
        raise Failure(
            Feedback(
                summary=f"The node logs `{shown(lines[0].text)}`, but the sum is 25.",
                expected="Sum of squares: 25",
                seen=lines[0].text[:120],
                where=places_of(recording.sources, r"\bsum_of_squares\s*\(")[-1:],
                advice="Log the result of `SampleClass::sum_of_squares(2.0, 3.0)` from your library.",
            )
        )


def with_the_object(recording: Recording) -> tuple[LogLine, ...]:
    """The messages that contain the text of an object with any private member."""
    text = re.escape(texts_of(recording)[0])
    found = holding(recording, re.compile(text.replace(re.escape(str(VALUES[0])), r"-?\d+")))
    # If the text is only a number, the line with the sum contains it, too.
    return tuple(line for line in found if not SUM.search(line.text)) or found


@cpp_library.check("logs_text", "it logs the object at level INFO", needs=("starts", "to_string"))
def logs_text(recording: Recording) -> None:
    lines = with_the_object(recording)
    example = texts_of(recording)[0].replace(str(VALUES[0]), "7")
    if recording.log and not lines:
        streams(recording)  # a node that logs the object with `<<` logs what `<<` writes
        raise Failure(
            Feedback(
                summary="The node never logs the text of its object.",
                expected=example[:120],
                seen="; ".join(shown(line.text) for line in recording.log[:3]),
                where=places_of(recording.sources, r"\bRCLCPP_INFO")[-1:],
                advice="Log the result of the object's `to_string()`, or write the object after a `<<`.",
            )
        )
    expect_logged(recording, NODE, lines, example, example)


@cpp_library.check("rate", "it logs both twice per second", needs=("logs_sum", "logs_text"))
def rate(recording: Recording) -> None:
    both = ((holding(recording, SUM), "sums"), (with_the_object(recording), "lines with the object"))
    for lines, what in both:
        times = tuple(line.t for line in lines)
        if len(times) < 2:
            pytest.skip("there are too few messages to tell")
        expect_period(times, 0.5, what=what, program=recording)


@cpp_library.check("interrupt", "Ctrl+C ends the node cleanly", needs="starts")
def interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, NODE)


@cpp_library.check("declares_rclcpp", "package.xml declares rclcpp")
def declares_rclcpp(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclcpp")
