"""Failures of functions in C++ that return a wrong value."""

from __future__ import annotations

from course.api import Failure, Feedback, Recording, replace, without_effect


def wrong(recording: Recording, feedback: Feedback) -> Failure:
    """This failure; its advice is a statement without effect instead, if the C++ files have one."""
    cause = without_effect(recording.sources)
    return Failure(replace(feedback, where=cause.where, advice=cause.text) if cause else feedback)
