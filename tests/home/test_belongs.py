"""A home remembers the course that it was made for."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.errors import UsageError
from course.home import create_home, remember_course, remembered_course


def test_none_by_default(tmp_path: Path) -> None:
    assert remembered_course(create_home(tmp_path / "home")) is None


def test_the_last_one_that_was_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = create_home(tmp_path / "home")
    monkeypatch.chdir(tmp_path)
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        remember_course(home, Path(name))
        assert remembered_course(home) == tmp_path / name


def test_one_that_is_gone(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    remember_course(home, tmp_path / "gone")
    with pytest.raises(UsageError, match="gone") as caught:
        remembered_course(home)
    assert caught.value.next_step == f"say where it is now: ros2course init {home.path} --course DIR"
