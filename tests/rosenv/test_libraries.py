"""Whether the system has a C++ library."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.errors import MissingHere
from course.rosenv.libraries import lacks_library, require_libraries


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
