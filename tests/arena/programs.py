"""An arena's programs in a separate home, without ROS."""

from __future__ import annotations

import sys
from pathlib import Path

from course.arena.home_programs import HomePrograms
from course.evidence.recording import Recording
from course.evidence.timeline import Timeline

PLAIN = {"PATH": "/usr/bin:/bin", "KIND": "plain"}
SOURCED = {"PATH": "/usr/bin:/bin", "KIND": "sourced", "ROS_DISTRO": "jazzy"}


class Programs(HomePrograms):
    """Starts programs in `folder`/home, which exists; ends them with `close`."""

    def __init__(self, folder: Path, learners_home: Path | None = None) -> None:
        super().__init__(Timeline(), SOURCED, PLAIN, sys.executable, folder, learners_home)

    def write(self, name: str, text: str, mode: int = 0o644) -> None:
        file = self.home / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        file.chmod(mode)

    @property
    def recording(self) -> Recording:
        return Recording("x", self.timeline.events())

    def close(self) -> None:
        for process in self._processes:
            process.close()
