"""Messages to YAML, CSV and dictionaries and back, and interfaces found by name.

The conversions are loaded when they are first asked for: listing interfaces needs no YAML.
"""

from importlib import import_module
from typing import Any

# At once: get_interfaces is also a module's name, and the function must win over it.
from .get_interfaces import (
    get_action_interfaces,
    get_interface_packages,
    get_interface_path,
    get_interfaces,
    get_message_interfaces,
    get_service_interfaces,
)

_LATER = {
    "message_to_csv": "convert",
    "message_to_ordereddict": "convert",
    "message_to_yaml": "convert",
    "set_message_fields": "set_message",
}

__all__ = [
    "get_action_interfaces",
    "get_interface_packages",
    "get_interface_path",
    "get_interfaces",
    "get_message_interfaces",
    "get_service_interfaces",
    "message_to_csv",
    "message_to_ordereddict",
    "message_to_yaml",
    "set_message_fields",
]


def __getattr__(name: str) -> Any:
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_LATER[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
