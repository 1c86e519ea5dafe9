""""""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from course.errors import MissingHere
from course.rosenv.host import Host, lacks_library, require_libraries, why_no_wheels


def test_this_machine_is_described() -> None:
    host = Host.here()
    assert host.python == sys.version_info[:2]
    assert host.prefix.samefile(sys.prefix)
    assert Path(__import__("pytest").__file__).is_relative_to(host.site_packages)
    assert host.libc.startswith("glibc ") or host.libc == ""


HOST = Host(Path("/p/bin/python3"), Path("/p"), Path("/p/lib/python3.12/site-packages"), (3, 12))


@pytest.mark.parametrize("python", [(3, 10), (3, 12), (3, 14)])
def test_the_usual_machine_is_served(python: tuple[int, int]) -> None:
    assert why_no_wheels(replace(HOST, python=python)) is None


@pytest.mark.parametrize(
    ("changes", "what", "next_step"),
    [
        ({"machine": "aarch64"}, "x86-64 processors only; this one is aarch64", "Docker image ros:jazzy"),
        ({"system": "darwin"}, "Linux only; this is darwin", "Docker image ros:jazzy"),
        ({"libc": ""}, "musl", "Docker image ros:jazzy"),
        ({"libc": "glibc 2.27"}, "needs glibc 2.28 or newer, not glibc 2.27", "Docker image ros:jazzy"),
        ({"python": (3, 9)}, "Python 3.9 is too old", "3.10 to 3.14"),
        ({"python": (3, 15)}, "Python 3.15 is too new", "3.10 to 3.14"),
        ({"implementation": "pypy"}, "this Python is pypy", "3.10 to 3.14"),
        ({"free_threaded": True}, "this Python is free-threaded", "3.10 to 3.14"),
    ],
)
def test_another_machine_is_told_why_and_what_to_do(
    changes: dict[str, Any], what: str, next_step: str
) -> None:
    error = why_no_wheels(replace(HOST, **changes))
    assert what in error.what
    assert next_step in (error.next_step or "")


def test_the_processor_is_named_before_the_python() -> None:
    # Another Python would not help there.
    error = why_no_wheels(replace(HOST, machine="aarch64", python=(3, 9)))
    assert "aarch64" in error.what


@pytest.mark.parametrize(("name", "package"), [("Eigen3", "libeigen3-dev"), ("Qt5Core", "qtbase5-dev")])
@pytest.mark.parametrize("folder", ["share/library/cmake", "lib/x86_64-linux-gnu/cmake/Library"])
def test_it_is_there_when_cmake_would_find_it(tmp_path: Path, name: str, package: str, folder: str) -> None:
    with pytest.raises(MissingHere) as caught:
        require_libraries([name], [tmp_path])
    assert caught.value.next_step == f"sudo apt install {package}"
    (tmp_path / folder).mkdir(parents=True)
    (tmp_path / folder / f"{name}Config.cmake").touch()
    require_libraries([name], [tmp_path])


def test_a_part_of_qt_is_there_when_qt_is(tmp_path: Path) -> None:
    folder = tmp_path / "lib/cmake/Qt5Core"
    folder.mkdir(parents=True)
    (folder / "Qt5CoreConfig.cmake").touch()
    assert not lacks_library("Qt5coreConfig", [tmp_path])


def test_all_are_asked_for(tmp_path: Path) -> None:
    folder = tmp_path / "share/eigen3/cmake"
    folder.mkdir(parents=True)
    (folder / "Eigen3Config.cmake").touch()
    with pytest.raises(MissingHere, match="Qt 5"):
        require_libraries(["Eigen3", "Qt5Core"], [tmp_path])
