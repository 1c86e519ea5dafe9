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
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from socket import socket

from course.arena.arena import open_arena
from course.arena.containment import PROGRAMS
from course.arena.leftovers import adopt_orphans, end_descendants
from course.arena.sandbox.control_groups import cpu_seconds
from course.arena.sandbox.launcher import fork_launcher
from course.arena.sandbox.limits import for_sanitizers
from course.arena.sandbox.linux import PR_SET_DUMPABLE, process_control
from course.arena.sandbox.sandbox import open_sandbox
from course.arena.sandbox.watchdog import most_of
from course.arena.scratch_home import lay_home
from course.arena.starting import Starter, start_here
from course.errors import MissingHere, StorageError
from course.evidence.events import Acted, Drawn, Event, LimitReached
from course.evidence.home_files import read_entries
from course.evidence.mcap_file import save
from course.evidence.recording import Recording
from course.evidence.sources import read_sources
from course.evidence.timeline import Timeline
from course.feedback import Feedback
from course.grading.channel import Channel, Judgement
from course.grading.job import Job, from_line
from course.grading.lag import measured_lag
from course.grading.load import load_grader
from course.grading.outcome import our_error
from course.grading.scenario_digest import scenario_digest

_JUDGING = "course.grading.judging"


def main() -> int:
    _listen_to_signals()
    launcher = fork_launcher()  # before there is a second thread
    process_control(PR_SET_DUMPABLE, 0)  # where nothing else keeps them apart, no program reads our memory
    channel = Channel(int(sys.argv[1]))
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
        channel.judgement(_grade(job, channel, folder, launcher))
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


def _grade(job: Job, channel: Channel, folder: Path, launcher: socket) -> Judgement:
    try:
        with measured_lag() as lag:
            recording = _record(job, channel, folder, launcher)
    except MissingHere as error:
        return Judgement((), 0.0, Feedback(error.what, advice=error.next_step), missing=True)
    except Exception as error:  # noqa: BLE001 - whatever a scenario runs into is our error, kept and shown
        return Judgement((), 0.0, our_error(error))
    used = cpu_seconds([Path(group) for group in job.sandbox.control_groups]) if job.sandbox else 0.0
    kept = _keep(recording, job, channel)
    judgement = (
        Judgement((), recording.duration, judged=False) if kept and not job.judge else _judge(recording, job)
    )
    return replace(judgement, lag=lag.worst, cpu=used)


def _judge(recording: Recording, job: Job) -> Judgement:
    from course.grading.judging import judge  # pytest takes a while, and was loaded meanwhile: see `_record`

    judgements: list[Judgement] = []
    judge(Path(job.grader), {job.exercise}, [recording], judgements.append)
    return judgements[0]


def _keep(recording: Recording, job: Job, channel: Channel) -> bool:
    """Save the evidence; that there is no room for it is no reason to withhold the verdict."""
    if job.evidence is None:
        return False
    began = time.time_ns() - round(recording.duration * 1e9)
    scenario = scenario_digest(Path(job.grader), job.exercise, job.looks_at)
    try:
        save(replace(recording, scenario=scenario), Path(job.evidence), began_ns=began)
    except StorageError as error:
        channel.progress(error.what)
        return False
    return True


def _record(job: Job, channel: Channel, folder: Path, launcher: socket) -> Recording:
    """Run the scenario, unless nothing was built that it could run."""
    grader = load_grader(Path(job.grader), job.exercise)
    timeline = Timeline()
    home = Path(job.home)
    looked_at = read_entries(home, job.looks_at)
    texts = (entry.path for entry in looked_at if entry.kind == "file")
    sources = read_sources(home, (*job.roots, *texts), trusted=job.local)
    definitions: dict[str, str] = {}
    duration = 0.0
    for event in _told(job):
        timeline.add(event)
    if grader.scenario_function is not None and job.packages.failure is None:
        channel.progress("watching your program")
        lay_home(home, (*looked_at, *read_entries(home, (".bashrc",))), folder / PROGRAMS / "home")
        with (
            _confined(job, grader.sanitizers, folder, launcher, timeline) as confined,
            open_arena(
                timeline,
                job.packages,
                job.environment,
                job.python,
                folder / PROGRAMS,
                plain=job.plain,
                ros=grader.ros,
                learners_home=home,
                ours=_ours(folder),
                confined=confined,
            ) as arena,
        ):
            if job.judge:
                # pytest judges afterwards; it loads while the scenario waits for the learner's program.
                threading.Thread(target=importlib.import_module, args=(_JUDGING,), daemon=True).start()
            try:
                grader.scenario_function(arena)
            except Exception:
                # Whatever a scenario runs into when all programs were killed: the recording says why.
                if not any(timeline.of(LimitReached)):
                    raise
            duration = timeline.now()
            definitions = arena.definitions
    return Recording(
        job.exercise, timeline.events(), definitions, sources, job.packages, duration, looked_at, job.local
    )


def _ours(folder: Path) -> Path:
    """For what the learner's programs may read and not write."""
    ours = folder / "ours"
    ours.mkdir(exist_ok=True, parents=True)
    return ours


@contextlib.contextmanager
def _confined(
    job: Job, sanitizers: bool, folder: Path, launcher: socket, timeline: Timeline
) -> Iterator[Starter]:
    """What starts the learner's programs."""
    if job.sandbox is None:
        yield start_here
        return
    limits = for_sanitizers(job.sandbox.limits) if sanitizers else job.sandbox.limits
    plan = replace(job.sandbox, shown=(*job.sandbox.shown, str(_ours(folder))), limits=limits)

    def note(limit: str) -> None:
        timeline.add(LimitReached(timeline.now(), limit, most_of(plan.limits, limit)))

    with open_sandbox(plan, launcher, folder / PROGRAMS, note) as sandbox:
        yield sandbox


def _told(job: Job) -> Iterator[Event]:
    """What was known of a mystery before the recording began."""
    if job.seed is not None:
        yield Drawn(0.0, job.seed)
    yield from (Acted(0.0, name, detail) for name, detail in job.acts)


if __name__ == "__main__":
    raise SystemExit(main())
