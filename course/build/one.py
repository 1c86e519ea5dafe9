"""Building one package into its entry of the store."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from course.build.colcon import build_environment, colcon_command, require_tools
from course.build.digest import Case, explain, explain_success, readable
from course.build.digest.machine import raise_if_machine
from course.build.interrupt import Interrupt
from course.build.job import Job, SourcesChanged
from course.build.key import content_key
from course.build.manifest import strict_fault
from course.build.outcome import BuildFailure, BuiltPackage
from course.build.process import Ended, Ending, run
from course.build.refusal import unreadable
from course.build.sources import copy_sources
from course.build.store import Entry, storage

_ASK_SECONDS = 30.0


def build_one(job: Job, stop: Interrupt) -> BuiltPackage | BuildFailure:
    """Build the package, or find that someone else did meanwhile. Raises SourcesChanged and Interrupted."""
    name = job.package.name

    def waiting() -> None:
        job.on_progress(f"Waiting for {name}, which is being built already")

    with job.store.locked(job.key, stop, waiting) as entry, storage(job.store.root):
        prefix = entry.prefix(name)
        if entry.is_complete():
            return BuiltPackage(name, job.package.source, prefix, True, 0.0)
        job.on_progress(f"Building {name}")
        if fault := strict_fault(job.package.folder / "package.xml"):
            return unreadable(job.package, fault)
        with _half_made(entry):
            ended, failure = _run(job, entry, stop)
            if failure:
                entry.give_up()
                return failure
            entry.finish(name)
        return BuiltPackage(name, job.package.source, prefix, False, ended.seconds)


@contextmanager
def _half_made(entry: Entry) -> Iterator[None]:
    """Leave nothing behind when something unforeseen happens."""
    entry.begin()
    try:
        yield
    except BaseException:
        entry.discard()
        raise


def _run(job: Job, entry: Entry, stop: Interrupt) -> tuple[Ended, BuildFailure | None]:
    _copy(job, entry)
    env = build_environment(job.ros, entry, job.overlays)
    require_tools(job.package, env)
    command = colcon_command(job.package, entry, job.ros, env)
    ended = run(command, cwd=entry.path, env=env, output=entry.log, time_limit=job.time_limit, interrupt=stop)
    case = _case(job, entry, env, stop)
    if ended.ending is not Ending.EXITED:
        return ended, _stopped(case, ended, job.time_limit)
    if ended.code != 0:
        raise_if_machine(case.lines, job.store.root, job.ros.python)
        return ended, explain(case)
    return ended, explain_success(case, entry.prefix(job.package.name))


def _copy(job: Job, entry: Entry) -> None:
    copy_sources(job.package.folder, job.workspace.home, entry.src)
    if content_key(entry.src, entry.src, job.needed, job.ros.identity) != job.key:
        raise SourcesChanged


def _stopped(case: Case, ended: Ended, time_limit: float) -> BuildFailure:
    name, lines = case.package.name, case.lines[-3:]
    file = case.place("setup.py" if case.text("setup.py") else "CMakeLists.txt")
    if ended.ending is Ending.TOO_LONG:
        summary = f"Building `{name}` took longer than {time_limit:g} seconds and was stopped."
        advice = "Does setup.py or CMakeLists.txt loop without end, or wait for someone to type?"
        return case.failure("time-limit", summary, where=[file], advice=advice, details=lines)
    summary = f"Building `{name}` printed without end and was stopped."
    advice = "Look for what prints in a loop in setup.py or CMakeLists.txt."
    return case.failure("output-limit", summary, where=[file], advice=advice, details=lines)


def _case(job: Job, entry: Entry, env: Mapping[str, str], stop: Interrupt) -> Case:
    def lines_of(file: Path) -> tuple[str, ...]:
        text = file.read_text(encoding="utf-8", errors="replace")
        return readable(text, job.store.root, entry.src, job.package.source)

    def ask_setup_py() -> tuple[str, ...]:
        output = entry.log.with_name("setup-py.log")
        command = [str(job.ros.python), "-W", "ignore", "setup.py", "--name"]
        run(command, cwd=entry.src, env=env, output=output, time_limit=_ASK_SECONDS, interrupt=stop)
        return lines_of(output)

    prefixes = tuple(Path(prefix) for prefix in env.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if prefix)
    return Case(job.package, job.workspace, entry.src, lines_of(entry.log), entry.log, prefixes, ask_setup_py)
