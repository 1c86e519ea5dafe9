"""The reference for authors of graders: complete, current, and findable by name."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import course.api
from course.authoring.api_reference import Reference, as_page
from course.errors import UsageError

if TYPE_CHECKING:
    from tests.cli.conftest import Ros2course

PAGE = Path(__file__).parents[2] / "docs/api.md"


@pytest.fixture(scope="module")
def reference() -> Reference:
    return Reference()


def test_the_page_is_current(reference: Reference) -> None:
    assert PAGE.read_text(encoding="utf-8") == as_page(reference), "./ros2course api --out docs/api.md"


def test_everything_public_is_in_it(reference: Reference) -> None:
    told = {entry.name.partition(".")[0] for entry in reference.entries()}
    names = {name for name in vars(course.api) if not name.startswith("_")}
    aside = {"annotations", "TYPE_CHECKING", "Arena", "Recording"}  # told as `arena` and `recording`
    assert names - told == aside
    assert {"arena", "recording", "Listener", "Stimulus", "Process", "TopicView"} <= told


def test_every_function_says_what_it_does(reference: Reference) -> None:
    assert [one.signature for one in reference.entries() if "(" in one.signature and not one.text] == []


def test_what_is_returned_is_told(reference: Reference) -> None:
    known = {entry.name for entry in reference.entries()}
    given = {name for entry in reference.entries() for name in entry.gives}
    assert given <= known and "ServiceView" in given


def test_signatures(reference: Reference) -> None:
    def of(name: str) -> list[str]:
        return [entry.signature for entry in reference.named(name)]

    assert of("recording.topic") == ["recording.topic(name: str) -> TopicView"]
    assert of("arena.interrupt") == ["arena.interrupt(process: Process | None, grace: float = 4.0)"]
    assert of("arena.mark") == ["arena.mark(name: str, detail: str = '')"]
    assert of("arena.shell")[0].startswith("arena.shell(name: str = 'bash', ")  # from the class above
    assert of("TopicView.messages") == ["TopicView.messages: tuple[Message, ...]"]
    (endpoint,) = of("expect_endpoint")
    assert "kind: Literal['publisher', 'subscription'], topic: str, *, remedy: str" in endpoint


def test_by_the_last_part_alone(reference: Reference) -> None:
    assert {one.name for one in reference.named("subscribe")} == {"arena.ros.subscribe"}
    with pytest.raises(UsageError, match="did you mean `subscribe`"):
        reference.named("subscrbe")


def test_the_command(ros2course: Ros2course, tmp_path: Path) -> None:
    every = ros2course("api").out
    assert "  recording: Everything observed" in every and "\n  expect_period: " in every
    shown = ros2course("api", "recording.topic").out
    assert re.search(r"^    recording\.topic\(name: str\) -> TopicView$", shown, re.M)
    assert "TopicView.between(begin: float, end: float)" in shown  # what it returns is explained too
    wrong = ros2course("api", "recording.topc")
    assert wrong.code == 2 and "recording.topic" in wrong.err
    assert ros2course("api", "--out", str(tmp_path / "api.md")).code == 0
    assert (tmp_path / "api.md").read_text(encoding="utf-8") == PAGE.read_text(encoding="utf-8")
