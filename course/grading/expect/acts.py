"""What a learner was to do while a mystery was played."""

from __future__ import annotations

from course.evidence.acts import Act
from course.evidence.recording import Recording
from course.feedback import Failure, Feedback

_SHOWN = 5


def expect_act(recording: Recording, name: str, summary: str, *, near_miss: str | None = None) -> Act:
    """The act of that name, which the mystery's nodes recorded.

    summary: what is said when there is none. near_miss: the name of acts that came close; what they
    held is shown.
    """
    found = [act for act in recording.acts if act.name == name]
    if found:
        return found[0]
    close = [act.detail for act in recording.acts if act.name == near_miss]
    raise Failure(
        Feedback(
            summary=summary,
            seen=", ".join(f"`{detail}`" for detail in close[-_SHOWN:]) or None,
            advice=f"Start the mystery in one terminal, `ros2course play {recording.exercise}`, and do "
            "this in another one while it runs. It remembers what you did.",
        )
    )
