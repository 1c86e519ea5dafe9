"""The daemon: what it leaves behind, when it ends, and that nothing wrong with it holds up a command."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import psutil
import pytest

from course.isolation import Level
from course.isolation.levels import isolated, obstacle_to
from course.rosenv import find_ros
from tests.underlay.cli.place import environment

_LIST = ["topic", "list"]
_LISTED = "/parameter_events\n/rosout\n"


class Terminal:
    """A place with a ROS domain of its own, whose daemon can be seen from the test."""

    def __init__(self, variables: dict[str, str]) -> None:
        self.variables = variables
        self.domain = variables["ROS_DOMAIN_ID"]

    def ros2(self, *arguments: str, **more: str) -> tuple[str, str]:
        command = [str(find_ros().python), "-m", "ros2cli", *arguments]
        done = subprocess.run(
            command, env={**self.variables, **more}, capture_output=True, text=True, timeout=30, check=False
        )
        assert "Traceback" not in done.stderr
        return done.stdout, done.stderr

    def address(self) -> str:
        return f"\0ros2course-ros2cli-{os.getuid()}-{self.domain}"

    def daemons(self) -> list[psutil.Process]:
        found = []
        for process in psutil.process_iter(["cmdline", "environ"]):
            words, variables = process.info["cmdline"] or [], process.info["environ"] or {}
            if "ros2cli.daemon_server" in words and variables.get("ROS_DOMAIN_ID") == self.domain:
                found.append(process)
        return found

    def one_daemon(self) -> psutil.Process:
        """The one that is there, or that is about to be."""
        end = time.monotonic() + 20
        while time.monotonic() < end:
            found = self.daemons()
            if len(found) == 1 and self.ros2("daemon", "status")[0] == "The daemon is running\n":
                return found[0]
        raise AssertionError(f"{len(self.daemons())} daemons")


@pytest.fixture
def terminal() -> Iterator[Terminal]:
    with isolated(namespaces=False) as around:
        place = Terminal({**environment(), **around.environment})
        try:
            yield place
        finally:
            for process in place.daemons():
                process.kill()


@pytest.mark.slow
def test_a_listing_leaves_a_daemon_that_holds_nothing_of_it(terminal: Terminal, tmp_path: Path) -> None:
    with (tmp_path / "inherited").open("w") as inherited:
        command = [str(find_ros().python), "-m", "ros2cli", *_LIST]
        done = subprocess.run(
            command, env=terminal.variables, cwd=tmp_path, capture_output=True, text=True,
            timeout=30, check=True, pass_fds=[inherited.fileno()],
        )  # fmt: skip
    assert done.stdout == _LISTED
    daemon = terminal.one_daemon()
    assert daemon.cwd() == "/"
    assert daemon.terminal() is None
    assert os.getsid(daemon.pid) == daemon.pid
    streams = {Path(f"/proc/{daemon.pid}/fd/{number}").readlink() for number in range(3)}
    assert streams == {Path("/dev/null")}
    assert str(tmp_path / "inherited") not in {file.path for file in daemon.open_files()}
    daemon.send_signal(signal.SIGINT)
    daemon.send_signal(signal.SIGHUP)
    assert terminal.ros2(*_LIST)[0] == _LISTED
    assert terminal.one_daemon().pid == daemon.pid


@pytest.mark.slow
def test_none_is_started_where_it_must_not_be(terminal: Terminal) -> None:
    assert terminal.ros2(*_LIST, "--no-daemon")[0] == _LISTED
    assert terminal.ros2(*_LIST, ROS2COURSE_ARENA="1")[0] == _LISTED
    assert terminal.ros2("doctor", ROS2COURSE_ARENA="1")[0] == "\nAll 3 checks passed\n\n"
    assert "not started" in terminal.ros2("daemon", "start", ROS2COURSE_ARENA="1")[1]
    assert terminal.daemons() == []


@pytest.mark.slow
@pytest.mark.parametrize(
    "variable", ["LD_LIBRARY_PATH", "AMENT_PREFIX_PATH", "FASTRTPS_DEFAULT_PROFILES_FILE"]
)
def test_another_ros_takes_its_place(variable: str, terminal: Terminal, tmp_path: Path) -> None:
    terminal.ros2("daemon", "start")
    first = terminal.one_daemon()
    before = terminal.variables.get(variable, "")
    if variable.endswith("FILE"):
        (tmp_path / "profile.xml").write_bytes(Path(before).read_bytes())
        changed = str(tmp_path / "profile.xml")
    else:
        changed = f"{before}:{tmp_path}"
    assert terminal.ros2(*_LIST, **{variable: changed})[0] == _LISTED
    first.wait(10)
    terminal.variables[variable] = changed
    assert terminal.one_daemon().pid != first.pid


@pytest.mark.slow
def test_terminals_with_and_without_a_workspace_share_it(terminal: Terminal, tmp_path: Path) -> None:
    terminal.ros2("daemon", "start")
    first = terminal.one_daemon()
    prefixes = f"{tmp_path}/install/p:{terminal.variables['AMENT_PREFIX_PATH']}"
    more = {"COLCON_PREFIX_PATH": f"{tmp_path}/install", "AMENT_PREFIX_PATH": prefixes}
    assert terminal.ros2(*_LIST, **more)[0] == _LISTED
    assert terminal.one_daemon().pid == first.pid


@pytest.mark.slow
def test_it_does_not_outlive_its_network(terminal: Terminal) -> None:
    if obstacle_to(Level.NAMESPACES):
        pytest.skip("needs namespaces")
    inside = [
        "bwrap",
        "--unshare-net",
        "--dev-bind",
        "/",
        "/",
        str(find_ros().python),
        "-m",
        "ros2cli",
        *_LIST,
    ]
    done = subprocess.run(
        inside, env=terminal.variables, capture_output=True, text=True, timeout=30, check=True
    )
    assert done.stdout == _LISTED
    for daemon in terminal.daemons():  # it looks around every ten seconds
        daemon.wait(30)
    assert terminal.daemons() == []


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGSTOP])
def test_a_dead_or_hung_one_holds_up_nothing(number: signal.Signals, terminal: Terminal) -> None:
    usual = _seconds(terminal, "--no-daemon")
    # Two for the daemon, two for its port that does not answer. A busy machine can only add to that.
    assert any(_seconds_after(number, terminal) < usual + 2.0 + 2.0 for _ in range(5))


def _seconds_after(number: signal.Signals, terminal: Terminal) -> float:
    """How long a listing takes whose daemon has got this signal."""
    terminal.ros2("daemon", "start")
    first = terminal.one_daemon()
    first.send_signal(number)
    seconds = _seconds(terminal)
    first.wait(20)  # a hung one is ended
    assert terminal.one_daemon().pid != first.pid
    return seconds


@pytest.mark.slow
@pytest.mark.parametrize("answer", [b"", b"nonsense", b" [1", b' {"nodes": 5}', None])
def test_what_has_taken_its_name_is_no_obstacle(answer: bytes | None, terminal: Terminal) -> None:
    with socket.socket(socket.AF_UNIX) as squatter:
        squatter.bind(terminal.address())
        squatter.listen()
        taken = []

        def serve() -> None:
            while True:
                try:
                    connection, _ = squatter.accept()
                except OSError:
                    return
                taken.append(connection)
                if answer is not None:
                    connection.sendall(answer)
                    connection.close()

        import threading

        thread = threading.Thread(target=serve, daemon=True)
        thread.start()
        assert terminal.ros2(*_LIST)[0] == _LISTED
        assert terminal.ros2("daemon", "status")[0] == "The daemon is not running\n"
        squatter.shutdown(socket.SHUT_RDWR)
        thread.join(10)
        assert taken
        for connection in taken:
            connection.close()


def _seconds(terminal: Terminal, *arguments: str) -> float:
    began = time.monotonic()
    assert terminal.ros2(*_LIST, *arguments)[0] == _LISTED
    return time.monotonic() - began


def test_a_daemon_of_another_user_is_not_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    from ros2cli import daemon

    monkeypatch.setenv("ROS_DOMAIN_ID", "221")
    with socket.socket(socket.AF_UNIX) as squatter:
        squatter.bind(daemon.address())
        squatter.listen()
        user = os.getuid()
        monkeypatch.setattr(daemon, "_peer", lambda connection: (1, user + 1))
        assert daemon.ask("graph") is None
        connection, _ = squatter.accept()
        with connection:
            assert connection.recv(10) == b""


def test_who_is_alone_has_no_company(tmp_path: Path) -> None:
    from ros2cli.daemon_server import has_company

    def process(pid: str, network: str) -> None:
        (tmp_path / pid / "ns").mkdir(parents=True)
        (tmp_path / pid / "ns/net").symlink_to(network)

    process("self", "net:[1]")
    process(str(os.getpid()), "net:[1]")
    process("7", "net:[2]")
    (tmp_path / "8").mkdir()
    assert not has_company(tmp_path)
    process("9", "net:[1]")
    assert has_company(tmp_path)


def test_identity_is_of_ros_and_network(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    from ros2cli.identity import identity

    routes = tmp_path / "route"
    routes.write_text("head\nlo 0000007F 0 0\n")
    base = identity(routes)
    assert identity(routes) == base
    assert json.loads(json.dumps(base)) == base
    routes.write_text("head\nlo 0000007F 0 9\n")
    assert identity(routes) == base  # only a counter
    routes.write_text("head\nlo 0000007F 0 0\nwlan0 0000A8C0 0 0\n")
    assert identity(routes) != base
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")
    assert identity(tmp_path / "none") != base


def test_the_order_of_paths_is_no_other_identity(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    from ros2cli.identity import identity

    seen = []
    for paths in ("/a:/b", "/b:/a:/b", "/a"):
        monkeypatch.setenv("LD_LIBRARY_PATH", paths)
        seen.append(identity(tmp_path / "none"))
    assert seen[0] == seen[1] != seen[2]
