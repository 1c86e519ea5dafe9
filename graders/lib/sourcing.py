"""What `~/.bashrc` sources, according to bash itself, so loops, conditions and variables don't matter.

A scenario types `TRACE` into a shell; checks read the answer with `sourced`.
"""

from __future__ import annotations

import re
import shlex
from dataclasses import dataclass
from pathlib import PurePosixPath

from course.api import Location, Recording, expect_ran

# A new bash, with a fresh environment like the first one's, that prints each step. PS4 cannot be set in the
# environment, because bash ignores it there when it runs as root.
TRACE = (
    'env -i HOME="$HOME" TERM="$TERM" PATH=/usr/local/bin:/usr/bin:/bin bash --norc -ic '
    "'PS4=\"@\\${BASH_SOURCE[0]}:\\$LINENO@ \"; set -x; . ~/.bashrc' 2>&1 </dev/null"
    ' | sed -n "s|$HOME/|~/|g; /^@*~[^@]*\\/install\\//d; /^@*~[^@]*@ \\(source\\|\\.\\) /p" | head -n 200'
)
_STEP = re.compile(r"@+~/(?P<file>[^@]+):(?P<line>\d+)@ (?:source|\.) (?P<words>.+)")
_SETUP = re.compile(r"(local_)?setup\.(bash|sh|zsh)")


@dataclass(frozen=True)
class Sourced:
    """One `source` that bash ran: `target` as it was named, with `~/` for the course home."""

    where: Location
    target: str

    @property
    def is_setup(self) -> bool:
        """Whether this is the setup file of ROS or of a workspace."""
        return _SETUP.fullmatch(PurePosixPath(self.target).name) is not None

    @property
    def is_workspace(self) -> bool:
        """Whether colcon made it."""
        path = PurePosixPath(self.target)
        ours = not path.is_absolute() or any(part.endswith("workspace") for part in path.parts)
        return self.is_setup and ours and path.parent.name == "install"


def sourced(recording: Recording) -> tuple[Sourced, ...]:
    """What `~/.bashrc` sourced, itself or through files of the home that it reads, in order."""
    steps = (_STEP.match(line.strip()) for line in expect_ran(recording, TRACE).printed)
    return tuple(
        Sourced(Location(step["file"], int(step["line"])), _target(step["words"])) for step in steps if step
    )


def environments(recording: Recording) -> tuple[Sourced, ...]:
    """The sourced files that make ROS itself ready."""
    return tuple(one for one in sourced(recording) if one.is_setup and not one.is_workspace)


def workspaces(recording: Recording) -> tuple[Sourced, ...]:
    """The sourced files that add a workspace."""
    return tuple(one for one in sourced(recording) if one.is_workspace)


def _target(words: str) -> str:
    try:
        return shlex.split(words)[0]
    except (ValueError, IndexError):
        return words
