"""A C++ build that resumes where the build of a similar package ended: only changed files compile.

Packages are similar if they differ only in their sources, and in nothing that CMake reads. The earlier build
folder is copied, and make does the rest: it compiles what is older than its sources, and installs.

This is done for a learner's own packages and for the course's, never for submissions (see `PackageBuild`): a
build folder contains what the programs of one author made. It also requires that CMakeLists.txt consists of
commands that start only CMake, make, and the compiler, because make does not know what others have read.
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
    " ".join(
        (
            "cmake_minimum_required project if elseif else endif foreach endforeach set unset message",
            "find_package add_compile_options add_compile_definitions add_definitions include_directories",
            "add_executable add_library target_link_libraries target_include_directories",
            "target_compile_features target_compile_options target_compile_definitions target_sources",
            "set_target_properties install ament_target_dependencies ament_export_targets",
            "ament_export_dependencies ament_export_libraries ament_export_include_directories",
            "ament_lint_auto_find_test_dependencies ament_package",
        )
    ).split()
)
_INSTALLS = frozenset({"TARGETS", "DIRECTORY", "FILES", "PROGRAMS", "EXPORT"})
_VARIABLES = re.compile(r"CMAKE_(C|CXX)_(STANDARD|STANDARD_REQUIRED|EXTENSIONS)|(?!CMAKE_)\w+")
# What could hide a command, or makes the build run one of the package's own programs.
_OBSCURE = re.compile(
    r"\\|\[=*\[|LAUNCHER|RULE_LAUNCH|plugin|wrapper|specs|CONFIGS|file:|@|[\s(\"]-B", re.IGNORECASE
)
# How a compiler can read a file without telling make.
_READS = re.compile(rb"\.incbin|\.include\b|#\s*embed")


def may_differ(file: SourceFile) -> bool:
    """Return whether it is a source: compilers or installed programs read it, but CMake does not."""
    return PurePosixPath(file.name).suffix in _SOURCES


def is_plain_cmake(files: Iterable[SourceFile]) -> bool:
    """Return whether CMake and make run nothing that comes from the package."""
    files = tuple(files)
    lists = [file for file in files if PurePosixPath(file.name).name == LISTS]
    return (
        [file.name for file in lists] == [LISTS]
        and _is_plain_list(lists[0].path)
        and not any(_READS.search(file.path.read_bytes()) for file in files if may_differ(file))
    )


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


def keep_tree(package: str, entry: StoreEntry) -> bool:
    """Prepare a finished build so that others can resume it; return False if that is not possible.

    It is not after warnings of the compiler, which it would not repeat without compiling the file again.
    """
    shutil.rmtree(entry.build / "tmp", ignore_errors=True)
    hooks = entry.build / package / "ament_cmake_environment_hooks/package.dsv"
    if hooks.is_file():  # colcon installs a longer one, and make must not install this one again
        shutil.copy2(entry.prefix(package) / "share" / package / hooks.name, hooks)
    says = entry.log.read_text(encoding="utf-8", errors="replace").lower()
    return (
        "warning" not in says
        and seal(entry.build, entry.path) is None
        and not any(file.is_symlink() for top in (entry.build, entry.install) for file in top.rglob("*"))
    )


def lay_times(earlier: StoreEntry, entry: StoreEntry) -> bool:
    """Date sources so that make compiles the changed ones; return False if the clock was set back since."""
    now = time.time()
    for file in source_files(entry.src, entry.src):
        before = earlier.src / file.name
        if before.read_bytes() == file.path.read_bytes():
            shutil.copystat(before, file.path)
        else:  # it may have been copied before the earlier build ended
            os.utime(file.path, (now, now))
    return all(file.stat().st_mtime < now for file in entry.build.rglob("*") if file.is_file())


def make_command(package: str, entry: StoreEntry, env: Mapping[str, str]) -> list[str]:
    """Return the command that colcon runs after it has configured the package."""
    cmake, jobs = shutil.which("cmake", path=env.get("PATH", os.defpath)) or "cmake", os.cpu_count() or 1
    command = [cmake, "--build", str(entry.build / package), "--target", "install"]
    return [*command, "--", f"-j{jobs}", f"-l{jobs}", "--output-sync=target"]
