"""The course home, the folder that replaces `~` for a learner: making it, finding it, and its course."""

from __future__ import annotations

import contextlib
import json
import os
import secrets
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from course.content.layout import STATE, WORKSPACE
from course.errors import StorageError, UsageError
from course.files import locked, sweep, write_atomic
from course.home.storage import inside, storing, write_new

SCHEMA_VERSION = 1
MARKER = "home.json"


@dataclass(frozen=True)
class CourseHome:
    """A folder made by `create_home`. `path` is absolute."""

    path: Path

    @property
    def state(self) -> Path:
        """The folder of the course's own files: progress, backups, the marker."""
        return self.path / STATE

    @property
    def workspace(self) -> Path:
        return self.path / WORKSPACE

    def seed(self) -> int:
        """The learner's own random number (63 bits), drawn once; it determines the learner's mysteries."""
        return read_marker(self.path)

    @contextlib.contextmanager
    def lock(self) -> Iterator[None]:
        """Only one command at a time changes the files of a home; others wait."""
        file = inside(self.path, f"{STATE}/lock")
        with contextlib.ExitStack() as stack:
            with storing("the course home cannot be written"):
                stack.enter_context(locked(file))
            yield


def is_home(path: Path) -> bool:
    """Whether `create_home` made this folder."""
    try:
        return (path / STATE / MARKER).is_file()
    except PermissionError:
        return False


def read_marker(path: Path) -> int:
    """The seed in the marker. Raises StorageError if it cannot be read, UsageError if it is too new."""
    file = path / STATE / MARKER
    with storing("the course home cannot be read"):
        content = file.read_bytes()
    try:
        marker = json.loads(content)
        schema, seed = int(marker["schema"]), int(marker["seed"])
    except (ArithmeticError, LookupError, RecursionError, TypeError, ValueError):  # somebody edited it
        raise StorageError(f"{file} is damaged", f"`ros2course init {path}` creates it again") from None
    if schema > SCHEMA_VERSION:
        raise UsageError(f"{path} was made by a newer ros2course", "upgrade ros2course, then try again")
    return seed


VARIABLE = "ROS2COURSE_HOME"
DEFAULT_NAME = "ros2course"


def find_home(
    option: Path | None = None, environ: Mapping[str, str] | None = None, cwd: Path | None = None
) -> CourseHome:
    """--home, else ROS2COURSE_HOME, else the current folder or one above it, else ~/ros2course.

    If one of the first two is given, it must be a course home. Raises UsageError.
    """
    environ = os.environ if environ is None else environ
    cwd = _here() if cwd is None else cwd
    if option is not None:
        return _named(_full(option, environ, cwd), "--home")
    if environ.get(VARIABLE):
        return _named(_full(Path(environ[VARIABLE]), environ, cwd), VARIABLE)
    default = default_home(environ)
    for folder in (cwd, *cwd.parents, default):
        if is_home(folder):
            return CourseHome(folder)
    raise UsageError(f"there is no course home here, nor at {default}", "create one: ros2course init")


def default_home(environ: Mapping[str, str] | None = None) -> Path:
    """Where `init` makes a home unless told otherwise."""
    return _user_home(os.environ if environ is None else environ) / DEFAULT_NAME


def _here() -> Path:
    try:
        return Path.cwd()
    except FileNotFoundError:
        what = "The folder you are in no longer exists."
        raise UsageError(what, "Go to another one: `cd`") from None


def _named(path: Path, by: str) -> CourseHome:
    if is_home(path):
        return CourseHome(path)
    reason = "is not a course home" if path.exists() else "does not exist"
    raise UsageError(f"{path} (from {by}) {reason}", f"create one there: ros2course init {path}")


def _full(path: Path, environ: Mapping[str, str], cwd: Path) -> Path:
    """The absolute path. One from a file or an editor may still start with `~`, which no shell expanded."""
    if path.parts[:1] == ("~",):
        path = _user_home(environ).joinpath(*path.parts[1:])
    return Path(os.path.normpath(cwd / path))


def _user_home(environ: Mapping[str, str]) -> Path:
    return Path(environ["HOME"]) if environ.get("HOME") else Path.home()


FOLDERS = (
    f"{WORKSPACE}/src",
    "ros2_tutorials_preamble/python",
    "sas_tutorial_workspace",
    "cmake_tutorial",
)
BASHRC = """\
# bash reads this file each time you open a terminal in your course home.
# It is yours. The lessons will ask you to add lines at its end.
"""


def create_home(path: Path) -> CourseHome:
    """Make `path` a course home, or complete the one that is there.

    A second call makes nothing. Raises UsageError if the path cannot be a course home, StorageError if it
    cannot be written.
    """
    home = CourseHome(Path(os.path.normpath(path.absolute())))
    _refuse(home.path)
    with storing(f"the course home {home.path} cannot be created"):
        for folder in ("", *FOLDERS, STATE):
            (inside(home.path, folder) if folder else home.path).mkdir(parents=True, exist_ok=True)
        with home.lock():
            sweep(home.path)
            sweep(home.state)
            write_new(inside(home.path, ".bashrc"), BASHRC.encode())
            _make_marker(home)  # last: a home with a marker is complete
    return home


def _refuse(path: Path) -> None:
    if path.exists() and not path.is_dir():
        raise UsageError(f"{path} is a file", "give the name of a new folder: ros2course init DIR")
    _damaged(path)  # raises UsageError if a newer ros2course made the home
    if not (path / STATE).exists() and _is_own_home(path):
        advice = f"choose a folder inside it: ros2course init {path / 'ros2course'}"
        raise UsageError(f"{path} is your own home, which the course leaves alone", advice)


def _damaged(path: Path) -> bool:
    """Whether the marker is unreadable. Raises UsageError if a newer ros2course wrote it."""
    try:
        if is_home(path):
            read_marker(path)
    except StorageError:
        return True
    return False


def _is_own_home(path: Path) -> bool:
    return path.exists() and Path.home().exists() and path.samefile(Path.home())


def _make_marker(home: CourseHome) -> None:
    """Keep a damaged marker under another name. Its seed is lost, so draw a new one."""
    if _damaged(home.path):
        (home.state / MARKER).replace(home.state / f"home.damaged-{secrets.token_hex(4)}.json")
    content = json.dumps({"schema": SCHEMA_VERSION, "seed": secrets.randbits(63)}, indent=2)
    write_new(inside(home.path, f"{STATE}/{MARKER}"), f"{content}\n".encode())


_COURSE_FILE = "course.txt"


def remember_course(home: CourseHome, folder: Path) -> None:
    """From now on, commands in this home use the course in `folder`."""
    with storing("the course home cannot be written"):
        write_atomic(inside(home.path, f"{home.state.name}/{_COURSE_FILE}"), f"{folder.absolute()}\n")


def remembered_course(home: CourseHome) -> Path | None:
    """The folder of the course that this home uses, if one is stored. Raises UsageError if it is gone."""
    file = home.state / _COURSE_FILE
    with storing("the course home cannot be read"):
        text = file.read_text(encoding="utf-8", errors="replace").strip() if file.is_file() else ""
    folder = Path(text) if text else None
    if folder is not None and not folder.is_dir():
        step = f"say where it is now: ros2course init {home.path} --course DIR"
        raise UsageError(f"the course of this home is gone: {folder}", step)
    return folder
