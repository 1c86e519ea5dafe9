"""Expectations about a package.xml."""

from __future__ import annotations

from course.evidence.recording import Recording
from course.explain.package_xml import RUN_TAGS, Manifest, manifest
from course.model.feedback import Failure, Feedback
from course.spelling import listed, nearest

_LUCK = " Without it, colcon does not know which package to build first, so a build succeeds only by luck."


def expect_manifest(recording: Recording, package: str) -> Manifest:
    """Return the package's manifest. Raises Failure if it is missing or cannot be read."""
    built = recording.packages.get(package)
    found = manifest(recording.sources, built.source) if built else None
    if found is None:
        raise Failure(
            Feedback(
                summary=f"The package `{package}` has no readable package.xml.",
                advice="Compare it with the package.xml of a new package from `ros2 pkg create`.",
            )
        )
    return found


def expect_build_type(recording: Recording, package: str, wanted: str) -> None:
    """Check the build type in package.xml, as `ros2 pkg create` writes it."""
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
    """Check that package.xml declares each of these packages as needed at run time."""
    found = expect_manifest(recording, package)
    missing = [name for name in names if not found.depends(name, *RUN_TAGS)]
    if missing:
        own = recording.packages.get(missing[0]) is not None
        raise Failure(_undeclared(found, missing, names, own=own))


# What beginners declare by mistake: the other language's package.
_LANGUAGES = {"rclpy": ("rclcpp", "C++"), "rclcpp": ("rclpy", "Python")}


def _undeclared(found: Manifest, missing: list[str], wanted: tuple[str, ...], *, own: bool) -> Feedback:
    """Feedback on the first missing package, or on all if several are missing.

    own: whether the first one is the learner's own package, so that the build order depends on it.
    """
    name = missing[0]
    line = f"<depend>{name}</depend>"
    other, language = _LANGUAGES.get(name, ("", ""))
    if found.depends(other, *RUN_TAGS):
        return Feedback(
            summary=f"package.xml does not declare `{name}`. It declares `{other}`, which is for {language}.",
            expected=line,
            seen=f"<depend>{other}</depend>",
            where=(found.place_of(other) or found.where,),
            advice=f"Change `{other}` to `{name}`.",
        )
    if len(missing) > 1:
        return Feedback(
            summary=f"package.xml does not declare the dependencies {listed(missing)}.",
            expected=f"a <depend> for each of {len(wanted)} packages",
            seen=f"{len(missing)} are missing",
            where=(found.place_of("<depend>") or found.where,),
            advice=f"Add {', '.join(f'`<depend>{one}</depend>`' for one in missing)} to package.xml.",
        )
    other_tags = [tag for tag, text in found.tags if text == name]
    if other_tags:
        return Feedback(
            summary=f"package.xml declares `{name}` as `{other_tags[0]}` only, but the program "
            "needs it when it runs.",
            expected=line,
            seen=f"<{other_tags[0]}>{name}</{other_tags[0]}>",
            where=(found.place_of(name) or found.where,),
            advice=f"Write `{line}`, which covers building and running.",
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
