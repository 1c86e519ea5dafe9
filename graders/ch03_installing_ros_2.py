"""Grader of chapter 3: one line of `.bashrc` makes ROS 2 known to an interactive bash."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import PurePosixPath

from course.api import (
    BASHRC,
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    NotApplicable,
    OurFault,
    Recording,
    complaints,
    expect_ran,
    expect_shell,
    listed,
)
from lib.sourcing import TRACE, Sourced, environments

DISTRO = "echo $ROS_DISTRO"
USAGE = "ros2"
# Some of the commands that each distribution has.
COMMANDS = ("node", "pkg", "run", "topic")
ELSEWHERE = "The line names a file on the computer that the submission comes from."
ADVICE = "`ros2course init` prints the right line for this computer."
SETUP = r"[^\s;#'\"]*setup\.(?:bash|sh|zsh)"

environment = Grader("03-environment", builds=None, ros=False)


@environment.scenario
def open_a_terminal(arena: Arena) -> None:
    in_use = arena.start("printenv", "ROS_DISTRO", name="in use")
    with arena.shell() as shell:
        shell.run(DISTRO)
        shell.run(USAGE, timeout=20)
        shell.run(TRACE, timeout=20)
    in_use.wait(10)


@environment.check("reads", "a new terminal reads `~/.bashrc` to the end")
def reads(recording: Recording) -> None:
    expect_shell(recording)


@environment.check("once", "`~/.bashrc` sources ROS 2 exactly once", needs="reads")
def once(recording: Recording) -> None:
    found = environments(recording)
    if len(found) == 1:
        return
    if not found and not recording.local and "/setup." in (recording.home.file(BASHRC).text or ""):
        raise NotApplicable(ELSEWHERE)  # it may source the file only if it exists: not here
    raise Failure(repeated(found) if found else missing(recording))


def repeated(found: tuple[Sourced, ...]) -> Feedback:
    targets = list(dict.fromkeys(one.target for one in found))
    return Feedback(
        summary=f"ROS 2 is sourced {len(found)} times, from {listed(targets)}."
        if len(targets) > 1
        else f"ROS 2 is sourced {len(found)} times.",
        expected="one line",
        seen=f"{len(found)} lines",
        where=tuple(dict.fromkeys(one.where for one in found))[:4],
        advice=f"Keep one of them, and remove the others. {ADVICE}",
    )


def missing(recording: Recording) -> Feedback:
    """Why nothing is sourced: the most likely cause in the file."""
    for summary, advice, places in reasons(recording):
        if places:
            return Feedback(summary=summary, where=places[:2], advice=advice)
    return Feedback(
        summary="`~/.bashrc` does not source ROS 2.",
        expected="source /opt/ros/jazzy/setup.bash, or the path of ROS 2 on this computer",
        where=(Location(BASHRC),),
        advice=f"Add the line to its end. {ADVICE}",
    )


def reasons(recording: Recording) -> Iterable[tuple[str, str, tuple[Location, ...]]]:
    yield (
        "The line that sources ROS 2 begins with `#`, so bash skips it.",
        "Remove the `#`.",
        places(recording, rf"\s*#+\s*(source|\.)\s+{SETUP}"),
    )
    yield (
        "`setup.bash` is run, not sourced, so everything it sets is lost when it ends.",
        f"Put only the word `source` before the path. {ADVICE}",
        places(recording, rf"\s*((ba|z)?sh\s+)?[/~.$]{SETUP}"),
    )
    yield (
        "`~/.bashrc` contains the line that sources ROS 2, but bash never reaches it.",
        "Check the lines before it: does one stop bash from reading on, as `return` does, or is "
        "there an `if` that is not true?",
        places(recording, rf".*(source|\.)\s+{SETUP}"),
    )
    others = sorted(name for name in recording.home.inside() if name != BASHRC)
    for name in others:
        found = places(recording, rf".*(source|\.)\s+{SETUP}", name)
        yield (
            f"The line is in `~/{name}`, which a new terminal does not read.",
            "Move it to `~/.bashrc`, with the dot.",
            found,
        )


def places(recording: Recording, pattern: str, file: str = BASHRC) -> tuple[Location, ...]:
    lines = enumerate(recording.home.file(file).lines, 1)
    return tuple(Location(file, number) for number, line in lines if re.match(pattern, line))


@environment.check("distro", "`ROS_DISTRO` names the distribution in use", needs="once")
def distro(recording: Recording) -> None:
    wanted = in_use(recording)
    printed = [line.strip() for line in expect_ran(recording, DISTRO).printed]
    seen = printed[-1] if printed else ""
    if seen == wanted:
        return
    line = environments(recording)[0]
    lacks = next((text for _, text in complaints(recording) if "No such file" in text), None)
    not_here(recording, lacks)
    raise Failure(
        Feedback(
            summary=wrong_distro(line, seen, wanted, lacks),
            expected=wanted,
            seen=seen or "nothing",
            where=(line.where,),
            advice=f"Correct the path. {ADVICE}",
            details=(lacks,) if lacks else (),
        )
    )


def in_use(recording: Recording) -> str:
    text = [line.strip() for line in recording.process("in use").text if line.strip()]
    if not text:
        raise OurFault("the environment of the check names no ROS distribution")
    return text[-1]


def wrong_distro(line: Sourced, seen: str, wanted: str, lacks: str | None) -> str:
    named = PurePosixPath(line.target).parent.name
    other = bool(re.fullmatch(r"/opt/ros/[a-z]+", str(PurePosixPath(line.target).parent))) and named != wanted
    if lacks and other:
        return f"The line is for `{named}`, which is not installed here. This course uses `{wanted}`."
    if lacks:
        return f"The line names a file that does not exist: {line.target}."
    if seen:
        return f"A new terminal has the distribution `{seen}`, but this course uses `{wanted}`."
    return f"{line.target} is sourced, but `ROS_DISTRO` is not set afterwards."


def not_here(recording: Recording, lacks: str | None) -> None:
    if not recording.local and lacks:
        raise NotApplicable(ELSEWHERE)


@environment.check("ros2", "`ros2` prints its commands", needs="distro")
def finds_ros2(recording: Recording) -> None:
    ran = expect_ran(recording, USAGE)
    words = {line.split()[0] for line in ran.printed if line.split()}
    if any("usage: ros2" in line for line in ran.printed) and words.issuperset(COMMANDS):
        return
    raise Failure(
        Feedback(
            summary="A new terminal cannot find `ros2`."
            if ran.code == 127
            else "`ros2` does not print its commands.",
            expected="usage: ros2 ...",
            seen=ran.printed[-1][:120] if ran.printed else "nothing",
            where=places(recording, r".*\bPATH=")[:2] or (Location(BASHRC),),
            advice="After the line that sources ROS 2, is there one that sets `PATH` without `$PATH` in it? "
            "And is there an alias or a function called `ros2`?",
            details=ran.printed[:4],
        )
    )
