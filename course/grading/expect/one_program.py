"""Views of a recording of several programs, as if only one of them had run."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from course.evidence.recording import ROSOUT, Recording
from course.evidence.sources import Sources
from course.explain.cmake import LISTS, commands
from course.explain.cpp_code import cpp_files
from course.explain.python_code import parsed
from course.explain.setup_py import entry_points
from course.model import replace
from course.model.events import Event, MessageSeen


def about(recording: Recording, package: str, executable: str, node: str) -> Recording:
    """Return the recording reduced to this executable, whose node is called `node` (`scanner`, no slash).

    It leaves out other nodes' lines on /rosout and files that belong only to other programs: modules named
    by their entry points, sources of another `add_executable`, and all C++ if this one is a script. So an
    `expect_*` helper looks for causes only in this program, and gives advice in its language.
    """
    others = _logged_by_others(recording, node)
    events = tuple(event for event in recording.events if event not in others)
    return replace(recording, events=events, sources=_sources_of(recording, package, executable))


def of_program(recording: Recording, process: str) -> Recording:
    """Return the recording without the modules that this program does not import, as far as that is known.

    A crash may be about a file that could not be imported, so to explain one, use the whole recording.
    """
    started = recording.process(process).started
    for package in recording.packages.built:
        for executable in package.executables:
            if started and f"{package.prefix}/lib/{package.name}/{executable}" in started.command:
                sources = _sources_of(recording, package.name, executable)
                return replace(recording, sources=sources)
    return recording


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
    files = {entry.name: entry.file_in(folder) for entry in entry_points(sources, folder)}
    reached = _imported(sources, files.get(executable, ""))
    others = set(files.values()) - {files.get(executable, "")}
    return others | (_modules(sources) - reached) if reached else others


def _modules(sources: Sources) -> set[str]:
    """The importable files of packages: those next to an __init__.py."""
    folders = {name.rpartition("/")[0] for name in sources.files if name.endswith("/__init__.py")}
    return {name for name in sources.files if name.endswith(".py") and name.rpartition("/")[0] in folders}


def _imported(sources: Sources, file: str) -> set[str]:
    """The module and all of the learner's modules that it imports; empty if that is unknown."""
    modules, found = _modules(sources), [file]
    if file not in modules:
        return set()
    for one in found:  # `found` grows during the loop
        tree = parsed(sources.files[one])
        if tree is None or "importlib" in sources.files[one] or "__import__" in sources.files[one]:
            return set()
        for name in _names_imported(tree, one):
            ends = (f"/{name}.py", f"/{name}/__init__.py")
            found += [other for other in modules if other.endswith(ends) and other not in found]
    return set(found)


def _names_imported(tree: ast.Module, file: str) -> Iterator[str]:
    """For `import talk.words`, `from talk import words`, or `from . import words` in `talk`: `talk/words`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name.replace(".", "/") for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            above = "/".join(file.split("/")[: -node.level]).rpartition("/src/")[2] if node.level else ""
            base = "/".join(part for part in (above, (node.module or "").replace(".", "/")) if part)
            yield base
            yield from (f"{base}/{alias.name}" for alias in node.names)


def _others_in_cmake(sources: Sources, folder: str, executable: str) -> set[str]:
    """The sources of CMake's other programs. A program that CMake does not build is a script."""
    made = {
        command.words[0]: {f"{folder}/{word}" for word in command.words[1:]}
        for command in commands(sources, folder)
        if command.name == "add_executable" and command.words
    }
    if executable not in made:
        return set(cpp_files(sources))
    return {file for files in made.values() for file in files} - made[executable]
