"""Packages to break, and ways to break them."""

from __future__ import annotations

from pathlib import Path


def edit(file: Path, old: str, new: str) -> None:
    """Replace the first `old` in the file by `new`."""
    text = file.read_text()
    assert old in text, f"{old!r} is not in {file}"
    file.write_text(text.replace(old, new, 1))


def make_package(src: Path, name: str, *depends: str) -> Path:
    """A package of type ament_python with nothing but a package.xml."""
    tags = "".join(f"<depend>{depend}</depend>" for depend in depends)
    folder = src / name
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(
        f"<package format='3'><name>{name}</name><version>0.0.0</version><description>d</description>"
        f"<maintainer email='a@example.com'>a</maintainer><license>MIT</license>{tags}"
        "<export><build_type>ament_python</build_type></export></package>"
    )
    return folder
