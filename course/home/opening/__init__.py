"""Opens archives of strangers: bounded, into a folder of their own, and nothing half-made is left.

Nothing that an archive says of itself is believed: bytes are counted as they come out, and names,
kinds and modes are ours. Links are made last, and only those that stay inside.
"""

from course.home.opening.archive import archive_stem, is_archive, open_archive
from course.home.opening.finding import Finding, Notes, Refused
from course.home.opening.limits import USUAL, Limits, Meter
from course.home.opening.names import Unsafe, safe_name, visible
from course.home.opening.parts import Opened, open_parts, zip_names

__all__ = [
    "USUAL",
    "Finding",
    "Limits",
    "Meter",
    "Notes",
    "Opened",
    "Refused",
    "Unsafe",
    "archive_stem",
    "is_archive",
    "open_archive",
    "open_parts",
    "safe_name",
    "visible",
    "zip_names",
]
