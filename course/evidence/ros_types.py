"""ROS types by name, and messages filled from plain values."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import Any

from course.errors import OurFault


def load_type(type_name: str) -> Any:
    """The Python class of `pkg/msg/Type` or `pkg/srv/Type`; OurFault when the grader's ROS lacks it."""
    package, kind, short = type_name.split("/")
    try:
        return getattr(importlib.import_module(f"{package}.{kind}"), short)
    except (ImportError, AttributeError) as error:
        raise OurFault(f"the grader cannot load the type {type_name}: {error}") from error


def filled(message: Any, fields: Mapping[str, Any]) -> Any:
    """`message` with these fields set; nested messages are given as dicts."""
    for name, value in fields.items():
        if isinstance(value, Mapping):
            filled(getattr(message, name), value)
        else:
            setattr(message, name, value)
    return message
