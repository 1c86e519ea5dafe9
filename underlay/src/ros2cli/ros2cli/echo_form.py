"""How `echo` shows a message."""

from __future__ import annotations

import builtins
from argparse import Namespace
from collections.abc import Callable
from typing import Any

from ros2cli.errors import CommandError
from ros2cli.form_arguments import limits

_INFO = ("source_timestamp", "received_timestamp", "publication_sequence_number", "reception_sequence_number")


class Form:
    """What the options ask for: YAML, CSV, one field or the bytes, and which messages at all."""

    def __init__(self, args: Namespace) -> None:
        self._args = args
        self._fields = args.field.split(".") if args.field else []
        self._wants = wanted(args.filter_expr)
        self._limits = limits(args)

    def show(self, message: Any, info: dict[str, Any]) -> bool:
        """Print the message; False when the filter left it out."""
        part = self._part(message)
        if not self._wants(part):
            return False
        if self._args.csv and is_message(part):
            self._show_csv(part, info)
        elif is_message(part):
            self._show_yaml(part, info)
        else:
            self._show_value(part, info)
        return True

    def _part(self, message: Any) -> Any:
        for field in self._fields:
            try:
                message = getattr(message, field)
            except AttributeError as error:
                raise CommandError(f"Invalid field '{self._args.field}': {error}") from error
        return message

    def _show_value(self, value: Any, info: dict[str, Any]) -> None:
        if self._args.include_message_info:
            print(f"---Got new message, message info:---\n{info}\n---Message data:---")
        print(value, end="\n---\n")

    def _show_csv(self, message: Any, info: dict[str, Any]) -> None:
        from rosidl_runtime_py import message_to_csv

        before = [str(info.get(name)) for name in _INFO] if self._args.include_message_info else []
        print(",".join([*before, message_to_csv(message, **self._limits)]))

    def _show_yaml(self, message: Any, info: dict[str, Any]) -> None:
        import yaml
        from rosidl_runtime_py import message_to_yaml

        if self._args.include_message_info:
            print(yaml.dump(info), end="---\n")
        print(message_to_yaml(message, **self._limits, flow_style=self._args.flow_style), end="---\n")


def is_message(value: Any) -> bool:
    return hasattr(value, "get_fields_and_field_types")


def wanted(expression: str | None) -> Callable[[Any], bool]:
    """Whether the expression is true of a message, which it calls `m`."""
    if expression is None:
        return lambda message: True
    try:
        code = compile(expression, "<filter>", "eval")
    except (SyntaxError, ValueError) as error:
        raise CommandError(f"Invalid filter expression '{expression}': {error}") from error
    names = vars(builtins)
    return lambda message: bool(_evaluated(code, {"__builtins__": names, "m": message}, expression))


def _evaluated(code: Any, names: dict[str, Any], expression: str) -> Any:
    try:
        return eval(code, names)
    except Exception as error:  # what a learner's expression raises is not known beforehand
        raise CommandError(f"Invalid filter expression '{expression}': {error}") from error
