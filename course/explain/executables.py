"""Why `ros2 run` finds no executable, based on what is installed and on setup.py or CMakeLists.txt."""

from __future__ import annotations

from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.explain.cmake import LISTS, Command, commands
from course.explain.engine import Evidence
from course.explain.setup_py import entry_points, joined_entry_points, misspelled_group
from course.model import replace
from course.model.events import ExecutableMissing
from course.model.feedback import Feedback, Location
from course.spelling import listed, nearest


def no_executable(missing: ExecutableMissing, packages: BuiltPackages, sources: Sources) -> Feedback:
    """Feedback on `No executable found`, with the likely cause in the files that build the package."""
    package = packages.get(missing.package)
    if package is None:
        return Feedback(
            summary=f"The package `{missing.package}` was not built, so there is nothing to run.",
            advice="Fix the build first: `colcon build` names the error.",
        )
    if f"{package.source}/{LISTS}" in sources.files:
        return not_installed(missing, package.source, sources)
    setup = Location(f"{package.source}/setup.py")
    declared = {entry.name: entry.where for entry in entry_points(sources, package.source)}
    joined = joined_entry_points(sources, package.source)
    close = nearest(missing.executable, missing.available)
    if joined and missing.executable in joined.text:
        return _comma(joined.text, joined.where)
    if missing.executable in declared:
        config = f"{package.source}/setup.cfg"
        line = Evidence(sources=sources).line(config, r"install[_-]scripts")
        where = Location(config, line) if line else declared[missing.executable]
        return _elsewhere(missing.package, missing.executable, where)
    if close:
        return _misspelt(missing.executable, close, declared.get(close, setup))
    group = None if declared else misspelled_group(sources, package.source)
    undeclared = _undeclared(missing, declared.get(next(iter(declared), ""), setup))
    return replace(undeclared, where=group.where, advice=group.text) if group else undeclared


def _comma(text: str, where: Location) -> Feedback:
    return Feedback(
        summary="A comma is missing between two entry points: Python joins the two strings into one.",
        seen=text,
        where=(where,),
        advice="End each entry of `console_scripts` with a comma.",
    )


def _elsewhere(package: str, name: str, where: Location) -> Feedback:
    return Feedback(
        summary=f"No executable found: `{name}` is declared, but not installed where ROS looks for it.",
        expected=f"installed in the folder lib/{package}",
        where=(where,),
        advice="`setup.cfg` next to `setup.py` says where to install it. Under `[install]` it needs the line "
        f"`install_scripts=$base/lib/{package}`.",
    )


def _misspelt(wanted: str, close: str, where: Location) -> Feedback:
    return Feedback(
        summary=f"No executable found: the package has `{close}`, but not `{wanted}`.",
        expected=wanted,
        seen=close,
        where=(where,),
        advice="Correct the name before the `=` of the entry point.",
    )


def _undeclared(missing: ExecutableMissing, where: Location) -> Feedback:
    return Feedback(
        summary=f"No executable found: `{missing.package}` does not install `{missing.executable}`.",
        expected=f"`{missing.executable}` among the entry points",
        seen=f"installed: {listed(missing.available)}",
        where=(where,),
        advice="Add it to `console_scripts` in `setup.py`: "
        f"`'{missing.executable} = {missing.package}.<module>:main',`",
    )


_NOWHERE = "nowhere"


def not_installed(missing: ExecutableMissing, folder: str, sources: Sources) -> Feedback:
    """Feedback on `No executable found`, with the likely cause in the learner's CMakeLists.txt."""
    every = commands(sources, folder)
    name = missing.executable
    made = [command for command in every if command.name == "add_executable" and command.words]
    targets = {command.words[0]: command for command in made}
    if name in targets:
        places = [one for one in _installs(every) if name in one.words]
        return _installed_elsewhere(missing, places[0]) if places else _not_installed(missing, targets[name])
    close = nearest(name, (*targets, *missing.available))
    if close:
        where = targets[close].where if close in targets else Location(f"{folder}/{LISTS}")
        return _misspelt_target(name, close, where)
    return _no_target(missing, made, Location(f"{folder}/{LISTS}"))


def _installs(every: tuple[Command, ...]) -> tuple[Command, ...]:
    return tuple(one for one in every if one.name == "install" and one.words[:1] == ("TARGETS",))


def _not_installed(missing: ExecutableMissing, made: Command) -> Feedback:
    return Feedback(
        summary=f"No executable found: `{missing.executable}` is built, but not installed.",
        expected=f"installed in the folder lib/{missing.package}",
        seen="built only",
        where=(made.where,),
        advice=f"Add to CMakeLists.txt: `{_install_line(missing.executable)}`",
    )


def _installed_elsewhere(missing: ExecutableMissing, install: Command) -> Feedback:
    place = install.after("DESTINATION") or _NOWHERE
    return Feedback(
        summary=f"No executable found: `{missing.executable}` is not installed where `ros2 run` looks.",
        expected=f"installed in the folder lib/{missing.package}",
        seen=f"installed in the folder {place}" if place != _NOWHERE else "no DESTINATION",
        where=(install.where,),
        advice=f"In CMakeLists.txt, write: `{_install_line(missing.executable)}`",
    )


def _misspelt_target(wanted: str, close: str, where: Location) -> Feedback:
    return Feedback(
        summary=f"No executable found: the package has `{close}`, but not `{wanted}`.",
        expected=wanted,
        seen=close,
        where=(where,),
        advice=f"Correct the name on each line of {LISTS} that uses it.",
    )


def _no_target(missing: ExecutableMissing, made: list[Command], where: Location) -> Feedback:
    others = [command.words[0] for command in made]
    return Feedback(
        summary=f"No executable found: CMakeLists.txt does not build `{missing.executable}`.",
        expected=f"`{missing.executable}` in `add_executable` and in `install`",
        seen=f"built: {listed(others)}",
        where=(made[0].where if made else where,),
        advice=f"`add_executable({missing.executable} ...)` names its .cpp files, and `install(TARGETS "
        f"{missing.executable} ...)` puts it where `ros2 run` looks.",
    )


def _install_line(name: str) -> str:
    return f"install(TARGETS {name} DESTINATION lib/${{PROJECT_NAME}})"
