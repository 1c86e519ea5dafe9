"""Answers are kept whole, and nowhere else."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.errors import StorageError, UsageError
from course.home import create_home, keep_answers


def test_answers_are_kept(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    keep_answers(home, "05-quiz", "a: b\n")
    keep_answers(home, "05-quiz", "a: c\n")
    assert [file.name for file in (home.path / "answers").iterdir()] == ["05-quiz.yaml"]
    assert (home.path / "answers/05-quiz.yaml").read_text() == "a: c\n"


def test_a_link_is_replaced_and_not_written_through(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    (tmp_path / "other").write_text("precious\n")
    (home.path / "answers").mkdir()
    (home.path / "answers/05-quiz.yaml").symlink_to(tmp_path / "other")
    keep_answers(home, "05-quiz", "a: b\n")
    assert (tmp_path / "other").read_text() == "precious\n"


def test_a_folder_that_leads_elsewhere(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    (tmp_path / "other").mkdir()
    (home.path / "answers").symlink_to(tmp_path / "other")
    with pytest.raises(UsageError, match="leads out of the course home"):
        keep_answers(home, "05-quiz", "a: b\n")


def test_a_file_where_the_folder_should_be(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    (home.path / "answers").write_text("mine\n")
    with pytest.raises(StorageError, match=r"answers/05-quiz\.yaml cannot be written"):
        keep_answers(home, "05-quiz", "a: b\n")
