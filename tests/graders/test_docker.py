"""Chapter 32: how its graders judge files, and where its nodes run on a shared network."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Course
from course.errors import MissingHere, OurFault
from course.evidence.home_files import HomeEntry
from course.evidence.mcap_file import load
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.grading import trial
from course.grading.check import Request, check_exercise
from course.grading.load import load_module
from course.isolation import Level, levels
from course.isolation.levels import obstacle_to
from course.model.events import Marked, OutputLine
from course.model.feedback import Failure, Feedback
from course.model.result import Result
from course.rosenv import find_ros

ROOT = Path(__file__).parents[2]
GRADERS = load_module(ROOT / "graders/ch32_docker.py")
PROFILE = ROOT / "solutions/32-docker" / GRADERS.PROFILE


def recorded(file: str, text: str, *events: Marked | OutputLine) -> Recording:
    entries = (HomeEntry(file, "file", 0o644, len(text)),)
    return Recording("x", events, sources=Sources({file: text}), looked_at=entries)


def complaint(text: str) -> Feedback:
    with pytest.raises(Failure) as caught:
        GRADERS.valid(recorded(GRADERS.COMPOSE, text))
    return caught.value.feedback


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("services: {talker: {image: a, stop_signals: X}}", ("exist in `services.talker`", "`stop_signal`")),
        ("services: {talker: {image: a, healthcheck: {tests: a}}}", ("talker.healthcheck`", "`test`")),
        ("services: {talker: {image: a}}\nlistener: {image: a}", ("`listener` does", "below `services:`")),
        ("services: {talker: {image: a}}\nstop_signal: SIGINT", ("below a service",)),
        ("services: {ta lker: {image: a}}", ("`ta lker`", "letters, digits")),
        (
            "services: {talker: {image: a, environment: {A: [1]}}}",
            ("talker.environment.A` cannot be a list",),
        ),
        ("services: {talker: {image: a, env_file: [{paht: b}]}}", ("`paht` does not exist in",)),
        ("services: {talker: {image: yes}}", ("cannot be `true` or `false`", "quotation marks")),
        ("- services", ("not a list of names",)),
        ("services", ("not a list of names",)),
    ],
)
def test_the_first_thing_that_the_specification_does_not_have_is_named(
    text: str, words: tuple[str, ...]
) -> None:
    feedback = complaint(text)
    said = f"{feedback.summary} {feedback.advice}"
    assert [word for word in words if word not in said] == []


@pytest.mark.parametrize(
    "text",
    [
        "services: {}",
        "services: {a: {image: a, x-mine: 1}}\nx-other: [1]",
        "services: {a: {image: a, deploy: {replicas: 2}, ports: ['1:2', {target: 80}]}}",
        "version: '3'\nservices: {a: {build: ., extends: {service: b}}, b: {image: a}}",
    ],
)
def test_what_the_specification_has_is_valid(text: str) -> None:
    GRADERS.valid(recorded(GRADERS.COMPOSE, text))


@pytest.mark.parametrize(
    ("text", "lasts"),
    [
        *((text, True) for text in ("10s", "1m30s", "0.5m", ".5s", "1500ms", "1h", "0h1s")),
        *((text, False) for text in ("10", "ten", "10 s", "0s", "s", "-5s", "", "10S", "1s2")),
    ],
)
def test_how_long_is_a_time(text: str, lasts: bool) -> None:
    assert GRADERS.lasts(text) is lasts


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("", 0),
        ("ROS_DOMAIN_ID", 0),
        ("ROS_DOMAIN_ID=1", 1),
        ("  ROS_DOMAIN_ID= 1 ", 1),
        ("ROS_DOMAIN_ID=0\n# ROS_DOMAIN_ID=3\nROS_DOMAIN_ID=2", 2),
        ("ROS_DOMAIN_ID=1abc", 1),
        ("ROS_DOMAIN_ID=010", 8),
        ("ROS_DOMAIN_ID=232", 232),
        *((f"ROS_DOMAIN_ID={text}", None) for text in ("233", "-1", '"1"', "one", "", "0x1", "9" * 30)),
    ],
)
def test_the_domain_is_read_as_docker_and_ros_do(text: str, number: int | None) -> None:
    assert GRADERS.number_of(GRADERS.chosen(text)) == number


def test_a_witness_that_hears_nothing_is_never_blamed_on_a_right_domain() -> None:
    heard = OutputLine(1.0, "listener", "listener heard hello 1")
    with pytest.raises(OurFault):
        GRADERS.meet(recorded(GRADERS.DOMAIN_ENV, "ROS_DOMAIN_ID=1\n", heard))
    with pytest.raises(Failure):
        GRADERS.meet(recorded(GRADERS.DOMAIN_ENV, "ROS_DOMAIN_ID=10\n", heard))


def test_without_shared_memory_in_the_control_nothing_is_proven() -> None:
    text = PROFILE.read_text()
    marks = [Marked(1.0, f"shared memory of {name}", "lttng-ust-wait-6") for name in GRADERS.NODES]
    with pytest.raises(OurFault):
        GRADERS.no_memory(recorded(GRADERS.PROFILE, text, *marks))
    control = Marked(0.5, f"shared memory of {GRADERS.WITHOUT}", "fastrtps_port7411 lttng-ust-wait-6")
    GRADERS.no_memory(recorded(GRADERS.PROFILE, text, control, *marks))


@pytest.mark.slow
def test_where_namespaces_are_all_there_is_a_profile_is_judged_too(
    course: Course, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without a sandbox, bubblewrap gives programs their own /dev/shm."""
    if obstacle := obstacle_to(Level.NAMESPACES):
        pytest.skip(f"not exercised: a profile where namespaces are all there is ({obstacle})")
    lacking = {levels.KNOWN: "no sandbox here"}
    monkeypatch.setattr(levels, "unless_known", lambda name, *_: lacking.get(name))
    exercise = course.exercise("32-udp-profile")
    trial.lay_solution(course, exercise, home)
    result = check_exercise(Request(exercise, home, ros=find_ros()))
    assert result.containment == "namespaces"
    assert [check.id for check in result.checks if check.outcome.value != "passed"] == []


def graded(course: Course, home: Path, exercise: str, evidence: Path | None = None, **files: str) -> Result:
    """In a domain on this machine's network, as without namespaces."""
    found = course.exercise(exercise)
    trial.lay_solution(course, found, home)
    for name, text in files.items():
        (home / getattr(GRADERS, name)).write_text(text)
    return check_exercise(Request(found, home, ros=find_ros(), namespaces=False, evidence=evidence))


@pytest.mark.slow
def test_on_a_shared_network_the_nodes_meet_in_a_domain_that_stands_for_1(
    course: Course, home: Path, tmp_path: Path
) -> None:
    """Only the domain in the file reaches a program."""
    evidence = tmp_path / "evidence.mcap"
    text = "LD_PRELOAD=/nonexistent/evil.so\nPATH=/nonexistent\nROS_DOMAIN_ID=1\nPYTHONPATH=/nonexistent\n"
    result = graded(course, home, "32-domain", evidence, DOMAIN_ENV=text)
    assert [check.id for check in result.checks if check.outcome.value != "passed"] == []
    printed = [event.text for event in load(evidence).events if isinstance(event, OutputLine)]
    assert "talker ready" in printed
    assert not [line for line in printed if "evil.so" in line]


@pytest.mark.slow
@pytest.mark.parametrize(("text", "failed"), [("ROS_DOMAIN_ID=10", "meet"), ("ROS_DOMAIN=1", "hidden")])
def test_on_a_shared_network_another_domain_is_another_one(
    course: Course, home: Path, text: str, failed: str
) -> None:
    result = graded(course, home, "32-domain", DOMAIN_ENV=text)
    assert [check.id for check in result.checks if check.outcome.value == "failed"] == [failed]


@pytest.mark.slow
def test_on_a_shared_network_a_profile_cannot_be_judged(course: Course, home: Path) -> None:
    with pytest.raises(MissingHere) as caught:
        graded(course, home, "32-udp-profile")
    assert "namespaces" in caught.value.what
