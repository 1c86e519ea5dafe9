"""Faults of CMakeLists.txt, as CMake words them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.build.digest import Case, explain
from tests.build.conftest import SRC
from tests.build.digest.logs import check, refused
from tests.build.packages import edit

CALL_STACK = "Call Stack (most recent call first):\n"

# the log; the kind, the place, words of the summary, words of the advice, words of the details
CMAKE: list[tuple[str, str, str, str, str, str]] = [
    ("CMake Error at /ros/a.cmake:53 (message):\n"
     "  ament_package_xml() package name 'small_interfaces' in\n"
     "  '/package.xml' does not match current PROJECT_NAME 'other'.  You must call\n"
     f"{CALL_STACK}  CMakeLists.txt:8 (rosidl_generate_interfaces)\n",
     "names-differ", "CMakeLists.txt:2", "calls the project `other`", "`project(small_interfaces)`", ""),
    (refused("InvalidResourceName: 'Project' is an invalid package\nname.  It should have"),
     "names-differ", "CMakeLists.txt:1", "does not call `project(small_interfaces)`", "below", ""),
    ("CMake Error at CMakeLists.txt:8 (rosidl_generate_interfaces):\n"
     '  Unknown CMake command "rosidl_generate_interfaces".\n\n',
     "cmake-command", "CMakeLists.txt:8", "the package that brings it", "rosidl_default_generators", ""),
    ('CMake Error at /ros/x.cmake:30 (if):\n  if given arguments:\n\n    "NOT"\n\n'
     f"{CALL_STACK}  CMakeLists.txt:4 (find_package)\n\n\n"
     "CMake Error in CMakeLists.txt:\n  No cmake_minimum_required command is present.  A line of\n",
     "cmake-minimum", "CMakeLists.txt:1", "does not begin with `cmake_minimum_required`", "first line", ""),
    ('CMake Error at CMakeLists.txt:15:\n  Parse error.  Function missing ending ")".  Instead found\n'
     '  unterminated string with text "msg/Landmark.msg\n',
     "cmake-syntax", "CMakeLists.txt:15", "A closing quote is missing", "line 15", ""),
    ("CMake Error at CMakeLists.txt:8 (rosidl_generate_interfaces):\n"
     '  The target name "$PROJECT_NAME" is reserved\n',
     "cmake-variable", "CMakeLists.txt:8", "PROJECT_NAME without braces", "`${PROJECT_NAME}`", ""),
    ("CMake Error at CMakeLists.txt:14 (add_executable):\n"
     "  Cannot find source file:\n\n    msg/Landmarc.msg\n\n  Tried\n",
     "source-missing", "CMakeLists.txt:14", "the source file msg/Landmarc.msg", "`msg/Landmark.msg`", ""),
    ("CMake Error at cmake_install.cmake:362 (file):\n  file INSTALL cannot find\n"
     f'  "{SRC}/small_interfaces/launch": No\n',
     "install-missing", "CMakeLists.txt", "installs launch, but it does not exist", "`install(...)`", ""),
    ('CMake Error: The source directory "x" does not appear to contain CMakeLists.txt.\n',
     "cmake-missing", "CMakeLists.txt", "has no CMakeLists.txt", "ament_cmake", ""),
    ("CMake Error at CMakeLists.txt:3 (strange):\n  Something quite new.  It goes on for long.\n",
     "cmake", "CMakeLists.txt:3", "configure `small_interfaces`: Something quite new.", "None", "It goes"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("log", "kind", "place", "summary", "advice", "detail"),
    CMAKE,
    ids=[f"{row[1]}-{row[3]}" for row in CMAKE],
)
def test_faults_of_cmake_lists(
    case: Callable[..., Case], log: str, kind: str, place: str, summary: str, advice: str, detail: str
) -> None:
    failure = explain(case("small_interfaces", log))
    check(failure, kind, f"{SRC}/small_interfaces/{place}", summary, advice)
    assert detail in "\n".join(failure.feedback.details)


def test_a_python_package_that_says_cmake(case: Callable[..., Case], src: Path) -> None:
    edit(src / "small_node/package.xml", "ament_python", "ament_cmake")
    log = 'CMake Error: The source directory "x" does not appear to contain CMakeLists.txt.\n'
    place = f"{SRC}/small_node/package.xml:11"
    check(explain(case("small_node", log)), "build-type", place, "says ament_cmake", "ament_python")
