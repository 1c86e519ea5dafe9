"""Launch files in XML and YAML: what they have in common, and how packages add tags of their own."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {
    "Entity": "entity",
    "InvalidFrontendLaunchFileError": "errors",
    "Parser": "parser",
    "expose_action": "expose",
    "expose_substitution": "expose",
    "parse_substitution": "parse_substitution",
    "type_utils": "type_utils",
}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, {**_NAMES, "entity": "entity", "expose": "expose", "parser": "parser"})
