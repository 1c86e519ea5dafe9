"""What an expectation says of a program, in the words of the language that the program is written in.

What is expected of a node is the same in all languages. What is likely to be wrong with it, where that stands
and what to write instead, each language knows for itself: `in_python`, `in_cpp`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar

from course.evidence.process_view import ProcessView
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.feedback import Feedback, Location
from course.grading.explain.timers import Cause


class Language(ABC):
    """One language. All texts go to a learner; `Cause.text` is an advice."""

    spin: ClassVar[str]  # what keeps a node running
    log_info: ClassVar[str]  # how a line is logged
    at_the_end: ClassVar[str]  # how a program comes to exit code 0
    comes_to_an_end: ClassVar[str]  # how one that should end by itself does so
    after_ctrl_c: ClassVar[str]  # how one comes to exit code 0 after Ctrl+C

    @abstractmethod
    def places(self, sources: Sources, name: str) -> tuple[Location, ...]:
        """Where a function or method of this name is called."""

    @abstractmethod
    def stopped(self, recording: Recording, view: ProcessView) -> Feedback | None:
        """The error that ended the program, if one did; it ended by itself."""

    @abstractmethod
    def unhandled(self, recording: Recording, view: ProcessView, asked: float) -> Feedback | None:
        """The error that Ctrl+C, at the time `asked`, led to. Raises Spoilt for one of ROS's own."""

    @abstractmethod
    def to_keep_running(self, sources: Sources) -> Cause:
        """What is missing where a node's program ended by itself, without an error."""

    @abstractmethod
    def deaf(self, sources: Sources) -> Cause:
        """Why Ctrl+C does not end it."""

    @abstractmethod
    def to_name_a_node(self, name: str) -> str:
        """An advice: how a node gets its name (no slash)."""

    @abstractmethod
    def to_use_a_type(self, maker: str, package: str, name: str) -> str:
        """An advice: how `maker` (`create_publisher`) is given the message type package/msg/name."""

    @abstractmethod
    def logged_at(self, sources: Sources, level: str) -> tuple[Location, ...]:
        """Where something is logged at this level (`WARN`)."""

    @abstractmethod
    def printed(self, sources: Sources) -> tuple[str, tuple[Location, ...]]:
        """What prints to the terminal alone, as it is called, and where it stands."""

    @abstractmethod
    def other_words(self, text: str) -> str | None:
        """An advice on a logged line of other words than asked for, if they tell what went wrong."""

    @abstractmethod
    def silent(self, sources: Sources) -> Cause | None:
        """Why a node logs nothing although it runs, if that can be told."""
