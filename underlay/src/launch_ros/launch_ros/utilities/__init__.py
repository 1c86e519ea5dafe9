"""Small things about parameters, remappings and names."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {
    "evaluate_parameter_dict": "parameter_values",
    "evaluate_parameters": "parameter_values",
    "make_namespace_absolute": "names",
    "normalize_parameter_dict": "parameter_forms",
    "normalize_parameters": "parameter_forms",
    "normalize_remap_rule": "remap_forms",
    "normalize_remap_rules": "remap_forms",
    "prefix_namespace": "names",
}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, _NAMES)
