"""The grading process: runs one scenario and its checks, apart from everything else.

Started by `grading.supervisor` with two arguments: the descriptor of the result pipe, and a
folder for scratch files. The job comes as one line on standard input, which stays open: when
it closes, the parent is gone, and this process ends all that it started and itself.
"""

from __future__ import annotations

import contextlib
import importlib
import os
import shutil
import signal
import sys
import threading
import time
from pathlib import Path

from course.arena.arena import open_arena
from course.arena.leftovers import adopt_orphans, end_descendants
from course.errors import StorageError
from course.evidence.mcap_file import save
from course.evidence.recording import Recording
from course.evidence.sources import read_sources
from course.evidence.timeline import Timeline
from course.feedback import Feedback
from course.grading.channel import Channel, Judgement
from course.grading.job import Job, from_line
from course.grading.load import load_grader
from course.grading.outcome import our_error

_PYTEST = (
    # graders/conftest.py is for `pytest graders/`; no conftest has a say in a grading.
    "--noconftest",
    *("-p", "no:cacheprovider", "-p", "no:faulthandler"),
    *("-q", "--tb=short", "--capture=no", "-W", "ignore"),
)


def main() -> int:
    channel = Channel(int(sys.argv[1]))
    _listen_to_signals()
    adopt_orphans()
    # While the job is still being made. What fails here fails again, and is told, when it is used.
    with contextlib.suppress(ImportError):
        importlib.import_module("course.evidence.recorder")
    line = sys.stdin.readline()
    if not line:
        return 0  # the parent changed its mind
    job = from_line(line)
    folder = Path(sys.argv[2])
    threading.Thread(target=_end_with_parent, args=(folder,), daemon=True).start()
    try:
        channel.judgement(_grade(job, channel, folder))
    finally:
        end_descendants()
        shutil.rmtree(folder, ignore_errors=True)
    sys.stdout.flush()
    # Threads of the middleware may take their time to end; there is nothing left to wait for.
    os._exit(0)  # noqa: TID251 - see above; everything has been cleaned up


def _listen_to_signals() -> None:
    """As in front of a terminal, for us and all that we start.

    Who was started in the background has inherited to ignore SIGINT, and would hand that on
    to the learner's programs: none of them would hear Ctrl+C.
    """
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def _end_with_parent(folder: Path) -> None:
    sys.stdin.read()
    end_descendants()
    shutil.rmtree(folder, ignore_errors=True)
    os._exit(1)  # noqa: TID251 - the main thread may be anywhere; nothing is left to clean up


def _grade(job: Job, channel: Channel, folder: Path) -> Judgement:
    try:
        recording = _record(job, channel, folder)
    except Exception as error:  # noqa: BLE001 - whatever a scenario runs into is our error, kept and shown
        return Judgement((), 0.0, our_error(error))
    _keep(recording, job, channel)
    return _judge(recording, job)


def _judge(recording: Recording, job: Job) -> Judgement:
    import pytest

    from course.grading.plugin import JudgePlugin

    plugin = JudgePlugin(recording)
    pytest.main([job.grader, f"--rootdir={Path(job.grader).parent}", "-c", os.devnull, *_PYTEST], [plugin])
    fault = None
    if plugin.faults or not plugin.results:
        lines = "\n".join(plugin.faults).splitlines()
        fault = Feedback(summary=f"The grader of {job.exercise} cannot be run.", details=tuple(lines[-12:]))
    return Judgement(tuple(plugin.results.values()), recording.duration, fault)


def _keep(recording: Recording, job: Job, channel: Channel) -> None:
    """Save the evidence; that there is no room for it is no reason to withhold the verdict."""
    if job.evidence is None:
        return
    began = time.time_ns() - round(recording.duration * 1e9)
    try:
        save(recording, Path(job.evidence), began_ns=began)
    except StorageError as error:
        channel.progress(error.what)


def _record(job: Job, channel: Channel, folder: Path) -> Recording:
    """Run the scenario, unless nothing was built that it could run."""
    grader = load_grader(Path(job.grader), job.exercise)
    timeline = Timeline()
    sources = read_sources(Path(job.home), job.roots)
    definitions: dict[str, str] = {}
    duration = 0.0
    if grader.scenario_function is not None and job.packages.failure is None:
        channel.progress("watching your program")
        with open_arena(timeline, job.packages, job.environment, job.python, folder) as arena:
            # pytest judges afterwards; it loads while the scenario waits for the learner's program.
            threading.Thread(target=importlib.import_module, args=("pytest",), daemon=True).start()
            grader.scenario_function(arena)
            duration = timeline.now()
            definitions = arena.definitions
    return Recording(job.exercise, timeline.events(), definitions, sources, job.packages, duration)


if __name__ == "__main__":
    raise SystemExit(main())
