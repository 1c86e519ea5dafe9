"""What varies from run to run, and where this command is meant to differ from the real one."""

from __future__ import annotations

import re
from dataclasses import replace

from tests.underlay.cli.captured import CAPTURES, Case, Outcome

_VARIES = {
    r"RIHS01_[0-9a-f]{64}": "<hash>",
    r"GID: [0-9a-f.]+": "GID: <gid>",
    r"_ros2cli_(daemon_)?\w+": "_ros2cli_<id>",
    r"^\x1b\[0m|\x1b\[0m$": "",
    r"\[\d{10}\.\d{9}\]": "[<time>]",
    r"^<prefix>/\S+ \d+: UserWarning": "UserWarning",
    r"/[\w/]+/rcl/arguments.c:\d+": "<source>",
    # Numbers of messages, random answers, and what is measured.
    r"\bid: \d+$": "id: <n>",
    r"\bid=\d+\.": "id=<n>.",
    r"^\d+,Use": "<n>,Use",
    r"\b([xyz])=[\d.e-]+": r"\1=<x>",
    r"average rate: [\d.]+": "average rate: <x>",
    r"min: [\d.]+s max: [\d.]+s std dev: [\d.]+s window: \d+": "<spread>",
    r"^\d+ B/s from \d+ messages": "<x> B/s from <n> messages",
    r"(b'\\x00\\x01\\x00\\x00).*?(\\x00\\x00\\x00\\x18)": r"\1<n>\2",
    r"(flags   : )\d+<.*>": r"\1<flags>",
}
# How often they are said depends on how long the other side took to be found.
_WHILE_WAITING = re.compile(
    r"^(Waiting for at least \d+ matching subscription\(s\)|waiting for service to become available)\.\.\.\n",
    re.M,
)
# Two checks of the real one need the internet.
_OFFLINE = re.compile(r"^.*UserWarning: Fail to call \w+ class functions\.\n", re.M)
_NO_YAML = (
    'while parsing a flow sequence in "<unicode string>", line 1, column 5: {a: [1 ^ '
    "expected ',' or ']', but got '<stream end>' in \"<unicode string>\", line 1, column 7: {a: [1 ^"
)
_NO_FILE = (
    'while parsing a flow sequence in "<cwd>/files/broken.yaml", line 1, column 4 '
    "expected ',' or ']', but got '<stream end>' in \"<cwd>/files/broken.yaml\", line 2, column 1"
)
_NOT_YET = "WARNING: topic [/amazing_quote] does not appear to be published yet\n"

# Where the real one shows a traceback, misses what is there, or leaves the node behind.
_BETTER: dict[str, dict[str, str | int]] = {
    "service_call_bad_yaml": {"stderr": f"The passed value is not valid YAML: {_NO_YAML}\n"},
    "param_load_broken_yaml": {"stderr": f"'<cwd>/files/broken.yaml' is not valid YAML: {_NO_FILE}\n"},
    "topic_echo_head": {"stderr": ""},
    "param_get_noslash": {"stdout": "String value is: Use the force, Pikachu!\n"},  # nobody has set it
    "node_list_c_nodaemon": {"stdout": "1\n"},
    "topic_list_c_nodaemon": {"stdout": "3\n"},
    "run_ok_spins_sigint_ros2_only": {"code": 0},
}
# The real one runs on until it is killed: what it prints until then does not matter.
_PASSES_IT_ON = "run_ok_spins_sigint_ros2_only"
_FINDS_AT_ONCE = ("topic_hz", "topic_bw")
_SEES_THE_SUBSCRIBER = "doctor_with_nodes"


def expected(case: Case) -> Outcome:
    """What this command is to print and return."""
    outcome = replace(case.expected, **_BETTER.get(case.name, {}))
    if case.name in _FINDS_AT_ONCE:
        outcome = replace(outcome, stdout=outcome.stdout.replace(_NOT_YET, ""))
    if case.name == _SEES_THE_SUBSCRIBER:
        outcome = replace(outcome, stderr="UserWarning: Only loopback IP address is found.\n")
    if case.name == _PASSES_IT_ON:
        outcome = replace(outcome, stderr="".join(outcome.stderr.splitlines(keepends=True)[:3]))
    return normal(outcome, case)


def normal(outcome: Outcome, case: Case) -> Outcome:
    """Without what varies; of what was stopped, as many lines as the real one had printed by then."""
    out, err = _text(outcome.stdout), _text(outcome.stderr)
    if case.stop is not None:
        out, err = _first(out, _text(case.expected.stdout)), _first(err, _text(case.expected.stderr))
    if case.name in _WAITS_FOR_EVER:
        out = outcome.stdout[: outcome.stdout.find("\n") + 1]
    return Outcome(outcome.code, out, err)


_WAITS_FOR_EVER = ("service_call_no_server", "service_call_wrong_type_server", "topic_pub_wrong_type_topic")


def _first(text: str, real: str) -> str:
    return "".join(text.splitlines(keepends=True)[: real.count("\n")])


def _text(text: str) -> str:
    text = _OFFLINE.sub("", _WHILE_WAITING.sub("", text.replace(str(CAPTURES), "<cwd>")))
    for pattern, instead in _VARIES.items():
        text = re.sub(pattern, instead, text, flags=re.M)
    return text
