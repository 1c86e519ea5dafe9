"""Programs that are not nodes: the learner's scripts, an interactive bash, probes, and the course's own.

They run confined, in a scratch copy of those parts of the course home that the exercise needs.
"""

from __future__ import annotations

import contextlib
import shutil
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from pathlib import Path
from types import MappingProxyType

from course.arena import toolchain
from course.arena.bash import START_TIME, Shell
from course.arena.command_lines import LINT_TIME, lint_command, public_names
from course.arena.probe import PROBE_TIME, run_probe
from course.arena.process import Process, files_in_memory
from course.arena.scratch_home import HOME, OpenPlace, Place, ScratchHome
from course.errors import MissingHere, OurFault
from course.evidence.timeline import Timeline
from course.isolation.domains import Domains
from course.isolation.isolation_plan import Starter
from course.isolation.sandbox import start_here
from course.model.events import Marked, ProcessExited, ProgramMissing
from course.rosenv.host import require

_DOMAIN = "ROS_DOMAIN_ID"
_ONLY_ROS = ("ROS_LOG_DIR", "RCUTILS_COLORIZED_OUTPUT", "ROS_PYTHON_CHECK_FIELDS", "ROS2COURSE_ARENA")


@dataclass(frozen=True)
class Surroundings:
    """What an arena's programs get.

    environment: with ROS and the learner's packages. plain: without them. python: the interpreter for
    programs of the course. folder: a scratch folder, by the path that programs use. learners_home: the
    course home itself. ours: a folder that programs can read but not write. place: where programs run; by
    default in `folder`, without a sandbox. another: opens further places.
    """

    environment: Mapping[str, str]
    python: str
    folder: Path
    plain: Mapping[str, str] = field(default_factory=dict)
    learners_home: Path | None = None
    ours: Path | None = None
    place: Place | None = None
    another: OpenPlace | None = None


class HomePrograms:
    """The part of an arena that starts programs in the copy of the course home."""

    def __init__(self, timeline: Timeline, given: Surroundings) -> None:
        self.timeline = timeline
        self._ours = given.ours or given.folder
        self._place = given.place or Place(start_here, ScratchHome(given.folder))
        self._another = given.another
        self._learners_home = given.learners_home or given.folder / HOME
        self._environment = given.environment
        self._plain = given.plain
        self._python = given.python
        self._folder = given.folder
        self._processes: list[Process] = []
        if given.place is None:
            self.home.mkdir(parents=True, exist_ok=True)

    @property
    def home(self) -> Path:
        """The copy of the course home. It is HOME and the working folder of every program started here.

        Use this path only in programs. To look inside, use `files`. Nothing is written there from outside.
        """
        return self._folder / HOME

    @property
    def files(self) -> ScratchHome:
        """What is in the copy of the course home now: `arena.files.text("notes.txt")`."""
        return self._place.home

    @contextlib.contextmanager
    def fresh(self, files: Mapping[str, str] = MappingProxyType({})) -> Iterator[None]:
        """Inside this context, programs start in an unused place; when it ends, all of them have ended.

        Their home is as it was at the beginning, plus the texts in `files`. They share no processes, shared
        memory or temporary files with earlier programs, and no network if the exercise has no ROS. So a
        program that runs several times cannot tell one run from another by its surroundings.
        """
        if self._another is None:
            raise OurFault("this arena has one place for programs, and no other")
        before, number = self._place, len(self._processes)
        with self._another(files) as self._place:
            try:
                yield
                self._place.require_ours()
            finally:
                for process in self._processes[number:]:
                    process.close()
                self._place = before

    @contextlib.contextmanager
    def shell(
        self, name: str = "bash", *, sourced: bool = False, timeout: float = START_TIME
    ) -> Iterator[Shell]:
        """Open an interactive bash that has read the learner's `~/.bashrc`: `with arena.shell() as sh:`.

        sourced: with ROS in its environment from the start, as in `ros2course shell`. timeout: seconds
        until the first prompt must appear. If it does not, the shell takes no commands, and the recording
        says why.
        """
        if shutil.which("bash") is None:
            raise MissingHere("The program bash is missing.", "Install it: `sudo apt install bash`.")
        shell = Shell(name, self.timeline, self._ours)
        environment = self._programs() if sourced else self._plain_programs()
        try:
            shell.open(self._launch, environment, timeout)
            yield shell
        finally:
            shell.close()

    def python(self, file: str, *args: str, name: str | None = None) -> Process | None:
        """Start `python3 file args...` in its own terminal and folder; `file` is relative to the course home.

        name: what the recording calls it; the file's name by default. If there is no such file, this is
        recorded, and None returned.
        """
        command = (self._python, str(self.home / file), *args)
        return self._start_file(file, command, name, {})

    def python_module(
        self,
        module: str,
        *args: str,
        name: str | None = None,
        cwd: str = "",
        env: Mapping[str, str] | None = None,
        ours: bool = False,
        through: Callable[[str], str | None] | None = None,
    ) -> Process | None:
        """Start `python3 -m module args...` in the folder `cwd` of the home; None if there is no such folder.

        ours: use the Python that runs the course, which has pip, venv and setuptools. through: maps each
        line of output to what is kept, or to None to drop it. It is needed where the learner's code runs
        beside files that they must not see, and might print them.
        """
        name, folder = name or module, self._inside(cwd)
        if not self.files.is_folder(cwd):
            self.timeline.add(ProgramMissing(self.timeline.now(), name, cwd))
            return None
        command = (sys.executable if ours else self._python, "-m", module, *args)
        environment = {**self._programs(), **(env or {})}
        return self._launch(name, command, environment, folder, through=through or self._at_home)

    def in_place(self, file: str, *args: str, name: str) -> Process | None:
        """Start a program from the learner's own home that cannot be copied, such as a virtual environment.

        It still runs in the copy of the home. If it does not exist, this is recorded, and None returned.
        """
        program = self._learners_home / self._inside(file).relative_to(self.home)
        if not program.is_file():
            self.timeline.add(ProgramMissing(self.timeline.now(), name, file))
            return None
        return self._launch(name, (str(program), *args), self._plain_programs())

    def execute(
        self, file: str, *args: str, name: str | None = None, env: Mapping[str, str] | None = None
    ) -> Process | None:
        """Start `./file args...` in the file's folder, by its mode and first line; else like `python`."""
        return self._start_file(file, (f"./{Path(file).name}", *args), name, env or {})

    def probe(
        self, code: str | Path, *, name: str = "probe", cwd: str = "", timeout: float = PROBE_TIME
    ) -> None:
        """Run Python code of the course (text or a file) beside the learner's; see `recording.probe`.

        Each `ask("sum", lambda: theirs.add(1, 2))` in it is one question. It can import modules from `cwd`,
        a folder of the home.
        """
        folder = self._inside(cwd)
        if not self.files.is_folder(cwd):
            self.timeline.add(ProgramMissing(self.timeline.now(), name, cwd))
            return
        file = self._ours / f"{name}.py"
        file.write_text(code if isinstance(code, str) else code.read_text(encoding="utf-8"), encoding="utf-8")

        def launch(command: tuple[str, ...], descriptors: tuple[int, ...]) -> Process:
            return self._launch(
                name, command, self._programs(), folder, through=self._at_home, descriptors=descriptors
            )

        run_probe(launch, self._python, file, self.home, self.timeline, name, timeout)

    def lint(self, folder: str, *rules: str, name: str = "lint", timeout: float = LINT_TIME) -> None:
        """Check the Python files in `folder` by these rules of ruff; `graders/lib/lint.py` reads the result.

        The learner's own settings and comments that silence rules are ignored.
        """
        self._inside(folder)
        renamed = public_names(self.files.below(folder))
        before = {new: old for old, new in renamed.items()}

        def as_it_was(line: str) -> str:
            file, colon, rest = line.partition(":")
            return f"{before.get(file, file)}{colon}{rest}"

        command = lint_command(folder, rules, renamed)
        self._launch(name, command, self._plain_programs(), through=as_it_was).wait(timeout)

    def require(self, *tools: str) -> None:
        """Raise MissingHere, with the install command, if this machine lacks any of these tools."""
        require(tools, self._plain_programs().get("PATH", ""))

    def tool(
        self,
        *command: str,
        name: str,
        cwd: str = "",
        env: Mapping[str, str] | None = None,
        timeout: float = toolchain.COMPILE_TIME,
    ) -> bool:
        """Run a tool of this machine (`cmake`, `make`) to its end, in the folder `cwd` of the home.

        Its output is recorded, with `~` for the home. Returns True if it succeeded within `timeout` s.
        Raises MissingHere, with the install command, if the tool is not installed.
        """
        environment = {**toolchain.compiling(self._plain_programs()), **(env or {})}
        require(command[:1], environment.get("PATH", ""))
        process = self._launch(name, command, environment, self._inside(cwd), through=self._at_home)
        if not process.wait(timeout):
            process.close()
        return any(e.process == name and e.code == 0 for e in self.timeline.of(ProcessExited))

    def handed(self, path: Path) -> str:
        """Return a path where programs can read, but not write, a copy of the course's file or folder."""
        copy = self._ours / path.name
        if path.is_dir():
            shutil.copytree(path, copy)
        else:
            shutil.copyfile(path, copy)
        return str(copy)

    def companion(
        self,
        file: Path,
        *arguments: str,
        name: str,
        env: Mapping[str, str] | None = None,
        own_memory: bool = False,
    ) -> Process:
        """Start a Python program of the course (`file`) among the learner's, in its own terminal.

        own_memory: give it a /dev/shm of its own, as in a container; raises MissingHere if that is
        impossible.
        """
        if own_memory and self._shares_the_network:
            raise MissingHere(
                "This exercise needs namespaces, which this machine does not offer.",
                "`ros2course doctor` says what is missing.",
            )
        start = partial(self._place.start, own_memory=True) if own_memory else self._place.start
        command = (self._python, self.handed(file), *arguments)
        return self._launch(name, command, {**self._programs(), **(env or {})}, start=start)

    def domain(self, number: int) -> int:
        """Return the ROS_DOMAIN_ID that puts a program into domain `number`; the arena is in 0.

        It is `number` itself, unless others use the same network: see `Domains`.
        """
        return self._domains.at(number)

    def shared_memory(self, process: Process) -> tuple[str, ...]:
        """Return and record the names of the files in /dev/shm that the program or its children use now."""
        found = files_in_memory(process.pid) if process.running else ()
        self.timeline.add(Marked(self.timeline.now(), memory_mark(process.name), " ".join(found)))
        return found

    def _start_file(
        self, file: str, command: Sequence[str], name: str | None, env: Mapping[str, str]
    ) -> Process | None:
        path = self._inside(file)
        name = name or path.name
        # A link may lead to a file that exists only where the program runs.
        if not (self.files.is_file(file) or self.files.is_link(file)):
            self.timeline.add(ProgramMissing(self.timeline.now(), name, file))
            return None
        environment = {**self._programs(), **env}
        return self._launch(name, command, environment, path.parent, through=self._at_home)

    def _inside(self, path: str) -> Path:
        if Path(path).is_absolute() or ".." in Path(path).parts:
            raise OurFault(f"the scenario leaves the course home: {path}")
        return self.home / path

    def _at_home(self, line: str) -> str:
        """Paths in tracebacks as the learner knows them: they have never seen the copy of the home."""
        return line.replace(str(self.home), "~")

    def _programs(self) -> dict[str, str]:
        return {**self._environment, **self._own_environment()}

    def _plain_programs(self) -> dict[str, str]:
        own = {key: value for key, value in self._own_environment().items() if key not in _ONLY_ROS}
        return {**self._plain, **own}

    def _launch(
        self,
        name: str,
        command: Sequence[str],
        environment: Mapping[str, str],
        cwd: Path | None = None,
        *,
        through: Callable[[str], str | None] = str,
        descriptors: Sequence[int] = (),
        start: Starter | None = None,
    ) -> Process:
        if any(process.name == name for process in self._processes):
            raise OurFault(f"the scenario starts two programs under the name {name}")
        process = Process(
            name,
            command,
            env=environment,
            cwd=cwd or self.home,
            timeline=self.timeline,
            through=through,
            descriptors=descriptors,
            start=start or self._place.start,
        )
        self._processes.append(process)
        return process

    def _own_environment(self) -> dict[str, str]:
        return {
            "HOME": str(self.home),
            "TMPDIR": str(self._folder),
            "ROS_LOG_DIR": str(self._folder / "log"),
            "TERM": "xterm",
            "RCUTILS_COLORIZED_OUTPUT": "0",
            # A field of the wrong type raises a clear exception instead of aborting in C.
            "ROS_PYTHON_CHECK_FIELDS": "1",
            # Otherwise, Python would write bytecode into the build cache.
            "PYTHONDONTWRITEBYTECODE": "1",
            # Messages import numpy, which would start a thread for each core.
            "OPENBLAS_NUM_THREADS": "1",
            # Keeps the course's own ros2 command from starting its daemon.
            "ROS2COURSE_ARENA": "1",
        }

    @property
    def _shares_the_network(self) -> bool:
        return _DOMAIN in self._environment

    @cached_property
    def _domains(self) -> Domains:
        return Domains(int(self._environment[_DOMAIN]) if self._shares_the_network else None)


def memory_mark(name: str) -> str:
    """The name of the mark for the shared memory of the program `name`: `recording.marked`."""
    return f"shared memory of {name}"
