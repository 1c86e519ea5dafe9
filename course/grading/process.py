"""The grading process: runs one scenario and its checks, apart from everything else.

Started by `grading.supervisor` with two arguments: the descriptor of the result pipe, and a
folder for scratch files. The job comes as one line on standard input, which stays open: when
it closes, the parent is gone, and this process ends all that it started and itself.
"""

from __future__ import annotations

import os
import shutil
import sys
import threading
import time
from pathlib import Path

import pytest

from course.arena.arena import open_arena
from course.arena.leftovers import adopt_orphans, end_descendants
from course.errors import StorageError
from course.evidence.mcap_file import save
from course.evidence.recording import Recording
from course.evidence.sources import read_sources
from course.evidence.timeline import Timeline
from course.feedback import Feedback
from course.grading.author import Grader
from course.grading.channel import Channel, Judgement
from course.grading.job import Job, from_line
from course.grading.outcome import our_error
from course.grading.plugin import JudgePlugin

_PYTEST = (
    # graders/conftest.py is for `pytest graders/`; no conftest has a say in a grading.
    "--noconftest",
    *("-p", "no:cacheprovider", "-p", "no:faulthandler"),
    *("-q", "--tb=short", "--capture=no", "-W", "ignore"),
)


def main() -> int:
    channel = Channel(int(sys.argv[1]))
    adopt_orphans()
    line = sys.stdin.readline()
    if not line:
        return 0  # the parent changed its mind
    job = from_line(line)
    folder = Path(sys.argv[2]) / "arena"
    threading.Thread(target=_end_with_parent, args=(folder,), daemon=True).start()
    try:
        channel.judgement(_judge(job, channel, folder))
    finally:
        end_descendants()
        shutil.rmtree(folder, ignore_errors=True)
    sys.stdout.flush()
    # Threads of the middleware may take their time to end; there is nothing left to wait for.
    os._exit(0)  # noqa: TID251 - see above; everything has been cleaned up


def _end_with_parent(folder: Path) -> None:
    sys.stdin.read()
    end_descendants()
    shutil.rmtree(folder, ignore_errors=True)
    os._exit(1)  # noqa: TID251 - the main thread may be anywhere; nothing is left to clean up


def _judge(job: Job, channel: Channel, folder: Path) -> Judgement:
    took: list[float] = []

    def provide(grader: Grader) -> Recording:
        recording = _record(job, grader, channel, folder)
        took.append(recording.duration)
        _keep(recording, job, channel)
        return recording

    plugin = JudgePlugin(job.exercise, provide)
    pytest.main([job.grader, f"--rootdir={Path(job.grader).parent}", "-c", os.devnull, *_PYTEST], [plugin])
    return Judgement(tuple(plugin.results.values()), sum(took), _fault(plugin))


def _keep(recording: Recording, job: Job, channel: Channel) -> None:
    """Save the evidence; that there is no room for it is no reason to withhold the verdict."""
    if job.evidence is None:
        return
    began = time.time_ns() - round(recording.duration * 1e9)
    try:
        save(recording, Path(job.evidence), began_ns=began)
    except StorageError as error:
        channel.progress(error.what)


def _fault(plugin: JudgePlugin) -> Feedback | None:
    if plugin.scenario_error is not None:
        return our_error(plugin.scenario_error)
    if plugin.faults:
        lines = plugin.faults[0].splitlines()
        return Feedback(summary="The grader module cannot be loaded.", details=tuple(lines[-12:]))
    if not plugin.results:
        return Feedback(summary=f"No grader judges {plugin.exercise}.")
    return None


def _record(job: Job, grader: Grader, channel: Channel, folder: Path) -> Recording:
    """Run the scenario, unless nothing was built that it could run."""
    timeline = Timeline()
    sources = read_sources(Path(job.home), job.roots)
    definitions: dict[str, str] = {}
    duration = 0.0
    if grader.scenario_function is not None and job.packages.failure is None:
        channel.progress("watching your program")
        with open_arena(timeline, job.packages, job.environment, job.python, folder) as arena:
            grader.scenario_function(arena)
            duration = timeline.now()
            definitions = arena.definitions
    return Recording(job.exercise, timeline.events(), definitions, sources, job.packages, duration)


if __name__ == "__main__":
    raise SystemExit(main())
