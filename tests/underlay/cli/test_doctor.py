"""`ros2 doctor`: its report, its options, and hello."""

from __future__ import annotations

import re
import socket
from pathlib import Path

import pytest

from tests.underlay.cli.captured import case
from tests.underlay.cli.place import among, typed

pytestmark = pytest.mark.slow

# What the real one tells only where it finds the index of all packages on the internet.
_MORE = {"PACKAGE VERSIONS", "ROS 2 INFORMATION"}


def _sections(report: str) -> dict[str, list[str]]:
    """The lines below each title, without what is the machine's."""
    parts = re.split(r"^   ([A-Z0-9 ]+)\n", report, flags=re.M)[1:]
    found = dict(zip(parts[::2], parts[1::2], strict=True))
    return {
        title: [line.split(": ")[0] for line in text.splitlines() if line] for title, text in found.items()
    }


def test_report(workspace: Path) -> None:
    real = case("doctor_report")
    whole, brief = among([], [real.job(), typed("ros2", "doctor", "-r", "-ep")], workspace)
    ours = _sections(whole.stdout)
    assert {title: rows for title, rows in ours.items() if title not in _MORE} == _sections(
        real.expected.stdout
    )
    assert [title for title in ours if title not in _MORE] == list(_sections(real.expected.stdout))
    assert re.search(r"^rclpy +: local=\d", whole.stdout, re.M)
    assert "PACKAGE VERSIONS" not in brief.stdout
    same = re.compile(
        r"^(inet|device|mtu|netmask|system|middleware name|compatibility|topic|publ|subs).*$", re.M
    )
    assert [m[0] for m in same.finditer(brief.stdout)] == [m[0] for m in same.finditer(real.expected.stdout)]


def test_warnings_count_where_that_is_asked_for(workspace: Path) -> None:
    strict, failed = among(
        ["publisher"],
        [typed("ros2", "doctor", "-iw"), typed("ros2", "wtf", "--report-failed", "--include-warnings")],
        workspace,
    )
    verdict = "\n2/3 check(s) failed\n\nFailed modules: network topic\n\n"
    assert (strict.code, strict.stdout) == (1, verdict)
    assert list(_sections(failed.stdout)) == ["NETWORK CONFIGURATION", "TOPIC LIST"]
    assert "topic               : /amazing_quote\n" in failed.stdout


def test_hello(workspace: Path) -> None:
    hello = ["ros2", "doctor", "hello", "-pp", "0.5", "-ep", "0.05"]
    once, often = among(
        [],
        [typed(*hello, "--once", "--ttl", "1"), typed(*hello, stop={"when": r"(?s)(MULTI.*----\n){2}"})],
        workspace,
    )
    assert (once.code, often.code) == (0, 2)
    assert once.stdout.startswith(
        "MULTIMACHINE COMMUNICATION SUMMARY\nTopic: /canyouhearme, Published Msg Count: "
    )
    assert re.search(rf"Subscribed from:\n    {re.escape(socket.gethostname())}: \d+ msgs\n", once.stdout)
    assert "Multicast Group/Port: 225.0.0.1/49150, Sent Msg Count: " in once.stdout
    assert often.stdout.count("MULTIMACHINE") >= 2
    assert once.stderr.count("\n") <= 1
