"""Makes a ROS ready for use, once; quick if there is nothing to do."""

from __future__ import annotations

import importlib.util
import os
import re
import sysconfig
from collections.abc import Iterator, Mapping
from pathlib import Path

from course.errors import StorageError
from course.files import cache_dir, locked, sweep, write_atomic
from course.rosenv.ros import Ros
from course.rosenv.setup_files import (
    SetupFiles,
    body_of,
    is_stamped,
    place_of,
    write_setup_files,
    write_stamp,
)
from course.rosenv.underlay import (
    UnderlayPackage,
    add_build,
    is_built,
    packages_in,
    source_root,
    write_prefix,
)


def prepare(ros: Ros, environ: Mapping[str, str] | None = None) -> None:
    """Correct the wheels' paths and write their setup files; an installed ROS does not need this.

    Repeated after pip changed a wheel. Can be killed at any time, and called by two processes at once.
    """
    if ros.origin != "pip":
        return
    environ = os.environ if environ is None else environ
    place = place_of(ros, environ)
    if is_prepared(ros, place):
        return
    try:
        with locked(place.lock):
            # Another process may have done it while we waited.
            if not is_prepared(ros, place):
                _prepare(ros, place, cache_dir(environ))
    except OSError as error:
        raise _storage_error(ros, error) from error


def compiled_of_underlay(ros: Ros) -> tuple[UnderlayPackage, ...]:
    """Our own packages that must be compiled; none for an installed ROS."""
    root = source_root() if ros.origin == "pip" else None
    return tuple(package for package in packages_in(root) if package.compiled) if root else ()


def missing_of_underlay(ros: Ros, environ: Mapping[str, str] | None = None) -> tuple[UnderlayPackage, ...]:
    """Our own packages that must still be compiled."""
    prefix = place_of(ros, os.environ if environ is None else environ).underlay
    return tuple(package for package in compiled_of_underlay(ros) if not is_built(prefix, package.name))


def underlay_builds(ros: Ros, environ: Mapping[str, str] | None = None) -> Path:
    """Where to build our own packages; the builds belong to this ROS, and stay there."""
    return place_of(ros, os.environ if environ is None else environ).underlay_builds


def add_to_underlay(ros: Ros, built: Path, environ: Mapping[str, str] | None = None) -> None:
    """Add one of our own packages, whose install prefix is `built`, to the underlay."""
    place = place_of(ros, os.environ if environ is None else environ)
    try:
        with locked(place.lock):
            add_build(place.underlay, built)
    except OSError as error:
        raise _storage_error(ros, error) from error


def is_prepared(ros: Ros, place: SetupFiles) -> bool:
    """Whether everything was done for exactly these wheels, and nobody removed what a learner sources."""
    return is_stamped(ros, place) and body_of(place).exists() and place.underlay.exists()


def _prepare(ros: Ros, place: SetupFiles, cache: Path) -> None:
    relocate(ros.prefix, Path(sysconfig.get_path("include")), _numpy_include(ros))
    root = source_root()
    packages = packages_in(root) if root else ()
    write_prefix(place.underlay, packages, ros, setup=body_of(place), cache=cache)
    write_setup_files(ros, place)
    write_stamp(ros, place)


def _numpy_include(ros: Ros) -> Path:
    """The folder that numpy.get_include() returns, without the 0.1 s that importing numpy takes."""
    root = ros.python_packages / "numpy"
    if not root.exists() and (found := importlib.util.find_spec("numpy")) and found.origin:
        root = Path(found.origin).parent  # in the Python on which this environment is based
    new, old = root / "_core/include", root / "core/include"  # since and before numpy 2
    return old if old.exists() and not new.exists() else new


def _storage_error(ros: Ros, error: OSError) -> StorageError:
    where = error.filename or ros.prefix
    return StorageError(
        f"ROS 2 in {ros.prefix} could not be prepared: {where}: {error.strerror}.",
        "If the disk is full, free some space. If the folder belongs to somebody else, ask them "
        "to run `ros2course doctor` once, or set the course up in a folder of your own: ./ros2course next",
    )


# Elements of a CMake list inside quotes. They match both the paths of the build machine and our own earlier
# ones, so a second run changes nothing, and an environment that was moved is corrected again.
_PYTHON_INCLUDE = re.compile(r'(?<=[";])/[^";]*/include/python3\.\d+(?=[";])')
_NUMPY_INCLUDE = re.compile(r'(?<=[";])/[^";]*/numpy/(?:_core|core)/include(?=[";])')
_TINYXML = re.compile(r';/[^";]*/libtinyxml2\.so(?=[";])|(?<=")/[^";]*/libtinyxml2\.so;?')


def relocate(prefix: Path, python_include: Path, numpy_include: Path) -> tuple[Path, ...]:
    """Correct every file below `prefix` that needs it; returns those that changed.

    Each file is replaced in one step, so this may be killed at any moment and run again. Raises OSError if a
    file that needs it cannot be written.
    """
    return tuple(
        file for file, text in _corrected(prefix, python_include, numpy_include) if write_atomic(file, text)
    )


def _corrected(prefix: Path, python_include: Path, numpy_include: Path) -> Iterator[tuple[Path, str]]:
    for file in prefix.glob("share/*/cmake/export_*__rosidl_generator_pyExport.cmake"):
        sweep(file.parent)
        yield file, with_includes(_read(file), python_include, numpy_include)
    fastrtps = prefix / "share/fastrtps/cmake/fastrtps-shared-targets.cmake"
    if fastrtps.exists():
        sweep(fastrtps.parent)
        yield fastrtps, without_tinyxml(_read(fastrtps))


def with_includes(text: str, python_include: Path, numpy_include: Path) -> str:
    """The text of a CMake export with this machine's include folders of Python and numpy."""
    text = _PYTHON_INCLUDE.sub(lambda _: _quoted(python_include), text)
    return _NUMPY_INCLUDE.sub(lambda _: _quoted(numpy_include), text)


def without_tinyxml(text: str) -> str:
    """The text of a CMake export without libtinyxml2.so, which the wheel bundles for its own use."""
    return _TINYXML.sub("", text)


def _read(file: Path) -> str:
    return file.read_text(encoding="utf-8", errors="surrogateescape")


def _quoted(path: Path) -> str:
    return re.sub(r'([\\"$;])', r"\\\1", str(path))
