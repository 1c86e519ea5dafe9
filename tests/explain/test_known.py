"""Every known error explains its own example, and no earlier entry does; the texts are in `known.txt`.

After a change that is meant, write the file again: `KNOWN=write pytest tests/explain/test_known.py`.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.sources import Sources
from course.explain import build_errors, cmake_errors, cpp_errors, interface_errors, python_errors, setup_py
from course.explain.builds import Build, read_copy
from course.explain.cmake import LISTS
from course.explain.cmake import cmake_errors as read_cmake
from course.explain.compiler import CppError, first_error
from course.explain.engine import Evidence, Explanation, Known, Symptom, explain
from course.explain.package_xml import Manifest, manifest
from course.model import replace
from course.model.feedback import Location
from tests.explain.conftest import made_up_ros

FOLDER = "src/talk"
GOLDEN = Path(__file__).with_name("known.txt")
WRITTEN: dict[str, list[str]] | None = {} if os.environ.get("KNOWN") == "write" else None
MANIFEST = """<package format="3">
  <name>talk</name>
  <depend>declared</depend>
  <export><build_type>{}</build_type></export>
</package>
"""
Reader = Callable[[Any, str], Sequence[Symptom]]


@dataclass(frozen=True)
class Table:
    """Known errors, and how their examples become symptoms."""

    known: tuple[Known[Any], ...]
    read: Reader
    type: str = "ament_cmake"
    upto: int | None = None  # those that follow are entries of another table


def as_lines(build: Build, example: str) -> list[Symptom]:
    return [Symptom(line, build.place("setup.py"), (line,)) for line in example.splitlines()]


def from_cmake(evidence: Evidence, example: str) -> list[Symptom]:
    indented = "\n".join(f"  {line}" for line in example.splitlines())
    return read_cmake(f"CMake Error at CMakeLists.txt:1 (x):\n{indented}\n\n".splitlines(), evidence)


def from_compiler(evidence: Evidence, example: str) -> list[Symptom]:
    return [cpp_errors.symptom_of(*an_error(evidence, f"src/main.cpp:1:1: error: {example}"))]


def from_linker(evidence: Evidence, example: str) -> list[Symptom]:
    return [cpp_errors.symptom_of(*an_error(evidence, f"CMakeFiles/robot.dir/src/main.cpp.o: {example}"))]


def from_compiler_of_a_package(build: Build, example: str) -> list[Symptom]:
    return [build_errors.symptom_in(build, an_error(build, f"src/main.cpp:1:1: error: {example}")[0])]


def from_linker_of_a_package(build: Build, example: str) -> list[Symptom]:
    log = f"CMakeFiles/robot.dir/src/main.cpp.o: {example}"
    return [build_errors.symptom_in(build, an_error(build, log)[0])]


def an_error(evidence: Evidence, log: str) -> tuple[CppError, Location | None]:
    error = first_error(log.splitlines(), evidence.own_file)
    assert error
    return error, evidence.place(error.file, error.line) if error.file and error.line else None


def from_python(evidence: Evidence, example: str) -> list[Symptom]:
    """In the line that ends with `# here`, else in the first one."""
    lines = evidence.sources.files.get(f"{FOLDER}/talk/talker.py", "").splitlines()
    number = next((n for n, line in enumerate(lines, start=1) if line.endswith("# here")), 1)
    return [Symptom(example, evidence.place("talk/talker.py", number), (example,))]


TABLES = {
    "Python": Table(python_errors.EXCEPTIONS, from_python, "ament_python"),
    "setup.py, files": Table(setup_py.OF_FILES, as_lines, "ament_python"),
    "setup.py": Table(setup_py.OF_SETUP, as_lines, "ament_python"),
    "interfaces": Table(interface_errors.INTERFACES, from_cmake),
    "types of interfaces": Table(interface_errors.TYPES, as_lines),
    "reserved words": Table(interface_errors.RESERVED, as_lines),
    "CMake, packages": Table((*cmake_errors.PACKAGES, *cmake_errors.AS_SAID), from_cmake),
    "CMake, projects": Table(cmake_errors.PROJECTS, from_cmake),
    "compiler": Table(cpp_errors.COMPILER, from_compiler),
    "compiler, packages": Table(
        build_errors.COMPILED, from_compiler_of_a_package, upto=len(build_errors.HEADERS)
    ),
    "linker": Table(cpp_errors.LINKER, from_linker),
    "linker, packages": Table(build_errors.LINKED, from_linker_of_a_package),
    "nothing installed": Table(build_errors.INSTALLED_NOTHING, as_lines),
}
ENTRIES = [
    (name, number) for name, table in TABLES.items() for number in range(len(table.known[: table.upto]))
]


def build_of(tmp_path: Path, known: Known[Any], type_: str) -> Build:
    """The package `talk` with the files of the entry, built with a small ROS."""
    made_up_ros(tmp_path / "ros")
    copy = tmp_path / "talk"
    files = {"package.xml": MANIFEST.format(type_), "src/main.cpp": "int main() {}\n"}
    files |= {LISTS: "cmake_minimum_required(VERSION 3.8)\nproject(talk)\n"} if type_ == "ament_cmake" else {}
    for name, text in {**files, **known.given}.items():
        (copy / name).parent.mkdir(parents=True, exist_ok=True)
        if text.startswith("-> "):
            (copy / name).symlink_to(text[3:])
        else:
            (copy / name).write_text(text)
    sources = read_copy(copy, FOLDER)
    found = manifest(sources, FOLDER)
    assert isinstance(found, Manifest)
    return Build(
        sources=sources,
        packages=BuiltPackages((BuiltPackage("talk", FOLDER, "/store/talk"),)),
        folder=FOLDER,
        name="talk",
        build_type=type_,
        manifest=found,
        copy=copy,
        lines=tuple(known.example.splitlines()),
        neighbors={"other": "src/other", "declared": "src/declared"},
        prefixes=(tmp_path / "ros",),
        ask_setup_py=tuple,
    )


@pytest.mark.parametrize(("name", "number"), ENTRIES, ids=[f"{name}-{number}" for name, number in ENTRIES])
def test_an_entry_explains_its_own_example(tmp_path: Path, name: str, number: int) -> None:
    table = TABLES[name]
    known = table.known[number]
    build = build_of(tmp_path, known, table.type)
    symptoms = table.read(build, known.example)
    found = explain(table.known, symptoms, build)
    assert found and found.known is known, f"{known.example!r} is taken by {found}"
    if WRITTEN is None:
        assert told(found) == golden()[name][number]
    else:
        WRITTEN.setdefault(name, []).append(told(found))
    broken = (*table.known[:number], replace(known, pattern=r"(?!)"), *table.known[number + 1 :])
    other = explain(broken, symptoms, build)
    assert other is None or told(other) != told(found)


def told(found: Explanation) -> str:
    places = " ".join(str(place).removeprefix(f"{FOLDER}/") for place in found.where)
    return " | ".join(part for part in (found.known.kind, found.cause, found.remedy, places) if part)


def test_the_file_holds_nothing_else() -> None:
    if WRITTEN is not None:
        lines = (f"== {name}\n" + "".join(f"{line}\n" for line in lines) for name, lines in WRITTEN.items())
        GOLDEN.write_text("\n".join(lines))
    assert {name: len(lines) for name, lines in golden().items()} == {
        name: len(table.known[: table.upto]) for name, table in TABLES.items()
    }


@cache
def golden() -> dict[str, list[str]]:
    tables: dict[str, list[str]] = {}
    for line in GOLDEN.read_text().splitlines():
        if line.startswith("== "):
            tables[line[3:]] = []
        elif line:
            list(tables.values())[-1].append(line)
    return tables


def test_a_word_that_is_not_known_silences_a_text() -> None:
    known = Known[Evidence]("a (?P<name>b)?", ("{near}", "{name}", "c ${X} { y }"), "a b")
    evidence = Evidence(sources=Sources({}))
    for text, remedy in (("a b", "b"), ("a c", "c ${X} { y }")):
        found = explain([known], [Symptom(text)], evidence)
        assert found and found.remedy == remedy
    assert explain([replace(known, cause="{near}")], [Symptom("a b")], evidence) is None
