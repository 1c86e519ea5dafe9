"""Opens archives of strangers: bounded, into a folder of their own, and nothing half-made is left.

Nothing that an archive says of itself is believed: bytes are counted as they come out, and names,
kinds and modes are ours. Links are made last, and only those that stay inside.
"""

from course.home.opening.findings import (
    USUAL,
    Limits,
    Meter,
    Notes,
    Refused,
    Remark,
    Unsafe,
    safe_name,
    visible,
)
from course.home.opening.unpack import Opened, archive_stem, is_archive, open_archive, open_parts, zip_names

__all__ = [
    "USUAL",
    "Limits",
    "Meter",
    "Notes",
    "Opened",
    "Refused",
    "Remark",
    "Unsafe",
    "archive_stem",
    "is_archive",
    "open_archive",
    "open_parts",
    "safe_name",
    "visible",
    "zip_names",
]
