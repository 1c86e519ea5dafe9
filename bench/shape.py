"""The shape of the engine in numbers: lines, files, names used twice, crumbs, lazy imports, circles.

A *crumb* is a file of at most 50 lines with a single importer. A *lazy import* is in a function. If you name
rooms, only these are counted: `bench/shape.py cli report`. `--list` shows what is counted.
`tests/test_shape.py` contains the limits.
"""

from __future__ import annotations

import argparse
import ast
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from statistics import median

REPO = Path(__file__).parents[1]
CRUMB = 50
# Names for a role, not for a topic. Every command has a file with its name.
NO_TOPIC = frozenset({"__init__", "__main__"})


@dataclass(frozen=True)
class Module:
    """name: dotted. file: where it is."""

    name: str
    file: Path

    @cached_property
    def text(self) -> str:
        return self.file.read_text(encoding="utf-8")

    @cached_property
    def tree(self) -> ast.Module:
        return ast.parse(self.text)

    @property
    def lines(self) -> int:
        return self.text.count("\n")

    @property
    def room(self) -> str:
        """`content` for `course.content.chapter`; empty for modules at the top."""
        parts = self.name.split(".")
        return parts[1] if len(parts) > 2 or (self.file.name == "__init__.py" and len(parts) > 1) else ""

    @property
    def base(self) -> str:
        return self.file.stem

    def classes(self) -> list[str]:
        """Names of public classes."""
        return [
            node.name
            for node in self.tree.body
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_")
        ]

    def lazy_imports(self) -> list[int]:
        """Lines of imports inside functions."""
        functions = (node for node in ast.walk(self.tree) if isinstance(node, ast.FunctionDef))
        nested = {
            node.lineno: node
            for function in functions
            for node in ast.walk(function)
            if isinstance(node, ast.Import | ast.ImportFrom)
        }
        return sorted(nested)


class Engine:
    """All modules of a package. An import from a package counts as an import of its `__init__`."""

    def __init__(self, root: Path = REPO / "course") -> None:
        self.root = root
        files = sorted(root.rglob("*.py"))
        self.modules = {name: Module(name, file) for file in files for name in [_name(file, root.parent)]}

    @cached_property
    def imports(self) -> Mapping[str, frozenset[str]]:
        """Which modules each module imports, at the top, in functions and under TYPE_CHECKING."""
        return {name: frozenset(self._imported(module)) - {name} for name, module in self.modules.items()}

    @cached_property
    def importers(self) -> Mapping[str, frozenset[str]]:
        found: dict[str, set[str]] = defaultdict(set)
        for name, targets in self.imports.items():
            for target in targets:
                found[target].add(name)
        return {name: frozenset(names) for name, names in found.items()}

    def crumbs(self) -> dict[str, str]:
        """Small files with a single importer, and that importer."""
        return {
            module.name: next(iter(self.importers[module.name]))
            for module in self.modules.values()
            if module.lines <= CRUMB and module.base not in NO_TOPIC and self._has_one_importer(module.name)
        }

    def shared_bases(self) -> dict[str, list[str]]:
        """Base names of several files. A command may have the name of its topic."""
        found: dict[str, list[str]] = defaultdict(list)
        for module in self.modules.values():
            if module.base not in NO_TOPIC and module.room != "cli":
                found[module.base].append(module.name)
        return {base: names for base, names in found.items() if len(names) > 1}

    def shared_classes(self) -> dict[str, list[str]]:
        """Public classes with the same name."""
        found: dict[str, list[str]] = defaultdict(list)
        for module in self.modules.values():
            for name in module.classes():
                found[name].append(module.name)
        return {name: names for name, names in found.items() if len(names) > 1}

    def circles(self) -> list[list[str]]:
        """Groups of modules that import each other. A package's `__init__` is left out."""
        graph = {
            name: {target for target in targets if not self._is_front_door(target)}
            for name, targets in self.imports.items()
            if not self._is_front_door(name)
        }
        return sorted(sorted(group) for group in _strongly_connected(graph) if len(group) > 1)

    def _has_one_importer(self, name: str) -> bool:
        return len(self.importers.get(name, ())) == 1

    def _is_front_door(self, name: str) -> bool:
        return self.modules[name].file.name == "__init__.py"

    def _imported(self, module: Module) -> Iterator[str]:
        for node in ast.walk(module.tree):
            if isinstance(node, ast.Import):
                yield from (alias.name for alias in node.names if alias.name in self.modules)
            elif isinstance(node, ast.ImportFrom):
                base = _absolute(module, node)
                for alias in node.names:
                    name = f"{base}.{alias.name}"
                    # `from course.batch.intake import look` means the function, if `__init__` has one.
                    if name in self.modules and not self._gives(base, alias.name):
                        yield name
                    elif base in self.modules:
                        yield base

    def _gives(self, package: str, name: str) -> bool:
        """Whether the package's `__init__` has something else with this name."""
        if package not in self.modules:
            return False
        nodes = self.modules[package].tree.body
        taken = (node for node in nodes if isinstance(node, ast.ImportFrom))
        return any(
            alias.name == name and (one.module or "").endswith(name) for one in taken for alias in one.names
        )


def _name(file: Path, parent: Path) -> str:
    parts = file.relative_to(parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _absolute(module: Module, node: ast.ImportFrom) -> str:
    if not node.level:
        return node.module or ""
    own = module.name.split(".")
    inside = own if module.file.name == "__init__.py" else own[:-1]
    parents = inside[: len(inside) - node.level + 1]
    return ".".join([*parents, *([node.module] if node.module else [])])


def _strongly_connected(graph: Mapping[str, Iterable[str]]) -> list[list[str]]:
    """Tarjan's algorithm."""
    index: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    found: list[list[str]] = []

    def visit(name: str) -> None:
        index[name] = low[name] = len(index)
        stack.append(name)
        for target in graph.get(name, ()):
            if target not in index:
                visit(target)
                low[name] = min(low[name], low[target])
            elif target in stack:
                low[name] = min(low[name], index[target])
        if low[name] == index[name]:
            group = []
            while not group or group[-1] != name:
                group.append(stack.pop())
            found.append(group)

    for name in graph:
        if name not in index:
            visit(name)
    return found


def figures(engine: Engine, rooms: Sequence[str] = ()) -> list[tuple[str, int, list[str]]]:
    """Each figure with what it counts."""

    def here(name: str) -> bool:
        return not rooms or engine.modules[name].room in rooms

    modules = [module for name, module in engine.modules.items() if here(name)]
    lazy = [f"{one.name}:{line}" for one in modules for line in one.lazy_imports()]
    imports = sum(
        isinstance(node, ast.Import | ast.ImportFrom) for one in modules for node in ast.walk(one.tree)
    )
    crumbs = [f"{name} (of {by})" for name, by in engine.crumbs().items() if here(name)]
    bases = [
        f"{base}: {', '.join(names)}"
        for base, names in engine.shared_bases().items()
        if any(map(here, names))
    ]
    classes = [
        f"{name}: {', '.join(names)}"
        for name, names in engine.shared_classes().items()
        if any(map(here, names))
    ]
    circles = [" <-> ".join(group) for group in engine.circles() if any(map(here, group))]
    return [
        ("lines", sum(one.lines for one in modules), []),
        ("files", len(modules), []),
        ("median lines of a file", round(median(one.lines for one in modules)), []),
        ("files under 30 lines", sum(one.lines < 30 for one in modules), []),
        (f"files of at most {CRUMB} lines with one importer", len(crumbs), crumbs),
        ("statements that import", imports, []),
        ("of these, in functions", len(lazy), [f"{name}: {count}" for name, count in _counted(lazy)]),
        ("base names of several files", len(bases), bases),
        ("public class names defined several times", len(classes), classes),
        ("import circles", len(circles), circles),
    ]


def _counted(places: Iterable[str]) -> list[tuple[str, int]]:
    return Counter(place.rpartition(":")[0] for place in places).most_common()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rooms", nargs="*", help="only these rooms of the engine")
    parser.add_argument("--list", action="store_true", help="show what is counted")
    options = parser.parse_args()
    engine = Engine()
    for title, count, items in figures(engine, options.rooms):
        print(f"{title:<52} {count:>7,}")
        for item in items if options.list else ():
            print(f"    {item}")


if __name__ == "__main__":
    main()
