"""The setup.bash for pip wheels, which come without one, and the files that colcon looks for."""

from __future__ import annotations

import os
import shlex
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from course.errors import MissingHere
from course.files import cache_dir, write_atomic
from course.rosenv.find import find_ros
from course.rosenv.ros import Ros, digest
from course.rosenv.underlay import source_root
from course.rosenv.variables import PROFILE, Variables, discovery_values, wheel_variables

_FORMAT = "3"


@dataclass(frozen=True)
class SetupFiles:
    """Where our files for a prefix are: `scripts` contains setup.bash, `data` everything else."""

    scripts: Path
    data: Path

    @property
    def profile(self) -> Path:
        return self.data / PROFILE.name

    @property
    def underlay(self) -> Path:
        """The prefix that offers our own packages."""
        return self.data / "underlay"

    @property
    def underlay_builds(self) -> Path:
        """Where those of our packages are built that must be compiled."""
        return self.data / "underlay-builds"

    @property
    def stamp(self) -> Path:
        return self.data / "prepared"

    @property
    def lock(self) -> Path:
        return self.data / "lock"


def place_of(ros: Ros, environ: Mapping[str, str]) -> SetupFiles:
    """In the prefix, if the files were written there or can be; else in the cache."""
    inside = SetupFiles(ros.prefix, ros.prefix / "share/ros2course")
    cached = cache_dir(environ) / "rosenv" / digest([str(ros.prefix)])
    outside = SetupFiles(cached, cached)
    for place in (inside, outside):
        if is_stamped(ros, place):
            return place
    return inside if _can_write(inside) else outside


def places_of(ros: Ros, environ: Mapping[str, str] | None = None) -> tuple[Path, ...]:
    """All folders that programs of this ROS read, apart from those in their environment variables."""
    if ros.origin != "pip":
        return (ros.prefix,)
    place, root = place_of(ros, os.environ if environ is None else environ), source_root()
    return (ros.prefix, place.data, place.scripts, *((root / "src",) if root else ()))


def is_stamped(ros: Ros, place: SetupFiles) -> bool:
    """Whether everything was written there for exactly these wheels."""
    try:
        return place.stamp.read_text(encoding="utf-8") == _stamp(ros)
    except (OSError, UnicodeDecodeError):
        return False


def write_stamp(ros: Ros, place: SetupFiles) -> None:
    """Record that everything is done. Call this last."""
    write_atomic(place.stamp, _stamp(ros))


def setup_script(ros: Ros, environ: Mapping[str, str] | None = None) -> Path:
    """What a learner sources in bash to use this ROS; for pip wheels, it exists after `prepare`."""
    if ros.origin == "pip":
        return place_of(ros, os.environ if environ is None else environ).scripts / "setup.bash"
    # For a ROS built from source with isolated packages, it is one folder higher.
    own, above = ros.prefix / "setup.bash", ros.prefix.parent / "setup.bash"
    return above if above.exists() and not own.exists() else own


def write_setup_files(ros: Ros, place: SetupFiles) -> None:
    """Write setup.* and local_setup.* for bash, sh and zsh, and the discovery profile that they name."""
    write_atomic(place.profile, PROFILE.read_text(encoding="utf-8"))
    body = body_of(place)
    write_atomic(body, script(wheel_variables(ros, place.underlay), discovery_values(place.profile)))
    call = f"# Uses ROS 2 from these pip packages; written by ros2course.\n. {shlex.quote(str(body))}\n"
    for name in ("setup.sh", "setup.bash", "setup.zsh", "local_setup.bash", "local_setup.zsh"):
        shell = name.rpartition(".")[2]
        write_atomic(place.scripts / name, call + _completion(shell))


def body_of(place: SetupFiles) -> Path:
    """The script that all the others source."""
    return place.scripts / "local_setup.sh"


def script(variables: Variables, discovery: Mapping[str, str]) -> str:
    """The text to source: works in any POSIX shell, even under `set -eu`; a second time changes nothing."""
    return "\n".join([_HEAD, *_prepends(variables), *_exports({**variables.values, **discovery}), _TAIL])


def _prepends(variables: Variables) -> Iterator[str]:
    for name, paths in variables.lists.items():
        # Each one is put in front, so begin with the last.
        yield from (f"_ros2course_prepend {name} {shlex.quote(path)}" for path in reversed(paths))


def _exports(values: Mapping[str, str]) -> Iterator[str]:
    return (f"export {name}={shlex.quote(value)}" for name, value in values.items())


def _completion(shell: str) -> str:
    """A line that lets the Tab key complete `ros2 ...` in interactive shells."""
    root = source_root()
    script = root / f"src/ros2cli/completion/ros2-argcomplete.{shell}" if root else None
    if script is None or not script.exists():
        return ""
    return f"case $- in *i*) . {shlex.quote(str(script))} ;; esac\n"


def _can_write(place: SetupFiles) -> bool:
    return all(os.access(folder, os.W_OK) for folder in (place.scripts, place.data.parent) if folder.exists())


def _stamp(ros: Ros) -> str:
    return f"{_FORMAT} {ros.prefix} {ros.identity} {ros.underlay}\n"


# A path that is already in the list keeps its place: what was sourced on top of it must stay on top.
_HEAD = """\
# Uses ROS 2 from these pip packages. Source it: it changes the environment of the shell it is read by.
# Written by ros2course, and written again when the packages change.

_ros2course_prepend() {
  eval "_ros2course_old=\\"\\${$1-}\\""
  case ":${_ros2course_old}:" in
    *":$2:"*) ;;
    *) export "$1=$2${_ros2course_old:+:${_ros2course_old}}" ;;
  esac
}

if [ -n "${ROS_DISTRO-}" ] && [ "${ROS_DISTRO-}" != "jazzy" ]; then
  echo "ROS ${ROS_DISTRO-} was sourced in this shell before. Do not mix it with jazzy: open a new shell." >&2
fi
"""
_TAIL = """
unset -f _ros2course_prepend
unset _ros2course_old
"""


INSTALLED = "/opt/ros/jazzy/setup.bash"


def on_this_machine(text: str, environ: Mapping[str, str] | None = None) -> str:
    """`text` with the setup.bash below /opt/ros replaced by that of the ROS 2 in use.

    Unchanged if there is no ROS 2 at all.
    """
    if INSTALLED not in text:
        return text
    try:
        script = setup_script(find_ros(environ), environ)
    except MissingHere:
        return text
    return text.replace(INSTALLED, shlex.quote(str(script)))
