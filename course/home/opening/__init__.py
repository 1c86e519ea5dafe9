"""Opens archives from strangers: within limits, each into a new folder, and completely or not at all.

Nothing that an archive says about itself is trusted: bytes are counted as they come out, and names, kinds
and modes are checked or replaced. Links are made last, and only those that stay inside.
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
