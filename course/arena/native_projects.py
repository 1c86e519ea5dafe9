"""The part of an arena that builds a project of the course's with what the learner's packages install.

What a package leaves for others shows only when another one uses it.
"""

from __future__ import annotations

from pathlib import Path

from course.arena import native
from course.arena.native_programs import NativePrograms, compiling
from course.errors import OurFault

BUILD_TIME = 90.0
# Other programs may be watched meanwhile, and must not wait for a processor.
_BEHIND_OTHERS = ("nice", "-n", "10")
_LIBRARIES = "LD_LIBRARY_PATH"
_AFTER_SOURCING = '. "$1" && exec "$2"'


class NativeProjects(NativePrograms):
    """Packages of the course's own that use the learner's."""

    def build_project(self, name: str, project: Path) -> Path | None:
        """Build a CMake project on top of ROS and the learner's packages; None if that fails.

        project: a folder of files whose CMakeLists.txt makes the program `name`, and gets the folder of
        `ask.hpp` as `${ASK}`. What CMake says is recorded as `configure NAME`, and what the compiler and
        the linker say as `compile NAME`. To run it, `ask_native(..., env=arena.ros_libraries)`.
        """
        source, build = self._ours / name, self._folder / f"{name}.build"
        source.mkdir()
        for file in sorted(project.iterdir()):
            (source / file.name).write_text(file.read_text(encoding="utf-8"), encoding="utf-8")
        self._handed(native.ASK)
        options = (f"-DASK={self._ours}", f"-DPython3_EXECUTABLE={self._python}")
        configured = self._cmake("-S", str(source), "-B", str(build), *options, name=configuring(name))
        built = configured and self._cmake("--build", str(build), name=compiling(name))
        return build / name if built else None

    def ask_sourced(self, program: Path | None, package: str, *, name: str) -> None:
        """As `ask_native`, in a shell that knows of the learner's package only what its own setup says.

        colcon adds folders of its own to that; where a package was installed without colcon, nobody does.
        """
        if program is None:
            return
        prefixes = self._environment.get("AMENT_PREFIX_PATH", "").split(":")
        scripts = (Path(prefix, "share", package, "local_setup.bash") for prefix in prefixes)
        setup = next((script for script in scripts if script.is_file()), None)
        if setup is None:
            raise OurFault(f"{package} is not built for this exercise")
        prefix = setup.parents[2]
        others = (folder for folder in self.ros_libraries.get(_LIBRARIES, "").split(":"))
        kept = ":".join(folder for folder in others if not Path(folder).is_relative_to(prefix))
        shell = ("-c", _AFTER_SOURCING, "bash", str(setup), str(program))
        self.ask_native(Path("/bin/bash"), *shell, name=name, env={_LIBRARIES: kept})

    def _cmake(self, *arguments: str, name: str) -> bool:
        environment = native.compiling(self._programs())
        native.require(("cmake",), environment.get("PATH", ""))
        command = (*_BEHIND_OTHERS, "cmake", *arguments)
        return self.tool(*command, name=name, env=environment, timeout=BUILD_TIME)


def configuring(name: str) -> str:
    """What the recording calls CMake's look at the project `name`."""
    return f"configure {name}"
