"""`doctor`: what the course finds on this machine, and what to do about what is missing."""

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

import typer

from course import isolation
from course.cli.options import Options, options_of
from course.cli.session import home_of
from course.cli.usage import examples, spoken, typed
from course.errors import CourseError, ExitCode
from course.files import cache_dir
from course.isolation import Level
from course.isolation.identity import available
from course.isolation.levels import obstacle_to
from course.report.console import open_console
from course.report.problem import MachineFinding, State, render_findings
from course.rosenv import find_ros, prepare

OLDEST_PYTHON = (3, 10)
GIBIBYTE = 2**30
ENOUGH_SPACE = 2 * GIBIBYTE
LEAST_SPACE = GIBIBYTE // 4
CLOCK_TOLERANCE = 2.0  # seconds between this machine's clock and its file system's
NOT_BEFORE = 2026
_FULL = "programs run as an unprivileged user, without network access or access to your files"


def find_all(options: Options) -> list[MachineFinding]:
    """Everything that `doctor` shows, in order."""
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


def ros() -> MachineFinding:
    """The ROS 2 with which nodes are built and run."""
    try:
        found = find_ros()
        prepare(found)
    except CourseError as error:
        return MachineFinding("ROS 2", State.MISSING, error.what, spoken(error.next_step or ""))
    origin = {"sourced": "sourced in this shell", "installed": "installed", "pip": "from pip"}[found.origin]
    notes = " ".join(found.notes)
    return MachineFinding(
        "ROS 2", State.OK, f"{found.distro}, {origin}, in {found.prefix}. {notes}".strip(" ")
    )


def python() -> MachineFinding:
    """The Python that runs the course."""
    found = f"{platform.python_version()}, {sys.executable}"
    if sys.version_info[:2] < OLDEST_PYTHON:
        return MachineFinding("Python", State.MISSING, found, "Python 3.10 or newer is needed.")
    return MachineFinding("Python", State.OK, found)


def colcon() -> MachineFinding:
    """colcon builds the learner's packages: a module of this Python, or a command."""
    if util.find_spec("colcon_core"):
        return MachineFinding("colcon", State.OK, f"colcon-core {metadata.version('colcon-core')}")
    if command := shutil.which("colcon"):
        return MachineFinding("colcon", State.OK, command)
    step = f"`{shlex.quote(sys.executable)} -m pip install colcon-common-extensions`"
    return MachineFinding("colcon", State.MISSING, "not found", step)


def program(name: str, package: str) -> MachineFinding:
    """A program that is needed for building or working."""
    command = shutil.which(name)
    if command is None:
        return MachineFinding(name, State.MISSING, "not found", f"Install it: {install(package)}")
    return MachineFinding(name, State.OK, f"{_first_line(command, '--version')}, {command}")


def containment() -> MachineFinding:
    """Whether submissions can be contained here, and checks of your own code isolated."""
    obstacle = obstacle_to(Level.CONTAINED)
    if obstacle is None:
        return MachineFinding("containment", State.OK, f"full: {_FULL}; {_bounds()}")
    own = "Checks of your own code work without it; `grade` needs --no-sandbox."
    found = isolation.ISOLATION.restriction()
    if found is not None:
        return MachineFinding("containment", State.LESS, f"{obstacle}. {found.what}", f"{found.step} {own}")
    if obstacle_to(Level.NAMESPACES) is None:
        return MachineFinding("containment", State.LESS, f"one layer of two: {obstacle}", own)
    inside = "This is a container: start it so that bubblewrap works in it. " if _in_container() else ""
    return MachineFinding("containment", State.LESS, obstacle, f"{inside}{own}")


def _bounds() -> str:
    if available():
        return "the kernel limits memory and processes (control groups)"
    return "memory and processes are only watched (no control groups here)"


def _in_container() -> bool:
    return any(Path(mark).exists() for mark in ("/.dockerenv", "/run/.containerenv"))


def course_home(options: Options) -> MachineFinding:
    """Where the learner's work is, and whether that folder is writable."""
    try:
        return storage("course home", home_of(options).path)
    except CourseError as error:
        return MachineFinding("course home", State.LESS, error.what, f"`{typed('next')}` creates one.")


def storage(name: str, folder: Path) -> MachineFinding:
    """Whether files can be created in a folder, and whether its disk has room for builds."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            free = shutil.disk_usage(folder).free
    except OSError as error:
        step = f"Check the owner and permissions of {folder}, and its disk: `ls -ld {folder}; df {folder}`."
        return MachineFinding(name, State.MISSING, f"{folder}: {error.strerror}", step)
    found = f"{folder}, {free / GIBIBYTE:.1f} GiB free"
    if free >= ENOUGH_SPACE:
        return MachineFinding(name, State.OK, found)
    state = State.LESS if free >= LEAST_SPACE else State.MISSING
    return MachineFinding(name, state, found, f"Free some space on the disk of {folder}.")


def clock(folder: Path) -> MachineFinding:
    """Check the clock: if it is wrong, or differs from the file system's, builds miss changes."""
    now = time.time()
    today = time.strftime("%Y-%m-%d %H:%M:%S")
    if time.gmtime(now).tm_year < NOT_BEFORE:
        return MachineFinding(
            "clock", State.MISSING, today, "Set the clock: `sudo date -s 'YYYY-MM-DD hh:mm'`."
        )
    try:
        with tempfile.NamedTemporaryFile(dir=folder) as file:
            apart = abs(Path(file.name).stat().st_mtime - now)
    except OSError:
        return MachineFinding("clock", State.OK, today)
    if apart > CLOCK_TOLERANCE:
        step = f"Use a local disk for course home and cache, or set the clock of the server with {folder}."
        return MachineFinding("clock", State.LESS, f"file times are {apart:.0f} s off", step)
    return MachineFinding("clock", State.OK, today)


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


EXAMPLES = examples(("doctor", "what this machine has, and what is missing"))


def doctor(ctx: typer.Context) -> None:
    """Check this machine: ROS 2, compilers, disk, clock.

    If something is missing, it says exactly what to do. The exit code is 4 if
    the course needs what is missing.
    """
    findings = find_all(options_of(ctx))
    render_findings(open_console(), findings)
    if any(finding.state is State.MISSING for finding in findings):
        raise typer.Exit(ExitCode.MISSING_HERE)
