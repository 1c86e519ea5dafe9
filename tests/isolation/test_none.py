"""Nothing survives. Each test runs in a separate Python, so that pytest adopts no orphans."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

REPO = Path(__file__).parents[2]
TIMEOUT = 60.0

PLAY = """
import json, os, signal, subprocess, sys
import psutil
from course.isolation.none import adopt_orphans, end_descendants, nothing_left

def start(code):
    "A quick Python; returns once it has written a line."
    child = subprocess.Popen([sys.executable, "-S", "-c", code], stdout=subprocess.PIPE, text=True)
    return child, child.stdout.readline().strip()

def alive(pid):
    return psutil.pid_exists(int(pid)) and psutil.Process(int(pid)).status() != psutil.STATUS_ZOMBIE

def await_orphan(pid):
    "Until it is a child of ours and has ended: WNOWAIT leaves it as the zombie that it is."
    os.waitid(os.P_PID, int(pid), os.WEXITED | os.WNOWAIT)

def below():
    return len(psutil.Process().children(recursive=True))

def tell(**found):
    print(json.dumps(found))
"""

DAEMON = """
import os, signal
if os.fork():
    os._exit(0)
os.setsid()
before = os.getpid()
if os.fork():
    os._exit(0)
while os.getppid() == before:  # it is the only one that is left
    pass
print(os.getpid(), flush=True)
signal.pause()
"""

ORPHAN = """
import os
child = os.fork()
if child:
    print(child, flush=True)
os._exit(0)
"""

TREE = """
import os, signal
child = os.fork()
if child:
    print(child, flush=True)
signal.pause()
"""

DEAF = """
import os, signal
for number in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):
    signal.signal(number, signal.SIG_IGN)
for _ in range(3):
    os.fork()
os.write(1, b".\\n")
signal.pause()
"""

# Chains in which each process forks the next one and ends, each in its own session.
BREEDING = """
import os, time
for _ in range(2):
    os.fork()
os.write(1, b".\\n")
end = time.monotonic() + 30
while time.monotonic() < end:
    time.sleep(0.01)
    if os.fork():
        os._exit(0)
    os.setsid()
"""

MANY = """
import os
children = [os.fork() or os._exit(0) for _ in range(400)]
for child in children:
    os.waitid(os.P_PID, child, os.WEXITED | os.WNOWAIT)
os.write(1, b".\\n")
"""

PROGRAMS = {
    "DAEMON": DAEMON,
    "ORPHAN": ORPHAN,
    "TREE": TREE,
    "DEAF": DEAF,
    "BREEDING": BREEDING,
    "MANY": MANY,
}


def play(code: str) -> dict[str, Any]:
    given = "".join(f"{name} = {text!r}\n" for name, text in PROGRAMS.items())
    done = subprocess.run(
        [sys.executable, "-c", PLAY + given + code],
        env={**os.environ, "PYTHONPATH": str(REPO)},
        capture_output=True,
        text=True,
        timeout=TIMEOUT,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return dict(json.loads(done.stdout))


def test_nobody_there_is_nothing_to_do() -> None:
    assert play("tell(ended=end_descendants())") == {"ended": 0}


def test_a_daemon_in_a_session_of_its_own_is_ended() -> None:
    found = play("""
adopt_orphans()
child, pid = start(DAEMON)
child.wait()
before = alive(pid)
tell(before=before, ended=end_descendants(), after=alive(pid), below=below())
""")
    assert found == {"before": True, "ended": 1, "after": False, "below": 0}


def test_children_of_children_are_ended_even_when_they_ignore_everything() -> None:
    found = play("""
adopt_orphans()
start(DEAF)
tell(some=end_descendants() > 0, below=below())
""")
    assert found == {"some": True, "below": 0}


def test_an_orphan_that_ended_is_reaped_and_not_counted() -> None:
    found = play("""
adopt_orphans()
child, pid = start(ORPHAN)
child.wait()
await_orphan(pid)
zombies = below()
tell(zombies=zombies, ended=end_descendants(), below=below())
""")
    assert found == {"zombies": 1, "ended": 0, "below": 0}


def test_processes_that_breed_are_caught() -> None:
    found = play("""
adopt_orphans()
start(BREEDING)
tell(some=end_descendants() > 0, below=below())
""")
    assert found == {"some": True, "below": 0}


@pytest.mark.slow
def test_many_that_ended_take_no_time() -> None:
    """As many zombies as a forking program leaves behind in a few seconds."""
    found = play("""
import time
adopt_orphans()
start(MANY)[0].wait()
began = time.monotonic()
tell(ended=end_descendants(), below=below(), quick=time.monotonic() - began < 10)
""")
    assert found == {"ended": 0, "below": 0, "quick": True}


def test_what_was_there_before_is_spared_with_all_below_it() -> None:
    found = play("""
old, older = start(TREE)
with nothing_left():
    new, newer = start(TREE)
tell(old=[alive(old.pid), alive(older)], new=[alive(new.pid), alive(newer)])
old.kill()
os.kill(int(older), signal.SIGKILL)
""")
    assert found == {"old": [True, True], "new": [False, False]}


def test_orphans_are_adopted_only_for_the_time() -> None:
    found = play("""
with nothing_left():
    pass
child, pid = start(DAEMON)
child.wait()
tell(ours=psutil.Process(int(pid)).ppid() == os.getpid())
os.kill(int(pid), signal.SIGKILL)
""")
    assert found == {"ours": False}


def test_everything_ends_with_the_context_also_after_an_error() -> None:
    found = play("""
try:
    with nothing_left():
        child, pid = start(DAEMON)
        raise ValueError
except ValueError:
    tell(alive=alive(pid), below=below())
""")
    assert found == {"alive": False, "below": 0}
