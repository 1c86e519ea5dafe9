"""Why `ros2 run` finds no executable: from what is installed, and what setup.py or CMakeLists.txt says."""

from __future__ import annotations

from course.evidence.events import ExecutableMissing
from course.evidence.packages import BuiltPackages
from course.evidence.sources import Sources
from course.feedback import Feedback, Location
from course.grading.explain.cmake_install import not_installed
from course.grading.explain.cmake_lists import LISTS
from course.grading.explain.names import listed, nearest
from course.grading.explain.setup_py import entry_points, joined_entry_points


def no_executable(missing: ExecutableMissing, packages: BuiltPackages, sources: Sources) -> Feedback:
    """`No executable found`, with the likely cause in what the learner's package is built with."""
    package = packages.get(missing.package)
    if package is None:
        return Feedback(
            summary=f"The package `{missing.package}` was not built, so there is nothing to run.",
            advice="See to it first that it builds: `colcon build` names the error.",
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
        return _elsewhere(missing.package, missing.executable, declared[missing.executable])
    if close:
        return _misspelt(missing.executable, close, declared.get(close, setup))
    return _undeclared(missing, declared.get(next(iter(declared), ""), setup))


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
        advice="`setup.cfg` beside `setup.py` says where it goes. Under `[install]` it needs the line "
        f"`install_scripts=$base/lib/{package}`.",
    )


def _misspelt(wanted: str, close: str, where: Location) -> Feedback:
    return Feedback(
        summary=f"No executable found: the package has `{close}`, but not `{wanted}`.",
        expected=wanted,
        seen=close,
        where=(where,),
        advice="Correct the name before the `=` of the entry point, letter by letter.",
    )


def _undeclared(missing: ExecutableMissing, where: Location) -> Feedback:
    return Feedback(
        summary=f"No executable found: `{missing.package}` installs no `{missing.executable}`.",
        expected=f"`{missing.executable}` among the entry points",
        seen=f"installed: {listed(missing.available)}",
        where=(where,),
        advice="Add it to `console_scripts` in `setup.py`: "
        f"`'{missing.executable} = {missing.package}.<module>:main',`",
    )
