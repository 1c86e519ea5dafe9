from pathlib import Path

import pytest

from course.rosenv.files import remove_half_made, write_atomic


def test_a_file_is_replaced_and_keeps_its_mode(tmp_path: Path) -> None:
    file, link = tmp_path / "a", tmp_path / "link"
    file.write_text("old")
    file.chmod(0o640)
    link.hardlink_to(file)
    assert write_atomic(file, "new")
    assert (file.read_text(), file.stat().st_mode & 0o777) == ("new", 0o640)
    assert link.read_text() == "old", "a hard link in pip's cache was changed too"


def test_the_same_text_is_not_written_again(tmp_path: Path) -> None:
    file = tmp_path / "a"
    assert write_atomic(file, "same")
    before = file.stat().st_ino
    assert not write_atomic(file, "same")
    assert file.stat().st_ino == before


def test_a_failed_write_leaves_the_old_file_and_nothing_beside(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "a"
    file.write_text("old")

    def full(self: Path, target: Path) -> Path:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(OSError, match="No space"):
        write_atomic(file, "new")
    assert file.read_text() == "old"
    assert list(tmp_path.iterdir()) == [file]


def test_what_a_killed_process_left_is_removed(tmp_path: Path) -> None:
    (tmp_path / ".a.ros2course-77").write_text("ha")
    (tmp_path / ".b.ros2course-77").write_text("of another file")
    remove_half_made(tmp_path / "a")
    assert list(tmp_path.iterdir()) == [tmp_path / ".b.ros2course-77"]
