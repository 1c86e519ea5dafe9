"""Which substitution a name in a launch file stands for."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from launch import substitutions as kinds
from launch.frontend.expose import load_extensions, substitution_parsers
from launch.substitution import Substitution
from launch.substitutions.command import Command
from launch.substitutions.python_expression import PythonExpression
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.substitutions.text_substitution import TextSubstitution

if TYPE_CHECKING:
    from launch.frontend.parse_substitution import Argument

Builders = Mapping[str, Callable[..., Substitution]]


BUILDERS: Builders = {
    "all": lambda *parts: kinds.AllSubstitution(*parts),
    "and": lambda left, right: kinds.AndSubstitution(left, right),
    "anon": lambda name: kinds.AnonName(name),
    "any": lambda *parts: kinds.AnySubstitution(*parts),
    "dirname": lambda: kinds.ThisLaunchFileDir(),
    "env": lambda name, default=None: kinds.EnvironmentVariable(name, default_value=default),
    "equals": lambda left, right: kinds.EqualsSubstitution(left, right),
    "file-content": lambda path: kinds.FileContent(path),
    "filename": lambda: kinds.ThisLaunchFile(),
    "find-exec": lambda name: kinds.FindExecutable(name=name),
    "for-var": lambda name, default=None: kinds.ForEachVar(name, default_value=default),
    "if": lambda condition, *values: kinds.IfElseSubstitution(condition, *values),
    "index": lambda name: kinds.ForLoopIndex(name),
    "launch_log_dir": lambda: kinds.LaunchLogDir(),
    "log_dir": lambda: kinds.LaunchLogDir(),
    "not": lambda value: kinds.NotSubstitution(value),
    "not-equals": lambda left, right: kinds.NotEqualsSubstitution(left, right),
    "optenv": lambda name, default="": kinds.EnvironmentVariable(name, default_value=default),
    "or": lambda left, right: kinds.OrSubstitution(left, right),
    "path-join": lambda *parts: kinds.PathJoinSubstitution(parts),
    "string-join": lambda between, *parts: kinds.StringJoinSubstitution(parts, delimiter=between),
    "var": lambda name, default=None: kinds.LaunchConfiguration(name, default=default),
}


def substitution(name: str, arguments: list[Argument]) -> Substitution:
    """Raises SubstitutionFailure where there is none of that name, or its arguments are wrong."""
    if name == "eval":
        return _evaluation(arguments)
    if name == "command":
        return _command(arguments)
    builder = _builder(name)
    try:
        return builder(*(argument.parts for argument in arguments))
    except TypeError as error:
        given = len(arguments)
        raise SubstitutionFailure(f"{name} substitution does not take {given} argument(s)") from error


def _builder(name: str) -> Callable[..., Substitution]:
    for builders in (BUILDERS, _of_ros()):
        if name in builders:
            return builders[name]
    if name not in substitution_parsers:
        load_extensions()
    if name not in substitution_parsers:
        raise SubstitutionFailure(f"Unknown substitution: {name}")
    return lambda *data: _made(substitution_parsers[name](data))


def _made(parsed: tuple[Any, Mapping[str, Any]]) -> Substitution:
    kind, kwargs = parsed
    made: Substitution = kind(**kwargs)
    return made


def _of_ros() -> Builders:
    if importlib.util.find_spec("launch_ros") is None:
        return {}
    module = importlib.import_module("launch_ros.frontend")
    builders: Builders = module.SUBSTITUTIONS
    return builders


def _evaluation(arguments: list[Argument]) -> Substitution:
    """An expression in quotes, perhaps with modules to import; or one without, whose quotes are Python's."""
    if len(arguments) == 1:
        return PythonExpression(arguments[0].parts)
    if len(arguments) == 2 and all(argument.quote for argument in arguments):
        return PythonExpression(arguments[0].parts, [arguments[1].parts])
    return PythonExpression(_joined(arguments))


def _command(arguments: list[Argument]) -> Substitution:
    if len(arguments) == 2 and arguments[0].quote:
        return Command(arguments[0].parts, on_stderr=arguments[1].parts)
    return Command(arguments[0].parts if len(arguments) == 1 else _joined(arguments))


def _joined(arguments: list[Argument]) -> list[Substitution]:
    """As it was written: with quotes, and spaces between."""
    joined: list[Substitution] = []
    for argument in arguments:
        blank = " " if joined else ""
        joined += [TextSubstitution(text=blank + argument.quote), *argument.parts]
        joined += [TextSubstitution(text=argument.quote)] if argument.quote else []
    return joined
