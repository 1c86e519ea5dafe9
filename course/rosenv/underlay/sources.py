"""The packages of the underlay as they stand in its source folder."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from course.rosenv.identity import digest

_COURSE = Path(__file__).parents[2]
_SCRIPT = re.compile(r"""["']\s*([\w.-]+)\s*=\s*([\w.]+):(\w+)\s*["']""")
INTERFACE_FOLDERS = ("msg", "srv", "action")


@dataclass(frozen=True)
class UnderlayPackage:
    """One package: `compiled` says that there is more to it than Python, which is to be built first."""

    name: str
    folder: Path
    compiled: bool

    @property
    def modules(self) -> tuple[Path, ...]:
        """The folders of its Python packages that are used as they stand."""
        return tuple(sorted(file.parent for file in self.folder.glob("*/__init__.py")))

    @property
    def interfaces(self) -> tuple[str, ...]:
        """What it defines, as the ament index lists it: `msg/Bool.msg`, `srv/AddTwoInts.srv`."""
        found = (file for kind in INTERFACE_FOLDERS for file in self.folder.glob(f"{kind}/*.{kind}"))
        return tuple(sorted(file.relative_to(self.folder).as_posix() for file in found))

    @property
    def scripts(self) -> tuple[tuple[str, str, str], ...]:
        """Its console scripts: name, module and function of each."""
        return tuple(_SCRIPT.findall((self.folder / "setup.py").read_text(encoding="utf-8")))

    @property
    def scripts_folder(self) -> str:
        """Where they are installed, relative to a prefix: `bin`, or `lib/<package>`."""
        setting = (self.folder / "setup.cfg").read_text(encoding="utf-8")
        return "bin" if "install_scripts=$base/bin" in setting else f"lib/{self.name}"


def source_root() -> Path | None:
    """The underlay's workspace: beside the engine in a checkout, else inside it; None if it was left out."""
    for root in (_COURSE.parent / "underlay", _COURSE / "_course" / "underlay"):
        if (root / "src").is_dir():
            return root
    return None


def packages_in(root: Path) -> tuple[UnderlayPackage, ...]:
    """All packages of the workspace `root`, by name."""
    folders = sorted(file.parent for file in (root / "src").glob("*/package.xml"))
    return tuple(
        UnderlayPackage(folder.name, folder, (folder / "CMakeLists.txt").exists()) for folder in folders
    )


def fingerprint(packages: Iterable[UnderlayPackage]) -> str:
    """Changes when a package comes, goes, or is to be laid out or compiled differently."""
    return digest(line for package in packages for line in _lines(package))


def _lines(package: UnderlayPackage) -> list[str]:
    # A module that is used as it stands may change at any time: only where it lies counts.
    if not package.compiled:
        fixed = [package.folder / name for name in ("package.xml", "setup.py", "setup.cfg")]
        return [*map(str, package.modules), *map(_content, fixed)]
    files = (file for file in sorted(package.folder.rglob("*")) if file.is_file())
    built = (file for file in files if not any(map(file.is_relative_to, package.modules)))
    return [str(package.folder), *map(str, package.modules), *map(_content, built)]


def _content(file: Path) -> str:
    return f"{file} {file.read_text(encoding='utf-8', errors='surrogateescape')}"
