"""The same class, with a property in the place of an attribute."""

from __future__ import annotations


class MinimalistClass:
    """Keeps its numbers in a dictionary."""

    attribute_reference = "Hello" + " "

    def __init__(self, attribute_arg: float = 10, private_attribute_arg: float = 20):
        """Keep both numbers."""
        self._numbers = {"public": attribute_arg, "private": private_attribute_arg}

    @property
    def attribute(self) -> float:
        """The first number."""
        return self._numbers["public"]

    @attribute.setter
    def attribute(self, value: float) -> None:
        self._numbers["public"] = value

    @property
    def _private_attribute(self) -> float:
        return self._numbers["private"]

    def method(self) -> float:
        """Return the sum."""
        return sum(self._numbers.values())

    def get_private_attribute(self) -> float:
        """Return the second number."""
        return self._numbers["private"]

    def set_private_attribute(self, value: float) -> None:
        """Replace the second number."""
        self._numbers.update(private=value)

    @classmethod
    def static_method(cls) -> str:
        """Return a greeting."""
        return cls.attribute_reference + "World!"
