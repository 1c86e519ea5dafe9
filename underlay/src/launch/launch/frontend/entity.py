"""One tag of a launch file: its attributes, and the tags below it."""

from __future__ import annotations

import typing
from typing import Any

from launch.frontend.type_utils import typed_attribute


class Entity:
    """Remembers what was asked for: whatever nobody asked for is a mistake of the file."""

    _is_typed = False  # whether the file tells a number from a text

    def __init__(self, type_name: str) -> None:
        self.__type_name = type_name
        self._read: set[str] = set()

    @property
    def type_name(self) -> str:
        return self.__type_name

    @property
    def children(self) -> list[Entity]:
        """All tags below this one."""
        raise NotImplementedError

    def get_attr(
        self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True
    ) -> Any:
        """An attribute, as a `data_type`; with List[Entity], the tags of that name below.

        A text that holds substitutions comes as it is. None if it is `optional` and absent.
        """
        self._read.add(name)
        found = self._below(name) if _is_entities(data_type) else self._attribute(name, data_type)
        if found is None and not optional:
            raise AttributeError(
                f"Attribute '{name}' of type '{data_type}' not found in Entity '{self.type_name}'"
            )
        return found

    def _attribute(self, name: str, data_type: Any) -> Any:
        value = self._value(name)
        if value is None or (data_type is None and self._is_typed):
            return value
        return typed_attribute(value, data_type, f"Attribute '{name}' of Entity '{self.type_name}'")

    def assert_entity_completely_parsed(self) -> None:
        unread = self._names() - self._read
        if unread:
            raise ValueError(f"Unexpected key(s) found in `{self.type_name}`: {sorted(unread)}")

    def read_all(self) -> None:
        """Whatever is in there is all right."""
        self._read |= self._names()

    def _names(self) -> set[str]:
        """The names of all that is in there."""
        raise NotImplementedError

    def _value(self, name: str) -> Any:
        """A text or, where the file can say so, another value or a list of them; None if absent."""
        raise NotImplementedError

    def _below(self, name: str) -> list[Entity] | None:
        """The tags of a name; None if there are none."""
        raise NotImplementedError


def _is_entities(data_type: Any) -> bool:
    inner = typing.get_args(data_type)
    return bool(inner) and isinstance(inner[0], type) and issubclass(inner[0], Entity)
