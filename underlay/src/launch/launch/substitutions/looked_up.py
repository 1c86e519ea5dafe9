"""What substitutions that look a value up by its name have in common."""

from __future__ import annotations

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities import perform_substitutions


class LookedUp(Substitution):
    """`default` is taken where there is nothing of that name; without one it must be there."""

    _shown = ""  # in descriptions; the class's own name if empty
    _missing = "'{}' does not exist"

    def __init__(self, name: object, default: object | None) -> None:
        self._name = texts(name)
        self._default = None if default is None else texts(default)

    @property
    def name(self) -> list[Substitution]:
        return self._name

    @property
    def default_value(self) -> list[Substitution] | None:
        return self._default

    def describe(self) -> str:
        name = " + ".join(sub.describe() for sub in self._name)
        return f"{self._shown or type(self).__name__}({name})"

    def perform(self, context: LaunchContext) -> str:
        name = perform_substitutions(context, self._name)
        found = self._find(context, name)
        if found is not None:
            return str(found)
        if self._default is None:
            raise SubstitutionFailure(self._missing.format(name))
        return perform_substitutions(context, self._default)

    def _find(self, context: LaunchContext, name: str) -> object | None:
        """The value; None if there is none."""
        raise NotImplementedError
