"""A recording of several programs, seen as if only one of them had run."""

from __future__ import annotations

from dataclasses import replace

from course.evidence.events import Event, MessageSeen
from course.evidence.recording import ROSOUT, Recording
from course.evidence.sources import Sources
from course.grading.explain.setup_py import entry_points


def about(recording: Recording, package: str, executable: str, node: str) -> Recording:
    """What is told of this executable, whose node is called `node` (`night_watch`, no slash).

    The others' lines on /rosout are left out, and the modules that only their entry points name. So an
    `expect_*` helper that looks for a cause does not look for it in another program.
    """
    others = _logged_by_others(recording, node)
    events = tuple(event for event in recording.events if event not in others)
    return replace(recording, events=events, sources=_sources_of(recording, package, executable))


def _logged_by_others(recording: Recording, node: str) -> set[Event]:
    logged = (event for event in recording.events if isinstance(event, MessageSeen) and event.topic == ROSOUT)
    return {event for event, line in zip(logged, recording.log, strict=True) if line.node != node}


def _sources_of(recording: Recording, package: str, executable: str) -> Sources:
    built = recording.packages.get(package)
    if built is None:
        return recording.sources
    entries = entry_points(recording.sources, built.source)
    files = {entry.name: _file(built.source, entry.target) for entry in entries}
    others = set(files.values()) - {files.get(executable)}
    kept = {name: text for name, text in recording.sources.files.items() if name not in others}
    return Sources(kept, recording.sources.others)


def _file(folder: str, target: str) -> str:
    """The file of `package.module:function`."""
    module = target.partition(":")[0].strip()
    return f"{folder}/{module.replace('.', '/')}.py"
