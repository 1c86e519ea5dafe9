"""What a C++ program said when it ended."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.explain.cpp_crashes import NO_LINE, cpp_crash, crash_notes, own_place, trouble
from course.explain.engine import failed_with
from course.model.events import Observed, ProcessExited
from course.model.feedback import Feedback, Location
from course.model.result import CheckResult, Outcome
from tests.golden import golden

FILE = "src/talk/src/talker.cpp"


def told(*lines: str, number: int | None = 6, code: str = "") -> Feedback | None:
    ended = ProcessExited(1.0, "talker", None if number else 0, number)
    return cpp_crash(ended, lines, Sources({FILE: code}), "The program stopped")


def thrown(kind: str, what: str, *more: str, code: str = "") -> Feedback:
    found = told(
        f"terminate called after throwing an instance of '{kind}'", f"  what():  {what}", *more, code=code
    )
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("kind", "what"),
    [
        ("rclcpp::exceptions::RCLInvalidArgument", "guard condition: context argument is null"),
        ("rclcpp::exceptions::RCLError", "the given context is not valid, either rcl_init()"),
        ("rclcpp::ContextAlreadyInitialized", "context is already initialized"),
        ("std::bad_weak_ptr", "bad_weak_ptr"),
        ("rclcpp::exceptions::InvalidTopicNameError", "Invalid topic name: 1"),
        ("std::runtime_error", "Node '/a' has already been added to an executor."),
        ("std::out_of_range", "vector::_M_range_check"),
        ("std::out_of_range", "map::at"),
        ("std::out_of_range", "stoi"),
        ("std::out_of_range", "of my own"),
        ("std::invalid_argument", "stod"),
        ("std::invalid_argument", "stop it"),
        ("std::bad_function_call", "bad_function_call"),
        ("std::bad_optional_access", "bad optional access"),
        ("std::bad_variant_access", "std::get: wrong index for variant"),
    ],
)
def test_exceptions(kind: str, what: str) -> None:
    golden(thrown(kind, what))


def test_the_name_that_ros_complains_of() -> None:
    golden(
        thrown(
            "rclcpp::exceptions::InvalidNodeNameError",
            "Invalid node name: node name must not contain characters other than alphanumerics or '_':",
            "  'my-node'",
            "     ^",
            code='\n: rclcpp::Node("my-node")',
        )
    )


@pytest.mark.parametrize(
    ("number", "lines"), [(11, ()), (6, ("what it wrote",)), (6, ("free(): invalid pointer",)), (8, ())]
)
def test_signals(number: int, lines: tuple[str, ...]) -> None:
    golden(told(*lines, number=number))


def test_a_number_logged_as_a_text() -> None:
    golden(told(number=11, code='\nRCLCPP_INFO(get_logger(), "Printed %s times.", count_);'))
    right = told(number=11, code='\nRCLCPP_INFO(get_logger(), "%s", text.c_str());')
    assert right is not None
    assert right.where == ()


@pytest.mark.parametrize("number", [None, 2, 15])
def test_an_end_without_an_error(number: int | None) -> None:
    assert told("[INFO] [1.0] [talker]: hello", number=number) is None


def test_a_library_of_the_package_that_was_not_installed() -> None:
    lost = "talker: error while loading shared libraries: libarm.so: cannot open shared object file"
    lists = {"src/talk/CMakeLists.txt": "project(talk)\nadd_library(arm SHARED a.cpp)\n"}
    ended = ProcessExited(1.0, "talker", 127, None)
    golden(cpp_crash(ended, [lost], Sources(lists), "The program stopped"))
    golden(cpp_crash(ended, [lost], Sources({}), "The program stopped"))


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
    "kind",
    [
        "heap-buffer-overflow",
        "container-overflow",
        "stack-overflow",
        "heap-use-after-free",
        "stack-use-after-scope",
        "attempting double-free",
        "attempting free",
        "alloc-dealloc-mismatch",
        "SEGV",
        "something-new",
    ],
)
@pytest.mark.parametrize("place", ["~/cpp/arm.cpp:7:3", "cpp/arm.cpp:7", "./cpp/arm.cpp:7"])
def test_reports_of_the_address_sanitizer(kind: str, place: str) -> None:
    golden(trouble(REPORT.format(kind=kind, place=place).splitlines(), SOURCES))


def test_what_is_not_defined() -> None:
    lines = [
        "~/cpp/main.cpp:4:9: runtime error: signed integer overflow: 1 + 2 cannot be",
        "    #0 0x1 in main x:1",
    ]
    golden(trouble(lines, SOURCES))


def test_what_is_not_defined_in_a_header_of_the_system() -> None:
    lines = [
        "/usr/include/c++/12/bits/x.h:99:9: runtime error: member call on null pointer of type 'Arm'",
        "    #0 0x1 in std::f() /usr/include/c++/12/bits/x.h:99",
        "    #1 0x1 in main cpp/main.cpp:3",
    ]
    golden(trouble(lines, SOURCES))


@pytest.mark.parametrize(
    ("what", "said"), [("  what():  no such joint", "(no such joint)"), ("other", "`std::out_of_range`.")]
)
def test_an_exception_that_nothing_catches(what: str, said: str) -> None:
    found = trouble(["terminate called after throwing an instance of 'std::out_of_range'", what], SOURCES)
    assert found is not None and found.thrown == "std::out_of_range"
    assert said in found.summary and "catch (const std::out_of_range& error)" in found.advice


def test_a_library_that_is_not_found() -> None:
    line = "./it: error while loading shared libraries: libtinyqp.so: cannot open shared object file"
    golden(trouble([line], SOURCES))


def test_nothing_is_made_of_other_lines() -> None:
    assert trouble(["all is well", "ERROR: of the learner's own"], SOURCES) is None


def test_files_of_others_are_no_place() -> None:
    assert own_place("/usr/include/x.h", "3", SOURCES) is None


UNCAUGHT = "terminate called after throwing an instance of"
ABORTED = """\
==7==ERROR: AddressSanitizer: {kind} on unknown address 0x7b03 (pc 0x7f bp 0x7f sp 0x7f T0)
    #0 0x7ffa in __pthread_kill_implementation nptl/pthread_kill.c:44
    #1 0x563f in std::vector<int>::at(unsigned long) /usr/include/c++/12/bits/stl_vector.h:1175
    #2 0x563f in Talker::tick() {file}:2
    #3 0x563f in main {file}:3
"""


def after_a_second_run(
    number: int, *lines: str, kind: str = "ABRT", file: str = FILE, notes: bool = True
) -> Feedback | None:
    """Of a program with three lines."""
    ended = ProcessExited(1.0, "talker", None, number)
    found = crash_notes(ABORTED.format(kind=kind, file=file).splitlines()) if notes else ()
    return cpp_crash(ended, lines, Sources({FILE: "\n\n\n"}), "The program stopped", list(found))


@pytest.mark.parametrize(
    ("number", "lines", "kind"),
    [
        (11, (), "SEGV"),
        (8, (), "FPE"),
        (6, ("free(): invalid pointer",), "heap-use-after-free"),
        (
            6,
            ("terminate called after throwing an instance of 'std::invalid_argument'", "  what():  stoi"),
            "ABRT",
        ),
        (6, ("terminate called after throwing an instance of 'std::runtime_error'", "  what():  no"), "ABRT"),
    ],
)
def test_the_line_that_a_second_run_finds(number: int, lines: tuple[str, ...], kind: str) -> None:
    golden(after_a_second_run(number, *lines, kind=kind))


@pytest.mark.parametrize("file", ["/usr/include/x.hpp", "../../etc/passwd", "src/other/talker.cpp"])
def test_a_line_of_nobody_s(file: str) -> None:
    found = after_a_second_run(11, file=file)
    assert found is not None
    assert found.where == () and str(found.advice).startswith(NO_LINE)


def test_a_line_that_does_not_exist() -> None:
    note = Observed(0.0, "crashed", "SEGV", raised=Location(FILE, 4))
    ended = ProcessExited(1.0, "talker", None, 11)
    found = cpp_crash(ended, (), Sources({FILE: "\n\n\n"}), "It stopped", [note])
    assert found is not None and found.where == ()


def test_only_a_second_run_can_be_asked_for() -> None:
    asks, cannot = after_a_second_run(11, notes=False), told(number=11)
    assert asks and cannot and asks.advice == f"{NO_LINE} {cannot.advice}"
    checks = (CheckResult("starts", "It starts", 1, Outcome.FAILED, feedback=one) for one in (asks, cannot))
    assert [failed_with(check, NO_LINE) for check in checks] == [True, False]


def test_a_report_without_an_error_has_no_notes() -> None:
    assert list(crash_notes(ABORTED.format(kind="ABRT", file=FILE).splitlines()[1:])) == []


STREAMS = (
    "std::ostream & operator<<(std::ostream & stream, const Arm & arm)\n{{\n  return stream << {};\n}}\n"
)


@pytest.mark.parametrize(
    ("code", "line"),
    [
        (STREAMS.format("arm"), 3),
        (STREAMS.format('"arm " << arm << "."'), 3),
        (STREAMS.format("arm.size()"), None),
        ("int Arm::size() const { return size(); }", 1),
        ("int Arm::size() const { return parts_.size(); }", None),
        ("void set(int a) { set(a, 0); }\nvoid set(int a, int b) { b_ = a + b; }", None),
        ("int fall(int n)\n{\n  return fall(n - 1);\n}", 3),
        ("int fall(int n) { return n < 1 ? 0 : fall(n - 1); }", None),
        ("void spin(Node node) { rclcpp::spin(node); }", None),
    ],
)
def test_a_function_that_calls_itself_without_end(code: str, line: int | None) -> None:
    found = told(number=11, code=code)
    assert found is not None
    assert [place.line for place in found.where] == ([line] if line else [])
    assert ("calls itself" in str(found.advice)) is (line is not None)
