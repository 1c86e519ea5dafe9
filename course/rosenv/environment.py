"""The complete environment for a process that uses ROS: of the caller's, only what is listed here."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from course.errors import MissingHere
from course.files import cache_dir, write_atomic
from course.rosenv.paths import every_prefix, sourced_prefixes, split, without
from course.rosenv.ros import Ros, digest, python_folders
from course.rosenv.setup_files import place_of, setup_script
from course.rosenv.variables import (
    LISTS,
    PREFIXES,
    PROFILE,
    Variables,
    discovery_values,
    ros_values,
    wheel_variables,
)

_BASICS = ("HOME", "USER", "LOGNAME", "SHELL", "LANG", "LANGUAGE", "TERM", "COLORTERM", "TZ", "TMPDIR")
_DEFAULT_PATH = "/usr/local/bin:/usr/bin:/bin"


def node_environment(
    ros: Ros, overlays: Sequence[Path] = (), environ: Mapping[str, str] | None = None
) -> dict[str, str]:
    """All variables for a child process that builds or runs ROS packages.

    `overlays` are install prefixes of single packages (colcon's isolated layout); if two contain the same
    thing, the last one wins. Workspaces that happen to be sourced in `environ` are left out, and so are
    ROS_DOMAIN_ID and the like: whatever starts the process sets them.
    """
    environ = os.environ if environ is None else environ
    under, outer_path = _under(ros, environ)
    lists = {name: list(under.lists.get(name, ())) for name in LISTS}
    for overlay in overlays:
        for name, paths in _overlay_lists(overlay).items():
            lists[name] = [*paths, *lists[name]]
    lists["PATH"] += outer_path
    joined = {name: ":".join(dict.fromkeys(paths)) for name, paths in lists.items() if paths}
    return {**_basics(environ), **under.values, **discovery_values(_profile(ros, environ)), **joined}


def plain_environment(ros: Ros, environ: Mapping[str, str] | None = None) -> dict[str, str]:
    """All variables for a child process that must not find ROS, as in a freshly opened terminal."""
    environ = os.environ if environ is None else environ
    # An environment of pip packages may be active in the caller's shell, without its ROS being sourced.
    known = (*every_prefix(environ), *((ros.prefix,) if ros.origin == "pip" else ()))
    path = without(split(environ.get("PATH")) or _DEFAULT_PATH.split(":"), known)
    return {**_basics(environ), "PATH": ":".join(path)}


def _under(ros: Ros, environ: Mapping[str, str]) -> tuple[Variables, list[str]]:
    """The variables of the ROS itself, and the entries of the caller's PATH that come after them."""
    sourced = sourced_prefixes(environ)
    path = split(environ.get("PATH")) or _DEFAULT_PATH.split(":")
    if ros.origin == "sourced" and sourced and sourced.rclpy == ros.prefix:
        names = {*LISTS} - {"PATH"}
        lists = {name: tuple(without(split(environ.get(name)), sourced.dropped)) for name in names}
        return Variables(lists, ros_values(ros.distro)), without(path, sourced.dropped)
    # Another ROS may be sourced, or this one with workspaces on top: their programs must not be found.
    path = without(path, every_prefix(environ))
    return (_wheels(ros, environ) if ros.origin == "pip" else _captured(ros, environ)), path


def _captured(ros: Ros, environ: Mapping[str, str]) -> Variables:
    lists = {name: tuple(split(value)) for name, value in captured_variables(ros, environ).items()}
    return Variables(lists, ros_values(ros.distro))


def _wheels(ros: Ros, environ: Mapping[str, str]) -> Variables:
    return wheel_variables(ros, place_of(ros, environ).underlay)


def _overlay_lists(overlay: Path) -> dict[str, list[str]]:
    lists = {name: [str(overlay)] for name in PREFIXES}
    lists["PYTHONPATH"] = [str(folder) for folder in python_folders(overlay)]
    for name, folder in (("LD_LIBRARY_PATH", "lib"), ("PATH", "bin"), ("PKG_CONFIG_PATH", "lib/pkgconfig")):
        lists[name] = [str(overlay / folder)] if (overlay / folder).is_dir() else []
    return lists


def _basics(environ: Mapping[str, str]) -> dict[str, str]:
    return {name: value for name, value in environ.items() if name in _BASICS or name.startswith("LC_")}


def _profile(ros: Ros, environ: Mapping[str, str]) -> Path:
    # The copy next to the wheels is the one that setup.bash names and that is visible in a sandbox.
    copy = place_of(ros, environ).profile if ros.origin == "pip" else PROFILE
    return copy if copy.exists() else PROFILE


_PLAIN_PATH = "/usr/local/bin:/usr/bin:/bin"
_PATIENCE = 60  # seconds; sourcing takes well under one, or a few on a cold and busy disk


def captured_variables(ros: Ros, environ: Mapping[str, str]) -> dict[str, str]:
    """The path variables that setup.bash sets; PATH contains only what it adds."""
    remembered = cache_dir(environ) / "rosenv" / f"{digest([str(ros.prefix)])}.json"
    if (variables := _recall(remembered, ros)) is not None:
        return variables
    variables = _source(setup_script(ros), environ)
    # If this cannot be stored, the next time takes a moment longer.
    with suppress(OSError):
        write_atomic(remembered, json.dumps({"identity": ros.identity, "variables": variables}))
    return variables


def _recall(file: Path, ros: Ros) -> dict[str, str] | None:
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
        if content["identity"] == ros.identity:
            return {str(name): str(value) for name, value in content["variables"].items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        pass  # missing or damaged: it is made again
    return None


def _source(script: Path, environ: Mapping[str, str]) -> dict[str, str]:
    base = {"PATH": _PLAIN_PATH, "HOME": environ.get("HOME", "/")}
    command = ["bash", "--noprofile", "--norc", "-c", '. "$1" >&2; exec env -0', "bash", str(script)]
    try:
        done = subprocess.run(
            command, env=base, stdin=subprocess.DEVNULL, capture_output=True, timeout=_PATIENCE
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise _unusable(script, str(error)) from error
    variables = _added(done.stdout)
    if "AMENT_PREFIX_PATH" not in variables:
        said = done.stderr.decode(errors="replace").strip().splitlines()
        raise _unusable(script, said[-1] if said else "it sets no AMENT_PREFIX_PATH")
    return variables


def _added(output: bytes) -> dict[str, str]:
    pairs = (os.fsdecode(entry).partition("=") for entry in output.split(b"\0") if entry)
    found = {name: value for name, _, value in pairs if name in LISTS}
    plain = _PLAIN_PATH.split(":")
    found["PATH"] = ":".join(path for path in found.get("PATH", "").split(":") if path not in plain)
    return found


def _unusable(script: Path, reason: str) -> MissingHere:
    return MissingHere(
        f"The ROS 2 installed here cannot be used: {script}: {reason}.",
        f"See what this says, then repair or reinstall that ROS: bash -c 'source {script}'",
    )
