"""Interfaces by name: `get_message("std_msgs/msg/String")` is the class itself."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rosidl_parser.definition import NamespacedType

_KINDS = ("msg", "srv", "action")


def get_namespaced_type(identifier: str) -> "NamespacedType":
    """Return the rosidl type of `package/kind/Name`; ValueError for a name of another shape."""
    from rosidl_parser.definition import NamespacedType  # the commands that only list need no parser

    package, kind, name = _split(identifier)
    return NamespacedType([package, kind], name)


def get_interface(identifier: str) -> Any:
    """Return the class of a message, service or action.

    Raises ValueError for a malformed name, ModuleNotFoundError for an unknown package, AttributeError for
    an unknown name in it.
    """
    package, kind, name = _split(identifier)
    return getattr(import_module(f"{package}.{kind}"), name)


def get_message(identifier: str) -> Any:
    """Return the class of a message, given as `package/msg/Name` or `package/Name`."""
    interface = get_interface(_with_kind(identifier, "msg"))
    return _checked(interface, identifier, is_message(interface), "message")


def get_service(identifier: str) -> Any:
    """Return the class of a service, given as `package/srv/Name` or `package/Name`."""
    interface = get_interface(_with_kind(identifier, "srv"))
    return _checked(interface, identifier, is_service(interface), "service")


def get_action(identifier: str) -> Any:
    """Return the class of an action, given as `package/action/Name` or `package/Name`."""
    interface = get_interface(_with_kind(identifier, "action"))
    return _checked(interface, identifier, is_action(interface), "action")


def is_message(interface: Any) -> bool:
    """Tell whether the class is that of a message."""
    return hasattr(interface, "_fields_and_field_types")


def is_service(interface: Any) -> bool:
    """Tell whether the class is that of a service."""
    return hasattr(interface, "Request") and hasattr(interface, "Response")


def is_action(interface: Any) -> bool:
    """Tell whether the class is that of an action."""
    return all(hasattr(interface, part) for part in ("Goal", "Result", "Feedback"))


def _split(identifier: str) -> list[str]:
    parts = identifier.split("/")
    if len(parts) != 3 or not all(part.isidentifier() for part in parts) or parts[1] not in _KINDS:
        raise ValueError(f"Expected the full name of an interface (package/kind/Name), got '{identifier}'")
    return parts


def _with_kind(identifier: str, kind: str) -> str:
    """Fill in the part that people leave out: package/Name is package/msg/Name."""
    parts = identifier.split("/")
    return "/".join([parts[0], kind, parts[1]]) if len(parts) == 2 else identifier


def _checked(interface: Any, identifier: str, fits: bool, kind: str) -> Any:
    if not fits:
        raise ValueError(f"Expected '{identifier}' to be a {kind}")
    return interface
