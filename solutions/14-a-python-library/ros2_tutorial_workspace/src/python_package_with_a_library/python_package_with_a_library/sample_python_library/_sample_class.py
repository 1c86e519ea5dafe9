"""A class for others to use."""


class SampleClass:
    """Keeps a name."""

    def __init__(self, name: str) -> None:
        self._name = name

    def get_name(self) -> str:
        """Return the name that the object was made with."""
        return self._name
