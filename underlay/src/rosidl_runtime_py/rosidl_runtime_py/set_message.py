"""Fill a message from dictionaries, such as YAML typed on a command line gives."""

from __future__ import annotations

from array import array
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from .convert import get_message_slot_types
from .import_message import import_message_from_namespaced_type

StampSetter = Callable[[Any], None]


def set_message_fields(
    msg: Any,
    values: Mapping[str, Any],
    expand_header_auto: bool = False,
    expand_time_now: bool = False,
) -> list[StampSetter]:
    """Set the fields of `msg` that `values` names, nested ones too; the others stay as they are.

    With `expand_header_auto` a header may be given as "auto", with `expand_time_now` a time as "now". The
    functions returned set these: call each with a builtin_interfaces Time, at every sending.

    Raises AttributeError for a field that is not there. Raises TypeError for a value that is not a dictionary
    where one is needed, and ValueError for one that is not of the field's type.
    """
    filler = _Filler(expand_header_auto, expand_time_now)
    filler.fill(msg, values)
    return filler.stamps


class _Filler:
    def __init__(self, header_auto: bool, time_now: bool) -> None:
        self._header_auto = header_auto
        self._time_now = time_now
        self.stamps: list[StampSetter] = []

    def fill(self, msg: Any, values: Any) -> None:
        if not isinstance(values, Mapping):
            raise TypeError(
                f"Value '{values}' is expected to be a dictionary but is a {type(values).__name__}"
            )
        for name, value in values.items():
            self._fill_field(msg, name, value)

    def _fill_field(self, msg: Any, name: Any, value: Any) -> None:
        current = getattr(msg, str(name))
        slot = get_message_slot_types(msg).get(name)
        if slot is None:  # an attribute of the class, but no field of it
            raise AttributeError(f"'{type(msg).__name__}' object has no attribute '{name}'")
        stamp = self._stamp_setter(msg, name, current, value)
        if stamp is None:
            setattr(msg, name, self._converted(current, slot, value))
        else:
            self.stamps.append(stamp)

    def _stamp_setter(self, msg: Any, name: str, current: Any, value: Any) -> StampSetter | None:
        kind = f"{type(current).__module__}.{type(current).__name__}"
        if self._header_auto and kind == "std_msgs.msg._header.Header" and value == "auto":
            return partial(setattr, current, "stamp")
        if self._time_now and kind == "builtin_interfaces.msg._time.Time" and value == "now":
            return partial(setattr, msg, name)
        return None

    def _converted(self, current: Any, slot: Any, value: Any) -> Any:
        element = getattr(slot, "value_type", None)
        if element is not None:
            return _of_size(self._sequence(current, element, value), slot)
        if hasattr(current, "SLOT_TYPES"):
            return self._message(current, value)
        if isinstance(current, bytes):
            return _byte(value)
        return value if type(value) is type(current) else type(current)(value)

    def _sequence(self, current: Any, element: Any, value: Any) -> Any:
        if hasattr(element, "namespaces"):
            kind = import_message_from_namespaced_type(element)
            return [self._message(kind(), item) for item in value]
        if isinstance(current, array):
            return array(current.typecode, value)
        if type(current).__module__ == "numpy":
            return _numpy_array(current, value)
        if getattr(element, "typename", None) == "octet":
            return [_byte(item) for item in value]
        return value if type(value) is type(current) else type(current)(value)

    def _message(self, message: Any, value: Any) -> Any:
        if type(value) is type(message):
            return value
        self.fill(message, value)
        return message


def _of_size(values: Any, slot: Any) -> Any:
    """Return the values, if there are as many as an array of fixed size holds; rclpy itself does not look."""
    size = getattr(slot, "size", None)
    if size is not None and len(values) != size:
        raise ValueError(f"expected {size} values, got {len(values)}")
    return values


def _byte(value: Any) -> bytes:
    """Return the one byte that a number, or the character that YAML shows for it, stands for."""
    if isinstance(value, str):
        return value.encode("latin-1")
    return bytes([value]) if isinstance(value, int) else bytes(value)


def _numpy_array(current: Any, value: Any) -> Any:
    import numpy  # the message has loaded it already

    return numpy.array(value, dtype=current.dtype)
