"""What is expected of a package.xml."""

from __future__ import annotations

from course.evidence.recording import Recording
from course.feedback import Failure, Feedback, Location
from course.grading.explain.names import nearest
from course.grading.explain.package_xml import RUN_TAGS, Manifest, manifest


def expect_manifest(recording: Recording, package: str) -> Manifest:
    """The package's manifest. Raises Failure when there is none that can be read."""
    built = recording.packages.get(package)
    found = manifest(recording.sources, built.source) if built else None
    if found is None:
        raise Failure(Feedback(summary=f"The package `{package}` has no package.xml that can be read."))
    return found


def expect_dependency(recording: Recording, package: str, *names: str) -> None:
    """package.xml declares each of these packages as needed to run."""
    found = expect_manifest(recording, package)
    missing = [name for name in names if not found.depends(name, *RUN_TAGS)]
    if not missing:
        return
    name = missing[0]
    close = nearest(name, set(found.values(*RUN_TAGS)) - set(names))
    raise Failure(
        Feedback(
            summary=f"package.xml does not declare the dependency `{name}`"
            + (f"; it names `{close}`." if close else ", which the code needs."),
            expected=f"<depend>{name}</depend>",
            seen=close,
            where=(_line_with(found, "<depend>") or found.where,),
            advice=f"Add `<depend>{name}</depend>` to package.xml.",
        )
    )


def _line_with(found: Manifest, text: str) -> Location | None:
    for number, line in enumerate(found.text.splitlines(), start=1):
        if text in line:
            return Location(found.where.file, number)
    return None
