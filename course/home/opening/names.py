"""Names that strangers chose: made safe for a disk, and for a terminal."""

from __future__ import annotations

import re

LONGEST_NAME = 255  # bytes; what Linux takes
LONGEST_PATH = 1024  # bytes; leaves room for the folder that all of it goes into
DEEPEST = 32

_DRIVE = re.compile(r"[A-Za-z]:")


class Unsafe(Exception):
    """A name that leads elsewhere, or that no disk takes; its text says which, to end a sentence with."""


def safe_path(name: str) -> str:
    """The relative path that `name` stands for, in characters that can be printed. Raises Unsafe."""
    if name.startswith("/") or _DRIVE.match(name):
        raise Unsafe("an absolute path")
    parts = [part for part in name.split("/") if part not in ("", ".")]
    if ".." in parts:
        raise Unsafe("a path that leads out (`..`)")
    if len(parts) > DEEPEST:
        raise Unsafe(f"more than {DEEPEST} folders deep")
    path = "/".join(safe_name(part) for part in parts)
    if len(path.encode()) > LONGEST_PATH:
        raise Unsafe(f"a path of more than {LONGEST_PATH} bytes")
    return path


def safe_name(name: str) -> str:
    """One file's name with an underscore for each character that cannot be printed. Raises Unsafe.

    These are control characters and escapes, line ends, marks that turn the reading direction, and
    bytes that are no UTF-8 (which Python keeps as halves of surrogate pairs).
    """
    safe = name if name.isprintable() else "".join(c if c.isprintable() else "_" for c in name)
    if len(safe.encode()) > LONGEST_NAME:
        raise Unsafe(f"a name of more than {LONGEST_NAME} bytes")
    return safe


def visible(text: str, limit: int = 120) -> str:
    """`text` on one line, with what cannot be printed spelt out, and its middle left out if it is long."""
    if len(text) > limit:
        text = f"{text[: limit // 2]}...{text[-(limit // 2) :]}"
    return "".join(char if char.isprintable() else char.encode("unicode_escape").decode() for char in text)
