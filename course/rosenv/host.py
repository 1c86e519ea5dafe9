"""Facts about this machine and the Python that runs the course, in one value that tests can make up."""

from __future__ import annotations

import os
import sys
import sysconfig
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Host:
    """The machine and the interpreter; `prefix` and `site_packages` are where pip puts the ROS wheels.

    `libc` is for example "glibc 2.36", and empty where there is no glibc (musl).
    """

    executable: Path
    prefix: Path
    site_packages: Path
    python: tuple[int, int]
    implementation: str = "cpython"
    free_threaded: bool = False
    system: str = "linux"
    machine: str = "x86_64"
    libc: str = "glibc 2.36"
    installed: Path = Path("/opt/ros/jazzy")

    @classmethod
    def here(cls) -> Host:
        """The machine and the interpreter that run this."""
        prefix, site_packages = _pip_places()
        return cls(
            executable=Path(sys.executable),
            prefix=prefix,
            site_packages=site_packages,
            python=sys.version_info[:2],
            implementation=sys.implementation.name,
            free_threaded="t" in getattr(sys, "abiflags", ""),
            system=sys.platform,
            machine=os.uname().machine if sys.maxsize > 2**32 else "32-bit",
            libc=_libc(),
        )

    @property
    def python_version(self) -> str:
        """For example "3.12"."""
        return f"{self.python[0]}.{self.python[1]}"


def _pip_places() -> tuple[Path, Path]:
    """Prefix and site-packages, with links resolved: the same place must have one name in every cache key."""
    if sys.prefix != sys.base_prefix:
        # A virtual environment, the usual case: no need to load the whole of sysconfig's variables.
        prefix = Path(sys.prefix).resolve()
        return prefix, prefix / "lib" / f"python{sys.version_info[0]}.{sys.version_info[1]}" / "site-packages"
    return Path(sysconfig.get_path("data")).resolve(), Path(sysconfig.get_path("purelib")).resolve()


def _libc() -> str:
    try:
        return os.confstr("CS_GNU_LIBC_VERSION") or ""
    except (AttributeError, ValueError, OSError):
        return ""  # another C library does not know the question
