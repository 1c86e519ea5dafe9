"""When a listing may be believed to be complete, and what counts as living."""

from __future__ import annotations

import os
import signal
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tests.underlay.cli.place import among, typed

MACHINE = (1, 15, 127, 1)


def endpoint(pid: int, name: str, node: str, *, writes: bool = True, number: int = 0) -> Any:
    from ros2cli.snapshot import Endpoint

    gid = (*MACHINE, pid % 256, pid // 256 % 256, 0, 0, 0, 0, 0, 0, 0, 0, number, 3)
    return Endpoint(name, "std_msgs::msg::dds_::String_", writes, node, "/", gid)


def process(pid: int, node: str) -> list[Any]:
    return [
        endpoint(pid, "ros_discovery_info", "_NODE_NAME_UNKNOWN_"),
        endpoint(pid, "rt/chatter", node, number=1),
        endpoint(pid, "rq/addRequest", node, writes=False, number=2),
        endpoint(pid, "rr/addReply", node, number=3),
    ]


def complete(ends: list[Any], participants: int) -> bool:
    from ros2cli.discovery import is_complete
    from ros2cli.snapshot import Snapshot

    return is_complete(Snapshot((), tuple(ends)), "own", participants)


def test_every_port_has_told_about_itself() -> None:
    ends = [*process(1, "own"), *process(2, "other")]
    assert complete(ends, 2)
    assert not complete(ends, 3)


@pytest.mark.parametrize("missing", [1, 2, 3])
def test_one_endpoint_of_a_service_or_the_only_node_is_missing(missing: int) -> None:
    ends = [*process(1, "own"), *process(2, "other")]
    left = [end for end in ends if (end.node, end.gid[14]) != ("other", missing)]
    assert complete(left, 2) is (missing == 1)


def test_an_endpoint_without_its_node_is_waited_for() -> None:
    ends = [*process(1, "own"), *process(2, "other"), endpoint(2, "rt/new", "_NODE_NAME_UNKNOWN_", number=9)]
    assert not complete(ends, 2)


@pytest.mark.slow
def test_listings_without_daemon_are_complete_every_time(workspace: Path) -> None:
    cases = [typed("ros2", "node", "list", "--no-daemon")] * 8
    seen = {outcome.stdout for outcome in among(["publisher", "server", "parameters"], cases, workspace)}
    nodes = ("amazing_quote_configurable_publisher_node", "amazing_quote_publisher_node")
    assert seen == {"".join(f"/{name}\n" for name in (*nodes, "what_is_the_point_service_server"))}


def test_names_and_types() -> None:
    from ros2cli.snapshot import Endpoint, Snapshot

    request = Endpoint("rq/a/bRequest", "p::srv::dds_::S_Request_", False, "n", "/x", (0,) * 16)
    hidden = Endpoint("rt/_h/t", "p::msg::dds_::M_", True, "n", "/x", (0,) * 16)
    known = Snapshot(("/x/n",), (request, hidden))
    assert known.services() == {"/a/b": ["p/srv/S"]}
    assert known.topics() == {}
    assert known.topics(hidden=True) == {"/_h/t": ["p/msg/M"]}
    assert known.of_node("/x/n", "request", writes=False) == {"/a/b": ["p/srv/S"]}
    assert len(known.servers("/a/b")) == 1 and not known.clients("/a/b")


def test_a_snapshot_survives_being_sent() -> None:
    import json

    from ros2cli.snapshot import Snapshot, from_data, to_data

    known = Snapshot(("/own",), tuple(process(1, "own")))
    assert from_data(json.loads(json.dumps(to_data(known)))) == known


def test_ports_of_the_domain_are_counted(tmp_path: Path) -> None:
    from ros2cli.ports import local_participants

    table = tmp_path / "udp"
    ports = [7400, 7410, 7411, 7412, 7413, 7660, 53]
    lines = [f" {port}: 00000000:{port:04X} 00000000:0000 07 0:0 0:0 0" for port in [*ports, 7410]]
    table.write_text("head\n" + "\n".join(lines) + "\n")
    assert local_participants(0, table) == 2
    assert local_participants(1, table) == 1
    assert local_participants(0, tmp_path / "none") == 0


def test_a_killed_process_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    from ros2cli import living
    from ros2cli.snapshot import Snapshot

    monkeypatch.setattr(living, "local_participants", lambda domain: 1)
    running = {int(entry.name) & 0xFFFF for entry in Path("/proc").iterdir() if entry.name.isdigit()}
    gone = next(number for number in range(2, 0xFFFF) if number not in running)
    ends = (*process(os.getpid() & 0xFFFF, "own"), *process(gone, "other"))
    left = living.without_the_dead(Snapshot(("/other", "/own"), ends), "own")
    assert left.nodes == ("/own",)
    assert {end.node for end in left.endpoints} == {"own", "_NODE_NAME_UNKNOWN_"}
    # One more port than living processes: someone is there whose number is not to be seen.
    monkeypatch.setattr(living, "local_participants", lambda domain: 2)
    assert living.without_the_dead(Snapshot(("/other", "/own"), ends), "own").nodes == ("/other", "/own")


def test_a_stopped_process_is_seen() -> None:
    from ros2cli.living import is_any_stopped

    with subprocess.Popen(["sleep", "60"]) as sleeper:
        sleeper.send_signal(signal.SIGSTOP)
        os.waitid(os.P_PID, sleeper.pid, os.WSTOPPED | os.WNOWAIT)
        assert is_any_stopped()
        sleeper.kill()


@pytest.mark.parametrize(
    ("waited", "patience", "stopped", "over"),
    [
        (2.5, None, False, False),
        (2.5, None, True, True),
        (10.5, None, False, True),
        (0.6, 0.5, False, True),
        (2.5, 9.0, True, False),
    ],
)
def test_who_is_not_heard_is_waited_for_unless_something_is_stopped(
    waited: float, patience: float | None, stopped: bool, over: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    from ros2cli import discovery

    monkeypatch.setattr(discovery, "is_any_stopped", lambda: stopped)
    assert discovery.is_over(waited, patience) is over


def test_states_of_processes(tmp_path: Path) -> None:
    from ros2cli.living import is_any_stopped

    for number, text in enumerate(["7 (a) S 1", "8 (T) S) R 1", ""]):
        (tmp_path / str(number)).mkdir()
        (tmp_path / str(number) / "stat").write_text(text)
    (tmp_path / "9").mkdir()  # gone meanwhile
    assert not is_any_stopped(tmp_path)
    (tmp_path / "0/stat").write_text("7 (a b) T 1")
    assert is_any_stopped(tmp_path)
