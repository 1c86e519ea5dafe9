"""Our own ROS packages for pip wheels: where they are, and the prefix that offers them.

`underlay/src` is a colcon workspace. Plain Python packages are used from their source folders; the others are
compiled when they are first needed. A learner's shell, a build and a node reach both through one prefix that
consists of links: `write_prefix` makes it, and `add_build` adds what was compiled.
"""

from __future__ import annotations

import re
import shlex
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from course.files import link, wipe, write_atomic
from course.rosenv.ros import Ros, digest

_COURSE = Path(__file__).parents[1]
_SCRIPT = re.compile(r"""["']\s*([\w.-]+)\s*=\s*([\w.]+):(\w+)\s*["']""")
_PROGRAM = re.compile(r"^add_executable\((\w+)", re.MULTILINE)
INTERFACE_FOLDERS = ("msg", "srv", "action")


@dataclass(frozen=True)
class UnderlayPackage:
    """One package. `compiled`: it contains more than Python, and must be built first."""

    name: str
    folder: Path
    compiled: bool

    @property
    def modules(self) -> tuple[Path, ...]:
        """The folders of its Python packages that are used directly."""
        return tuple(sorted(file.parent for file in self.folder.glob("*/__init__.py")))

    @property
    def interfaces(self) -> tuple[str, ...]:
        """The interfaces that it defines, as in the ament index: `msg/Bool.msg`, `srv/AddTwoInts.srv`."""
        found = (file for kind in INTERFACE_FOLDERS for file in self.folder.glob(f"{kind}/*.{kind}"))
        return tuple(sorted(file.relative_to(self.folder).as_posix() for file in found))

    @property
    def scripts(self) -> tuple[tuple[str, str, str], ...]:
        """Its console scripts: name, module and function of each."""
        setup = self.folder / "setup.py"
        return tuple(_SCRIPT.findall(setup.read_text(encoding="utf-8"))) if setup.exists() else ()

    @property
    def programs(self) -> tuple[str, ...]:
        """The programs that its build puts into `lib/<package>`, according to its CMakeLists.txt."""
        return tuple(_PROGRAM.findall((self.folder / "CMakeLists.txt").read_text(encoding="utf-8")))

    @property
    def scripts_folder(self) -> str:
        """Where the scripts are installed, relative to a prefix: `bin`, or `lib/<package>`."""
        setting = (self.folder / "setup.cfg").read_text(encoding="utf-8")
        return "bin" if "install_scripts=$base/bin" in setting else f"lib/{self.name}"


def source_root() -> Path | None:
    """The underlay's workspace: next to the engine in a checkout, else inside it; None if it was left out."""
    for root in (_COURSE.parent / "underlay", _COURSE / "_course" / "underlay"):
        if (root / "src").is_dir():
            return root
    return None


def packages_in(root: Path) -> tuple[UnderlayPackage, ...]:
    """All packages of the workspace `root`, by name."""
    folders = sorted(file.parent for file in (root / "src").glob("*/package.xml"))
    return tuple(
        UnderlayPackage(folder.name, folder, (folder / "CMakeLists.txt").exists()) for folder in folders
    )


def fingerprint(packages: Iterable[UnderlayPackage]) -> str:
    """A text that changes if a package is added, removed, or must be arranged or compiled differently."""
    return digest(line for package in packages for line in _lines(package))


def _lines(package: UnderlayPackage) -> list[str]:
    # A module that is used directly may change at any time: only its place counts.
    if not package.compiled:
        fixed = [package.folder / name for name in ("package.xml", "setup.py", "setup.cfg")]
        return [*map(str, package.modules), *map(_content, fixed)]
    files = (file for file in sorted(package.folder.rglob("*")) if file.is_file() and file.suffix != ".pyc")
    built = (file for file in files if not any(map(file.is_relative_to, package.modules)))
    return [str(package.folder), *map(str, package.modules), *map(_content, built)]


def _content(file: Path) -> str:
    return f"{file} {file.read_text(encoding='utf-8', errors='surrogateescape')}"


STANDINS = "standins"
_INDEX = "share/ament_index/resource_index"


def write_prefix(
    prefix: Path, packages: Iterable[UnderlayPackage], ros: Ros, *, setup: Path, cache: Path
) -> None:
    """Make the prefix again. `setup` is the script that sources it together with the wheels.

    Call this under a lock. Compiled packages of an earlier prefix must be added again; `cache` is where the
    course keeps things that it can make again. The prefix is a link to a folder next to it, so a process
    that is using the earlier one never finds it half-made.
    """
    prefix.parent.mkdir(parents=True, exist_ok=True)
    folder = Path(tempfile.mkdtemp(prefix=f"{prefix.name}.", dir=prefix.parent))
    folder.chmod(0o755)
    _fill(folder, packages, ros, Builder(ros.python, cache), prefix)
    for shell in ("sh", "bash", "zsh"):
        write_atomic(folder / f"local_setup.{shell}", f". {shlex.quote(str(setup))}\n")
    link(prefix, folder)
    for other in prefix.parent.glob(f"{prefix.name}.*"):
        if other != folder:
            wipe(other)


def _fill(
    folder: Path, packages: Iterable[UnderlayPackage], ros: Ros, builder: Builder, prefix: Path
) -> None:
    for shared in (folder / "bin", folder / "lib", site_packages(folder, ros)):
        shared.mkdir(parents=True, exist_ok=True)
    for package in packages:
        _register(folder, package)
        for module in package.modules:
            link(site_packages(folder, ros) / module.name, module)
        if package.compiled:
            _stand_in(folder, package, ros, builder, prefix)
        _offer_scripts(folder, package, ros)


def site_packages(prefix: Path, ros: Ros) -> Path:
    """The folder of the prefix from which Python imports; it has the same name as that of the wheels."""
    return prefix / "lib" / ros.python_packages.parent.name / "site-packages"


def _register(folder: Path, package: UnderlayPackage) -> None:
    link(folder / "share" / package.name / "package.xml", package.folder / "package.xml")
    write_atomic(folder / _INDEX / "packages" / package.name, "")
    for kind in (*INTERFACE_FOLDERS, "launch"):
        # In a pure Python package, `launch` is a module.
        if package.compiled and (package.folder / kind).is_dir():
            link(folder / "share" / package.name / kind, package.folder / kind)
    if package.interfaces:
        write_atomic(folder / _INDEX / "rosidl_interfaces" / package.name, "\n".join(package.interfaces))


def _offer_scripts(folder: Path, package: UnderlayPackage, ros: Ros) -> None:
    for name, source, function in package.scripts:
        script = folder / package.scripts_folder / name
        write_atomic(script, console_script(ros.python, source, function))
        script.chmod(0o755)


def _stand_in(folder: Path, package: UnderlayPackage, ros: Ros, builder: Builder, prefix: Path) -> None:
    """Make a replacement for the package until it is built; a build replaces the links to it."""
    name, own = package.name, folder / STANDINS / package.name
    found = Path("share", name, "cmake")
    config = cmake_standin(name, own / "cmake", prefix / found, builder)
    write_atomic(own / "cmake" / f"{name}Config.cmake", config)
    link(folder / found, own / "cmake")
    for program in package.programs:
        script = own / "lib" / program
        write_atomic(script, program_standin(name, own / "lib", prefix / "lib" / name / program, builder))
        script.chmod(0o755)
        link(folder / "lib" / name, own / "lib")
    if package.interfaces:
        imported = python_standin(name, site_packages(prefix, ros) / name, builder)
        write_atomic(own / "python" / "__init__.py", imported)
        link(site_packages(folder, ros) / name, own / "python")


# Folders that packages share; whatever else is in an install prefix belongs to its package alone.
_PROGRAMS = ("bin", "include", "lib", "lib/python3*", "lib/python3*/site-packages")
_SHARED = (*_PROGRAMS, "share", "share/*", "share/ament_index/*", "share/ament_index/resource_index/*")
# Files directly in these folders are only for `built`: colcon's setup files, and its records.
_ALONE = (Path(), Path("share/colcon-core"))


def add_build(prefix: Path, built: Path) -> None:
    """Link everything of the install prefix `built` into `prefix`.

    The parts by which processes find a package come last, so that they find all of it.
    """
    for part in sorted(_parts(built, Path()), key=_is_awaited):
        link(prefix / part, built / part)


def is_built(prefix: Path, package: str) -> bool:
    """Whether the prefix contains `package` itself, and not its replacement."""
    found = (prefix / "share" / package / "cmake").resolve()
    return found.is_dir() and not found.is_relative_to((prefix / STANDINS).resolve())


def _parts(built: Path, folder: Path) -> Iterator[Path]:
    """Files and folders to link as a whole, relative to `built`."""
    for entry in sorted((built / folder).iterdir()):
        part = folder / entry.name
        if entry.is_dir() and not entry.is_symlink() and _is_shared(part):
            yield from _parts(built, part)
        elif folder not in _ALONE:
            yield part


def _is_shared(part: Path) -> bool:
    depth = len(part.parts) - 1
    return any(part.match(pattern) for pattern in _SHARED if pattern.count("/") == depth)


def _is_awaited(part: Path) -> bool:
    return part.name == "cmake" or "site-packages" in part.parts


_ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Builder:
    """How a stand-in calls the course: `python` runs it, and `cache` is its cache folder."""

    python: Path
    cache: Path

    def words(self, package: str) -> list[str]:
        """The command that builds `package`; it works in any folder and with any PYTHONPATH."""
        code = f"import sys; sys.path.insert(0, {str(_ROOT)!r}); from course.cli.main import run; run()"
        return [str(self.python), "-I", "-c", code, "build-underlay", package]

    @property
    def variables(self) -> dict[str, str]:
        """The variables that the command needs, because a build may have changed its HOME."""
        return {"ROS2COURSE_CACHE": str(self.cache), "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1"}


def console_script(python: Path, module: str, function: str) -> str:
    """A console script. Its first lines are for the shell: a `#!` line allows no long paths, and no spaces.

    Ctrl+C while it loads ends it without a traceback; after that, the function handles it.
    """
    return f"""\
#!/bin/sh
'''exec' "{python}" "$0" "$@"
' '''
import signal
import sys

_hears_ctrl_c = signal.getsignal(signal.SIGINT) is signal.default_int_handler
if _hears_ctrl_c:
    signal.signal(signal.SIGINT, signal.SIG_DFL)

from {module} import {function}

if _hears_ctrl_c:
    signal.signal(signal.SIGINT, signal.default_int_handler)

if __name__ == "__main__":
    sys.exit({function}())
"""


def cmake_standin(package: str, own: Path, real: Path, builder: Builder) -> str:
    """A <package>Config.cmake for the folder `own`: builds the package, then includes the one in `real`.

    Until then, `real` is a link to `own`.
    """
    set_variables = [f"{name}={value}" for name, value in builder.variables.items()]
    command = _cmake_words(["-E", "env", *set_variables, *builder.words(package)])
    return f"""\
# {package} is built when it is first needed; after that, this file is no longer found.
get_filename_component(_ros2course_here [==[{own}]==] REALPATH)
get_filename_component(_ros2course_found [==[{real}]==] REALPATH)
if(_ros2course_found STREQUAL _ros2course_here)
  message(STATUS "Building {package}, only this once")
  execute_process(COMMAND ${{CMAKE_COMMAND}} {command} RESULT_VARIABLE _ros2course_failed)
  if(_ros2course_failed)
    message(FATAL_ERROR "{package} could not be built; the reason is above.")
  endif()
endif()
set({package}_DIR [==[{real}]==])
include([==[{real}/{package}Config.cmake]==])
"""


def python_standin(package: str, real: Path, builder: Builder) -> str:
    """A Python package that has the one in `real` built, and then takes its place."""
    return f'''\
"""{package} is built when it is first imported; after that, this file is no longer found."""

import os
import pathlib
import subprocess
import sys

_here, _real = pathlib.Path(__file__).resolve(), pathlib.Path({str(real)!r}, "__init__.py")
if _real.resolve() == _here:
    if os.environ.get("ROS2COURSE_ARENA"):
        raise ImportError("{package} was not built before it was needed")
    _environment = {{**os.environ, **{builder.variables!r}}}
    if subprocess.run({builder.words(package)!r}, env=_environment, stdout=sys.stderr).returncode:
        raise ImportError("{package} could not be built; the reason is above")
__path__, __file__ = [str(_real.parent)], str(_real)
exec(compile(_real.read_bytes(), __file__, "exec"))
'''


def program_standin(package: str, own: Path, real: Path, builder: Builder) -> str:
    """A program for the folder `own` that has the package built, and then executes the one in `real`."""
    variables = " ".join(shlex.quote(f"{name}={value}") for name, value in builder.variables.items())
    return f"""\
#!/bin/sh
# {package} is built when it is first run; after that, this file is no longer found.
real={shlex.quote(str(real))}
if [ "$(readlink -f "$real")" = "$(readlink -f {shlex.quote(str(own / real.name))})" ]; then
    env {variables} {shlex.join(builder.words(package))} >&2 || exit 1
fi
exec "$real" "$@"
"""


def _cmake_words(words: Sequence[str]) -> str:
    return " ".join(f"[==[{word}]==]" for word in words)
