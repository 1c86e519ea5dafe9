"""How much a build has written, however it hides it."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from course.arena.sandbox.watchdog import DISK
from course.build import usage
from course.build.usage import FILES, MOST_DEPTH, Usage

MB = 1024 * 1024


def test_what_fits_is_fine(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(bytes(MB))
    assert Usage([tmp_path], 2 * MB).look() is None
    assert Usage([tmp_path / "missing"], 2 * MB).now() is None


def test_bytes_of_all_folders_count(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / name / "inner").mkdir(parents=True)
        (tmp_path / name / "inner/file").write_bytes(bytes(MB))
    assert Usage([tmp_path / "a"], 2 * MB).now() is None
    assert Usage([tmp_path / "a", tmp_path / "b"], 2 * MB).now() == DISK


def test_holes_are_no_bytes(tmp_path: Path) -> None:
    with (tmp_path / "hole").open("wb") as file:
        file.truncate(100 * MB)
    assert Usage([tmp_path], MB).now() is None


def test_links_are_not_followed(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "big").write_bytes(bytes(2 * MB))
    (tmp_path / "a/link").symlink_to(tmp_path / "big")
    (tmp_path / "a/up").symlink_to(tmp_path)
    assert Usage([tmp_path / "a"], MB).now() is None


def test_files_are_counted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for number in range(10):
        (tmp_path / str(number)).touch()
    monkeypatch.setattr(usage, "MOST_FILES", 10)
    assert Usage([tmp_path], MB).now() is None
    monkeypatch.setattr(usage, "MOST_FILES", 9)
    assert Usage([tmp_path], MB).now() == FILES


@pytest.mark.slow
@pytest.mark.parametrize(("name", "depth"), [("d", MOST_DEPTH + 1), ("d", 3000), ("n" * 250, 20)])
def test_nothing_hides_in_the_deep(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, depth: int
) -> None:
    monkeypatch.chdir(tmp_path)
    for _ in range(depth):
        Path(name).mkdir()
        os.chdir(name)
    assert Usage([tmp_path], MB).now() == FILES
    monkeypatch.chdir(tmp_path)
    subprocess.run(["rm", "-rf", name], check=True)  # pytest's own tidying is not up to it


def test_it_is_not_looked_at_all_the_time(tmp_path: Path) -> None:
    used = Usage([tmp_path], MB)
    assert used.look() is None
    (tmp_path / "a").write_bytes(bytes(2 * MB))
    assert used.look() is None
    assert used.now() == DISK
