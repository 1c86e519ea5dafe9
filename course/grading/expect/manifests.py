"""What is expected of a package.xml."""

from __future__ import annotations

from course.evidence.recording import Recording
from course.feedback import Failure, Feedback
from course.grading.explain.names import nearest
from course.grading.explain.package_xml import RUN_TAGS, Manifest, manifest

_LUCK = (
    " Without it, colcon does not know which of the two packages must be built first: "
    "if it works today, that is luck."
)


def expect_manifest(recording: Recording, package: str) -> Manifest:
    """The package's manifest. Raises Failure when there is none that can be read."""
    built = recording.packages.get(package)
    found = manifest(recording.sources, built.source) if built else None
    if found is None:
        raise Failure(
            Feedback(
                summary=f"The package `{package}` has no package.xml that can be read.",
                advice="Compare it with the package.xml of a new package from `ros2 pkg create`.",
            )
        )
    return found


def expect_build_type(recording: Recording, package: str, wanted: str) -> None:
    """package.xml names this build type, and so `ros2 pkg create` was given it."""
    found = expect_manifest(recording, package)
    if found.build_type == wanted:
        return
    other = found.build_type
    raise Failure(
        Feedback(
            summary=f"The package has {f'the build type `{other}`' if other else 'no build type'}, "
            f"not `{wanted}`.",
            expected=f"<build_type>{wanted}</build_type>",
            seen=f"<build_type>{other}</build_type>" if other else "no build type",
            where=(found.place_of(other or "<export>") or found.where,),
            advice=f"Remove the folder, and create the package again with `--build-type {wanted}`.",
        )
    )


def expect_dependency(recording: Recording, package: str, *names: str) -> None:
    """package.xml declares each of these packages as needed to run."""
    found = expect_manifest(recording, package)
    missing = [name for name in names if not found.depends(name, *RUN_TAGS)]
    if missing:
        own = recording.packages.get(missing[0]) is not None
        raise Failure(_undeclared(found, missing[0], names, own=own))


def expect_tag(
    recording: Recording, package: str, tags: tuple[str, ...], value: str, *, purpose: str
) -> None:
    """package.xml has an element with one of these tags and this text."""
    found = expect_manifest(recording, package)
    if found.depends(value, *tags):
        return
    elsewhere = [tag for tag, text in found.tags if text == value]
    written = f"<{tags[0]}>{value}</{tags[0]}>"
    raise Failure(
        Feedback(
            summary=f"package.xml does not hold `{written}`: {purpose}.",
            expected=written,
            seen=f"<{elsewhere[0]}>{value}</{elsewhere[0]}>" if elsewhere else None,
            where=(found.place_of(value) or found.where,),
            advice=f"Add the line `{written}` to package.xml.",
        )
    )


def _undeclared(found: Manifest, name: str, wanted: tuple[str, ...], *, own: bool) -> Feedback:
    """own: the missing package is one of the learner's own, so the order of the builds depends on it."""
    line = f"<depend>{name}</depend>"
    other_tags = [tag for tag, text in found.tags if text == name]
    if other_tags:
        return Feedback(
            summary=f"package.xml declares `{name}` as `{other_tags[0]}` only, but the program "
            "needs it when it runs.",
            expected=line,
            seen=f"<{other_tags[0]}>{name}</{other_tags[0]}>",
            where=(found.place_of(name) or found.where,),
            advice=f"Write `{line}`, which stands for building and running.",
        )
    close = nearest(name, set(found.values(*RUN_TAGS)) - set(wanted))
    return Feedback(
        summary=f"package.xml does not declare the dependency `{name}`"
        + (f"; it names `{close}`." if close else ", which the program needs."),
        expected=line,
        seen=f"<depend>{close}</depend>" if close else None,
        where=(found.place_of(close or "<depend>") or found.where,),
        advice=f"Add the line `{line}` to package.xml." + (_LUCK if own else ""),
    )
