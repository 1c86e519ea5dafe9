"""The optional tools: packages in `extras/`, beside the engine. Nothing else in the engine imports them."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

from course.cli.usage import installing
from course.errors import MissingHere


def extra(name: str, module: str = "command") -> ModuleType:
    """A module of the optional tool `similar`, `mutation` or `cluster`; by default, its commands.

    Raises MissingHere, with the command that installs it, when a package that it needs is missing.
    """
    try:
        return import_module(f"course_{name}.{module}")
    except ModuleNotFoundError as error:
        raise MissingHere(
            f"This needs the Python package `{error.name}`, which is not installed.",
            f"`{installing(name)}` installs it.",
        ) from error
