"""Grader of chapter 8: a program from the template of `ros2 pkg create`, run by `ros2 run`."""

from __future__ import annotations

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    Recording,
    calls,
    expect_build_type,
    expect_clean_end,
    expect_executable,
)

PACKAGE = "python_package_with_a_node"
PROGRAM = "sample_python_node"
GREETING = f"Hi from {PACKAGE}."

template = Grader("08-template-node", ros=False)


@template.scenario
def run_it_once(arena: Arena) -> None:
    program = arena.run(PACKAGE, PROGRAM)
    if program and not program.wait(10):
        arena.interrupt(program)


@template.check("executable", f"`ros2 run` finds {PROGRAM}")
def executable(recording: Recording) -> None:
    missing = recording.missing_executable(PROGRAM)
    if missing and not missing.available and not modules(recording):
        raise Failure(no_program(recording))
    expect_executable(recording, PROGRAM)


def modules(recording: Recording) -> list[str]:
    built = recording.packages.get(PACKAGE)
    files = recording.sources.below(f"{built.source}/{PACKAGE}").files if built else ()
    return [file for file in files if file.endswith(".py") and not file.endswith("/__init__.py")]


def no_program(recording: Recording) -> Feedback:
    built = recording.packages.get(PACKAGE)
    return Feedback(
        summary=f"No executable found: the package contains no program at all, so no `{PROGRAM}` either.",
        expected=PROGRAM,
        seen="a package without a program",
        where=(Location(f"{built.source}/{PACKAGE}"),) if built else (),
        advice="Remove the folder, and create the package again, with the option "
        f"`--node-name {PROGRAM}`: it writes the program and declares it in setup.py.",
    )


@template.check("ends", "it ends on its own, with exit code 0", needs="executable")
def ends(recording: Recording) -> None:
    expect_clean_end(recording, PROGRAM)


@template.check("greeting", f"it prints `{GREETING}`", needs="ends")
def greeting(recording: Recording) -> None:
    text = [line.strip() for line in recording.process(PROGRAM).text if line.strip()]
    if GREETING in text:
        return
    if any("hello world" in line for line in text):  # the C++ template
        expect_build_type(recording, PACKAGE, "ament_python")
    raise Failure(
        Feedback(
            summary=f"`{PROGRAM}` does not print `{GREETING}`",
            expected=GREETING,
            seen=text[0] if text else "nothing",
            where=tuple(call.where for call in calls(recording.sources, "print"))[:2],
            advice="Print exactly these words: capital letters, underscores and the period count."
            if text
            else "Does the entry point name the function that prints, and does that function call `print`?",
        )
    )
