"""What expectations say of nodes in C++."""

from __future__ import annotations

import re
from dataclasses import replace

from course.evidence.process_view import ProcessView
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.feedback import Feedback, Location
from course.grading.explain.cpp_code import cpp_calls, places_of
from course.grading.explain.cpp_crashes import cpp_crash
from course.grading.explain.cpp_timers import SPINS, cpp_timer_cause
from course.grading.explain.language import Language
from course.grading.explain.timers import Cause

# What prints, as learners know it, and the pattern that finds it.
_PRINTING = (("std::cout", r"\b(?:cout|cerr|clog)\s*<<"), ("printf", r"\b(?:f?printf|f?puts)\s*\("))
_DEAF = (
    "`rclcpp::spin` ends at Ctrl+C. A loop of your own has to ask for it: `while (rclcpp::ok())`. "
    "A handler of your own calls `rclcpp::shutdown()`."
)
_DEAF_PLACES = r"\bwhile\s*\(\s*(?:true|1)\s*\)|\bfor\s*\(\s*;\s*;\s*\)|\bsig(?:nal|action)\s*\("
# What rclcpp throws when it is asked for more after Ctrl+C.
_WENT_ON = re.compile(r"context is not valid|rcl_shutdown\(\) was called|context is already shut")
_IN_THE_TEXT = (
    ("<<", "`<<` stands within the quotes: end the text before it, and begin it once more behind."),
    ("%", "`RCLCPP_INFO_STREAM` puts texts together with `<<`. `%d` is for `RCLCPP_INFO`, and the number "
          "comes behind the text."),
    ("{", "C++ fills in no braces. `RCLCPP_INFO_STREAM(get_logger(), ...)` puts texts and numbers together "
          "with `<<`."),
)  # fmt: skip


class Cpp(Language):
    spin = "rclcpp::spin"
    log_info = "RCLCPP_INFO_STREAM(get_logger(), ...)"
    at_the_end = "What `main` returns is the exit code: `return 0;` says that all went well."
    comes_to_an_end = "Let `main` come to its end: look for a loop that never ends, or for `std::cin`."
    after_ctrl_c = "What `main` returns is the exit code. Let it come to `return 0;` after `rclcpp::spin`."

    def places(self, sources: Sources, name: str) -> tuple[Location, ...]:
        return tuple(call.where for call in cpp_calls(sources, name))

    def stopped(self, recording: Recording, view: ProcessView) -> Feedback | None:
        return cpp_crash(view.exited, view.text, recording.sources, "The program stopped")

    def unhandled(self, recording: Recording, view: ProcessView, asked: float) -> Feedback | None:
        lines = tuple(line.text for line in view.lines if line.t >= asked)
        found = cpp_crash(view.exited, lines, recording.sources, "Ctrl+C ends the program, but not in peace")
        if found and _WENT_ON.search(" ".join(lines)):
            return replace(found, advice=_DEAF, where=places_of(recording.sources, _DEAF_PLACES)[:2])
        return found

    def to_keep_running(self, sources: Sources) -> Cause:
        where = tuple(place for name in SPINS for place in self.places(sources, name))[:2]
        return Cause(self._to_keep_running(sources), where)

    def _to_keep_running(self, sources: Sources) -> str:
        if not self.places(sources, "init"):
            return "`main` has to call `rclcpp::init(argc, argv)`, make the node, and `rclcpp::spin` it."
        if self.places(sources, "spin"):
            return "Something ends `rclcpp::spin`: an `exit` somewhere, or `rclcpp::shutdown()`?"
        if self.places(sources, "spin_some"):
            return "`spin_some` does what waits and returns. `rclcpp::spin(node)` goes on until Ctrl+C."
        return "Nothing keeps it running: call `rclcpp::spin(...)` in `main`, with the node, after `init`."

    def deaf(self, sources: Sources) -> Cause:
        return Cause(_DEAF, places_of(sources, _DEAF_PLACES)[:2])

    def to_name_a_node(self, name: str) -> str:
        return f'Its class hands the name to `rclcpp::Node`, before the braces: `: rclcpp::Node("{name}")`.'

    def to_use_a_type(self, maker: str, package: str, name: str) -> str:
        return f"Include its header, and name it in `{maker}<{package}::msg::{name}>`."

    def logged_at(self, sources: Sources, level: str) -> tuple[Location, ...]:
        return places_of(sources, rf"\bRCLCPP_{level}\w*\s*\(")

    def printed(self, sources: Sources) -> tuple[str, tuple[Location, ...]]:
        found = ((name, places_of(sources, pattern)) for name, pattern in _PRINTING)
        return next(((name, places) for name, places in found if places), (_PRINTING[0][0], ()))

    def other_words(self, text: str) -> str | None:
        return next((advice for sign, advice in _IN_THE_TEXT if sign in text), None)

    def silent(self, sources: Sources) -> Cause | None:
        cause = cpp_timer_cause(sources)
        if cause or any(self.places(sources, name) for name in SPINS):
            return cause
        return Cause(
            "Nothing calls what the timer is to call: `main` has to hand the node to `rclcpp::spin(...)`, "
            "which waits and calls. A loop of your own does not."
        )
