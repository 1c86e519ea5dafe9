"""Submissions on disk."""

from __future__ import annotations

from pathlib import Path

MESSAGES = "python_package_that_uses_the_messages"
PUBLISHER = f"{MESSAGES}/{MESSAGES}/amazing_quote_publisher_node.py"
INTERFACES = "package_with_interfaces"


def lay(folder: Path, *names: str) -> Path:
    """Makes files, with their names in them (package.xml: its folder's), and folders (`name/`)."""
    for name in names:
        path = folder / name
        if name.endswith("/"):
            path.mkdir(parents=True, exist_ok=True)
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(manifest(path.parent.name) if path.name == "package.xml" else name)
    return folder


def manifest(name: str) -> str:
    return f'<package format="3"><name>{name}</name></package>\n'


def package(name: str, where: str = "") -> tuple[str, ...]:
    return f"{where}{name}/package.xml", f"{where}{name}/setup.py", f"{where}{name}/{name}/__init__.py"
