"""Names that must not occur twice."""

from __future__ import annotations


class Names:
    """Hands out names: the second `ada` is `ada (2)`."""

    def __init__(self) -> None:
        self._taken: set[str] = set()

    def unique(self, name: str) -> str:
        found, count = name, 1
        while found in self._taken:
            count += 1
            found = f"{name} ({count})"
        self._taken.add(found)
        return found
