"""A test ends what it starts: no process remains."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import psutil

GRADING = "course.grading.recording_process"
# By how many processes above it have the same command line.
_OF_RECORDING = {0: "fork server", 1: "guard", 2: "grading process"}
_PROGRAMS = {
    "worker": "course.batch.worker",
    "judge": "course.grading.judge.judging_process",
    "player": "course.arena.mystery_program",
    "measuring process": "arena/lateness_program.py",
    "Dask worker": "--multiprocessing-fork",
}


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
    """Everything that is started meanwhile must have ended at the end. Yields what was there before.

    Other tests of this process may have left helpers of theirs, as multiprocessing does.
    """
    before = below()
    yield before
    assert below() <= before


def left_in(temporary: Path) -> list[Path]:
    """What is left in a folder for temporary files after a kill -9.

    Python tries such a folder with a tiny file of a random name; a kill at that moment leaves it there.
    """
    return [path for path in temporary.iterdir() if path.is_dir() or path.read_bytes() not in {b"", b"blat"}]


def ours_below(top: psutil.Process) -> Iterator[tuple[str, psutil.Process]]:
    """Processes of the course's own below this one, with their kinds; none of a submission's."""
    for process in _all_below(top):
        with suppress(psutil.Error):
            if (kind := _kind(process)) is not None:
                yield kind, process


def _all_below(top: psutil.Process) -> list[psutil.Process]:
    try:
        return top.children(recursive=True)
    except psutil.Error:
        return []


def _kind(process: psutil.Process) -> str | None:
    words, parent = process.cmdline(), process.parent()
    above = parent.cmdline() if parent else []
    if words[:1] == ["/bin/sh"] and any("kill -KILL 0" in word for word in words[:3]):
        return "build's guard"
    if _is_bubblewrap(above):
        return f"{_layer(above)}'s first process"
    if _is_bubblewrap(words):
        return f"{_layer(words)}'s bubblewrap"
    if GRADING in words:
        return _OF_RECORDING.get(_forks_above(process), "launcher")
    return next((kind for kind, end in _PROGRAMS.items() if any(word.endswith(end) for word in words)), None)


def _forks_above(process: psutil.Process) -> int:
    return sum(GRADING in words_of(above) for above in process.parents())


def _is_bubblewrap(words: list[str]) -> bool:
    return bool(words) and words[0].rpartition("/")[2] == "bwrap"


def _layer(words: list[str]) -> str:
    if "--hostname" not in words:
        return "outer layer"
    return "build" if "--block-fd" in words else "sandbox"
