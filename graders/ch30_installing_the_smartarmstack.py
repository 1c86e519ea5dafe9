"""Grader of chapter 30: a second workspace, for the driver of the next chapter."""

from __future__ import annotations

from course.api import Failure, Feedback, Grader, Recording

WS = "sas_tutorial_workspace"
SRC = f"{WS}/src"
# Its name is similar, so the feedback must not suggest renaming it.
FIRST = "ros2_tutorial_workspace"

workspace = Grader("30-sas-workspace", builds=None, ros=False)


@workspace.check("workspace", f"`~/{WS}` exists")
def workspace_is_there(recording: Recording) -> None:
    if recording.home.file(WS).kind != "folder":
        raise Failure(no_workspace(recording))


def no_workspace(recording: Recording) -> Feedback:
    close = next((folder for folder in recording.home.near_folders(WS) if folder != FIRST), None)
    if recording.home.file(WS).exists:
        seen, summary = f"~/{WS}, a file", f"`~/{WS}` is a file, not a folder."
        advice = f"Run `rm ~/{WS}`, then `mkdir -p ~/{SRC}`."
    elif close:
        seen, summary = f"~/{close}", f"There is no folder `~/{WS}`, but there is `~/{close}`."
        advice = f"Give it the right name and place: `mv ~/{close} ~/{WS}`."
    else:
        seen, summary = "no such folder", f"There is no folder `~/{WS}`."
        advice = f"Create it, with `src` in it: `mkdir -p ~/{SRC}`."
    return Feedback(summary=summary, expected=f"~/{WS}", seen=seen, advice=advice)


@workspace.check("src", f"`~/{SRC}` exists", needs="workspace")
def src_is_there(recording: Recording) -> None:
    if recording.home.file(SRC).kind != "folder":
        raise Failure(no_src(recording))


def no_src(recording: Recording) -> Feedback:
    if recording.home.file(SRC).exists:
        seen, advice = "a file", f"Run `rm ~/{SRC}`, then `mkdir ~/{SRC}`."
    elif recording.home.inside(WS):
        seen = f"~/{WS}/{recording.home.inside(WS)[0]}"
        advice = (
            f"Run `mkdir ~/{SRC}`, or rename the folder with `mv` if it has a different name. colcon looks "
            "for packages in `src`."
        )
    else:
        seen, advice = f"~/{WS}, which is empty", f"Run `mkdir ~/{SRC}`."
    return Feedback(
        summary=f"There is no folder `src` in `~/{WS}`.", expected=f"~/{SRC}", seen=seen, advice=advice
    )
