"""The kinds of interfaces, and the options that choose among them."""

from __future__ import annotations

import argparse
from typing import Any

# The letter of the option, the heading of the list, the folder within a package.
KINDS = (("m", "Messages", "msg"), ("s", "Services", "srv"), ("a", "Actions", "action"))


def add_kind_arguments(parser: argparse.ArgumentParser) -> None:
    """Take -m, -s and -a; none of them means all."""
    for letter, heading, folder in KINDS:
        name = f"--only-{'actions' if folder == 'action' else folder + 's'}"
        help_text = f"Print out only the {heading.lower()[:-1]} types"
        parser.add_argument(f"-{letter}", name, dest=folder, action="store_true", help=help_text)


def wanted_folders(args: argparse.Namespace) -> list[str]:
    """Return the kinds asked for, as msg, srv and action."""
    folders = [folder for _, _, folder in KINDS]
    return [folder for folder in folders if getattr(args, folder)] or folders


def interface_packages(prefix: str = "", parsed_args: Any = None, **kwargs: Any) -> list[str]:
    """Complete packages that offer interfaces."""
    from rosidl_runtime_py import get_interface_packages

    return sorted(get_interface_packages())


def interface_types(prefix: str = "", parsed_args: Any = None, **kwargs: Any) -> list[str]:
    """Complete interfaces, as package/msg/Name."""
    from rosidl_runtime_py import get_interfaces

    return [f"{package}/{name}" for package, names in get_interfaces().items() for name in names]
