"""How messages are shortened: by length, without the contents of arrays, without those of strings."""

from dataclasses import dataclass
from typing import Any

ELLIPSIS = "..."


@dataclass(frozen=True)
class Limits:
    """What is left out: all beyond `length` items or characters, arrays (`no_arr`), strings (`no_str`)."""

    length: int | None = None
    no_arr: bool = False
    no_str: bool = False

    def exceeded_by(self, value: Any) -> bool:
        """Tell whether the value is too long to be shown whole."""
        return self.length is not None and len(value) > self.length

    def text(self, value: str) -> str:
        """Return a string as it is to be shown."""
        if self.no_str:
            return f"<string length: <{len(value)}>>"
        return value[: self.length] + ELLIPSIS if self.exceeded_by(value) else value


def is_sequence(value: Any) -> bool:
    """Tell an array field's value (list, tuple, array.array, numpy array) from everything else."""
    return not isinstance(value, (str, bytes)) and hasattr(value, "__len__")


def described(value: Any, slot_type: Any) -> str:
    """Return what stands for an array that is not shown: its type and how long it is."""
    name = _type_name(slot_type.value_type)
    size = getattr(slot_type, "size", None)
    if size is not None:
        return f"<array type: {name}[{size}]>"
    bound = getattr(slot_type, "maximum_size", None) if slot_type.has_maximum_size() else None
    shown = f"{name}[{bound}]" if bound is not None else name
    return f"<sequence type: {shown}, length: {len(value)}>"


def _type_name(value_type: Any) -> str:
    kind = type(value_type).__name__
    if kind == "BasicType":
        return str(value_type.typename)
    if kind.endswith("WString"):
        return "wstring"
    if kind.endswith("String"):
        return "string"
    if kind == "NamespacedType":
        return f"{value_type.namespaces[0]}/{value_type.name}"
    return str(getattr(value_type, "name", kind))
