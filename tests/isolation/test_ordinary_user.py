"""Both layers without root: in a user namespace, and without control groups.

As root, these tests give up what they are, and use the system's own Python, which any user can.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
import psutil
import pytest

import course
from course.isolation.isolation_plan import ResourceLimits
from tests.conftest import NOBODY

pytestmark = pytest.mark.slow
PYTHON = "/usr/bin/python3"
ATTACKS = Path(__file__).parents[1] / "hostile" / "programs"
LEAVES_MANY = """
import os, signal
os.kill(1, signal.SIGKILL)
for _ in range(700):
    if os.fork() == 0:
        os.fork()
        os._exit(0)
    os.wait()
print('alive')
"""
SHARES_MEMORY = """
import mmap, os
print(sorted(os.listdir("/dev/shm")), os.access(__file__, os.W_OK), os.statvfs("/dev/shm").f_files)
with open("/dev/shm/segment", "w+b") as file:
    file.truncate(4096)
    kept = mmap.mmap(file.fileno(), 4096)
print("up", flush=True)
input()
"""
SIZE = """
import os
status = os.statvfs(os.environ["HOME"])
print(status.f_blocks * status.f_frsize, os.stat(os.environ["HOME"]).st_dev != os.stat("/dev/shm").st_dev)
"""
_IMPORTS = "import course.isolation.levels, course.isolation.sandbox, course.arena.process"


@dataclass(frozen=True)
class Machine:
    """Runs files in `folder` as a user without rights."""

    folder: Path

    def run(self, *command: str) -> subprocess.CompletedProcess[str]:
        rights = ["setpriv", "--reuid", str(NOBODY), "--regid", str(NOBODY), "--clear-groups", "--"]
        environment = {
            "PATH": os.defpath,
            "HOME": "/nonexistent",
            "PYTHONPATH": str(self.folder / "lib"),
            "PYTHONDONTWRITEBYTECODE": "1",
            "ROS2COURSE_CACHE": str(self.folder / "cache"),
        }
        given = [*(rights if os.geteuid() == 0 else []), *command]
        return subprocess.run(given, env=environment, capture_output=True, text=True, timeout=120)

    def confine(self, code: str, *how: str) -> dict[str, Any]:
        """What came of this program in the sandbox: `ended`, `limits` and `printed`; how: see confine.py."""
        program = self.folder / "program.py"
        program.write_text((ATTACKS / "attempts.py").read_text() + code)
        program.chmod(0o644)
        done = self.run(PYTHON, str(self.folder / "confine.py"), *how, str(program))
        found: dict[str, Any] = {}
        for line in done.stdout.splitlines():
            found.update(json.loads(line))
        if found.get("kind") != "contained":
            pytest.skip(f"not exercised: containment of an ordinary user's programs ({found.get('missing')})")
        assert found["user"] is None
        assert "ended" in found, done.stderr
        return found

    def attack(self, name: str, *how: str, **values: object) -> dict[str, Any]:
        settings = "".join(f"{key} = {value!r}\n" for key, value in values.items())
        return self.confine(settings + (ATTACKS / f"{name}.py").read_text(), *how)


@pytest.fixture
def machine(open_folder: Path) -> Machine:
    library = open_folder / "lib"
    for package in (course, msgspec, psutil):
        source = Path(package.__file__).parent
        shutil.copytree(source, library / source.name, ignore=shutil.ignore_patterns("__pycache__", "tests"))
    shutil.copy(Path(__file__).with_name("confine.py"), open_folder)
    (open_folder / "cache").mkdir()
    (open_folder / "cache").chmod(0o777)
    subprocess.run(["chmod", "-R", "a+rX", str(open_folder)], check=True)
    found = Machine(open_folder)
    if not (Path(PYTHON).exists() and shutil.which("setpriv")):
        pytest.skip("not exercised: containment without root (no Python of the system's own, or no setpriv)")
    done = found.run(PYTHON, "-c", _IMPORTS)
    if done.returncode:
        pytest.skip(f"not exercised: containment without root ({done.stderr.splitlines()[-1]})")
    return found


def breaches(found: dict[str, Any]) -> list[str]:
    return [line for line in found["printed"] if line.startswith("BREACH")]


def test_a_program_runs(machine: Machine) -> None:
    found = machine.confine("import os\nprint(os.getuid(), os.getpid() > 1, os.uname().nodename)")
    assert found["printed"] == ["1000 True robot"]
    assert (found["ended"], found["limits"]) == (True, [])


def test_there_is_no_way_out(machine: Machine) -> None:
    """It may send signals to the first process of its namespace, which can ignore them."""
    found = machine.attack("escapes", TERMINALS=ResourceLimits().terminals)
    assert breaches(found) == ["BREACH signal: '[1]'"]
    assert "HELD terminals: nothing" in found["printed"]
    assert any(line.startswith("HELD kill everybody") for line in found["printed"])


def test_the_first_process_cannot_be_ended_and_frees_what_others_leave_behind(machine: Machine) -> None:
    found = machine.confine(LEAVES_MANY)
    assert found["printed"] == ["alive"]


def test_nothing_can_be_written_and_nothing_is_to_be_seen(machine: Machine) -> None:
    folders = ["/", "/dev", "/etc", "/usr", "/run", str(machine.folder)]
    found = machine.attack("writes", PLACES=["/usr/bin/env", "/etc/passwd"], FOLDERS=folders)
    assert [line.split(":")[0] for line in breaches(found)] == ["BREACH own_install"]  # its own scratch copy
    places = ["/etc/shadow", "/root", str(machine.folder), "/proc/1/root/etc/shadow"]
    found = machine.attack("reads", PLACES=places, SECRET="program.py")
    assert not [line for line in breaches(found) if line.startswith("BREACH place")]


@pytest.mark.parametrize(
    ("attack", "values", "limit"),
    [
        ("thread_bomb", {}, "processes"),
        ("fork_bomb", {"MOST": 400}, "processes"),
        ("memory_hog", {"PROCESSES": 3}, "memory"),
        ("inode_filler", {}, "disk"),
    ],
)
def test_limits_hold_by_looking_alone(
    machine: Machine, attack: str, values: dict[str, int], limit: str
) -> None:
    """Without control groups, the watchdog looks at the processes themselves."""
    found = machine.attack(attack, **values)
    assert (found["ended"], found["limits"]) == (True, [limit])


def test_memory_of_its_own_holds_nothing_but_what_it_needs(machine: Machine) -> None:
    """That is the scratch folder, which is there. Its files in memory are visible from outside."""
    found = machine.confine(SHARES_MEMORY, "apart")
    assert found["printed"] == ["['ros2course'] True 1024", "up"]
    assert found["memory"] == ["segment"]
    assert (found["ended"], found["limits"]) == (True, [])


def test_in_a_new_sandbox_nothing_tells_of_an_earlier_run(machine: Machine) -> None:
    """A second run in the same sandbox sees all the same marks."""
    again, fresh = (machine.attack("marks", how) for how in ("again", "fresh"))
    names = [line.split(":")[0].partition(" ")[2] for line in again["printed"]]
    first, second = names[: len(names) // 2], names[len(names) // 2 :]
    assert first == second
    assert breaches({"printed": again["printed"][: len(first)]}) == []
    seen = {line.split(":")[0].partition(" ")[2] for line in breaches(again)}
    refused = {"shared_memory", "message_queue"}  # by the filter of system calls, where it knows the machine
    assert seen | refused == {*second}
    assert breaches(fresh) == []
    assert len(fresh["printed"]) == 2 * len(first)


def test_the_scratch_folder_is_a_file_system_of_its_own_size(machine: Machine) -> None:
    found = machine.confine(SIZE)
    assert found["printed"] == [f"{ResourceLimits().scratch} True"]
