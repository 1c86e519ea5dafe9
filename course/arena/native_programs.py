"""The part of an arena that compiles the learner's C++ files, and runs what comes of it.

Compilers run where programs do, in the scratch home and confined: they read what the learner's files tell
them to read.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from course.arena import native
from course.arena.home_programs import HomePrograms
from course.arena.probe import collect_answers
from course.arena.process import Process
from course.evidence.events import OutputLine, ProcessExited, ProgramMissing
from course.rosenv.libraries import require_libraries

_CHECKED = "sanitizers"


class NativePrograms(HomePrograms):
    """Programs of this machine's compilers, and what they make."""

    def require(self, *tools: str) -> None:
        """Raise MissingHere, with the command that installs it, when this machine lacks one of them."""
        native.require(tools, self._plain_programs().get("PATH", ""))

    def require_libraries(self, *names: str) -> None:
        """Raise MissingHere, likewise, when this machine lacks a C++ library (`Eigen3`, `Qt5Core`)."""
        require_libraries(names)

    def tool(
        self,
        *command: str,
        name: str,
        cwd: str = "",
        env: Mapping[str, str] | None = None,
        timeout: float = native.COMPILE_TIME,
    ) -> bool:
        """Run a program of this machine (`cmake`, `make`) in the folder `cwd` of the home, to its end.

        Its words are recorded, with `~` for the home; True if it ended well within `timeout` s. Raises
        MissingHere, with the command that installs it, when it is not there.
        """
        environment = {**native.compiling(self._plain_programs()), **(env or {})}
        native.require(command[:1], environment.get("PATH", ""))
        process = self._launch(name, command, environment, self._inside(cwd), through=self._at_home)
        if not process.wait(timeout):
            process.close()
        return any(e.process == name and e.code == 0 for e in self.timeline.of(ProcessExited))

    def compile(
        self,
        name: str,
        *sources: str,
        ours: Path | None = None,
        without: str = "",
        heap: bool = False,
        options: Sequence[str] = (),
        sanitized: bool = True,
        env: Mapping[str, str] | None = None,
    ) -> Path | None:
        """Make a program of C++ files of the home; None if it cannot be made, which the recording explains.

        sources: files, or patterns (`project/*.cpp`), relative to the home; without: one that a pattern would
        take in. ours: a file of the course's that is compiled with them; it finds `ask.hpp`, and headers of
        the home by their path from there. heap: the program answers "never freed" with a number of blocks
        and, of some, size and line. options: for the compiler, after the files. sanitized: with the address
        and the undefined-behaviour sanitizer, for which the `Grader` says `sanitizers=True`.
        """
        files = self._files(name, sources, without)
        if files is None:
            return None
        given = [self._handed(file) for file in ((ours,) if ours else ())]
        if heap:
            given.append(self._handed(native.HEAP))
        if given:
            self._handed(native.ASK)
        own = ("-I.", f"-I{self._ours}") if given else ()
        output = self._folder / f"{name}.program"
        command = native.compile_command(
            [*files, *given], output, options=(*own, *options), sanitized=sanitized
        )
        if self.tool(*command, name=compiling(name), env=env):
            return output
        if sanitized:
            self._require_sanitizers(compiling(name))
        return None

    def ros_options(self, *libraries: str) -> tuple[str, ...]:
        """Options of `compile` for files that include headers of ROS, and what they use of its libraries."""
        prefixes = self._environment.get("AMENT_PREFIX_PATH", "").split(":")
        return native.ros_options((Path(prefix) for prefix in prefixes if prefix), libraries)

    @property
    def ros_libraries(self) -> Mapping[str, str]:
        """What a program that `compile` linked with libraries of ROS needs in its environment to run."""
        return {name: self._environment[name] for name in ("LD_LIBRARY_PATH",) if name in self._environment}

    def run_native(
        self, program: Path | None, *arguments: str, name: str, env: Mapping[str, str] | None = None
    ) -> Process | None:
        """Start a program that `compile` made, in the home, on a terminal of its own; None without one."""
        if program is None:
            return None
        environment = {**native.running(self._plain_programs()), **(env or {})}
        return self._launch(
            name, native.steady((str(program), *arguments)), environment, through=self._at_home
        )

    def ask_native(
        self,
        program: Path | None,
        *arguments: str,
        name: str,
        timeout: float = native.RUN_TIME,
        env: Mapping[str, str] | None = None,
    ) -> None:
        """Run such a program to its end, and record what it answered: `recording.probe(name)`."""
        if program is None:
            return

        def launch(writing: int) -> Process:
            environment = {
                **native.running(self._plain_programs()),
                native.ANSWERS: str(writing),
                **(env or {}),
            }
            command = native.steady((str(program), *arguments))
            return self._launch(name, command, environment, through=self._at_home, descriptors=(writing,))

        collect_answers(launch, self.timeline, name, timeout, start_time=timeout)

    def _files(self, name: str, sources: Sequence[str], without: str) -> list[str] | None:
        """The sources as the compiler is given them: from the home, as messages are to name them."""
        found: list[str] = []
        for source in sources:
            self._inside(source)
            matching = sorted(
                str(path.relative_to(self.home)) for path in self.home.glob(source) if path.is_file()
            )
            if not matching:  # else the linker says what is missing
                self.timeline.add(ProgramMissing(self.timeline.now(), compiling(name), source))
                return None
            # A name of the learner's must not be taken for an option.
            named = (f"./{file}" if file.startswith(("-", "@")) else file for file in matching)
            found.extend(file for file in named if file != without)
        return found

    def _handed(self, file: Path) -> str:
        """A copy of a file of the course's, where programs can read it and nobody of theirs can write."""
        copy = self._ours / file.name
        copy.write_text(file.read_text(encoding="utf-8"), encoding="utf-8")
        return str(copy)

    def _require_sanitizers(self, failed: str) -> None:
        """Raise MissingHere if the compiler could not have made anything with them."""
        said = (line.text for line in self.timeline.of(OutputLine) if line.process == failed)
        if not native.may_lack_sanitizers(said):
            return
        source = self._ours / "nothing.cpp"
        source.write_text("int main() {}\n", encoding="utf-8")
        command = native.compile_command([str(source)], self._folder / "nothing.program")
        if not self.tool(*command, name=_CHECKED):
            raise native.no_sanitizers()


def compiling(name: str) -> str:
    """What the recording calls the compiler's run for the program `name`."""
    return f"compile {name}"
