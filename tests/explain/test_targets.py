"""What CMake says of targets, and headers of a package that a target does not use."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.explain.build_errors import BuildError, explain_build
from course.explain.builds import Build
from tests.build.conftest import SRC
from tests.build.packages import edit
from tests.golden import golden

PACKAGE = "small_interfaces"
LISTS = """\
cmake_minimum_required(VERSION 3.8)
project(small_interfaces)
find_package(geometry_msg REQUIRED)
find_package(std_msgs REQUIRED)
add_library(arm SHARED src/arm.cpp)
add_executable(robot src/robot.cpp)
target_include_directories(arm PUBLIC include)
install(TARGETS arm
  EXPORT export_arms
  DESTINATION lib)
ament_export_targets(export_arm)
target_link_libraries(robot Qt5::Core Eigen3::Eigen)
"""

# Of which line CMake says which words.
TOLD = [
    (12, "ament_target_dependencies() the passed package name 'rclcpp' was not\n  found before"),
    (12, "ament_target_dependencies() the passed package name 'geometry_msgs' was not\n  found before"),
    (12, 'Cannot specify link libraries for target "robto" which is not built by this\n  project.'),
    (12, "ament_target_dependencies() the first argument 'gripper' must be a valid\n  target name"),
    (12, 'install TARGETS given target "robott" which does not exist.'),
    (None, 'Target "robot" links to:\n\n    Qt5::Core\n\n  but the target was not found.  Possible reasons'),
    (12, 'Target "robot" links to target "Eigen3::Eigen" but the target was not found.'),
    (None, 'Target "robot" links to:\n\n    std_msgs::std_msgs\n\n  but the target was not found.'),
    (None, 'Target "robot" links to:\n\n    geometry_msg::rclcp\n\n  but the target was not found.'),
    (12, "The plain signature for target_link_libraries has already been used with the\n  target"),
    (None, 'INSTALL(EXPORT) given unknown export "export_arm"'),
    (
        None,
        'Target "arm" INTERFACE_INCLUDE_DIRECTORIES property contains path:\n\n    "/a/include"\n\n'
        "  which is prefixed in the source directory.",
    ),
]


@pytest.fixture
def src_with_targets(src: Path) -> Path:
    (src / PACKAGE / "CMakeLists.txt").write_text(LISTS)
    (src / PACKAGE / "src").mkdir()
    for name in ("arm", "robot"):
        (src / PACKAGE / f"src/{name}.cpp").touch()
    return src


@pytest.mark.usefixtures("src_with_targets")
@pytest.mark.parametrize(("line", "words"), TOLD, ids=range(len(TOLD)))
def test_targets(case: Callable[..., Build], line: int | None, words: str) -> None:
    head = f"CMake Error at CMakeLists.txt:{line} (x):" if line else "CMake Error:"
    golden(explain_build(case(PACKAGE, f"{head}\n  {words}\n\n")))


HEADER = """\
{src}/small_interfaces/src/robot.cpp:3:10: fatal error: {header}: No such file or directory
    3 | #include <{header}>
compilation terminated.
gmake[2]: *** [CMakeFiles/robot.dir/build.make:76: CMakeFiles/robot.dir/src/robot.cpp.o] Error 1
"""


def of_header(case: Callable[..., Build], header: str, file: str = "robot.cpp") -> BuildError | None:
    log = HEADER.format(src=SRC, header=header).replace("robot.cpp:3", f"{file}:3")
    return explain_build(case(PACKAGE, log))


@pytest.mark.usefixtures("src_with_targets")
def test_a_header_of_a_package_that_the_target_does_not_use(case: Callable[..., Build]) -> None:
    golden(of_header(case, "std_msgs/msg/string.hpp"))  # as plain as line 12


@pytest.mark.usefixtures("src_with_targets")
@pytest.mark.parametrize(
    ("last", "header"),
    [
        ("", "rclcpp/rclcpp.hpp"),
        ("", "std_msgs/msg/string.hpp"),
        ("target_link_libraries(robot PRIVATE arm)", "rclcpp/rclcpp.hpp"),
        ("target_link_libraries(arm PUBLIC x)\ntarget_link_libraries(robot arm)", "rclcpp/rclcpp.hpp"),
        ("ament_target_dependencies(robot std_srvs)", "rclcpp/rclcpp.hpp"),
        ("ament_target_dependencies(arm std_srvs)", "rclcpp/rclcpp.hpp"),
    ],
)
def test_a_package_is_used_in_the_form_that_the_target_has(
    case: Callable[..., Build], src: Path, last: str, header: str
) -> None:
    lists = LISTS.replace("std_msgs", "std_msgs REQUIRED)\nfind_package(rclcpp")
    (src / PACKAGE / "CMakeLists.txt").write_text(lists.rpartition("target_link")[0] + last)
    golden(of_header(case, header))


@pytest.mark.usefixtures("src_with_targets")
def test_a_header_that_another_header_includes(case: Callable[..., Build], src: Path) -> None:
    (src / PACKAGE / "src/robot.hpp").touch()
    golden(of_header(case, "std_msgs/msg/string.hpp", "robot.hpp"))


def test_a_header_of_a_package_that_is_not_looked_for(
    case: Callable[..., Build], src_with_targets: Path
) -> None:
    edit(src_with_targets / PACKAGE / "CMakeLists.txt", "find_package(std_msgs REQUIRED)\n", "")
    golden(of_header(case, "std_msgs/msg/string.hpp"))


@pytest.mark.usefixtures("src_with_targets")
def test_a_header_of_the_package_by_another_name(case: Callable[..., Build], src: Path) -> None:
    (src / PACKAGE / "src/robot.hpp").touch()
    golden(of_header(case, "robot.h"))


@pytest.mark.usefixtures("src_with_targets")
def test_a_header_of_nobody(case: Callable[..., Build]) -> None:
    golden(of_header(case, "robot.hpp"))


@pytest.mark.usefixtures("src_with_targets")
def test_a_header_of_the_package_itself(case: Callable[..., Build]) -> None:
    golden(of_header(case, "small_interfaces/arm.hpp"))


def undefined(case: Callable[..., Build], src: Path, target: str, by: str, of: str) -> BuildError | None:
    """What is said when `Arm::bend` is used in a function of this target, with an argument of this type."""
    (src / PACKAGE / "src/arm.cpp").write_text("void Arm::bend(double by)\n{\n}\n")
    head = f"/usr/bin/ld: CMakeFiles/{target}.dir/src/{target}.cpp.o: in function `{by}()':\n{target}.cpp:"
    return explain_build(case(PACKAGE, f"{head}(.text+0x1): undefined reference to `Arm::bend({of})'\n"))


def test_a_library_of_the_package_that_is_not_linked(
    case: Callable[..., Build], src_with_targets: Path
) -> None:
    golden(undefined(case, src_with_targets, "robot", "main", "double"))


def test_a_target_is_not_told_to_link_itself(case: Callable[..., Build], src_with_targets: Path) -> None:
    golden(undefined(case, src_with_targets, "arm", "f", "int"))
