"""What a test starts, it ends: no process stays."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import psutil


def below() -> set[psutil.Process]:
    """All processes that this one has started, and those that these have."""
    return set(psutil.Process().children(recursive=True))


@contextmanager
def none_stays() -> Iterator[set[psutil.Process]]:
    """Whatever is started meanwhile has ended at the end. Gives what was there before.

    Other tests of this process may have left helpers of theirs, as multiprocessing does.
    """
    before = below()
    yield before
    assert below() <= before
