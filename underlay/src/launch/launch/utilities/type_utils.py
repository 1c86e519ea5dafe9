"""Values of a type that may be given as substitutions."""

from __future__ import annotations

from typing import Any

from launch.frontend.type_utils import typed_attribute
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities.normalize import normalize_to_list_of_substitutions
from launch.utilities.perform import perform_substitutions


def normalize_typed_substitution(value: Any, data_type: Any) -> Any:
    """A plain value stays; whatever holds substitutions becomes a list of them."""
    late = isinstance(value, Substitution) or (
        isinstance(value, list) and any(isinstance(item, Substitution) for item in value)
    )
    return normalize_to_list_of_substitutions(value) if late else coerce_to_type(value, data_type)


def perform_typed_substitution(context: LaunchContext, value: Any, data_type: Any) -> Any:
    late = isinstance(value, list) and bool(value) and isinstance(value[0], Substitution)
    return coerce_to_type(perform_substitutions(context, value) if late else value, data_type)


def coerce_to_type(value: Any, data_type: Any = None) -> Any:
    """Raises TypeError where the value is none of that type."""
    return typed_attribute(value, data_type, f"'{value}'")
