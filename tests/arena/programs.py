"""An arena's programs in a separate home, without ROS."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path

from course.arena.home_programs import HomePrograms, Surroundings
from course.evidence.recording import Recording
from course.evidence.timeline import Timeline
from course.model.events import OutputLine

PLAIN = {"PATH": "/usr/bin:/bin", "KIND": "plain"}
SOURCED = {"PATH": "/usr/bin:/bin", "KIND": "sourced", "ROS_DISTRO": "jazzy"}


class Programs(HomePrograms):
    """Starts programs in `folder`/home, which exists; our own files are beside it. `close` ends them."""

    def __init__(
        self,
        folder: Path,
        learners_home: Path | None = None,
        environment: Mapping[str, str] = SOURCED,
        plain: Mapping[str, str] = PLAIN,
    ) -> None:
        self.ours = folder / "ours"
        self.ours.mkdir()
        given = Surroundings(environment, sys.executable, folder, plain, learners_home, self.ours)
        super().__init__(Timeline(), given)

    def write(self, name: str, text: str, mode: int = 0o644) -> None:
        file = self.home / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        file.chmod(mode)

    @property
    def recording(self) -> Recording:
        return Recording("x", self.timeline.events())

    @property
    def lines(self) -> list[str]:
        return [event.text for event in self.timeline.of(OutputLine)]

    def close(self) -> None:
        for process in self._processes:
            process.close()
