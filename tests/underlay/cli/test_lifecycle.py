"""`ros2 lifecycle` with two nodes that have states, one of them hidden."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.underlay.cli.place import Outcome, among, typed

pytestmark = pytest.mark.slow

_NEXT = """\
- configure [1]
\tStart: unconfigured
\tGoal: configuring
- shutdown [5]
\tStart: unconfigured
\tGoal: shuttingdown
"""
_UNKNOWN = "Unknown transition requested, available ones are:\n- configure [1]\n- shutdown [5]\n"


def _ask(workspace: Path, *commands: str) -> list[Outcome]:
    """With an ordinary node beside them."""
    cases = [typed("ros2", "lifecycle", *command.split()) for command in commands]
    return among(["managed", "stamps"], cases, workspace)


def test_listings(workspace: Path) -> None:
    commands = {
        "nodes": "/managed\n",
        "nodes -a --no-daemon": "/_hidden_managed\n/managed\n",
        "nodes -c": "1\n",
        "nodes -a -c": "2\n",
        "get": "/managed: unconfigured [1]\n",
        "get --include-hidden-nodes": "/_hidden_managed: unconfigured [1]\n/managed: unconfigured [1]\n",
        "get managed": "unconfigured [1]\n",
        "list managed": _NEXT,
    }
    *found, every = _ask(workspace, *commands, "list -a managed")
    assert found == [Outcome(0, text, "") for text in commands.values()]
    assert every.stdout.count("\tStart: ") == 25
    assert "- transition_error [62]\n\tStart: errorprocessing\n\tGoal: finalized\n" in every.stdout


def test_transitions(workspace: Path) -> None:
    steps = ["configure", "activate", "deactivate", "cleanup", "6"]
    after = ["inactive [2]", "active [3]", "inactive [2]", "inactive [2]", "finalized [4]"]
    commands = [word for step in steps for word in (f"set /managed {step}", "get /managed")]
    found = _ask(workspace, *commands)
    assert [outcome.stdout for outcome in found[1::2]] == [f"{state}\n" for state in after]
    done, refused = Outcome(0, "Transitioning successful\n", ""), Outcome(0, "", "Transitioning failed\n")
    assert found[::2] == [done, done, done, refused, done]


def test_what_is_wrong(workspace: Path) -> None:
    unknown, *absent = _ask(
        workspace,
        "set managed noop",
        "get /nosuch",
        "list stamps",
        "set _hidden_managed configure",
    )
    assert unknown == Outcome(1, "", _UNKNOWN)
    assert absent == [Outcome(1, "", "Node not found\n")] * 3
