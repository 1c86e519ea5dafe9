"""How nodes in C++ end by an error, and what is said of it."""

from __future__ import annotations

import pytest

from course.evidence.events import ProcessExited
from course.evidence.sources import Sources
from course.feedback import Feedback
from course.grading.explain.cpp_crashes import cpp_crash

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
    ("kind", "what", "words"),
    [
        ("rclcpp::exceptions::RCLInvalidArgument", "guard condition: context argument is null", "argv"),
        ("rclcpp::exceptions::RCLError", "the given context is not valid, either rcl_init()", "argv"),
        ("rclcpp::ContextAlreadyInitialized", "context is already initialized", "once only"),
        ("std::bad_weak_ptr", "bad_weak_ptr", "`shared_from_this()` works only"),
        ("rclcpp::exceptions::InvalidTopicNameError", "Invalid topic name: 1", "no part of it"),
        ("std::runtime_error", "Node '/a' has already been added to an executor.", "in one place"),
        ("std::out_of_range", "vector::_M_range_check", "catch (const std::out_of_range& error)"),
    ],
)
def test_exceptions(kind: str, what: str, words: str) -> None:
    found = thrown(kind, what)
    assert kind in found.summary
    assert words in str(found.advice)


def test_the_name_that_ros_complains_of() -> None:
    found = thrown(
        "rclcpp::exceptions::InvalidNodeNameError",
        "Invalid node name: node name must not contain characters other than alphanumerics or '_':",
        "  'my-node'",
        "     ^",
        code='\n: rclcpp::Node("my-node")',
    )
    assert "letters, digits and `_`" in str(found.advice)
    assert [str(place) for place in found.where] == [f"{FILE}:2"]


@pytest.mark.parametrize(
    ("number", "lines", "words"),
    [
        (11, (), "follows a pointer that leads nowhere"),
        (6, ("what it wrote",), "ended itself"),
        (6, ("free(): invalid pointer",), "gives memory back"),
        (8, (), "by zero"),
    ],
)
def test_signals(number: int, lines: tuple[str, ...], words: str) -> None:
    found = told(*lines, number=number)
    assert found is not None
    assert words in found.summary
    assert found.details == lines


def test_a_number_logged_as_a_text() -> None:
    found = told(number=11, code='\nRCLCPP_INFO(get_logger(), "Printed %s times.", count_);')
    assert found is not None
    assert "%d" in str(found.advice)
    assert [str(place) for place in found.where] == [f"{FILE}:2"]
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
    found = cpp_crash(ended, [lost], Sources(lists), "The program stopped")
    assert found is not None
    assert "it does not find the library `libarm.so`" in found.summary
    assert "install(TARGETS arm" in str(found.advice)
    assert [str(place) for place in found.where] == ["src/talk/CMakeLists.txt:2"]
    foreign = cpp_crash(ended, [lost], Sources({}), "The program stopped")
    assert foreign is not None
    assert "LD_LIBRARY_PATH" in str(foreign.advice)
