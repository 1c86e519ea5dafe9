"""How much a build has written, however it hides it."""

from __future__ import annotations

import os
import socket
import stat
import subprocess
from pathlib import Path

import pytest

from course.build import outputs
from course.build.outputs import FILES, LONGEST_PATH, MOST_DEPTH, DiskUsage, seal
from course.isolation.watchdog import DISK

MB = 1024 * 1024


def test_what_fits_is_fine(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(bytes(MB))
    assert DiskUsage([tmp_path], 2 * MB).look() is None
    assert DiskUsage([tmp_path / "missing"], 2 * MB).now() is None


def test_bytes_of_all_folders_count(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / name / "inner").mkdir(parents=True)
        (tmp_path / name / "inner/file").write_bytes(bytes(MB))
    assert DiskUsage([tmp_path / "a"], 2 * MB).now() is None
    assert DiskUsage([tmp_path / "a", tmp_path / "b"], 2 * MB).now() == DISK


def test_holes_are_no_bytes(tmp_path: Path) -> None:
    with (tmp_path / "hole").open("wb") as file:
        file.truncate(100 * MB)
    assert DiskUsage([tmp_path], MB).now() is None


def test_links_are_not_followed(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "big").write_bytes(bytes(2 * MB))
    (tmp_path / "a/link").symlink_to(tmp_path / "big")
    (tmp_path / "a/up").symlink_to(tmp_path)
    assert DiskUsage([tmp_path / "a"], MB).now() is None


def test_files_are_counted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for number in range(10):
        (tmp_path / str(number)).touch()
    monkeypatch.setattr(outputs, "MOST_FILES", 10)
    assert DiskUsage([tmp_path], MB).now() is None
    monkeypatch.setattr(outputs, "MOST_FILES", 9)
    assert DiskUsage([tmp_path], MB).now() == FILES


@pytest.mark.slow
@pytest.mark.parametrize(("name", "depth"), [("d", MOST_DEPTH + 1), ("d", 3000), ("n" * 250, 20)])
def test_nothing_hides_in_the_deep(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, depth: int
) -> None:
    monkeypatch.chdir(tmp_path)
    for _ in range(depth):
        Path(name).mkdir()
        os.chdir(name)
    assert DiskUsage([tmp_path], MB).now() == FILES
    monkeypatch.chdir(tmp_path)
    subprocess.run(["rm", "-rf", name], check=True)  # pytest's own cleanup cannot handle it


def test_it_is_not_looked_at_all_the_time(tmp_path: Path) -> None:
    used = DiskUsage([tmp_path], MB)
    assert used.look() is None
    (tmp_path / "a").write_bytes(bytes(2 * MB))
    assert used.look() is None
    assert used.now() == DISK


STRANGER = 2_000_009_999
needs_root = pytest.mark.skipif(os.geteuid() != 0, reason="not exercised here: only root gives files away")


@pytest.fixture
def top(tmp_path: Path) -> Path:
    folder = tmp_path / "entry/install"
    (folder / "inner").mkdir(parents=True)
    (folder / "inner/file").write_text("text")
    return folder


def test_what_is_right_stays(top: Path) -> None:
    (top / "program").touch(0o755)
    (top / "link").symlink_to("inner/file")
    assert seal(top, top.parent) is None
    assert (top / "link").is_symlink()
    assert (top / "link").read_text() == "text"
    assert stat.S_IMODE((top / "program").stat().st_mode) == 0o755


@needs_root
def test_owners_become_us(top: Path) -> None:
    (top / "link").symlink_to("inner/file")
    for path in (top, *top.rglob("*")):
        os.chown(path, STRANGER, STRANGER, follow_symlinks=False)
    seal(top, top.parent)
    assert {path.stat().st_uid for path in (top, *top.rglob("*"))} == {os.geteuid()}


@pytest.mark.parametrize("mode", [0o000, 0o200, 0o4755, 0o2755, 0o1777, 0o666])
def test_modes_become_plain(top: Path, mode: int) -> None:
    (top / "inner/file").chmod(mode)
    (top / "inner").chmod(mode)
    assert seal(top, top.parent) is None
    wanted = 0o755 if mode & stat.S_IXUSR else 0o644
    assert stat.S_IMODE((top / "inner").lstat().st_mode) == 0o755
    assert stat.S_IMODE((top / "inner/file").lstat().st_mode) == wanted


@pytest.mark.parametrize(
    "target", ["/etc/passwd", "../../outside", "/proc/self/environ", "link", "/dev/zero"]
)
def test_links_that_lead_out_are_removed(top: Path, target: str) -> None:
    (top / "link").symlink_to(target)
    flaw = seal(top, top.parent)
    assert flaw is not None
    assert (flaw.why, flaw.name) == ("link", "link")
    assert not os.path.lexists(top / "link")


def test_what_a_link_leads_to_keeps_its_mode(top: Path, tmp_path: Path) -> None:
    (tmp_path / "outside").touch(0o600)
    (top / "link").symlink_to(tmp_path / "outside")
    seal(top, top.parent)
    assert stat.S_IMODE((tmp_path / "outside").stat().st_mode) == 0o600


def test_a_top_that_is_a_link_is_not_entered(top: Path, tmp_path: Path) -> None:
    (tmp_path / "outside").mkdir(0o700)
    (top.parent / "other").symlink_to(tmp_path / "outside")
    assert seal(top.parent / "other", top.parent) is None
    assert stat.S_IMODE((tmp_path / "outside").stat().st_mode) == 0o700


def test_pipes_and_sockets_are_removed(top: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    os.mkfifo(top / "pipe")
    flaw = seal(top, top.parent)
    assert flaw is not None
    assert (flaw.why, flaw.name) == ("kind", "pipe")
    monkeypatch.chdir(top)  # a socket's path must be short
    with socket.socket(socket.AF_UNIX) as made:
        made.bind("socket")
    flaw = seal(top, top.parent)
    assert flaw is not None
    assert (flaw.why, flaw.name) == ("kind", "socket")
    assert [path.name for path in top.iterdir()] == ["inner"]


def test_too_many_and_too_deep(top: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (top / ("d/" * MOST_DEPTH)).mkdir(parents=True)
    assert seal(top, top.parent) is None
    (top / ("d/" * (MOST_DEPTH + 1))).mkdir()
    flaw = seal(top, top.parent)
    assert flaw is not None
    assert (flaw.why, flaw.name) == ("size", "d")
    monkeypatch.setattr(outputs, "MOST_FILES", 1)
    flaw = seal(top, top.parent)
    assert flaw is not None
    assert flaw.why == "size"


def test_paths_longer_than_the_kernel_takes(top: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(top)
    for _ in range(20):
        Path("n" * 250).mkdir()
        os.chdir("n" * 250)
    flaw = seal(top, top.parent)
    assert flaw is not None
    assert flaw.why == "size"
    assert len(flaw.name) <= LONGEST_PATH
