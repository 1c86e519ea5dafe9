"""Files are whole or not there, and people's names are no paths."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.errors import StorageError
from course.report.gradebook.files import file_stem, sweep, write
from tests.report.gradebook import hostile


def test_pieces_become_one_file(tmp_path: Path) -> None:
    target = tmp_path / "new" / "a.txt"
    write(target, ["é", b"\x00", "x"])
    assert target.read_bytes() == "é".encode() + b"\x00x"
    assert [path.name for path in target.parent.iterdir()] == ["a.txt"]


def test_what_breaks_half_way_leaves_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "a.txt"
    target.write_text("old")

    def pieces() -> Iterator[str]:
        yield "new"
        raise RuntimeError("half way")

    with pytest.raises(RuntimeError):
        write(target, pieces())
    assert target.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["a.txt"]


def test_a_place_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StorageError) as caught:
        write(tmp_path / "file" / "a.txt", ["x"])
    assert "a.txt" in caught.value.what and caught.value.next_step


def killed_while_writing(target: Path) -> None:
    """A process that writes to it, and is killed in the middle."""
    code = (
        "import os, signal, sys; from pathlib import Path; from course.report.gradebook.files import write\n"
        "def pieces():\n    yield 'half'\n    os.kill(os.getpid(), signal.SIGKILL)\n"
        f"write(Path({str(target)!r}), pieces())"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == -signal.SIGKILL


def test_what_a_killed_writer_left_is_swept_and_nothing_else(tmp_path: Path) -> None:
    target = tmp_path / "feedback" / "ada.md"
    killed_while_writing(target)
    write(target, ["whole"])
    (left,) = set(target.parent.iterdir()) - {target}
    others = (
        target.with_name(f".ada.md.{os.getpid()}.part"),  # this process may be writing it
        target.with_name("a.99999999.part"),
        target.with_name(".part"),
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
    write(tmp_path / "a.txt", ["x"])
    assert other.read_text() == "keep" and not (tmp_path / "a.txt").is_symlink()


@pytest.mark.parametrize("name", ["ada", "ada.okafor", "2026-001", "A_b-c"])
def test_a_harmless_id_is_its_own_name(name: str) -> None:
    assert file_stem(name) == name


@pytest.mark.parametrize("text", [*hostile.TEXTS, "../../x", "..", ".", ".hidden", "a/b", "x" * 300, "-rf"])
def test_any_other_id_becomes_a_name(text: str) -> None:
    stem = file_stem(text)
    assert stem.isascii() and "/" not in stem and stem[0] not in ".-" and len(stem) <= 60


def test_different_people_have_different_names() -> None:
    people = ["a b", "a-b", "a/b", "", " ", "é", "è", file_stem("a b")]
    assert len({file_stem(name) for name in people}) == len(people)
