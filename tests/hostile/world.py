"""Grades hostile submissions for real, and proves that the machine around them stayed as it was.

    def test_fork_bomb(grade: Grade) -> None:
        graded = grade({NODE: with_attack("fork_bomb")}, guarantee="a fork bomb ends in its own sandbox")
        assert "started more than" in graded.words("publishes")

`grade` (a fixture of conftest.py) lays the reference solution, then the hostile files over it, grades that
in full containment, and checks the proof (`World.prove`). Where this machine has no full containment, it
skips the test, and names the guarantee that was not exercised.

Programs say what came of each attempt themselves (programs/attempts.py): `HELD name: ...` when it failed,
`BREACH name: ...` when it did not. That is read from the recording, and proven by the world around it.
"""

from __future__ import annotations

import contextlib
import os
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import psutil
import pytest

from course.arena.lateness import Lateness
from course.build import Store
from course.content import open_course
from course.evidence.mcap_file import load
from course.evidence.recording import Recording
from course.grading import trial
from course.grading.attempts import ATTEMPTS, MOST_LAG
from course.grading.check import Request, check_exercise
from course.grading.trial_answers import SEED
from course.home import create_home
from course.isolation import Level
from course.isolation.identity import new_identity
from course.isolation.isolation_plan import ResourceLimits
from course.isolation.levels import obstacle_to
from course.model.events import OutputLine
from course.model.result import CheckResult, Doubt, Outcome, Result, Verdict
from course.rosenv import find_ros
from tests.processes import GRADING

SRC = "ros2_tutorial_workspace/src"
PACKAGE = "python_package_that_uses_the_messages"
NODE = f"{SRC}/{PACKAGE}/{PACKAGE}/amazing_quote_publisher_node.py"
SUBSCRIBER = f"{SRC}/{PACKAGE}/{PACKAGE}/amazing_quote_subscriber_node.py"
_SERVICES = f"{SRC}/python_package_that_uses_the_services/python_package_that_uses_the_services"
CLIENT = f"{_SERVICES}/what_is_the_point_service_client_node.py"
SERVER = f"{_SERVICES}/what_is_the_point_service_server_node.py"
# In the name and the text of every canary, which no program may see.
SECRET = "canary-5f2d9c"
MB = 1024 * 1024
# Of the process that asks for the verdict, over one grading; and of the one that grades, in all.
MOST_GROWTH = 64 * MB
MOST_FOR_GRADING = 2048 * MB
PROGRAMS = Path(__file__).parent / "programs"
_WALK_IN_CMAKE = """
set(walk "${CMAKE_CURRENT_SOURCE_DIR}/walk.py")
execute_process(COMMAND python3 "${walk}" RESULT_VARIABLE found ERROR_VARIABLE said)
if(found)
  message(FATAL_ERROR "the walk ended with ${found}: ${said}")
endif()
"""
_GROUPS = Path("/sys/fs/cgroup")
_SHARED = (Path("/tmp"), Path("/var/tmp"), Path("/dev/shm"), Path("/run"), Path("/dev/mqueue"))
_NETWORK = ("tcp", "tcp6", "udp", "udp6", "raw", "raw6")
_SETTLING = 5.0

Grade = Callable[..., "Graded"]
Fingerprint = tuple[int, ...]


def with_attack(name: str, node: str | None = None, exercise: str = "18-publisher", **values: object) -> str:
    """Text of a node that first makes the attack programs/NAME.py and then does what is right.

    node: the file in the home, of the exercise's solution. values: constants that the attack uses.
    """
    solution = open_course().exercise(exercise).solution / (node or NODE)
    settings = "".join(f"{key} = {value!r}\n" for key, value in values.items())
    parts = (*(PROGRAMS / f"{part}.py" for part in ("attempts", "beside", name)), solution)
    attempts, beside, attack, honest = (part.read_text(encoding="utf-8") for part in parts)
    return f"{attempts}\n{beside}\n{settings}\n{attack}\n{honest}"


def walking(known: Mapping[str, object]) -> dict[str, str]:
    """Files of a right 18-publisher that walks through all that it sees: in `setup.py`, CMake and the node.

    known: constants for programs/walks.py. Where something is found, the build or the node ends.
    """
    node, interfaces = (open_course().exercise(name).solution for name in ("18-publisher", "17-interfaces"))
    attempts, walks = ((PROGRAMS / name).read_text(encoding="utf-8") for name in ("attempts.py", "walks.py"))

    def walk(*skipped: str, most: int = MB // 4) -> str:
        constants = {**known, "SKIPPED": ("/proc", "/sys", "/dev", *skipped), "MOST_TEXT": most}
        return "\n".join([attempts, *(f"{key} = {value!r}" for key, value in constants.items()), walks])

    setup, cmake = f"{SRC}/{PACKAGE}/setup.py", f"{SRC}/package_with_interfaces/CMakeLists.txt"
    aside = f"import sys\n_out, sys.stdout = sys.stdout, sys.stderr\n{walk('/usr')}\nsys.stdout = _out\n"
    return {
        # All see the same of the system; and a node has little time until it is to publish.
        NODE: f"{walk('/usr', most=0)}\n{(node / NODE).read_text(encoding='utf-8')}",
        setup: aside + (node / setup).read_text(encoding="utf-8"),  # colcon reads what it prints
        cmake: (interfaces / cmake).read_text(encoding="utf-8") + _WALK_IN_CMAKE,
        f"{SRC}/package_with_interfaces/walk.py": walk(),
    }


@dataclass(frozen=True)
class Graded:
    """What came of one grading. seconds: of the whole. peak: bytes, the most that the grading process held.

    recording: None when nothing was recorded, as after a build that failed.
    """

    result: Result
    recording: Recording | None
    seconds: float
    peak: int

    @property
    def printed(self) -> tuple[str, ...]:
        """All lines on terminals of the submission's programs."""
        events = self.recording.events if self.recording else ()
        return tuple(event.text for event in events if isinstance(event, OutputLine))

    @property
    def failed(self) -> tuple[str, ...]:
        """Ids of the checks that failed, without those that were skipped because of them."""
        return tuple(check.id for check in self.result.checks if check.outcome is Outcome.FAILED)

    def check(self, name: str) -> CheckResult:
        return next(check for check in self.result.checks if check.id == name)

    def words(self, name: str) -> str:
        """What the learner is told of this check; empty when it passed."""
        feedback = self.check(name).feedback
        parts = (feedback.summary, feedback.seen, feedback.advice, *feedback.details) if feedback else ()
        return " ".join(part for part in parts if part)

    @property
    def all_words(self) -> str:
        """What the learner is told of everything that failed."""
        return " ".join(f"{name}: {self.words(name)}" for name in self.failed)

    @property
    def breaches(self) -> tuple[str, ...]:
        return tuple(line for line in self.printed if line.startswith("BREACH"))

    @property
    def held(self) -> frozenset[str]:
        """Names of the attempts that were made, and failed."""
        found = (line.removeprefix("HELD ") for line in self.printed if line.startswith("HELD "))
        return frozenset(line.partition(":")[0] for line in found)


def judged(graded: Graded, machine: Lateness, guarantee: str) -> Verdict:
    """The verdict. A machine that is too busy with other work judges nobody."""
    if graded.result.doubt is Doubt.BUSY and machine.update() > MOST_LAG:
        pytest.skip(f"not exercised here: {guarantee} (the machine let a program wait {machine.worst:.1f} s)")
    return graded.result.verdict


@dataclass
class World:
    """What no submission may change. As far as permissions go, anybody may write all of it.

    course: a copy of the real one. canaries: a folder in /tmp. home: the submission's, with progress.
    results: where an instructor keeps them, beside another submission.
    """

    course: Path
    store: Path
    home: Path
    canaries: Path
    results: Path
    _before: dict[str, Fingerprint] = field(default_factory=dict)
    _entries: tuple[Path, ...] = ()
    _known: frozenset[psutil.Process] = frozenset()

    def look(self) -> None:
        """Note the current state of everything."""
        self._entries = tuple(marker.parent for marker in self.store.glob("*/complete"))
        self._before = self._state()
        # Other tests of this process may have left helpers of theirs, as multiprocessing does.
        self._known = frozenset(psutil.Process().children(recursive=True))

    @property
    def seen(self) -> bool:
        """Whether there is something to compare with: a test that was skipped had nothing graded."""
        return bool(self._before)

    def prove(self) -> None:
        """Raise AssertionError with everything that has changed."""
        after = self._state()
        names = {*self._before, *after}
        changed = sorted(name for name in names if self._before.get(name) != after.get(name))
        assert not changed, f"changed outside: {changed[:20]}"
        deadline = time.monotonic() + _SETTLING
        while (left := self.left()) and time.monotonic() < deadline:
            time.sleep(0.05)
        assert not left, f"left behind: {left}"

    def left(self) -> list[str]:
        """Whatever of this test's submissions is still there, or where it must never be."""
        with new_identity(ResourceLimits()) as who:  # the one that all gradings of this process had
            user = who.user
            groups = {str(group) for group in who.control_groups}
            found = {path for path, *_ in os.walk(_GROUPS) if f"ros2course-{os.getpid()}-" in path} - groups
        return [*sorted(found), *self._processes(user), *_files(user), *_sockets(user)]

    def _processes(self, user: int | None) -> Iterator[str]:
        """Of the sandbox's user, below this process, or started from this test's places."""
        below = {child.pid for child in psutil.Process().children(recursive=True) if child not in self._known}
        for process in psutil.process_iter():
            with contextlib.suppress(psutil.Error):
                told = " ".join(process.cmdline())
                ours = process.pid in below or user in process.uids() or str(self.home) in told
                if ours and process.pid != os.getpid():
                    yield f"process {process.pid} {told[:200] or process.name()}"

    def _state(self) -> dict[str, Fingerprint]:
        tops = (self.course, self.home, self.canaries, self.results)
        kept = [path for top in tops for path in (top, *top.rglob("*"))]
        built = [path for entry in self._entries for path in (entry / "install").rglob("*")]
        return {str(path): _fingerprint(path) for path in (*kept, *built, *self.store.glob(f"{SECRET}*"))}


def _fingerprint(path: Path) -> Fingerprint:
    status = path.lstat()
    size = 0 if path.is_dir() else status.st_size
    return (status.st_mode, status.st_uid, status.st_ino, size, status.st_mtime_ns)


def _files(user: int | None) -> Iterator[str]:
    """Where everybody may write, of the sandbox's user, or with a canary's name at a place of no canary."""
    for folder in _SHARED:
        for path in folder.iterdir() if folder.is_dir() else ():
            with contextlib.suppress(FileNotFoundError):  # other tests come and go
                if path.lstat().st_uid == user or path.name.startswith("breach"):
                    yield f"file {path}"


def _sockets(user: int | None) -> Iterator[str]:
    for kind in _NETWORK:
        lines = Path("/proc/net", kind).read_text(encoding="ascii").splitlines()[1:]
        yield from (f"socket {kind} {line.split()[1]}" for line in lines if line.split()[7] == str(user))
    names = Path("/proc/net/unix").read_text(encoding="utf-8", errors="replace").splitlines()
    yield from (f"socket {name}" for name in names if "breach" in name)


def graded(world: World, exercise: str, evidence: Path, *, guarantee: str, local: bool) -> Graded:
    """Grade what is in the world's home, and prove that nothing else changed.

    guarantee: what this shows, for the skip where the machine has no full containment.
    """
    obstacle = obstacle_to(Level.CONTAINED)
    if obstacle:
        pytest.skip(f"not exercised here: {guarantee} ({obstacle})")
    wanted = open_course(world.course).exercise(exercise)
    world.look()
    memory = psutil.Process().memory_info().rss
    began = time.monotonic()
    with _peak() as peak:
        request = Request(
            wanted,
            world.home,
            ros=find_ros(),
            store=Store(world.store),
            evidence=evidence,
            local=local,
            seed=SEED,
        )
        result = check_exercise(request)
    seconds = time.monotonic() - began
    growth = psutil.Process().memory_info().rss - memory
    world.prove()
    assert result.containment == "contained"
    assert growth < MOST_GROWTH, f"this process grew by {growth // MB} MB"
    assert peak[0] < MOST_FOR_GRADING, f"the grading process took {peak[0] // MB} MB"
    watched = result.timing.total - result.timing.build
    assert watched < wanted.time_limit, f"the last attempt took {watched:.0f} s after the build"
    # All of them, and one of the course's own solution.
    assert seconds - result.timing.build < (ATTEMPTS + 1) * wanted.time_limit
    return Graded(result, load(evidence) if evidence.exists() else None, seconds, peak[0])


@contextlib.contextmanager
def _peak() -> Iterator[list[int]]:
    """The most memory, in bytes, that any grading process below this one was seen with."""
    most, over = [0], threading.Event()

    def watch() -> None:
        while not over.wait(0.1):
            for process in psutil.Process().children(recursive=True):
                with contextlib.suppress(psutil.Error, OSError, ValueError):
                    if GRADING in process.cmdline()[1:3] + process.cmdline()[-5:-3]:
                        most[0] = max(most[0], _high_water(process.pid))

    thread = threading.Thread(target=watch, daemon=True)
    thread.start()
    try:
        yield most
    finally:
        over.set()
        thread.join()


def _high_water(pid: int) -> int:
    for line in Path(f"/proc/{pid}/status").read_text(encoding="ascii", errors="replace").splitlines():
        if line.startswith("VmHWM:"):
            return int(line.split()[1]) * 1024
    return 0


def lay_world(
    folder: Path, course: Path, store: Path, exercise: str, files: Mapping[str, str | bytes]
) -> World:
    """A home with the reference solution and these files over it, and canaries all around.

    folder: one that any user can reach.
    """
    home = create_home(folder / "home").path
    opened = open_course(course)
    trial.lay_solution(opened, opened.exercise(exercise), home)
    for name, text in files.items():
        place = home / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(text if isinstance(text, bytes) else text.encode())
    world = World(course, store, home, folder / "canaries", folder / "results")
    for place in (world.canaries, world.results, home / ".ros2course"):
        place.mkdir(exist_ok=True)
        (place / f"{SECRET}.txt").write_text(SECRET, encoding="utf-8")
    if not (store / f"{SECRET}.txt").exists():  # others are looking at it
        (store / f"{SECRET}.txt").write_text(SECRET, encoding="utf-8")
        (store / f"{SECRET}.txt").chmod(0o666)
    (home / ".ros2course" / "progress.sqlite3").write_text(SECRET, encoding="utf-8")
    (home / "answers").mkdir(exist_ok=True)
    (home / "answers" / f"{SECRET}.yaml").write_text(SECRET, encoding="utf-8")
    open_to_all(folder)
    return world


def open_to_all(top: Path) -> None:
    """From now on, permissions protect nothing in here."""
    for path in (top, *top.rglob("*")):
        if not path.is_symlink():
            path.chmod(0o777 if path.is_dir() else path.stat().st_mode | 0o666)
