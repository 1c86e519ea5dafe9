"""A plan is written completely or not at all."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest

from course.authoring.write import Plan, carry_out
from course.errors import StorageError, UsageError


def files(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def test_all_of_it(tmp_path: Path) -> None:
    (tmp_path / "old").write_text("old")
    plan = Plan({tmp_path / "a/b": "new"}, {tmp_path / "old": "more"}, (tmp_path / "c/d",))
    made = carry_out(plan, tmp_path, "it")
    assert files(tmp_path) == ["a", "a/b", "c", "c/d", "old"]
    assert (tmp_path / "old").read_text() == "more"
    assert (made.name, made.new, made.changed) == ("it", (tmp_path / "a/b",), (tmp_path / "old",))


def test_nothing_when_one_is_there(tmp_path: Path) -> None:
    (tmp_path / "b").symlink_to("nowhere")
    with pytest.raises(UsageError, match="already exists, and is left as it is"):
        carry_out(Plan({tmp_path / "a": "", tmp_path / "b": ""}, {}, (tmp_path / "c",)), tmp_path, "it")
    assert files(tmp_path) == ["b"]


def test_nothing_when_the_disk_refuses(
    open_folder: Path, read_only: Callable[[Path], AbstractContextManager[None]]
) -> None:
    (open_folder / "free").mkdir()
    (open_folder / "free").chmod(0o777)
    (open_folder / "shut").mkdir()
    plan = Plan({open_folder / "free/a/b": "", open_folder / "shut/c": ""})
    with read_only(open_folder / "shut"), pytest.raises(StorageError) as caught:
        carry_out(plan, open_folder, "it")
    assert caught.value.next_step and "shut" in caught.value.what
    assert files(open_folder) == ["free", "shut"]
