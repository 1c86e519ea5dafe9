"""`bundle`: a zip with the requested files, or a reason why there is none."""

from __future__ import annotations

import os
import zipfile
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course.cli import bundle

if TYPE_CHECKING:
    from tests.cli.conftest import Ros2course

NAME = "ros2course-0.1.0-py3-none-any.whl"


@pytest.fixture
def wheel(tmp_path: Path) -> Path:
    file = tmp_path / NAME
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("course/__init__.py", "")
    return file


def test_a_bundle_of_what_was_asked_for(ros2course: Ros2course, wheel: Path, tmp_path: Path) -> None:
    out = tmp_path / "week3.zip"
    options = ("--wheel", str(wheel), "--out", str(out), "--exercises")
    assert ros2course("bundle", *options, "18, 19-q", course=None).code == 2
    run = ros2course("bundle", *options, "18,19", course=None)
    assert run.code == 0, run.err
    assert "week3.zip is ready: 0.0 MB." in run.out
    with zipfile.ZipFile(out) as archive:
        assert set(archive.namelist()) == {"setup.sh", "run_autograder", NAME, "exercises.txt"}
        assert archive.read("exercises.txt") == b"18,19"


def test_unsandboxed_only_when_that_is_said(ros2course: Ros2course, wheel: Path, tmp_path: Path) -> None:
    out = tmp_path / "trusting.zip"
    ros2course("bundle", "--wheel", str(wheel), "--out", str(out), "--no-sandbox")
    with zipfile.ZipFile(out) as archive:
        names = archive.namelist()
    assert "no-sandbox" in names
    for part in ("chapters", "graders"):
        assert any(name.startswith(f"course/{part}/") for name in names)


def test_a_wheel_that_is_none(ros2course: Ros2course, tmp_path: Path) -> None:
    run = ros2course("bundle", "--wheel", str(tmp_path / "none.whl"))
    assert run.code == 2
    assert "leave --wheel out" in run.err


def test_an_installed_course_has_no_wheel_of_itself(
    ros2course: Ros2course, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bundle, "_CHECKOUT", tmp_path)
    run = ros2course("bundle", "--out", str(tmp_path / "a.zip"))
    assert run.code == 2
    assert "--wheel" in run.err
    assert not (tmp_path / "a.zip").exists()


@pytest.mark.slow
def test_a_wheel_that_cannot_be_made(
    ros2course: Ros2course, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "pyproject.toml").write_text("no TOML at all [")
    monkeypatch.setattr(bundle, "_CHECKOUT", tmp_path)
    monkeypatch.setitem(os.environ, "PIP_NO_INDEX", "1")
    run = ros2course("bundle", "--out", str(tmp_path / "a.zip"))
    assert run.code == 4
    assert "was not built" in run.err
