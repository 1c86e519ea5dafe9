"""The prefix that offers the underlay's packages: links to their sources, scripts, and stand-ins for builds.

bin/ros2, lib/<package>/<script>     start what setup.py names, with the Python of the wheels
lib/pythonX.Y/site-packages/<module> the source folder, or what builds the package when it is imported
share/<package>/...                  package.xml, message definitions, or CMake that builds the package
share/ament_index/...                makes the packages known
local_setup.*                        what colcon's own setup files source
"""

from __future__ import annotations

import shlex
import shutil
import tempfile
from collections.abc import Iterable
from pathlib import Path

from course.rosenv.files import write_atomic
from course.rosenv.model import Ros
from course.rosenv.underlay import standins
from course.rosenv.underlay.links import link
from course.rosenv.underlay.sources import INTERFACE_FOLDERS, UnderlayPackage
from course.rosenv.underlay.standins import Builder

STANDINS = "standins"
_INDEX = "share/ament_index/resource_index"


def write_prefix(
    prefix: Path, packages: Iterable[UnderlayPackage], ros: Ros, *, setup: Path, cache: Path
) -> None:
    """Make the prefix anew. `setup` is the script that puts it in place together with the wheels.

    Call it under a lock. What was compiled into an earlier one has to be added again; `cache` is where the
    course keeps such things. The prefix is a link to a folder beside it, so that whoever uses the earlier one
    at this moment never finds it half-made.
    """
    prefix.parent.mkdir(parents=True, exist_ok=True)
    folder = Path(tempfile.mkdtemp(prefix=f"{prefix.name}.", dir=prefix.parent))
    folder.chmod(0o755)
    _fill(folder, packages, ros, Builder(ros.python, cache), prefix)
    for shell in ("sh", "bash", "zsh"):
        write_atomic(folder / f"local_setup.{shell}", f". {shlex.quote(str(setup))}\n")
    link(prefix, folder)
    for other in prefix.parent.glob(f"{prefix.name}.*"):
        if other != folder:
            shutil.rmtree(other, ignore_errors=True)


def _fill(
    folder: Path, packages: Iterable[UnderlayPackage], ros: Ros, builder: Builder, prefix: Path
) -> None:
    for shared in (folder / "bin", folder / "lib", site_packages(folder, ros)):
        shared.mkdir(parents=True, exist_ok=True)
    for package in packages:
        _register(folder, package)
        for module in package.modules:
            link(site_packages(folder, ros) / module.name, module)
        if package.compiled:
            _stand_in(folder, package, ros, builder, prefix)
        else:
            _offer_scripts(folder, package, ros)


def site_packages(prefix: Path, ros: Ros) -> Path:
    """The folder of the prefix that Python imports from; it is called as that of the wheels."""
    return prefix / "lib" / ros.python_packages.parent.name / "site-packages"


def _register(folder: Path, package: UnderlayPackage) -> None:
    link(folder / "share" / package.name / "package.xml", package.folder / "package.xml")
    write_atomic(folder / _INDEX / "packages" / package.name, "")
    for kind in INTERFACE_FOLDERS:
        if (package.folder / kind).is_dir():
            link(folder / "share" / package.name / kind, package.folder / kind)
    if package.interfaces:
        write_atomic(folder / _INDEX / "rosidl_interfaces" / package.name, "\n".join(package.interfaces))


def _offer_scripts(folder: Path, package: UnderlayPackage, ros: Ros) -> None:
    for name, source, function in package.scripts:
        script = folder / package.scripts_folder / name
        write_atomic(script, standins.script(ros.python, source, function))
        script.chmod(0o755)


def _stand_in(folder: Path, package: UnderlayPackage, ros: Ros, builder: Builder, prefix: Path) -> None:
    """Lay what stands in until the package was built; a build replaces the links to it."""
    name, own = package.name, folder / STANDINS / package.name
    found = Path("share", name, "cmake")
    config = standins.cmake(name, own / "cmake", prefix / found, builder)
    write_atomic(own / "cmake" / f"{name}Config.cmake", config)
    link(folder / found, own / "cmake")
    if package.interfaces:
        imported = standins.python(name, site_packages(prefix, ros) / name, builder)
        write_atomic(own / "python" / "__init__.py", imported)
        link(site_packages(folder, ros) / name, own / "python")
