"""Why CMake cannot configure a project of the learner's that is no ROS package, as feedback."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from course.build.digest.cmake import CMakeError, cmake_errors
from course.evidence.recording import Recording
from course.feedback import Feedback, Location

_LONGEST = 90
_WHERE_FROM = "Is its name spelt right, and does this line name the folder that it was installed to?"
_LINKED = "`find_package` has to stand above this line, and the name in it must be the package's own."
_CAUSES = (
    (r'package configuration file provided by "(?P<name>\S+?)"', "CMake does not find the package `{name}`.",
     _WHERE_FROM),
    (r"Could not find (?P<name>\S+) using the following (?:names|files)", "CMake does not find `{name}`.",
     _WHERE_FROM),
    (r"NOTFOUND\..*?: (?P<name>\w+)", "CMake does not find what `{name}` stands for.", _WHERE_FROM),
    (r'links to(?: target)?:? "?(?P<name>[\w:]+)"?.*not found', "There is no `{name}` to link.", _LINKED),
    (r"Cannot find source file: (?P<name>\S+)", "There is no source file `{name}`.",
     "Make the file, or correct its name."),
    (r'Unknown CMake command "(?P<name>\w+)"', "`{name}` is no CMake command.",
     "Is it spelt right? Compare it with the lesson, letter by letter."),
    (r"Parse error", "CMake cannot read the file.", "Every `(` needs its `)`, every quote its second one."),
    (r'add_executable.*?cannot create target "(?P<name>\w+)"', "The target `{name}` is made twice.",
     "Take one of the two lines out."),
)  # fmt: skip
_OTHERWISE = "Read what CMake says of this line, and compare it with the lesson."


@dataclass(frozen=True)
class _Printed:
    """CMake names files from the project's folder on."""

    lines: Sequence[str]
    folder: str
    names: frozenset[str]

    def own_file(self, shown: str) -> str | None:
        name = shown.removeprefix("~/").removeprefix(f"{self.folder}/")
        return name if f"{self.folder}/{name}" in self.names else None


def not_configured(recording: Recording, process: str, folder: str) -> Feedback:
    """The feedback on CMake's first error; `process` configured the project in `folder` of the home."""
    lines = recording.process(process).text
    errors = cmake_errors(_Printed(lines, folder, frozenset(recording.sources.names)))
    if not errors:
        return Feedback(
            summary="CMake cannot configure the project.",
            where=(Location(f"{folder}/CMakeLists.txt"),),
            advice="Configure it yourself, and read the first error.",
            details=lines[-4:],
        )
    error = errors[0]
    summary, advice = _words(error)
    return Feedback(
        summary=summary,
        where=(Location(f"{folder}/{error.file}", error.line),),
        advice=advice,
        details=error.printed[:4],
    )


def _words(error: CMakeError) -> tuple[str, str]:
    for pattern, summary, advice in _CAUSES:
        if found := re.search(pattern, error.text):
            return summary.format(**found.groupdict()), advice
    sentence = re.split(r"(?<=[.!?:])\s", error.text, maxsplit=1)[0].rstrip(".:")[:_LONGEST]
    return f"CMake cannot configure the project: {sentence}.", _OTHERWISE
