"""What a course is made of: chapters, exercises, and the known mistakes that prove the graders.

All of it is read-only data. What only graders' tests need (mistakes, alternatives) is read when asked for.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from course.content.layout import WORKSPACE
from course.content.question import Question

# What stands in an answers file for one question.
Given = str | list[str]


@dataclass(frozen=True)
class ChapterRef:
    """What an exercise knows of its chapter. `slug` is the folder's name: `18-publishers-and-subscribers`."""

    number: int
    title: str
    slug: str


@dataclass(frozen=True)
class Lesson:
    """What is read of a chapter before its exercises; text: Markdown."""

    chapter: ChapterRef
    text: str


@dataclass(frozen=True)
class Edit:
    """One change of a solution's file; exactly one of the other fields is set.

    file, rename: relative to the course home. replace: a text that occurs in the file; all its
    occurrences become `with_`. content: the whole new file. mode: octal, like "755". delete and rename
    take a whole folder, too. answers: question ids with the answers that take the place of the right
    ones in an answers file.
    """

    file: str
    replace: str | None = None
    with_: str | None = None
    delete: bool = False
    rename: str | None = None
    content: str | None = None
    mode: str | None = None
    answers: Mapping[str, Given] | None = None


@dataclass(frozen=True)
class Mistake:
    """A mistake that learners make: edits of the reference solution, and how it must be caught.

    caught_by: id of the check that must fail. says: texts that its feedback must contain.
    also_fails: ids of other checks that it rightly fails too; no other may.
    """

    id: str
    exercise: str
    summary: str
    edits: tuple[Edit, ...]
    caught_by: str
    says: tuple[str, ...]
    also_fails: tuple[str, ...] = ()


@dataclass(frozen=True)
class Alternative:
    """Another right solution: `tree` goes over the reference solution.

    tree: laid out as the course home, but for alternative.yaml itself.
    deletes: files of the reference that this one does without. answers: other right answers to
    questions, by the question's id.
    """

    name: str
    exercises: tuple[str, ...]
    summary: str
    deletes: tuple[str, ...]
    tree: Path
    answers: Mapping[str, Given] = field(default_factory=dict)


@dataclass(frozen=True)
class Exercise:
    """One exercise of a chapter.

    files: the learner's files, relative to the course home. packages: ROS packages built for it,
    which lie in `workspace`/src.
    grader_packages: packages whose reference build the grader itself needs. requires: ids of the
    exercises whose work it stands on. text, hints, after: Markdown. time_limit: seconds.
    starter, grader, solution: paths that may not exist (a quiz has no solution). questions: asked
    by `check`. play: the module of the exercise's mystery, if it has one. looks_at: more files,
    folders and patterns of the course home that the grader looks at. bonus: not needed to complete
    the course. local_only: about the learner's own machine, so no part of a submission.
    """

    id: str
    title: str
    summary: str
    chapter: ChapterRef
    text: str
    hints: tuple[str, ...]
    after: str | None
    files: tuple[str, ...]
    packages: tuple[str, ...]
    grader_packages: tuple[str, ...]
    requires: tuple[str, ...]
    time_limit: float
    grader: Path
    starter: Path
    solution: Path
    folder: Path
    questions: tuple[Question, ...] = ()
    play: Path | None = None
    looks_at: tuple[str, ...] = ()
    bonus: bool = False
    local_only: bool = False
    workspace: str = WORKSPACE

    def mistakes(self) -> tuple[Mistake, ...]:
        """The mistakes listed for this exercise; read from the chapter's mistakes.yaml now."""
        from course.content.proofs import load_mistakes  # reads YAML: not worth its import elsewhere

        return tuple(mistake for mistake in load_mistakes(self.folder) if mistake.exercise == self.id)

    def alternatives(self) -> tuple[Alternative, ...]:
        """Other right solutions of this exercise; read from the chapter's solutions folder now."""
        from course.content.proofs import load_alternatives  # as above

        return tuple(other for other in load_alternatives(self.solution) if self.id in other.exercises)


@dataclass(frozen=True)
class Chapter:
    """One chapter. `text` is the Markdown of lesson.md; `slug` the name of `folder`."""

    number: int
    slug: str
    title: str
    summary: str
    text: str
    exercises: tuple[Exercise, ...]
    folder: Path
