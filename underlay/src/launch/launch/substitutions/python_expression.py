"""What an expression in Python gives."""

from __future__ import annotations

import importlib
from collections.abc import Iterable

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions


class PythonExpression(Substitution):
    """The names of the modules can be used; so can `math`, and its functions by their bare names."""

    def __init__(self, expression: object, python_modules: Iterable[object] = ("math",)) -> None:
        self.__expression = texts(expression)
        modules = [python_modules] if isinstance(python_modules, str) else python_modules
        self.__modules = [texts(module) for module in modules]

    @property
    def expression(self) -> list[Substitution]:
        return self.__expression

    @property
    def python_modules(self) -> list[list[Substitution]]:
        return self.__modules

    def describe(self) -> str:
        return "PythonExpr({})".format(" + ".join(sub.describe() for sub in self.__expression))

    def perform(self, context: LaunchContext) -> str:
        names: dict[str, object] = {}
        for module in self.__modules:
            name = perform_substitutions(context, module)
            names[name] = importlib.import_module(name)
            names.update(vars(names[name]) if name == "math" else {})
        return str(eval(perform_substitutions(context, self.__expression), {}, names))
