"""Parameters in YAML as rcl reads it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import yaml


class _Dumper(yaml.SafeDumper):
    """Every text in quotes: rcl takes a bare `y` or `on` for a truth value. No references: it knows none."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


class _Text(str):
    """A value, not a name."""


def _quoted(dumper: yaml.SafeDumper, value: _Text) -> yaml.Node:
    return dumper.represent_scalar("tag:yaml.org,2002:str", str(value), style="'")


_Dumper.add_representer(_Text, _quoted)


def file_text(node_name: str, values: Mapping[str, Any]) -> str:
    tree = {node_name: {"ros__parameters": {name: _marked(value) for name, value in values.items()}}}
    return yaml.dump(tree, Dumper=_Dumper, default_flow_style=False, allow_unicode=True)


def rule(name: str, value: Any) -> str:
    """For `-p`: on one line."""
    text = yaml.dump(
        _marked(value), Dumper=_Dumper, default_flow_style=True, allow_unicode=True, width=float("inf")
    )
    return f"{name}:={text.removesuffix('...' + chr(10)).strip()}"


def _marked(value: Any) -> Any:
    if isinstance(value, bytes):
        return list(value)
    if isinstance(value, list | tuple):
        return [_marked(item) for item in value]
    return _Text(value) if isinstance(value, str) else value
