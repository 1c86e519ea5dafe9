"""A kept build is used only while it is what was built."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from course.build.intact import digest_of


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    top = tmp_path / "install"
    (top / "small/lib").mkdir(parents=True)
    (top / "small/lib/node").write_text("print('hello')")
    (top / "small/lib/link").symlink_to("node")
    return top


CHANGES: dict[str, Callable[[Path], object]] = {
    "content": lambda top: (top / "small/lib/node").write_text("print('jello')"),
    "mode": lambda top: (top / "small/lib/node").chmod(0o755),
    "name": lambda top: (top / "small/lib/node").rename(top / "small/lib/other"),
    "new": lambda top: (top / "small/new").touch(),
    "gone": lambda top: (top / "small/lib/node").unlink(),
    "folder": lambda top: (top / "small/empty").mkdir(),
    "link": lambda top: anew(top / "small/lib/link").symlink_to("/etc/passwd"),
    "file for a link": lambda top: anew(top / "small/lib/link").write_text("node"),
}


def anew(path: Path) -> Path:
    path.unlink()
    return path


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_every_change_is_seen(tree: Path, change: Callable[[Path], object]) -> None:
    before = digest_of(tree)
    change(tree)
    assert digest_of(tree) != before


def test_times_do_not_matter(tree: Path) -> None:
    before = digest_of(tree)
    os.utime(tree / "small/lib/node", (1, 1))
    assert digest_of(tree) == before


def test_a_tampered_entry_is_built_anew(
    built: Callable[..., object], runs: Callable[[], list[str]], store: object
) -> None:
    first = built("small_node")
    marker = first.packages[0].prefix / "share/ament_index/resource_index/packages/small_node"  # type: ignore[attr-defined]
    marker.write_text("poison")
    second = built("small_node")
    assert runs() == ["small_node", "small_node"]
    assert marker.read_text() == ""
    assert not second.packages[0].cached  # type: ignore[attr-defined]
    built("small_node")
    assert len(runs()) == 2
