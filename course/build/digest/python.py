"""Failed builds of Python packages: setup.py, setup.cfg and the files they name."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import PurePosixPath

from course.build.digest.case import Case
from course.build.digest.setup_source import EntryPoint, entry_points, name_line
from course.build.outcome import BuildFailure
from course.build.refusal import like, manifest_place

_COPY = re.compile(r"error: can't copy '(.+?)': doesn't exist")
_FOLDER = re.compile(r"error: package directory '(.+?)' does not exist")
_FRAME = re.compile(r'^\s*File "(.+?)", line (\d+)')
_EXCEPTION = re.compile(r"^(?:[\w.]+\.)?(\w*(?:Error|Exception|Warning|Exit|Interrupt))(?:: (.*))?$")
_CONFIG = re.compile(r"setup\.cfg'[,:]?\s*\[?line:?\s+(\d+)")

# Names that setup.py of a ROS package uses, and the line that brings each.
_IMPORTS = {
    "glob": "from glob import glob",
    "os": "import os",
    "find_packages": "from setuptools import find_packages, setup",
    "setup": "from setuptools import find_packages, setup",
    "Path": "from pathlib import Path",
}


def digest(case: Case) -> BuildFailure | None:
    if case.package.build_type != "ament_python":
        return None
    if not case.text("setup.py"):
        return _no_setup_py(case)
    return _missing_file(case) or _missing_folder(case) or _setup_py(case, case.ask_setup_py())


def _no_setup_py(case: Case) -> BuildFailure:
    name, where = case.package.name, [manifest_place(case.package, "build_type")]
    if case.text("CMakeLists.txt"):
        summary = f"package.xml of `{name}` says ament_python, but there is a CMakeLists.txt and no setup.py."
        advice = "If it is a CMake package, write `<build_type>ament_cmake</build_type>`."
        return case.failure("build-type", summary, where=where, advice=advice)
    if (case.source / "setup.py").is_symlink():
        summary = f"setup.py of `{name}` is a link that leads out of the course home, or nowhere."
        advice = "Put the file itself in its place."
        return case.failure("setup-py", summary, where=[case.place("setup.py")], advice=advice)
    if (case.source / "setup.py").exists():
        return case.failure("setup-py", f"setup.py of `{name}` is empty.", where=[case.place("setup.py")])
    summary = f"`{name}` has no setup.py, which a package of type ament_python is built with."
    advice = f"Make a fresh package with `ros2 pkg create {name} --build-type ament_python` and compare."
    return case.failure("setup-missing", summary, where=where, advice=advice)


# ------------------------------------------------------------------------------------- files it names


def _missing_file(case: Case) -> BuildFailure | None:
    found = _first(_COPY, case.lines)
    if not found:
        return None
    file, line = found.group(1), found.string
    if file.startswith("resource/"):
        return _marker(case, PurePosixPath(file).name, line)
    where = [case.place("setup.py", _data_line(case, file))]
    summary = f"setup.py of `{case.package.name}` installs {file}, but there is no such file."
    near = like(file, _files(case))
    advice = f"Did you mean `{near}`?" if near else "Make the file, or take it out of `data_files`."
    return case.failure("data-file", summary, where=where, advice=advice, details=[line])


def _marker(case: Case, named: str, line: str) -> BuildFailure:
    name = case.package.name
    if named != name:
        return _names_differ(case, named, [line])
    summary = f"The empty file resource/{name} is missing: it tells ROS that this package exists."
    others = [file for file in _files(case) if file.startswith("resource/")]
    advice = (
        f"Rename {others[0]} to resource/{name}."
        if len(others) == 1
        else f"Make it: `touch resource/{name}`."
    )
    where = [
        case.place(f"resource/{name}"),
        case.place("setup.py", case.line_of("setup.py", r"['\"]resource/")),
    ]
    return case.failure("marker-missing", summary, where=where, advice=advice, details=[line])


def _names_differ(case: Case, named: str, details: Sequence[str]) -> BuildFailure:
    name = case.package.name
    summary = f"setup.py calls the package `{named}`, but package.xml calls it `{name}`."
    where = [
        case.place("setup.py", name_line(case.text("setup.py"), named)),
        manifest_place(case.package, "name"),
    ]
    advice = "Write the same name in both and in setup.cfg, for the folder, and for the file in resource/."
    return case.failure("names-differ", summary, where=where, advice=advice, details=details)


def _missing_folder(case: Case) -> BuildFailure | None:
    found = _first(_FOLDER, case.lines)
    if not found:
        return None
    folder = found.group(1)
    summary = (
        f"setup.py of `{case.package.name}` lists the Python package {folder}, but there is no such folder."
    )
    where = [case.place("setup.py", case.line_of("setup.py", r"\bpackages\s*="))]
    advice = "`packages=find_packages(exclude=['test'])` finds every folder that has an `__init__.py`."
    return case.failure("package-folder", summary, where=where, advice=advice, details=[found.group(0)])


def _data_line(case: Case, file: str) -> int | None:
    exact = case.line_of("setup.py", re.escape(file))
    return (
        exact
        or case.line_of("setup.py", re.escape(PurePosixPath(file).name))
        or case.line_of("setup.py", "data_files")
    )


def _files(case: Case) -> list[str]:
    return [path.relative_to(case.source).as_posix() for path in case.source.rglob("*") if path.is_file()]


# ----------------------------------------------------------------------------------- setup.py itself


def _setup_py(case: Case, said: Sequence[str]) -> BuildFailure | None:
    """`said` is what setup.py prints when it is run alone: colcon swallows or buries it."""
    found = next((m for line in reversed(said) if (m := _EXCEPTION.match(line))), None)
    if found and (config := _CONFIG.search("\n".join(said))):
        return _setup_cfg(case, int(config.group(1)), said)
    if found:
        return _exception(case, found.group(1), found.group(2) or "", said)
    refused = next((line for line in said if line.startswith(("error in ", "error: "))), None)
    if refused:
        return _entry_points(case, said) or _refused(case, refused)
    return _never_called(case) if "never called" in "\n".join(case.lines) else None


def _exception(case: Case, kind: str, message: str, said: Sequence[str]) -> BuildFailure:
    line = next((int(m.group(2)) for text in reversed(said) if (m := _own_frame(text))), None)
    telling = _from_last_frame(said)
    if kind in ("SyntaxError", "IndentationError", "TabError"):
        summary = f"setup.py of `{case.package.name}` is not Python: {message.rstrip('?.')}."
        advice = "Look at that line and the one above it for a missing comma, quote or bracket."
    else:
        summary = f"setup.py of `{case.package.name}` stops with {kind}: {message.rstrip('.')}."
        advice = _import_advice(message)
    where = [case.place("setup.py", line)]
    return case.failure("setup-py", summary, where=where, advice=advice, details=telling)


def _own_frame(line: str) -> re.Match[str] | None:
    found = _FRAME.match(line)
    return found if found and PurePosixPath(found.group(1)).name == "setup.py" else None


def _from_last_frame(said: Sequence[str]) -> Sequence[str]:
    own = [number for number, line in enumerate(said) if _own_frame(line)]
    start = own[-1] if own else 0
    return [said[start].strip(), *said[start + 1 :][:3], *said[start + 4 :][-2:]] if own else said[-4:]


def _import_advice(message: str) -> str:
    found = re.search(r"name '(\w+)' is not defined", message)
    if found and (line := _IMPORTS.get(found.group(1))):
        return f"Add `{line}` at the top of setup.py."
    if message.startswith(("No module named", "cannot import name")):
        return "Correct or remove that import: setup.py needs little more than setuptools, os and glob."
    if message.startswith("'module' object is not callable"):
        return "A module is called there, not a function of it: `from glob import glob`, not `import glob`."
    if message.startswith(("'tuple' object is not callable", "'list' object is not callable")):
        return "A comma is missing before the brackets that follow: end each entry of a list with one."
    return "Run `python3 setup.py --name` in the package's folder to see it for yourself."


def _setup_cfg(case: Case, line: int, said: Sequence[str]) -> BuildFailure:
    summary = f"setup.cfg of `{case.package.name}` cannot be read: line {line} is not right."
    scripts = f"$base/lib/{case.package.name}"
    advice = f"It has sections such as `[install]`, and lines such as `install_scripts={scripts}`."
    details = [*case.at("setup.cfg", line), next(text for text in said if _EXCEPTION.match(text))]
    return case.failure(
        "setup-cfg", summary, where=[case.place("setup.cfg", line)], advice=advice, details=details
    )


def _entry_points(case: Case, said: Sequence[str]) -> BuildFailure | None:
    points = entry_points(case.text("setup.py"))
    joined = next((point for point in points if point.is_joined), None)
    if joined:
        return _comma(case, joined, said)
    unsound = next((point for point in points if not point.is_sound), None)
    return _unsound(case, unsound) if unsound else None


def _comma(case: Case, point: EntryPoint, said: Sequence[str]) -> BuildFailure:
    first, second = point.parts[0], point.parts[1]
    text = case.text("setup.py").splitlines()
    summary = (
        f"A comma is missing in setup.py of `{case.package.name}`, after the entry point in line {first}."
    )
    advice = f"Put one at the end of line {first}: without it, Python joins the strings of "
    advice += f"lines {first} and {second} to one."
    details = [text[first - 1], text[second - 1], *(line for line in said if line.startswith("error"))]
    return case.failure(
        "entry-point", summary, where=[case.place("setup.py", first)], advice=advice, details=details
    )


def _unsound(case: Case, point: EntryPoint) -> BuildFailure:
    summary = f"Line {point.line} of setup.py of `{case.package.name}` is not an entry point."
    advice = (
        "An entry point names the program, the module with dots (no `/`, no `.py`), and the function to call."
    )
    return case.failure(
        "entry-point",
        summary,
        where=[case.place("setup.py", point.line)],
        advice=advice,
        expected="program = package.module:function",
        seen=point.text,
    )


def _refused(case: Case, line: str) -> BuildFailure:
    reason = re.sub(r"^error( in .*? setup command)?: ", "", line)
    summary = f"setuptools refuses setup.py of `{case.package.name}`: {reason.rstrip('.')}."
    return case.failure("setup-py", summary, where=[case.place("setup.py")], details=[line])


def _never_called(case: Case) -> BuildFailure:
    summary = f"setup.py of `{case.package.name}` never calls `setup(...)`."
    advice = "The call belongs to the end of the file, not into a function and not behind an `if`."
    return case.failure("setup-py", summary, where=[case.place("setup.py")], advice=advice)


def _first(pattern: re.Pattern[str], lines: Sequence[str]) -> re.Match[str] | None:
    return next((found for line in lines if (found := pattern.search(line))), None)
