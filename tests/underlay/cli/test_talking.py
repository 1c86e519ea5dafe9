"""`topic echo`, `pub`, `hz` and `service call`: words, exit codes, Ctrl+C."""

from __future__ import annotations

import re

import pytest

from tests.underlay.cli.place import Outcome, captured, ros2_among

pytestmark = pytest.mark.slow

_TOPIC, _TYPE = "/amazing_quote", "std_msgs/msg/Int64"
_SERVICE, _SERVICE_TYPE = "/what_is_the_point", "std_srvs/srv/SetBool"
_ASKED = "requester: making request: std_srvs.srv.SetBool_Request(data={data})\n\n"
_ANSWERED = "response:\nstd_srvs.srv.SetBool_Response(success={data}, message='done')\n\n"


def test_echo() -> None:
    once = ["topic", "echo", "--once"]
    cases: list[tuple[list[str], float | None]] = [
        ([*once, _TOPIC], None),
        ([*once, "amazing_quote"], None),
        ([*once, "--csv", _TOPIC], None),
        ([*once, "--field", "data", _TOPIC], None),
        ([*once, "--filter", "m.data == 1979", _TOPIC], None),
        ([*once, "--field", "nosuch", _TOPIC], None),
        ([*once, "--filter", "m.data ==", _TOPIC], None),
        (["topic", "echo", "/nosuch", "std_msgs/msg/Nosuch"], None),
        (["topic", "echo", "/no such"], None),
    ]
    found = ros2_among(["publisher"], cases)
    yaml = Outcome(0, "data: 1979\n---\n", "")
    assert found[:5] == [yaml, yaml, Outcome(0, "1979\n", ""), Outcome(0, "1979\n---\n", ""), yaml]
    assert found[5] == Outcome(1, "", "Invalid field 'nosuch': 'Int64' object has no attribute 'nosuch'\n")
    for outcome in found[6:]:
        assert (outcome.code, outcome.stdout, outcome.stderr.count("\n")) == (1, "", 1)


def test_ctrl_c_ends_with_2() -> None:
    cases = [
        (["topic", "echo", _TOPIC], 3.0),
        (["topic", "echo", "/nosuch", _TYPE], 3.0),
        (["topic", "hz", _TOPIC], 5.0),
        (["topic", "hz", "/nosuch"], 5.0),
        (["topic", "pub", "-r", "2", "/none", _TYPE, "data: 1"], 3.0),
        (["service", "call", "/nosuch", _SERVICE_TYPE], 3.0),
    ]
    found = ros2_among(["publisher"], cases)
    assert [outcome.code for outcome in found] == [2] * len(cases)
    assert {outcome.stderr for outcome in found} == {""}
    assert found[0].stdout.startswith("data: 1979\n---\n")
    assert found[1].stdout == ""
    rate = re.search(r"^average rate: ([\d.]+)\n\tmin: ", found[2].stdout, re.M)
    assert rate and 9.0 < float(rate[1]) < 11.0
    assert found[3].stdout == "WARNING: topic [/nosuch] does not appear to be published yet\n"
    assert found[4].stdout.startswith(
        "publisher: beginning loop\npublishing #1: std_msgs.msg.Int64(data=1)\n\n"
    )
    assert found[5].stdout == "waiting for service to become available...\n"


def test_pub() -> None:
    once = ["topic", "pub", "--once", _TOPIC]
    good = [[*once, _TYPE, "{data: 7}"], [*once, "std_msgs/Int64", "data: 7"]]
    bad = {
        "topic_pub_bad_type": [*once, "std_msgs/msg/Nosuch", "{}"],
        "topic_pub_bad_pkg": [*once, "nosuch/msg/Nosuch", "{}"],
        "topic_pub_not_dict": [*once, _TYPE, "5"],
        "topic_pub_bad_value": [*once, _TYPE, "{data: hello}"],
        "topic_pub_bad_field": [*once, _TYPE, "{nosuch: 1}"],
    }
    found = ros2_among(["subscriber"], [(arguments, None) for arguments in [*good, *bad.values()]])
    for outcome in found[:2]:
        said = outcome.stdout.replace("Waiting for at least 1 matching subscription(s)...\n", "")
        assert (outcome.code, outcome.stderr) == (0, "")
        assert said == "publisher: beginning loop\npublishing #1: std_msgs.msg.Int64(data=7)\n\n"
    for name, outcome in zip(bad, found[2:], strict=True):
        expected = captured(name)[1].stderr.replace("AmazingQuote", "Int64")
        assert (outcome.code, outcome.stderr) == (1, expected)


def test_service_call() -> None:
    call = ["service", "call", _SERVICE]
    good = [[*call, _SERVICE_TYPE, "{data: true}"], [*call, "std_srvs/SetBool"]]
    bad = {
        "service_call_bad_type": [*call, "std_srvs/srv/Nosuch", "{}"],
        "service_call_malformed_type": [*call, "Nosuch", "{}"],
        "service_call_not_dict": [*call, _SERVICE_TYPE, "5"],
        "service_call_bad_field": [*call, _SERVICE_TYPE, "{nosuch: 1}"],
    }
    found = ros2_among(["server"], [(arguments, None) for arguments in [*good, *bad.values()]])
    for outcome, data in zip(found, (True, False), strict=False):
        assert (outcome.code, outcome.stderr) == (0, "")
        said = outcome.stdout.replace("waiting for service to become available...\n", "")
        assert said == (_ASKED + _ANSWERED).format(data=data)
    for name, outcome in zip(bad, found[2:], strict=True):
        expected = captured(name)[1].stderr.replace("WhatIsThePoint", "SetBool")
        assert outcome == Outcome(1, "", expected)
