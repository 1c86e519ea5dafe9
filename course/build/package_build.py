"""Builds one package into its entry in the store, and tells the learner why a build was stopped.

A build runs foreign code, which sees and writes no more than it needs: see `isolated_build`.
"""

from __future__ import annotations

import os
import shlex
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from course.build.budget import ALL_CPU, ALL_DISK, ALL_SECONDS, NO_ROOM, Bounds, Budget, Spent
from course.build.build_outcome import BuildFailure, InstalledPackage, unreadable
from course.build.cmake_reuse import keep_tree, make_command
from course.build.colcon import (
    SANITIZED,
    Killed,
    Machine,
    build_environment,
    colcon_command,
    raise_if_machine,
    require_tools,
    uses_cmake,
)
from course.build.outputs import FILES, MOST_FILES, DiskUsage, Flaw, seal
from course.build.package_sources import SourcesChanged, content_key, copy_sources
from course.build.reuse import likeness, resumed, reused
from course.build.runner import Ended, Ending, Interrupt, run
from course.build.store import Store, StoreEntry, disk_full, storage
from course.build.workspace import Package, Workspace
from course.explain.build_errors import BuildError, explain_build, explain_success
from course.explain.builds import Build, log_text, read_copy, readable
from course.explain.package_xml import strict_fault
from course.files import wipe
from course.isolation import IsolationPlan
from course.isolation.isolation_plan import BUILD
from course.isolation.levels import isolated_build
from course.isolation.sandbox import hand_over
from course.isolation.watchdog import CPU, DISK, MEMORY, PROCESSES, Watchdog
from course.model import replace
from course.model.feedback import Feedback, Spoilt
from course.rosenv import Ros

_ASK_SECONDS = 30.0
_ATTEMPTS = 3
_MB = 1024 * 1024
_LIMITS = {
    MEMORY: f"took more than {BUILD.memory // _MB} MB of memory",
    PROCESSES: f"started more than {BUILD.processes} processes and threads",
    CPU: f"used more than {BUILD.cpu:g} s of CPU time",
    DISK: f"wrote more than {BUILD.scratch // _MB} MB of files",
    FILES: f"created more than {MOST_FILES} files, or folders nested far too deep",
}
# What all packages of a check did together: each may be fine by itself.
_TOGETHER: dict[str | None, Callable[[Bounds], str]] = {
    ALL_SECONDS: lambda bounds: f"took longer than {bounds.seconds:g} s to build",
    ALL_CPU: lambda bounds: f"used more than {bounds.cpu:g} s of CPU time",
    ALL_DISK: lambda bounds: f"wrote more than {bounds.disk / _MB:.0f} MB of files",
}
_FLAWS = {
    "link": "installs a link to a place outside the package",
    "kind": "installs something that is neither a file nor a folder",
    "size": "installs far too many files, or folders nested far too deep",
}

RunCommand = Callable[[Sequence[str], Path, Path, float], Ended]


@dataclass(frozen=True)
class PackageBuild:
    """All that one build needs. `needed` and `overlays`: keys and prefixes of the packages it depends on.

    identity: identifies the ROS in use, and the options for C++.
    """

    package: Package
    workspace: Workspace
    key: str
    needed: tuple[str, ...]
    overlays: tuple[Path, ...]
    ros: Ros
    identity: str
    store: Store
    budget: Budget
    time_limit: float
    on_progress: Callable[[str], None]
    stop: Interrupt

    @property
    def entry(self) -> StoreEntry:
        return self.store.entry(self.key)

    def build(self) -> InstalledPackage | BuildFailure:
        """Build it, unless someone else built it meanwhile. Raises SourcesChanged and Interrupted."""
        name, source = self.package.name, self.package.source

        def waiting() -> None:
            self.on_progress(f"Waiting for {name}, which is already being built")

        with self.store.locked(self.key, self.stop, waiting) as entry, storage(self.store.root):
            prefix = entry.prefix(name)
            if entry.is_complete():
                return InstalledPackage(name, source, prefix, True, 0.0)
            self.on_progress(f"Building {name}")
            if fault := strict_fault(self.package.folder / "package.xml"):
                return unreadable(self.package, fault)
            began = time.monotonic()
            with _half_made(entry):
                failure = self._fill()
            return failure or InstalledPackage(name, source, prefix, False, time.monotonic() - began)

    def _fill(self) -> BuildFailure | None:
        entry, package = self.entry, self.package
        copy_sources(package.folder, self.workspace.home, entry.kept)
        if content_key(entry.kept, entry.kept, self.needed, self.identity) != self.key:
            raise SourcesChanged
        identity = (self.needed, self.identity)
        like, cmake = None, uses_cmake(package)
        if not cmake or self.workspace.is_trusted:  # nothing that one submission built reaches another one
            like = likeness(entry.kept, package.build_type, *identity)
        again = like is None or cmake or not reused(self.store, like, self.key, *identity)
        if again and (failure := self._run_undisturbed(like if cmake else None)):
            entry.give_up()
            return failure
        keeps = cmake and entry.build.exists()
        entry.finish(package.name, keeps_build=keeps)
        if like is not None and (keeps or not cmake):
            self.store.note_alike(like, self.key)
        return None

    def _run_undisturbed(self, like: str | None) -> BuildFailure | None:
        """Run the build, and again if one of our processes was killed, which the build itself cannot do."""
        for _ in range(_ATTEMPTS - 1):
            with suppress(Spoilt):
                return self._run(like)
            self.entry.begin_again()
        return self._run(like)

    def _run(self, like: str | None) -> BuildFailure | None:
        """like: the key of packages whose build folders this build may resume, and the other way around."""
        entry = self.entry
        copy_sources(entry.kept, entry.kept, entry.src)
        goes_on = like is not None and resumed(
            self.store, like, self.key, self.needed, self.identity, self.stop
        )
        env = build_environment(self.ros, entry, self.overlays)
        if self.identity != self.ros.identity:
            names = shlex.quote(f"-ffile-prefix-map={entry.src}={self.package.source}")
            env["CXXFLAGS"] = f"{SANITIZED} {names}"
        require_tools(self.package, env)
        command = make_command(self.package.name, entry, env) if goes_on else None
        command = command or colcon_command(self.package, entry, self.ros, env)
        killed, usage = Killed(), self.usage()
        with self.commands(env, usage) as run_command:
            ended = run_command(command, entry.path, entry.log, self.time_limit)
        build, flaw = self._evidence(env), None
        if ended.ending is Ending.EXITED:
            limit, flaw = self._too_much(usage), seal(entry.install, entry.path)
            if limit := limit or self._too_much(usage):  # only now can all folders be looked into
                ended = replace(ended, ending=Ending.LIMIT, limit=limit)
        error = self._error(build, ended, flaw, usage, killed)
        if goes_on and error and error.kind not in ("compiler", "linker"):
            entry.begin_again()  # make may miss a library that an upgrade of the system replaced
            return self._run(None)
        if error or goes_on or like is None or not keep_tree(self.package.name, entry):
            wipe(entry.build)
        return BuildFailure(build.name, error.kind, error.feedback, entry.log) if error else None

    def _error(
        self, build: Build, ended: Ended, flaw: Flaw | None, usage: DiskUsage, killed: Killed
    ) -> BuildError | None:
        """Decide whose fault it was. Raises if this machine lacks something."""
        root = self.store.root
        if ended.limit == NO_ROOM:
            raise disk_full(root)
        if ended.ending is not Ending.EXITED:
            return stopped(build, ended, self.time_limit, self.budget.bounds)
        if flaw is not None:
            return flawed(build, flaw)
        if ended.code == 0:
            return explain_success(build, self.entry.prefix(self.package.name))
        if usage.was_low and not self.budget.again:
            raise disk_full(root)
        raise_if_machine(build.lines, Machine(root, self.ros.python, killed, was_full=usage.was_low))
        return explain_build(build)

    def usage(self) -> DiskUsage:
        """How much all of its runs write."""
        return DiskUsage((*self._writable, self.entry.kept, self.entry.log.parent), BUILD.scratch)

    def _too_much(self, usage: DiskUsage) -> str | None:
        return usage.now() or self.budget.wrote(self.package.name, usage.total)

    @property
    def _writable(self) -> tuple[Path, ...]:
        return (self.entry.src, self.entry.build, self.entry.install)

    @contextmanager
    def commands(self, env: Mapping[str, str], usage: DiskUsage) -> Iterator[RunCommand]:
        """Yield a function `run(command, cwd, output, time_limit)`. No process of the command outlives it.

        What the command writes belongs to another user and can be anything: see `seal`. The function raises
        Spoilt if somebody else has killed a process of ours.
        """
        with isolated_build(self.ros, env, self._writable, self.overlays, BUILD) as plan:
            for folder in self._writable:
                hand_over(folder, plan.user if plan else None)

            def run_command(command: Sequence[str], cwd: Path, output: Path, time_limit: float) -> Ended:
                breach = self._breach(plan, usage)
                return run(plan, command, cwd, env, output, time_limit, self.stop, breach)

            yield run_command

    def _breach(self, plan: IsolationPlan | None, usage: DiskUsage) -> Callable[[int], str | None]:
        one_run, began = object(), time.monotonic()
        groups = [Path(group) for group in plan.control_groups] if plan else []

        def look(pid: int) -> str | None:
            watchdog = Watchdog(BUILD, groups, pid, lambda: (0, 1))
            reached = usage.look() or watchdog.look()
            spent = Spent(time.monotonic() - began, watchdog.cpu, usage.total)
            all_reached = self.budget.spend(one_run, self.package.name, spent)
            return reached or all_reached

        return look

    def _evidence(self, env: Mapping[str, str]) -> Build:
        entry, package = self.entry, self.package

        def lines_of(file: Path) -> tuple[str, ...]:
            return readable(log_text(file), self.store.root, entry.src, package.source)

        def ask_setup_py() -> tuple[str, ...]:
            output = entry.log.with_name("setup-py.log")
            command = [str(self.ros.python), "-W", "ignore", "setup.py", "--name"]
            entry.begin_again()
            copy_sources(entry.kept, entry.kept, entry.src)
            build_environment(self.ros, entry, self.overlays)
            with self.commands(env, self.usage()) as run_command:
                run_command(command, entry.src, output, _ASK_SECONDS)
            return lines_of(output)

        prefixes = (Path(prefix) for prefix in env.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if prefix)
        others = (other for other in self.workspace.packages if other.name != package.name)
        return Build(
            sources=read_copy(entry.kept, package.source),
            folder=package.source,
            name=package.name,
            build_type=package.build_type,
            manifest=package.manifest,
            copy=entry.kept,
            lines=lines_of(entry.log),
            neighbors={other.name: other.source for other in others},
            prefixes=tuple(prefixes),
            ask_setup_py=ask_setup_py,
        )


@contextmanager
def _half_made(entry: StoreEntry) -> Iterator[None]:
    entry.begin()
    try:
        yield
    except BaseException:
        entry.discard()
        raise


def stopped(build: Build, ended: Ended, time_limit: float, bounds: Bounds) -> BuildError:
    if ended.ending is Ending.TOO_LONG:
        what = f"took longer than {time_limit:g} seconds"
        advice = "Does setup.py or CMakeLists.txt loop forever, or wait for someone to type?"
        return _told(build, "time-limit", f"{what} and was stopped", advice, build.lines[-3:])
    if ended.limit in _TOGETHER:
        what = f"was stopped: the packages of this exercise together {_TOGETHER[ended.limit](bounds)}"
        advice = (
            "Look for the code that does it in their setup.py or CMakeLists.txt: a normal build needs little."
        )
        return _told(build, f"{ended.limit}-limit", what, advice, build.lines[-3:])
    if ended.limit is not None:
        advice = (
            "Look for the code that does it in setup.py or CMakeLists.txt: building a package needs little."
        )
        what = f"{_LIMITS[ended.limit]} and was stopped"
        return _told(build, f"{ended.limit}-limit", what, advice, build.lines[-3:])
    advice = "Look for a loop that prints in setup.py or CMakeLists.txt."
    return _told(build, "output-limit", "never stopped printing, and was stopped", advice, build.lines[-3:])


def flawed(build: Build, flaw: Flaw) -> BuildError:
    advice = "Install files of the package itself: `data_files` in setup.py, `install` in CMakeLists.txt."
    return _told(build, f"installed-{flaw.why}", f"{_FLAWS[flaw.why]}: `{flaw.name}`", advice)


def _told(build: Build, kind: str, what: str, advice: str, lines: tuple[str, ...] = ()) -> BuildError:
    where = build.place("setup.py" if build.text("setup.py") else "CMakeLists.txt")
    details = tuple(line.rstrip() for line in lines if line.strip())
    return BuildError(
        kind, Feedback(f"Building `{build.name}` {what}.", None, None, (where,), advice, details)
    )
