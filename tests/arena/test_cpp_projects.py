"""The course's own projects, built with what the learner's packages install."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from course.arena.cpp_programs import compiling, configuring
from course.errors import OurFault

from .test_cpp_programs import CppProjects

LISTS = """\
cmake_minimum_required(VERSION 3.8)
project(user CXX)
find_package(mathpack REQUIRED)
add_executable(user user.cpp)
target_include_directories(user PRIVATE ${ASK} ${mathpack_DIR})
"""
USER = '#include "ask.hpp"\n#include "turn.hpp"\nint main() { ask("turn", [] { return turn; }); done(); }\n'
SETUP = "export LD_LIBRARY_PATH=/sourced:$LD_LIBRARY_PATH\n"


class Projects(CppProjects):
    """With one package of the learner's, which consists of CMake files only."""

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        self.prefix = folder / "mathpack"
        self.cmake = self.prefix / "share/mathpack/cmake"
        self.cmake.mkdir(parents=True)
        (self.cmake / "mathpackConfig.cmake").touch()
        (self.cmake / "turn.hpp").write_text("const int turn = 360;\n")
        (self.prefix / "share/mathpack/local_setup.bash").write_text(SETUP)
        paths = {"AMENT_PREFIX_PATH": f"/ros:{self.prefix}", "CMAKE_PREFIX_PATH": str(self.prefix)}
        libraries = {"LD_LIBRARY_PATH": f"{self.prefix}/lib:/ros/lib"}
        self._environment = {**self._environment, **paths, **libraries}

    def words(self, process: str) -> str:
        return "\n".join(self.recording.process(process).text)


@pytest.fixture
def projects(tmp_path: Path) -> Iterator[Projects]:
    projects = Projects(tmp_path)
    yield projects
    projects.close()


@pytest.fixture
def user(tmp_path: Path) -> Path:
    folder = tmp_path / "theirs"
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text(LISTS)
    (folder / "user.cpp").write_text(USER)
    return folder


@pytest.mark.slow
def test_a_project_that_uses_a_package(projects: Projects, user: Path) -> None:
    program = projects.cpp.build_project("user", user)
    projects.cpp.ask(program, name="user")
    answer = projects.recording.probe("user").answer("turn")
    assert answer.value == 360


@pytest.mark.slow
def test_what_the_compiler_says_is_kept(projects: Projects, user: Path) -> None:
    (projects.cmake / "turn.hpp").unlink()
    assert projects.cpp.build_project("user", user) is None
    assert "turn.hpp: No such file or directory" in projects.words(compiling("user"))


@pytest.mark.slow
def test_a_package_that_is_not_found(projects: Projects, user: Path) -> None:
    (projects.cmake / "mathpackConfig.cmake").unlink()
    assert projects.cpp.build_project("user", user) is None
    assert 'provided by "mathpack"' in projects.words(configuring("user"))
    assert projects.recording.process(compiling("user")).started is None


def test_in_a_shell_only_what_the_packages_own_setup_says_counts(projects: Projects, tmp_path: Path) -> None:
    program = tmp_path / "program"
    program.write_text('#!/bin/sh\necho "$LD_LIBRARY_PATH"\n')
    program.chmod(0o755)
    projects.cpp.ask_sourced(program, "mathpack", name="sourced")
    assert projects.words("sourced") == "/sourced:/ros/lib"


def test_without_a_program_nothing_is_run(projects: Projects) -> None:
    projects.cpp.ask_sourced(None, "mathpack", name="sourced")
    assert projects.recording.process("sourced").started is None


def test_a_package_that_was_not_built_for_the_exercise(projects: Projects, tmp_path: Path) -> None:
    with pytest.raises(OurFault, match="armpack"):
        projects.cpp.ask_sourced(tmp_path, "armpack", name="sourced")
