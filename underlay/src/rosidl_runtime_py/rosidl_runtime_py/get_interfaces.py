"""Which interfaces there are, from the ament index: nothing is imported, so it is quick."""

from collections.abc import Iterable
from pathlib import Path, PurePosixPath

from ament_index_python import PackageNotFoundError, get_resource, get_resources
from ament_index_python.packages import get_package_share_directory

_INDEX = "rosidl_interfaces"
_SUFFIXES = (".msg", ".srv", ".action", ".idl")


def get_interface_packages() -> dict[str, str]:
    """Return the packages that offer interfaces, each with the prefix it is installed in."""
    return dict(get_resources(_INDEX))


def get_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the interfaces of the packages (none given: of all) as `msg/Name`, `srv/Name`, `action/Name`.

    Raises LookupError for a package that is unknown.
    """
    wanted = list(package_names)
    _refuse_unknown(wanted)
    found = get_interface_packages()
    return {package: _interfaces_of(package) for package in (wanted or sorted(found)) if package in found}


def get_message_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the messages of the packages (none given: of all)."""
    return _of_kind("msg", package_names)


def get_service_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the services of the packages (none given: of all)."""
    return _of_kind("srv", package_names)


def get_action_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the actions of the packages (none given: of all)."""
    return _of_kind("action", package_names)


def get_interface_path(interface_name: str) -> str:
    """Return the file that defines `package/msg/Name`, or `package/msg/Name.idl` if asked for that.

    Without a suffix the file people write (.msg, .srv, .action) comes before the generated .idl.
    Raises ValueError for a malformed name, LookupError for one that is unknown.
    """
    package, *inside = _parts(interface_name)
    folder = _share(package)
    asked = folder.joinpath(*inside)
    for candidate in _candidates(asked):
        if candidate.is_file():
            return str(candidate)
    shown = asked if asked.suffix else asked.with_name(asked.name + ".idl")
    raise LookupError(f"Could not find the interface '{shown}'")


def _parts(interface_name: str) -> list[str]:
    parts = interface_name.split("/")
    if len(parts) < 2:
        raise ValueError(f"Invalid name '{interface_name}'. Expected at least two parts separated by '/'")
    if not all(parts):
        raise ValueError(f"Invalid name '{interface_name}'. Must not contain empty parts")
    return parts


def _share(package: str) -> Path:
    try:
        return Path(get_package_share_directory(package))
    except (PackageNotFoundError, ValueError):
        raise LookupError(f"Unknown package '{package}'") from None


def _candidates(asked: Path) -> list[Path]:
    if asked.suffix:
        return [asked]
    return [asked.with_name(asked.name + suffix) for suffix in _SUFFIXES]


def _refuse_unknown(packages: Iterable[str]) -> None:
    for package in packages:
        _share(package)


def _interfaces_of(package: str) -> list[str]:
    content, _ = get_resource(_INDEX, package)
    paths = (PurePosixPath(line) for line in content.splitlines())
    return sorted({str(path.with_suffix("")) for path in paths if path.suffix in _SUFFIXES})


def _of_kind(kind: str, package_names: Iterable[str]) -> dict[str, list[str]]:
    everything = get_interfaces(package_names)
    sorted_out = {
        package: [name for name in names if name.startswith(f"{kind}/")]
        for package, names in everything.items()
    }
    return {package: names for package, names in sorted_out.items() if names}
