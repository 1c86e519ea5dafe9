"""A build of a C++ package that goes on where that of one like it ended, so that only changed files compile.

Packages are alike when they differ in what their sources say, and in nothing that CMake reads. The earlier
build folder is copied, and make does the rest: it compiles what is older than its sources, and installs.

A build folder is used for other submissions, too, so it may hold nothing that a submission's own programs
wrote. It is kept only where CMakeLists.txt consists of commands that run CMake, make and the compiler alone.
"""

from __future__ import annotations

import os
import re
import shutil
import time
from collections.abc import Iterable, Mapping
from pathlib import Path, PurePosixPath

from course.build.outputs import seal
from course.build.package_sources import SourceFile, source_files
from course.build.store import StoreEntry
from course.explain.cmake import LISTS, commands_in

_SOURCES = frozenset({".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx", ".py", ".yaml", ".md"})
_COMMANDS = frozenset(
    "cmake_minimum_required project if elseif else endif foreach endforeach set unset message find_package "
    "add_compile_options add_compile_definitions add_definitions include_directories add_executable "
    "add_library target_link_libraries target_include_directories target_compile_features "
    "target_compile_options target_compile_definitions target_sources set_target_properties install "
    "ament_target_dependencies ament_export_targets ament_export_dependencies ament_export_libraries "
    "ament_export_include_directories ament_lint_auto_find_test_dependencies ament_package".split()
)
_INSTALLS = frozenset({"TARGETS", "DIRECTORY", "FILES", "PROGRAMS", "EXPORT"})
_VARIABLES = re.compile(r"CMAKE_(C|CXX)_(STANDARD|STANDARD_REQUIRED|EXTENSIONS|FLAGS)|(?!CMAKE_)\w+")
# What could hide a command from a reader, and what has a program of the package's own run by the build.
_OBSCURE = re.compile(r"\\|\[=*\[|LAUNCHER|RULE_LAUNCH|plugin|wrapper|CONFIGS|file:", re.IGNORECASE)


def may_differ(file: SourceFile) -> bool:
    """Whether it is a source, which compilers or installed programs read, but CMake does not."""
    return PurePosixPath(file.name).suffix in _SOURCES


def is_plain_cmake(files: Iterable[SourceFile]) -> bool:
    """Whether CMake and make run nothing that comes from the package."""
    lists = [file for file in files if PurePosixPath(file.name).name == LISTS]
    return [file.name for file in lists] == [LISTS] and _is_plain_list(lists[0].path)


def _is_plain_list(file: Path) -> bool:
    text = file.read_text(encoding="utf-8", errors="replace")
    return not _OBSCURE.search(text) and all(
        command.name in _COMMANDS and _is_plain(command.name, command.words[:1])
        for command in commands_in(text, LISTS)
    )


def _is_plain(command: str, first: tuple[str, ...]) -> bool:
    if command == "install":
        return _INSTALLS.issuperset(first)
    return command not in ("set", "unset") or all(map(_VARIABLES.fullmatch, first))


def keep_tree(entry: StoreEntry) -> bool:
    """Make a finished build fit to be gone on with; False if it is not.

    What a compiler warns of would not be printed again for a file that is not compiled again.
    """
    shutil.rmtree(entry.build / "tmp", ignore_errors=True)
    says = entry.log.read_text(encoding="utf-8", errors="replace").lower()
    return (
        "warning" not in says
        and seal(entry.build, entry.path) is None
        and not any(file.is_symlink() for top in (entry.build, entry.install) for file in top.rglob("*"))
    )


def lay_times(earlier: StoreEntry, entry: StoreEntry) -> bool:
    """Make unchanged sources as old as they were; False if the clock has been set back since."""
    for file in source_files(entry.src, entry.src):
        before = earlier.src / file.name
        if before.read_bytes() == file.path.read_bytes():
            shutil.copystat(before, file.path)
    return all(file.stat().st_mtime < time.time() for file in entry.build.rglob("*"))


def make_command(package: str, entry: StoreEntry, env: Mapping[str, str]) -> list[str]:
    """What colcon runs after it has configured the package; CMake itself is configured no more."""
    cmake = shutil.which("cmake", path=env.get("PATH", os.defpath)) or "cmake"
    jobs = str(os.cpu_count() or 1)
    return [cmake, "--build", str(entry.build / package), "--target", "install", "--parallel", jobs]
