"""`ros2 action` with the Fibonacci action of example_interfaces."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.underlay.cli.place import Outcome, among, typed

pytestmark = pytest.mark.slow

_TYPE = "example_interfaces/action/Fibonacci"
_SENDING = "Waiting for an action server to become available...\nSending goal:\n     order: {order}\n\n"
_ACCEPTED = "Goal accepted with ID: "
_FEEDBACK = "Feedback:\n    sequence:\n{numbers}\n"
_RESULT = "Result:\n    sequence:\n{numbers}\n\nGoal finished with status: SUCCEEDED\n"


def _lines(*numbers: int) -> str:
    return "\n".join(f"- {number}" for number in numbers)


def _ask(workspace: Path, *commands: str) -> list[Outcome]:
    return among(
        ["fibonacci"], [typed("ros2", "action", *command.split()) for command in commands], workspace
    )


def test_listings(workspace: Path) -> None:
    info = "Action: /fibonacci\nAction clients: 0\nAction servers: 1\n"
    commands = {
        "list": "/fibonacci\n",
        "list -t": f"/fibonacci [{_TYPE}]\n",
        "list -c": "1\n",
        "type /fibonacci": f"{_TYPE}\n",
        "info /fibonacci": f"{info}    /fibonacci_server\n",
        "info -t /fibonacci": f"{info}    /fibonacci_server [{_TYPE}]\n",
        "info -c /fibonacci": info,
    }
    found = _ask(workspace, *commands, "type /nosuch", "info /nosuch")
    assert found[:-2] == [Outcome(0, text, "") for text in commands.values()]
    assert found[-2] == Outcome(1, "", "")
    assert found[-1] == Outcome(0, "Action: /nosuch\nAction clients: 0\nAction servers: 0\n", "")


def test_a_goal_with_feedback(workspace: Path) -> None:
    send = ["ros2", "action", "send_goal", "/fibonacci", _TYPE]
    cases = [typed(*send, "{order: 3}"), typed(*send, "-f", "order: 3"), typed(*send, "{order: 0}")]
    plain, watched, rejected = among(["fibonacci"], cases, workspace)
    head, _, rest = plain.stdout.partition(_ACCEPTED)
    assert (plain.code, plain.stderr, head) == (0, "", _SENDING.format(order=3))
    assert rest.partition("\n\n")[2] == _RESULT.format(numbers=_lines(0, 1, 1, 2))
    for numbers in ((0, 1, 1), (0, 1, 1, 2)):
        assert _FEEDBACK.format(numbers=_lines(*numbers)) in watched.stdout
    assert watched.stdout.endswith(_RESULT.format(numbers=_lines(0, 1, 1, 2)))
    assert rejected.stdout == f"{_SENDING.format(order=0)}Goal was rejected.\n"


def test_what_is_wrong(workspace: Path) -> None:
    send = ["ros2", "action", "send_goal"]
    cases = [
        typed(*send, "/fibonacci", "nosuch/action/Nosuch", "{}"),
        typed(*send, "/fibonacci", "std_msgs/msg/String", "{}"),
        typed(*send, "/fibonacci", _TYPE, "{nosuch: 1}"),
        typed(*send, "/fibonacci", _TYPE, "{order: [1"),
        typed(*send, "/nosuch", _TYPE, "{order: 1}", stop={"when": "become available"}),
    ]
    found = among(["fibonacci"], cases, workspace)
    assert [outcome.code for outcome in found] == [1, 1, 1, 1, 2]
    assert [outcome.stderr.count("\n") for outcome in found] == [1, 1, 1, 1, 0]
    assert found[0].stderr == found[1].stderr == "The passed action type is invalid\n"
    assert found[4].stdout == "Waiting for an action server to become available...\n"
