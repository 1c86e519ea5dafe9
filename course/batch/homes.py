"""Laid-out course homes of submissions, each there only as long as something of it is being graded."""

from __future__ import annotations

import shutil
import threading
from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path

from course.arena.acts import acts_file
from course.batch.intake import Found, lay_out
from course.batch.model import Unit
from course.content import Exercise, answers_file
from course.home.model import MARKER, STATE
from course.home.storage import storing
from course.rosenv.files import wipe


class Homes:
    """folder: for the homes. kept: what judging again needs of each submission, beside its recordings."""

    def __init__(self, folder: Path, kept: Path, found: Iterable[Found]) -> None:
        self._folder = folder
        self._kept = kept
        self._found: Mapping[str, Found] = {one.person.id: one for one in found}
        self._users: Counter[str] = Counter()
        self._one_at_a_time = threading.Lock()

    def take(self, unit: Unit, exercise: Exercise) -> Path:
        """The home that the unit is graded in. Raises StorageError and Refused."""
        home = self._folder / unit.person
        with self._one_at_a_time:
            if not self._users[unit.person]:
                wipe(home)
                with storing(f"the submission of {unit.person} cannot be laid out"):
                    home.parent.mkdir(parents=True, exist_ok=True)
                lay_out(self._found[unit.person], home)
            with storing(f"the answers of {unit.person} cannot be kept"):
                self._keep(unit, exercise, home)
            self._users[unit.person] += 1
        return home

    def give_back(self, unit: Unit) -> None:
        """Once for each `take`."""
        with self._one_at_a_time:
            self._users[unit.person] -= 1
            if not self._users[unit.person]:
                wipe(self._folder / unit.person)

    def _keep(self, unit: Unit, exercise: Exercise, home: Path) -> None:
        """Answers are judged as they stand, as is what `play` noted; the seed belongs to both."""
        if not (exercise.questions or exercise.play):
            return
        acts = acts_file(home / STATE, exercise.id).relative_to(home)
        for file in (Path(answers_file(exercise.id)), acts, Path(STATE, MARKER)):
            if (home / file).is_file():
                target = self._kept / unit.person / file
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(home / file, target)
