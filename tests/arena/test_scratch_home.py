"""The copy of the course home in which programs run."""

from __future__ import annotations

import os
import socket
import stat
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from course.arena import scratch_home
from course.arena.scratch_home import HOME, ScratchHome, lay_home
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


def test_texts_take_the_place_of_what_is_there(home: Path, tmp_path: Path) -> None:
    (home / "deep").write_text("a file where a folder should be")
    files = {"notes.txt": "other", "a_folder": "now a file", "deep/er/file": "new"}
    lay_home(home, read_entries(home, ("*", "a_folder")), tmp_path / "copy", files)
    found = {path: (tmp_path / "copy" / path).read_text() for path in files}
    assert found == files


# Files that programs put into their home are only read.


@pytest.fixture
def scratch(tmp_path: Path) -> ScratchHome:
    folder = tmp_path / "scratch"
    (folder / HOME / "src").mkdir(parents=True)
    (folder / HOME / "src/one.cpp").write_text("one")
    (tmp_path / "outside").mkdir()
    (tmp_path / "outside/secret.cpp").write_text("secret")
    return ScratchHome(folder)


def test_files_are_read_and_listed(scratch: ScratchHome, tmp_path: Path) -> None:
    (tmp_path / "scratch/home/src/deep").mkdir()
    (tmp_path / "scratch/home/src/deep/two.cpp").write_bytes(b"\xfftwo")
    assert (scratch.read("src/one.cpp"), scratch.read("src/one.cpp", 2)) == (b"one", b"on")
    assert scratch.text("src/deep/two.cpp") == "\ufffdtwo"
    assert scratch.matching("s*/*.cpp") == ("src/one.cpp",)
    assert scratch.below("src") == ("src/deep/two.cpp", "src/one.cpp")
    assert scratch.is_file("src/one.cpp") and scratch.is_folder("src") and scratch.is_folder("")
    assert not scratch.is_file("src") and not scratch.is_file("lost") and not scratch.is_folder("src/one.cpp")


@pytest.mark.parametrize("path", ["../../outside/secret.cpp", "src/../src/one.cpp", "/etc/passwd", "src"])
def test_no_path_leads_out(scratch: ScratchHome, path: str) -> None:
    assert scratch.read(path) is None
    assert not scratch.is_file(path)


@pytest.mark.parametrize("place", ["src/one.cpp", "src", ""])
def test_no_link_is_followed(scratch: ScratchHome, tmp_path: Path, place: str) -> None:
    """In place of the file, of its folder, and of the home itself."""
    path = tmp_path / "scratch/home" / place
    path.rename(tmp_path / "before")
    outside = tmp_path / "outside"
    (outside / "one.cpp").write_text("secret")
    (outside / "src").symlink_to(outside)
    path.symlink_to(outside / "secret.cpp" if place.endswith("cpp") else outside)
    assert scratch.read("src/one.cpp") is None
    assert scratch.read("src/secret.cpp") is None
    assert scratch.matching("src/*.cpp") == ()
    assert scratch.below("src") == ()
    assert not scratch.is_file("src/one.cpp")
    assert scratch.is_link(place)


def _fifo(path: Path) -> None:
    os.mkfifo(path)


def _socket(path: Path) -> None:
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(os.path.relpath(path))


def _huge(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(10**12)


@pytest.mark.parametrize(("make", "read"), [(_fifo, None), (_socket, None), (_huge, 100)])
def test_nothing_that_is_read_takes_time_or_memory(
    scratch: ScratchHome, tmp_path: Path, make: Callable[[Path], None], read: int | None
) -> None:
    (tmp_path / "scratch/home/src/one.cpp").unlink()
    make(tmp_path / "scratch/home/src/one.cpp")
    found = scratch.read("src/one.cpp", 100)
    assert (None if found is None else len(found)) == read


def test_a_link_that_comes_and_goes_is_never_followed(scratch: ScratchHome, tmp_path: Path) -> None:
    source, outside, over = tmp_path / "scratch/home/src", tmp_path / "outside", threading.Event()
    (outside / "one.cpp").write_text("secret")
    (tmp_path / "link").symlink_to(outside)

    def swap() -> None:
        while not over.is_set():
            source.rename(tmp_path / "kept")
            (tmp_path / "link").rename(source)
            source.rename(tmp_path / "link")
            (tmp_path / "kept").rename(source)

    thread = threading.Thread(target=swap)
    thread.start()
    try:
        seen = {scratch.read("src/one.cpp") for _ in range(5000)}
        listed = {file for _ in range(500) for file in scratch.matching("src/*")}
    finally:
        over.set()
        thread.join()
    assert seen <= {b"one", None}
    assert b"one" in seen
    assert listed <= {"src/one.cpp"}
