"""What CMake says of targets, and headers of a package that a target does not use."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.build.digest import Case, explain
from tests.build.conftest import SRC
from tests.build.digest.logs import check
from tests.build.packages import edit

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

# CMake's words at a line; the kind, the places, words of the summary, words of the advice
TOLD = [
    (12, "ament_target_dependencies() the passed package name 'rclcpp' was not\n  found before",
     "find-package-missing", "CMakeLists.txt:12", "uses the package `rclcpp`",
     "Add `find_package(rclcpp REQUIRED)`"),
    (12, "ament_target_dependencies() the passed package name 'geometry_msgs' was not\n  found before",
     "find-package-missing", "CMakeLists.txt:3", "uses the package `geometry_msgs`", "Compare with line 3"),
    (12, 'Cannot specify link libraries for target "robto" which is not built by this\n  project.',
     "target-missing", "CMakeLists.txt:12", "names the target `robto`", "Did you mean `robot`?"),
    (12, "ament_target_dependencies() the first argument 'gripper' must be a valid\n  target name",
     "target-missing", "CMakeLists.txt:12", "names the target `gripper`", "`add_executable`"),
    (12, 'install TARGETS given target "robott" which does not exist.',
     "target-missing", "CMakeLists.txt:12", "names the target `robott`", "Did you mean `robot`?"),
    (None, 'Target "robot" links to:\n\n    Qt5::Core\n\n  but the target was not found.  Possible reasons',
     "link-target", "CMakeLists.txt:12", "links `Qt5::Core`", "Add `find_package(Qt5Core REQUIRED)`"),
    (12, 'Target "robot" links to target "Eigen3::Eigen" but the target was not found.',
     "link-target", "CMakeLists.txt:12", "links `Eigen3::Eigen`", "Add `find_package(Eigen3 REQUIRED)`"),
    (12, "The plain signature for target_link_libraries has already been used with the\n  target",
     "link-signature", "CMakeLists.txt:12", "with `PRIVATE` or `PUBLIC`", "in all lines"),
    (None, 'INSTALL(EXPORT) given unknown export "export_arm"',
     "export-name", "CMakeLists.txt:11", "`export_arm` is exported", "EXPORT export_arm"),
    (None, 'Target "arm" INTERFACE_INCLUDE_DIRECTORIES property contains path:\n\n    "/a/include"\n\n'
     "  which is prefixed in the source directory.",
     "include-folder", "CMakeLists.txt:7", "in your source folder", "INSTALL_INTERFACE"),
]  # fmt: skip


@pytest.fixture
def src_with_targets(src: Path) -> Path:
    (src / PACKAGE / "CMakeLists.txt").write_text(LISTS)
    (src / PACKAGE / "src").mkdir()
    for name in ("arm", "robot"):
        (src / PACKAGE / f"src/{name}.cpp").touch()
    return src


@pytest.mark.usefixtures("src_with_targets")
@pytest.mark.parametrize(
    ("line", "words", "kind", "place", "summary", "advice"), TOLD, ids=[f"{row[2]}-{row[3]}" for row in TOLD]
)
def test_targets(
    case: Callable[..., Case],
    line: int | None,
    words: str,
    kind: str,
    place: str,
    summary: str,
    advice: str,
) -> None:
    head = f"CMake Error at CMakeLists.txt:{line} (x):" if line else "CMake Error:"
    failure = explain(case(PACKAGE, f"{head}\n  {words}\n\n"))
    check(failure, kind, f"{SRC}/{PACKAGE}/{place}", summary, advice)


HEADER = """\
{src}/small_interfaces/src/robot.cpp:3:10: fatal error: {header}: No such file or directory
    3 | #include <{header}>
compilation terminated.
gmake[2]: *** [CMakeFiles/robot.dir/build.make:76: CMakeFiles/robot.dir/src/robot.cpp.o] Error 1
"""


def missing_header(case: Callable[..., Case], header: str) -> str:
    failure = explain(case(PACKAGE, HEADER.format(src=SRC, header=header)))
    assert failure is not None
    places = [str(place).rpartition("/")[2] for place in failure.feedback.where]
    return f"{places} {failure.feedback.advice}"


@pytest.mark.usefixtures("src_with_targets")
def test_a_header_of_a_package_that_the_target_does_not_use(case: Callable[..., Case]) -> None:
    said = missing_header(case, "std_msgs/msg/string.hpp")
    assert said.startswith("['robot.cpp:3', 'CMakeLists.txt:6']")
    assert "Add `ament_target_dependencies(robot std_msgs)`" in said


@pytest.mark.usefixtures("src_with_targets")
def test_a_header_that_another_header_includes(case: Callable[..., Case], src: Path) -> None:
    (src / PACKAGE / "src").mkdir(exist_ok=True)
    (src / PACKAGE / "src/robot.hpp").touch()
    log = HEADER.format(src=SRC, header="std_msgs/msg/string.hpp").replace("robot.cpp:3", "robot.hpp:3")
    failure = explain(case(PACKAGE, log))
    assert failure is not None
    assert (
        failure.feedback.advice and "`ament_target_dependencies(robot std_msgs)`" in failure.feedback.advice
    )


def test_a_header_of_a_package_that_is_not_looked_for(
    case: Callable[..., Case], src_with_targets: Path
) -> None:
    edit(src_with_targets / PACKAGE / "CMakeLists.txt", "find_package(std_msgs REQUIRED)\n", "")
    said = missing_header(case, "std_msgs/msg/string.hpp")
    assert said.startswith("['robot.cpp:3'] It belongs to `std_msgs`: name that in `find_package`")


@pytest.mark.usefixtures("src_with_targets")
def test_a_header_of_the_package_by_another_name(case: Callable[..., Case], src: Path) -> None:
    (src / PACKAGE / "src").mkdir(exist_ok=True)
    (src / PACKAGE / "src/robot.hpp").touch()
    assert "Did you mean the header `src/robot.hpp`?" in missing_header(case, "robot.h")


@pytest.mark.usefixtures("src_with_targets")
def test_a_header_of_nobody(case: Callable[..., Case]) -> None:
    assert "Is the header's name right" in missing_header(case, "robot.hpp")


@pytest.mark.usefixtures("src_with_targets")
def test_a_header_of_the_package_itself(case: Callable[..., Case]) -> None:
    assert "`target_include_directories` has to name" in missing_header(case, "small_interfaces/arm.hpp")


def test_a_library_of_the_package_that_is_not_linked(
    case: Callable[..., Case], src_with_targets: Path
) -> None:
    (src_with_targets / PACKAGE / "src/arm.cpp").write_text("void Arm::bend(double by)\n{\n}\n")
    object_file = "CMakeFiles/robot.dir/src/robot.cpp.o"
    log = f"/usr/bin/ld: {object_file}: in function `main':\nrobot.cpp:(.text+0x1): undefined reference to"
    failure = explain(case(PACKAGE, f"{log} `Arm::bend(double)'\n"))
    assert failure is not None
    assert "`src/arm.cpp` of `arm` defines it" in str(failure.feedback.advice)
    assert "add `target_link_libraries(robot arm)`" in str(failure.feedback.advice)


def test_a_target_is_not_told_to_link_itself(case: Callable[..., Case], src_with_targets: Path) -> None:
    (src_with_targets / PACKAGE / "src/arm.cpp").write_text("void Arm::bend(double by)\n{\n}\n")
    object_file = "CMakeFiles/arm.dir/src/arm.cpp.o"
    log = f"/usr/bin/ld: {object_file}: in function `f()':\narm.cpp:(.text+0x1): undefined reference to"
    failure = explain(case(PACKAGE, f"{log} `Arm::bend(int)'\n"))
    assert failure is not None
    assert "target_link_libraries" not in str(failure.feedback.advice)
