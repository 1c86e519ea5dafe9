"""Where things lie in a course folder: the only place that knows its file names."""

from __future__ import annotations

import re
from pathlib import Path

from course.errors import OurFault, UsageError

LESSON = "lesson.yaml"
LESSON_TEXT = "lesson.md"
MISTAKES = "mistakes.yaml"
ALTERNATIVE = "alternative.yaml"
# What must have been built in a solution is said here, a line each: the folder of a workspace, and options of
# colcon; or that of a CMake project, which is installed, and options of cmake.
BUILT = "built.txt"
PARTS = ("chapters", "graders", "solutions")
# In every course home and solution: where an exercise's packages lie, and are built, if it names no other.
WORKSPACE = "ros2_tutorial_workspace"
CHAPTER_FOLDER = re.compile(r"(\d\d)-[a-z0-9]+(-[a-z0-9]+)*")


def own_root(package: Path) -> Path:
    """The course that travels with the engine: beside it in a checkout, else inside it."""
    for root in (package.parent, package / "_course"):
        if (root / "chapters").is_dir():
            return root
    raise OurFault(f"the lessons are missing from this installation ({package})", "install ros2course again")


def require_course(root: Path) -> None:
    """Raises UsageError, naming what is missing, when a folder is not a course."""
    try:
        lack = _lack(root)
    except PermissionError as error:
        raise UsageError(f"{root} is not readable: {error.strerror}", "ask its owner for access") from None
    if lack:
        form = f"a course holds chapters/NN-name/{LESSON}, graders/ and solutions/"
        raise UsageError(f"{root} is not a course: {lack}", form)


def _lack(root: Path) -> str | None:
    if not root.is_dir():
        return "there is no such folder"
    if not (root / "chapters").is_dir():
        return f"it has no {', '.join(f'{part}/' for part in PARTS if not (root / part).is_dir())}"
    return None if chapter_folders(root) else "no chapter lies in its chapters/ folder"


def chapter_folders(root: Path) -> tuple[Path, ...]:
    """Every folder in chapters/ but hidden ones, in order. A bad name is for `lesson` to complain about."""
    folders = (path for path in (root / "chapters").iterdir() if path.is_dir())
    return tuple(sorted(path for path in folders if path.name[0] not in "._"))


def grader_file(chapter: Path) -> Path:
    """`graders/ch18_publishers_and_subscribers.py` for `chapters/18-publishers-and-subscribers`."""
    return chapter.parents[1] / "graders" / f"ch{chapter.name.replace('-', '_')}.py"


def solution_folder(chapter: Path) -> Path:
    return chapter.parents[1] / "solutions" / chapter.name


def starter_folder(chapter: Path, exercise: str) -> Path:
    return chapter / "starter" / exercise


def play_file(chapter: Path, exercise: str) -> Path | None:
    """The module of the exercise's mystery, `play/ID.py` or `play/ID/__init__.py`; None when it has none."""
    candidates = (chapter / "play" / f"{exercise}.py", chapter / "play" / exercise / "__init__.py")
    return next((file for file in candidates if file.is_file()), None)


def answers_file(exercise: str) -> str:
    """Where a learner's answers to the exercise's questions lie, relative to the course home."""
    return f"answers/{exercise}.yaml"


def exercise_text(chapter: Path, exercise: str) -> Path:
    return chapter / f"{exercise}.md"
