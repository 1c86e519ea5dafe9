"""Grader of chapter 5: a workspace that colcon built and that every new terminal knows."""

from __future__ import annotations

import re

from course.api import (
    BASHRC,
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    NotApplicable,
    Recording,
    complaints,
    expect_ran,
    expect_shell,
    listed,
)
from lib.sourcing import TRACE, Sourced, environments, sourced, workspaces

WS = "ros2_tutorial_workspace"
MADE = ("build", "install", "log")
LINE = f"source ~/{WS}/install/setup.bash"
# A new terminal may open in any folder, as those of editors do.
OVERLAY = (
    'cd / && env -i HOME="$HOME" TERM="$TERM" PATH=/usr/local/bin:/usr/bin:/bin '
    "bash -ic 'echo $COLCON_PREFIX_PATH' 2>/dev/null </dev/null"
)
SUBMITTED = "A submission does not include a build, so only your own computer can check this."

workspace = Grader("05-workspace", builds=None, ros=False)


@workspace.scenario
def open_a_terminal(arena: Arena) -> None:
    with arena.shell() as shell:
        shell.run(TRACE, timeout=20)
        shell.run(OVERLAY, timeout=20)


@workspace.check("src", f"`~/{WS}/src` exists")
def src(recording: Recording) -> None:
    if recording.home.file(f"{WS}/src").kind == "folder":
        return
    inside = [name for name in recording.home.inside(WS) if name not in MADE]
    close = f"{WS}/{inside[0]}" if len(inside) == 1 else recording.home.near_folder(f"{WS}/src")
    raise Failure(
        Feedback(
            summary=f"There is no folder `~/{WS}/src`" + (f"; there is `~/{close}`." if close else "."),
            expected=f"~/{WS}/src",
            seen=f"~/{close}" if close else "no such folder",
            advice=f"`mkdir -p ~/{WS}/src` creates it. If it has a different name, rename it with `mv`.",
        )
    )


@workspace.check("built", f"colcon has built it, in `~/{WS}`", points=2, needs="src")
def built(recording: Recording) -> None:
    if not recording.local:
        raise NotApplicable(SUBMITTED)
    inside = [name for name in MADE if recording.home.file(f"{WS}/src/{name}").exists]
    if inside:
        raise Failure(built_in_src(inside))
    missing = [name for name in MADE if recording.home.file(f"{WS}/{name}").kind != "folder"]
    if missing:
        raise Failure(not_built(recording, missing))
    by_colcon = (recording.home.file(f"{WS}/build/.built_by").text or "").strip() == "colcon"
    laid_out = recording.home.file(f"{WS}/install/.colcon_install_layout").is_file
    if not (by_colcon and laid_out and recording.home.file(f"{WS}/install/setup.bash").is_file):
        raise Failure(half_built())


def built_in_src(inside: list[str]) -> Feedback:
    return Feedback(
        summary=f"colcon was run in `src`: it left {listed(inside)} there.",
        expected=f"~/{WS}/install",
        seen=f"~/{WS}/src/{inside[0]}",
        advice=f"Clean up: `cd ~/{WS}/src`, then `rm -r {' '.join(inside)}`. Build one folder higher: "
        "`cd ..`, then `colcon build`.",
    )


def not_built(recording: Recording, missing: list[str]) -> Feedback:
    home = recording.home
    away = [name for name in MADE if home.file(name).kind == "folder"]
    if len(missing) == len(MADE) and len(away) == len(MADE):
        summary = f"colcon was run in `~`, not in `~/{WS}`: it left {listed(away)} there."
        advice = f"`cd ~`, then `rm -r {' '.join(away)}`; then `cd ~/{WS}` and `colcon build`."
    elif len(missing) == len(MADE):
        summary = f"`~/{WS}` has not been built yet: it has no {listed(missing)}."
        advice = f"`cd ~/{WS}`, then `colcon build`."
    else:
        summary = f"`~/{WS}` lacks {listed(missing)}: the build is not complete, or was partly removed."
        advice = f"`cd ~/{WS}`, then `rm -rf {' '.join(MADE)}`, then `colcon build`."
    return Feedback(summary=summary, expected=listed([*MADE, "src"]), advice=advice)


def half_built() -> Feedback:
    return Feedback(
        summary=f"`build` and `install` in `~/{WS}` were not created by colcon.",
        expected="both as `colcon build` creates them, with `install/setup.bash`",
        advice=(
            f"Do not create them by hand: `cd ~/{WS}`, then `rm -r {' '.join(MADE)}`, then `colcon build`."
        ),
    )


@workspace.check("reads", "a new terminal reads `~/.bashrc` to the end")
def reads(recording: Recording) -> None:
    expect_shell(recording)


@workspace.check("sources", f"`~/.bashrc` sources `~/{WS}/install/setup.bash` once", needs="reads")
def sources(recording: Recording) -> None:
    found = own(recording)
    if len(found) == 1:
        return
    if len(found) > 1:
        raise Failure(
            Feedback(
                summary=f"The workspace is sourced {len(found)} times.",
                expected="one line",
                where=tuple(one.where for one in found)[:4],
                advice="Keep the last one, and remove the others.",
            )
        )
    written = mentions(recording)
    if not recording.local and "/setup." in (recording.home.file(BASHRC).text or ""):
        raise NotApplicable(SUBMITTED)  # it may source the file only if it exists: not here
    raise Failure(not_sourced(recording, written))


def own(recording: Recording) -> tuple[Sourced, ...]:
    """Where the course's workspace is sourced; a relative path counts, too."""
    return tuple(
        one for one in workspaces(recording) if WS in one.target or not one.target.startswith(("/", "~"))
    )


def mentions(recording: Recording) -> tuple[Location, ...]:
    lines = enumerate(recording.home.file(BASHRC).lines, 1)
    return tuple(Location(BASHRC, number) for number, line in lines if "setup.bash" in line and WS in line)


def not_sourced(recording: Recording, written: tuple[Location, ...]) -> Feedback:
    lines = recording.home.file(BASHRC).lines
    text = lines[(written[0].line or 1) - 1] if written else ""
    if text.lstrip().startswith("#"):
        summary = "The line begins with `#`, so bash skips it."
        advice = "Remove the `#`."
    elif "/src/" in text:
        summary = "The line names a `setup.bash` inside `src`; the right one is one folder higher."
        advice = f"Write this line: `{LINE}`."
    elif written:
        summary = "The workspace is named in `~/.bashrc`, but it is not sourced there."
        advice = (
            f"Write this line: `{LINE}`. Then check whether a line before it, such as `return`, stops "
            "bash from reading on."
        )
    else:
        summary = "`~/.bashrc` does not source the workspace."
        advice = f"Add this line at its end: `{LINE}`. If you use `echo`, write `>>`."
    return Feedback(summary=summary, expected=LINE, where=written[:1] or (Location(BASHRC),), advice=advice)


@workspace.check("after", "it does so after ROS 2 itself", needs="sources")
def after(recording: Recording) -> None:
    under, over = environments(recording), own(recording)[0]
    if not under:
        raise Failure(
            Feedback(
                summary=(
                    "`~/.bashrc` no longer sources ROS 2, only the workspace: did you write it with "
                    "a single `>`?"
                ),
                where=(over.where,),
                advice=(
                    "A single `>` erases the file first. Put the line from chapter 3 back above this "
                    "one (`ros2course init` prints it), and your alias from chapter 1."
                ),
            )
        )
    places = order(recording)
    if places.index("ros") > places.index("workspace"):
        raise Failure(
            Feedback(
                summary="The workspace is sourced before ROS 2.",
                expected="ROS 2 first, then the workspace",
                where=(over.where, under[0].where),
                advice="Swap the two lines: the workspace that is sourced last is searched first.",
            )
        )


def order(recording: Recording) -> list[str]:
    over, under = set(own(recording)), set(environments(recording))
    every = sourced(recording)
    return ["workspace" if one in over else "ros" for one in every if one in over | under]


@workspace.check("overlay", "a new terminal has the workspace in its environment", needs=("built", "after"))
def overlay(recording: Recording) -> None:
    printed = [line.strip() for line in expect_ran(recording, OVERLAY).printed]
    prefixes = printed[-1].split(":") if printed else []
    if any(re.search(rf"/{WS}/install/?$", prefix) for prefix in prefixes):
        return
    line = own(recording)[0]
    text = recording.home.file(line.where.file).lines[(line.where.line or 1) - 1]
    lacks = next((what for _, what in complaints(recording) if "No such file" in what), None)
    raise Failure(
        Feedback(
            summary=why_not(text, line, lacks),
            expected=LINE,
            seen=text.strip()[:120],
            where=(line.where,),
            advice=f"Write exactly `{LINE}`, with nothing around it.",
            details=(lacks,) if lacks else (),
        )
    )


def why_not(text: str, line: Sourced, lacks: str | None) -> str:
    if lacks and re.search(r"[\"']~", text):
        return "The path is in quotation marks, and inside them bash does not expand `~`."
    if not line.target.startswith(("/", "~")):
        return f"bash looks for `{line.target}` in the folder where the terminal opens, which may not be `~`."
    if lacks:
        return f"The line names a file that does not exist: {line.target}."
    return "The workspace is sourced, but it is not in the environment of a new terminal."
