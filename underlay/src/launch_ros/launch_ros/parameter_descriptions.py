"""Parameters with more to say than a dict can: a type, or substitutions within a file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions

from launch_ros.utilities.temporary_files import temporary_file
from launch_ros.utilities.typed_value import typed


class ParameterValue:
    """A value whose type is said: `value_type` is bool, int, float, str or List[...] of one; None guesses."""

    def __init__(self, value: Any, *, value_type: Any = None) -> None:
        self.__value = value
        self.__value_type = value_type

    @property
    def value(self) -> Any:
        return self.__value

    @property
    def value_type(self) -> Any:
        return self.__value_type

    def evaluate(self, context: LaunchContext) -> Any:
        from launch_ros.utilities.parameter_forms import normalize_value
        from launch_ros.utilities.parameter_values import evaluate_value

        normal = normalize_value(self.__value)
        return evaluate_value(context, normal, self.__value_type)


class Parameter:
    """A single parameter, handed over as `-p name:=value`."""

    def __init__(
        self, name: object, value: Any, *, value_type: Any = None, description: object | None = None
    ) -> None:
        self.__name = texts(name)
        self.__value = ParameterValue(value, value_type=value_type)

    @property
    def name(self) -> list[Substitution]:
        return self.__name

    @property
    def value(self) -> Any:
        return self.__value.value

    def evaluate(self, context: LaunchContext) -> tuple[str, Any]:
        return perform_substitutions(context, self.__name), self.__value.evaluate(context)


class ParameterFile:
    """A YAML file. With `allow_substs`, `$(var name)` and the like in it are replaced first."""

    def __init__(self, param_file: object, *, allow_substs: object = False) -> None:
        self.__param_file = texts(param_file)
        self.__allow_substs = allow_substs

    @property
    def param_file(self) -> list[Substitution]:
        return self.__param_file

    @property
    def allow_substs(self) -> object:
        return self.__allow_substs

    def evaluate(self, context: LaunchContext) -> Path:
        from launch.frontend.parse_substitution import parse_substitution

        path = Path(perform_substitutions(context, self.__param_file))
        if not self._allows(context):
            return path
        parts = parse_substitution(path.read_text(encoding="utf-8"))
        return temporary_file(perform_substitutions(context, parts))

    def _allows(self, context: LaunchContext) -> bool:
        given = self.__allow_substs
        value = given if isinstance(given, bool) else perform_substitutions(context, texts(given))
        return bool(typed(str(value), bool))
