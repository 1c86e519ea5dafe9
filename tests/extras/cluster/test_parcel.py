"""Homes are sent unchanged, up to a limit."""

from __future__ import annotations

import io
import tarfile
from pathlib import Path

import pytest

from course.home.opening import Refused
from course_cluster import parcel


def test_a_home_arrives_as_it_was(tmp_path: Path) -> None:
    home = tmp_path / "home"
    for name, text in (
        ("ros2_tutorial_workspace/src/a package/ünïcode.py", "print()\n"),
        ("answers/02-editor-quiz.yaml", "a: b\n"),
        (".ros2course/home.json", "{}"),
        ("-rf", ""),
        ("zeros", "\0" * 30_000_000),
    ):
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        (home / name).write_text(text, encoding="utf-8")
    (home / "-rf").chmod(0o755)
    (home / "empty").mkdir()
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    there = parcel.unpack(parcel.pack(home), scratch)
    assert _tree(there) == _tree(home)
    assert [*scratch.iterdir()] == [there]


def test_what_is_too_large_does_not_travel(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "home").mkdir()
    (tmp_path / "home" / "noise").write_bytes(bytes(range(256)) * 40)
    monkeypatch.setattr(parcel, "LARGEST_HOME", 100)
    with pytest.raises(Refused, match="too large"):
        parcel.pack(tmp_path / "home")


def test_bytes_that_lead_elsewhere_are_not_followed(tmp_path: Path) -> None:
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w:gz") as archive:
        archive.addfile(tarfile.TarInfo("../out"))
        archive.addfile(tarfile.TarInfo("in"))
    there = parcel.unpack(packed.getvalue(), scratch)
    assert [path.name for path in there.iterdir()] == ["in"]
    assert not (scratch / "out").exists()


def test_bytes_that_are_no_archive_are_refused(tmp_path: Path) -> None:
    with pytest.raises(Refused):
        parcel.unpack(b"\x80\x05cposix\nsystem\n", tmp_path)


def test_a_recording_travels_unless_it_is_too_large(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    recording = tmp_path / "recording.mcap"
    assert parcel.evidence_of(recording) is None
    recording.write_bytes(b"12345")
    assert parcel.evidence_of(recording) == b"12345"
    monkeypatch.setattr(parcel, "LARGEST_EVIDENCE", 4)
    assert parcel.evidence_of(recording) is None


def _tree(folder: Path) -> dict[str, tuple[bytes | None, bool]]:
    return {
        str(path.relative_to(folder)): (
            path.read_bytes() if path.is_file() else None,
            bool(path.stat().st_mode & 0o100),
        )
        for path in folder.rglob("*")
    }
