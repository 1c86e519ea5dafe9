"""The copy of the course home that programs run in."""

from __future__ import annotations

import stat
from pathlib import Path

import pytest

from course.arena import scratch_home
from course.arena.scratch_home import lay_home
from course.evidence.home_files import read_entries


@pytest.fixture
def home(tmp_path: Path) -> Path:
    home = tmp_path / "home"
    (home / "a_folder").mkdir(parents=True)
    (home / "a_folder/run.sh").write_text("echo hi")
    (home / "a_folder/run.sh").chmod(0o754)
    (home / "notes.txt").write_text("notes")
    return home


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


def test_what_was_looked_at_is_copied_with_its_modes(home: Path, tmp_path: Path) -> None:
    (home / "a_folder").chmod(0o555)
    lay_home(home, read_entries(home, ("a_folder",)), tmp_path / "copy")
    assert (tmp_path / "copy/a_folder/run.sh").read_text() == "echo hi"
    assert mode(tmp_path / "copy/a_folder/run.sh") == 0o754
    assert not (tmp_path / "copy/notes.txt").exists()
    (home / "a_folder").chmod(0o755)


def test_a_file_without_its_folder(home: Path, tmp_path: Path) -> None:
    lay_home(home, read_entries(home, ("a_folder/run.sh",)), tmp_path / "copy")
    assert (tmp_path / "copy/a_folder/run.sh").exists()


def test_links_are_not_carried_over(home: Path, tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("secret")
    (home / "out").symlink_to(tmp_path / "secret")
    (home / "way").symlink_to("notes.txt")
    lay_home(home, read_entries(home, ("*",)), tmp_path / "copy")
    assert not (tmp_path / "copy/out").exists()
    assert not (tmp_path / "copy/way").is_symlink()
    assert (tmp_path / "copy/way").read_text() == "notes"


def test_what_is_huge_is_left_out(home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(scratch_home, "MAX_FILE", 6)
    lay_home(home, read_entries(home, ("a_folder/run.sh", "notes.txt")), tmp_path / "copy")
    assert not (tmp_path / "copy/a_folder/run.sh").exists()
    assert (tmp_path / "copy/notes.txt").exists()


def test_what_was_taken_away_meanwhile_is_no_fault(home: Path, tmp_path: Path) -> None:
    entries = read_entries(home, ("*",))
    (home / "notes.txt").unlink()
    lay_home(home, entries, tmp_path / "copy")
    assert (tmp_path / "copy/a_folder").is_dir()
