"""All pictures of one recording."""

from __future__ import annotations

from course.evidence.recording import Recording
from course.report.pictures.lanes import duration_of
from course.report.pictures.signal_svg import plot
from course.report.pictures.signals import signals_of
from course.report.pictures.svg import Clean
from course.report.pictures.timeline_svg import timeline


def pictures(recording: Recording, *, key: str, clean: Clean) -> tuple[str, ...]:
    """The time line and at most two signals, each an `<svg>` element.

    None of a mystery: the names that are to be found out stand in its recording. key: unique on the page,
    a word of letters and digits. clean: makes a text of a submission fit to be shown.
    """
    if recording.seed is not None or recording.acts:
        return ()
    line = timeline(recording, key=f"{key}l", clean=clean)
    if line is None:
        return ()
    duration = duration_of(recording)
    plots = (
        plot(signal, duration, key=f"{key}s{place}", clean=clean)
        for place, signal in enumerate(signals_of(recording))
    )
    return (line, *plots)
