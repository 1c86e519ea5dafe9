"""Grader of chapter 7: a Python package as `ros2 pkg create` makes it. Here the files are the exercise."""

from __future__ import annotations

from course.api import (
    Arena,
    Failure,
    Feedback,
    Grader,
    Location,
    Recording,
    answered,
    expect_build_type,
    expect_importable,
    expect_manifest,
    listed,
    nearest,
    read_setup_cfg,
    text_places,
)
from lib.installed_packages import not_installed

PACKAGE = "the_simplest_python_package"
SCRIPTS = f"$base/lib/{PACKAGE}"
SCRIPT_FOLDERS = (("develop", "script_dir"), ("install", "install_scripts"))
LINT_TESTS = ("test_copyright.py", "test_flake8.py", "test_pep257.py")
AGAIN = "or create the package again in an empty folder, and compare."

IMPORTED = "import"

simplest = Grader("07-simplest-package", ros=False)


@simplest.scenario
def import_it(arena: Arena) -> None:
    """Import it from another folder, so that Python finds it only if it is installed."""
    arena.probe(f"import importlib\nask({IMPORTED!r}, lambda: importlib.import_module({PACKAGE!r}).__file__)")


def folder(recording: Recording) -> str:
    """The package's folder, relative to the course home."""
    built = recording.packages.get(PACKAGE)
    return built.source if built else PACKAGE


def inside(recording: Recording, part: str = "") -> list[str]:
    """Names of the files in a folder of the package, or in all of it, relative to that folder."""
    top = f"{folder(recording)}/{part}".rstrip("/")
    return [name.removeprefix(f"{top}/") for name in recording.sources.below(top).names]


@simplest.check("build_type", "it is a package of type ament_python")
def build_type(recording: Recording) -> None:
    expect_build_type(recording, PACKAGE, "ament_python")


@simplest.check("format", "package.xml is of format 3")
def package_format(recording: Recording) -> None:
    found = expect_manifest(recording, PACKAGE)
    if found.format == "3":
        return
    raise Failure(
        Feedback(
            summary=f"package.xml is of format {found.format}, not 3.",
            expected='<package format="3">',
            where=text_places(recording.sources, "<package")[:1] or (found.where,),
            advice='Write `<package format="3">`, as `ros2 pkg create` does by default.',
        )
    )


@simplest.check("marker", "the marker in resource/ is there", needs="build_type")
def marker(recording: Recording) -> None:
    found = inside(recording, "resource")
    if PACKAGE in found:
        return
    near = nearest(PACKAGE, found)
    raise Failure(
        Feedback(
            summary=f"The empty file resource/{PACKAGE} is missing: it tells ROS that this package exists.",
            expected=f"resource/{PACKAGE}",
            seen=f"resource/{near}" if near else f"in resource/: {listed(found, 'nothing')}",
            where=(Location(f"{folder(recording)}/resource"),),
            advice=f"Rename it to `{PACKAGE}`."
            if near
            else (
                f"Create it in the package's folder: `touch resource/{PACKAGE}`. setup.py must list "
                "it in `data_files`."
            ),
        )
    )


@simplest.check("module", f"`import {PACKAGE}` works", needs="build_type")
def module(recording: Recording) -> None:
    expect_importable(recording, f"import {PACKAGE}")
    error = recording.probe().answer(IMPORTED)
    if error and error.error and f"No module named '{PACKAGE}'" in error.error:
        raise Failure(not_installed(recording.sources, folder(recording), PACKAGE, error.error))
    answered(recording, IMPORTED, f"import {PACKAGE}")


@simplest.check("setup_cfg", "setup.cfg installs programs where ROS looks", needs="build_type")
def setup_cfg(recording: Recording) -> None:
    file = f"{folder(recording)}/setup.cfg"
    text = recording.sources.files.get(file)
    for section, key in SCRIPT_FOLDERS:
        found = setting(text or "", section, key)
        if found != SCRIPTS:
            raise Failure(misdirected(recording, file, text, section, key, found))


def setting(text: str, section: str, key: str) -> str | None:
    """A value of setup.cfg; setuptools reads a dash in a key as an underscore."""
    parser = read_setup_cfg(text)
    if parser is None:
        return None
    return parser.get(section, key, fallback=parser.get(section, key.replace("_", "-"), fallback=None))


def misdirected(
    recording: Recording, file: str, text: str | None, section: str, key: str, found: str | None
) -> Feedback:
    line = f"{key}={SCRIPTS}"
    places = tuple(place for place in text_places(recording.sources, key) if place.file == file)
    return Feedback(
        summary=(
            "The package has no setup.cfg, so its programs are not installed where `ros2 run` looks for them."
        )
        if text is None
        else f"setup.cfg does not install programs to `{SCRIPTS}`, where `ros2 run` looks for them.",
        expected=f"[{section}] {line}",
        seen=f"[{section}] {key}={found}" if found else f"no `{key}` under [{section}]",
        where=places[:1] or (Location(file),),
        advice=f"Below `[{section}]`, write the line `{line}`, {AGAIN}",
    )


@simplest.check("tests", "test/ contains the three style tests", needs="build_type")
def lint_tests(recording: Recording) -> None:
    found = inside(recording, "test")
    missing = [name for name in LINT_TESTS if name not in found]
    if not missing:
        return
    raise Failure(
        Feedback(
            summary=f"The folder test/ lacks {listed(missing)}.",
            expected=f"test/{missing[0]}",
            seen=f"in test/: {listed(found, 'nothing')}",
            where=(Location(f"{folder(recording)}/test"),),
            advice=f"Put it back, {AGAIN}",
        )
    )


@simplest.check("label", "description, license, and maintainer are real", bonus=True, needs="build_type")
def label(recording: Recording) -> None:
    found = expect_manifest(recording, PACKAGE)
    for tag, what in (("description", "the description"), ("license", "the license")):
        value = " ".join(found.values(tag))
        if "TODO" in value or not value:
            raise Failure(still_to_do(recording, what, value or "nothing", f"<{tag}"))
    if text_places(recording.sources.below(folder(recording)), "@todo.todo"):
        raise Failure(still_to_do(recording, "the maintainer's address", "@todo.todo", "<maintainer"))


def still_to_do(recording: Recording, what: str, seen: str, near: str) -> Feedback:
    file = f"{folder(recording)}/package.xml"
    places = tuple(place for place in text_places(recording.sources, near) if place.file == file)
    return Feedback(
        summary=f"In package.xml, {what} is still a placeholder: `{seen}`.",
        where=places[:1] or (Location(file),),
        advice=(
            "Fill in real values: what the package is for, a license such as `MIT`, and your email address."
        ),
    )
