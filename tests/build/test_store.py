"""Kept builds: complete or absent, made by one process at a time, pruned by last use."""

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
from course.build.store import digest_of, storage
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
    real = store_module.try_lock

    def try_late(descriptor: int, *, shared: bool = False) -> bool:
        for prune in prunings:  # the first time, between opening the file and locking it
            prune()
        return real(descriptor, shared=shared)

    monkeypatch.setattr(store_module, "try_lock", try_late)
    with Interrupt() as interrupt, store.locked(KEY, interrupt, lambda: None):
        assert lock.exists()


def test_pruning_removes_the_longest_unused(store: Store) -> None:
    keys = [str(number) * 32 for number in range(4)]
    for number, key in enumerate(keys):
        make(store, key, size=100_000, age=LONG_AGO + number)
    Store(store.root, keep_bytes=250_000).prune()
    assert [store.entry(key).is_complete() for key in keys] == [True, True, False, False]
    assert not (store.root / f"{keys[3]}.lock").exists()


def test_after_a_build_the_store_is_pruned_when_that_was_not_just_done(store: Store) -> None:
    full = Store(store.root, keep_bytes=0)
    make(store, KEY)
    full.prune_now_and_then()
    assert not store.entry(KEY).path.exists()
    make(store, KEY)
    full.prune_now_and_then()
    assert store.entry(KEY).is_complete()
    for when in (LONG_AGO, 2**33):  # clocks are set back
        os.utime(store.root / "pruned", (when, when))
        full.prune_now_and_then()
        assert not store.entry(KEY).path.exists()
        make(store, KEY)


@pytest.mark.parametrize("age", [0.0, LONG_AGO, -LONG_AGO])
def test_pruning_spares_what_is_in_use(store: Store, age: float) -> None:
    """However old it looks, because clocks are set forward and back."""
    for key in (KEY, "1" * 32):
        make(store, key, age=age)
    with Interrupt() as interrupt, store.in_use(KEY, interrupt), store.in_use(KEY, interrupt):
        Store(store.root, keep_bytes=0).prune()
        store.make_room(2**62)
        assert store.entry(KEY).is_complete()
        assert not store.entry("1" * 32).path.exists()
    Store(store.root, keep_bytes=0).prune()
    assert not store.entry(KEY).path.exists()
    assert list(store.root.iterdir()) == []


def test_room_is_not_made_of_what_is_held(store: Store) -> None:
    make(store, KEY)
    with Interrupt() as mine, store.locked(KEY, mine, never), Interrupt() as theirs:
        store.make_room(2**62)
        with store.in_use(KEY, theirs):
            assert store.entry(KEY).is_complete()


def test_room_is_made_by_what_was_used_least_lately(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    keys = [str(number) * 32 for number in range(4)]
    for number, key in enumerate(keys[:3]):
        make(store, key, size=100_000, age=number)
    failed = store.entry(keys[3])
    failed.begin()
    failed.give_up()
    left = [store.entry(key).path for key in keys]
    monkeypatch.setattr(Store, "free", lambda _: 100 * sum(not path.exists() for path in left))
    store.make_room(150)
    assert [path.exists() for path in left] == [True, True, False, False]


def test_where_there_is_room_no_entry_is_looked_at(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    """Builds of a class wait for each other here, and a store may have thousands of entries."""
    make(store, KEY)
    monkeypatch.setattr(Store, "_entries", lambda _: never())
    store.make_room(1)


def test_pruning_spares_what_is_being_made(store: Store) -> None:
    make(store, KEY, age=LONG_AGO)
    with Interrupt() as interrupt, store.locked(KEY, interrupt, never):
        Store(store.root, keep_bytes=0).prune()
        assert store.entry(KEY).marker.exists()


@pytest.mark.parametrize("when", [1, 2**33])
def test_pruning_removes_old_failures(store: Store, when: float) -> None:
    """Even failures from the future, because the clock was set back."""
    entry = store.entry(KEY)
    entry.begin()
    entry.give_up()
    store.prune()
    assert entry.path.exists()
    os.utime(entry.path, (when, when))
    store.prune()
    assert not entry.path.exists()


def test_looking_keeps_an_entry(store: Store) -> None:
    make(store, KEY, age=LONG_AGO)
    assert store.entry(KEY).is_complete()
    make(store, "1" * 32, age=LONG_AGO - 1)
    Store(store.root, keep_bytes=store.entry(KEY).size).prune()
    assert store.entry(KEY).is_complete()
    assert not store.entry("1" * 32).path.exists()


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
