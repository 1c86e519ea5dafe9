"""A name that no one else has."""

from __future__ import annotations

import os
import random
import socket

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class AnonName(Substitution):
    """The same for the same `name` within one launch."""

    def __init__(self, name: object) -> None:
        self.__name = texts(name)

    @property
    def name(self) -> list[Substitution]:
        return self.__name

    def describe(self) -> str:
        return "AnonName({})".format(" + ".join(sub.describe() for sub in self.__name))

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self.__name)
        key = f"anon{name}"
        if key not in context.launch_configurations:
            context.launch_configurations[key] = _unique(name)
        return str(context.launch_configurations[key])


def _unique(name: str) -> str:
    host = "".join(c if c.isalnum() else "_" for c in socket.gethostname())
    return f"{name}_{host}_{os.getpid()}_{random.randint(0, 2**31)}"
