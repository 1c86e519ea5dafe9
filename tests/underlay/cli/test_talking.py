"""`topic echo`, `pub`, `hz`, `bw`, `delay` and `service echo`: what no capture shows."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.underlay.cli.place import Outcome, among, typed

pytestmark = pytest.mark.slow

_TOPIC, _TYPE = "/amazing_quote", "package_with_interfaces/msg/AmazingQuote"
_QUOTE = "quote: Use the force, Pikachu!\nphilosopher_name: Uncle Ben\n---\n"


def test_echo(workspace: Path) -> None:
    once = ["ros2", "topic", "echo", "--once"]
    good, info, shown, bad, none, invalid = among(
        ["publisher"],
        [
            typed(*once, "--field", "philosopher_name", _TOPIC),
            typed(*once, "-i", _TOPIC),
            typed(*once, "--no-str", "-l", "5", _TOPIC),
            typed(*once, "--filter", "m.id ==", _TOPIC),
            typed("ros2", "topic", "echo", "/nosuch", "std_msgs/msg/Nosuch"),
            typed("ros2", "topic", "echo", "/no such"),
        ],
        workspace,
    )
    assert good == Outcome(0, "Uncle Ben\n---\n", "")
    head, _, message = info.stdout.partition("---\n")
    assert message.endswith(_QUOTE)
    assert re.fullmatch(r"(\w+: (\d+|null)\n)+", head)
    assert {"source_timestamp", "received_timestamp"} <= {line.split(":")[0] for line in head.splitlines()}
    assert "<string length: <23>>" in shown.stdout
    for outcome in (bad, none, invalid):
        assert (outcome.code, outcome.stdout, outcome.stderr.count("\n")) == (1, "", 1)


def test_a_latched_message_is_heard_though_the_type_is_given(workspace: Path) -> None:
    lasting = ["--qos-durability", "transient_local", "--qos-reliability", "reliable"]
    shell = (
        "said=$(mktemp); "
        f"ros2 topic pub --rate 0.01 {' '.join(lasting)} /latched std_msgs/msg/Int64 'data: 5' >$said & "
        "until grep -q 'publishing #1' $said; do sleep 0.1; done; "
        "timeout 40 ros2 topic echo --once /latched std_msgs/msg/Int64; kill $!; rm $said"
    )
    (outcome,) = among([], [typed("bash", "-c", shell)], workspace)
    assert outcome.stdout == "data: 5\n---\n"


def test_a_closed_pipe_is_no_error(workspace: Path) -> None:
    line = "{} | head -n 1 >/dev/null; echo ${{PIPESTATUS[0]}}"
    commands = (f"ros2 topic echo {_TOPIC}", "ros2 topic pub -r 20 /none std_msgs/msg/Int64", "ros2 -h")
    cases = [typed("bash", "-c", line.format(command)) for command in commands]
    echo, pub, short = among(["publisher"], cases, workspace)
    assert echo == pub == Outcome(0, "141\n", "")
    assert short in (Outcome(0, "0\n", ""), Outcome(0, "141\n", ""))


def test_sigterm_ends_with_15(workspace: Path) -> None:
    stop = {"signal": "SIGTERM", "when": r"\S"}
    lines = (
        f"topic echo {_TOPIC}", "topic hz /nosuch", f"topic bw {_TOPIC}", "doctor hello",
        "topic pub /none std_msgs/msg/Int64", "topic pub --once /none std_msgs/msg/Int64",
        "service call /nosuch std_srvs/srv/SetBool", "service echo /nosuch std_srvs/srv/SetBool",
    )  # fmt: skip
    found = among(["publisher"], [typed("ros2", *line.split(), stop=stop) for line in lines], workspace)
    assert {line: outcome.code for line, outcome in zip(lines, found, strict=True)} == dict.fromkeys(
        lines, 15
    )
    assert not any("Traceback" in outcome.stderr for outcome in found)


def test_pub_reads_values_from_a_pipe_and_nobody_needs_to_listen(workspace: Path) -> None:
    pub = "ros2 topic pub --once -w 0 /none"
    cases = [
        typed("bash", "-c", f"echo 'data: 7' | {pub} --stdin std_msgs/msg/Int64"),
        typed(*pub.split(), "std_msgs/msg/Int64", "-p", "2", "data: 7"),
        typed(*pub.split()[:4], "--max-wait-time-secs", "0.2", "/none", "std_msgs/msg/Int64"),
        typed(*pub.split()[:4], "/no such", "std_msgs/msg/Int64"),
        typed(*pub.split(), "std_msgs/msg/Int64", "data: [1"),
    ]
    piped, unprinted, impatient, unnamed, malformed = among([], cases, workspace)
    said = "publisher: beginning loop\n"
    assert piped == Outcome(0, f"{said}publishing #1: std_msgs.msg.Int64(data=7)\n\n", "")
    assert unprinted == Outcome(0, said, "")
    assert impatient.code == 1
    assert "Expected 1 subscribers but only got 0 subscribers" in impatient.stderr
    for outcome in (unnamed, malformed):
        assert (outcome.code, outcome.stderr.count("\n")) == (1, 1)


def _until(report: str) -> dict[str, str]:
    """Stop it at the third report or a later one: what was late at first is right in the end."""
    return {"when": rf"(average .*\n\tmin.*\n){{2,}}average {report}.*\n\tmin"}


def _reported(outcome: Outcome, what: str) -> list[float]:
    return [float(number) for number in re.findall(rf"average {what}: ([\d.]+)", outcome.stdout)]


def test_hz_and_delay(workspace: Path) -> None:
    ten = _until(r"rate: (9|10)\.")
    rate, noslash, filtered, delay, nothing = among(
        ["stamps", "publisher"],
        [
            typed("ros2", "topic", "hz", "/stamped", stop=ten),
            typed("ros2", "topic", "hz", "stamped", "-w", "5", stop=ten),
            typed(
                "ros2", "topic", "hz", "--filter", "m.id % 2 == 0", _TOPIC, stop=_until(r"rate: (0\.9|1\.0)")
            ),
            typed("ros2", "topic", "delay", "/stamped", stop=_until(r"delay: 0\.(19[1-9]|[234])")),
            typed("ros2", "topic", "delay", _TOPIC),
        ],
        workspace,
    )
    for outcome, wanted in ((rate, 10.0), (noslash, 10.0), (filtered, 1.0)):
        assert (outcome.code, outcome.stderr) == (2, "")
        assert pytest.approx(wanted, rel=0.1) in _reported(outcome, "rate")[2:]
    assert "window: 6\n" in noslash.stdout
    assert any(0.19 < average < 0.5 for average in _reported(delay, "delay")[2:])
    assert nothing == Outcome(1, "", "msg does not have header\n")


def test_simulated_time_is_that_of_the_clock(workspace: Path) -> None:
    """A clock of a tenth of the usual pace makes ten times the rate."""
    hz = ["ros2", "topic", "hz", "-s", "/stamped"]
    cases = [
        typed(*hz, stop=_until(r"rate: (8.|9.|10.|11.)\.")),
        typed(*hz, "--wall-time", stop=_until(r"rate: (8|9|10|11)\.")),
    ]
    slow, usual = among(["stamps", "slow_clock"], cases, workspace)
    assert pytest.approx(100.0, rel=0.2) in _reported(slow, "rate")[2:]
    assert pytest.approx(10.0, rel=0.2) in _reported(usual, "rate")[2:]


def test_service_echo(workspace: Path) -> None:
    shell = (
        "set -m; said=$(mktemp); ros2 service echo {options} /switch > $said & pid=$!; "
        "until ros2 topic info /switch/_service_event | grep -q 'Subscription count: 1'; do :; done; "
        "ros2 service call /switch std_srvs/srv/SetBool '{{data: true}}' > /dev/null; "
        "until grep -Eq 'RESPONSE_SENT|^2,' $said; do sleep 0.1; done; "
        "kill -INT $pid; wait $pid; echo $?; cat $said; rm $said"
    )
    cases = [
        typed("bash", "-c", shell.format(options=options))
        for options in ("", "--csv", "--flow-style --no-str")
    ]
    cases += [
        typed("ros2", "service", "echo", "/quiet", stop={"when": "introspection is off.*\n"}),
        typed("ros2", "service", "echo", "/nosuch"),
        typed("ros2", "service", "echo", "/switch", "std_srvs/srv/Nosuch"),
    ]
    plain, csv, flow, quiet, unknown, malformed = among(["introspected"], cases, workspace)
    assert plain.stdout.startswith("2\ninfo:\n  event_type: REQUEST_RECEIVED\n  stamp:\n")
    assert "request:\n- data: true\nresponse: []\n---\n" in plain.stdout
    assert "  event_type: RESPONSE_SENT\n" in plain.stdout
    assert re.search(r"^1,\d+,\d+,.*,True,$", csv.stdout, re.M)
    assert "request: [{data: true}]\n" in flow.stdout
    assert (quiet.code, quiet.stdout, quiet.stderr.count("\n")) == (2, "", 1)
    assert "introspection is off" in quiet.stderr
    assert unknown == Outcome(1, "", "Could not determine the type for the passed service\n")
    assert malformed == Outcome(1, "", "The service type 'std_srvs/srv/Nosuch' is invalid\n")
