"""The recipe for CI: its workflow is YAML of the right form, and types commands that exist."""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from typer.main import get_command

from course.cli.app import app
from course.cli.usage import global_options_first
from course.files import cache_dir

DOCS = Path(__file__).parents[2] / "docs"
WORKFLOW: dict[Any, Any] = yaml.safe_load((DOCS / "ci/course.yml").read_text(encoding="utf-8"))
OTHERS = {("sudo", "apt-get"), ("sudo", "sysctl"), ("python", "-m")}


def actions() -> Iterator[dict[str, Any]]:
    for job in WORKFLOW["jobs"].values():
        yield from job["steps"]


def lines() -> Iterator[str]:
    for step in actions():
        yield from step.get("run", "").splitlines()


def understood(line: str) -> str:
    """The command that our command line parses; ends like the command itself if there is none."""
    words = global_options_first(shlex.split(line)[1:])
    root = get_command(app)
    above = root.make_context("ros2course", words[:2])
    name, *rest = words[2:] if words[0] == "--course" else words
    root.commands[name].make_context(name, rest, parent=above)  # type: ignore[attr-defined]
    return name


def test_its_form() -> None:
    assert set(WORKFLOW[True]) == {"push", "pull_request", "schedule"}  # YAML reads `on` as true
    for job in WORKFLOW["jobs"].values():
        assert job["runs-on"] == "ubuntu-24.04" and job["timeout-minutes"] <= 360
    assert all(("run" in step) != ("uses" in step) for step in actions())
    assert all("@v" in step["uses"] for step in actions() if "uses" in step)


def test_every_command_of_it_exists() -> None:
    ours = [line for line in lines() if line.startswith("ros2course")]
    assert len(ours) == 4
    for line in ours:
        understood(line)
    others = {tuple(line.split()[:2]) for line in lines() if line not in ours}
    assert others == OTHERS


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ("ros2course validate --junitt x", "junitt"),
        ("ros2course valdate", "valdate"),
        ("ros2course doctor x", "unexpected extra argument"),
    ],
)
def test_a_command_that_does_not_exist_is_seen(line: str, complaint: str) -> None:
    with pytest.raises(Exception, match=complaint):
        understood(line)


def test_results_are_handed_on_even_when_something_was_found() -> None:
    uploads = [step for step in actions() if "upload-artifact" in step.get("uses", "")]
    assert len(uploads) == len(WORKFLOW["jobs"])
    written = {word for line in lines() for word in line.split() if word.endswith(".xml")}
    assert {step["with"]["path"] for step in uploads} == written
    assert all(step["if"] == "always()" for step in uploads)


def test_the_cache_is_the_one_that_is_used() -> None:
    kept = next(step for step in actions() if "actions/cache@" in step.get("uses", ""))
    variable = WORKFLOW["env"]["ROS2COURSE_CACHE"].replace("${{ github.workspace }}", "/clone")
    assert cache_dir({"ROS2COURSE_CACHE": variable}) == Path("/clone") / kept["with"]["path"]


def test_the_document_s_own_commands_exist() -> None:
    text = (DOCS / "ci.md").read_text(encoding="utf-8")
    own = [line.strip() for line in text.splitlines() if line.startswith("venv/bin/ros2course")]
    assert own and all(understood(line) for line in own)
