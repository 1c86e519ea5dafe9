"""What a launch file should start, and how all of it ends."""

from __future__ import annotations

import signal

import pytest

from course.errors import OurFault
from course.evidence.recording import Recording
from course.grading.expect.launches import (
    expect_launch_file,
    expect_launch_interrupt,
    expect_launch_parameter,
    expect_launched,
    expect_launched_node,
    expect_own_launch_parameter,
    launch_file,
)
from course.model import replace
from course.model.events import (
    Event,
    GraphSeen,
    OutputLine,
    ProcessExited,
    ProcessLeft,
    ProcessStarted,
    SignalSent,
)
from course.model.graph import Graph
from tests.golden import golden

from . import conftest
from .conftest import FOLDER, record, said, told, where
from .parameter_calls import DEFINITIONS, NODE, got

FILE = "talk_launch.py"
PATH = f"launch/{FILE}"
LAUNCH = """\
def generate_launch_description():
    return LaunchDescription([
        Node(package='talk', executable='talker', name='speaker',
             parameters=[{'period': '0.5'}])])
"""
STARTED = ProcessStarted(0.1, FILE, ("ros2", "launch", "talk", FILE))
TALKER = "[INFO] [talker-1]: process started with pid [12]"
INTERRUPTED = SignalSent(5.0, FILE, signal.SIGINT)
CLEAN = "[INFO] [talker-1]: process has finished cleanly [pid 12]"
ENDED = ProcessExited(5.2, FILE, 0, None)
TRACEBACK = """\
[talker-1] Traceback (most recent call last):
[talker-1]   File "/store/talk/lib/python3.12/site-packages/talk/talker.py", line 1, in main
[talker-1] {}"""
PREFACE = "[ERROR] [launch]: Caught exception in launch (see debug for traceback): "
SEVERAL = f"{PREFACE}Caught multiple exceptions when trying to load file of format [py]:\n - "


def lines(t: float, text: str) -> list[Event]:
    return [OutputLine(t, FILE, line) for line in text.splitlines()]


def launched(*events: Event, text: str = LAUNCH, files: dict[str, str] | None = None) -> Recording:
    return record(STARTED, *events, code="rclpy.spin(node)", files={PATH: text, **(files or {})})


def right() -> Recording:
    return launched(*lines(0.4, TALKER), INTERRUPTED, *lines(5.1, CLEAN), ENDED)


def refused(error: str, text: str = LAUNCH) -> Recording:
    return launched(*lines(0.4, error), ProcessExited(0.5, FILE, 1, None), text=text)


def test_what_is_right_passes() -> None:
    assert said(expect_launch_file, right(), "talk", FILE) is None
    assert said(expect_launched, right(), FILE) is None
    assert said(expect_launch_interrupt, right(), FILE) is None


def test_a_launch_that_the_scenario_never_made_passes_nowhere() -> None:
    for expect in (expect_launched, expect_launch_interrupt):
        with pytest.raises(OurFault, match="other_launch"):
            expect(right(), "other_launch.py")


def test_a_file_that_is_not_installed() -> None:
    lost = refused(f"file '{FILE}' was not found in the share directory of package 'talk' which is at '/x'")
    setup = {f"{FOLDER}/setup.py": "setup(data_files=[])"}
    lost = replace(lost, sources=replace(lost.sources, files={**lost.sources.files, **setup}))
    golden(told(expect_launch_file, lost, "talk", FILE))


# starting


def test_a_fault_in_the_launch_file_is_explained_by_its_cause() -> None:
    text = LAUNCH.replace("[{'period': '0.5'}]", "{'period': 0.5}")
    golden(told(expect_launched, refused(f"{SEVERAL}TypeError: Expecting list of parameters", text), FILE))


@pytest.mark.parametrize(
    "error",
    [
        f"SyntaxError: invalid syntax ({FILE}, line 3)",
        "SyntaxError: invalid syntax (other.py, line 3)",
        "NameError: name 'Node' is not defined",
        "TypeError: ... missing 1 ... argument: 'executable'",
        "RuntimeError: x",
    ],
)
def test_errors_without_a_known_cause(error: str) -> None:
    golden(told(expect_launched, refused(f"{SEVERAL}{error}"), FILE))


def test_folders_of_the_build_are_not_shown() -> None:
    error = "executable 'x' not found on the libexec directory '/store/1/lib/talk' (/venv/x.py)"
    golden(told(expect_launched, refused(f"{PREFACE}{error}"), FILE))


@pytest.mark.parametrize(
    "text", [LAUNCH, "def generate_launch_description():\n    return LaunchDescription([])\n"]
)
def test_nothing_is_started(text: str) -> None:
    golden(told(expect_launched, launched(ProcessExited(0.5, FILE, 0, None), text=text), FILE))


def test_a_node_that_falls() -> None:
    fall = launched(
        *lines(0.4, TALKER),
        *lines(0.8, TRACEBACK.format("ValueError: no")),
        *lines(0.9, "[ERROR] [talker-1]: process has died [pid 12, exit code 1, cmd 'talker']."),
        ProcessExited(1.0, FILE, 0, None),
    )
    golden(told(expect_launched, fall, FILE))


def test_a_value_of_another_type() -> None:
    error = (
        "rclpy.exceptions.InvalidParameterTypeException: Trying to set parameter 'period' to '0.5' of type "
        "'STRING', expecting type 'DOUBLE': period"
    )
    fall = launched(*lines(0.4, TALKER), *lines(0.8, TRACEBACK.format(error)))
    golden(told(expect_launched, fall, FILE))


# the node's name


def named(*nodes: str) -> Recording:
    return launched(GraphSeen(1.0, Graph(nodes)))


def test_the_nodes_name() -> None:
    assert said(expect_launched_node, named("/speaker"), FILE, "/speaker") is None
    golden(told(expect_launched_node, named("/talker"), FILE, "/preacher"))
    golden(told(expect_launched_node, named("/choir/speaker"), FILE, "/speaker"))
    golden(told(expect_launched_node, named(), FILE, "/speaker"))


# the end


def test_a_traceback_at_the_end() -> None:
    ugly = launched(
        *lines(0.4, TALKER),
        INTERRUPTED,
        *lines(5.1, TRACEBACK.format("KeyboardInterrupt")),
        *lines(5.1, "[ERROR] [talker-1]: process has died [pid 12, exit code -2, cmd 'talker']."),
        ENDED,
    )
    golden(told(expect_launch_interrupt, ugly, FILE))


def test_a_node_that_does_not_end() -> None:
    deaf = launched(*lines(0.4, TALKER), INTERRUPTED, ProcessExited(9.0, FILE, None, signal.SIGKILL))
    assert "does not end" in told(expect_launch_interrupt, deaf, FILE).summary


def test_a_program_that_is_left_behind() -> None:
    events = (*right().events, ProcessLeft(5.3, FILE, 12, ("talker", "--loud")))
    golden(told(expect_launch_interrupt, replace(right(), events=events), FILE))


def test_the_launch_file_alone() -> None:
    assert list(launch_file(right(), FILE).files) == [f"{FOLDER}/{PATH}"]


# parameters


@pytest.fixture
def _definitions(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(conftest, "DEFINITIONS", DEFINITIONS)


def asked(*events: tuple[Event, ...], parameters: str) -> Recording:
    text = LAUNCH.replace("'period': '0.5'", parameters)
    return launched(*(event for few in events for event in few), text=text)


@pytest.mark.usefixtures("_definitions")
def test_parameters_that_the_launch_file_gives() -> None:
    given = asked(got(1.0, "period", 0.25), got(2.0, "quote", "x"), parameters="'period': 0.25, 'quote': 'x'")
    assert said(expect_launch_parameter, given, FILE, NODE, "period", 0.25) is None
    assert said(expect_own_launch_parameter, given, FILE, NODE, "quote", "y") is None


@pytest.mark.usefixtures("_definitions")
@pytest.mark.parametrize("parameters", ["'period': 0.5", ""])
def test_another_value(parameters: str) -> None:
    golden(
        told(
            expect_launch_parameter,
            asked(got(1.0, "period", 0.5), parameters=parameters),
            FILE,
            NODE,
            "period",
            0.25,
        )
    )


@pytest.mark.usefixtures("_definitions")
@pytest.mark.parametrize("value", ["y", ""])
def test_no_value_of_their_own(value: str) -> None:
    given = asked(got(1.0, "quote", value), parameters=f"'quote': '{value}'")
    golden(told(expect_own_launch_parameter, given, FILE, NODE, "quote", "y"))


@pytest.mark.usefixtures("_definitions")
def test_a_parameter_that_is_misspelt_in_the_launch_file() -> None:
    given = asked(got(1.0, "quote", "y"), parameters="'qoute': 'x'")
    for expect, value in ((expect_launch_parameter, "x"), (expect_own_launch_parameter, "y")):
        found = told(expect, given, FILE, NODE, "quote", value)
        assert found.summary == "The launch file sets `qoute`; the node's parameter is called `quote`."
        assert where(found) == [f"{PATH}:4"]
