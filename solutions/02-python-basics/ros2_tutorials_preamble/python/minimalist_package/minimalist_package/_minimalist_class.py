"""A class as small as a class can be, and still show everything."""


class MinimalistClass:
    """Holds two numbers, of which one is meant for the class alone."""

    attribute_reference: str = "Hello "

    def __init__(self, attribute_arg: float = 10.0, private_attribute_arg: float = 20.0) -> None:
        """Keep both numbers."""
        self.attribute: float = attribute_arg
        self._private_attribute: float = private_attribute_arg

    def method(self) -> float:
        """Return the sum of both numbers."""
        return self.attribute + self._private_attribute

    def get_private_attribute(self) -> float:
        """Return the number that is not to be touched from outside."""
        return self._private_attribute

    def set_private_attribute(self, private_attribute_arg: float) -> None:
        """Replace the number that is not to be touched from outside."""
        self._private_attribute = private_attribute_arg

    @staticmethod
    def static_method() -> str:
        """Return a greeting, which takes no object."""
        return "Hello World!"
