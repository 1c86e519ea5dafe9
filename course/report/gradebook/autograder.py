"""The autograder that an instructor uploads to Gradescope: a zip that sets itself up and grades.

setup.sh            installs system packages, then ros2course from the wheel
run_autograder      grades /autograder/submission into /autograder/results/results.json
ros2course-*.whl    the engine with its course
exercises.txt       what to grade; empty: all that a submission holds
no-sandbox          there when it is to grade even where submissions cannot be contained
course/             another course, where one is given
"""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from importlib.resources import files

from course.errors import UsageError

_SCRIPTS = ("setup.sh", "run_autograder")
_WHEEL = re.compile(r"ros2course-[0-9][A-Za-z0-9._+]*-py3-none-any\.whl")


@dataclass(frozen=True)
class Packed:
    """One file of the bundle; `path` is relative to /autograder/source."""

    path: str
    content: bytes
    executable: bool = False


def bundle(
    wheel_name: str,
    wheel: bytes,
    exercises: Iterable[str],
    course: Mapping[str, bytes] | None = None,
    *,
    contained: bool = True,
) -> tuple[Packed, ...]:
    """What the zip holds.

    wheel_name, wheel: ros2course as `pip wheel --no-deps` makes it. exercises: ids, or chapters'
    numbers, as `grade --exercises` takes them. course: another course's files by their relative paths.
    contained: refuse to grade where submissions cannot be contained.
    Raises UsageError when the wheel is not one of ours.
    """
    if not _WHEEL.fullmatch(wheel_name) or not zipfile.is_zipfile(io.BytesIO(wheel)):
        advice = "Make it with: pip wheel --no-deps -w wheels ."
        raise UsageError("This is no wheel of ros2course.", advice)
    own = (Packed(name, _script(name), executable=True) for name in _SCRIPTS)
    chosen = Packed("exercises.txt", ",".join(exercises).encode("utf-8"))
    others = (Packed(f"course/{path}", content) for path, content in sorted((course or {}).items()))
    trusting = () if contained else (Packed("no-sandbox", b""),)
    return (*own, Packed(wheel_name, wheel), chosen, *trusting, *others)


def zipped(packed: Iterable[Packed]) -> bytes:
    """The zip itself, the same bytes for the same files."""
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in packed:
            entry = zipfile.ZipInfo(file.path)  # its date is 1980, always
            entry.create_system = 3  # Unix, so that the mode counts
            entry.external_attr = (0o100755 if file.executable else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, file.content)
    return target.getvalue()


def _script(name: str) -> bytes:
    return (files("course.report.gradebook") / "scripts" / name).read_bytes()
