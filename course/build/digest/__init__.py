"""From the log of a failed build to its cause, in a few lines, with file, line and advice.

One module for each kind of tool that fails. Each looks whether the failure is one of its own; the
first that says so is believed, so the more particular ones come first.
"""

from __future__ import annotations

import re
from pathlib import Path

from course.build.digest import cmake, compiler, python, rosidl, targets
from course.build.digest.case import Case, log_text, readable
from course.build.outcome import BuildFailure
from course.build.refusal import manifest_place

__all__ = ["Case", "explain", "explain_success", "log_text", "readable"]

_NOISE = re.compile(
    r"^\s*$|^gmake|^make|^\[ *\d+%\]|^-- |^\[\d+\.\d+s\] WARNING:colcon|^Traceback|^ +\^+ *$|^running "
)
_TELLING = re.compile(r"(?i)\berror\b|\bfailed\b|exception|cannot|not found|no such")


def explain(case: Case) -> BuildFailure:
    """Why the build failed; at worst the last lines of its log that look like a reason."""
    for digest in (python.digest, rosidl.digest, targets.digest, cmake.digest, compiler.digest):
        if failure := digest(case):
            return failure
    return _last_lines(case)


def explain_success(case: Case, prefix: Path) -> BuildFailure | None:
    """What is wrong although colcon is content; None if nothing is."""
    if failure := rosidl.reserved_word(case):
        return failure
    name, build_type = case.package.name, case.package.build_type
    marker = prefix / "share/ament_index/resource_index/packages" / name
    installed = marker.exists() or (build_type == "cmake" and prefix.exists())
    return None if installed else _not_installed(case, name, build_type)


def _not_installed(case: Case, name: str, build_type: str) -> BuildFailure:
    """ROS will not find the package."""
    if any("No task extension to 'build'" in line for line in case.lines):
        summary = f"package.xml of `{name}` has the build type {build_type}, which does not exist."
        advice = "Write ament_python for a Python package, ament_cmake for one with a CMakeLists.txt."
        where = [manifest_place(case.package, "build_type")]
        return case.failure("build-type", summary, where=where, advice=advice)
    if build_type == "ament_cmake" and not case.line_of("CMakeLists.txt", r"(?i)^\s*ament_package\s*\("):
        summary = f"CMakeLists.txt of `{name}` never calls `ament_package()`: ROS will not find the package."
        advice = "Add `ament_package()` as the last line."
        return case.failure("ament-package", summary, where=[case.place("CMakeLists.txt")], advice=advice)
    summary = f"The build of `{name}` installs nothing that ROS could find."
    return case.failure("not-installed", summary, where=[case.place("package.xml")], details=case.lines[-3:])


def _last_lines(case: Case) -> BuildFailure:
    lines = [line for line in case.lines if not _NOISE.search(line)]
    telling = [line for line in lines if _TELLING.search(line)] or lines
    summary = f"`{case.package.name}` cannot be built."
    advice = "Build it yourself with `colcon build` and read the first error."
    return case.failure(
        "build", summary, where=[case.place("package.xml")], advice=advice, details=telling[-6:]
    )
