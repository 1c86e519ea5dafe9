"""Expectations of compiled C++: no warnings, a clean end, and answers."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest

from course.errors import OurFault
from course.evidence.home_files import HomeEntry
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.grading.expect.native import expect_compiled, expect_no_warnings, expect_sound, native_answer
from course.model.events import (
    Event,
    OutputLine,
    Probed,
    ProcessExited,
    ProcessStarted,
    ProgramMissing,
    SignalSent,
)
from course.model.feedback import Location
from tests.golden import golden

from .conftest import said, told

FILE = "cpp/main.cpp"
PLACE = Location(FILE, 4)
SOURCES = Sources({FILE: "int main() {}\n"})


def ran(
    name: str, *lines: str, code: int | None = 0, signal: int | None = None, killed: bool = False
) -> Recording:
    """A program that printed these lines and ended so."""

    def events() -> Iterator[Event]:
        yield ProcessStarted(0.1, name, (name,))
        yield from (OutputLine(0.2, name, line) for line in lines)
        if killed:
            yield SignalSent(0.3, name, 9)
        yield ProcessExited(0.4, name, code, signal)

    return Recording("x", tuple(events()), sources=SOURCES)


def compiled(*lines: str, code: int | None = 1, signal: int | None = None) -> Recording:
    return ran("compile it", *lines, code=code, signal=signal)


def test_what_compiles_in_silence() -> None:
    recording = compiled(code=0)
    assert said(expect_compiled, recording, "it") is None
    assert said(expect_no_warnings, recording, "it") is None


def test_the_first_error_has_its_place() -> None:
    lines = (f"{FILE}:4:9: error: expected ';' before 'return'", f"{FILE}:5:9: error: something else")
    golden(told(expect_compiled, compiled(*lines), "it"))


@pytest.mark.parametrize(
    "line",
    [
        f"/usr/bin/ld: ~/{FILE}:4: undefined reference to `f(int)'",
        f"/usr/bin/ld: ~/{FILE}:4: undefined reference to `vtable for Arm'",
        "(.text+0x17): undefined reference to `main'",
        "ld: cannot find -ltinyqp: No such file",
        "b.cpp:7: multiple definition of `f()'; /tmp/a.o:a.cpp:7: first defined here",
        "the moon is full",
    ],
)
def test_linkers_are_understood(line: str) -> None:
    golden(told(expect_compiled, compiled(line), "it"))


def test_a_compiler_that_never_ends() -> None:
    assert "never finishes" in told(expect_compiled, compiled(code=None, signal=9), "it").summary


def test_a_file_that_is_missing_is_named() -> None:
    home = (HomeEntry("cpp", "folder"), HomeEntry("cpp/mian.cpp", "file"))
    lost = ProgramMissing(0.1, "compile it", FILE)
    golden(told(expect_compiled, Recording("x", (lost,), looked_at=home), "it"))


def test_a_warning_is_quoted() -> None:
    lines = (
        f"{FILE}:4:9: warning: unused variable 'x' [-Wunused-variable]",
        "/usr/include/a.h:1:1: warning: y",
    )
    golden(told(expect_no_warnings, compiled(*lines, code=0), "it"))


def test_what_was_never_tried_is_our_fault() -> None:
    for expect in (expect_compiled, expect_sound):
        with pytest.raises(OurFault):
            expect(Recording("x"), "it")


def test_a_sound_end() -> None:
    assert expect_sound(ran("it", "hello"), "it").text == ("hello",)


@pytest.mark.parametrize(
    "recording",
    [
        ran("it", "==1==ERROR: AddressSanitizer: heap-use-after-free on", code=1),
        ran("it", code=4),
        ran("it", code=None, signal=11),
        ran("it", code=None, signal=9, killed=True),
    ],
)
def test_other_ends(recording: Recording) -> None:
    golden(told(expect_sound, recording, "it"))


def asked(recording: Recording, **answer: object) -> Recording:
    lines = (json.dumps(answer),) if answer else ()
    events = (*recording.events, Probed(0.5, "it", lines, True))
    return Recording("x", events, sources=SOURCES)


def test_answers_and_exceptions_come_back() -> None:
    answer = native_answer(
        asked(ran("it"), question="half", value=1.5, type="double"), "half", "half(3)", "it"
    )
    assert answer.value == 1.5
    thrown = asked(ran("it"), question="half", error="std::out_of_range: no", type="std::out_of_range")
    assert native_answer(thrown, "half", "half(0)", "it").type == "std::out_of_range"


@pytest.mark.parametrize(
    "recording",
    [
        ran("it", "==1==ERROR: AddressSanitizer: SEGV on", code=1),
        ran("it", code=None, signal=9, killed=True),
        ran("it", code=None, signal=11),
        ran("it", code=0),
    ],
)
def test_questions_that_were_never_answered(recording: Recording) -> None:
    golden(told(native_answer, asked(recording), "half", "half(3)", "it", where=PLACE))
