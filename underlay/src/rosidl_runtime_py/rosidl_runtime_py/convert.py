"""Messages as YAML, as one line of CSV, and as dictionaries."""

from __future__ import annotations

from collections import OrderedDict
from functools import cache
from typing import Any

from .abbreviate import ELLIPSIS, Limits, described, is_sequence
from .plain_yaml import dump_plainly

_WIDEST = 2**31 - 1  # no line is ever wrapped


def message_to_yaml(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
    flow_style: bool = False,
) -> str:
    """Return the message as YAML text. With `flow_style` arrays stand in one line, as [1, 2, 3]."""
    data = message_to_ordereddict(msg, truncate_length=truncate_length, no_arr=no_arr, no_str=no_str)
    quick = None if flow_style else dump_plainly(data)
    return _dump(data, flow_style) if quick is None else quick


def message_to_csv(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
) -> str:
    """Return all values of the message in one line, separated by commas; strings stand as they are."""
    limits = Limits(truncate_length, no_arr, no_str)
    return ",".join(_cell(value, slot, limits) for _, value, slot in _fields(msg))


def message_to_ordereddict(
    msg: Any,
    *,
    truncate_length: int | None = None,
    no_arr: bool = False,
    no_str: bool = False,
) -> OrderedDict[str, Any]:
    """Return the message as dictionaries and lists, its fields in the order of their definition."""
    return _mapping(msg, Limits(truncate_length, no_arr, no_str))


def get_message_slot_types(msg: Any) -> OrderedDict[str, Any]:
    """Return the rosidl type of every field."""
    return OrderedDict((name, slot) for name, slot in zip(_field_names(msg), msg.SLOT_TYPES, strict=True))


def _field_names(msg: Any) -> list[str]:
    return list(msg.get_fields_and_field_types())


def _fields(msg: Any) -> list[tuple[str, Any, Any]]:
    names = _field_names(msg)
    return [(name, getattr(msg, name), slot) for name, slot in zip(names, msg.SLOT_TYPES, strict=True)]


def _mapping(msg: Any, limits: Limits) -> OrderedDict[str, Any]:
    return OrderedDict((name, _value(value, slot, limits)) for name, value, slot in _fields(msg))


def _value(value: Any, slot: Any, limits: Limits) -> Any:
    if type(value) in (bool, int, float):  # a numpy number is an instance of these, too
        return value
    if isinstance(value, str):
        return limits.text(value)
    if isinstance(value, bytes):
        return _characters(value, limits)
    if is_sequence(value):
        return _sequence(value, slot, limits)
    return _mapping(value, limits) if hasattr(value, "SLOT_TYPES") else value.item()  # else a numpy number


def _characters(value: bytes, limits: Limits) -> str:
    """Return a byte as the character of that number, which YAML writes as an escape where need be."""
    text = value.decode("latin-1")
    return text[: limits.length] + ELLIPSIS if limits.exceeded_by(text) else text


def _sequence(values: Any, slot: Any, limits: Limits) -> Any:
    if limits.no_arr and slot is not None:
        return described(values, slot)
    kept = values[: limits.length] if limits.exceeded_by(values) else values
    numbers = hasattr(kept, "tolist")
    items = kept.tolist() if numbers else [_value(item, None, limits) for item in kept]
    return [*items, ELLIPSIS] if limits.exceeded_by(values) else items


def _cell(value: Any, slot: Any, limits: Limits) -> str:
    if isinstance(value, str):
        return limits.text(value)
    if isinstance(value, bytes):
        return str(value[: limits.length] + ELLIPSIS.encode() if limits.exceeded_by(value) else value)
    if is_sequence(value):
        return described(value, slot) if limits.no_arr and slot is not None else _cells(value, limits)
    if hasattr(value, "SLOT_TYPES"):
        return ",".join(_cell(inner, inner_slot, limits) for _, inner, inner_slot in _fields(value))
    return str(value)


def _cells(values: Any, limits: Limits) -> str:
    cells = [_cell(item, None, limits) for item in values[: limits.length]]
    return ",".join([*cells, ELLIPSIS] if limits.exceeded_by(values) else cells)


def _dump(data: OrderedDict[str, Any], flow_style: bool) -> str:
    import yaml  # most messages are written without it

    style = {"allow_unicode": True, "width": _WIDEST, "sort_keys": False, "default_flow_style": flow_style}
    return str(yaml.dump(data, Dumper=_dumper(), **style))


@cache
def _dumper() -> Any:
    """Return a dumper that leaves dictionaries in order, and in lines of their own in either style."""
    import yaml

    class Dumper(yaml.SafeDumper):
        def ignore_aliases(self, data: Any) -> bool:
            return True

    def in_order(dumper: Any, data: OrderedDict[str, Any]) -> Any:
        pairs = [(dumper.represent_data(key), dumper.represent_data(item)) for key, item in data.items()]
        return yaml.MappingNode("tag:yaml.org,2002:map", pairs)

    Dumper.add_representer(OrderedDict, in_order)
    return Dumper
