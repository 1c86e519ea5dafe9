"""The part of an arena that compiles and runs the learner's C++ files: `arena.cpp`.

It also builds the course's own projects against the learner's installed packages: only a second package
shows whether the first one exports everything that it should.

Compilers run where programs do, confined to the scratch home, because the learner's files tell them what to
read.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from course.arena import toolchain
from course.arena.home_programs import HomePrograms
from course.arena.probe import collect_answers
from course.arena.process import Process
from course.errors import OurFault
from course.model.events import OutputLine, ProgramMissing
from course.rosenv.host import require, require_libraries

_CHECKED = "sanitizers"
BUILD_TIME = 90.0
# Other programs may be under observation, and must not have to wait for a processor.
_BEHIND_OTHERS = ("nice", "-n", "10")
_LIBRARIES = "LD_LIBRARY_PATH"
_AFTER_SOURCING = '. "$1" && exec "$2"'


class CppPrograms:
    """Compiles, runs and probes the learner's C++, and builds projects of ours that use their packages."""

    def __init__(self, home: HomePrograms) -> None:
        self._home = home

    def require_libraries(self, *names: str) -> None:
        """Raise MissingHere if this machine lacks a C++ library (`Eigen3`, `Qt5Core`)."""
        require_libraries(names)

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
        """Compile C++ files of the home into a program. On failure returns None and records the reason.

        sources: files or patterns (`project/*.cpp`) in the home. without: a file that a pattern matches, to
        leave out. ours: a file of the course to compile with them; it can include `ask.hpp`, and headers by
        their path in the home. heap: the program answers "never freed" with the number of blocks, and the
        size and line of some. options: for the compiler, after the files. sanitized: with the address and
        undefined-behavior sanitizers; the `Grader` then needs `sanitizers=True`.
        """
        files = self._files(name, sources, without)
        if files is None:
            return None
        given = [self._home.handed(file) for file in ((ours,) if ours else ())]
        if heap:
            given.append(self._home.handed(toolchain.HEAP))
        if given:
            self._home.handed(toolchain.ASK)
        own = ("-I.", f"-I{self._home._ours}") if given else ()
        output = self._home._folder / f"{name}.program"
        command = toolchain.compile_command(
            [*files, *given], output, options=(*own, *options), sanitized=sanitized
        )
        if self._home.tool(*command, name=compiling(name), env=env):
            return output
        if sanitized:
            self._require_sanitizers(compiling(name))
        return None

    def ros_options(self, *libraries: str) -> tuple[str, ...]:
        """Return the options of `compile` for files that include ROS headers and use these ROS libraries."""
        prefixes = self._home._environment.get("AMENT_PREFIX_PATH", "").split(":")
        return toolchain.ros_options((Path(prefix) for prefix in prefixes if prefix), libraries)

    @property
    def ros_libraries(self) -> Mapping[str, str]:
        """The environment that a program linked with ROS libraries by `compile` needs to run."""
        known = self._home._environment
        return {name: known[name] for name in (_LIBRARIES,) if name in known}

    def run(
        self, program: Path | None, *arguments: str, name: str, env: Mapping[str, str] | None = None
    ) -> Process | None:
        """Start a program that `compile` made, in the home and in its own terminal; None if it made none."""
        if program is None:
            return None
        environment = {**toolchain.running(self._home._plain_programs()), **(env or {})}
        return self._home._launch(
            name, toolchain.steady((str(program), *arguments)), environment, through=self._home._at_home
        )

    def ask(
        self,
        program: Path | None,
        *arguments: str,
        name: str,
        timeout: float = toolchain.RUN_TIME,
        env: Mapping[str, str] | None = None,
    ) -> None:
        """Run a program that `compile` made to its end, and record its answers: `recording.probe(name)`."""
        if program is None:
            return

        def launch(writing: int) -> Process:
            environment = {
                **toolchain.running(self._home._plain_programs()),
                toolchain.ANSWERS: str(writing),
                **(env or {}),
            }
            command = toolchain.steady((str(program), *arguments))
            return self._home._launch(
                name, command, environment, through=self._home._at_home, descriptors=(writing,)
            )

        collect_answers(launch, self._home.timeline, name, timeout, start_time=timeout)

    def build_project(self, name: str, project: Path) -> Path | None:
        """Build a CMake project on top of ROS and the learner's packages; returns None if that fails.

        project: a folder whose CMakeLists.txt makes the program `name`; `${ASK}` is the folder of
        `ask.hpp`. The output of CMake is recorded as `configure NAME`, that of the compiler and linker as
        `compile NAME`. To run the program, use `ask(..., env=arena.cpp.ros_libraries)`.
        """
        source, build = self._home.handed(project), self._home._folder / f"{name}.build"
        self._home.handed(toolchain.ASK)
        options = (f"-DASK={self._home._ours}", f"-DPython3_EXECUTABLE={self._home._python}")
        configured = self._cmake("-S", source, "-B", str(build), *options, name=configuring(name))
        built = configured and self._cmake("--build", str(build), name=compiling(name))
        return build / name if built else None

    def ask_sourced(self, program: Path | None, package: str, *, name: str) -> None:
        """Like `ask`, in a shell that knows the learner's package only through the package's own setup file.

        colcon's own setup files add library folders by themselves, hiding that a package does not.
        """
        if program is None:
            return
        prefixes = self._home._environment.get("AMENT_PREFIX_PATH", "").split(":")
        scripts = (Path(prefix, "share", package, "local_setup.bash") for prefix in prefixes)
        setup = next((script for script in scripts if script.is_file()), None)
        if setup is None:
            raise OurFault(f"{package} is not built for this exercise")
        prefix = setup.parents[2]
        others = (folder for folder in self.ros_libraries.get(_LIBRARIES, "").split(":"))
        kept = ":".join(folder for folder in others if not Path(folder).is_relative_to(prefix))
        shell = ("-c", _AFTER_SOURCING, "bash", str(setup), str(program))
        self.ask(Path("/bin/bash"), *shell, name=name, env={_LIBRARIES: kept})

    def _files(self, name: str, sources: Sequence[str], without: str) -> list[str] | None:
        """The sources as the compiler gets them: relative to the home, as its messages should name them."""
        found: list[str] = []
        for source in sources:
            self._home._inside(source)
            matching = self._home.files.matching(source)
            if not matching:  # otherwise, only the linker would complain
                self._home.timeline.add(ProgramMissing(self._home.timeline.now(), compiling(name), source))
                return None
            # The compiler must not take a learner's file name for an option.
            named = (f"./{file}" if file.startswith(("-", "@")) else file for file in matching)
            found.extend(file for file in named if file != without)
        return found

    def _require_sanitizers(self, failed: str) -> None:
        """Raise MissingHere if the compiler cannot build anything with the sanitizers."""
        said = (line.text for line in self._home.timeline.of(OutputLine) if line.process == failed)
        if not toolchain.may_lack_sanitizers(said):
            return
        source = self._home._ours / "nothing.cpp"
        source.write_text("int main() {}\n", encoding="utf-8")
        command = toolchain.compile_command([str(source)], self._home._folder / "nothing.program")
        if not self._home.tool(*command, name=_CHECKED):
            raise toolchain.no_sanitizers()

    def _cmake(self, *arguments: str, name: str) -> bool:
        environment = toolchain.compiling(self._home._programs())
        require(("cmake",), environment.get("PATH", ""))
        command = (*_BEHIND_OTHERS, "cmake", *arguments)
        return self._home.tool(*command, name=name, env=environment, timeout=BUILD_TIME)


def compiling(name: str) -> str:
    """What the recording calls the run of the compiler that makes the program `name`."""
    return f"compile {name}"


def configuring(name: str) -> str:
    """What the recording calls the run of CMake for the project `name`."""
    return f"configure {name}"
