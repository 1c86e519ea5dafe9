"""Which files belong to a package, and their key."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from course.build import package_sources as sources
from course.build.package_sources import TooMuch, content_key, copy_sources, source_files


def key(folder: Path, home: Path, *needed: str, identity: str = "ros") -> str:
    return content_key(folder, home, needed, identity)


@pytest.fixture
def package(src: Path) -> Path:
    return src / "small_node"


def test_what_tools_leave_is_no_source(package: Path, home: Path) -> None:
    before = key(package, home)
    for left in ("build/x", "install/x", "log/x", "small_node/__pycache__/x.pyc", ".git/x", ".vscode/x"):
        (package / left).parent.mkdir(parents=True, exist_ok=True)
        (package / left).write_text("left")
    assert key(package, home) == before


def test_a_folder_called_log_deeper_down_is_a_source(package: Path, home: Path) -> None:
    before = key(package, home)
    (package / "small_node/log").mkdir()
    (package / "small_node/log/__init__.py").touch()
    assert key(package, home) != before


def test_the_key_stands_for_contents_names_and_modes(package: Path, home: Path) -> None:
    file = package / "small_node/talker.py"
    keys = [key(package, home)]
    file.write_text(file.read_text() + "\n")
    keys.append(key(package, home))
    file.chmod(0o755)
    keys.append(key(package, home))
    file.rename(file.with_name("speaker.py"))
    keys.append(key(package, home))
    assert len(set(keys)) == 4


def test_the_key_stands_for_what_it_was_built_with(package: Path, home: Path) -> None:
    keys = {key(package, home), key(package, home, "a"), key(package, home, identity="other")}
    assert len(keys) == 3
    assert key(package, home, "a", "b") == key(package, home, "b", "a")


def test_the_key_does_not_depend_on_place_or_time(package: Path, home: Path, tmp_path: Path) -> None:
    copy_sources(package, home, tmp_path / "copy")
    os.utime(package / "setup.py", (1, 1))
    assert key(tmp_path / "copy", tmp_path / "copy") == key(package, home)


def test_a_link_within_the_home_counts_as_what_it_leads_to(package: Path, home: Path, tmp_path: Path) -> None:
    (home / "shared.txt").write_text("shared")
    (home / "folder").mkdir()
    (home / "folder/inner.txt").write_text("inner")
    (package / "shared.txt").symlink_to(home / "shared.txt")
    (package / "folder").symlink_to("../../../folder")
    copy_sources(package, home, tmp_path / "copy")
    assert not (tmp_path / "copy/shared.txt").is_symlink()
    assert (tmp_path / "copy/folder/inner.txt").read_text() == "inner"
    assert key(tmp_path / "copy", tmp_path / "copy") == key(package, home)


def test_nothing_from_outside_the_home_is_copied(package: Path, home: Path, tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("secret")
    (package / "link").symlink_to(tmp_path / "secret")
    copy_sources(package, home, tmp_path / "copy")
    assert (tmp_path / "copy/link").is_symlink()


def test_links_in_circles_and_pipes_do_no_harm(package: Path, home: Path) -> None:
    (package / "up").symlink_to(package)
    (package / "a").mkdir()
    (package / "a/b").symlink_to(package / "c")
    (package / "c").mkdir()
    (package / "c/d").symlink_to(package / "a")
    os.mkfifo(package / "pipe")
    found = {file.name for file in source_files(package, home)}
    assert "setup.py" in found
    assert not any(name.startswith(("up", "pipe")) for name in found)


def test_an_environment_gone_astray_is_named(
    package: Path, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sources, "MOST_FILES", 20)
    (package / "my_venv").mkdir()
    for number in range(20):
        (package / f"my_venv/{number}").touch()
    with pytest.raises(TooMuch) as caught:
        source_files(package, home)
    assert caught.value.largest == "my_venv"
