"""What graders can use in the engine, read from its source: signatures and docstrings of `course.api`.

Nothing is imported, because some of it needs ROS, and a reference must not.
"""

from __future__ import annotations

import ast
import inspect
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from course.errors import UsageError
from course.spelling import did_you_mean

_ROOT = Path(__file__).parents[1]
_API = "course.api"
_ARENA = "course.arena.arena"
# The classes of objects that graders are given, and the names that graders use for these.
_SPOKEN = {"Arena": "arena", "ArenaNode": "arena.ros", "CppPrograms": "arena.cpp", "Recording": "recording"}
_PARTS = ("ArenaNode", "CppPrograms")
_TITLES = (
    ("What a scenario calls", ("Arena", *_PARTS)),
    ("What a check asks", ("Recording",)),
)
_EXPECTED, _FUNCTIONS = "What a check expects", "What else a grader calls"
_CLASSES, _CONSTANTS = "What all of these give", "Constants"
_HEAD = """# The API of graders

Everything that `course.api` offers, what each call takes, and what it returns. `ros2course api NAME` shows
one of them in the terminal. [Writing a grader](writing-a-grader.md) explains how they work together.

`./ros2course api --out docs/api.md` writes this page from the docstrings.
"""

Definition = ast.ClassDef | ast.FunctionDef


@dataclass(frozen=True)
class Entry:
    """One name. name: as graders write it. signature: what it takes and returns. text: its docstring.

    members: the public ones of a class. gives: names of the classes that it returns.
    """

    name: str
    signature: str
    text: str
    members: tuple[Entry, ...] = ()
    gives: tuple[str, ...] = ()

    @property
    def line(self) -> str:
        """The name and the first paragraph of its text; without a text, its signature."""
        text = " ".join(self.text.partition("\n\n")[0].split())
        return f"{self.name}: {text}" if text else self.signature


@dataclass(frozen=True)
class _Source:
    """A module of the engine. name: dotted."""

    name: str

    @cached_property
    def tree(self) -> ast.Module:
        return ast.parse(_file(self.name).read_text(encoding="utf-8"))

    @cached_property
    def imports(self) -> dict[str, tuple[str, str]]:
        """The imported names: for each, the module that it comes from, and its name there."""
        found = (node for node in ast.walk(self.tree) if isinstance(node, ast.ImportFrom))
        return {
            alias.asname or alias.name: (node.module or "", alias.name)
            for node in found
            if (node.module or "").partition(".")[0] == "course"
            for alias in node.names
        }

    @cached_property
    def definitions(self) -> dict[str, Definition]:
        otherwise = (node for one in self.tree.body if isinstance(one, ast.If) for node in one.orelse)
        every = (*self.tree.body, *otherwise)
        return {node.name: node for node in every if isinstance(node, ast.ClassDef | ast.FunctionDef)}

    @cached_property
    def values(self) -> dict[str, ast.expr]:
        """The values in `NAME = VALUE`, by name."""
        assigned = (node for node in self.tree.body if isinstance(node, ast.Assign))
        return {node.targets[0].id: node.value for node in assigned if isinstance(node.targets[0], ast.Name)}

    @property
    def known(self) -> set[str]:
        return {*self.imports, *self.definitions, *self.values}


def _file(module: str) -> Path:
    path = _ROOT.joinpath(*module.split(".")[1:])
    return path / "__init__.py" if path.is_dir() else path.with_suffix(".py")


class Reference:
    """The whole reference. sections: entries by title, in the order of the page."""

    def __init__(self) -> None:
        self._sources: dict[str, _Source] = {}
        self._classes: dict[str, tuple[_Source, ast.ClassDef]] = {}
        self._waiting: list[str] = []
        self.sections = self._read()

    def _read(self) -> dict[str, list[Entry]]:
        functions, constants = [], []
        for name in _SPOKEN:
            source, found = self._find(_ARENA if name in _PARTS else _API, name)
            assert isinstance(found, ast.ClassDef), name
            self._known(source, found)
        for name in sorted(self._source(_API).imports):
            source, found = self._find(_API, name)
            if isinstance(found, ast.FunctionDef):
                functions.append(self._function(source, name, found))
            elif isinstance(found, ast.ClassDef):
                self._known(source, found)
            elif found is None:
                functions += self._functions_of(source, name)
            else:
                constants.append(Entry(name, f"{name} = {ast.unparse(found)}", ""))
        spoken = {title: [self._class(name) for name in names] for title, names in _TITLES}
        listed = [name for _, names in _TITLES for name in names]
        classes = []
        while self._waiting:
            name = self._waiting.pop(0)
            if name not in listed:
                classes.append(self._class(name))
        classes.sort(key=lambda entry: entry.name)
        expected = [entry for entry in functions if entry.name.startswith("expect_")]
        others = [entry for entry in functions if entry not in expected]
        return {**spoken, _EXPECTED: expected, _FUNCTIONS: others, _CLASSES: classes, _CONSTANTS: constants}

    def _functions_of(self, source: _Source, name: str) -> list[Entry]:
        public = (one for short, one in source.definitions.items() if not short.startswith("_"))
        functions = (one for one in public if isinstance(one, ast.FunctionDef))
        return [self._function(source, f"{name}.{one.name}", one) for one in functions]

    def _source(self, module: str) -> _Source:
        return self._sources.setdefault(module, _Source(module))

    def _find(self, module: str, name: str) -> tuple[_Source, Definition | ast.expr | None]:
        """Where and how a name is defined; None for a module."""
        source = self._source(module)
        if name in source.definitions:
            return source, source.definitions[name]
        if name in source.values:
            return source, source.values[name]
        above, there = source.imports[name]
        if _file(f"{above}.{there}").is_file() and there not in self._source(above).definitions:
            return self._source(f"{above}.{there}"), None
        return self._find(above, there)

    def _known(self, source: _Source, found: ast.ClassDef) -> str:
        if found.name not in self._classes:
            self._classes[found.name] = source, found
            self._waiting.append(found.name)
        return found.name

    def _class(self, name: str) -> Entry:
        source, found = self._classes[name]
        spoken = _SPOKEN.get(name, name)
        members: dict[str, Entry] = {}
        for above, one in self._family(source, found):
            for member in self._members(above, one, spoken):
                members.setdefault(member.name, member)
        return Entry(spoken, spoken, _text(found), tuple(members.values()))

    def _family(self, source: _Source, found: ast.ClassDef) -> Iterator[tuple[_Source, ast.ClassDef]]:
        yield source, found
        for base in found.bases:
            if isinstance(base, ast.Name) and (base.id in source.imports or base.id in source.definitions):
                above, parent = self._find(source.name, base.id)
                if isinstance(parent, ast.ClassDef):
                    yield from self._family(above, parent)

    def _members(self, source: _Source, found: ast.ClassDef, spoken: str) -> Iterator[Entry]:
        for node in found.body:
            if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
                if not node.target.id.startswith("_"):
                    kind, gives = self._annotation(source, node.annotation)
                    name = f"{spoken}.{node.target.id}"
                    yield Entry(name, f"{name}: {kind}", "", (), gives)
            elif isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
                marks = {ast.unparse(mark) for mark in node.decorator_list}
                if marks & {"property", "cached_property"}:
                    kind, gives = self._annotation(source, node.returns)
                    name = f"{spoken}.{node.name}"
                    yield Entry(name, f"{name}: {kind}", _text(node), (), gives)
                elif not marks & {"classmethod", "staticmethod"}:
                    yield self._function(source, f"{spoken}.{node.name}", node)

    def _function(self, source: _Source, name: str, node: ast.FunctionDef) -> Entry:
        every = node.args
        plain = [one for one in (*every.posonlyargs, *every.args) if one.arg != "self"]
        optional = [None] * (len(plain) - len(every.defaults)) + list(every.defaults)
        words = [self._argument(source, *pair) for pair in zip(plain, optional, strict=True)]
        if every.vararg:
            words.append("*" + self._argument(source, every.vararg, None))
        elif every.kwonlyargs:
            words.append("*")
        words += [self._argument(source, *p) for p in zip(every.kwonlyargs, every.kw_defaults, strict=True)]
        if every.kwarg:
            words.append("**" + self._argument(source, every.kwarg, None))
        kind, gives = self._annotation(source, node.returns)
        back = "" if kind == "None" else f" -> {kind}"
        return Entry(name, f"{name}({', '.join(words)}){back}", _text(node), (), gives)

    def _argument(self, source: _Source, one: ast.arg, default: ast.expr | None) -> str:
        kind, _ = self._annotation(source, one.annotation, returned=False)
        if isinstance(default, ast.Name):  # of a constant, the value is more useful
            constant = self._find(source.name, default.id)[1] if default.id in source.known else None
            default = constant if isinstance(constant, ast.Constant) else default
        value = "" if default is None else f" = {ast.unparse(default)}"
        return f"{one.arg}: {kind}{value}"

    def _annotation(
        self, source: _Source, node: ast.expr | None, *, returned: bool = True
    ) -> tuple[str, tuple[str, ...]]:
        """A type as text, with aliases written out, and the names of our classes in it."""
        if node is None:
            return "Any", ()
        gives = []
        whole = ast.parse(ast.unparse(node), mode="eval").body
        for name in [one.id for one in ast.walk(whole) if isinstance(one, ast.Name)]:
            if name not in source.known:
                continue
            above, found = self._find(source.name, name)
            if isinstance(found, ast.ClassDef):
                if returned or found.name in self._classes:
                    gives.append(self._known(above, found))
            elif isinstance(found, ast.Subscript | ast.BinOp):
                whole = _Written(name, found).visit(whole)
        return ast.unparse(whole), tuple(_SPOKEN.get(name, name) for name in dict.fromkeys(gives))

    def entries(self) -> Iterator[Entry]:
        for section in self.sections.values():
            for entry in section:
                yield entry
                yield from entry.members

    def named(self, name: str) -> tuple[Entry, ...]:
        """The entries with this name, in full (`recording.topic`) or only its last part (`topic`).

        Raises UsageError if there are none.
        """
        every = tuple(self.entries())
        plain = name.removesuffix("()")
        found = tuple(entry for entry in every if entry.name == plain)
        found = found or tuple(entry for entry in every if entry.name.rpartition(".")[2] == plain)
        if not found:
            known = {entry.name for entry in every} | {entry.name.rpartition(".")[2] for entry in every}
            what = f"there is no `{name}` for graders{did_you_mean(plain, known)}"
            raise UsageError(what, "`ros2course api` lists all names")
        return found


class _Written(ast.NodeTransformer):
    """Replaces an alias with what it stands for."""

    def __init__(self, name: str, value: ast.expr) -> None:
        self._name, self._value = name, value

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return self._value if node.id == self._name else node


def _text(node: Definition) -> str:
    return inspect.cleandoc(ast.get_docstring(node) or "")


def as_page(reference: Reference) -> str:
    """The whole reference as Markdown."""
    pieces = [_HEAD]
    for title, entries in reference.sections.items():
        pieces.append(f"\n## {title}\n")
        if title == _CONSTANTS:
            pieces += [f"\n- `{entry.signature}`" for entry in entries]
            continue
        pieces += [f"\n### {entry.name}\n\n{as_markdown(entry)}" for entry in entries]
    return "".join(pieces).rstrip() + "\n"


def as_markdown(entry: Entry) -> str:
    """One entry: a class with its members, or a function with its whole text."""
    signature = "" if entry.members else f"```python\n{entry.signature}\n```\n\n"
    members = "".join(f"\n- `{one.signature}`{_told(one)}\n" for one in entry.members)
    return f"{signature}{entry.text}\n{members}"


def _told(entry: Entry) -> str:
    text = " ".join(entry.text.split())
    return f": {text}" if text else ""
