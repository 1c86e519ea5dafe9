"""What is installed: packages and their executables, from the ament index alone."""

from __future__ import annotations

import argparse
import contextlib
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from ament_index_python.packages import PackageNotFoundError, get_package_prefix, get_packages_with_prefixes

from ros2cli.errors import CommandError


def packages(prefix: str = "", parsed_args: Any = None, **kwargs: Any) -> list[str]:
    """Return the names of all packages; also completes them."""
    return sorted(get_packages_with_prefixes())


def versions() -> dict[str, str]:
    """Return the version of each package that has a manifest."""
    found = {}
    for name, prefix in sorted(get_packages_with_prefixes().items()):
        with contextlib.suppress(OSError, ElementTree.ParseError):
            manifest = ElementTree.parse(Path(prefix, "share", name, "package.xml"))
            found[name] = (manifest.findtext("version") or "unknown").strip()
    return found


def prefix_of(package: str, complaint: str = "Package '{}' not found") -> Path:
    """Return where the package is installed; CommandError when it is not."""
    try:
        return Path(get_package_prefix(package))
    except (PackageNotFoundError, ValueError):
        raise CommandError(complaint.format(package)) from None


def executables(package: str) -> list[Path]:
    """Return the executables of the package, by name."""
    folder = prefix_of(package) / "lib" / package
    return sorted(_executables_below(folder), key=lambda path: (path.name, path))


def executable_names(prefix: str, parsed_args: argparse.Namespace, **kwargs: Any) -> list[str]:
    """Complete the executables of the package that stands before."""
    try:
        return [path.name for path in executables(parsed_args.package_name)]
    except CommandError:
        return []


def _executables_below(folder: Path) -> Iterator[Path]:
    for where, folders, files in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        yield from (path for path in (Path(where, name) for name in files) if os.access(path, os.X_OK))
