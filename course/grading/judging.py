"""Recordings judged by the checks of one grader module, in one pytest session. Needs no ROS."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable
from pathlib import Path

import pytest

from course.evidence.recording import Recording
from course.grading.channel import Judgement
from course.grading.plugin import JudgePlugin

_PYTEST = (
    # graders/conftest.py is for `pytest graders/`; no conftest has a say in a grading.
    "--noconftest",
    *("-p", "no:cacheprovider", "-p", "no:faulthandler"),
    # They collect all garbage, several times, to warn of what we do not ask.
    *("-p", "no:unraisableexception", "-p", "no:threadexception"),
    *("-q", "--tb=short", "--capture=no", "-W", "ignore"),
)


def judge(
    grader: Path,
    exercises: Collection[str],
    recordings: Iterable[Recording],
    tell: Callable[[Judgement], None],
    over: Callable[[], None] = lambda: None,
) -> None:
    """Judge recordings of these exercises, all of which have their checks in the module `grader`.

    recordings: each is taken when the one before has been judged, so that they need not be held all.
    tell: gets one judgement for each, in their order; with a fault where the grader cannot be run.
    over: called when pytest has ended; what it left of the recordings is told as a fault after that.
    pytest writes its progress to standard output.
    """
    plugin = JudgePlugin(exercises, recordings, tell)
    pytest.main([str(grader), f"--rootdir={grader.parent}", "-c", os.devnull, *_PYTEST], [plugin])
    over()
    plugin.finish()
