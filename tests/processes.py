"""What a test starts, it ends: no process stays."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import psutil


def below() -> set[psutil.Process]:
    """All processes that this one has started, and those that these have."""
    return set(psutil.Process().children(recursive=True))


def words_of(process: psutil.Process) -> list[str]:
    """Its command line; empty for one that has just ended, as others that a test did not ask for may."""
    try:
        return process.cmdline()
    except psutil.Error:
        return []


@contextmanager
def none_stays() -> Iterator[set[psutil.Process]]:
    """Whatever is started meanwhile has ended at the end. Gives what was there before.

    Other tests of this process may have left helpers of theirs, as multiprocessing does.
    """
    before = below()
    yield before
    assert below() <= before
