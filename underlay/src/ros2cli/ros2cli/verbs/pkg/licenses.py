"""The licenses that `ros2 pkg create` can write a LICENSE file for."""

from __future__ import annotations

from datetime import date
from pathlib import Path

KNOWN = (
    "Apache-2.0",
    "BSL-1.0",
    "BSD-2.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "GPL-3.0-only",
    "LGPL-3.0-only",
    "MIT",
    "MIT-0",
)


def license_text(name: str, holder: str) -> str:
    """Return the text of a known license, in the holder's name where it has a place for one."""
    text = (Path(__file__).parent / "license_texts" / f"{name}.txt").read_text(encoding="utf-8")
    return text.replace("{copyright}", f"Copyright (c) {date.today().year} {holder}", 1)
