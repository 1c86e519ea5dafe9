"""A workspace that is really built in a trial home."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.errors import OurFault
from course.grading.trial_build import build_in_place

pytestmark = pytest.mark.slow


def test_it_is_built_anew_with_the_given_layout(tmp_path: Path) -> None:
    (tmp_path / "ws/src").mkdir(parents=True)
    build_in_place(tmp_path / "ws")
    (tmp_path / "ws/install/left").touch()
    build_in_place(tmp_path / "ws", ["--merge-install"])
    assert (tmp_path / "ws/install/.colcon_install_layout").read_text().strip() == "merged"
    assert not (tmp_path / "ws/install/left").exists()


def test_a_cmake_project_is_installed_anew(tmp_path: Path) -> None:
    (tmp_path / "kit").mkdir()
    (tmp_path / "kit/CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.8)\nproject(kit LANGUAGES NONE)\n"
        "install(FILES CMakeLists.txt DESTINATION include)\n"
    )
    (tmp_path / "opt").mkdir()
    (tmp_path / "opt/left").touch()
    build_in_place(tmp_path / "kit", [f"-DCMAKE_INSTALL_PREFIX={tmp_path}/opt"])
    assert [str(file.relative_to(tmp_path)) for file in (tmp_path / "opt").rglob("*.txt")] == [
        "opt/include/CMakeLists.txt"
    ]
    assert not (tmp_path / "opt/left").exists()


def test_a_build_that_fails_is_our_fault(tmp_path: Path) -> None:
    (tmp_path / "ws/src").mkdir(parents=True)
    with pytest.raises(OurFault, match="does not build"):
        build_in_place(tmp_path / "ws", ["--no-such-option"])
