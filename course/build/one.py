"""Building one package into its entry of the store."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from course.build.colcon import build_environment, colcon_command, require_tools
from course.build.confined import confined, written
from course.build.digest import Case, explain, explain_success, log_text, readable
from course.build.digest.machine import Killed, Machine, raise_if_machine
from course.build.interrupt import Interrupt
from course.build.job import Job, SourcesChanged
from course.build.key import content_key
from course.build.manifest import strict_fault
from course.build.outcome import BuildFailure, BuiltPackage
from course.build.process import Ending
from course.build.refusal import unreadable
from course.build.renewal import likeness, renewed
from course.build.sealing import seal
from course.build.sources import copy_sources
from course.build.stopped import flawed, stopped
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
        began = time.monotonic()
        with _half_made(entry):
            _copy(job, entry)
            like = likeness(job, entry)
            if like is None or not renewed(job, entry, like):
                failure = _run(job, entry, stop)
                if failure:
                    entry.give_up()
                    return failure
            entry.finish(name)
        if like is not None:
            job.store.note_alike(like, job.key)
        return BuiltPackage(name, job.package.source, prefix, False, time.monotonic() - began)


@contextmanager
def _half_made(entry: Entry) -> Iterator[None]:
    """Leave nothing behind when something unforeseen happens."""
    entry.begin()
    try:
        yield
    except BaseException:
        entry.discard()
        raise


def _run(job: Job, entry: Entry, stop: Interrupt) -> BuildFailure | None:
    copy_sources(entry.kept, entry.kept, entry.src)
    env = build_environment(job.ros, entry, job.overlays)
    require_tools(job.package, env)
    command = colcon_command(job.package, entry, job.ros, env)
    killed = Killed()
    with confined(job, entry, env, stop) as run:
        ended = run(command, entry.path, entry.log, job.time_limit)
    case = _case(job, entry, env, stop)
    if ended.ending is not Ending.EXITED:
        return stopped(case, ended, job.time_limit)
    limit, flaw = written(entry).now(), seal(entry.install, entry.path)
    if limit := limit or written(entry).now():  # only now can all folders be looked into
        return stopped(case, replace(ended, ending=Ending.LIMIT, limit=limit), job.time_limit)
    if flaw is not None:
        return flawed(case, flaw)
    if ended.code != 0:
        raise_if_machine(case.lines, Machine(job.store.root, job.ros.python, killed))
        return explain(case)
    return explain_success(case, entry.prefix(job.package.name))


def _copy(job: Job, entry: Entry) -> None:
    copy_sources(job.package.folder, job.workspace.home, entry.kept)
    if content_key(entry.kept, entry.kept, job.needed, job.ros.identity) != job.key:
        raise SourcesChanged


def _case(job: Job, entry: Entry, env: Mapping[str, str], stop: Interrupt) -> Case:
    def lines_of(file: Path) -> tuple[str, ...]:
        return readable(log_text(file), job.store.root, entry.src, job.package.source)

    def ask_setup_py() -> tuple[str, ...]:
        output = entry.log.with_name("setup-py.log")
        command = [str(job.ros.python), "-W", "ignore", "setup.py", "--name"]
        entry.begin_again()
        copy_sources(entry.kept, entry.kept, entry.src)
        build_environment(job.ros, entry, job.overlays)
        with confined(job, entry, env, stop) as run:
            run(command, entry.src, output, _ASK_SECONDS)
        return lines_of(output)

    prefixes = tuple(Path(prefix) for prefix in env.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if prefix)
    return Case(
        job.package, job.workspace, entry.kept, lines_of(entry.log), entry.log, prefixes, ask_setup_py
    )
