"""How much of other people's C++ compiles and passes on our packages: a table, and a list to compare with.

    python tests/peers/measure.py CHECKOUTS

CHECKOUTS holds checkouts, branch jazzy, of these repositories of https://github.com/ros2, each in a folder
of its name: rclcpp, examples, demos, rcl_interfaces, test_interface_files. They are built as shipped, against
ROS from pip and our packages. rclcpp's own tests, those of its four packages, need GoogleTest (libgtest-dev,
libgmock-dev). Those that inject faults into rcl use no public API, and are left out.

What is in `passing.txt`, but works no longer, is printed; then the exit code is 1. `--write` writes the list.
CI has no such checkouts, so it does not run this.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from course.build.underlay_build import build_underlay
from course.rosenv import find_ros, missing_of_underlay, node_environment, prepare
from course.rosenv.underlay import source_root

LIST = Path(__file__).with_name("passing.txt")
_PRIVATE = ("mocking_utils", "fault_injection")
_EXECUTABLE = re.compile(r"^\s*add_executable\s*\(|\bEXECUTABLE\s+\w+", re.MULTILINE)
_CASES = re.compile(r"^TYPED_TEST\(|^TEST(?:_[FP])?\s*\(", re.MULTILINE)
_RAN, _PASSED = (re.compile(rf"^\[ *{word} *\] (\d+) test", re.MULTILINE) for word in ("=+", "PASSED"))
_RUN_TIME = 120.0
# The tests want messages of a package that is called as rclcpp itself.
_TESTS = """\
cmake_minimum_required(VERSION 3.8)
project(rclcpp LANGUAGES C CXX)
set(CMAKE_CXX_STANDARD 17)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(rclcpp_action REQUIRED)
find_package(rclcpp_components REQUIRED)
find_package(rclcpp_lifecycle REQUIRED)
find_package(rosidl_default_generators REQUIRED)
find_package(statistics_msgs REQUIRED)
find_package(test_msgs REQUIRED)
find_package(GTest REQUIRED)
file(GLOB messages RELATIVE ${TESTS}/.. ${TESTS}/../msg/*.msg)
list(TRANSFORM messages PREPEND "${TESTS}/..:")
rosidl_generate_interfaces(rclcpp_test_msgs ${messages}
  DEPENDENCIES builtin_interfaces LIBRARY_NAME rclcpp SKIP_INSTALL)
rosidl_get_typesupport_target(own_messages rclcpp_test_msgs rosidl_typesupport_cpp)
# Other tests use what is in this one.
add_library(helpers STATIC ${TESTS}/executors/test_waitable.cpp)
target_link_libraries(helpers rclcpp::rclcpp)
foreach(source ${SOURCES})
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  target_include_directories(${name} PRIVATE ${TESTS} ${TESTS}/..)
  target_compile_definitions(${name} PRIVATE TEST_RESOURCES_DIRECTORY="${RESOURCES}")
  target_link_libraries(${name}
    helpers rclcpp::rclcpp rclcpp_action::rclcpp_action rclcpp_components::component_manager
    rclcpp_lifecycle::rclcpp_lifecycle ${own_messages} ${statistics_msgs_TARGETS} ${test_msgs_TARGETS}
    GTest::gmock GTest::gtest_main)
endforeach()
"""
_PACKAGE = """\
<package format="3">
  <name>rclcpp</name><version>0.0.0</version><description>Tests</description>
  <maintainer email="nobody@example.com">nobody</maintainer><license>none</license>
  <member_of_group>rosidl_interface_packages</member_of_group>
</package>
"""


@dataclass(frozen=True)
class Row:
    """what: what is counted. good: the names of those that work. of: how many there are."""

    what: str
    good: tuple[str, ...]
    of: int


@dataclass(frozen=True)
class Builder:
    """folder: for all that is made. environment: with ROS and our packages."""

    checkouts: Path
    folder: Path
    environment: Mapping[str, str]

    def run(self, *command: str | Path, log: str) -> None:
        """Run it to its end, however it ends; what it says goes into the file `log`."""
        with (self.folder / log).open("w") as file:
            told = {"cwd": self.folder, "env": self.environment, "stdout": file, "stderr": file}
            subprocess.run(["nice", *command], check=False, **told)

    def colcon(self, name: str, *packages: Path) -> Path:
        """Build these packages; returns where they are installed, each by itself."""
        base = self.folder / name
        places = ("--build-base", base / "build", "--install-base", base / "install")
        options = ("--continue-on-error", "--executor", "sequential", "--cmake-args", "-DBUILD_TESTING=OFF")
        tool = (sys.executable, "-m", "colcon", "--log-base", base / "log")
        self.run(*tool, "build", "--paths", *packages, *places, *options, log=f"{name}.log")
        return base / "install"


def main() -> int:
    raw = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=raw)
    parser.add_argument("checkouts", type=Path)
    parser.add_argument("--work", type=Path, help="keep all that is built, and the logs, in this folder")
    parser.add_argument("--write", action="store_true", help="write passing.txt")
    given = parser.parse_args()
    ros = find_ros()
    prepare(ros)
    if source_root() is None:
        raise SystemExit("This ROS is an installed one, with its own packages: there is nothing to compare.")
    build_underlay([package.name for package in missing_of_underlay(ros)], ros, on_progress=print)
    with tempfile.TemporaryDirectory(prefix="peers-") as scratch:
        folder = (given.work or Path(scratch)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        builder = Builder(given.checkouts.resolve(), folder, {**os.environ, **node_environment(ros)})
        rows = [*rclcpp_tests(builder), *executables(builder), demos(builder)]
    for row in rows:
        print(f"{row.what:<52} {len(row.good):>4} of {row.of}")
    found = [f"{row.what}: {name}" for row in rows for name in sorted(row.good)]
    if given.write:
        LIST.write_text("\n".join(found) + "\n", encoding="utf-8")
    lost = sorted(set(LIST.read_text(encoding="utf-8").splitlines()) - set(found))
    print(*(f"no longer: {line}" for line in lost), sep="\n")
    return 1 if lost else 0


def rclcpp_tests(builder: Builder) -> Iterator[Row]:
    """Those with public API only: which files compile, and which of their cases pass."""
    needed = ("test_interface_files", "rcl_interfaces/test_msgs", "rcl_interfaces/statistics_msgs")
    messages = builder.colcon("messages", *(builder.checkouts / name for name in needed))
    tests = builder.checkouts / "rclcpp/rclcpp/test/rclcpp"
    public = [
        file for file in sorted((builder.checkouts / "rclcpp").glob("*/test/**/test_*.cpp"))
        if not any(word in file.read_text(encoding="utf-8") for word in _PRIVATE)
    ]  # fmt: skip
    project, build = builder.folder / "tests", builder.folder / "tests/build"
    project.mkdir(exist_ok=True)
    (project / "CMakeLists.txt").write_text(_TESTS, encoding="utf-8")
    (project / "package.xml").write_text(_PACKAGE, encoding="utf-8")
    paths = {"TESTS": tests, "RESOURCES": tests.parent / "resources", "Python3_EXECUTABLE": sys.executable}
    lists = {"SOURCES": public, "CMAKE_PREFIX_PATH": [messages / Path(name).name for name in needed]}
    told = {**paths, **{name: ";".join(map(str, paths)) for name, paths in lists.items()}}
    options = (f"-D{name}={value}" for name, value in told.items())
    builder.run("cmake", "-S", project, "-B", build, *options, log="configure.log")
    builder.run("cmake", "--build", build, "--", "--keep-going", log="tests.log")
    compiled = [file for file in public if (build / file.stem).is_file()]
    yield Row("rclcpp's test files that compile", tuple(file.stem for file in compiled), len(public))
    outcomes = {file.stem: cases(builder, build / file.stem, messages) for file in compiled}
    good = (f"{name} {number}" for name, (passed, _) in outcomes.items() for number in range(1, passed + 1))
    yield Row("their cases that pass", tuple(good), sum(ran for _, ran in outcomes.values()))
    every = sum(len(_CASES.findall(file.read_text(encoding="utf-8"))) for file in public)
    print(f"(as written, all {len(public)} files have {every} cases; parameters and types make more)")


def cases(builder: Builder, program: Path, messages: Path) -> tuple[int, int]:
    """How many pass, and how many run."""
    own = (program.parent, *messages.glob("*/lib"), builder.environment.get("LD_LIBRARY_PATH", ""))
    libraries = ":".join(map(str, own))
    try:
        done = subprocess.run(
            ["nice", program], cwd=builder.folder, env={**builder.environment, "LD_LIBRARY_PATH": libraries},
            capture_output=True, text=True, errors="replace", timeout=_RUN_TIME, check=False,
        )  # fmt: skip
        said = done.stdout
    except subprocess.TimeoutExpired as error:
        said = (error.stdout or b"").decode(errors="replace")
    (builder.folder / f"{program.name}.txt").write_text(said, encoding="utf-8")
    ran, passed = (pattern.findall(said) for pattern in (_RAN, _PASSED))
    single = said.count("[       OK ]"), said.count("[ RUN      ]")
    return (int(passed[-1]), int(ran[-1])) if ran and passed else single


def executables(builder: Builder) -> Iterator[Row]:
    packages = cpp_packages(builder.checkouts / "examples/rclcpp")
    install = builder.colcon("examples", *packages)
    shipped = sum(len(_EXECUTABLE.findall((package / "CMakeLists.txt").read_text())) for package in packages)
    made = (file for file in install.glob("*/lib/*/*") if os.access(file, os.X_OK) and file.is_file())
    good = tuple(f"{file.parent.name} {file.name}" for file in made)
    yield Row("executables of ros2/examples in C++, as shipped", good, shipped)


def demos(builder: Builder) -> Row:
    packages = cpp_packages(builder.checkouts / "demos")
    install = builder.colcon("demos", *packages)
    good = (file.parent.name for file in install.glob("*/share/*/package.xml"))
    return Row("packages of ros2/demos in C++ that build, as shipped", tuple(good), len(packages))


def cpp_packages(folder: Path) -> list[Path]:
    return [file.parent for file in sorted(folder.rglob("package.xml")) if "ament_cmake" in file.read_text()]


if __name__ == "__main__":
    sys.exit(main())
