"""Grader of chapter 9: a build newer than its sources, known to a terminal that sourced it."""

from __future__ import annotations

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    NotApplicable,
    OurFault,
    Recording,
    listed,
)

WS = "ros2_tutorial_workspace"
PACKAGE = "python_package_with_a_node"
PROGRAM = "sample_python_node"
SOURCE = f"{WS}/src/{PACKAGE}"
RESULT = f"{WS}/build/{PACKAGE}/colcon_build.rc"
RUN = f"ros2 run {PACKAGE} {PROGRAM}"
BUILD = f"`cd ~/{WS}`, then `colcon build`, then `source install/setup.bash`."
ANEW = f"`cd ~/{WS}`, then `rm -r build install log`, then `colcon build`."
# Times in a file system may be no more exact than this.
SAME_TIME = 0.01

source = Grader("09-source", builds=None, ros=False)


@source.scenario
def run_it_before_and_after(arena: Arena) -> None:
    """Two terminals with ROS 2: the second one sources the workspace as well."""
    before = arena.start("bash", "--norc", "-ic", RUN, name="before")
    after = arena.start("bash", "--norc", "-ic", f". ~/{WS}/install/setup.bash && {RUN}", name="after")
    for program in (before, after):
        if not program.wait(15):
            arena.interrupt(program)


@source.check("built", f"`{PACKAGE}` is built in `~/{WS}`")
def built(recording: Recording) -> None:
    if not recording.local:
        raise NotApplicable(
            "A submission does not include a build, so only your own computer can check this."
        )
    home = recording.home
    isolated, merged = f"{WS}/install/{PACKAGE}", f"{WS}/install/share/{PACKAGE}"
    if home.file(f"{WS}/install/setup.bash").is_file and any(
        home.file(folder).kind == "folder" for folder in (isolated, merged)
    ):
        return
    raise Failure(not_built(recording))


def not_built(recording: Recording) -> Feedback:
    home = recording.home
    if home.file(f"{WS}/src/install").exists:
        summary = "colcon was run in `src`: it left an `install` folder there."
        advice = f"`cd ~/{WS}/src`, then `rm -r build install log`; then {BUILD}"
    elif not home.file(SOURCE).exists:
        summary = f"There is no package `{PACKAGE}` in `~/{WS}/src`."
        advice = "You create it in chapter 8: `ros2course next 08-template-node`."
    elif not home.file(f"{WS}/install/setup.bash").is_file:
        summary = f"`~/{WS}` is not built: there is no `install/setup.bash`."
        advice = BUILD
    else:
        summary = f"`{PACKAGE}` is not among the packages that were built."
        advice = f"{BUILD} Read its last lines: they name any package that failed."
    names = home.inside(f"{WS}/install")
    inside = [name for name in names if home.file(f"{WS}/install/{name}").kind == "folder"]
    return Feedback(
        summary=summary,
        expected=f"~/{WS}/install/{PACKAGE}",
        seen=listed(inside, "no packages"),
        advice=advice,
    )


@source.check("runs", f"`ros2 run` finds and runs `{PROGRAM}` after sourcing", points=2, needs="built")
def runs(recording: Recording) -> None:
    before, after = recording.process("before"), recording.process("after")
    if before.exited is None or not any(f"'{PACKAGE}' not found" in line for line in before.text):
        raise OurFault(f"without the workspace, `{RUN}` does not report that the package is missing")
    if after.exited is not None and after.exited.code == 0 and any(line.strip() for line in after.text):
        return
    text = [line.strip() for line in after.text if line.strip()]
    lost = next((line for line in text if "not found" in line or "No executable" in line), None)
    raise Failure(
        Feedback(
            summary=f"After sourcing, `ros2 run` still says: {lost}."
            if lost
            else f"`{PROGRAM}` never ends."
            if after.exited is None or after.exited.signal
            else f"`{PROGRAM}` starts, but ends with an error.",
            expected=f"Hi from {PACKAGE}.",
            seen=text[-1][:120] if text else "nothing",
            where=(Location(f"{SOURCE}/setup.py"),),
            advice=f"Check that `{PROGRAM}` is in `console_scripts` of setup.py, then build again: {ANEW}",
            details=tuple(text[-6:]),
        )
    )


@source.check("fresh", "the build is newer than your last change", needs="built")
def fresh(recording: Recording) -> None:
    result = recording.home.file(RESULT)
    if result.is_file and (result.text or "0").strip() != "0":
        raise Failure(
            Feedback(
                summary=(
                    "The last build of the package failed. The installed files are from an earlier build."
                ),
                where=(Location(SOURCE),),
                advice=f"`cd ~/{WS}`, then `colcon build`, and read its output.",
            )
        )
    since = changed_since(recording, build_time(recording))
    if since:
        names = [path.removeprefix(f"{SOURCE}/") for path in since]
        raise Failure(
            Feedback(
                summary=f"You changed {listed(names[:3])} after the last build.",
                expected="a build after the last change",
                where=tuple(Location(path) for path in since[:3]),
                advice=f"The old program still runs. {BUILD}",
            )
        )


def build_time(recording: Recording) -> float:
    """When colcon last built the package; if only `install` is left, when that was written."""
    entries = recording.home.entries
    if RESULT in entries:
        return entries[RESULT].modified
    installed = (entry for path, entry in entries.items() if path.startswith(f"{WS}/install/"))
    return max((entry.modified for entry in installed if entry.kind == "file"), default=0.0)


def changed_since(recording: Recording, time: float) -> list[str]:
    """The paths of files that changed after `time`, the latest first.

    Tests need no build, and neither do files that the build only links to.
    """
    entries = recording.home.entries
    linked = entries.get(f"{WS}/build/{PACKAGE}/{PACKAGE}")
    spared = [f"{SOURCE}/test/", f"{SOURCE}/{PACKAGE}/"] if linked and linked.target else [f"{SOURCE}/test/"]
    own = (entry for path, entry in entries.items() if path.startswith(f"{SOURCE}/") and entry.kind == "file")
    late = [
        entry
        for entry in own
        if entry.modified > time + SAME_TIME
        and not entry.path.startswith(tuple(spared))
        and not entry.path.endswith(".pyc")
    ]
    return [entry.path for entry in sorted(late, key=lambda entry: -entry.modified)]
