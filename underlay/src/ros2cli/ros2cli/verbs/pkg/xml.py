"""`ros2 pkg xml`: a package's manifest, or what one of its tags says."""

from __future__ import annotations

import argparse
from pathlib import Path
from xml.etree import ElementTree

from ros2cli.errors import CommandError
from ros2cli.verbs.pkg.installed import packages, prefix_of


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the package and the tag."""
    name = parser.add_argument("package_name", help="The package name")
    name.completer = packages  # type: ignore[attr-defined]  # argcomplete's way
    parser.add_argument("-t", "--tag", help="The XML tag to output")


def main(args: argparse.Namespace) -> None:
    """Print the manifest as it is, without the lines before its root."""
    prefix = prefix_of(args.package_name, "Package not found")
    root = _root(prefix / "share" / args.package_name / "package.xml")
    if args.tag is None:
        print(ElementTree.tostring(root, encoding="unicode"))
    else:
        _print_tag(root, args.tag)


def _root(path: Path) -> ElementTree.Element:
    try:
        return ElementTree.parse(path).getroot()
    except FileNotFoundError:
        raise CommandError("No manifest for package found") from None
    except (OSError, ElementTree.ParseError) as error:
        raise CommandError(f"Cannot read {path}: {error}") from None


def _print_tag(root: ElementTree.Element, tag: str) -> None:
    found = [root] if root.tag == tag else root.findall(f".//{tag}")
    if not found:
        raise CommandError(f"No tag '{tag}' found in manifest")
    for element in found:
        whole = ElementTree.tostring(element, encoding="unicode").strip()
        print(whole if len(element) else element.text or "")
