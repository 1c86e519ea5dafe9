"""Unknown failures, paths, and what is the machine's fault."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from course.build.colcon import Killed, Machine, raise_if_machine
from course.errors import MissingHere, StorageError
from course.explain.build_errors import explain_build
from course.explain.builds import Build, readable


def test_an_unknown_failure_shows_its_last_errors(case: Callable[..., Build]) -> None:
    log = "running x\nfine\nerror: the moon is full\ngmake: *** [all] Error 2\n"
    failure = explain_build(case("small_interfaces", log))
    assert failure.kind == "build"
    assert failure.feedback.details == ("error: the moon is full",)


def test_paths_are_the_learners(tmp_path: Path) -> None:
    store = tmp_path / "store"
    copy = store / ("a" * 32) / "src"
    log = f"\x1b[31m{copy}/main.cpp:3: in {store}/{'b' * 32}/install/other/x.hpp\x1b[0m\r\ncd {copy}\n"
    found = readable(log, store, copy, "ws/src/mine")
    assert found == ("ws/src/mine/main.cpp:3: in install/other/x.hpp", "cd ws/src/mine")


class Poor(Machine):
    """Lacks everything."""

    def is_full(self) -> bool:
        return True

    lacks_headers = lacks_compiler = is_full


@pytest.mark.parametrize(
    ("line", "error", "words"),
    [
        ("fatal error: error writing to x: No space left on device", StorageError, "disk is full"),
        ("OSError: [Errno 122] Disk quota exceeded: 'x'", StorageError, "disk is full"),
        ("c++: fatal error: Killed signal terminated program cc1plus", MissingHere, "out of memory"),
        ("  Could NOT find Python3 (missing: Development.Module)", MissingHere, "header files"),
        ("  No CMAKE_CXX_COMPILER could be found.", MissingHere, "C++ compiler"),
    ],
)
def test_the_machines_faults_are_not_the_learners(
    tmp_path: Path, line: str, error: type[Exception], words: str
) -> None:
    with pytest.raises(error) as caught:
        raise_if_machine(["fine", line], Poor(tmp_path, tmp_path / "python3", Killed(-1)))
    assert words in str(caught.value)
    raise_if_machine(["fine", line], Machine(tmp_path, Path(sys.executable), Killed()))


@pytest.mark.parametrize(
    ("config", "package"), [("Eigen3Config.cmake", "libeigen3-dev"), ("Qt5CoreConfig.cmake", "qtbase5-dev")]
)
@pytest.mark.parametrize("folder", ["share/library/cmake", "lib/x86_64-linux-gnu/cmake/Library"])
def test_a_library_of_the_system_is_missing_only_if_it_really_is(
    tmp_path: Path, config: str, package: str, folder: str
) -> None:
    log = ["CMake Error at CMakeLists.txt:5 (find_package):", f"    {config}"]
    machine = Machine(tmp_path, Path(sys.executable), Killed(), system=(tmp_path,))
    with pytest.raises(MissingHere) as caught:
        raise_if_machine(log, machine)
    assert caught.value.next_step == f"sudo apt install {package}"
    (tmp_path / folder).mkdir(parents=True)
    (tmp_path / folder / config).touch()
    raise_if_machine(log, machine)


def test_a_misspelt_part_of_what_is_there_is_no_fault_of_the_machine(tmp_path: Path) -> None:
    folder = tmp_path / "lib/x86_64-linux-gnu/cmake/Qt5Core"
    folder.mkdir(parents=True)
    (folder / "Qt5CoreConfig.cmake").touch()
    machine = Machine(tmp_path, Path(sys.executable), Killed(), system=(tmp_path,))
    raise_if_machine(["    Qt5coreConfig.cmake"], machine)
