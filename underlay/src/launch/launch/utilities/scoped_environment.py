"""The environment of a launch is this process's own, with copies put by for the scopes of groups."""

from __future__ import annotations

import os
from collections.abc import Mapping


class EnvironmentStack:
    """Copies of the environment, the newest last."""

    def __init__(self) -> None:
        self._first = dict(os.environ)
        self._stack: list[dict[str, str]] = []

    def push(self) -> None:
        self._stack.append(dict(os.environ))

    def pop(self) -> None:
        if not self._stack:
            raise RuntimeError("environment stack unexpectedly empty")
        self.replace(self._stack.pop())

    def reset(self) -> None:
        """Back to what it was when the launch began."""
        self.replace(self._first)

    def replace(self, environment: Mapping[str, str]) -> None:
        wanted = dict(environment)
        for name in set(os.environ) - set(wanted):
            del os.environ[name]
        os.environ.update(wanted)
