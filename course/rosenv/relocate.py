"""Corrects the paths of the build machine that are baked into the CMake files of the ROS wheels.

Without this, find_package(geometry_msgs) fails in a package that defines its own messages. Two things are
wrong: the include folders of Python and numpy in the exports of rosidl_generator_py, and a libtinyxml2.so in
that of fastrtps.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from course.rosenv.files import remove_half_made, write_atomic

# Elements of a CMake list inside quotes. They match the paths of the build machine and our own earlier ones
# alike, so that a second time changes nothing, and an environment that was moved is put right again.
_PYTHON_INCLUDE = re.compile(r'(?<=[";])/[^";]*/include/python3\.\d+(?=[";])')
_NUMPY_INCLUDE = re.compile(r'(?<=[";])/[^";]*/numpy/(?:_core|core)/include(?=[";])')
_TINYXML = re.compile(r';/[^";]*/libtinyxml2\.so(?=[";])|(?<=")/[^";]*/libtinyxml2\.so;?')


def relocate(prefix: Path, python_include: Path, numpy_include: Path) -> tuple[Path, ...]:
    """Correct every file below `prefix` that needs it; returns those that changed.

    Each file is replaced in one step, so this may be killed at any moment and run again. OSError where a file
    that needs it cannot be written.
    """
    return tuple(
        file for file, text in _corrected(prefix, python_include, numpy_include) if write_atomic(file, text)
    )


def _corrected(prefix: Path, python_include: Path, numpy_include: Path) -> Iterator[tuple[Path, str]]:
    for file in prefix.glob("share/*/cmake/export_*__rosidl_generator_pyExport.cmake"):
        remove_half_made(file)
        yield file, with_includes(_read(file), python_include, numpy_include)
    fastrtps = prefix / "share/fastrtps/cmake/fastrtps-shared-targets.cmake"
    if fastrtps.exists():
        remove_half_made(fastrtps)
        yield fastrtps, without_tinyxml(_read(fastrtps))


def with_includes(text: str, python_include: Path, numpy_include: Path) -> str:
    """The text of a CMake export with the include folders of Python and numpy of this machine."""
    text = _PYTHON_INCLUDE.sub(lambda _: _quoted(python_include), text)
    return _NUMPY_INCLUDE.sub(lambda _: _quoted(numpy_include), text)


def without_tinyxml(text: str) -> str:
    """The text of a CMake export without libtinyxml2.so, which the wheel bundles for itself."""
    return _TINYXML.sub("", text)


def _read(file: Path) -> str:
    return file.read_text(encoding="utf-8", errors="surrogateescape")


def _quoted(path: Path) -> str:
    return re.sub(r'([\\"$;])', r"\\\1", str(path))
