"""Grader of chapter 30: a second workspace, for the driver of the next chapter."""

from __future__ import annotations

from course.api import Failure, Feedback, Grader, Recording

WS = "sas_tutorial_workspace"
SRC = f"{WS}/src"
# Its name is similar to the other's, and should not be revealed.
FIRST = "ros2_tutorial_workspace"

workspace = Grader("30-sas-workspace", builds=None, ros=False)


@workspace.check("workspace", f"`~/{WS}` is there")
def workspace_is_there(recording: Recording) -> None:
    if recording.home.file(WS).kind != "folder":
        raise Failure(no_workspace(recording))


def no_workspace(recording: Recording) -> Feedback:
    close = next((folder for folder in recording.home.near_folders(WS) if folder != FIRST), None)
    if recording.home.file(WS).exists:
        seen, summary = f"~/{WS}, a file", f"`~/{WS}` is a file, not a folder."
        advice = f"`rm ~/{WS}`, then `mkdir -p ~/{SRC}`."
    elif close:
        seen, summary = f"~/{close}", f"There is no folder `~/{WS}`; there is `~/{close}`."
        advice = f"`mv ~/{close} ~/{WS}` gives it the right name, in the right place."
    else:
        seen, summary = "no such folder", f"There is no folder `~/{WS}`."
        advice = f"`mkdir -p ~/{SRC}` creates it with `src` in it."
    return Feedback(summary=summary, expected=f"~/{WS}", seen=seen, advice=advice)


@workspace.check("src", f"`~/{SRC}` is there", needs="workspace")
def src_is_there(recording: Recording) -> None:
    if recording.home.file(SRC).kind != "folder":
        raise Failure(no_src(recording))


def no_src(recording: Recording) -> Feedback:
    if recording.home.file(SRC).exists:
        seen, advice = "a file", f"`rm ~/{SRC}`, then `mkdir ~/{SRC}`."
    elif recording.home.inside(WS):
        seen = f"~/{WS}/{recording.home.inside(WS)[0]}"
        advice = (
            f"colcon looks for packages in `src`: run `mkdir ~/{SRC}`, or rename the folder with `mv` "
            "if it has a different name."
        )
    else:
        seen, advice = f"~/{WS}, which is empty", f"`mkdir ~/{SRC}`."
    return Feedback(
        summary=f"There is no folder `src` in `~/{WS}`.", expected=f"~/{SRC}", seen=seen, advice=advice
    )
