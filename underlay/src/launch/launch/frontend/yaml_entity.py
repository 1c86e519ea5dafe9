"""Launch files in YAML."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

from launch.frontend.entity import Entity


class YamlEntity(Entity):
    """A mapping of attributes, in which `children` are the tags below, or a list of these alone."""

    _is_typed = True

    def __init__(self, element: Any, type_name: str) -> None:
        super().__init__(type_name)
        self._element = element

    @property
    def children(self) -> list[Entity]:
        self._read.add("children")
        below = self._element.get("children", ()) if isinstance(self._element, dict) else self._element
        return [_tag(child, self.type_name) for child in below or ()]

    def _names(self) -> set[str]:
        return set(self._element) if isinstance(self._element, dict) else set()

    def _value(self, name: str) -> Any:
        return self._element.get(name) if isinstance(self._element, dict) else None

    def _below(self, name: str) -> list[Entity] | None:
        found = self._value(name)
        if found is None:
            return None
        if not isinstance(found, list):
            raise TypeError(f"Attribute '{name}' of Entity '{self.type_name}' is expected to be a list")
        return [YamlEntity(each, name) for each in found]


def load_yaml(path: Path) -> Entity:
    """Raises yaml.YAMLError, which names line and column."""
    with path.open(encoding="utf-8") as file:
        tree = yaml.safe_load(file)
    if not isinstance(tree, dict) or len(tree) != 1:
        raise RuntimeError("Expected only one root")
    ((name, element),) = tree.items()
    return YamlEntity(element, str(name))


def _tag(child: Any, above: str) -> Entity:
    if not isinstance(child, dict) or len(child) != 1:
        raise RuntimeError(f"Subentities of `{above}` must be dictionaries with only one key: {child!r}")
    ((name, element),) = child.items()
    return YamlEntity(element, str(name))
