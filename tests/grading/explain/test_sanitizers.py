"""How a compiled program failed, out of what it printed at its end."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.grading.explain.sanitizers import own_place, trouble

SOURCES = Sources({"cpp/main.cpp": "", "cpp/arm.cpp": ""})
REPORT = """\
fine until here
=================================================================
==7==ERROR: AddressSanitizer: {kind} on address 0x6020000000b8 at pc 0x55 bp 0x7f sp 0x7f
READ of size 8 at 0x6020000000b8 thread T0
    #0 0x55d0 in std::vector<double>::operator[](unsigned long) /usr/include/c++/12/bits/stl_vector.h:1124
    #1 0x55d1 in position_of(std::vector<double> const&, unsigned long) {place}
    #2 0x55d2 in main ~/cpp/main.cpp:9
"""


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        ("heap-buffer-overflow", "outside of an array"),
        ("container-overflow", "outside of an array"),
        ("stack-overflow", "calls itself"),
        ("heap-use-after-free", "deleted already"),
        ("stack-use-after-scope", "does not exist any more"),
        ("attempting double-free", "deleted twice"),
        ("attempting free", "`new` has not made"),
        ("alloc-dealloc-mismatch", "in another way"),
        ("SEGV", "leads nowhere"),
        ("something-new", "must not do"),
    ],
)
@pytest.mark.parametrize("place", ["~/cpp/arm.cpp:7:3", "cpp/arm.cpp:7", "./cpp/arm.cpp:7"])
def test_reports_of_the_address_sanitizer(kind: str, words: str, place: str) -> None:
    found = trouble(REPORT.format(kind=kind, place=place).splitlines(), SOURCES)
    assert found is not None and words in found.summary
    assert str(found.where) == "cpp/arm.cpp:7"
    assert len(found.details) == 3 and found.details[0].startswith("AddressSanitizer:")


def test_what_is_not_defined() -> None:
    lines = [
        "~/cpp/main.cpp:4:9: runtime error: signed integer overflow: 1 + 2 cannot be",
        "    #0 0x1 in main x:1",
    ]
    found = trouble(lines, SOURCES)
    assert found is not None and "signed integer overflow" in found.summary
    assert str(found.where) == "cpp/main.cpp:4"


def test_what_is_not_defined_in_a_header_of_the_system() -> None:
    lines = [
        "/usr/include/c++/12/bits/x.h:99:9: runtime error: member call on null pointer of type 'Arm'",
        "    #0 0x1 in std::f() /usr/include/c++/12/bits/x.h:99",
        "    #1 0x1 in main cpp/main.cpp:3",
    ]
    found = trouble(lines, SOURCES)
    assert found is not None and str(found.where) == "cpp/main.cpp:3" and "nullptr" in found.advice


@pytest.mark.parametrize(
    ("what", "said"), [("  what():  no such joint", "(no such joint)"), ("other", "program:")]
)
def test_an_exception_that_nothing_catches(what: str, said: str) -> None:
    found = trouble(["terminate called after throwing an instance of 'std::out_of_range'", what], SOURCES)
    assert found is not None and found.thrown == "std::out_of_range"
    assert said in found.summary and "catch (const std::out_of_range& error)" in found.advice


def test_a_library_that_is_not_found() -> None:
    line = "./it: error while loading shared libraries: libtinyqp.so: cannot open shared object file"
    found = trouble([line], SOURCES)
    assert found is not None and "`libtinyqp.so`" in found.summary and "LD_LIBRARY_PATH" in found.advice


def test_nothing_is_made_of_other_lines() -> None:
    assert trouble(["all is well", "ERROR: of the learner's own"], SOURCES) is None


def test_files_of_others_are_no_place() -> None:
    assert own_place("/usr/include/x.h", "3", SOURCES) is None
