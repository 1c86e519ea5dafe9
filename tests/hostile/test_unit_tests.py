"""Unit tests of a submission: they run beside reference classes, some of which are wrong on purpose."""

from __future__ import annotations

import builtins
import re
from pathlib import Path

import pytest

from course.model import codec
from course.model.events import OutputLine, ProcessExited
from course.model.result import Verdict
from tests.hostile.world import PROGRAMS, Grade

pytestmark = pytest.mark.slow
EXERCISE = "02-unit-tests"
PROJECT = "ros2_tutorials_preamble/python/minimalist_package"
TEST = f"{PROJECT}/test/test_minimalist_class.py"
# Passes if it sees no mark of an earlier run; asserts nothing.
CHEATS = """
import os, unittest
seen = []

def attempt(name, act):
    try:
        if act() is not None:
            seen.append(name)
    except OSError:  # a call that the sandbox refuses
        pass

{marks}

class Test(unittest.TestCase):
    def test_nothing(self):
        if seen:
            os._exit(100 + len(seen))
"""
# Says of its surroundings what fits through: three numbers that the lines of this file make known.
SEES = """
import os, sys, time, unittest, zlib

def seen_of_files():
    for top, folders, files in os.walk(os.environ["TMPDIR"]):
        for name in (".", *folders, *files):
            path = os.path.join(top, name)
            yield path, os.lstat(path)

def read(path):
    with open(path) as file:
        return file.read()

def digest(*seen):
    return zlib.crc32(repr(seen).encode()) % MOST + 1

stats = list(seen_of_files())
files = digest([
    (path, s.st_mode, s.st_uid, s.st_gid, s.st_nlink, s.st_size, s.st_blocks, s.st_ino) for path, s in stats
])
# How long ago in minutes, and whether somebody has set the time by hand.
times = digest([((time.time() - s.st_mtime) // 60, s.st_mtime_ns % 10**9 == 0) for path, s in stats])
process = digest(
    sys.orig_argv, sys.path, os.getcwd(), list(os.environ.items()), os.uname(), os.getpriority(0, 0),
    [os.listdir(folder) for folder in ("/", "/tmp", "/dev", "/dev/shm", "/proc/self/fd")],
    # Not of the sandbox's first process: on a busy machine, it may still be starting.
    os.getpid(), [read(f"/proc/self/{name}") for name in ("cmdline", "comm", "cgroup", "limits")],
)
print(f"FAIL: {files} (x)")
print(f'  File "{os.path.abspath(__file__)}", line {times}')
print(f"KeyError: '{process}'", flush=True)

class Test(unittest.TestCase):
    def test_nothing(self):
        pass
"""
MOST = 4000
TELLS = """
import base64, inspect, os, sys, unittest, warnings
import minimalist_package._minimalist_class as module

text = inspect.getsource(module)
ways = [text, text[::-1], base64.b64encode(text.encode()).decode(), "\\n".join(text), text.encode().hex()]
for way in ways:
    print(way)
    print(f"Ran {len(text)} tests in {way!r}")
    print(f"FAIL: {way} ({way})\\nNameError: name {way!r} is not defined")
    warnings.warn(way)
for word in text.split():
    print(f"FAIL: {word} (x)\\nNameError: '{word}'")
    print(f'  File "/x/test_minimalist_class.py", line {len(word)}000')
    open("".join(c if c.isalnum() else "_" for c in word) or "_", "w")

class Test(unittest.TestCase):
    def test_that_fails(self):
        exec(compile("raise KeyError(text)", text.replace("\\n", " "), "exec"), {"text": text})

for index, way in enumerate(ways):
    def fail(self, way=way):
        raise AssertionError(way)
    setattr(Test, f"test_{way.encode().hex()[:2000]}", fail)
    setattr(Test, f"test_{index}", fail)
sys.argv = [text]
"""
# Replaces the grader's files with links, and continues after the test is over.
LINKS = """
import os, unittest

own = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
package = os.path.join(own, "minimalist_package")

def replace(path, outside):
    try:
        os.rename(path, f"{path}.{os.getpid()}")
    except OSError:
        pass
    try:
        os.symlink(outside, path)
    except OSError:
        pass

def put_links():
    if {parents}:
        replace(package, {folder!r})
    for name in ("__init__.py", "_minimalist_class.py"):
        replace(os.path.join(package, name), os.path.join({folder!r}, name))

class Test(unittest.TestCase):
    def test_nothing(self):
        put_links()
        if os.fork() == 0:
            os.setsid()
            for number in (0, 1, 2):
                os.close(number)
            while True:
                put_links()
"""
# In the class, and in nothing that a learner is shown.
SECRET = "self._private_attribute"
SECRETS = (SECRET, SECRET[::-1], SECRET.encode().hex(), "\n".join(SECRET))


def test_a_run_knows_of_no_other(grade: Grade) -> None:
    """With one home for all runs, a test without assertions could pass at first and then fail on cue."""
    text = CHEATS.replace("{marks}", (PROGRAMS / "marks.py").read_text(encoding="utf-8"))
    graded = grade({TEST: text}, EXERCISE, guarantee="a run of unit tests knows of no other run")
    assert graded.recording is not None
    ends = [event for event in graded.recording.events if isinstance(event, ProcessExited)]
    assert len(ends) == 12
    assert {event.process: event.code for event in ends if event.code != 0} == {}
    assert graded.failed == ("notices",)
    assert "pass on 8 of 8" in graded.words("notices")


def test_the_surroundings_say_nothing(grade: Grade) -> None:
    """Names, sizes and times of files, and the process: alike for right classes and for wrong ones."""
    text = f"MOST = {MOST}\n{SEES}" + "\n" * MOST
    graded = grade({TEST: text}, EXERCISE, guarantee="a run of unit tests knows a class by what it does")
    assert graded.recording is not None
    seen: dict[str, list[str]] = {"failed": [], "line": [], "word": []}
    for event in graded.recording.events:
        for told in event.text.split() if isinstance(event, OutputLine) else ():
            fact, _, number = told.partition("=")
            seen.setdefault(fact, []).append(number)
    for aspect, fact in (("files", "failed"), ("times", "line"), ("process", "word")):
        assert len(seen[fact]) == 12
        assert len(set(seen[fact])) == 1, (aspect, seen[fact])


def test_the_order_says_nothing(grade: Grade) -> None:
    """A test that fails from the second run on would have been right with the old order."""
    orders = set()
    for _ in range(2):
        graded = grade({}, EXERCISE, guarantee="runs of unit tests come in random order")
        assert graded.result.verdict is Verdict.PASSED
        assert graded.recording is not None
        names = [e.process for e in graded.recording.events if isinstance(e, ProcessExited)]
        orders.add(tuple(names))
        assert sum(name.startswith("right") for name in names) == 4
    assert len(orders) == 2


def test_what_tests_print_is_not_shown(grade: Grade) -> None:
    graded = grade({TEST: TELLS}, EXERCISE, guarantee="nobody is shown the class that their tests run on")
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert graded.failed == ("right",)
    assert graded.recording is not None
    printed = [event.text for event in graded.recording.events if isinstance(event, OutputLine)]
    own = {*re.findall(r"[\w.]+", TELLS), *map(str, range(len(TELLS.splitlines()) + 1))}
    known = {"Ran", "test_minimalist_class", *own, *dir(builtins)}
    assert all(word.partition("=")[2] in known for line in printed for word in line.split()), printed
    assert len(printed) <= 5 * 12
    shown = codec.to_json(graded.result).decode()
    kept = repr(graded.recording.events)
    for secret in SECRETS:
        assert secret not in shown
        assert secret not in kept


@pytest.mark.parametrize("parents", [False, True], ids=["files", "folders"])
def test_no_link_of_theirs_is_written_through(grade: Grade, tmp_path: Path, parents: bool) -> None:
    """The recording is kept in that folder, and was once written through such a link."""
    evidence = tmp_path / "evidence-1"
    text = LINKS.replace("{parents}", str(parents)).replace("{folder!r}", repr(str(evidence)))
    graded = grade({TEST: text}, EXERCISE, guarantee="the grader writes through no link of a submission")
    assert [path.name for path in evidence.iterdir()] == ["evidence.mcap"]
    assert graded.failed == ("notices",)
