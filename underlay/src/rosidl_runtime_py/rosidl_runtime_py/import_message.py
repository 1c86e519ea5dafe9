"""The Python class of an interface, from its namespaced type as rosidl describes it."""

from importlib import import_module
from typing import Any


def import_message_from_namespaced_type(message_type: Any) -> Any:
    """Return the class for a rosidl NamespacedType, importing the module that holds it.

    Raises ModuleNotFoundError for an unknown package, AttributeError for an unknown name in it.
    """
    module = import_module(".".join(message_type.namespaces))
    return getattr(module, message_type.name)
