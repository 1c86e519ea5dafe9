"""Programs and packages with names that no exercise asks for, recognized by reading their files."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice

from course.batch.intake.recognize import LARGEST_MANIFEST, made_of
from course.batch.intake.submission import Found
from course.batch.intake.tree import content, read_tree
from course.content import Exercise
from course.evidence.sources import Sources, read_sources
from course.explain.package_xml import Manifest, name_in, read_manifest
from course.explain.python_code import calls
from course.explain.setup_py import EntryPoint, entry_points
from course.home.opening import Remark
from course.model import replace

# What tells one node from another.
_KINDS = ("create_publisher", "create_subscription", "create_service", "create_client")
# The most packages, and the most programs, of a submission that are looked into.
_MOST = 30
_NAME = re.compile(r"[\w.-]{1,100}", re.ASCII)
_BYTES = ("utf-8", "surrogateescape")
_SETUP = """\
from setuptools import setup
data_files = [('share/ament_index/resource_index/packages', ['resource/{0}']), ('share/{0}', ['package.xml'])]
setup(name='{0}', packages=[], data_files=data_files, entry_points={{'console_scripts': {1}}})
"""
_SETUP_CFG = "[develop]\nscript_dir=$base/lib/{0}\n[install]\ninstall_scripts=$base/lib/{0}\n"
AS_IF = "{} is graded as if {} were {}, for one point less."
ENTERED = "{} is graded as if a setup.py with the entry point `{}` had been handed in, for one point less."
UNCLEAR = "It is not clear which program is meant to be {}."


@dataclass(frozen=True)
class Program:
    """A console script. exercise: the one that asks for it. kinds: which of _KINDS it creates.

    setup: the setup.py that has its entry point.
    """

    exercise: str
    package: str
    folder: str
    entry: EntryPoint
    kinds: frozenset[str]
    setup: str

    @property
    def shown(self) -> str:
        return f"`{self.entry.name}` of `{self.package}`"


def own_packages(exercise: Exercise) -> Iterator[str]:
    """The packages in which the learner writes for this exercise."""
    for package in exercise.packages:
        if any(file.startswith(f"{exercise.workspace}/src/{package}/") for file in exercise.files):
            yield package


def asked_programs(exercise: Exercise) -> Iterator[Program]:
    """The solution's programs whose modules the exercise asks for, in packages that contain only programs."""
    for package in own_packages(exercise):
        folder = f"{exercise.workspace}/src/{package}"
        inside = [file.split("/")[3:] for file in exercise.files if file.startswith(f"{folder}/")]
        if all(len(parts) == 1 or parts[0] == package for parts in inside):
            for program in _programs(read_sources(exercise.solution, [folder]).files.get, folder, package):
                if program.entry.file_in(folder) in exercise.files:
                    yield replace(program, exercise=exercise.id)


def _programs(text: Callable[[str], str | None], folder: str, package: str) -> Iterator[Program]:
    setup = text(f"{folder}/setup.py") or ""
    for entry in _entries(folder, setup):
        if entry.is_sound and _NAME.fullmatch(entry.name):
            module = Sources({"module.py": text(entry.file_in(folder)) or ""})
            kinds = frozenset(kind for kind in _KINDS if calls(module, kind))
            yield Program("", package, folder, entry, kinds, setup)


def _entries(folder: str, setup: str) -> tuple[EntryPoint, ...]:
    return entry_points(Sources({f"{folder}/setup.py": setup}), folder)


def named_right(found: Found, graded: Iterable[Exercise], every: Sequence[Program]) -> Found:
    """Rename its programs as these exercises ask, if only one can be meant. every: all that are asked for."""
    ids = {exercise.id for exercise in graded}
    for package in dict.fromkeys(one.package for one in every if one.exercise in ids):
        found = _Naming(found, package, ids, every).named_right()
    return found


class _Naming:
    def __init__(self, found: Found, package: str, ids: set[str], every: Sequence[Program]) -> None:
        self._found = found
        self._package = package
        self._files = dict(made_of(read_tree(found.parts), found.places))
        folders = {
            name: file.rpartition("/")[0]
            for file in sorted(self._files)
            if file.endswith("/package.xml") and (name := name_in(self._text(file).encode(*_BYTES)))
        }
        self._is_there = package in folders
        others = folders.keys() - {one.package for one in every}
        few = [package] if self._is_there else sorted(filter(_NAME.fullmatch, others))[:_MOST]
        programs = (one for name in few for one in _programs(self._text, folders[name], name))
        self._programs = list(islice(programs, _MOST))
        right = {one.entry.name for one in self._programs if self._is_there}
        of = [one for one in every if one.package == package]
        self._taken = {one.entry.name for one in of}
        self._asked = [one for one in of if one.exercise in ids and one.entry.name not in right]

    def named_right(self) -> Found:
        if begun := self._without_setup():
            written = {f"{begun[0].folder}/setup.py": begun[-1].setup.encode(*_BYTES)}
            told = (ENTERED.format(one.exercise, one.entry.name) for one in begun)
            return self._told_and_written([Remark(what) for what in told], begun, written)
        chosen = {one: could for one in self._asked if (could := self._could_be(one))}
        sure = {one: could[0] for one, could in chosen.items() if len(could) == 1}
        programs = {*sure.values()}
        alone = len(programs) == len(sure) and len({one.package for one in programs}) == 1
        written = (self._edited(sure) if self._is_there else self._beside(sure)) if alone else {}
        done = tuple(sure) if written else ()
        return self._told_and_written([self._told(*each, done) for each in chosen.items()], done, written)

    def _without_setup(self) -> list[Program]:
        """Programs whose modules were handed in alone, and that the course's setup.py does not name."""
        alone = [one for one in self._asked if one.entry.file_in(one.folder) in self._files]
        if not alone or f"{alone[0].folder}/setup.py" in self._files:
            return []
        laid = (folder / "setup.py" for folder, place in self._found.beneath if place == alone[0].folder)
        setup = next((file.read_text(encoding="utf-8") for file in laid if file.is_file()), None)
        named = {entry.name for entry in _entries(alone[0].folder, setup or "")}
        return [one for one in alone if setup is not None and one.entry.name not in named]

    def _told_and_written(
        self, told: Iterable[Remark], done: Iterable[Program], written: Mapping[str, bytes]
    ) -> Found:
        renamed = dict.fromkeys((*self._found.person.renamed, *(one.exercise for one in done)))
        person = replace(self._found.person, renamed=tuple(renamed))
        found = replace(self._found, person=person, findings=(*told, *self._found.findings))
        return replace(found, written=(*found.written, *written.items()))

    def _could_be(self, asked: Program) -> list[Program]:
        """The programs that may be meant: by name, else those that create what it should, or might."""
        by_name = [one for one in self._programs if one.entry.name == asked.entry.name]
        free = [one for one in self._programs if one.entry.name not in self._taken]
        sure = [one for one in free if asked.kinds and asked.kinds <= one.kinds]
        return by_name or sure or [one for one in free if not one.kinds or asked.kinds <= one.kinds]

    def _told(self, asked: Program, could: Sequence[Program], done: Sequence[Program]) -> Remark:
        could_be = ", ".join(one.shown for one in could[:3])
        if asked in done:
            return Remark(AS_IF.format(asked.exercise, could_be, asked.shown))
        return Remark(UNCLEAR.format(asked.shown), where=could_be)

    def _edited(self, sure: dict[Program, Program]) -> dict[str, bytes]:
        """Rename the programs in setup.py. Return nothing if that would change more."""
        folder = next(iter(sure.values())).folder
        setup = self._text(f"{folder}/setup.py")
        names = {own.entry.name: asked.entry.name for asked, own in sure.items()}
        wanted = [(names.get(one.name, one.name), one.target) for one in _entries(folder, setup)]
        lines = setup.splitlines(keepends=True)
        for own in sure.values():
            line = (own.entry.where.line or 1) - 1
            lines[line] = lines[line].replace(own.entry.name, names[own.entry.name], 1)
        if [(one.name, one.target) for one in _entries(folder, "".join(lines))] != wanted:
            return {}
        return {f"{folder}/setup.py": "".join(lines).encode(*_BYTES)}

    def _beside(self, sure: dict[Program, Program]) -> dict[str, bytes]:
        """A package with the right name that contains only these programs of the other one."""
        asked, own = next(iter(sure.items()))
        named = f"<name>{self._package}</name><exec_depend>{own.package}</exec_depend>"
        text = self._text(f"{own.folder}/package.xml").replace(f"<name>{own.package}</name>", named)
        read = read_manifest(text.encode(*_BYTES))
        if not isinstance(read, Manifest) or read.name != self._package or asked.folder in self._files:
            return {}
        scripts = [f"{one.entry.name} = {its.entry.target}" for one, its in sure.items()]
        return {
            f"{asked.folder}/package.xml": text.encode(*_BYTES),
            f"{asked.folder}/setup.py": _SETUP.format(self._package, scripts).encode(),
            f"{asked.folder}/setup.cfg": _SETUP_CFG.format(self._package).encode(),
            f"{asked.folder}/resource/{self._package}": b"",
        }

    def _text(self, file: str) -> str:
        entry = self._files.get(file)
        data = content(entry) if entry and entry.size <= LARGEST_MANIFEST else None
        return (data or b"").decode(*_BYTES)
