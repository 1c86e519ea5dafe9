"""Why a timer in C++ does not call, or not when it should."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.explain.cpp_timers import cpp_timer_cause

FILE = "src/talk/src/talker.cpp"
RIGHT = "timer_ = create_wall_timer(500ms, [this]() { tick(); });"


def cause(text: str) -> str | None:
    found = cpp_timer_cause(Sources({FILE: text}))
    if found is None:
        return None
    return f"{[place.line for place in found.where]} {found.text}"


def made(statement: str) -> str:
    return f'Talker::Talker()\n: rclcpp::Node("talker")\n{{\n  {statement}\n}}\n'


@pytest.mark.parametrize(
    "statement",
    [
        RIGHT,
        "this->timer_ = this->create_wall_timer(0.5s, std::bind(&Talker::tick, this));",
        "timer_ = rclcpp::create_timer(this, get_clock(), 500ms, tick);",
        "timers_.push_back(create_wall_timer(500ms, tick));",
        "timers_[0] = create_wall_timer(std::chrono::milliseconds(500), tick);",
        "return create_wall_timer(500ms, tick);",
        "static auto timer = create_wall_timer(500ms, tick);",
        "auto timer = node->create_wall_timer(500ms, tick); rclcpp::spin(node);",
        "create_wall_timer(9s, tick), keep();  rclcpp::spin(node);",
    ],
)
def test_nothing_to_say(statement: str) -> None:
    assert cause(made(statement)) is None


def test_a_member_that_is_made_before_the_braces() -> None:
    assert cause("explicit Talker() : Node(name), timer_(create_wall_timer(500ms, tick)) {}") is None
    assert cause("public:\n  Talker() : timer_{create_wall_timer(500ms, tick)} {}") is None


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        ("auto timer = create_wall_timer(500ms, tick);", "local variable"),
        ("rclcpp::TimerBase::SharedPtr timer_ = this->create_wall_timer(500ms, tick);", "local variable"),
        ("const auto & timer{create_wall_timer(500ms, tick)};", "local variable"),
        ("std::shared_ptr<rclcpp::TimerBase> t(create_wall_timer(500ms, tick));", "local variable"),
        ("create_wall_timer(500ms, tick);", "Nothing stores the timer"),
        ("this->create_wall_timer(500ms, tick);", "Nothing stores the timer"),
        ("rclcpp::create_timer(this, get_clock(), 500ms, tick);", "Nothing stores the timer"),
        ("timer_ = create_wall_timer(500s, tick);", "500 s before each call: `500s`"),
        ("timer_ = create_wall_timer(30min, tick);", "1800 s before each call"),
        ("timer_ = create_wall_timer(std::chrono::seconds(500), tick);", "500 s before each call"),
        ("timer_ = create_wall_timer(20'000ms, tick);", "20 s before each call"),
        ("rclcpp::spin(node); timer_ = create_wall_timer(500ms, tick);", "Create the timer before it"),
    ],
)
def test_what_is_wrong(statement: str, words: str) -> None:
    found = cause(made(statement)) or ""
    assert words in found
    assert found.startswith("[4]")


def test_no_timer_at_all() -> None:
    assert "The code does not create a timer" in (cause("int main() {}") or "")


def test_a_plain_node_in_place_of_the_class() -> None:
    text = "class Talker : public rclcpp::Node {};\n" + made(RIGHT)
    assert cause(text) is None
    found = cause(f'{text}int main() {{ spin(std::make_shared<rclcpp::Node>("a")); }}') or ""
    assert found.startswith("[7] The program creates a plain `rclcpp::Node`")


@pytest.mark.parametrize(("hertz", "is_told"), [("0.5", True), ("2.0", False)])
def test_a_rate_is_not_a_period(hertz: str, is_told: bool) -> None:
    found = cause(f"int main()\n{{\n  rclcpp::Rate rate({hertz});\n}}\n")
    assert found == (
        "[3] A rate is the number of calls per second, not the time between them: twice per second is 2.0."
        if is_told
        else None
    )
