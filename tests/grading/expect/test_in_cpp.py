"""What is said about C++ nodes, where the words differ from Python."""

from __future__ import annotations

import pytest

from course.evidence.recording import Recording
from course.grading.expect.endpoints import expect_node, expect_type
from course.grading.expect.logs import expect_logged
from course.grading.expect.programs import expect_clean_end, expect_clean_interrupt, expect_running
from course.model.events import Event, GraphSeen, OutputLine, ProcessExited, SignalSent
from course.model.feedback import Feedback
from course.model.graph import Endpoint, Graph, Qos
from tests.golden import golden

from .conftest import STARTED, log, record, told

EXAMPLE = "Printed 0 times."
INTERRUPTED = SignalSent(5.0, "talker", 2)
TIMER = "timer_ = create_wall_timer(500ms, tick);\n"
PYTHON = ("rclpy", "self.", "print`", "KeyboardInterrupt", "__init__", "sys.exit", "setup.py")


def end(t: float, code: int | None = 0, number: int | None = None) -> ProcessExited:
    return ProcessExited(t, "talker", code, number)


def cpp(*events: Event, code: str = "") -> Recording:
    return record(STARTED, *events, files={"src/talker.cpp": f"\n{code}"})


def in_cpp(feedback: Feedback) -> Feedback:
    said = f"{feedback.summary} {feedback.expected} {feedback.advice}"
    assert not [word for word in PYTHON if word in said]
    return feedback


@pytest.mark.parametrize(
    "code",
    [
        "int main() {}",
        "rclcpp::init(1, a); rclcpp::spin(n);",
        "rclcpp::init(1, a); rclcpp::spin_some(n);",
        "rclcpp::init(1, a);",
    ],
)
def test_ended_by_itself(code: str) -> None:
    golden(in_cpp(told(expect_running, cpp(end(1.0), code=code), "talker")))


def test_an_exception_and_a_signal() -> None:
    lines = [
        OutputLine(1.0, "talker", "terminate called after throwing an instance of 'std::bad_weak_ptr'"),
        OutputLine(1.0, "talker", "  what():  bad_weak_ptr"),
    ]
    assert "std::bad_weak_ptr" in told(expect_running, cpp(*lines, end(1.1, None, 6)), "talker").summary
    assert "The program stopped" in told(expect_running, cpp(end(1.1, None, 11)), "talker").summary
    assert "by zero" in told(expect_clean_end, cpp(end(1.1, None, 8)), "talker").summary


def test_a_clean_end() -> None:
    assert "`return 0;`" in str(in_cpp(told(expect_clean_end, cpp(end(1.0, 3)), "talker")).advice)
    assert "loop" in str(in_cpp(told(expect_clean_end, cpp(INTERRUPTED), "talker")).advice)


def test_ctrl_c() -> None:
    expect_clean_interrupt(cpp(INTERRUPTED, end(5.1)), "talker")
    expect_clean_interrupt(cpp(INTERRUPTED, end(5.1, None, 2)), "talker")
    golden(in_cpp(told(expect_clean_interrupt, cpp(INTERRUPTED, code="while (true) {}"), "talker")))
    golden(in_cpp(told(expect_clean_interrupt, cpp(INTERRUPTED, end(5.1, 7)), "talker")))
    golden(in_cpp(told(expect_clean_interrupt, cpp(INTERRUPTED, end(5.1, None, 6)), "talker")))


def test_a_loop_that_goes_on_after_ctrl_c() -> None:
    lines = [
        OutputLine(5.1, "talker", "terminate called after throwing an instance of 'rclcpp::RCLError'"),
        OutputLine(
            5.1, "talker", "  what():  the given context is not valid, either rcl_init() was not called"
        ),
    ]
    recording = cpp(INTERRUPTED, *lines, end(5.2, None, 6), code="while (true) { spin_some(node); }")
    golden(in_cpp(told(expect_clean_interrupt, recording, "talker")))


def test_an_error_before_ctrl_c_is_no_matter_of_it() -> None:
    early = OutputLine(1.0, "talker", "terminate called after throwing an instance of 'x'")
    expect_clean_interrupt(cpp(early, INTERRUPTED, end(5.1)), "talker")


def seen(*nodes: str) -> GraphSeen:
    return GraphSeen(1.0, Graph(nodes))


def test_the_name_of_a_node() -> None:
    assert expect_node(cpp(seen("/a", "/cpp_print_forever_node")), "print_forever", whole=False) == (
        "/cpp_print_forever_node"
    )
    code = 'Talker() : rclcpp::Node("my_node") {}'
    golden(in_cpp(told(expect_node, cpp(seen("/my_node"), code=code), "print_forever", whole=False)))
    golden(told(expect_node, cpp(), "print_forever", whole=False))
    golden(in_cpp(told(expect_node, cpp(seen("/my_node")), "/talker")))


def test_a_type() -> None:
    endpoint = Endpoint("/chatter", "publisher", "/talker", "std_msgs/msg/Int32", "", Qos())
    recording = cpp(
        GraphSeen(1.0, Graph(("/talker",), (endpoint,))),
        code='pub_ = create_publisher<std_msgs::msg::Int32>("chatter", 10);',
    )
    golden(in_cpp(told(expect_type, recording, "publisher", "/chatter", "std_msgs/msg/String")))


def logged(recording: Recording) -> Feedback:
    lines = tuple(line for line in recording.log if "Printed" in line.text)
    return in_cpp(told(expect_logged, recording, "talker", lines, EXAMPLE, "Print"))


@pytest.mark.parametrize(
    ("macro", "level"), [("RCLCPP_WARN", 30), ("RCLCPP_ERROR_STREAM", 40), ("RCLCPP_FATAL_ONCE", 50)]
)
def test_another_level(macro: str, level: int) -> None:
    golden(logged(cpp(log(1.0, EXAMPLE, level), code=f"{macro}(get_logger(), x);")))


@pytest.mark.parametrize(
    "text", ["Print %d times.", "Print << count_ << times.", "Print {} times.", "Print 0 times"]
)
def test_other_words(text: str) -> None:
    golden(logged(cpp(log(1.0, text))))


def test_a_text_of_cpp_for_percent_s() -> None:
    code = '\nRCLCPP_INFO(get_logger(), "%s", text{});'
    found = logged(cpp(log(1.0, ""), code=code.format("")))
    assert "c_str()" in str(found.advice)
    assert [place.line for place in found.where] == [3]
    assert "c_str()" not in str(logged(cpp(log(1.0, ""), code=code.format(".c_str()"))).advice)


@pytest.mark.parametrize("code", ['std::cout << "Print";', 'printf("Print");'])
def test_printed_and_not_logged(code: str) -> None:
    golden(logged(cpp(OutputLine(1.0, "talker", EXAMPLE), code=code)))


@pytest.mark.parametrize(
    "code",
    [
        "RCLCPP_DEBUG(get_logger(), x);",
        "",
        "auto timer = create_wall_timer(500ms, tick);",
        TIMER,
        f"{TIMER}rclcpp::spin(node);",
    ],
)
def test_silent(code: str) -> None:
    golden(logged(cpp(code=code)))
