"""A small course whose grader is any Python text, and recordings of its proofs without running any."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest
import yaml

from course.content import Course, open_course
from course.evidence.mcap_file import save
from course.evidence.recording import Recording
from course.model.result import Result, Verdict, to_json
from course.validate.proofs import Proof, ProofKind
from course_mutation.model import Judged
from course_mutation.mutants import mutants
from course_mutation.recordings import Recorded
from course_mutation.run import judged

HEAD = """\
from course.api import Failure, Feedback, Grader

light = Grader("04-light", builds=None)
dim = Grader("04-dim", builds=None)

"""


class Workshop:
    """`grader` writes the module; `mistake` adds a mistake whose recording takes so long."""

    def __init__(self, root: Path, folder: Path) -> None:
        self.root = root
        self.grader_file = root / "graders/ch04_lanterns.py"
        self._folder = folder
        self._mistakes: list[dict[str, object]] = []
        self.recorded: list[Recorded] = []
        self._write()

    def grader(self, body: str) -> int:
        """The line in which the body begins."""
        self.grader_file.write_text(HEAD + body)
        return HEAD.count("\n") + 1

    def right(self, seconds: float) -> None:
        self._record(Proof("04-light", ProofKind.SOLUTION), seconds)

    def mistake(self, name: str, seconds: float, caught_by: str, says: str = "", **more: object) -> None:
        one = {"id": name, "exercise": "04-light", "summary": "Wrong.", "caught_by": caught_by, **more}
        edits = [{"file": "light.py", "content": "pass"}]
        self._mistakes.append({**one, "says": [says or "s"], "edits": edits})
        self._write()
        self._record(Proof("04-light", ProofKind.MISTAKE, name), seconds)

    def _record(self, proof: Proof, seconds: float) -> None:
        file = self._folder / f"{proof}.mcap"
        save(Recording("04-light", duration=seconds), file, began_ns=0)
        recorded = Recorded(proof, file)
        recorded.result.write_text(to_json(Result("04-light", Verdict.PASSED)))
        self.recorded.append(recorded)

    def _write(self) -> None:
        text = yaml.safe_dump({"mistakes": self._mistakes}) if self._mistakes else "mistakes: []\n"
        (self.root / "chapters/04-lanterns/mistakes.yaml").write_text(text)

    @property
    def course(self) -> Course:
        return open_course(self.root)

    def judged(self, seconds: float = 20, jobs: int = 2) -> tuple[tuple[str, ...], dict[str, Judged]]:
        """What the proofs say about the unchanged grader, and each mutant's fate, by its changed text."""
        course = self.course
        exercise = course.exercise("04-light")
        problems, *rest = judged(course, exercise, mutants(exercise), self.recorded, jobs, seconds)
        assert isinstance(problems, tuple)
        every = [one for one in rest if isinstance(one, Judged)]
        return problems, {one.mutant.after: one for one in every}


@pytest.fixture
def workshop(small_course: Path, tmp_path: Path) -> Workshop:
    folder = tmp_path / "recordings"
    folder.mkdir()
    return Workshop(small_course, folder)


@pytest.fixture
def lines_of(small_course: Path) -> Callable[[str], Mapping[str, list[str]]]:
    """From a grader's text to each operator's changes, by the operator's name."""
    file = small_course / "graders/ch04_lanterns.py"

    def found(body: str) -> Mapping[str, list[str]]:
        file.write_text(HEAD + body)
        every: dict[str, list[str]] = {}
        for mutant in mutants(open_course(small_course).exercise("04-light")):
            text = mutant.change.applied(file.read_bytes()).decode()
            compile(text, "mutant", "exec")
            assert text.count("\n") == (HEAD + body).count("\n")
            every.setdefault(mutant.change.operator.name, []).append(mutant.after)
        return every

    return found
