"""Grader of chapter 27: a library in C++ that a package of the grader's own uses, and a node that does."""

from __future__ import annotations

import re
from math import isclose
from pathlib import Path
from typing import Any

import pytest

from course.arena.arena import Arena
from course.arena.native_programs import compiling
from course.arena.native_projects import configuring
from course.errors import OurFault
from course.evidence.packages import BuiltPackage
from course.evidence.recording import Recording
from course.evidence.topic_view import LogLine, expect_period
from course.feedback import Failure, Feedback, Location
from course.grading.author import Grader
from course.grading.expect.logs import expect_logged
from course.grading.expect.manifests import expect_dependency
from course.grading.expect.native import native_answer
from course.grading.expect.programs import expect_clean_interrupt, expect_running
from course.grading.explain.consumers import not_compiled, not_configured, not_loaded
from course.grading.explain.cpp_code import cpp_files, places_of

PACKAGE = "cpp_package_with_a_library"
LIBRARY = f"lib{PACKAGE}.so"
NODE = "sample_class_local_node"
SOURCE = f"ros2_tutorial_workspace/src/{PACKAGE}"
HEADER = Location(f"{SOURCE}/include/{PACKAGE}/sample_class.hpp")
CODE = Location(f"{SOURCE}/src/sample_class.cpp")
LISTS = Location(f"{SOURCE}/CMakeLists.txt")
PROJECT = Path(__file__).with_name("probes") / "ch27_consumer"
CONSUMER, SOURCED = "consumer", "consumer after sourcing"
TEXT = "SampleClass(7)"
SUM_TEXT = "Sum of squares"
SUM = re.compile(SUM_TEXT + r": (-?\d+(?:\.\d*)?)")
ENOUGH = 5

cpp_library = Grader("27-cpp-library")


@cpp_library.scenario
def another_package_and_the_node(arena: Arena) -> None:
    """The node first, alone, so that no compiler disturbs its pace; then the grader's own package."""
    node = arena.run(PACKAGE, NODE)
    if node:
        arena.until(lambda: arena.graph.nodes, timeout=15, while_running=node)
        arena.until(lambda: arena.logged("") or arena.printed("Sample"), timeout=6, while_running=node)
        arena.until(
            lambda: min(arena.logged(TEXT), arena.logged(SUM_TEXT)) >= ENOUGH, timeout=6, while_running=node
        )
    arena.interrupt(node)
    arena.require_libraries("Eigen3", "Qt5Core")
    consumer = arena.build_project(CONSUMER, PROJECT)
    arena.ask_native(consumer, name=CONSUMER, timeout=10, env=arena.ros_libraries)
    arena.ask_sourced(consumer, PACKAGE, name=SOURCED)


def package(recording: Recording) -> BuiltPackage:
    built = recording.packages.get(PACKAGE)
    if built is None:
        raise OurFault(f"{PACKAGE} was not built")
    return built


@cpp_library.check("found", "another package finds it")
def found(recording: Recording) -> None:
    view = recording.process(configuring(CONSUMER))
    if view.started is None:
        raise OurFault("the scenario did not configure the consumer")
    if view.exited is None or view.exited.code != 0:
        raise Failure(not_configured(view.text, package(recording), recording.sources))


@cpp_library.check("compiles", "another package can be built with it", points=2, needs="found")
def compiles(recording: Recording) -> None:
    view = recording.process(compiling(CONSUMER))
    if view.exited is None or view.exited.code != 0:
        raise Failure(not_compiled(view.text, package(recording), recording.sources))


def answer(recording: Recording, question: str, what: str) -> Any:
    """What the class answered in the grader's own program; it may not throw."""
    seen = native_answer(recording, question, what, CONSUMER, where=CODE)
    if seen.error is None:
        return seen.value
    raise Failure(
        Feedback(
            summary=f"`{what}` throws: {seen.error[:80]}",
            where=(CODE,),
            advice="None of the functions of the class has a reason to throw. Look at what it calls.",
        )
    )


def defined(recording: Recording, name: str) -> tuple[Location, ...]:
    """Where a function of the class is defined."""
    found = places_of(recording.sources, rf"\b{name}\s*\([^;{{}}()]*\)[^;{{}}()]*\{{")
    return (*found, CODE)[:1]


@cpp_library.check("shared", "the library is shared, and has the package's name", needs="compiles")
def shared(recording: Recording) -> None:
    loaded = [Path(name).name for name in answer(recording, "loaded", "SampleClass")]
    if any(name.startswith(LIBRARY) for name in loaded):
        return
    prefix = package(recording).prefix
    own = [Path(name).name for name in answer(recording, "loaded", "SampleClass") if name.startswith(prefix)]
    raise Failure(
        Feedback(
            summary=f"A program that uses the library does not load `{LIBRARY}`.",
            expected=LIBRARY,
            seen=", ".join(own) or "no shared library of this package",
            where=(*places_of_library(recording), LISTS)[:1],
            advice="Without `SHARED` in `add_library` it becomes a part of each program that links it.",
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
    loaded = [Path(name).name for name in answer(recording, "loaded", "SampleClass")]
    if not any(name.startswith("libQt5Core") for name in loaded):
        raise Failure(
            Feedback(
                summary="The library does not use Qt 5 Core.",
                expected="`to_string` made with `QString`",
                where=(CODE,),
                advice="`#include <QString>`; in CMakeLists.txt, find `Qt5Core` and link `Qt5::Core`.",
            )
        )
    texts = cpp_files(recording.sources).values()
    if not any(re.search(r"^\s*#\s*include\s*[<\"](?:eigen3/)?Eigen/", text, re.MULTILINE) for text in texts):
        raise Failure(
            Feedback(
                summary="The library does not use Eigen 3.",
                expected="`sum_of_squares` adds up a vector of Eigen",
                where=defined(recording, "sum_of_squares"),
                advice="`#include <Eigen/Core>`, and add up an `Eigen::Vector3d` with its function `sum()`.",
            )
        )


@cpp_library.check("member", "the private member is 0 at first, and can be set", needs="compiles")
def member(recording: Recording) -> None:
    first = answer(recording, "at first", "SampleClass().get_a_private_member()")
    if first != 0:
        raise Failure(
            Feedback(
                summary="The private member of a new object is not 0.",
                expected="0",
                seen=str(first),
                where=(HEADER,),
                advice="Give it its value in the class: `int a_private_member_ = 0;`.",
            )
        )
    seen = answer(recording, "members", "set_a_private_member(-3)")
    if seen != [-3, 41]:
        raise Failure(
            Feedback(
                summary="`get_a_private_member` does not return what `set_a_private_member` was given.",
                expected="-3 and 41",
                seen=" and ".join(map(str, seen)),
                where=defined(recording, "set_a_private_member"),
                advice="The one writes the member, the other returns it. Is it the same one, of this object?",
            )
        )


@cpp_library.check("to_string", "`to_string` shows the private member", needs="compiles")
def to_string(recording: Recording) -> None:
    seen = answer(recording, "texts", "to_string()")
    if seen != ["SampleClass(-3)", "SampleClass(41)"]:
        raise Failure(
            Feedback(
                summary=f"`to_string` returns `{seen[0][:40]}`, not `SampleClass(-3)`.",
                expected="SampleClass(-3) and SampleClass(41)",
                seen=" and ".join(text[:60] for text in seen),
                where=defined(recording, "to_string"),
                advice='`QString("SampleClass(%1)").arg(number).toStdString()` puts the number in place.',
            )
        )


@cpp_library.check("streams", "`<<` writes the same", needs="to_string")
def streams(recording: Recording) -> None:
    seen = answer(recording, "streamed", "stream << sample")
    if seen != ["SampleClass(-3)|", "SampleClass(41)|"]:
        raise Failure(
            Feedback(
                summary=f"`stream << sample << '|'` writes `{seen[0][:40]}`, not `SampleClass(-3)|`.",
                expected="SampleClass(-3)|",
                seen=seen[0][:120],
                where=defined(recording, r"operator\s*<<"),
                advice="Write to the stream that it is given: `return stream << sample.to_string();`.",
            )
        )


@cpp_library.check("sum", "`sum_of_squares` follows the formula", points=2, needs="compiles")
def sum_of_squares(recording: Recording) -> None:
    wanted = {"2, 3": 25.0, "0.5, -1.25": 0.5625, "-4, 1": 9.0}
    seen = answer(recording, "sums", "SampleClass::sum_of_squares(2, 3)")
    for (arguments, value), given in zip(wanted.items(), seen, strict=True):
        if not isclose(given, value, abs_tol=1e-9):
            raise Failure(
                Feedback(
                    summary=f"`sum_of_squares({arguments})` is {given:g}, not {value:g}.",
                    expected=f"{value:g}",
                    seen=f"{given:g}",
                    where=defined(recording, "sum_of_squares"),
                    advice="It is `a*a + 2*a*b + b*b`, in `double` throughout.",
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
    expect_logged(recording, NODE, lines, "Sum of squares: 25", "Sum of")
    values = [float(found[1]) for found in (SUM.search(line.text) for line in lines) if found]
    if any(not isclose(value, 25.0, abs_tol=1e-3) for value in values):
        raise Failure(
            Feedback(
                summary=f"The node logs `{lines[0].text[:60]}`, not `Sum of squares: 25`.",
                expected="Sum of squares: 25",
                seen=lines[0].text[:120],
                where=places_of(recording.sources, r"\bsum_of_squares\s*\(")[-1:],
                advice="Log what `SampleClass::sum_of_squares(2.0, 3.0)` of your library returns.",
            )
        )


@cpp_library.check("logs_text", "it logs the object at level INFO", needs="starts")
def logs_text(recording: Recording) -> None:
    lines = holding(recording, re.compile(re.escape(TEXT)))
    others = holding(recording, re.compile(r"SampleClass\("))
    if others and not lines:
        raise Failure(
            Feedback(
                summary=f"The node logs `{others[0].text[:60]}`, not `{TEXT}`.",
                expected=TEXT,
                seen=others[0].text[:120],
                where=places_of(recording.sources, r"\bset_a_private_member\s*\(")[-1:],
                advice="Set the object's private member to 7 where the node is made.",
            )
        )
    expect_logged(recording, NODE, lines, TEXT, "SampleClass")


@cpp_library.check("rate", "it logs both twice per second", needs=("logs_sum", "logs_text"))
def rate(recording: Recording) -> None:
    for pattern, what in ((SUM, "sums"), (re.compile(re.escape(TEXT)), "lines with the object")):
        times = tuple(line.t for line in holding(recording, pattern))
        if len(times) < 2:
            pytest.skip("there are too few messages to tell")
        expect_period(times, 0.5, what=what, advice="Half a second is `500ms`, or `0.5s`.")


@cpp_library.check("interrupt", "Ctrl+C ends the node in silence", needs="starts")
def interrupt(recording: Recording) -> None:
    expect_clean_interrupt(recording, NODE)


@cpp_library.check("declares_rclcpp", "package.xml declares rclcpp")
def declares_rclcpp(recording: Recording) -> None:
    expect_dependency(recording, PACKAGE, "rclcpp")
