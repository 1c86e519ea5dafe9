"""Programs that are no nodes: the learner's scripts, an interactive bash, and probes of their code.

They run in a scratch copy of the part of the course home that the exercise needs.
"""

from __future__ import annotations

import contextlib
import shutil
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from course.arena.lint import LINT_TIME, lint_command, named_as_public
from course.arena.probe import PROBE_TIME, run_probe
from course.arena.process import Process
from course.arena.shell import START_TIME, Shell
from course.arena.starting import Starter, start_here
from course.errors import MissingHere, OurFault
from course.evidence.events import ProgramMissing
from course.evidence.timeline import Timeline

_ONLY_ROS = ("ROS_LOG_DIR", "RCUTILS_COLORIZED_OUTPUT", "ROS_PYTHON_CHECK_FIELDS", "ROS2COURSE_ARENA")


class HomePrograms:
    """The part of an arena that starts programs in the copy of the course home.

    environment: with ROS and the learner's packages. plain: without them. python: the interpreter for
    programs of the course. folder: a scratch folder. learners_home: the course home itself. ours: a folder
    for what programs may read and not write. confined: starts them in a sandbox.
    """

    def __init__(
        self,
        timeline: Timeline,
        environment: Mapping[str, str],
        plain: Mapping[str, str],
        python: str,
        folder: Path,
        learners_home: Path | None = None,
        ours: Path | None = None,
        confined: Starter = start_here,
    ) -> None:
        self.timeline = timeline
        self._ours = ours or folder
        self._confined = confined
        self._learners_home = learners_home or folder / "home"
        self._environment = environment
        self._plain = plain
        self._python = python
        self._folder = folder
        self._processes: list[Process] = []
        self.home.mkdir(exist_ok=True)

    @property
    def home(self) -> Path:
        """The copy of the course home: HOME, and the working folder, of all that is started here."""
        return self._folder / "home"

    @contextlib.contextmanager
    def shell(
        self, name: str = "bash", *, sourced: bool = False, timeout: float = START_TIME
    ) -> Iterator[Shell]:
        """An interactive bash that has read the learner's `~/.bashrc`; `with arena.shell() as sh:`.

        sourced: with ROS in its environment from the start, as in `ros2course shell`. timeout: seconds
        for it to show its first prompt; a shell that shows none takes no commands, and the recording
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

    def python(
        self,
        file: str,
        *args: str,
        name: str | None = None,
        cwd: str | None = None,
        env: Mapping[str, str] | None = None,
    ) -> Process | None:
        """Start `python3 file args...` on a terminal of its own; `file` is relative to the course home.

        cwd: folder of the home that it is started in; by default the file's own. name: what the
        recording calls it; the file's name by default. Returns None, and records it, when there is
        no such file.
        """
        command = (self._python, str(self.home / file), *args)
        return self._start_file(file, command, name, cwd, env)

    def python_module(
        self,
        module: str,
        *args: str,
        name: str | None = None,
        cwd: str = "",
        env: Mapping[str, str] | None = None,
        ours: bool = False,
    ) -> Process | None:
        """Start `python3 -m module args...` in the folder `cwd` of the home; None if that is not there.

        ours: with the Python that the course itself runs with, which has pip, venv and setuptools.
        """
        name, folder = name or module, self._inside(cwd)
        if not folder.is_dir():
            self.timeline.add(ProgramMissing(self.timeline.now(), name, cwd))
            return None
        command = (sys.executable if ours else self._python, "-m", module, *args)
        return self._launch(name, command, {**self._programs(), **(env or {})}, folder, through=self._at_home)

    def in_place(self, file: str, *args: str, name: str) -> Process | None:
        """Start a program of the learner's own home itself, where no copy would do: a virtual environment.

        It runs in the copy of the home all the same. Returns None, and records it, when there is none.
        """
        program = self._learners_home / self._inside(file).relative_to(self.home)
        if not program.is_file():
            self.timeline.add(ProgramMissing(self.timeline.now(), name, file))
            return None
        return self._launch(name, (str(program), *args), self._plain_programs())

    def execute(
        self, file: str, *args: str, name: str | None = None, env: Mapping[str, str] | None = None
    ) -> Process | None:
        """Start `./file args...` in the file's folder: its mode and its first line decide. As `python`."""
        return self._start_file(file, (f"./{Path(file).name}", *args), name, None, env)

    def probe(
        self, code: str | Path, *, name: str = "probe", cwd: str = "", timeout: float = PROBE_TIME
    ) -> None:
        """Run Python code of ours, or a file of it, beside the learner's; `recording.probe` has the answers.

        In it, `ask("sum", lambda: theirs.add(1, 2))` is one question, and modules of `cwd` (a folder of
        the home) can be imported.
        """
        folder = self._inside(cwd)
        if not folder.is_dir():
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
        """Judge the Python files in `folder` by these rules of ruff; `explain.lint.findings` has the result.

        The learner's own settings, and remarks that silence a rule, do not count.
        """
        with named_as_public(self._inside(folder)) as renamed:
            names = {str(Path(new).relative_to(self.home)): old for new, old in renamed.items()}

            def as_it_was(line: str) -> str:
                old = names.get(line.split(":")[0])
                return f"{old.relative_to(self.home)}:{line.partition(':')[2]}" if old else line

            where = str(self._inside(folder).relative_to(self.home))
            command = lint_command(where, rules)
            self._launch(name, command, self._plain_programs(), through=as_it_was).wait(timeout)

    def _start_file(
        self,
        file: str,
        command: Sequence[str],
        name: str | None,
        cwd: str | None,
        env: Mapping[str, str] | None,
    ) -> Process | None:
        path = self._inside(file)
        name = name or path.name
        if not path.is_file():
            self.timeline.add(ProgramMissing(self.timeline.now(), name, file))
            return None
        folder = path.parent if cwd is None else self._inside(cwd)
        return self._launch(name, command, {**self._programs(), **(env or {})}, folder, through=self._at_home)

    def _inside(self, path: str) -> Path:
        if Path(path).is_absolute() or ".." in Path(path).parts:
            raise OurFault(f"the scenario leaves the course home: {path}")
        return self.home / path

    def _at_home(self, line: str) -> str:
        """Paths in tracebacks as the learner knows them: nobody has seen the copy of the home."""
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
            start=start or self._confined,
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
            # A field of the wrong type is an exception that says so, and not an abort in C.
            "ROS_PYTHON_CHECK_FIELDS": "1",
            # Bytecode would be written into the build cache.
            "PYTHONDONTWRITEBYTECODE": "1",
            # Keeps the course's own ros2 command from starting its daemon.
            "ROS2COURSE_ARENA": "1",
        }
