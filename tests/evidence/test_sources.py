"""The learner's files as they are read: limited, and only files."""

from __future__ import annotations

import os
import subprocess
import tracemalloc
from pathlib import Path

import pytest

from course.evidence.sources import MAX_DEPTH, MAX_FILE, MAX_FILES, MAX_TOTAL, Sources, read_sources

MEGABYTE = 1024 * 1024


@pytest.fixture
def home(tmp_path: Path) -> Path:
    folder = tmp_path / "home"
    folder.mkdir()
    return folder


def put(home: Path, name: str, content: str | bytes = "text") -> Path:
    file = home / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(content.encode() if isinstance(content, str) else content)
    return file


def test_files_are_named_from_the_course_home(home: Path) -> None:
    put(home, "src/talk/talk/talker.py", "häufig\n")
    put(home, "src/talk/setup.py", "setup\n")
    put(home, "src/other/setup.py")
    found = read_sources(home, ["src/talk"])
    assert found == Sources({"src/talk/setup.py": "setup\n", "src/talk/talk/talker.py": "häufig\n"})
    # A file of the folder itself comes before those further down.
    assert list(found.files) == ["src/talk/setup.py", "src/talk/talk/talker.py"]


def test_a_root_may_be_a_file(home: Path) -> None:
    put(home, "src/notes.txt", "notes")
    assert read_sources(home, ["src/notes.txt", "src/lost.txt"]).files == {"src/notes.txt": "notes"}


def test_each_file_is_read_once_however_often_it_is_named(home: Path) -> None:
    put(home, "src/talk/picture.png", b"\x89PNG\xff")
    for number in range(MAX_FILES - 1):
        put(home, f"src/talk/{number:04}.py")
    found = read_sources(home, ["src/talk/picture.png", "src/talk/0000.py", "src/talk"])
    assert len(found.files) == MAX_FILES - 1
    assert found.others == ("src/talk/picture.png",)


@pytest.mark.parametrize("folder", ["__pycache__", "build", "install", "log", ".git", ".pytest_cache"])
def test_what_tools_leave_behind_is_left_out(home: Path, folder: str) -> None:
    put(home, f"src/talk/{folder}/file.py")
    put(home, f"src/talk/deeper/{folder}/file.py")
    assert read_sources(home, ["src/talk"]).names == ()


def test_what_is_no_text_is_named_only(home: Path) -> None:
    put(home, "src/binary", b"\x00\xff\xfe")
    put(home, "src/latin", "é".encode("latin-1"))
    put(home, "src/large", "x" * (MAX_FILE + 1))
    put(home, "src/text", "x" * MAX_FILE)
    found = read_sources(home, ["src"])
    assert list(found.files) == ["src/text"]
    assert found.others == ("src/binary", "src/large", "src/latin")
    assert found.names == ("src/binary", "src/large", "src/latin", "src/text")


def test_a_mark_at_the_beginning_is_no_text(home: Path) -> None:
    """Some editors write one. Python ignores it, and so must readers of the text."""
    put(home, "src/talker.py", b"\xef\xbb\xbfimport rclpy\r\n")
    assert read_sources(home, ["src"]).files == {"src/talker.py": "import rclpy\n"}


def test_pipes_and_sockets_do_not_hang(home: Path) -> None:
    put(home, "src/text")
    os.mkfifo(home / "src" / "pipe")
    os.mkfifo(home / "pipe")
    found = read_sources(home, ["src", "pipe"])
    assert (list(found.files), found.others) == (["src/text"], ("src/pipe",))


def test_devices_are_not_read(home: Path) -> None:
    put(home, "src/text")
    (home / "src" / "zero").symlink_to("/dev/zero")
    assert read_sources(home, ["src"]).names == ("src/text",)


# links


def test_a_link_within_the_course_home_counts_as_what_it_leads_to(home: Path) -> None:
    put(home, "shared/words.py", "words")
    (home / "src").mkdir()
    (home / "src" / "words.py").symlink_to("../shared/words.py")
    (home / "src" / "folder").symlink_to("../shared")
    found = read_sources(home, ["src"])
    assert found.files == {"src/words.py": "words", "src/folder/words.py": "words"}


def test_a_link_out_of_the_course_home_is_not_followed(home: Path, tmp_path: Path) -> None:
    put(tmp_path, "secret/key", "secret")
    put(home, "src/text")
    (home / "src" / "key").symlink_to(tmp_path / "secret" / "key")
    (home / "src" / "folder").symlink_to(tmp_path / "secret")
    (home / "src" / "up").symlink_to("../..")
    assert read_sources(home, ["src"]).names == ("src/text",)


def test_a_package_that_is_a_link_is_read_as_it_is_built(home: Path, tmp_path: Path) -> None:
    put(tmp_path, "repository/talk/package.xml", "<package/>")
    (home / "src").mkdir()
    (home / "src" / "talk").symlink_to(tmp_path / "repository" / "talk")
    assert read_sources(home, ["src/talk"], trusted=True).files == {"src/talk/package.xml": "<package/>"}
    for roots in (["src/talk"], ["src/talk/package.xml"], ["src"]):
        assert read_sources(home, roots).names == ()


@pytest.mark.parametrize("target", [".", "..", "itself", "nowhere"])
def test_links_in_a_circle_end(home: Path, target: str) -> None:
    put(home, "src/talk/text")
    (home / "src" / "talk" / "itself").symlink_to(target)
    assert list(read_sources(home, ["src"]).files) == ["src/talk/text"]


# bounds


def test_a_deep_tree_ends(home: Path) -> None:
    """Deeper than Python's stack."""
    here = os.open(home, os.O_RDONLY)
    for depth in range(1500):
        if depth == 3:
            os.close(os.open("file", os.O_CREAT | os.O_WRONLY, dir_fd=here))
        os.mkdir("d", dir_fd=here)
        below = os.open("d", os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = below
    os.close(here)
    try:
        assert read_sources(home, ["d"]).names == ("d/d/d/file",)
    finally:
        subprocess.run(["rm", "-r", str(home / "d")], check=True)  # too deep for pytest as well


def test_of_a_tree_that_is_just_deep_all_is_read(home: Path) -> None:
    put(home, "/".join(["d"] * MAX_DEPTH) + "/file")
    put(home, "/".join(["d"] * MAX_DEPTH) + "/d/file")
    assert len(read_sources(home, ["d"]).names) == 1


def test_the_number_of_files_is_bounded(home: Path) -> None:
    for number in range(MAX_FILES + 100):
        put(home, f"src/{number:04}", "")
    assert len(read_sources(home, ["src"]).names) == MAX_FILES


def test_the_amount_of_text_is_bounded(home: Path) -> None:
    for number in range(20):
        put(home, f"src/{number:02}", "x" * MAX_FILE)
    tracemalloc.start()
    found = read_sources(home, ["src"])
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert sum(map(len, found.files.values())) == MAX_TOTAL
    assert len(found.names) == 20
    assert peak < MAX_TOTAL + 2 * MEGABYTE


def test_a_huge_file_is_not_read(home: Path) -> None:
    with put(home, "src/huge").open("wb") as stream:
        stream.truncate(10**11)
    assert read_sources(home, ["src"]).others == ("src/huge",)


def test_a_name_that_is_not_utf8_can_be_written_as_json(home: Path) -> None:
    (home / "src").mkdir()
    Path(os.fsdecode(os.fsencode(home / "src") + b"/caf\xe9.py")).write_text("text")
    assert list(read_sources(home, ["src"]).files) == ["src/caf\ufffd.py"]


def test_what_is_not_there_is_nothing(home: Path) -> None:
    assert read_sources(home, ["src", "../..", "x/y/z"][:1]) == Sources()


def test_below_a_folder() -> None:
    sources = Sources({"src/talk/a": "1", "src/talker/b": "2", "src/talk/c/d": "3"}, ("src/talk/e", "src/f"))
    assert sources.below("src/talk/") == Sources({"src/talk/a": "1", "src/talk/c/d": "3"}, ("src/talk/e",))
