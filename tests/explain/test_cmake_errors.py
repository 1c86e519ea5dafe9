"""Errors in CMakeLists.txt, in CMake's words."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.explain.build_errors import explain_build
from course.explain.builds import Build
from tests.build.conftest import SRC
from tests.build.packages import edit
from tests.golden import golden

from .logs import refused

CALL_STACK = "Call Stack (most recent call first):\n"

CMAKE = [
    "CMake Error at /ros/a.cmake:53 (message):\n"
    "  ament_package_xml() package name 'small_interfaces' in\n"
    "  '/package.xml' does not match current PROJECT_NAME 'other'.  You must call\n"
    f"{CALL_STACK}  CMakeLists.txt:8 (rosidl_generate_interfaces)\n",
    refused("InvalidResourceName: 'Project' is an invalid package\nname.  It should have"),
    "CMake Error at CMakeLists.txt:8 (rosidl_generate_interfaces):\n"
    '  Unknown CMake command "rosidl_generate_interfaces".\n\n',
    'CMake Error at /ros/x.cmake:30 (if):\n  if given arguments:\n\n    "NOT"\n\n'
    f"{CALL_STACK}  CMakeLists.txt:4 (find_package)\n\n\n"
    "CMake Error in CMakeLists.txt:\n  No cmake_minimum_required command is present.  A line of\n",
    'CMake Error at CMakeLists.txt:15:\n  Parse error.  Function missing ending ")".  Instead found\n'
    '  unterminated string with text "msg/Landmark.msg\n',
    "CMake Error at CMakeLists.txt:8 (rosidl_generate_interfaces):\n"
    '  The target name "$PROJECT_NAME" is reserved\n',
    "CMake Error at CMakeLists.txt:14 (add_executable):\n"
    "  Cannot find source file:\n\n    msg/Landmarc.msg\n\n  Tried\n",
    "CMake Error at cmake_install.cmake:362 (file):\n  file INSTALL cannot find\n"
    f'  "{SRC}/small_interfaces/launch": No\n',
    'CMake Error: The source directory "x" does not appear to contain CMakeLists.txt.\n',
    "CMake Error at CMakeLists.txt:3 (strange):\n  Something quite new.  It goes on for long.\n",
]


@pytest.mark.parametrize("log", CMAKE, ids=range(len(CMAKE)))
def test_faults_of_cmake_lists(case: Callable[..., Build], log: str) -> None:
    golden(explain_build(case("small_interfaces", log)))


def test_a_python_package_that_says_cmake(case: Callable[..., Build], src: Path) -> None:
    edit(src / "small_node/package.xml", "ament_python", "ament_cmake")
    log = 'CMake Error: The source directory "x" does not appear to contain CMakeLists.txt.\n'
    golden(explain_build(case("small_node", log)))
