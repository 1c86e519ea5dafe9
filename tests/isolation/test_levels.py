"""Where grading runs: in namespaces if possible, otherwise in its own ROS domain."""

from __future__ import annotations

import contextlib
import os
import select
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.errors import MissingHere
from course.isolation import Level, bubblewrap, domains
from course.isolation import levels as remembered
from course.isolation.levels import forget, isolated, obstacle_to, unless_known

REPO = Path(__file__).parents[2]
WAIT = 20.0
HOLD = """
import sys
from course.isolation import domains
from course.isolation.levels import isolated
domains._DOMAINS = ({free},)
with isolated(namespaces=False) as where:
    print(where.environment["ROS_DOMAIN_ID"], flush=True)
    sys.stdin.read()
"""

needs_namespaces = pytest.mark.skipif(
    obstacle_to(Level.NAMESPACES) is not None, reason=str(obstacle_to(Level.NAMESPACES))
)


# namespaces


def inside(code: str) -> list[str]:
    """What a Python in the namespaces prints, line by line."""
    with isolated() as where:
        assert (where.level, where.missing, dict(where.environment)) == ("namespaces", None, {})
        command = [*where.prefix, sys.executable, "-S", "-c", f"import os\nfrom pathlib import Path\n{code}"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


@needs_namespaces
def test_the_network_is_only_loopback() -> None:
    assert inside("import socket\nprint(*(name for _, name in socket.if_nameindex()))") == ["lo"]


@needs_namespaces
def test_the_loopback_carries_packets_within_and_not_out() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as outside:
        outside.bind(("127.0.0.1", 0))
        outside.settimeout(0.2)
        code = (
            "import socket\na, b = (socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in '12')\n"
            "a.bind(('127.0.0.1', 0))\nb.sendto(b'hello', a.getsockname())\nprint(a.recv(10))\n"
            f"b.sendto(b'hello', ('127.0.0.1', {outside.getsockname()[1]}))"
        )
        assert inside(code) == ["b'hello'"]
        with pytest.raises(TimeoutError):
            outside.recv(10)


@needs_namespaces
def test_shared_memory_is_private(tmp_path: Path) -> None:
    outside = Path("/dev/shm", f"ros2course-test-{os.getpid()}")
    outside.write_text("seen from outside")
    try:
        code = f"print(os.listdir('/dev/shm'))\nPath('/dev/shm/{outside.name}-inside').write_text('x')"
        assert inside(code) == ["[]"]
        assert not outside.with_name(f"{outside.name}-inside").exists()
    finally:
        outside.unlink()


@needs_namespaces
def test_processes_outside_cannot_be_seen() -> None:
    pids = inside("print(*(pid for pid in os.listdir('/proc') if pid.isdigit()))")[0].split()
    assert 1 <= len(pids) <= 3
    assert str(os.getpid()) not in pids or os.getpid() <= 3


DAEMON = """
import os, signal
if os.fork():
    os._exit(0)
os.setsid()
if os.fork():
    os._exit(0)
print("ready", flush=True)
signal.pause()
"""


def closed(reader: int) -> bool:
    """Wait until nobody has the other end of a pipe anymore."""
    return bool(select.select([reader], [], [], WAIT)[0]) and os.read(reader, 1) == b""


@needs_namespaces
def test_a_daemon_inside_ends_with_the_first_process() -> None:
    reader, writer = os.pipe()
    with isolated() as where:
        command = [*where.prefix, sys.executable, "-S", "-c", DAEMON]
        subprocess.run(command, pass_fds=(writer,), stdout=subprocess.DEVNULL, timeout=60, check=True)
    os.close(writer)
    assert closed(reader)
    os.close(reader)


@needs_namespaces
def test_all_inside_ends_when_the_parent_is_killed() -> None:
    reader, writer = os.pipe()
    forever = "import signal; print('ready', flush=True); signal.pause()"
    with isolated() as where:
        command = [*where.prefix, sys.executable, "-S", "-c", forever]
        parent = subprocess.Popen(
            [sys.executable, "-S", "-c", f"import subprocess\nsubprocess.run({command!r}, close_fds=False)"],
            pass_fds=(writer,),
            stdout=subprocess.PIPE,
        )
        os.close(writer)
        with parent:
            assert parent.stdout is not None
            assert parent.stdout.readline() == b"ready\n"
            parent.kill()
            assert closed(reader)
    os.close(reader)


# why there are none


def fake_bwrap(folder: Path, body: str, monkeypatch: pytest.MonkeyPatch) -> None:
    file = folder / "bwrap"
    file.write_text(f"#!/bin/sh\n{body}\n")
    file.chmod(0o755)
    monkeypatch.setenv("PATH", str(folder))


def test_without_bubblewrap_it_says_how_to_get_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert obstacle_to(Level.NAMESPACES) == "bubblewrap is not installed: `sudo apt install bubblewrap`"
    with isolated() as where:
        assert (where.level, where.prefix, where.missing) == ("domain", (), obstacle_to(Level.NAMESPACES))
        assert where.environment["ROS_AUTOMATIC_DISCOVERY_RANGE"] == "LOCALHOST"


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("exit 0", None),
        (
            "echo first >&2; echo 'bwrap: No permissions to create new namespace' >&2; exit 1",
            "this system does not allow namespaces (bwrap: No permissions to create new namespace)",
        ),
        ("exit 3", "this system does not allow namespaces (3)"),
        (r"printf '\377 broken' >&2; exit 1", "this system does not allow namespaces (\ufffd broken)"),
    ],
)
def test_the_obstacle_is_told_in_one_line(
    body: str, words: str | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fake_bwrap(tmp_path, body, monkeypatch)
    assert obstacle_to(Level.NAMESPACES) == words


@pytest.mark.parametrize(
    ("load", "words"),
    [
        (0.5, "bubblewrap does not start here: it hung for 0 s"),
        (4000.4, "it is too busy to test bubblewrap (load 4000), so try again when less is running"),
    ],
)
@pytest.mark.parametrize("level", [Level.NAMESPACES, Level.CONTAINED])
def test_a_bubblewrap_that_hangs_is_told_from_a_busy_machine(
    level: Level, load: float, words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fake_bwrap(tmp_path, "exec /bin/sleep 100", monkeypatch)
    monkeypatch.setattr(bubblewrap, "_PROBE_TIMEOUT", 0.2)
    monkeypatch.setattr(os, "getloadavg", lambda: (load, 0.0, 0.0))
    assert obstacle_to(level) == words


def test_a_bubblewrap_that_cannot_be_run_is_an_obstacle(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fake_bwrap(tmp_path, "", monkeypatch)
    (tmp_path / "bwrap").write_text("#!/no/such/shell\n")
    assert str(obstacle_to(Level.NAMESPACES)).startswith("bubblewrap does not start here: [Errno 2]")


# domains


def held() -> list[int]:
    """The domain of a check that begins now, or none."""
    try:
        with isolated(namespaces=False) as where:
            return [int(where.environment["ROS_DOMAIN_ID"])]
    except MissingHere:
        return []


@pytest.fixture
def free(monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """A domain that nobody holds, and the only one. Others on this machine start with low ones.

    The same test, or one of its neighbors, in another process at this moment has another one.
    """
    for domain in range(101, 50, -1):
        monkeypatch.setattr(domains, "_DOMAINS", (domain,))
        with socket.socket(socket.AF_UNIX) as claim, contextlib.suppress(OSError):
            claim.bind(f"\0ros2course-test-of-domain-{domain}")
            if held() == [domain]:
                yield domain
                return
    pytest.fail("no domain is free")


def test_two_checks_at_once_have_different_domains() -> None:
    with isolated(namespaces=False) as one, isolated(namespaces=False) as other:
        assert one.environment["ROS_DOMAIN_ID"] != other.environment["ROS_DOMAIN_ID"]
        assert one.missing is None  # it was asked for: nothing is missing


def test_a_domain_is_free_again_after_the_check(free: int) -> None:
    with isolated(namespaces=False):
        assert held() == []
    assert held() == [free]


def test_it_says_what_to_do_when_all_domains_are_in_use(free: int) -> None:
    with isolated(namespaces=False), pytest.raises(MissingHere) as caught, isolated(namespaces=False):
        pass
    assert "in use" in caught.value.what
    assert "bubblewrap" in str(caught.value.next_step)


def test_a_domain_is_free_again_when_its_holder_was_killed(free: int) -> None:
    code = HOLD.format(free=free)
    environment = {**os.environ, "PYTHONPATH": str(REPO)}
    pipe = subprocess.PIPE
    with subprocess.Popen([sys.executable, "-c", code], env=environment, stdin=pipe, stdout=pipe) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"%d\n" % free
        assert held() == []
        holder.kill()
        holder.wait(WAIT)
        assert held() == [free]


@pytest.mark.parametrize("offset", [0, 10, 12, 40], ids=["multicast", "first", "second", "sixteenth"])
def test_a_domain_with_a_ros_program_in_it_is_left_out(free: int, offset: int) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as program:
        program.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        program.bind(("", 7400 + 250 * free + offset))
        assert held() == []
    assert held() == [free]


def test_the_next_domain_is_taken_instead(free: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(domains, "_DOMAINS", (free, *range(50, 30, -1)))
    with isolated(namespaces=False):
        (other,) = held()
    assert other in range(31, 51)


@pytest.fixture
def program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ROS2COURSE_CACHE", str(tmp_path / "cache"))
    file = tmp_path / "program"
    file.write_text("one")
    return file


class Trial:
    """Counts how often it is asked."""

    def __init__(self, *answers: str | None) -> None:
        self.answers = list(answers)
        self.asked = 0

    def __call__(self) -> str | None:
        self.asked += 1
        return self.answers.pop(0)


def test_success_is_kept(program: Path) -> None:
    trial = Trial(None)
    assert [unless_known("it", str(program), trial) for _ in range(3)] == [None] * 3
    assert trial.asked == 1


def test_failure_is_tried_again(program: Path) -> None:
    trial = Trial("it failed", None)
    assert unless_known("it", str(program), trial) == "it failed"
    assert unless_known("it", str(program), trial) is None


def test_another_name_is_another_matter(program: Path) -> None:
    assert unless_known("one", str(program), Trial(None)) is None
    assert unless_known("other", str(program), Trial("no")) == "no"


def test_a_changed_program_is_tried_again(program: Path) -> None:
    unless_known("it", str(program), Trial(None))
    program.write_text("another")
    assert unless_known("it", str(program), Trial("no")) == "no"


def test_a_machine_that_was_started_anew_is_tried_again(
    program: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    unless_known("it", str(program), Trial(None))
    boot = tmp_path / "boot_id"
    boot.write_text("another")
    monkeypatch.setattr(remembered, "_BOOT", boot)
    assert unless_known("it", str(program), Trial("no")) == "no"


def test_another_user_is_tried_again(program: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    unless_known("it", str(program), Trial(None))
    monkeypatch.setattr(os, "geteuid", lambda: 4242)
    assert unless_known("it", str(program), Trial("no")) == "no"


def test_what_did_not_work_after_all_is_forgotten(program: Path) -> None:
    unless_known("it", str(program), Trial(None))
    forget("it")
    forget("it")  # twice is fine
    assert unless_known("it", str(program), Trial("no")) == "no"


def test_without_a_cache_or_a_program_it_is_always_tried(
    program: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for known in (str(tmp_path / "nowhere"), str(program)):
        monkeypatch.setenv("ROS2COURSE_CACHE", "/dev/null/cache")
        trial = Trial(None, None)
        assert [unless_known("it", known, trial) for _ in range(2)] == [None, None]
        assert trial.asked == 2
