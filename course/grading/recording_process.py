"""The recording process: runs one scenario, isolated from everything else. Checks are judged elsewhere.

`grading.supervisor` starts one process that loads everything, and asks it for forks over a socket: loading
takes most of a recording's CPU time. That process starts no thread and no node, and never sees a task. Each
fork gets its own environment, enters its own namespaces, and records once. It cannot affect later forks.

A fork's arguments: the descriptor of the result pipe, that of the file for the recording, and a folder for
scratch files. To look for a cause, there is one more: the descriptor of the recording that was judged. The
new recording is then a copy of it with notes on this run. The task comes as one line on standard input, which
stays open. When it closes, the parent is gone, and this process ends everything that it started and itself.
"""

from __future__ import annotations

import contextlib
import ctypes
import gc
import importlib
import json
import os
import shutil
import signal
import socket
import sys
import threading
import time
import traceback
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from itertools import islice
from pathlib import Path, PurePosixPath
from typing import NoReturn

import course
from course.arena.arena import open_arena
from course.arena.home_programs import Surroundings
from course.arena.scratch_home import HOME, Place, ScratchHome, lay_home, place_without_sandbox
from course.child import end_with_parent
from course.errors import DamagedData, MissingHere
from course.evidence.home_files import HomeEntry, read_entries
from course.evidence.mcap_file import read, write
from course.evidence.recording import Recording
from course.evidence.sources import Sources, read_sources
from course.evidence.timeline import Timeline
from course.explain.cpp_crashes import crash_notes
from course.files import wipe
from course.grading.author import Grader
from course.grading.load import load_grader
from course.grading.outcomes import doubt_about, our_error
from course.grading.protocol import Fork, RecordingOutcome, RecordingTask, Stage, tell
from course.grading.scenario_digest import scenario_digest
from course.isolation.identity import cpu_seconds
from course.isolation.isolation_plan import PROGRAMS, IsolationPlan, for_sanitizers
from course.isolation.launcher import PACKET, fork_launcher
from course.isolation.linux import PR_SET_DUMPABLE, enter_namespace, opened, process_control
from course.isolation.none import adopt_orphans, end_descendants
from course.isolation.sandbox import Sandbox, open_sandbox
from course.isolation.watchdog import most_of
from course.model import codec, replace
from course.model.events import Acted, Drawn, Event, LimitReached, Observed
from course.model.feedback import Feedback

# Needed by scenarios, the recorder, and saving. An import that fails fails again, and is reported, on use.
_NEEDED = ("course.evidence.recorder", "course.api", "mcap.writer")
_NAMESPACES = ("user", "mnt", "ipc", "net", "pid")
_MOST_DESCRIPTORS = 5
# In the programs' home: their notes when we look for a cause. Limits on files, characters, and frames.
_NOTES, _REPORTS = ".ros2course-notes", ".ros2course-report"
_MOST_PROGRAMS, _MOST_NOTES, _MOST_FRAMES = 20, 200_000, 50
_OBSERVER = Path(course.__file__).parent / "arena/observer_program.py"


def main() -> int:
    """Fork a recording process for each request, until the socket is closed."""
    _listen_to_signals()
    process_control(PR_SET_DUMPABLE, 0)  # no program may read our memory, even if nothing isolates it
    for module in _NEEDED:
        with contextlib.suppress(ImportError):
            importlib.import_module(module)
    if recorder := sys.modules.get("course.evidence.recorder"):
        recorder.load_middleware()
    gc.freeze()  # otherwise, garbage collection would copy memory that forks share
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # the kernel cleans up after forks
    with socket.socket(fileno=int(sys.argv[1])) as link:
        while True:
            data, descriptors, _, _ = socket.recv_fds(link, PACKET, _MOST_DESCRIPTORS)
            if not data:
                return 0
            pid = os.fork()
            if pid == 0:
                link.close()
                _guard(codec.from_json(data, Fork, "the request"), descriptors)
            watched = os.pidfd_open(pid)
            socket.send_fds(link, [b"forked"], [watched])
            for descriptor in (*descriptors, watched):
                os.close(descriptor)


def _guard(fork: Fork, descriptors: Sequence[int]) -> NoReturn:
    """Start the recording process, and report if it ended with an error. If we are killed, so is it.

    Only a child can be in a different pid namespace. The result pipe closes when both have ended.
    """
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    os.setsid()  # Ctrl+C in the terminal goes to our parent, which ends everything in order
    task, log, *others = descriptors
    for number, descriptor in enumerate((task, log, log)):
        os.dup2(descriptor, number)
    os.close(task)
    os.close(log)
    for descriptor in others:
        os.set_inheritable(descriptor, False)
    if fork.holder is not None:
        _enter(fork.holder)
    pid = os.fork()
    if pid == 0:
        end_with_parent()
        os._exit(_recorded(fork, others))  # noqa: TID251 - threads of the middleware may take their time to end
    code = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    if code:
        how = f"signal {-code}" if code < 0 else f"exit code {code}"
        os.write(2, f"The recording process ended with {how}.\n".encode())
    os._exit(0)  # noqa: TID251 - everything else belongs to the process that we were forked from


def _enter(holder: int) -> None:
    """Enter the namespaces of this process; its pid namespace only applies to our children."""
    with contextlib.ExitStack() as stack:
        users, *others = (stack.enter_context(opened(f"/proc/{holder}/ns/{name}")) for name in _NAMESPACES)
        own = stack.enter_context(opened("/proc/self/ns/user"))
        if not os.path.sameopenfile(own, users):  # root has the same one
            enter_namespace(users)
        for namespace in others:
            enter_namespace(namespace)


def _recorded(fork: Fork, descriptors: Sequence[int]) -> int:
    results, file, *judged = map(str, descriptors)
    sys.argv[1:] = [results, file, fork.folder, *judged]
    _take_on(fork.environment)
    try:
        return record()
    except BaseException:  # noqa: BLE001 - it must not reach the code that forked us
        traceback.print_exc()
        return 1
    finally:
        sys.stdout.flush()


def _take_on(environment: Mapping[str, str]) -> None:
    """Continue as if this process had been started in this environment."""
    known = set(os.environ.get("LD_LIBRARY_PATH", "").split(os.pathsep))
    os.environ.clear()
    os.environ.update(environment)
    paths = filter(None, environment.get("PYTHONPATH", "").split(os.pathsep))
    sys.path[1:1] = [path for path in paths if path not in sys.path]
    for folder in environment.get("LD_LIBRARY_PATH", "").split(os.pathsep):
        if folder not in known:
            _load([str(file) for file in sorted(Path(folder).glob("lib*.so"))])


def _load(libraries: Sequence[str]) -> None:
    """Load each after those that it needs: the linker reads LD_LIBRARY_PATH only when a process starts."""
    waiting, before = list(libraries), None
    while waiting and waiting != before:
        before = waiting
        waiting = [library for library in waiting if not _is_loaded(library)]


def _is_loaded(library: str) -> bool:
    with contextlib.suppress(OSError):
        ctypes.CDLL(library)
        return True
    return False


def record() -> int:
    """What a fork does: one recording."""
    launcher = fork_launcher()  # before there is a second thread
    results, file = int(sys.argv[1]), int(sys.argv[2])
    judged = int(sys.argv[4]) if len(sys.argv) > 4 else None
    adopt_orphans()
    line = sys.stdin.buffer.readline()
    if not line:
        return 0  # the parent changed its mind
    task = codec.from_json(line, RecordingTask, "the task")
    folder = Path(sys.argv[3])
    threading.Thread(target=_end_with_parent, args=(folder,), daemon=True).start()
    try:
        tell(results, _outcome(task, results, file, folder, launcher, judged))
    finally:
        end_descendants()
        wipe(folder)
    return 0


def _listen_to_signals() -> None:
    """React to signals as in a terminal; everything that we start inherits this.

    A process that was started in the background may ignore SIGINT, and the learner's programs
    would inherit that: none of them would react to Ctrl+C.
    """
    for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def _end_with_parent(folder: Path) -> None:
    sys.stdin.read()
    end_descendants()
    wipe(folder)
    os._exit(1)  # noqa: TID251 - the main thread may be anywhere; nothing is left to clean up


def _outcome(
    task: RecordingTask,
    results: int,
    file: int,
    folder: Path,
    launcher: socket.socket,
    judged: int | None,
) -> RecordingOutcome:
    try:
        recording, lag = _record(task, results, folder, launcher)
        used = cpu_seconds(_groups(task))
        if judged is not None:
            recording = _with_notes(judged, recording)
        _save(recording, task, file)
    except MissingHere as error:
        return RecordingOutcome(fault=Feedback(error.what, advice=error.next_step), missing=True)
    except Exception as error:  # noqa: BLE001 - whatever a scenario runs into is our error, kept and shown
        return RecordingOutcome(fault=our_error(error), doubt=doubt_about(error))
    return RecordingOutcome(recording.duration, lag=lag, cpu=used)


def _save(recording: Recording, task: RecordingTask, file: int) -> None:
    began = time.time_ns() - round(recording.duration * 1e9)
    scenario = scenario_digest(Path(task.grader), task.exercise, task.looks_at)
    try:
        with open(file, "wb") as stream:
            write(replace(recording, scenario=scenario), stream, began_ns=began)
    except OSError as error:
        what = f"The recording could not be written: {error.strerror}."
        raise MissingHere(what, "Make room for temporary files, or name another folder in TMPDIR.") from error


def _with_notes(judged: int, observed: Recording) -> Recording:
    """The judged recording, followed by the notes of the run that looked for a cause."""
    before = read(os.pread(judged, os.fstat(judged).st_size, 0), "the judged recording")
    notes = (replace(event, t=before.duration) for event in observed.events if isinstance(event, Observed))
    return replace(before, events=(*before.events, *notes))


def _groups(task: RecordingTask) -> list[Path]:
    return [Path(group) for group in task.sandbox.control_groups] if task.sandbox else []


def _record(
    task: RecordingTask, results: int, folder: Path, launcher: socket.socket
) -> tuple[Recording, float]:
    """Run the scenario if there is one; return the recording, and how busy the machine was (s)."""
    grader = load_grader(Path(task.grader), task.exercise)
    timeline = Timeline()
    home = Path(task.home)
    looked_at = read_entries(home, task.looks_at)
    texts = (entry.path for entry in looked_at if entry.kind == "file")
    sources = read_sources(home, (*task.roots, *texts), trusted=task.local)
    definitions: dict[str, str] = {}
    duration = lag = 0.0
    for event in _told(task):
        timeline.add(event)
    if grader.scenario_function is not None and task.packages.failure is None:
        tell(results, Stage("watching your program", running=True))
        laid = (*looked_at, *read_entries(home, (".bashrc",)))
        open_place = partial(_open_place, task, grader, folder, launcher, timeline, laid)
        with (
            open_place({}) as place,
            open_arena(
                timeline,
                task.packages,
                Surroundings(
                    _watching(task, sources, folder) if task.observed else task.environment,
                    task.python,
                    folder / PROGRAMS,
                    task.plain,
                    home,
                    _ours(folder),
                    place,
                    open_place,
                ),
                ros=grader.ros,
                groups=_groups(task),
            ) as arena,
        ):
            try:
                grader.scenario_function(arena)
            except Exception:
                # If all programs were killed, that caused this error, and the recording says why.
                if isinstance(place.start, Sandbox):
                    place.start.look()  # the limit may have been reached just now
                if not any(timeline.of(LimitReached)):
                    raise
            arena.require_ours()
            place.require_ours()
            duration, lag = timeline.now(), arena.worst_lag
            definitions = arena.ros.definitions
    events = timeline.events()
    recording = Recording(
        task.exercise, events, definitions, sources, task.packages, duration, looked_at, task.local
    )
    return recording, lag


def _ours(folder: Path) -> Path:
    """A folder that the learner's programs can read but not write."""
    ours = folder / "ours"
    ours.mkdir(exist_ok=True, parents=True)
    return ours


def _watching(task: RecordingTask, sources: Sources, folder: Path) -> Mapping[str, str]:
    """The environment of programs that `observer_program` or a sanitizer watches from inside."""
    place = _ours(folder) / "observer"
    place.mkdir()
    shutil.copyfile(_OBSERVER, place / "sitecustomize.py")
    home = folder / PROGRAMS / HOME
    told = {
        "roots": [*(package.prefix for package in task.packages.built), str(home)],
        "names": sorted({PurePosixPath(name).name for name in sources.files}),
        "folder": str(home / _NOTES),
    }
    (place / "observer.json").write_text(json.dumps(told), encoding="utf-8")
    return {
        **task.environment,
        "PYTHONPATH": f"{place}:{task.environment.get('PYTHONPATH', '')}",
        "ASAN_OPTIONS": f"log_path={home / _REPORTS}:handle_abort=1:detect_leaks=0:color=never",
    }


def _noted(home: ScratchHome) -> Iterator[Observed]:
    """The valid notes of the programs, which may have written anything."""
    for file in islice(home.matching(f"{_NOTES}/*"), _MOST_PROGRAMS):
        for line in (home.text(file) or "")[:_MOST_NOTES].splitlines():
            with contextlib.suppress(DamagedData):
                yield codec.from_json(line, Observed, "a note")
    for file in islice(home.matching(f"{_REPORTS}.*"), _MOST_PROGRAMS):
        yield from islice(crash_notes((home.text(file) or "")[:_MOST_NOTES].splitlines()), _MOST_FRAMES)


@contextlib.contextmanager
def _open_place(
    task: RecordingTask,
    grader: Grader,
    folder: Path,
    launcher: socket.socket,
    timeline: Timeline,
    laid: tuple[HomeEntry, ...],
    files: Mapping[str, str],
) -> Iterator[Place]:
    """A new place for the learner's programs to run. laid, files: what to put into their home."""

    def fill(scratch: Path) -> None:
        lay_home(Path(task.home), laid, scratch / HOME, files)

    if task.sandbox is None:
        with place_without_sandbox(folder / PROGRAMS, fill) as place, _notes_of(place, task, timeline):
            yield place
        return
    plan = _plan(task.sandbox, grader, folder, task.observed)

    def note(limit: str) -> None:
        timeline.add(LimitReached(timeline.now(), limit, most_of(plan.limits, limit)))

    with open_sandbox(plan, launcher, folder / PROGRAMS, note, fill) as (sandbox, scratch):
        place = Place(sandbox, ScratchHome(scratch), sandbox.require_ours)
        with _notes_of(place, task, timeline):
            yield place


@contextlib.contextmanager
def _notes_of(place: Place, task: RecordingTask, timeline: Timeline) -> Iterator[None]:
    try:
        yield
    finally:
        for note in _noted(place.home) if task.observed else ():
            timeline.add(note)


def _plan(sandbox: IsolationPlan, grader: Grader, folder: Path, observed: bool) -> IsolationPlan:
    limits = for_sanitizers(sandbox.limits) if grader.sanitizers or observed else sandbox.limits
    shown = (*sandbox.shown, str(_ours(folder)))
    return replace(sandbox, shown=shown, limits=limits, own_network=not grader.ros)


def _told(task: RecordingTask) -> Iterator[Event]:
    if task.seed is not None:
        yield Drawn(0.0, task.seed)
    yield from (Acted(0.0, name, detail) for name, detail in task.acts)


if __name__ == "__main__":
    raise SystemExit(main())
