"""What `ros2 pkg create` was asked for, with what was left open filled in."""

from __future__ import annotations

import argparse
import getpass
import shutil
import subprocess
import sys
from dataclasses import dataclass

VERSION = "0.0.0"


@dataclass(frozen=True)
class Plan:
    """A package to be made. `node` and `library` are empty when none is wanted."""

    name: str
    destination: str
    build_type: str
    package_format: str
    description: str
    license: str
    maintainer: str
    email: str
    dependencies: tuple[str, ...]
    node: str
    library: str

    @property
    def folder(self) -> str:
        """The package's folder, as it is shown: ./name."""
        return f"{self.destination}/{self.name}"


def plan_from(args: argparse.Namespace) -> Plan:
    """Return what the command line asks for."""
    name = args.maintainer_name or _user()
    return Plan(
        name=args.package_name,
        destination=args.destination_directory,
        build_type=args.build_type,
        package_format=args.package_format,
        description=args.description,
        license=args.license,
        maintainer=name,
        email=args.maintainer_email or _git_email() or f"{name}@todo.todo",
        dependencies=tuple(args.dependencies),
        node=_node_name(args.node_name, args.library_name),
        library=args.library_name or "",
    )


def _user() -> str:
    try:
        return getpass.getuser()
    except (KeyError, OSError):  # a container's user without a name
        return "user"


def _git_email() -> str:
    git = shutil.which("git")
    if git is None:
        return ""
    answer = subprocess.run([git, "config", "user.email"], capture_output=True, text=True, check=False)
    return answer.stdout.strip()


def _node_name(node: str | None, library: str | None) -> str:
    if not node or node != library:
        return node or ""
    print("[WARNING] node name can not be equal to the library name", file=sys.stderr)
    print(f"[WARNING] renaming node to {node}_node", file=sys.stderr)
    return f"{node}_node"
