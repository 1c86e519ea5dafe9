"""The texts that `crashes/` holds are still those that this machine's ROS writes."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.arena.command_lines import command_for
from course.arena.process import Process
from course.build import Store, Workspace, build
from course.evidence.timeline import Timeline
from course.model.events import OutputLine
from course.rosenv import find_ros, node_environment, prepare

from .conftest import CRASHES, PREFIX, Case, explained, package

pytestmark = pytest.mark.slow

WAIT = 60.0
# Raised in the middle of a file's import, so which of the two comes first depends on how it is run.
ELSEWHERE = ("circular",)
DOMAIN = "99"


def test_each_program_is_explained_as_its_text_is(tmp_path: Path) -> None:
    cases = {name: Case.named(name) for name in CRASHES}
    cases["circular_other"] = Case.named("circular_other")
    ros = find_ros()
    prepare(ros)
    for name, text in package(*cases.values()).items():
        file = tmp_path / "ros2_tutorial_workspace" / "src" / "faulty" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    workspace = Workspace.scan(tmp_path / "ros2_tutorial_workspace")
    outcome = build(workspace, ("faulty",), ros, Store(tmp_path / "store"))
    assert outcome.failure is None
    (prefix,) = outcome.prefixes
    environment = {
        **node_environment(ros, outcome.prefixes),
        "ROS_DOMAIN_ID": DOMAIN,
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    wrong = {}
    for name in CRASHES:
        timeline = Timeline()
        command = command_for(prefix, "faulty", name, str(ros.python))
        program = Process(name, command, env=environment, cwd=tmp_path, timeline=timeline)
        ended = program.wait(WAIT)
        program.close()
        output = "\n".join(event.text for event in timeline.of(OutputLine)).replace(str(prefix), PREFIX)
        found = explained(cases[name], output)
        expected = explained(cases[name])
        assert expected is not None
        first = expected.where[0].file if name in ELSEWHERE else str(expected.where[0])
        if not (
            ended and found and str(found.where[0]).startswith(first) and found.advice == expected.advice
        ):
            wrong[name] = (ended, found, output)
    assert wrong == {}
