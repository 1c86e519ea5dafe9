"""Why `ros2 run` finds no executable of an ament_cmake package: what CMakeLists.txt builds and installs."""

from __future__ import annotations

from course.evidence.events import ExecutableMissing
from course.evidence.sources import Sources
from course.feedback import Feedback, Location
from course.grading.explain.cmake_lists import LISTS, Command, commands
from course.grading.explain.names import listed, nearest

_NOWHERE = "nowhere"


def not_installed(missing: ExecutableMissing, folder: str, sources: Sources) -> Feedback:
    """`No executable found`, with the likely cause in the learner's CMakeLists.txt."""
    every = commands(sources, folder)
    name = missing.executable
    made = [command for command in every if command.name == "add_executable" and command.words]
    targets = {command.words[0]: command for command in made}
    if name in targets:
        places = [one for one in _installs(every) if name in one.words]
        return _elsewhere(missing, places[0]) if places else _left(missing, targets[name])
    close = nearest(name, (*targets, *missing.available))
    if close:
        where = targets[close].where if close in targets else Location(f"{folder}/{LISTS}")
        return _misspelt(name, close, where)
    return _unbuilt(missing, made, Location(f"{folder}/{LISTS}"))


def _installs(every: tuple[Command, ...]) -> tuple[Command, ...]:
    return tuple(one for one in every if one.name == "install" and one.words[:1] == ("TARGETS",))


def _left(missing: ExecutableMissing, made: Command) -> Feedback:
    return Feedback(
        summary=f"No executable found: `{missing.executable}` is built, but not installed.",
        expected=f"installed in the folder lib/{missing.package}",
        seen="built only",
        where=(made.where,),
        advice=f"Add to CMakeLists.txt: `{_line(missing.executable)}`",
    )


def _elsewhere(missing: ExecutableMissing, install: Command) -> Feedback:
    place = install.after("DESTINATION") or _NOWHERE
    return Feedback(
        summary=f"No executable found: `{missing.executable}` is not installed where `ros2 run` looks.",
        expected=f"installed in the folder lib/{missing.package}",
        seen=f"installed in the folder {place}" if place != _NOWHERE else "no DESTINATION",
        where=(install.where,),
        advice=f"Let CMakeLists.txt say: `{_line(missing.executable)}`",
    )


def _misspelt(wanted: str, close: str, where: Location) -> Feedback:
    return Feedback(
        summary=f"No executable found: the package has `{close}`, but not `{wanted}`.",
        expected=wanted,
        seen=close,
        where=(where,),
        advice=f"Correct the name in {LISTS}, letter by letter, in each line that has it.",
    )


def _unbuilt(missing: ExecutableMissing, made: list[Command], where: Location) -> Feedback:
    others = [command.words[0] for command in made]
    return Feedback(
        summary=f"No executable found: CMakeLists.txt builds no `{missing.executable}`.",
        expected=f"`{missing.executable}` in `add_executable` and in `install`",
        seen=f"built: {listed(others)}",
        where=(made[0].where if made else where,),
        advice=f"`add_executable({missing.executable} ...)` names its .cpp files, "
        f"`install(TARGETS {missing.executable} ...)` puts it where `ros2 run` looks.",
    )


def _line(name: str) -> str:
    return f"install(TARGETS {name} DESTINATION lib/${{PROJECT_NAME}})"
