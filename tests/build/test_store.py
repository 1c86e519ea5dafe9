"""Kept builds: complete or absent, one maker at a time, pruned by last use."""

from __future__ import annotations

import errno
import os
import threading
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest

from course.build import Interrupt, Interrupted, Store
from course.build import store as store_module
from course.build.store import storage
from course.errors import StorageError

KEY = "0" * 32
LONG_AGO = 10**6


def make(store: Store, key: str, *, size: int = 1000, age: float = 0.0) -> None:
    entry = store.entry(key)
    entry.begin()
    (entry.install / "file").write_bytes(b"x" * size)
    entry.finish("package")
    stamp = entry.marker.stat().st_mtime - age
    os.utime(entry.marker, (stamp, stamp))


def never() -> None:
    raise AssertionError("nobody else holds the entry")


def test_an_entry_counts_when_it_is_finished(store: Store) -> None:
    entry = store.entry(KEY)
    entry.begin()
    assert not entry.is_complete()
    entry.finish("package")
    assert entry.is_complete()
    assert not entry.build.exists()


def test_a_half_made_entry_is_wiped(store: Store) -> None:
    entry = store.entry(KEY)
    entry.begin()
    (entry.install / "left").touch()
    entry.begin()
    assert list(entry.install.iterdir()) == []


def test_a_failed_build_keeps_its_log_only(store: Store) -> None:
    entry = store.entry(KEY)
    entry.begin()
    entry.log.write_text("why")
    entry.give_up()
    assert [path.name for path in entry.path.iterdir()] == ["log"]


def test_the_second_waits_for_the_first(store: Store) -> None:
    waiting = threading.Event()
    order: list[str] = []

    def second() -> None:
        with Interrupt() as interrupt, store.locked(KEY, interrupt, waiting.set):
            order.append("second")

    thread = threading.Thread(target=second)
    with Interrupt() as interrupt, store.locked(KEY, interrupt, never):
        thread.start()
        assert waiting.wait(10)
        order.append("first")
    thread.join(10)
    assert order == ["first", "second"]


def test_waiting_can_be_called_off(store: Store) -> None:
    with (
        Interrupt() as mine,
        store.locked(KEY, mine, never),
        Interrupt() as theirs,
        pytest.raises(Interrupted),
        store.locked(KEY, theirs, theirs.set),
    ):
        pass


def test_a_lock_file_that_was_just_pruned_is_not_trusted(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    lock = store.root / f"{KEY}.lock"
    prunings = iter([lock.unlink])
    real = store_module._try

    def try_late(descriptor: int) -> bool:
        for prune in prunings:  # the first time, between opening the file and locking it
            prune()
        return real(descriptor)

    monkeypatch.setattr(store_module, "_try", try_late)
    with Interrupt() as interrupt, store.locked(KEY, interrupt, lambda: None):
        assert lock.exists()


def test_pruning_removes_the_longest_unused(store: Store) -> None:
    keys = [str(number) * 32 for number in range(4)]
    for number, key in enumerate(keys):
        make(store, key, size=100_000, age=LONG_AGO + number)
    store.prune(keep_bytes=250_000)
    assert [store.entry(key).is_complete() for key in keys] == [True, True, False, False]
    assert not (store.root / f"{keys[3]}.lock").exists()


def test_pruning_spares_what_is_in_use(store: Store) -> None:
    make(store, KEY)
    store.prune(keep_bytes=0)
    assert store.entry(KEY).is_complete()


def test_pruning_spares_what_is_being_made(store: Store) -> None:
    make(store, KEY, age=LONG_AGO)
    with Interrupt() as interrupt, store.locked(KEY, interrupt, never):
        store.prune(keep_bytes=0)
        assert store.entry(KEY).marker.exists()


def test_pruning_removes_old_failures(store: Store) -> None:
    entry = store.entry(KEY)
    entry.begin()
    entry.give_up()
    store.prune()
    assert entry.path.exists()
    os.utime(entry.path, (1, 1))
    store.prune()
    assert not entry.path.exists()


def test_looking_keeps_an_entry(store: Store) -> None:
    make(store, KEY, age=LONG_AGO)
    assert store.entry(KEY).is_complete()
    store.prune(keep_bytes=0)
    assert store.entry(KEY).is_complete()


def test_a_read_only_store_still_serves(
    open_folder: Path, read_only: Callable[[Path], AbstractContextManager[None]]
) -> None:
    store = Store(open_folder / "store")
    make(store, KEY)
    with read_only(open_folder / "store"):
        assert store.entry(KEY).is_complete()
        with pytest.raises(StorageError), Interrupt() as interrupt, store.locked("1" * 32, interrupt, never):
            pass


def test_a_full_disk_is_said_so(tmp_path: Path) -> None:
    with pytest.raises(StorageError, match="disk is full"), storage(tmp_path):
        raise OSError(errno.ENOSPC, "No space left on device")


def test_the_usual_place_is_the_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS2COURSE_CACHE", str(tmp_path))
    assert Store().root == tmp_path / "builds"
