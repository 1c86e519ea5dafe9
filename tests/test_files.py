"""Files are complete or absent, a lock has one holder at a time, and removed files are gone."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.errors import StorageError
from course.files import (
    link,
    locked,
    new_folder,
    open_lock,
    sweep,
    try_lock,
    wipe,
    write_atomic,
    write_pieces,
)


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


def test_pieces_become_one_file(tmp_path: Path) -> None:
    target = tmp_path / "new" / "a.txt"
    write_pieces(target, ["é", b"\x00", "x"])
    assert target.read_bytes() == "é".encode() + b"\x00x"
    assert [path.name for path in target.parent.iterdir()] == ["a.txt"]


def test_what_breaks_half_way_leaves_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "a.txt"
    target.write_text("old")

    def pieces() -> Iterator[str]:
        yield "new"
        raise RuntimeError("half way")

    with pytest.raises(RuntimeError):
        write_pieces(target, pieces())
    assert target.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["a.txt"]


def test_a_place_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StorageError) as caught:
        write_pieces(tmp_path / "file" / "a.txt", ["x"])
    assert "a.txt" in caught.value.what and caught.value.next_step


def killed_while_writing(target: Path) -> None:
    """A process that writes to it, and is killed in the middle."""
    code = (
        "import os, signal, sys; from pathlib import Path; from course.files import write_pieces\n"
        "def pieces():\n    yield 'half'\n    os.kill(os.getpid(), signal.SIGKILL)\n"
        f"write_pieces(Path({str(target)!r}), pieces())"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == -signal.SIGKILL


def test_what_a_killed_writer_left_is_swept_and_nothing_else(tmp_path: Path) -> None:
    target = tmp_path / "feedback" / "ada.md"
    killed_while_writing(target)
    write_pieces(target, ["whole"])
    (left,) = set(target.parent.iterdir()) - {target}
    others = (
        target.with_name(f".ada.md.{os.getpid()}-77aa.ros2course-part"),  # this process may be writing it
        target.with_name("a.99999999-77aa.ros2course-part"),
        target.with_name(".ros2course-part"),
    )
    for other in others:
        other.write_text("")
    sweep(target.parent)
    assert not left.exists()
    assert set(target.parent.iterdir()) == {target, *others}


def test_a_link_is_replaced_and_not_followed(tmp_path: Path) -> None:
    other = tmp_path / "other"
    other.write_text("keep")
    (tmp_path / "a.txt").symlink_to(other)
    write_pieces(tmp_path / "a.txt", ["x"])
    assert other.read_text() == "keep" and not (tmp_path / "a.txt").is_symlink()


def test_a_new_folder_is_whole_or_not_there(tmp_path: Path) -> None:
    half = tmp_path / ".a.99999999-77aa.ros2course-part"
    (half / "left by one that was killed").mkdir(parents=True)
    with pytest.raises(KeyboardInterrupt), new_folder(tmp_path / "a") as part:
        (part / "b").mkdir()
        raise KeyboardInterrupt
    assert list(tmp_path.iterdir()) == []
    with new_folder(tmp_path / "a") as part:
        (part / "b").mkdir()
    assert [path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*")] == ["a", "a/b"]


def test_a_link_is_put_in_place_of_another(tmp_path: Path) -> None:
    for target in ("one", "two"):
        link(tmp_path / "in/here", Path(target))
        assert (tmp_path / "in/here").readlink() == Path(target)
    assert len(list((tmp_path / "in").iterdir())) == 1


def test_a_lock_keeps_others_out_until_it_is_let_go(tmp_path: Path) -> None:
    file = tmp_path / "new/lock"
    for _ in range(2):
        with locked(file), pytest.raises(BlockingIOError), locked(file, wait=False):
            pass


def test_several_may_share_a_lock(tmp_path: Path) -> None:
    file = tmp_path / "lock"
    with locked(file, shared=True), locked(file, shared=True, wait=False):
        descriptor = open_lock(file)
        assert not try_lock(descriptor)
        assert try_lock(descriptor, shared=True)
        os.close(descriptor)


def test_a_lock_that_is_a_link_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "lock").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(OSError, match="symbolic links"), locked(tmp_path / "lock"):
        pass
    assert not (tmp_path / "elsewhere").exists()


def test_thousand_folders_deep_is_wiped(tmp_path: Path) -> None:
    top = tmp_path / "deep"
    top.mkdir()
    descriptor = os.open(top, os.O_RDONLY)
    for _ in range(1500):
        os.mkdir("d" * 20, dir_fd=descriptor)
        below = os.open("d" * 20, os.O_RDONLY, dir_fd=descriptor)
        os.close(descriptor)
        descriptor = below
    os.close(descriptor)
    wipe(top)
    assert not top.exists()


def test_what_is_not_there_is_wiped_without_a_word(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    wipe(tmp_path / "none")
    wipe(tmp_path / "-rf")
    assert capfd.readouterr() == ("", "")


def test_a_link_is_wiped_and_what_it_leads_to_stays_as_it_is(tmp_path: Path) -> None:
    shut, place = tmp_path / "shut", tmp_path / "place"
    (shut / "file").mkdir(parents=True)
    shut.chmod(0o500)
    place.symlink_to(shut)
    wipe(place)
    assert not place.is_symlink()
    assert (shut.stat().st_mode & 0o777, (shut / "file").is_dir()) == (0o500, True)


@pytest.mark.skipif(os.geteuid() == 0, reason="nothing is shut for root")
def test_a_folder_that_is_shut_is_wiped(tmp_path: Path) -> None:
    (tmp_path / "top/shut/in").mkdir(parents=True)
    (tmp_path / "top/shut").chmod(0)
    wipe(tmp_path / "top")
    assert not (tmp_path / "top").exists()
