"""A recording of several programs, seen as if only one of them had run."""

from __future__ import annotations

from dataclasses import replace

from course.evidence.events import Event, MessageSeen
from course.evidence.recording import ROSOUT, Recording
from course.evidence.sources import Sources
from course.grading.explain.cmake_lists import LISTS, commands
from course.grading.explain.cpp_code import cpp_files
from course.grading.explain.setup_py import entry_points


def about(recording: Recording, package: str, executable: str, node: str) -> Recording:
    """What is told of this executable, whose node is called `node` (`night_watch`, no slash).

    The others' lines on /rosout are left out, and the files that only they are made of: modules that their
    entry points name, sources of another `add_executable`, and all C++ where it is a script. So an `expect_*`
    helper does not look for a cause in another program, and speaks of this one in its own language.
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
    folder = built.source
    in_cmake = f"{folder}/{LISTS}" in recording.sources.files
    others = (_others_in_cmake if in_cmake else _others_in_setup_py)(recording.sources, folder, executable)
    kept = {name: text for name, text in recording.sources.files.items() if name not in others}
    return Sources(kept, recording.sources.others)


def _others_in_setup_py(sources: Sources, folder: str, executable: str) -> set[str]:
    files = {entry.name: _file(folder, entry.target) for entry in entry_points(sources, folder)}
    return set(files.values()) - {files.get(executable, "")}


def _others_in_cmake(sources: Sources, folder: str, executable: str) -> set[str]:
    """A program that CMake does not make is a script."""
    made = {
        command.words[0]: {f"{folder}/{word}" for word in command.words[1:]}
        for command in commands(sources, folder)
        if command.name == "add_executable" and command.words
    }
    if executable not in made:
        return set(cpp_files(sources))
    return {file for files in made.values() for file in files} - made[executable]


def _file(folder: str, target: str) -> str:
    """The file of `package.module:function`."""
    module = target.partition(":")[0].strip()
    return f"{folder}/{module.replace('.', '/')}.py"
