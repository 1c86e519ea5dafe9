"""What `doctor` looks at. Each function looks at one thing and never raises for what it finds."""

from __future__ import annotations

import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from importlib import metadata, util
from pathlib import Path

from course.cli.desk import home_of
from course.cli.options import Options
from course.cli.words import spoken, typed
from course.errors import CourseError
from course.report.machine import Finding, State
from course.rosenv.paths import cache_dir

OLDEST_PYTHON = (3, 10)
GIBIBYTE = 2**30
ENOUGH_SPACE = 2 * GIBIBYTE
LEAST_SPACE = GIBIBYTE // 4
CLOCK_TOLERANCE = 2.0  # seconds between this machine's clock and its file system's
NOT_BEFORE = 2026
_FULL = "programs run as a user without rights, without network or sight of your files"


def find_all(options: Options) -> list[Finding]:
    """Everything `doctor` shows, in its order."""
    cache = cache_dir(os.environ)
    return [
        ros(),
        python(),
        colcon(),
        program("g++", "g++"),
        program("cmake", "cmake"),
        program("make", "make"),
        program("bash", "bash"),
        containment(),
        course_home(options),
        storage("cache", cache),
        clock(cache),
    ]


def ros() -> Finding:
    """Which ROS 2 nodes are built for and run with."""
    from course.rosenv import find_ros, prepare

    try:
        found = find_ros()
        prepare(found)
    except CourseError as error:
        return Finding("ROS 2", State.MISSING, error.what, spoken(error.next_step or ""))
    origin = {"sourced": "sourced in this shell", "installed": "installed", "pip": "from pip"}[found.origin]
    notes = " ".join(found.notes)
    return Finding("ROS 2", State.OK, f"{found.distro}, {origin}, in {found.prefix}. {notes}".strip(" "))


def python() -> Finding:
    """The Python that runs the course."""
    found = f"{platform.python_version()}, {sys.executable}"
    if sys.version_info[:2] < OLDEST_PYTHON:
        return Finding("Python", State.MISSING, found, "Python 3.10 or newer is needed.")
    return Finding("Python", State.OK, found)


def colcon() -> Finding:
    """colcon builds the learner's packages: a module of this Python, or a command."""
    if util.find_spec("colcon_core"):
        return Finding("colcon", State.OK, f"colcon-core {metadata.version('colcon-core')}")
    if command := shutil.which("colcon"):
        return Finding("colcon", State.OK, command)
    step = f"`{shlex.quote(sys.executable)} -m pip install colcon-common-extensions`"
    return Finding("colcon", State.MISSING, "not found", step)


def program(name: str, package: str) -> Finding:
    """A program that building and working need."""
    command = shutil.which(name)
    if command is None:
        return Finding(name, State.MISSING, "not found", f"Install it: {install(package)}")
    return Finding(name, State.OK, f"{_first_line(command, '--version')}, {command}")


def containment() -> Finding:
    """Whether submissions can be contained here, and checks of one's own code kept apart."""
    from course.arena.containment import sandbox_obstacle
    from course.arena.enclosure import namespace_obstacle
    from course.arena.restrictions import restriction

    obstacle = sandbox_obstacle()
    if obstacle is None:
        return Finding("containment", State.OK, f"full: {_FULL}; {_bounds()}")
    own = "Checks of your own code work without it; `grade` asks for --no-sandbox."
    found = restriction()
    if found is not None:
        return Finding("containment", State.LESS, f"{obstacle}. {found.what}", f"{found.step} {own}")
    if namespace_obstacle() is None:
        return Finding("containment", State.LESS, f"one layer of two: {obstacle}", own)
    inside = "This is a container: start it so that bubblewrap works in it. " if _in_container() else ""
    return Finding("containment", State.LESS, obstacle, f"{inside}{own}")


def _bounds() -> str:
    from course.arena.sandbox.control_groups import available

    if available():
        return "bounds on memory and processes are the kernel's (control groups)"
    return "bounds on memory and processes are watched (no control groups here)"


def _in_container() -> bool:
    return any(Path(mark).exists() for mark in ("/.dockerenv", "/run/.containerenv"))


def course_home(options: Options) -> Finding:
    """Where the learner's work lies, and whether it can be written."""
    try:
        return storage("course home", home_of(options).path)
    except CourseError as error:
        return Finding("course home", State.LESS, error.what, f"`{typed('next')}` makes one.")


def storage(name: str, folder: Path) -> Finding:
    """Whether files can be made in a folder, and whether its disk has room for builds."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            free = shutil.disk_usage(folder).free
    except OSError as error:
        step = (
            f"See to the owner and the rights of {folder}, and to its disk: `ls -ld {folder}; df {folder}`."
        )
        return Finding(name, State.MISSING, f"{folder}: {error.strerror}", step)
    found = f"{folder}, {free / GIBIBYTE:.1f} GiB free"
    if free >= ENOUGH_SPACE:
        return Finding(name, State.OK, found)
    state = State.LESS if free >= LEAST_SPACE else State.MISSING
    return Finding(name, state, found, f"Make room on the disk of {folder}.")


def clock(folder: Path) -> Finding:
    """A wrong clock, or a file system with another one, makes builds miss changes."""
    now = time.time()
    today = time.strftime("%Y-%m-%d %H:%M:%S")
    if time.gmtime(now).tm_year < NOT_BEFORE:
        return Finding("clock", State.MISSING, today, "Set the clock: `sudo date -s 'YYYY-MM-DD hh:mm'`.")
    try:
        with tempfile.NamedTemporaryFile(dir=folder) as file:
            apart = abs(Path(file.name).stat().st_mtime - now)
    except OSError:
        return Finding("clock", State.OK, today)
    if apart > CLOCK_TOLERANCE:
        step = f"Use a course home and a cache on a local disk, or set the clock of the server of {folder}."
        return Finding("clock", State.LESS, f"files are stamped {apart:.0f} s off", step)
    return Finding("clock", State.OK, today)


def install(package: str) -> str:
    """How to install a Debian package here, or what to look for elsewhere."""
    if shutil.which("apt-get"):
        return f"`sudo apt install {package}`"
    return f"the package `{package}`, with this system's package manager"


def _first_line(*command: str) -> str:
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=10, check=False)
    except (OSError, subprocess.SubprocessError):
        return "does not start"
    return (done.stdout.splitlines() or ["says nothing"])[0]
