"""What is said of nodes in C++ where Python has other words."""

from __future__ import annotations

import pytest

from course.evidence.events import Event, GraphSeen, OutputLine, ProcessExited, SignalSent
from course.evidence.graph import Endpoint, Graph, Qos
from course.evidence.recording import Recording
from course.feedback import Feedback
from course.grading.expect.graph import expect_node, expect_node_called, expect_type
from course.grading.expect.logs import expect_logged
from course.grading.expect.programs import expect_clean_end, expect_clean_interrupt, expect_running

from .conftest import STARTED, log, record, told, where

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
    ("code", "words", "places"),
    [
        ("int main() {}", "`main` has to call `rclcpp::init(argc, argv)`", []),
        ("rclcpp::init(1, a); rclcpp::spin(n);", "Something ends `rclcpp::spin`", ["src/talker.cpp:2"]),
        ("rclcpp::init(1, a); rclcpp::spin_some(n);", "`spin_some` does what waits", ["src/talker.cpp:2"]),
        ("rclcpp::init(1, a);", "Nothing keeps it running", []),
    ],
)
def test_ended_by_itself(code: str, words: str, places: list[str]) -> None:
    found = in_cpp(told(expect_running, cpp(end(1.0), code=code), "talker"))
    assert "`rclcpp::spin` should keep it running" in found.summary
    assert words in str(found.advice)
    assert where(found) == places


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
    deaf = in_cpp(told(expect_clean_interrupt, cpp(INTERRUPTED, code="while (true) {}"), "talker"))
    assert "rclcpp::ok()" in str(deaf.advice)
    assert where(deaf) == ["src/talker.cpp:2"]
    number = in_cpp(told(expect_clean_interrupt, cpp(INTERRUPTED, end(5.1, 7)), "talker"))
    assert "`return 0;`" in str(number.advice)
    crashed = in_cpp(told(expect_clean_interrupt, cpp(INTERRUPTED, end(5.1, None, 6)), "talker"))
    assert crashed.summary.startswith("Ctrl+C ends the program, but not in peace")


def test_a_loop_that_goes_on_after_ctrl_c() -> None:
    lines = [
        OutputLine(5.1, "talker", "terminate called after throwing an instance of 'rclcpp::RCLError'"),
        OutputLine(
            5.1, "talker", "  what():  the given context is not valid, either rcl_init() was not called"
        ),
    ]
    recording = cpp(INTERRUPTED, *lines, end(5.2, None, 6), code="while (true) { spin_some(node); }")
    found = in_cpp(told(expect_clean_interrupt, recording, "talker"))
    assert "`while (rclcpp::ok())`" in str(found.advice)
    assert where(found) == ["src/talker.cpp:2"]


def test_an_error_before_ctrl_c_is_no_matter_of_it() -> None:
    early = OutputLine(1.0, "talker", "terminate called after throwing an instance of 'x'")
    expect_clean_interrupt(cpp(early, INTERRUPTED, end(5.1)), "talker")


def seen(*nodes: str) -> GraphSeen:
    return GraphSeen(1.0, Graph(nodes))


def test_the_name_of_a_node() -> None:
    assert expect_node_called(cpp(seen("/a", "/cpp_print_forever_node")), "print_forever") == (
        "/cpp_print_forever_node"
    )
    code = 'Talker() : rclcpp::Node("my_node") {}'
    found = in_cpp(told(expect_node_called, cpp(seen("/my_node"), code=code), "print_forever"))
    assert found.summary == "The node is called `/my_node`; its name should hold `print_forever`."
    assert '`: rclcpp::Node("print_forever")`' in str(found.advice)
    assert where(found) == ["src/talker.cpp:2"]
    assert "There is no node whose name" in told(expect_node_called, cpp(), "print_forever").summary
    exact = in_cpp(told(expect_node, cpp(seen("/my_node")), "/talker"))
    assert '`: rclcpp::Node("talker")`' in str(exact.advice)


def test_a_type() -> None:
    endpoint = Endpoint("/chatter", "publisher", "/talker", "std_msgs/msg/Int32", "", Qos())
    recording = cpp(
        GraphSeen(1.0, Graph(("/talker",), (endpoint,))),
        code='pub_ = create_publisher<std_msgs::msg::Int32>("chatter", 10);',
    )
    found = in_cpp(told(expect_type, recording, "publisher", "/chatter", "std_msgs/msg/String"))
    assert "`create_publisher<std_msgs::msg::String>`" in str(found.advice)
    assert where(found) == ["src/talker.cpp:2"]


def logged(recording: Recording) -> Feedback:
    lines = tuple(line for line in recording.log if "Printed" in line.text)
    return in_cpp(told(expect_logged, recording, "talker", lines, EXAMPLE, "Print"))


@pytest.mark.parametrize(
    ("macro", "level", "name"),
    [("RCLCPP_WARN", 30, "WARN"), ("RCLCPP_ERROR_STREAM", 40, "ERROR"), ("RCLCPP_FATAL_ONCE", 50, "FATAL")],
)
def test_another_level(macro: str, level: int, name: str) -> None:
    found = logged(cpp(log(1.0, EXAMPLE, level), code=f"{macro}(get_logger(), x);"))
    assert found.summary == f"The message is logged at level {name}, not INFO."
    assert where(found) == ["src/talker.cpp:2"]
    assert "RCLCPP_INFO" in str(found.advice)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Print %d times.", "`%d` is for `RCLCPP_INFO`"),
        ("Print << count_ << times.", "within the quotes"),
        ("Print {} times.", "C++ fills in no braces"),
        ("Print 0 times", "full stop"),
    ],
)
def test_other_words(text: str, words: str) -> None:
    assert words in str(logged(cpp(log(1.0, text))).advice)


@pytest.mark.parametrize(
    ("code", "name"), [('std::cout << "Print";', "std::cout"), ('printf("Print");', "printf")]
)
def test_printed_and_not_logged(code: str, name: str) -> None:
    found = logged(cpp(OutputLine(1.0, "talker", EXAMPLE), code=code))
    assert f"comes from `{name}`" in found.summary
    assert where(found) == ["src/talker.cpp:2"]


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("RCLCPP_DEBUG(get_logger(), x);", "at level INFO"),
        ("", "No timer is made anywhere"),
        ("auto timer = create_wall_timer(500ms, tick);", "local variable"),
        (TIMER, "hand the node to `rclcpp::spin(...)`"),
        (f"{TIMER}rclcpp::spin(node);", "something calls the callback"),
    ],
)
def test_silent(code: str, words: str) -> None:
    assert words in str(logged(cpp(code=code)).advice)
