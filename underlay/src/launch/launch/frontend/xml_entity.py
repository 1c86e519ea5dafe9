"""Launch files in XML."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

from launch.frontend.entity import Entity

_SEPARATOR = "-sep"


class XmlEntity(Entity):
    """`value="1,2" value-sep=","` is a list."""

    def __init__(self, element: ElementTree.Element) -> None:
        super().__init__(element.tag)
        self._element = element

    @property
    def children(self) -> list[Entity]:
        self._read |= {child.tag for child in self._element}
        return [XmlEntity(child) for child in self._element]

    def assert_entity_completely_parsed(self) -> None:
        attributes = set(self._element.attrib) - self._read
        if attributes:
            raise ValueError(f"Unexpected attribute(s) found in `{self.type_name}`: {attributes}")
        below = {child.tag for child in self._element} - self._read
        if below:
            raise ValueError(f"Unexpected nested entity(ies) found in `{self.type_name}`: {below}")

    def _names(self) -> set[str]:
        return {*self._element.attrib, *(child.tag for child in self._element)}

    def _value(self, name: str) -> Any:
        value = self._element.attrib.get(name)
        separator = self._element.attrib.get(name + _SEPARATOR)
        if value is None or separator is None:
            return value
        self._read.add(name + _SEPARATOR)
        return value.split(separator)

    def _below(self, name: str) -> list[Entity] | None:
        return [XmlEntity(child) for child in self._element if child.tag == name] or None


def load_xml(path: Path) -> Entity:
    """Raises ElementTree.ParseError, which names line and column."""
    return XmlEntity(ElementTree.parse(path).getroot())
